"""Public names of the gears of a case, `case.drive`: a new one is a decision, and the Python page has it."""

import dataclasses
import inspect

import pytest
from attribute_literals import attribute_literals
from folders import ROOT

from pyworm.drives.drive import Drive
from pyworm.drives.gear_pair.drive import GearPairDrive
from pyworm.drives.roller_worm.drive import RollerWormDrive
from pyworm.drives.worm.drive import WormDrive

NAMES = {
    # what every set of gears answers, also one of another package
    Drive: """
        all_assumptions allowed_errors at_load assumptions bodies body_names cycle_around_contact cycle_data
        cycle_points cycle_seconds duty element_bearing geometry geometry_table hob_setup idle in_space
        loaded_cycle lubricated_teeth lubrication mesh_at_torque mesh_forces mesh_loss misalignment
        motion_figures normal_load
        oil_supplied oil_supply pattern_margin phases_per_second possible_drivers rated_as roots rotors
        scene scene_data sections shaft_speeds sheet shown solids supports usual_values warnings
        wheel_shim
        """,
    # and what each has besides
    WormDrive: """
        aligned aligned_cycle arms assembly assembly_under_load assumed axes_distance base_pitches
        centre_distance contact contact_axes contact_beyond cycle deviating driven_pattern driver
        edge_contact errors_in_words first_touch flank_grid flank_place force_with friction gap hand hob
        inspection interference life load_arm mean_force mean_teeth_in_contact mesh_cycle mid_mesh_load module
        motions oil patterns pitch play profile_shift ratio reference_radii reference_radius rim
        rotation scene_at scene_of scene_under shaft shaft_deflection shared shared_torque sliding speed
        springs thread_place tolerances tooth_load tooth_outline touching_place transmission turned
        varied warmth wheel wheel_flank wheel_reference_radius wheel_shaft wheel_tooth wheel_torque
        with_rigid_shaft within without_film_lift worm worm_flank worm_tooth
        """,
    GearPairDrive: """
        contact contacts cycle_phases driver friction_load_factor gap gear_shaft gear_speed inspection
        lead_crowning
        load_factor load_sharing loss_factor normal_force oil phase_of pinion_speed pitch_line_velocity
        pinion_shaft power rating reduced_modulus scene_at shaft_forces sharing surfaces teeth tip_relief
        """,
    RollerWormDrive: """
        axis_distance centre_distance driving oil partly_touched passed pitch_radius preload ratio
        rollers rolling
        rotation rows scene_at shaft shared sharing speed spun state throat_radius torque towards turning
        varied wheel_shaft wheel_speed wheel_torque worm
        """,
}


def public(drive):
    """Public attributes of a class, fields without a default among them."""
    fields = (part.name for part in dataclasses.fields(drive)) if drive is not Drive else ()
    return {name for name in (*dir(drive), *fields, *drive.__annotations__) if name[0] != "_"}


@pytest.mark.parametrize("drive", NAMES)
def test_public_names_are_these(drive):
    shared = () if drive is Drive else public(Drive)
    assert public(drive) - {*shared} == {*NAMES[drive].split()}


@pytest.mark.parametrize("drive", NAMES)
def test_each_has_a_meaning_and_the_page_shows_it(drive):
    literals = attribute_literals(drive)
    for name in public(drive):
        member = inspect.getattr_static(drive, name, None)
        shown = inspect.getdoc(member) if hasattr(member, "__get__") else literals.get(name)
        assert shown, f"{drive.__name__}.{name}"
    page = (ROOT / "docs/reference/python.md").read_text()
    assert f"::: {drive.__module__}.{drive.__name__}\n" in page
