"""Regimes of lubrication: whether pressure thickens the oil and whether it bends the bodies.

Four limiting minimum films are compared. Each mechanism adds film over the rigid isoviscous one,
but elastic flattening caps what the thickening of the oil can add, so

    h = max{ max(isoviscous-rigid, isoviscous-elastic),
             min(piezoviscous-rigid, piezoviscous-elastic) },

and the regime is the one whose film this picks. Letting the thickest film win instead would call
heavily loaded elastohydrodynamic contacts rigid, since the rigid piezoviscous film does not fall
with load.
"""

from dataclasses import dataclass
from math import atan, exp, sqrt

from pyworm.formulas.film import LineGroups, PointGroups
from pyworm.formulas.hertz import ellipticity

ISOVISCOUS_RIGID = "isoviscous-rigid"
PIEZOVISCOUS_RIGID = "piezoviscous-rigid"
ISOVISCOUS_ELASTIC = "isoviscous-elastic"
PIEZOVISCOUS_ELASTIC = "piezoviscous-elastic"

POINT_RANGE = (1, 8)
"""Ellipticities for which Hamrock and Dowson's chart was made."""


@dataclass(frozen=True)
class Regime:
    """The regime of a contact with the films that decide it.

    Attributes
    ----------
    name : str
        Isoviscous or piezoviscous, rigid or elastic, as "piezoviscous-elastic".
    film_by_regime : dict of str to float
        Minimum film each regime's formula gives [m].
    parameters : dict of str to float
        Coordinates on the chart of regimes: "viscosity" (g_V) and "elasticity" (g_E) [-].
    ratio : float or None
        Relative radius along the entrainment over that across, which a chart of points is drawn for [-];
        None of a line contact, whose chart is one.
    """

    name: str
    film_by_regime: dict[str, float]
    parameters: dict[str, float]
    ratio: float | None = None

    @property
    def doubt(self) -> str:
        """Caveat where the contact lies outside the chart's range; empty within it."""
        if self.ratio is None:
            return ""
        k, (least, most) = ellipticity(1 / self.ratio), POINT_RANGE
        return (
            "" if least <= k <= most else f"charted for ellipticity {least} to {most}, here {k:.2g}"
        )


def point_regime(groups: PointGroups) -> Regime:
    """Hamrock and Dowson's regime of an elliptic contact.

    With g_V = G W^3 / U^2, g_E = W^(8/3) / U^2, r = 1/D, k the ellipticity of the Hertz contact and
    H = (h/R) (W/U)^2:

        isoviscous-rigid      128 r {1 + 2/(3 r)}^-2 {0.131 atan(r/2) + 1.683}^2
        piezoviscous-rigid    1.66 g_V^(2/3) (1 - e^(-0.68 k))
        isoviscous-elastic    8.70 g_E^0.67 (1 - 0.85 e^(-0.31 k))
        piezoviscous-elastic  3.42 g_V^0.49 g_E^0.17 (1 - e^(-0.68 k))

    Source: B. J. Hamrock and D. Dowson, Proc. 5th Leeds-Lyon Symp. on Tribology (1979) 22-27.
    Range: k from 1 to 8. The later piezoviscous-rigid form in g_V^0.375 (1 - e^(-0.0387 r)) is not
    used: as found in print, with the factor 1.41, it stays below the isoviscous film up to
    g_V = 1e9 at k = 1, though oil that thickens under pressure cannot thin a film.
    """
    u, w = groups.speed, groups.load
    viscosity, elasticity = groups.material * w**3 / u**2, w ** (8 / 3) / u**2
    films = point_films(viscosity, elasticity, groups.ratio)
    return _regime(films, groups.radius * (u / w) ** 2, viscosity, elasticity, groups.ratio)


def point_films(viscosity: float, elasticity: float, ratio: float) -> dict[str, float]:
    """Film of each regime, H = (h/R) (W/U)^2, by the formulas of `point_regime`.

    Parameters
    ----------
    viscosity, elasticity : float or array
        g_V and g_E [-].
    ratio : float
        D, relative radius along the entrainment over that across [-].
    """
    r, k = 1 / ratio, ellipticity(1 / ratio)
    side = 1 - exp(-0.68 * k)
    return {
        ISOVISCOUS_RIGID: 128 * r * (1 + 2 / (3 * r)) ** -2 * (0.131 * atan(r / 2) + 1.683) ** 2,
        PIEZOVISCOUS_RIGID: 1.66 * viscosity ** (2 / 3) * side,
        ISOVISCOUS_ELASTIC: 8.70 * elasticity**0.67 * (1 - 0.85 * exp(-0.31 * k)),
        PIEZOVISCOUS_ELASTIC: 3.42 * viscosity**0.49 * elasticity**0.17 * side,
    }


def line_regime(groups: LineGroups) -> Regime:
    """Johnson's regime of a line contact.

    With g_V = (G^2 W^3 / U)^(1/2) = sqrt(2) M^(3/2) L, g_E = (W^2 / U)^(1/2) = sqrt(2) M and
    H = (h/R) (W/U):

        isoviscous-rigid      4.9
        piezoviscous-rigid    1.666 g_V^(2/3)
        isoviscous-elastic    3.10 g_E^0.8
        piezoviscous-elastic  1.665 g_V^0.75 g_E^-0.25

    The last is the asymptote for large lubricant parameters (Moes' 0.99 M^(-1/8) L^(3/4)), not
    Dowson and Higginson's regression: only the asymptote meets the rigid film on a line,
    g_V = g_E^3, that growing load crosses from rigid to elastic. 1.666 is the exact constant of
    rigid cylinders with Reynolds' exit condition, usually printed as 1.66.

    Source: K. L. Johnson, J. Mech. Eng. Sci. 12 (1970) 9-16; C. J. Hooke, J. Mech. Eng. Sci. 19
    (1977) 149-156; H. Moes, Lubrication and Beyond, University of Twente (2000).
    """
    u, w = groups.speed, groups.load
    viscosity, elasticity = groups.material * sqrt(w**3 / u), w / sqrt(u)
    return _regime(line_films(viscosity, elasticity), groups.radius * u / w, viscosity, elasticity)


def line_films(viscosity: float, elasticity: float) -> dict[str, float]:
    """Film of each regime, H = (h/R) (W/U), by the formulas of `line_regime`.

    Parameters
    ----------
    viscosity, elasticity : float or array
        g_V and g_E [-].
    """
    return {
        ISOVISCOUS_RIGID: 4.9,
        PIEZOVISCOUS_RIGID: 1.666 * viscosity ** (2 / 3),
        ISOVISCOUS_ELASTIC: 3.10 * elasticity**0.8,
        PIEZOVISCOUS_ELASTIC: 1.665 * viscosity**0.75 * elasticity**-0.25,
    }


def prevailing(films: dict[str, float]) -> str:
    """The regime by the rule of this module, from the film of each."""
    isoviscous = max(ISOVISCOUS_RIGID, ISOVISCOUS_ELASTIC, key=films.__getitem__)
    piezoviscous = min(PIEZOVISCOUS_RIGID, PIEZOVISCOUS_ELASTIC, key=films.__getitem__)
    return max(isoviscous, piezoviscous, key=films.__getitem__)


def _regime(
    films: dict[str, float],
    unit: float,
    viscosity: float,
    elasticity: float,
    ratio: float | None = None,
) -> Regime:
    """The regime of dimensionless films with their unit [m]."""
    return Regime(
        name=prevailing(films),
        film_by_regime={name: unit * film for name, film in films.items()},
        parameters={"viscosity": viscosity, "elasticity": elasticity},
        ratio=ratio,
    )
