"""Closed forms of involute helicoids, the flanks of ZI worms and of their hobs.

Sources: F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2004, chapter 19; names as in DIN 3975
and ISO 1122-2. Lengths in m, angles in rad.
"""

from math import acos, asin, atan2, cos, pi, sqrt, tan


def normal_module(axial_module: float, lead_angle: float) -> float:
    """Module of the section normal to the threads [m], m_n = m_x cos(gamma)."""
    return axial_module * cos(lead_angle)


def lead_angle_of(threads: int, normal_module: float, reference_diameter: float) -> float:
    """Lead angle on a reference cylinder on which the threads have a normal module, sin(gamma) = z m_n / d.

    ValueError if no threads of this module wind about so thin a cylinder.
    """
    sine = threads * normal_module / reference_diameter
    if not sine < 1:
        raise ValueError(
            f"{threads} threads of a normal module of {normal_module * 1e3:.4g} mm do not wind about a "
            f"cylinder of {reference_diameter * 1e3:.4g} mm"
        )
    return asin(sine)


def base_lead_angle(lead_angle: float, pressure_angle: float) -> float:
    """Lead angle on the base cylinder, cos(gamma_b) = cos(gamma) cos(normal pressure angle)."""
    return acos(cos(lead_angle) * cos(pressure_angle))


def base_radius(lead: float, base_lead_angle: float) -> float:
    """Radius of the base cylinder [m], r_b = p / tan(gamma_b) with p = lead / 2 pi."""
    return lead / (2 * pi * tan(base_lead_angle))


def normal_pressure_angle(lead: float, base_radius: float, radius: float) -> float:
    """Normal pressure angle on a cylinder, cos(alpha_n) = cos(gamma_b) / cos(gamma).

    It is zero on the base cylinder, where the flank begins, and inside it.
    """
    screw = lead / (2 * pi)
    ratio = cos(atan2(screw, base_radius)) / cos(atan2(screw, radius))
    return acos(min(ratio, 1.0))


def axial_profile(radius: float, base_radius: float, lead: float) -> float:
    """Height of the flank along the axis over a radius at or outside the base cylinder [m].

    z = p (tan(alpha) - alpha) with p = lead / 2 pi and cos(alpha) = r_b / r: the profile of an involute.
    """
    tangent = sqrt(max(radius**2 - base_radius**2, 0.0)) / base_radius
    return lead / (2 * pi) * (tangent - atan2(tangent, 1.0))
