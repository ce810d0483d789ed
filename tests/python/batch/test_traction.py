"""A traction curve from its case file to its picture."""

import json

import numpy as np
import pytest
from contact_edge import shares_of_contact
from folders import CASES

from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.result.result import open_result
from pyworm.solver.level import CONTACT_PRESSURE

CASE = str(CASES / "traction_steel.toml")
RATIOS = ("-0.5", "0", "0.5")


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    return tmp_path_factory.mktemp("traction")


@pytest.fixture(scope="module")
def swept(directory):
    """The steel contact at three slide-roll ratios, without the pictures of each."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.draw.SCENE_PICTURES", {"point": {}})
        arguments = ["run", CASE, "--accuracy", "5%", "--out", str(directory)]
        assert main([*arguments, "--slide-roll-ratio", *RATIOS]) == CONVERGED
    return open_result(directory / "result.nc").solutions


def traction(solution):
    """Force on body 1 along x, by the film that carries load, over the load."""
    fields = solution.fields
    x, y = fields.x.values, fields.y.values
    cell = (x[1] - x[0]) * (y[1] - y[0])
    carries = shares_of_contact(fields.pressure.values, CONTACT_PRESSURE)
    return float((carries * fields.shear_stress_x.values).sum()) * cell / solution.load


def test_a_curve_leaves_its_scenes_and_pictures_of_all(swept, directory):
    assert [solution.slide_roll_ratio for solution in swept] == [-0.5, 0, 0.5]
    assert swept[0].name == "slide-roll ratio -0.5"
    left = sorted(path.name for path in directory.iterdir())
    assert left == ["regimes.png", "result.nc", "traction.png"]


def test_traction_is_against_the_sliding_and_antisymmetric(swept):
    backwards, rolling, forwards = swept
    assert traction(forwards) == pytest.approx(-0.02, abs=0.002)
    assert traction(backwards) == pytest.approx(-traction(forwards), rel=1e-3)
    friction = forwards.figures.friction_coefficient.on_grid
    assert traction(forwards) == pytest.approx(-friction, rel=1e-4)
    assert traction(rolling) == pytest.approx(0, abs=1e-9)
    assert rolling.figures.friction_coefficient.value == 0


def test_bodies_of_one_material_change_places(swept):
    backwards, rolling, forwards = (solution.figures for solution in swept)
    for name in ("film_central", "film_min", "temperature_max_film"):
        assert getattr(backwards, name).value == pytest.approx(
            getattr(forwards, name).value, rel=1e-3
        )
    first, second = (getattr(forwards, f"temperature_max_body_{n}").value for n in (1, 2))
    assert second > first + 0.5  # the slower one
    assert backwards.temperature_max_body_1.value == pytest.approx(second, abs=0.02)
    assert backwards.temperature_max_body_2.value == pytest.approx(first, abs=0.02)
    assert rolling.temperature_max_body_1.value == pytest.approx(
        rolling.temperature_max_body_2.value, abs=1e-6
    )


def test_heat_goes_where_it_is_made(swept):
    for solution in swept[::2]:
        power = float(np.abs(traction(solution)) * solution.load * 0.5 * 2.0)
        # rolling adds the work of the flow that the pressure drives
        assert power < solution.figures.power_loss.value < 1.15 * power
        assert abs(solution.figures.heat_balance) < 0.01


def test_check_shows_every_slide_roll_ratio(capsys):
    assert main(["check", CASE, "--slide-roll-ratio", *RATIOS, "--json"]) == CONVERGED
    scenes = json.loads(capsys.readouterr().out)["scenes"]
    assert [scene["slide_roll_ratio"] for scene in scenes] == [-0.5, 0, 0.5]
    assert [scene["sliding_m_per_s"] for scene in scenes] == [[-1, 0], [0, 0], [1, 0]]
    assert main(["check", CASE]) == CONVERGED
    assert "slide-roll ratio 2.5" in capsys.readouterr().out
