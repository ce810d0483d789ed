"""A roller enveloping worm drive as its drawing would have it, with its mesh."""

from math import atan2, cos, degrees, hypot, pi

from pyworm.drives.roller_worm.mesh import RollerMesh

Described = dict[str, float | str]

SHEET = (
    *("hand", "threads", "gear_ratio", "centre_distance_m", "lead_angle_deg", "throat_angle_deg"),
    *("outer_angle_deg", "contact_ratio", "sliding_speed_m_per_s", "face_coverage"),
    *("wheel_reference_diameter_m", "wheel_tip_diameter_m", "worm_throat_diameter_m"),
    *("worm_flank_from_diameter_m", "worm_flank_to_diameter_m", "roller_count"),
    *("roller_diameter_m", "roller_length_m", "roller_tilt_deg"),
)
"""What of the geometry is printed."""


def described_rollers(mesh: RollerMesh) -> Described:
    """Geometry of worm and rollers, and their mesh; keys end in their unit.

    Diameters of the worm are those at its throat, of the part that bears the rollers; the design has neither
    its tip nor its root. There is no backlash: the sections are braced against each other.
    """
    worm, rollers, profile = mesh.worm, mesh.rollers, mesh.rollers.profile
    wheel = mesh.pitch_radius
    section = mesh.sections["left"]
    upright, pitch = cos(rollers.tilt), 2 * pi / rollers.count
    speeds = mesh.throat_radius * mesh.speed, wheel * mesh.wheel_speed
    return {
        "hand": worm.hand,
        "threads": worm.threads,
        "gear_ratio": mesh.ratio,
        "centre_distance_m": mesh.centre_distance,
        "throat_coefficient": worm.throat_coefficient,
        "arrangement": worm.arrangement,
        "lead_angle_deg": degrees(atan2(speeds[1], speeds[0])),
        "throat_angle_deg": degrees(worm.throat_angle),
        "outer_angle_deg": degrees(worm.outer_angle),
        "worm_throat_diameter_m": 2 * mesh.throat_radius,
        "worm_flank_from_diameter_m": 2 * mesh.axis_distance(worm.dedendum),
        "worm_flank_to_diameter_m": 2 * mesh.axis_distance(-worm.addendum),
        "wheel_reference_diameter_m": 2 * wheel,
        "wheel_tip_diameter_m": 2 * (wheel + profile.length / 2 * upright),
        "roller_count": rollers.count,
        "roller_shape": profile.shape,
        "roller_diameter_m": 2 * profile.radius,
        "roller_length_m": profile.length,
        "roller_tilt_deg": degrees(rollers.tilt),
        "roller_height_m": rollers.height,
        "contact_ratio": (section.last - section.first) / pitch,
        "sliding_speed_m_per_s": hypot(*speeds),
        "face_coverage": (worm.addendum + worm.dedendum) / profile.length,
        "wheel_torque_N_m": mesh.ratio * mesh.torque,
    }
