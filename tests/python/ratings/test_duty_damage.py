"""Shares of the life of flanks, roots and gear teeth that hours at a load take, against hand calculations."""

from dataclasses import replace

import pytest
from folders import CASES

import pyworm
from pyworm.formulas.wear_law import pass_depth
from pyworm.planning.prediction import predicted
from pyworm.ratings.duty_damage import tooth_wear, wear_coefficients
from pyworm.ratings.mesh_estimate import MeshFriction, estimated
from pyworm.ratings.worm_safeties import pitting_damage, root_damage


def test_pitting_of_25000_h_at_a_safety_of_1_is_a_life():
    assert pitting_damage(25000.0, 1.0) == 1
    assert pitting_damage(1000.0, 2.0) == pytest.approx(1000 / 25000 / 64)


def test_roots_endure_above_their_endurance_and_3e6_cycles_at_it():
    assert root_damage(1e12, 1.0) == 0
    assert root_damage(3e6, 1 - 1e-12) == pytest.approx(1)
    # the life factor of 8.3e5 cycles, (3e6/8.3e5)^0.16, is the load that they endure
    assert root_damage(8.3e5, (8.3e5 / 3e6) ** 0.16) == pytest.approx(1)


def test_a_pass_of_a_line_contact_wears_by_its_load_and_the_slide_over_the_surface():
    """Pressure w/2b over 2b/v of time, slid over at dv: k w dv/v."""
    width, load, velocity, sliding = 2e-4, 3e5, 1.5, -0.6
    depth = 1e-18 * load / width * abs(sliding) * width / velocity
    assert pass_depth(1e-18, load, sliding, velocity) == pytest.approx(depth, rel=1e-9, abs=0)


@pytest.fixture(scope="module")
def mesh():
    case = pyworm.load(CASES / "errichello_speed_increaser.toml")
    return MeshFriction(case.drive, case.places())


def test_gears_wear_where_they_slide_most_over_their_own_surface(mesh):
    hot = mesh.at(383.15)
    worn = tooth_wear(mesh.drive, hot)
    teeth = [mesh.drive.contacts(phase) for phase in hot.phases]
    depths = [
        1e-18
        * each.asperity_load_fraction
        * float(at.unit_load)
        * abs(float(at.pinion_specific_sliding))
        for each, at in zip(hot.contacts, teeth, strict=True)
    ]
    assert worn["pinion"][0] == pytest.approx(375 * 60 * max(depths), rel=1e-3)
    assert worn["pinion"][1] < worn["pinion"][0]
    assert worn["gear"][0] < worn["pinion"][0]  # a seventh of the passes


def test_bronze_wears_and_its_worm_by_the_square_of_their_hardnesses():
    bronze, steel = (pyworm.Body.from_name(name) for name in ("CuSn12Ni2-C-GZ", "16MnCr5"))
    worm, wheel = wear_coefficients((steel, bronze))
    assert wheel == 7e-18
    assert worm == pytest.approx(wheel * (0.93 / 6.7) ** 2, rel=0.2)
    assert wear_coefficients((steel, steel)) == (1e-18, 1e-18)


def test_smoother_flanks_carry_less_of_the_load_on_asperities(mesh):
    rough, smooth = mesh.at(383.15), mesh.at(383.15, (0.2e-6, 0.2e-6))
    composite = mesh.scenes[0].composite_roughness
    assert rough.specific_film == pytest.approx(rough.film_min / composite)
    assert smooth.asperity_load_fraction < rough.asperity_load_fraction < 1
    assert smooth.loss.friction < rough.loss.friction < mesh.drive.oil.boundary_friction


def test_flanks_without_a_roughness_are_smooth(mesh):
    scene = replace(mesh.scenes[0], smooth=True)
    found, prediction = estimated(predicted(scene)), predicted(scene)
    assert found.asperity_load_fraction == 0
    assert found.friction == pytest.approx(prediction.own_hot_stress / prediction.pressure_mean)


def test_an_oil_without_a_flow_law_has_no_friction(mesh):
    drive = replace(mesh.drive, oil=replace(mesh.drive.oil, flow=None))
    with pytest.raises(ValueError, match=r"needs \[oil.shear\]"):
        MeshFriction(drive, mesh.places)
    with pytest.raises(ValueError, match="too few"):
        MeshFriction(mesh.drive, mesh.places[:1]).at(350.0)
