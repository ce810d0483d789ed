"""Published charts of regimes: the minimum films of the four limits, and which of them holds.

Points: H = (h/R) (W/U)^2 over g_V = G W^3/U^2 = 4 L M^3 and g_E = W^(8/3)/U^2 = 4 M^(8/3). Lines:
H = (h/R) (W/U) over g_V = (G^2 W^3/U)^(1/2) = 2^(1/2) M^(3/2) L and g_E = (W^2/U)^(1/2) = 2^(1/2) M, where
M and L are Moes' parameters.

The regime of a contact is judged by limits and deflection of its own shape (`pyworm.formulas.regimes`), which
these charts, drawn beside it, are compared with; docs/theory/regimes.md has the differences.
"""

from math import atan, exp

import numpy as np

from pyworm.formulas.arrays import Indices, Values
from pyworm.formulas.hertz import ellipticity
from pyworm.formulas.regimes import (
    ISOVISCOUS_ELASTIC,
    ISOVISCOUS_RIGID,
    PIEZOVISCOUS_ELASTIC,
    PIEZOVISCOUS_RIGID,
    REGIMES,
)

POINT_RANGE = (1, 8)
"""Ellipticities for which Hamrock and Dowson's chart was made."""


def point_parameters(moes_m: Values, moes_l: Values) -> tuple[Values, Values]:
    """g_V and g_E of point contacts [-]."""
    return 4 * moes_l * moes_m**3, 4 * moes_m ** (8 / 3)


def line_parameters(moes_m: Values, moes_l: Values) -> tuple[Values, Values]:
    """g_V and g_E of line contacts [-]."""
    return np.sqrt(2) * moes_m**1.5 * moes_l, np.sqrt(2) * moes_m


def in_point_range(ratio: float) -> bool:
    """Whether the chart of points was made for a radius along the entrainment over that across, D."""
    least, most = POINT_RANGE
    # the ellipticity of a circle is 1 but for rounding
    return bool(least * (1 - 1e-9) <= ellipticity(1 / ratio) <= most)


def point_films(viscosity: Values, elasticity: Values, ratio: float) -> dict[str, Values]:
    """Film of each regime of an elliptic contact by Hamrock and Dowson; the largest holds.

    With r = 1/D and k the ellipticity of the Hertz contact:

        isoviscous-rigid      128 r {1 + 2/(3 r)}^-2 {0.131 atan(r/2) + 1.683}^2
        piezoviscous-rigid    141 g_V^0.375 (1 - e^(-0.0387 r))
        isoviscous-elastic    8.70 g_E^0.67 (1 - 0.85 e^(-0.31 k))
        piezoviscous-elastic  3.42 g_V^0.49 g_E^0.17 (1 - e^(-0.68 k))

    Source: B. J. Hamrock and D. Dowson, Proc. 5th Leeds-Lyon Symp. on Tribology (1979) 22-27; the second
    M. Esfahanian and B. J. Hamrock, Tribol. Trans. 34 (1991) 628-632, from memory. Its factor is also printed
    as 1.41, a misprint: that film is a hundredth of the rigid isoviscous one where alpha p is 1. The
    first piezoviscous-rigid form, 1.66 g_V^(2/3) (1 - e^(-0.68 k)), is nearer to solutions for rigid bodies
    (`benchmarks/atlas/rigid.py`), but as the largest film it would call heavily loaded contacts rigid. Range:
    k from 1 to 8.

    Args:
        viscosity, elasticity: g_V and g_E [-].
        ratio: D, relative radius along the entrainment over that across [-].
    """
    r, k = 1 / ratio, ellipticity(1 / ratio)
    return {
        ISOVISCOUS_RIGID: 128 * r * (1 + 2 / (3 * r)) ** -2 * (0.131 * atan(r / 2) + 1.683) ** 2,
        PIEZOVISCOUS_RIGID: 141 * viscosity**0.375 * (1 - exp(-0.0387 * r)),
        ISOVISCOUS_ELASTIC: 8.70 * elasticity**0.67 * (1 - 0.85 * exp(-0.31 * k)),
        PIEZOVISCOUS_ELASTIC: 3.42 * viscosity**0.49 * elasticity**0.17 * (1 - exp(-0.68 * k)),
    }


def point_chart(viscosity: Values, elasticity: Values, ratio: float) -> Indices:
    """Place in `REGIMES` by Hamrock and Dowson's chart; arguments as of `point_films`."""
    films = point_films(viscosity, elasticity, ratio)
    point_chart: Indices = np.argmax(
        np.stack(np.broadcast_arrays(*(films[name] for name in REGIMES))), axis=0
    )
    return point_chart


def line_films(viscosity: Values, elasticity: Values) -> dict[str, Values]:
    """Film of each regime of a line contact by Johnson and Hooke.

        isoviscous-rigid      4.9
        piezoviscous-rigid    1.666 g_V^(2/3)
        isoviscous-elastic    3.10 g_E^0.8
        piezoviscous-elastic  1.665 g_V^0.75 g_E^-0.25

    The last is the asymptote for large lubricant parameters (Moes' 0.99 M^(-1/8) L^(3/4)), not Dowson and
    Higginson's regression: only the asymptote meets the rigid film on a line, g_V = g_E^3, that growing load
    crosses from rigid to elastic. 1.666 is the exact constant of rigid cylinders with Reynolds' exit
    condition, usually printed as 1.66.

    Source: K. L. Johnson, J. Mech. Eng. Sci. 12 (1970) 9-16; C. J. Hooke, J. Mech. Eng. Sci. 19 (1977)
    149-156; H. Moes, Lubrication and Beyond, University of Twente (2000).

    Args:
        viscosity, elasticity: g_V and g_E [-].
    """
    return {
        ISOVISCOUS_RIGID: 4.9,
        PIEZOVISCOUS_RIGID: 1.666 * viscosity ** (2 / 3),
        ISOVISCOUS_ELASTIC: 3.10 * elasticity**0.8,
        PIEZOVISCOUS_ELASTIC: 1.665 * viscosity**0.75 * elasticity**-0.25,
    }


def line_chart(viscosity: Values, elasticity: Values) -> Indices:
    """Place in `REGIMES` by Johnson and Hooke's chart; arguments as of `line_films`.

    Elastic flattening adds film to an isoviscous oil, and caps what thickening adds to a piezoviscous one.
    """
    films = line_films(viscosity, elasticity)
    thin = np.maximum(films[ISOVISCOUS_RIGID], films[ISOVISCOUS_ELASTIC])
    thick = np.minimum(films[PIEZOVISCOUS_RIGID], films[PIEZOVISCOUS_ELASTIC])
    flat = np.where(
        thick > thin,
        films[PIEZOVISCOUS_RIGID] > films[PIEZOVISCOUS_ELASTIC],
        films[ISOVISCOUS_ELASTIC] > films[ISOVISCOUS_RIGID],
    )
    line_chart: Indices = 2 * flat + 1 * (thick > thin)
    return line_chart
