"""Geometry that cannot work is refused in one clear sentence."""

import numpy as np
import pytest
from folders import DATA
from zi_drives import DEGREE, HOB, MM, WHEEL, WORM, changed, sharif

import pyworm
from pyworm.case.case import case_of
from pyworm.drives.worm.flanks.contact_curve import HobError
from pyworm.drives.worm.loads.load_sharing import Transmission
from pyworm.io.toml import read_toml


def small_hob():
    base, angle = 25.9 * MM, 27.9 * DEGREE
    lead = 2 * np.pi * base * np.tan(angle)
    return changed(
        HOB,
        base_radius=base,
        base_lead_angle=angle,
        lead=lead,
        axial_pitch=lead / 3,
        tip_radius=50.2 * MM,
        root_radius=30.2 * MM,
        centre_distance=304.23 * MM,
        swivel=-0.3 * DEGREE,
        axial_shift=0.0,
    )


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"worm": changed(WORM, base_lead_angle=28.5 * DEGREE)}, "worm.base_lead_angle is 28.50 deg"),
        ({"hob": changed(HOB, base_lead_angle=27.61 * DEGREE)}, "hob.base_lead_angle is 27.61 deg"),
        ({"worm": changed(WORM, axial_pitch=30 * MM)}, "worm.axial_pitch is 30.00 mm"),
        ({"worm": changed(WORM, tip_radius=29 * MM)}, "worm.tip_diameter is 58.00 mm"),
        ({"worm": changed(WORM, threads=2.5)}, "worm.threads is 2.5"),
        ({"worm": changed(WORM, lead=-86.18 * MM)}, "worm.lead is -0.08618"),
        ({"wheel": changed(WHEEL, face_width=0.0)}, "wheel.face_width is 0"),
        ({"wheel": changed(WHEEL, tip_radius=270 * MM)}, "wheel.outside_diameter is 540.00 mm"),
        ({"centre_distance": 340 * MM}, "centre_distance is 340.00 mm"),
        ({"centre_distance": 300 * MM}, "centre_distance is 300.00 mm"),
        ({"hob": changed(HOB, centre_distance=300 * MM)}, "hob.centre_distance is 300.00 mm"),
        ({"hob": changed(HOB, swivel=2 * DEGREE)},
         "hob.swivel, hob.axial_shift and hob.centre_distance are 2 deg"),
        ({"hob": changed(HOB, base_radius=27 * MM, lead=90 * MM, axial_pitch=30 * MM,
                         base_lead_angle=np.arctan(90 / (2 * np.pi * 27)))}, "normal base pitch"),
        ({"hob": small_hob()}, "hob: the wheel it cuts would interfere"),
        ({"tooth_load": -14e3}, "tooth_load is -14000"),
        ({"tooth_load": None}, "tooth_load, transmission: give one of both"),
        ({"transmission": Transmission(6.7e3, "wheel")}, "tooth_load, transmission: give one of both"),
        ({"speed": float("nan")}, "speed is nan"),
    ],
)  # fmt: skip
def test_bad_geometry_is_refused(changes, says):
    with pytest.raises(ValueError) as caught:
        sharif(**changes)
    message = str(caught.value)
    assert says in message
    assert "\n" not in message
    assert type(caught.value) in (ValueError, HobError)


@pytest.mark.parametrize(
    ("changes", "begins", "right"),
    [
        ({"worm": changed(WORM, threads=59), "wheel": changed(WHEEL, teeth=3)},
         "threads is 59 with 3 teeth", "swapped? threads = 3, teeth = 59"),
        ({"worm": changed(WORM, tip_radius=2 * WORM.tip_radius)},
         "worm.tip_diameter is 192.04 mm", "did you mean 96.02 mm?"),
        ({"worm": changed(WORM, tip_radius=WORM.tip_radius / 2)},
         "worm.tip_diameter is 48.01 mm", "is it a radius? a diameter is required, 96.02 mm"),
        ({"worm": changed(WORM, root_radius=2 * WORM.root_radius)},
         "worm.root_diameter is 116.12 mm", "did you mean 58.06 mm?"),
        ({"worm": changed(WORM, base_radius=2 * WORM.base_radius)},
         "worm.base_diameter is 104.92 mm", "did you mean 52.46 mm?"),
        ({"worm": changed(WORM, base_radius=WORM.base_radius / 2)},
         "worm.base_diameter is 26.23 mm", "is it a radius? a diameter is required, 52.46 mm"),
        ({"hob": changed(HOB, tip_radius=2 * HOB.tip_radius)},
         "hob.tip_diameter is 206.52 mm", "did you mean 103.26 mm?"),
        ({"hob": changed(HOB, base_radius=2 * HOB.base_radius)},
         "hob.base_diameter is 105.92 mm", "did you mean 52.96 mm?"),
        ({"hob": changed(HOB, tip_radius=47 * MM)}, "hob.tip_diameter is 94.00 mm", "smaller than that of"),
        ({"worm": changed(WORM, lead=WORM.axial_pitch)}, "worm.lead is 28.73 mm, the same as", "86.19 mm"),
        ({"wheel": changed(WHEEL, throat_radius=2 * WHEEL.throat_radius)},
         "wheel.throat_diameter is 1096.12 mm", "did you mean 548.06 mm?"),
        ({"wheel": changed(WHEEL, throat_radius=WHEEL.throat_radius / 2)},
         "wheel.throat_diameter is 274.03 mm", "is it a radius? a diameter is required, 548.06 mm"),
        ({"wheel": changed(WHEEL, throat_radius=31.58 * MM)},
         "wheel.throat_diameter is 63.16 mm", "is it that of the throat's groove?"),
        ({"wheel": changed(WHEEL, tip_radius=2 * WHEEL.tip_radius)},
         "wheel.outside_diameter is 1114.44 mm", "did you mean 557.22 mm?"),
        ({"wheel": changed(WHEEL, tip_radius=WHEEL.tip_radius / 2)},
         "wheel.outside_diameter is 278.61 mm", "is it a radius? a diameter is required, 557.22 mm"),
        ({"wheel": changed(WHEEL, face_width=603.3 * MM)}, "face_width is 603.30 mm", "96.02 mm"),
    ],
)  # fmt: skip
def test_sizes_of_another_key_are_refused_with_what_is_meant(changes, begins, right):
    with pytest.raises(ValueError) as caught:
        sharif(**changes)
    message = str(caught.value)
    assert message.startswith(begins) and right in message and "\n" not in message


def test_phase_outside_the_cycle_is_refused():
    with pytest.raises(ValueError, match="phase is 1"):
        sharif().contact(1.5)


def other_lead(by):
    """The hob with a lead that differs."""
    lead = HOB.lead + by
    angle = np.arctan(lead / (2 * np.pi * HOB.base_radius))
    return changed(HOB, lead=lead, axial_pitch=lead / 3, base_lead_angle=angle)


@pytest.mark.parametrize("by", [0.2 * MM, -0.15 * MM])
def test_a_hob_of_another_base_pitch_gives_a_warning_in_micrometres(by):
    """The normal base pitch is lead x cos(base lead angle) over the threads."""
    hob = other_lead(by)
    worm_pitch = WORM.lead / 3 * np.cos(np.arctan(WORM.lead / (2 * np.pi * WORM.base_radius)))
    apart = (hob.lead / 3 * np.cos(hob.base_lead_angle) - worm_pitch) / MM * 1e3
    (said,) = sharif(hob=hob).warnings
    which = "more" if by > 0 else "less"
    assert f"{abs(apart):.1f} um {which} than the worm's {worm_pitch / MM:.4f} mm" in said
    assert said.startswith("hob.lead and hob.base_diameter give")


def test_the_rounding_of_a_printed_table_is_no_other_base_pitch():
    assert sharif().warnings == ()


def test_a_worm_that_meets_the_end_of_the_face_first_is_computed_and_said_so():
    """The hob of this drive is swivelled so far that the worm's thread would cut into the wheel there."""
    case = pyworm.load(DATA / "zi_a75.toml")
    edge = case.drive.edge_contact
    assert edge.depth == pytest.approx(27.4e-6, abs=0.5e-6)
    assert abs(edge.face) == pytest.approx(13.6e-3, abs=0.4e-3)
    (said,) = [one for one in case.drive.warnings if "at an edge" in one]
    assert said.startswith("hob: ") and "another swivel" in said
    (assumed,) = [one for one in case.drive.assumptions if "at phase" in one]
    assert assumed.startswith("As the hob is set up the flanks")
    assert all(scene.load > 0 for scene in case.scenes())


def test_the_same_worm_meshes_where_the_hob_is_swivelled_less():
    """Worm and wheel touch at the contact point alone: elsewhere on the teeth the gap is open."""
    data = read_toml(DATA / "zi_a75.toml")
    data["drive"]["hob"]["swivel"] = "0.9 deg"
    drive = case_of(data, "less", DATA).drive
    scene = drive.scene(0.5)
    outline = drive.tooth_outline(drive.contact(0.5))
    places = [np.linspace(side.min(), side.max(), 80) for side in (outline.x, outline.y)]
    gap, covered = scene.gap(*np.meshgrid(*places))
    assert gap[covered].min() > -1e-7
