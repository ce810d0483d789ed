"""Stress below solved contacts with heat, coatings and fatigue limits of their bodies."""

from dataclasses import replace

import numpy as np
import pytest

import pyworm
from pyworm.formulas.fatigue import failure_probability
from pyworm.formulas.layered_half_space import Layer
from pyworm.formulas.stress_invariants import max_shear_stress, von_mises
from pyworm.solver.stress.fatigue import duty_failure, with_fatigue
from pyworm.solver.stress.layer import CoatedBody
from pyworm.solver.stress.maximum import StressBelow
from pyworm.solver.stress.subsurface import inputs_of_scene, with_stress
from pyworm.solver.stress.tractions import Tractions

STRENGTH = pyworm.FatigueStrength("800 MPa", "470 MPa")


def line_contact(modulus, thickness):
    """Below Hertz's line contact of p0 = a = 1 with a layer of so many times the modulus."""
    x = np.linspace(-1.2, 1.2, 161)
    pressure = np.sqrt(np.maximum(1 - x**2, 0))
    tractions = Tractions(pressure, (0 * pressure,), (-1.2,), (x[1] - x[0],))
    return StressBelow(tractions, 0.3, CoatedBody(Layer(thickness, (modulus, 1.0), (0.3, 0.3))))


def test_a_coating_like_the_body_is_none():
    below = line_contact(1.0, 0.3)
    peak = below.peak(max_shear_stress, below.critical_depth)
    assert peak.value == pytest.approx(0.300, abs=5e-4)
    assert peak.depth == pytest.approx(0.786, rel=0.02)


def test_a_hard_coating_bears_the_maximum_at_one_of_its_faces():
    below = line_contact(4.0, 0.3)
    assert below.critical_depth in below.layer_depths
    assert below.peak(von_mises, below.critical_depth).value > 0.6


@pytest.fixture(scope="module")
def rolling():
    """A hot line contact of bodies with thermal expansion and fatigue limits, and its film."""
    scene = pyworm.load("cases/line_thermal.toml").scene()
    bodies = [replace(body, thermal_expansion=11.5e-6, fatigue=STRENGTH) for body in scene.bodies]
    scene = replace(scene, bodies=tuple(bodies))
    return scene, pyworm.solve(scene, accuracy=0.1)


def test_heat_presses_the_surface(rolling, tmp_path):
    scene, solution = rolling
    hot, cold = (solution.stress(1, [0.0], thermal=heat).sigma_xx[0] for heat in (True, False))
    rise = solution.figures.temperature_max_body_1.value - scene.bodies[0].bulk_temperature
    restrained = scene.bodies[0].youngs_modulus * 11.5e-6 / 0.7
    assert np.min(hot - cold) == pytest.approx(-restrained * rise, rel=0.3)
    stressed = with_stress(solution, inputs_of_scene(scene, thermal=True))
    read = pyworm.open_solution(stressed.save(tmp_path / "hot.nc"))
    assert read.figures == stressed.figures
    assert read.stress(1, [0.0]).sigma_xx[0] == pytest.approx(hot, rel=1e-3)
    with pytest.raises(ValueError, match="has no fatigue limits"):
        read.fatigue(1)


def test_thermal_stress_needs_heat_and_expansion(rolling):
    scene, _ = rolling
    with pytest.raises(ValueError, match="thermal_expansion is missing"):
        inputs_of_scene(pyworm.load("cases/line_thermal.toml").scene(), thermal=True)
    cold = pyworm.solve(scene, accuracy=0.1, effects="isothermal")
    with pytest.raises(ValueError, match="heat was not simulated"):
        cold.stress(thermal=True)


def test_fatigue_of_a_rolling_line(rolling):
    """Dang Van of a frictionless line: half the range of the orthogonal shear at least, 0.25 p0."""
    scene, solution = rolling
    passed = solution.fatigue(1)
    pressure = solution.figures.pressure_max.value
    assert 0.15 * pressure < passed.stress.max() < 0.4 * pressure
    assert passed.safety == pytest.approx(470e6 / passed.stress.max(), rel=1e-6)
    weak = replace(
        STRENGTH, bending_limit=0.8 * passed.stress.max(), torsion_limit=0.5 * passed.stress.max()
    )
    failing = solution.fatigue(1, weak)
    assert failing.risk[0] > 0
    pressed = replace(weak, depths=(0.0, 1.0), residual_stresses=(-4e8, -4e8))
    assert solution.fatigue(1, pressed).safety > failing.safety
    soft = replace(weak, depths=(0.0, 1e-4), hardnesses=(7e9, 5e9))
    assert solution.fatigue(1, soft).safety < failing.safety
    found = duty_failure([(failing, 1e3), (passed, 1e9)], "10 mm", "20 mm")
    assert found == pytest.approx(failure_probability([(failing.risk[0] * 2e-4, 1e3)]))
    fields = with_fatigue(solution, scene).fields
    assert float(fields["fatigue_ratio_body_1"].max()) == pytest.approx(1 / passed.safety, rel=1e-5)


def test_fatigue_along_a_direction_of_motion():
    """Below a ball that rolls along a diagonal of the grid as below one that rolls along an axis."""
    scene = pyworm.load("cases/film_rig.toml").scene()
    solution = pyworm.solve(scene, accuracy=0.2)
    straight = solution.fatigue(1, STRENGTH)
    fields = solution.fields
    for axis in "xy":
        fields = fields.assign({f"entrainment_{axis}": 0 * fields["entrainment_x"] + 0.5})
    turned = solution.changed(fields=fields).fatigue(1, STRENGTH)
    assert turned.safety == pytest.approx(straight.safety, rel=0.03)
    with pytest.raises(ValueError, match="has no fatigue limits"):
        solution.fatigue(2)
    still = solution.changed(
        fields=fields.assign({f"entrainment_{axis}": 0 * fields["gap"] for axis in "xy"})
    )
    with pytest.raises(ValueError, match="does not move"):
        still.fatigue(1, STRENGTH)
    limited = replace(scene, bodies=tuple(replace(body, fatigue=STRENGTH) for body in scene.bodies))
    assert with_fatigue(still, limited) is still
