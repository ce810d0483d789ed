"""What every drive answers: the shipped ones, and one of which no more is known than its contacts."""

import pytest
import xarray as xr
from folders import CASES
from roller_sections import coarse_cycle
from zi_drives import coarse_patterns

import pyworm
from pyworm.case.kinds import case_model
from pyworm.drives.drive import Drive
from pyworm.drives.duty import GearPairDuty, WormDuty
from pyworm.drives.kinds import BUILT_IN, module_of

SHIPPED = {
    "worm": ("zi_sharif_2001", WormDuty),
    "gear-pair": ("errichello_speed_increaser", GearPairDuty),
    "roller-worm": ("roller_ref", None),
}


class Bare(Drive):
    """A drive that makes a contact and says no more."""

    def scene(self, phase: float):
        return pyworm.load(CASES / "point_m20_l10.toml").scene()

    def cycle_data(self) -> xr.Dataset:
        return xr.Dataset()


def test_every_kind_is_shipped():
    assert set(SHIPPED) == set(BUILT_IN)


@pytest.mark.parametrize("kind", BUILT_IN)
def test_a_shipped_drive_is_rated_as_what_its_duty_is(kind):
    name, rated_as = SHIPPED[kind]
    drive = pyworm.load(CASES / f"{name}.toml").drive
    duty = drive.duty()
    assert drive.rated_as is rated_as
    assert duty is None if rated_as is None else type(duty) is rated_as


@pytest.mark.parametrize("kind", BUILT_IN)
def test_its_cycle_names_its_kind_and_its_bodies_are_two(kind, monkeypatch):
    coarse_patterns(monkeypatch)
    coarse_cycle(monkeypatch)
    drive = pyworm.load(CASES / f"{SHIPPED[kind][0]}.toml").drive
    assert drive.cycle_data().attrs["drive"] == kind
    assert len(set(drive.body_names)) == 2
    assert drive.assumptions


def test_the_normal_load_is_that_of_the_scene():
    worm, gears = (pyworm.load(CASES / f"{SHIPPED[kind][0]}.toml") for kind in BUILT_IN[:2])
    for case in (worm, gears):
        assert case.drive.normal_load(0.3) == case.scene(phase=0.3).load


def test_a_drive_with_nothing_to_say_says_so():
    drive = Bare()
    scene = drive.scene(0.0)
    assert drive.body_names == ("body 1", "body 2")
    assert drive.warnings == ()
    assert drive.assumptions == ("The load of each contact is that of the gear set.",)
    assert drive.normal_load(0.0) == scene.load
    assert not drive.scene_data(scene).variables
    assert drive.mesh_loss([]) is None
    assert drive.rated_as is None and drive.duty() is None
    assert drive.misalignment([scene]).errors == ()


def test_a_machine_without_contacts_is_no_drive():
    with pytest.raises(TypeError, match="abstract"):
        Drive()


def test_modules_are_found_by_the_kind_alone():
    assert module_of("worm", "plots").__name__ == "pyworm.plots.drives.worm"
    assert case_model("drive", "worm").__name__ == "WormCase"
    assert module_of("gear-pair", "console") is None  # it prints no table
    assert module_of("picture", "plots") is None  # no kind of drive
