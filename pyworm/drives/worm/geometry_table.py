"""A worm drive as its drawing would have it, with what follows for mesh, hob and contact pattern."""

from collections.abc import Sequence
from math import atan2, cos, degrees

import numpy as np

from pyworm.drives.worm.flanks.worm_profiles import PRESSURE_ANGLE_PLACES, own_pressure_angle
from pyworm.drives.worm.inspection import (
    Inspection,
    backlash_limits,
    seated_ball,
    wheel_chord,
    worm_chord,
)
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.patterns.contact_pattern import THICKNESS, ContactPattern
from pyworm.drives.worm.teeth.tooth_form import flank_start, wheel_thickness, worm_thickness
from pyworm.drives.worm.tolerances import Tolerance
from pyworm.formulas.worm_deflection import deflection_limit

Described = dict[str, float | str]


SHEET = (
    *("profile", "hand", "threads", "teeth", "centre_distance_m", "module_m", "diameter_factor"),
    *("profile_shift", "pressure_angle_deg", "lead_m", "lead_angle_deg", "base_lead_angle_deg"),
    *("worm_reference_diameter_m", "worm_tip_diameter_m", "worm_root_diameter_m"),
    *("worm_base_diameter_m", "wheel_reference_diameter_m", "wheel_throat_diameter_m"),
    *("wheel_outside_diameter_m", "wheel_root_diameter_m", "wheel_face_width_m"),
    *("worm_thickness_m", "wheel_thickness_m", "worm_chordal_thickness_m"),
    *("wheel_chordal_thickness_m", "worm_chordal_height_m", "wheel_chordal_height_m"),
    *("worm_ball_diameter_m", "worm_over_balls_m", "backlash_m", "least_backlash_m"),
    *("largest_backlash_m", "worm_tip_clearance_m", "wheel_tip_clearance_m", "contact_ratio"),
    *("sliding_speed_m_per_s", "face_coverage", "hob_oversize_m", "hob_swivel_deg"),
)
"""What of the geometry is printed and stands on the page to sign."""


def _geometry(mesh: WormMesh, inspection: Inspection) -> Described:
    parts = _gear(mesh), _worm(mesh), _wheel(mesh), _inspected(mesh, inspection), _clearances(mesh)
    ratio: Described = {"contact_ratio": mesh.mean_teeth_in_contact}
    return dict(item for part in (*parts, ratio) for item in part.items())


def signed_geometry(mesh: WormMesh, inspection: Inspection) -> Described:
    """Geometry for the page to sign; keys end in their unit."""
    found = _geometry(mesh, inspection)
    return {key: found[key] for key in SHEET if key in found}


def described_mesh(mesh: WormMesh, inspection: Inspection) -> Described:
    """Geometry of worm, wheel and hob, the mesh as assembled and the shaft; keys end in their unit."""
    return _geometry(mesh, inspection) | _hob(mesh) | _mesh(mesh) | _shaft(mesh)


def _gear(mesh: WormMesh) -> Described:
    return {
        "profile": mesh.worm.profile,
        "hand": mesh.hand,
        "threads": mesh.worm.threads,
        "teeth": mesh.wheel.teeth,
        "gear_ratio": mesh.wheel.teeth / mesh.worm.threads,
        "centre_distance_m": mesh.centre_distance,
        "module_m": mesh.module,
        "diameter_factor": 2 * mesh.reference_radius / mesh.module,
        "profile_shift": mesh.profile_shift,
    }


def _lead_angle(lead: float, radius: float) -> float:
    return atan2(lead, 2 * np.pi * radius)


def _worm(mesh: WormMesh) -> Described:
    worm, radius, flank = mesh.worm, mesh.reference_radius, mesh.worm_flank
    lead_angle = _lead_angle(worm.lead, radius)
    normal = flank.pressure_angle(radius)
    pressure_angle = own_pressure_angle(worm.profile, worm.generator, lead_angle, normal)
    about: Described = {
        "normal_module_m": mesh.module * cos(lead_angle),
        "pressure_angle_deg": degrees(pressure_angle),
        "pressure_angle_of": PRESSURE_ANGLE_PLACES[worm.profile],
        "normal_pressure_angle_deg": degrees(normal),
        "axial_pitch_m": worm.axial_pitch,
        "lead_m": worm.lead,
        "lead_angle_deg": degrees(lead_angle),
        "worm_reference_diameter_m": 2 * radius,
        "worm_tip_diameter_m": 2 * worm.tip_radius,
        "worm_root_diameter_m": 2 * worm.root_radius,
        "worm_flank_from_diameter_m": 2 * mesh.worm_tooth.start_radius,
        "worm_fillet_radius_m": worm.fillet_radius,
        "worm_thickness_m": worm_thickness(mesh, radius),
        "worm_normal_thickness_m": worm_thickness(mesh, radius) * cos(lead_angle),
        "worm_tip_thickness_m": worm_thickness(mesh, worm.tip_radius),
    }
    if worm.base_radius is not None:
        about |= {
            "base_lead_angle_deg": degrees(_lead_angle(worm.lead, worm.base_radius)),
            "base_radius_m": worm.base_radius,
            "worm_base_diameter_m": 2 * worm.base_radius,
        }
    return about


def _wheel(mesh: WormMesh) -> Described:
    wheel, hob = mesh.wheel, mesh.hob
    about: Described = {
        "wheel_reference_diameter_m": 2 * mesh.wheel_reference_radius,
        "wheel_throat_diameter_m": 2 * wheel.throat_radius,
        "wheel_outside_diameter_m": 2 * wheel.tip_radius,
        "wheel_root_diameter_m": 2 * (hob.centre_distance - hob.tip_radius),
        "wheel_flank_from_diameter_m": 2 * flank_start(mesh),
        "wheel_fillet_radius_m": wheel.fillet_radius,
        "wheel_groove_radius_m": hob.centre_distance - wheel.throat_radius
        if wheel.groove_radius is None
        else wheel.groove_radius,
        "wheel_face_width_m": wheel.face_width,
        "wheel_thickness_m": wheel_thickness(mesh),
    }
    if wheel.backlash is not None:
        about["backlash_m"] = wheel.backlash
    return about


def _inspected(mesh: WormMesh, inspection: Inspection) -> Described:
    """What is measured on worm and wheel, and the backlash that it leaves."""
    lead_angle = _lead_angle(mesh.worm.lead, mesh.reference_radius)
    about: Described = {}
    for name, chord in (("worm", worm_chord(mesh)), ("wheel", wheel_chord(mesh))):
        if chord is not None:
            about[f"{name}_chordal_thickness_m"] = chord.thickness
            about[f"{name}_chordal_height_m"] = chord.height
    ball = seated_ball(mesh, inspection.worm_ball_diameter)
    if ball is not None:
        about |= {
            "worm_ball_diameter_m": ball.diameter,
            "worm_ball_contact_diameter_m": 2 * ball.contact_radius,
            "worm_over_balls_m": ball.over,
        }
    if mesh.wheel.backlash is not None:
        across = cos(lead_angle) * cos(mesh.worm_flank.pressure_angle(mesh.reference_radius))
        about |= {
            "normal_backlash_m": mesh.wheel.backlash * across,
            "backlash_angle_deg": degrees(mesh.wheel.backlash / mesh.wheel_reference_radius),
        }
    limits = backlash_limits(mesh, inspection)
    if limits is not None:
        about |= {"least_backlash_m": limits[0], "largest_backlash_m": limits[1]}
    return about


def _clearances(mesh: WormMesh) -> Described:
    """From the tips of the one to the roots of the other, on the line of centres."""
    distance, worm, wheel, hob = mesh.centre_distance, mesh.worm, mesh.wheel, mesh.hob
    root = hob.centre_distance - hob.tip_radius
    return {
        "worm_tip_clearance_m": distance - worm.tip_radius - root,
        "wheel_tip_clearance_m": distance - wheel.throat_radius - worm.root_radius,
    }


def _hob(mesh: WormMesh) -> Described:
    hob, flank = mesh.hob, mesh.wheel_flank.hob
    worm, cut = mesh.base_pitches
    about: Described = {
        "hob_oversize_m": 2 * (hob.centre_distance - mesh.centre_distance),
        "hob_tip_diameter_m": 2 * hob.tip_radius,
        "hob_normal_pressure_angle_deg": degrees(flank.pressure_angle(mesh.reference_radii[1])),
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


def _mesh(mesh: WormMesh) -> Described:
    path = [mesh.cycle.contact(phase) for phase in (0.0, 0.5, 1.0)]
    faces, radii = np.transpose(
        [mesh.flank_place(contact, np.zeros(()), np.zeros(())) for contact in path]
    )
    lead_angle = _lead_angle(mesh.worm.lead, mesh.reference_radius)
    return {
        "mesh_begins_at": mesh.cycle.begin_boundary,
        "mesh_ends_at": mesh.cycle.end_boundary,
        "pattern_along_face_m": float(faces[1]),
        "pattern_radius_m": float(radii[1]),
        "pattern_along_face_first_m": float(faces[0]),
        "pattern_along_face_last_m": float(faces[2]),
        "sliding_speed_m_per_s": mesh.reference_radius * mesh.speed / cos(lead_angle),
        "wheel_torque_N_m": mesh.wheel_torque,
    }


def _shaft(mesh: WormMesh) -> Described:
    bent = mesh.shaft_deflection
    if bent is None:
        return {}
    return {
        "shaft_deflection_m": bent.deflection,
        "shaft_deflection_limit_m": deflection_limit(mesh.module),
        "shaft_deflection_away_m": bent.away,
        "shaft_deflection_to_leaving_side_m": bent.along,
        "shaft_tilt_deg": degrees(bent.tilt),
        "worm_thrust_N": float(bent.force[2]),
        "bearing_force_N": bent.reactions[0],
        "bearing_force_of_thrust_side_N": bent.reactions[1],
    }


def described_patterns(
    unloaded: ContactPattern, loaded: ContactPattern, face_width: float
) -> Described:
    """What compound marks of the driven flank without load and under it, over the face width [m]."""
    about: Described = {"marking_thickness_m": THICKNESS}
    for name, pattern in (("marking", unloaded), ("loaded_marking", loaded)):
        first, last = pattern.along_face()
        about |= {
            f"{name}_fraction": pattern.fraction(),
            f"{name}_along_face_first_m": first,
            f"{name}_along_face_last_m": last,
        }
    about["face_coverage"] = (last - first) / face_width
    return about


def described_tolerances(play: float | None, tolerances: Sequence[Tolerance]) -> Described:
    """Play as assembled [m], where it is known, and the errors of the assembly that are allowed."""
    about: Described = {} if play is None else {"play_as_assembled_m": play}
    for tolerance in tolerances:
        about |= {f"allowed_{tolerance.entry}_{key}": value for key, value in tolerance.row.items()}
    return about
