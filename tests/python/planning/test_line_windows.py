"""Windows of line contacts that reach farther."""

from dataclasses import replace

import pytest
from contacts import roller

from pyworm.planning.line_grid import first_grids, twice_as_far
from pyworm.scene.scales import line_scales


@pytest.mark.parametrize("sign", [1, -1])
def test_a_window_twice_as_far_grows_at_its_inlet_only(sign):
    scene = replace(roller(), velocities=(1.1 * sign, 0.9 * sign))
    narrow, wide = first_grids(scene, line_scales(scene), 0.02, heated=True)
    far = twice_as_far(narrow, wide)
    inlet, exit_ = (0, -1) if sign > 0 else (-1, 0)
    assert far.dx == wide.dx
    assert far.x[exit_] == pytest.approx(wide.x[exit_])
    assert far.x[inlet] / wide.x[inlet] == pytest.approx(2**0.5, abs=2 / wide.nodes)
    # at the node of the contact point
    assert abs(far.x).min() == 0.0
