"""A pair of involute gears as its drawing would have it, with its mesh (ISO 21771, ISO 1122-1)."""

from math import cos, degrees, isfinite, pi, tan

import numpy as np

from pyworm.drives.gear_pair.inspection import (
    PairInspection,
    ToothMeasures,
    backlash_limits,
    normal_backlash,
    tooth_measures,
)
from pyworm.drives.gear_pair.mesh import GearPairMesh
from pyworm.formulas.hertz import hertz
from pyworm.scene.point import Scene

Described = dict[str, float | str]

_OF_A_GEAR = (
    *("teeth", "profile_shift", "reference_diameter_m", "base_diameter_m", "pitch_diameter_m"),
    *("tip_diameter_m", "root_diameter_m", "thickness_m", "chordal_thickness_m"),
    *(
        "chordal_height_m",
        "ball_diameter_m",
        "over_balls_m",
        "span_teeth",
        "span_m",
        "tip_clearance_m",
    ),
)

SHEET = (
    *("centre_distance_m", "normal_module_m", "normal_pressure_angle_deg", "helix_angle_deg"),
    *("base_helix_angle_deg", "working_pressure_angle_deg", "face_width_m", "backlash_m"),
    *("least_backlash_m", "largest_backlash_m", "transverse_contact_ratio", "overlap_ratio"),
    *("sliding_speed_m_per_s", "face_coverage"),
    *(f"{gear}_{key}" for key in _OF_A_GEAR for gear in ("pinion", "gear")),
)
"""What of the geometry is printed."""


def described_pair(mesh: GearPairMesh, inspection: PairInspection) -> Described:
    """Geometry, measures and mesh of a pair of gears; keys end in their unit."""
    return _system(mesh) | _backlash(mesh, inspection) | _gears(mesh, inspection) | _mesh(mesh)


def _system(mesh: GearPairMesh) -> Described:
    pair, system = mesh.teeth, mesh.teeth.system
    return {
        "gear_ratio": pair.ratio,
        "centre_distance_m": pair.centre_distance,
        "reference_centre_distance_m": pair.reference_centre_distance,
        "normal_module_m": system.module,
        "transverse_module_m": system.transverse_module,
        "normal_pressure_angle_deg": degrees(system.pressure_angle),
        "transverse_pressure_angle_deg": degrees(system.transverse_pressure_angle),
        "working_pressure_angle_deg": degrees(pair.pressure_angle),
        "helix_angle_deg": degrees(system.helix_angle),
        "base_helix_angle_deg": degrees(system.base_helix_angle),
        "transverse_base_pitch_m": system.base_pitch,
        "face_width_m": pair.face_width,
    }


def _backlash(mesh: GearPairMesh, inspection: PairInspection) -> Described:
    about: Described = {
        "backlash_m": mesh.teeth.backlash,
        "normal_backlash_m": normal_backlash(mesh.teeth),
    }
    limits = backlash_limits(mesh.teeth, inspection)
    if limits is not None:
        about |= {"least_backlash_m": limits[0], "largest_backlash_m": limits[1]}
    return about


def _gears(mesh: GearPairMesh, inspection: PairInspection) -> Described:
    pair = mesh.teeth
    about: Described = {}
    for number, name in enumerate(("pinion", "gear")):
        gear, size = (pair.pinion, pair.gear)[number], pair.cylinders[number]
        measured = (inspection.pinion, inspection.gear)[number]
        other = pair.cylinders[1 - number]
        lead = (
            2 * pi * size.reference / tan(pair.system.helix_angle)
            if pair.system.helix_angle
            else np.inf
        )
        sizes = {
            "teeth": gear.teeth,
            "profile_shift": gear.profile_shift,
            "reference_diameter_m": 2 * size.reference,
            "base_diameter_m": 2 * size.base,
            "pitch_diameter_m": 2 * size.pitch,
            "tip_diameter_m": 2 * size.tip,
            "root_diameter_m": 2 * size.root,
            "flank_from_diameter_m": 2 * float(np.hypot(size.base, max(size.form_length, 0.0))),
            "lead_m": lead,
            "tip_thickness_m": size.tip_thickness,
            "tip_clearance_m": pair.centre_distance - size.tip - other.root,
            **_measured(tooth_measures(pair, number, measured)),
        }
        about |= {f"{name}_{key}": value for key, value in sizes.items() if isfinite(value)}
    return about


def _measured(found: ToothMeasures) -> dict[str, float]:
    measures = {
        "thickness_m": found.thickness,
        "chordal_thickness_m": found.chordal_thickness,
        "chordal_height_m": found.chordal_height,
        "ball_diameter_m": found.ball_diameter,
        "over_balls_m": found.over_balls,
        "over_pins_m": found.over_pins,
        "span_teeth": found.span_teeth,
        "span_m": found.span,
    }
    return {key: value for key, value in measures.items() if value is not None}


def _mesh(mesh: GearPairMesh) -> Described:
    pair = mesh.teeth
    ends = mesh.contacts(np.array([0.0, 1.0]))
    return {
        "transverse_contact_ratio": pair.transverse_contact_ratio,
        "overlap_ratio": pair.overlap_ratio,
        "contact_ratio": pair.transverse_contact_ratio + pair.overlap_ratio,
        "pitch_line_velocity_m_per_s": mesh.pitch_line_velocity,
        "sliding_speed_m_per_s": float(np.max(np.abs(ends.sliding))),
        "face_coverage": _face_coverage(mesh),
    }


def _face_coverage(mesh: GearPairMesh) -> float:
    """Part of the face that the dry contact at the pitch point reaches over [-]."""
    scene = mesh.scene_at(mesh.phase_of(mesh.teeth.pitch_point))
    if not isinstance(scene, Scene):
        return 1.0
    across, along = scene.radii
    dry = hertz(across, along, scene.load, mesh.reduced_modulus)
    reach = 2 * dry.semi_axis_y * cos(mesh.teeth.system.base_helix_angle)
    return min(reach / mesh.teeth.face_width, 1.0)
