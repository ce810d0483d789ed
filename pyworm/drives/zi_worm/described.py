"""A worm drive as its drawing would have it, with what follows for mesh, hob and contact pattern."""

from math import atan2, cos, degrees
from typing import TYPE_CHECKING

import numpy as np

from pyworm.drives.zi_worm.contact_pattern import THICKNESS
from pyworm.drives.zi_worm.design import AS_DESIGNED
from pyworm.drives.zi_worm.tooth_form import flank_start, wheel_thickness, worm_thickness
from pyworm.formulas.worm_deflection import deflection_limit
from pyworm.formulas.worm_profiles import PRESSURE_ANGLE_PLACES, own_pressure_angle

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.drive import ZiWormDrive

Described = dict[str, float | str]


SIGNED = (
    *("profile", "hand", "threads", "teeth", "centre_distance_m", "module_m", "diameter_factor"),
    *("profile_shift", "pressure_angle_deg", "lead_m", "lead_angle_deg"),
    *("worm_reference_diameter_m", "worm_tip_diameter_m", "worm_root_diameter_m"),
    *("wheel_reference_diameter_m", "wheel_throat_diameter_m", "wheel_outside_diameter_m"),
    *("wheel_root_diameter_m", "wheel_face_width_m", "backlash_m"),
    *("worm_tip_clearance_m", "wheel_tip_clearance_m", "contact_ratio"),
)
"""What of the geometry stands on the page to sign."""


def _geometry(drive: "ZiWormDrive") -> Described:
    """Geometry of worm and wheel as designed."""
    ratio: Described = {"contact_ratio": drive.mean_teeth_in_contact}
    return _gear(drive) | _worm(drive) | _wheel(drive) | _clearances(drive) | ratio


def signed_geometry(drive: "ZiWormDrive") -> Described:
    """Geometry for the page to sign; keys end in their unit."""
    found = _geometry(drive)
    return {key: found[key] for key in SIGNED if key in found}


def described_drive(drive: "ZiWormDrive") -> Described:
    """Geometry of worm, wheel and hob, and the mesh, of a drive as assembled; keys end in their unit."""
    return (
        _geometry(drive)
        | _hob(drive)
        | _mesh(drive)
        | _shaft(drive)
        | _pattern(drive)
        | _tolerances(drive)
    )


def _gear(drive: "ZiWormDrive") -> Described:
    return {
        "profile": drive.worm.profile,
        "hand": drive.hand,
        "threads": drive.worm.threads,
        "teeth": drive.wheel.teeth,
        "gear_ratio": drive.wheel.teeth / drive.worm.threads,
        "centre_distance_m": drive.centre_distance,
        "module_m": drive.module,
        "diameter_factor": 2 * drive.reference_radius / drive.module,
        "profile_shift": drive.profile_shift,
    }


def _lead_angle(lead: float, radius: float) -> float:
    return atan2(lead, 2 * np.pi * radius)


def _worm(drive: "ZiWormDrive") -> Described:
    worm, radius, flank = drive.worm, drive.reference_radius, drive.worm_flank
    lead_angle = _lead_angle(worm.lead, radius)
    normal = flank.pressure_angle(radius)
    own = own_pressure_angle(worm.profile, worm.generator, lead_angle, normal)
    about: Described = {
        "normal_module_m": drive.module * cos(lead_angle),
        "pressure_angle_deg": degrees(own),
        "pressure_angle_of": PRESSURE_ANGLE_PLACES[worm.profile],
        "normal_pressure_angle_deg": degrees(normal),
        "lead_m": worm.lead,
        "lead_angle_deg": degrees(lead_angle),
        "worm_reference_diameter_m": 2 * radius,
        "worm_tip_diameter_m": 2 * worm.tip_radius,
        "worm_root_diameter_m": 2 * worm.root_radius,
        "worm_flank_from_diameter_m": 2 * drive.worm_tooth.start_radius,
        "worm_fillet_radius_m": worm.fillet_radius,
        "worm_thickness_m": worm_thickness(drive, radius),
        "worm_tip_thickness_m": worm_thickness(drive, worm.tip_radius),
    }
    if worm.base_radius is not None:
        about |= {
            "base_lead_angle_deg": degrees(_lead_angle(worm.lead, worm.base_radius)),
            "base_radius_m": worm.base_radius,
            "worm_base_diameter_m": 2 * worm.base_radius,
        }
    return about


def _wheel(drive: "ZiWormDrive") -> Described:
    wheel, hob = drive.wheel, drive.hob
    about: Described = {
        "wheel_reference_diameter_m": 2 * drive.wheel_reference_radius,
        "wheel_throat_diameter_m": 2 * wheel.throat_radius,
        "wheel_outside_diameter_m": 2 * wheel.tip_radius,
        "wheel_root_diameter_m": 2 * (hob.centre_distance - hob.tip_radius),
        "wheel_flank_from_diameter_m": 2 * flank_start(drive),
        "wheel_fillet_radius_m": wheel.fillet_radius,
        "wheel_groove_radius_m": hob.centre_distance - wheel.throat_radius
        if wheel.groove_radius is None
        else wheel.groove_radius,
        "wheel_face_width_m": wheel.face_width,
        "wheel_thickness_m": wheel_thickness(drive),
    }
    if wheel.backlash is not None:
        about["backlash_m"] = wheel.backlash
    return about


def _clearances(drive: "ZiWormDrive") -> Described:
    """From the tips of the one to the roots of the other, on the line of centres."""
    distance, worm, wheel, hob = drive.centre_distance, drive.worm, drive.wheel, drive.hob
    root = hob.centre_distance - hob.tip_radius
    return {
        "worm_tip_clearance_m": distance - worm.tip_radius - root,
        "wheel_tip_clearance_m": distance - wheel.throat_radius - worm.root_radius,
    }


def _hob(drive: "ZiWormDrive") -> Described:
    hob, flank = drive.hob, drive.wheel_flank.hob
    worm, cut = drive.base_pitches
    about: Described = {
        "hob_oversize_m": 2 * (hob.centre_distance - drive.centre_distance),
        "hob_tip_diameter_m": 2 * hob.tip_radius,
        "hob_normal_pressure_angle_deg": degrees(flank.pressure_angle(drive.reference_radii[1])),
        "hob_lead_m": hob.lead,
        "hob_centre_distance_m": hob.centre_distance,
        "hob_swivel_deg": degrees(hob.swivel),
        "hob_axial_shift_m": hob.axial_shift,
        "normal_base_pitch_m": worm,
        "hob_base_pitch_difference_m": cut - worm,
    }
    if hob.base_radius is not None and hob.base_lead_angle is not None:
        about |= {
            "hob_base_diameter_m": 2 * hob.base_radius,
            "hob_base_lead_angle_deg": degrees(hob.base_lead_angle),
        }
    return about


def _mesh(drive: "ZiWormDrive") -> Described:
    path = [drive.cycle.contact(phase) for phase in (0.0, 0.5, 1.0)]
    faces, radii = np.transpose([drive.flank_place(of, np.zeros(()), np.zeros(())) for of in path])
    lead_angle = _lead_angle(drive.worm.lead, drive.reference_radius)
    return {
        "mesh_begins_at": drive.cycle.begin_boundary,
        "mesh_ends_at": drive.cycle.end_boundary,
        "pattern_along_face_m": float(faces[1]),
        "pattern_radius_m": float(radii[1]),
        "pattern_along_face_first_m": float(faces[0]),
        "pattern_along_face_last_m": float(faces[2]),
        "sliding_speed_m_per_s": drive.reference_radius * drive.speed / cos(lead_angle),
        "wheel_torque_N_m": drive.wheel_torque,
    }


def _shaft(drive: "ZiWormDrive") -> Described:
    """The bent shaft of the worm and the forces of its bearings."""
    bent = drive.bent
    if bent is None:
        return {}
    return {
        "shaft_deflection_m": bent.deflection,
        "shaft_deflection_limit_m": deflection_limit(drive.module),
        "shaft_deflection_away_m": bent.away,
        "shaft_deflection_to_leaving_side_m": bent.along,
        "shaft_tilt_deg": degrees(bent.tilt),
        "worm_thrust_N": float(bent.force[2]),
        "bearing_force_N": bent.reactions[0],
        "bearing_force_of_thrust_side_N": bent.reactions[1],
    }


def _pattern(drive: "ZiWormDrive") -> Described:
    """What compound marks without load and under it, and the shim for errors of the assembly."""
    about: Described = {"marking_thickness_m": THICKNESS}
    for name, pattern in (
        ("marking", drive.driven_pattern),
        ("loaded_marking", drive.loaded_patterns[0]),
    ):
        first, last = pattern.along_face()
        about |= {
            f"{name}_fraction": pattern.fraction(),
            f"{name}_along_face_first_m": first,
            f"{name}_along_face_last_m": last,
        }
    if drive.assembly != AS_DESIGNED:
        about["wheel_shim_to_leaving_side_m"] = drive.wheel_shim(None).shift
    return about


def _tolerances(drive: "ZiWormDrive") -> Described:
    """Play as assembled, and the errors of the assembly that the drive allows."""
    about: Described = {}
    if drive.play is not None:
        about["play_as_assembled_m"] = drive.play
    for one in drive.tolerances:
        about |= {f"allowed_{one.entry}_{key}": value for key, value in one.row.items()}
    return about
