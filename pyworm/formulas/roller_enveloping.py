"""Films of roller enveloping worm drives as their source prints them, and its normal force corrected.

Source: "Elastohydrodynamic Lubrication Analysis of a Novel Roller Enveloping End Face Engagement Worm Gear
Drive", of the school of X. Deng. It is kept under its own name so that its tables can be compared; films are
not to be trusted. Its four film formulas are the line contact's of Hooke's chart, but

- g_v and g_e lack their square roots (K. L. Johnson, J. Mech. Eng. Sci. 12 (1970) 9-16);
- the powers of the rigid-piezoviscous and elastic-isoviscous films do not make a length;
- its elastic-piezoviscous film, Dowson and Higginson's, already is the minimum, and is taken times 0.75;
- the normal force has the cosine of the lead angle where its sine belongs.
"""

from dataclasses import dataclass
from math import cos, sin

from pyworm.formulas.arrays import Values

MINIMUM_FRACTION = 0.75
"""What the source takes for minimum over central film."""


@dataclass(frozen=True)
class PrintedFilms:
    """The source's four films with SI numbers put in; only the first and last are lengths [m]."""

    rigid_isoviscous: Values
    """Film of rigid bodies and an isoviscous oil, the first of the source."""
    rigid_piezoviscous: Values
    """Film of rigid bodies and a piezoviscous oil, the second of the source."""
    elastic_isoviscous: Values
    """Film of elastic bodies and an isoviscous oil, the third of the source."""
    elastic_piezoviscous: Values
    """Film of elastic bodies and a piezoviscous oil, the fourth of the source."""


def printed_films(
    radius: Values,
    load_per_length: Values,
    reduced_modulus: float,
    speed: Values,
    viscosity: float,
    alpha: float,
) -> PrintedFilms:
    """The four films as printed, of a radius R_v, one over the induced curvature [m], under w [N/m].

    The speed u_jx is the mean of both surfaces across the contact line [m/s].
    """
    r, w, e, eu, a = radius, load_per_length, reduced_modulus, viscosity * speed, alpha
    return PrintedFilms(
        rigid_isoviscous=4.9 * eu * r / w,
        rigid_piezoviscous=1.66 * eu**0.67 * a**0.53 * r**0.67 / w**0.11,
        elastic_isoviscous=3.01 * eu**0.80 * r**0.80 / (e**0.08 * w**0.04),
        elastic_piezoviscous=2.65 * eu**0.70 * a**0.54 * r**0.43 / (e**0.03 * w**0.13),
    )


def printed_minimum(
    radius: Values,
    load_per_length: Values,
    reduced_modulus: float,
    speed: Values,
    viscosity: float,
    alpha: float,
) -> Values:
    """The source's minimum film [m], 0.75 times its elastic-piezoviscous; arguments as `printed_films`."""
    films = printed_films(radius, load_per_length, reduced_modulus, speed, viscosity, alpha)
    return MINIMUM_FRACTION * films.elastic_piezoviscous


def printed_parameters(
    radius: Values,
    load_per_length: Values,
    reduced_modulus: float,
    speed: Values,
    viscosity: float,
    alpha: float,
) -> tuple[Values, Values]:
    """The source's g_v and g_e, squares of Johnson's; arguments as `printed_films`."""
    r, w, eu = radius, load_per_length, viscosity * speed
    return alpha**2 * w**3 / (eu * r**2), w**2 / (eu * reduced_modulus * r)


def printed_normal_force(
    worm_torque: float, diameter: float, pressure_angle: float, lead_angle: float
) -> float:
    """The source's normal force [N], 2 T1 / (d1 cos(alpha_n) cos(lambda)), d1 at the worm's throat."""
    return 2 * worm_torque / (diameter * cos(pressure_angle) * cos(lead_angle))


def normal_force(
    worm_torque: float,
    diameter: float,
    pressure_angle: float,
    lead_angle: float,
    friction: float = 0.0,
) -> float:
    """The normal force [N] that balances a worm's torque [N m] on one contact at the throat.

    2 T1 / {d1 [cos(alpha_n) sin(lambda) + mu cos(lambda)]}; arguments as `printed_normal_force`, friction the
    coefficient mu of sliding along the thread [-].
    """
    component = cos(pressure_angle) * sin(lead_angle) + friction * cos(lead_angle)
    return 2 * worm_torque / (diameter * component)
