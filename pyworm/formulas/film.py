"""Film thickness of smooth, isothermal, fully flooded contacts by published formulas.

Every formula takes the dimensionless groups of a contact and returns films in metres. The groups
belong to the direction of entrainment: R is the radius along it and D the ratio of the radius along
it to the radius across it, so a contact with its long axis across the entrainment has D < 1.

Conventions: 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2; the speed is the mean (u1 + u2)/2.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Values
from pyworm.formulas.hertz import ellipticity


@dataclass(frozen=True)
class Film:
    """Films by one formula."""

    central: Values | None
    """Film in the middle of the contact [m]; None if the formula does not give it."""
    minimum: Values | None
    """Minimum film [m]; None if the formula does not give it."""

    @property
    def central_number(self) -> float:
        """Film in the middle of one contact [m], by a formula that gives it."""
        if self.central is None:
            raise ValueError("the formula gives no central film thickness")
        return float(self.central)

    @property
    def minima(self) -> Values:
        """Minimum films of one contact or of several [m], by a formula that gives them."""
        if self.minimum is None:
            raise ValueError("the formula gives no minimum film thickness")
        return self.minimum

    @property
    def minimum_number(self) -> float:
        """Minimum film of one contact [m], by a formula that gives it."""
        return float(self.minima)


@dataclass(frozen=True)
class PointGroups:
    """Dimensionless groups of a point contact, numbers or arrays."""

    radius: float
    """Relative radius of curvature R along the entrainment [m]."""
    ratio: float
    """D, radius along over radius across the entrainment [-]."""
    speed: float
    """U = eta0 um / (E' R) [-]."""
    load: float
    """W = F / (E' R^2) [-]."""
    material: float
    """G = alpha E' [-]."""

    @property
    def moes_m(self) -> float:
        """Load parameter M = W (2U)^(-3/4) (Moes)."""
        moes_m: float = self.load * (2 * self.speed) ** -0.75
        return moes_m

    @property
    def moes_l(self) -> float:
        """Lubricant parameter L = G (2U)^(1/4) (Moes)."""
        moes_l: float = self.material * (2 * self.speed) ** 0.25
        return moes_l

    @property
    def moes_film(self) -> float:
        """Film [m] for which Moes' dimensionless film (h/R) (2U)^(-1/2) is 1."""
        moes_film: float = self.radius * (2 * self.speed) ** 0.5
        return moes_film

    @property
    def ellipticity(self) -> Values:
        """Ellipticity k of the Hertz contact: axis across over axis along the entrainment [-]."""
        return ellipticity(1 / self.ratio)


@dataclass(frozen=True)
class LineGroups:
    """Dimensionless groups of a line contact, numbers or arrays."""

    radius: Values
    """Relative radius of curvature R [m]."""
    speed: Values
    """U = eta0 um / (E' R) [-]."""
    load: Values
    """W = w / (E' R) with w the load for each length [-]."""
    material: Values
    """G = alpha E' [-]."""

    @property
    def moes_m(self) -> Values:
        """Load parameter M = W (2U)^(-1/2) (Moes)."""
        moes_m: Values = self.load * (2 * self.speed) ** -0.5
        return moes_m

    @property
    def moes_l(self) -> Values:
        """Lubricant parameter L = G (2U)^(1/4) (Moes)."""
        moes_l: Values = self.material * (2 * self.speed) ** 0.25
        return moes_l

    @property
    def moes_film(self) -> Values:
        """Film [m] for which Moes' dimensionless film (h/R) (2U)^(-1/2) is 1."""
        moes_film: Values = self.radius * (2 * self.speed) ** 0.5
        return moes_film


def point_groups(
    radius_along: float,
    radius_across: float,
    load: float,
    reduced_modulus: float,
    speed: float,
    viscosity: float,
    alpha: float,
) -> PointGroups:
    """Groups of a point contact, its radii along and across the entrainment [m] (`radii_at_angle`).

    E' in Pa, speed um = |u1 + u2| / 2, viscosity of the inlet's oil at ambient pressure; alpha is 0 of an
    isoviscous oil.
    """
    return PointGroups(
        radius=radius_along,
        ratio=radius_along / radius_across,
        speed=viscosity * speed / (reduced_modulus * radius_along),
        load=load / (reduced_modulus * radius_along**2),
        material=alpha * reduced_modulus,
    )


def line_groups(
    radius: Values,
    load_per_length: Values,
    reduced_modulus: Values,
    speed: Values,
    viscosity: Values,
    alpha: Values,
) -> LineGroups:
    """Groups of a line contact; parameters as in `point_groups`, the load in [N/m]."""
    return LineGroups(
        radius=radius,
        speed=viscosity * speed / (reduced_modulus * radius),
        load=load_per_length / (reduced_modulus * radius),
        material=alpha * reduced_modulus,
    )


def radii_at_angle(radius_x: float, radius_y: float, angle: float) -> tuple[float, float]:
    """Radii along and across an entrainment turned by an angle [rad] from x towards y [m].

    The curvatures turn as 1/Re = cos^2/Rx + sin^2/Ry and 1/Rs = sin^2/Rx + cos^2/Ry (Chittenden et
    al. 1985); the twist of the surface in the turned axes is neglected, as it is there.
    """
    cos2, sin2 = np.cos(angle) ** 2, np.sin(angle) ** 2
    return 1 / (cos2 / radius_x + sin2 / radius_y), 1 / (sin2 / radius_x + cos2 / radius_y)


def hamrock_dowson(groups: PointGroups) -> Film:
    """Hamrock and Dowson's elliptic point contact.

    hc/R = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k)),
    hm/R = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k)),

    with k the ellipticity of the Hertz contact; the fit k = 1.03 D^(-0.64) often printed with the
    formula is 3 % off for a circle and changes the film by 1 to 2 %.

    Source: B. J. Hamrock and D. Dowson, J. Lubr. Technol. 99 (1977) 264-276. Range: elastic and
    piezoviscous, k from 1 to 8 (long axis across the entrainment), materials near G = 4500. Its
    minimum is a third too thick at M = 200 and worse above.
    """
    u, w, g, k = groups.speed, groups.load, groups.material, groups.ellipticity
    central = 2.69 * u**0.67 * g**0.53 * w**-0.067 * (1 - 0.61 * np.exp(-0.73 * k))
    minimum = 3.63 * u**0.68 * g**0.49 * w**-0.073 * (1 - np.exp(-0.68 * k))
    return Film(groups.radius * central, groups.radius * minimum)


def chittenden(groups: PointGroups) -> Film:
    """Chittenden's elliptic point contact entrained at any angle.

    hc/Re = 4.31 U^0.68 G^0.49 W^-0.073 {1 - exp[-1.23 (Rs/Re)^(2/3)]},
    hm/Re = 3.68 U^0.68 G^0.49 W^-0.073 {1 - exp[-0.67 (Rs/Re)^(2/3)]},

    with groups built from `radii_at_angle`.

    Source: R. J. Chittenden, D. Dowson, J. F. Dunn and C. M. Taylor, Proc. R. Soc. A 397 (1985)
    245-269 and 271-294. Range: elastic and piezoviscous; the minimum as in `hamrock_dowson`.
    """
    u, w, g = groups.speed, groups.load, groups.material
    slender = groups.ratio ** (-2 / 3)
    power = u**0.68 * g**0.49 * w**-0.073
    central = 4.31 * power * (1 - np.exp(-1.23 * slender))
    minimum = 3.68 * power * (1 - np.exp(-0.67 * slender))
    return Film(groups.radius * central, groups.radius * minimum)


def nijenbanning_venner_moes(groups: PointGroups) -> Film:
    """Nijenbanning, Venner and Moes' central film of elliptic contacts in every regime.

    The four asymptotes of `point_asymptotes` are joined as

        Hc^s = {H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8)}^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8),
        s = 1.5 {1 + exp(-1.2 H_EI/H_EP)},  H_00 = 1.8 / D,  H = (h/R) (2U)^(-1/2).

    The outer power 2s/3 is what makes the isoviscous limit L -> 0 hold; a version with its inverse
    and H_EI/H_RI in s is in circulation and fails that limit.

    Source: G. Nijenbanning, C. H. Venner and H. Moes, Wear 176 (1994) 217-229. Range: any load and
    lubricant parameter; made for the long axis across the entrainment (D <= 1), compared with solutions
    up to D = 5 (`film_ranges`). Within 11 % of those with a compressible Roelands oil for M up to 200 and
    L up to 10.
    """
    h = point_asymptotes(groups.moes_m, groups.moes_l, groups.ratio)
    crowned = _soft_min(h.elastic_isoviscous, 1.8 / groups.ratio, 4)
    isoviscous = (h.rigid_isoviscous**1.5 + crowned**1.5) ** (2 / 3)
    piezoviscous = _soft_min(h.rigid_piezoviscous, h.elastic_piezoviscous, 8)
    s = 1.5 * (1 + _decay(1.2 * h.elastic_isoviscous, h.elastic_piezoviscous))
    return Film(groups.moes_film * _join(isoviscous, piezoviscous, s), None)


def moes_circular(groups: PointGroups) -> Film:
    """Moes' central film of a circular contact, elastic regimes.

    Hc = [(1.70 t M^(-1/9) L^(3/4))^r + (1.96 M^(-1/9))^r]^(1/r), r = exp(1 - 6/(L + 8)),
    t = 1 - exp(-0.9 M^(1/6) / L^(1/6)); the ratio of radii is not used.

    Source: H. Moes, Lubrication and Beyond, University of Twente (2000). Range: D = 1, M > 5.
    Fitted to incompressible oils: 10 % thicker than a compressible one gives.
    """
    m, el = groups.moes_m, groups.moes_l
    t = 1 - _decay(0.9 * m ** (1 / 6), el ** (1 / 6))
    r = np.exp(1 - 6 / (el + 8))
    film = _join(1.96 * m ** (-1 / 9), 1.70 * t * m ** (-1 / 9) * el**0.75, r)
    return Film(groups.moes_film * film, None)


def masjedi_khonsari(groups: PointGroups) -> Film:
    """Masjedi and Khonsari's elliptic point contact, smooth surfaces.

    hc/R = 3.672 W^(-0.045 k^0.18) U^(0.663 k^0.025) G^(0.502 k^0.064) (1 - 0.573 e^(-0.74 k)),
    hm/R = 1.637 W^(-0.09 k^-0.15) U^(0.711 k^-0.023) G^(0.65 k^-0.045) (1 - 0.974 e^(-0.676 k)),

    with k the ellipticity of the Hertz contact.

    Source: M. Masjedi and M. M. Khonsari, Tribol. Int. 82 (2015) 228-244. Range: k from 1 to 8,
    elastic and piezoviscous.
    """
    u, w, g = groups.speed, groups.load, groups.material
    k = groups.ellipticity
    central = 3.672 * w ** (-0.045 * k**0.18) * u ** (0.663 * k**0.025) * g ** (0.502 * k**0.064)
    minimum = 1.637 * w ** (-0.09 * k**-0.15) * u ** (0.711 * k**-0.023) * g ** (0.65 * k**-0.045)
    return Film(
        groups.radius * central * (1 - 0.573 * np.exp(-0.74 * k)),
        groups.radius * minimum * (1 - 0.974 * np.exp(-0.676 * k)),
    )


def moes_line(groups: LineGroups) -> Film:
    """Moes' line contact in every regime.

    Central, meaning the film where the pressure is largest (H_RI and H_RP are exact there):

        H_RI = 3/M, H_EI = 2.621 M^(-1/5), H_RP = 1.287 L^(2/3), H_EP = 1.311 M^(-1/8) L^(3/4),
        Hc^s = (H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(-7/2) + H_EP^(-7/2))^(-2s/7),
        s = (7 + 8 exp(-2 H_EI/H_RI)) / 5.

    Minimum, elastic regimes:

        Hm = [(0.99 M^(-1/8) L^(3/4) t)^r + (2.05 M^(-1/5))^r]^(1/r),
        r = exp(1 - 3/(L + 4)),  t = 1 - exp(-3.5 M^(1/8) / L^(1/4)).

    Source: H. Moes, Lubrication and Beyond, University of Twente (2000). Range: central any M and
    L, fitted to incompressible oils; minimum M > 5, fitted to compressible oils. The two belong to
    different oils, so their ratio means little at high load.
    """
    m, el = groups.moes_m, groups.moes_l
    h = line_asymptotes(m, el)
    isoviscous, piezoviscous = joined_line(h)
    s = (7 + 8 * np.exp(-2 * h.elastic_isoviscous / h.rigid_isoviscous)) / 5
    t = 1 - _decay(3.5 * m**0.125, el**0.25)
    r = np.exp(1 - 3 / (el + 4))
    minimum = _join(2.05 * m**-0.2, 0.99 * m**-0.125 * el**0.75 * t, r)
    return Film(groups.moes_film * _join(isoviscous, piezoviscous, s), groups.moes_film * minimum)


def dowson_higginson(groups: LineGroups) -> Film:
    """Dowson and Higginson's minimum film of a line contact, 2.65 U^0.70 G^0.54 W^-0.13.

    Source: D. Dowson, Proc. IMechE 182 (3A) (1968) 151-167. Range: elastic and piezoviscous.
    """
    u, w, g = groups.speed, groups.load, groups.material
    return Film(None, groups.radius * 2.65 * u**0.70 * g**0.54 * w**-0.13)


def dowson_toyoda(groups: LineGroups) -> Film:
    """Dowson and Toyoda's central film of a line contact, 3.06 U^0.69 G^0.56 W^-0.10.

    Source: D. Dowson and S. Toyoda, Proc. 5th Leeds-Lyon Symp. on Tribology (1979) 60-65. Range:
    elastic and piezoviscous.
    """
    u, w, g = groups.speed, groups.load, groups.material
    return Film(groups.radius * 3.06 * u**0.69 * g**0.56 * w**-0.10, None)


@dataclass(frozen=True)
class Asymptotes:
    """Films of the four limits, in Moes' dimensionless film (h/R) (2U)^(-1/2)."""

    rigid_isoviscous: Values
    """H_RI [-]."""
    elastic_isoviscous: Values
    """H_EI [-]."""
    rigid_piezoviscous: Values
    """H_RP [-]."""
    elastic_piezoviscous: Values
    """H_EP [-]."""


def point_asymptotes(moes_m: float, moes_l: float, ratio: float) -> Asymptotes:
    """Central films of an elliptic contact in its four limits.

    H_RI = 145 (1 + 0.796 D^(14/15))^(-15/7) D^-1 M^-2,
    H_EI = 3.18 (1 + 0.006 ln D + 0.63 D^(4/7))^(-14/25) D^(-1/15) M^(-2/15),
    H_RP = 1.29 (1 + 0.691 D)^(-2/3) L^(2/3),
    H_EP = 1.48 (1 + 0.006 ln D + 0.63 D^(4/7))^(-7/20) D^(-1/24) M^(-1/12) L^(3/4).

    Source: G. Nijenbanning, C. H. Venner and H. Moes, Wear 176 (1994) 217-229.
    """
    m, el, d = moes_m, moes_l, ratio
    shape = 1 + 0.006 * np.log(d) + 0.63 * d ** (4 / 7)
    return Asymptotes(
        rigid_isoviscous=145 * (1 + 0.796 * d ** (14 / 15)) ** (-15 / 7) / (d * m**2),
        elastic_isoviscous=3.18 * shape ** (-14 / 25) * d ** (-1 / 15) * m ** (-2 / 15),
        rigid_piezoviscous=1.29 * (1 + 0.691 * d) ** (-2 / 3) * el ** (2 / 3),
        elastic_piezoviscous=1.48 * shape ** (-7 / 20) * d ** (-1 / 24) * m ** (-1 / 12) * el**0.75,
    )


def line_asymptotes(moes_m: Values, moes_l: Values) -> Asymptotes:
    """Films of a line contact in its four limits, where the pressure is largest.

    Source: H. Moes, Lubrication and Beyond, University of Twente (2000); 3 and 1.287 are exact for
    rigid cylinders with Reynolds' exit condition.
    """
    return Asymptotes(
        rigid_isoviscous=3 / moes_m,
        elastic_isoviscous=2.621 * moes_m**-0.2,
        rigid_piezoviscous=1.287 * moes_l ** (2 / 3),
        elastic_piezoviscous=1.311 * moes_m**-0.125 * moes_l**0.75,
    )


def joined_line(limits: Asymptotes) -> tuple[Values, Values]:
    """Film of a line contact in an isoviscous oil, and in a piezoviscous one, from its limits (Moes)."""
    isoviscous = (limits.rigid_isoviscous ** (7 / 3) + limits.elastic_isoviscous ** (7 / 3)) ** (
        3 / 7
    )
    return isoviscous, _soft_min(limits.rigid_piezoviscous, limits.elastic_piezoviscous, 3.5)


def _soft_min(a: Values, b: Values, power: float) -> Values:
    """(a^-n + b^-n)^(-1/n), written so that a zero gives zero instead of an overflow."""
    small, large = np.minimum(a, b), np.maximum(a, b)
    return small * (1 + _over(small, large) ** power) ** (-1 / power)


def _join(a: Values, b: Values, power: Values) -> Values:
    """(a^n + b^n)^(1/n)."""
    small, large = np.minimum(a, b), np.maximum(a, b)
    return large * (1 + _over(small, large) ** power) ** (1 / power)


def _decay(numerator: Values, denominator: Values) -> Values:
    """exp(-numerator/denominator), zero where the denominator is."""
    with np.errstate(divide="ignore"):
        return np.exp(-np.divide(numerator, denominator))


def _over(small: Values, large: Values) -> Values:
    """small / large, zero where both are."""
    return np.divide(small, np.where(np.equal(large, 0), 1.0, large))
