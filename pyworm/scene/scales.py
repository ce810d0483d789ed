"""Scales of a scene by closed forms: Hertz's contact, Moes' groups, expected film."""

from dataclasses import dataclass, replace
from math import atan2, cos, exp, hypot, inf, log, pi, sin, sqrt

import numpy as np
import scipy

from pyworm.formulas import film_atlas
from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.film import (
    LineGroups,
    PointGroups,
    line_groups,
    moes_line,
    nijenbanning_venner_moes,
    point_groups,
    radii_at_angle,
)
from pyworm.formulas.film_atlas import reciprocal_alpha
from pyworm.formulas.hertz import HertzContact, HertzLine, hertz, hertz_line
from pyworm.formulas.regimes import Regime, line_regime
from pyworm.formulas.starvation import film_over_flooded
from pyworm.scene.contact import Contact
from pyworm.scene.formula_film import film_of, unentrained_regime
from pyworm.scene.line import LineScene
from pyworm.scene.point import Paraboloid, Scene

POINT_MEAN, LINE_MEAN = 2 / 3, pi / 4
"""Ratio of mean to largest pressure of Hertz's ellipse and strip."""

MOST_SLENDER = 1e6
"""Largest ratio of the relative radii."""

LEAST_TO_CENTRAL = 0.6
"""Typical ratio of least to central film, where no formula gives it."""

CUT_SHORT, PLACES, FILM_PRECISION = 4.0, 257, 0.01
"""Reach of the paraboloid's film over that of surfaces from which their ends count; number of places across
the entrainment where the gap is read; relative precision of the film."""

STARVED_EXPONENT, NEVER_BELOW = 3.0, 0.01
"""Exponent of the law of starved films for point contacts (`formulas.starvation`), and the least share of the
flooded film that is expected."""

LIGHTEST, HEAVIEST, MOST_PIEZOVISCOUS = 1e-30, 1e7, 1e12
"""Bounds of Moes' parameters beyond which an input can only be a mistake."""


@dataclass(frozen=True)
class Scales:
    """Scales of a point contact."""

    hertz: HertzContact
    """The elliptic contact of the radii at the contact point."""
    groups: PointGroups
    """Dimensionless groups along the entrainment."""
    angle: float
    """Direction of the entrainment, from x to y [rad]."""
    film: float
    """Central film of smooth surfaces by formula (`_flooded`), less where its oil is short [m]."""
    least: float
    """Least film over the central one by formula, with enough oil [-]."""
    inside_atlas: bool
    """Whether the contact is in the box of the atlas."""
    open_film: float
    """Film that rough surfaces keep open, oil and asperities together [m]; `film` of smooth ones."""
    supply_ratio: float
    """Thickness of the oil that arrives over the flooded film [-]; infinite where there is always enough."""
    regime: Regime
    """The regime of lubrication, of smooth surfaces with enough oil."""

    @property
    def slenderness(self) -> float:
        """Ratio of the lengths of Hertz's contact along and across the entrainment [-]."""
        along, across = (
            hypot(cos(angle) / self.hertz.semi_axis_x, sin(angle) / self.hertz.semi_axis_y)
            for angle in (self.angle, self.angle + pi / 2)
        )
        return across / along


def scales(scene: Scene) -> Scales:
    """Scales of a scene from its radii, load, oil and entrainment at the contact point.

    Where the contact point is at rest (pure spin), the mean speed of the entrainment over Hertz's ellipse is
    taken instead. ValueError if no oil is entrained anywhere, or radii, load, speed and oil are out of all
    proportion.
    """
    if not max(scene.radii) <= MOST_SLENDER * min(scene.radii):
        raise ValueError(
            f"{scene.name}: the relative radii are {scene.radii[0]:g} and {scene.radii[1]:g} m; a point "
            f"contact has both finite and within a factor of {MOST_SLENDER:g} (surfaces that touch along "
            "a line, as a worm and a wheel cut by a hob equal to it, make a line contact)"
        )
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    u, v = (float(component) for component in scene.entrainment(np.zeros(()), np.zeros(())))
    speed = hypot(u, v)
    typical = _typical_speed(scene, contact)
    if not typical > 0:
        raise ValueError(
            f"{scene.name}: the surfaces entrain no oil (mean velocity 0 m/s all over the contact); "
            "give them velocities whose mean is not zero"
        )
    angle = atan2(v, u) if speed > 0 else 0.0
    along, across = radii_at_angle(*scene.radii, angle)
    groups = point_groups(
        float(along),
        float(across),
        scene.load,
        scene.reduced_modulus,
        max(speed, typical / 10),
        scene.oil.viscosity.eta0,
        scene.oil.viscosity.alpha,
    )
    require_proportion(scene.name, groups)
    at_rest = speed < typical / 10
    flooded, least, inside, regime = _flooded(scene, groups, at_rest)
    if regime.deflection < 1 and not (at_rest or isinstance(scene.gap, Paraboloid)):
        load = _whole_load(scene, groups, angle, flooded)
        if load > scene.load:
            heavier = replace(groups, load=groups.load * load / scene.load)
            flooded, least, inside, regime = _flooded(replace(scene, load=load), heavier, at_rest)
    ratio = _supply_ratio(scene, flooded)
    film = flooded * max(film_over_flooded(ratio, STARVED_EXPONENT), NEVER_BELOW)
    mean_pressure = POINT_MEAN * contact.pressure_max
    open_film = _open_film(scene, film, mean_pressure)
    return Scales(contact, groups, angle, film, least, inside, open_film, ratio, regime)


def _flooded(scene: Scene, groups: PointGroups, at_rest: bool) -> tuple[float, float, bool, Regime]:
    """Central film with enough oil [m], the minimum over it [-], whether the atlas has it, and the regime.

    By the formula of the atlas, which outside its box too is nearer to solved films than Nijenbanning, Venner
    and Moes' (docs/reference/atlas.md). That is taken where the contact point is nearly at rest, which the
    atlas is not about, and of contacts more slender than its ellipses are fitted to.
    """
    if at_rest or max(scene.radii) > film_atlas.MOST_SLENDER * min(scene.radii):
        central = nijenbanning_venner_moes(groups).central_number
        regime = unentrained_regime(groups, LEAST_TO_CENTRAL * central, scene.oil)
        return central, LEAST_TO_CENTRAL, False, regime
    found = film_of(scene)
    least = float(found.minimum / found.central)
    return float(found.central), least, bool(found.inside), found.single_regime()


def _whole_load(scene: Scene, groups: PointGroups, angle: float, film: float) -> float:
    """Load [N] of the paraboloid of a scene's radii that has the film of its own surfaces.

    Across the entrainment a rigid film bears pressure in proportion to h0/h (Martin 1916) wherever there are
    surfaces. A light load is spread beyond the ends of a roller by the paraboloid alone: its film is many
    times too thick. That is mended where surfaces end to both sides within a `CUT_SHORT` of its lens; flanks
    on the edge of a tooth end to one side. `film` is that of the paraboloid under the load of the scene [m].
    """
    across = groups.radius / groups.ratio
    places = np.tan((np.arange(PLACES) + 0.5) * pi / PLACES - pi / 2)

    def surfaces(film: float) -> tuple[Array, Flags]:
        """Gap [m] at the places over the lens of a film [m], and where there are surfaces."""
        lens = sqrt(2 * across * film)
        return scene.gap(-sin(angle) * lens * places, cos(angle) * lens * places)

    def cut(film: float) -> float:
        """What the paraboloid bears over what the surfaces do, at the same film [m]."""
        gap, covered = surfaces(film)
        whole = film * (1 + places**2)
        borne = np.where(covered, whole / (film + np.maximum(gap, 0.0)), 0.0)
        return 1 / max(float(borne.mean()), 1 / PLACES)

    def excess(log_film: float) -> float:
        more = cut(exp(log_film))
        heavier = replace(groups, load=more * groups.load)
        found, *_ = _flooded(replace(scene, load=more * scene.load), heavier, at_rest=False)
        return log(found) - log_film

    if np.any(surfaces(film)[1] & (np.abs(places) > 1 / CUT_SHORT)):
        return scene.load
    high = low = log(film)
    while excess(low) < 0:
        low -= log(CUT_SHORT)
    if low == high:  # the formula's film hardly depends on a light load, and may rise with it
        return scene.load
    return scene.load * cut(exp(scipy.optimize.brentq(excess, low, high, xtol=FILM_PRECISION)))


def _supply_ratio(scene: Contact, flooded: float) -> float:
    """Thickness of the oil that arrives in the middle of the track over the flooded film [m]."""
    return inf if scene.oil.supply is None else float(scene.oil.layer_at(0.0)) / flooded


def _open_film(scene: Contact, film: float, pressure: float) -> float:
    """Film [m] of rough surfaces under a mean pressure [Pa] whose film would be `film` if smooth.

    The gap of the dry rough contact joins the film as a hypotenuse: right where one of both rules.
    """
    pair = scene.rough_pair
    if pair is None:
        return film
    curves = pair.curves()
    dry = np.interp(curves.gap_under(pressure), curves.gaps, curves.thicknesses)
    return hypot(film, float(dry))


def require_proportion(name: str, groups: PointGroups | LineGroups) -> None:
    """Refuse load, speed and oil whose Moes' parameters can only be a mistake (ValueError)."""
    if not (LIGHTEST < groups.moes_m < HEAVIEST and groups.moes_l < MOST_PIEZOVISCOUS):
        raise ValueError(
            f"{name}: load, speed and oil give Moes' M = {groups.moes_m:.3g} and "
            f"L = {groups.moes_l:.3g}, beyond all experience (M {LIGHTEST:g} to {HEAVIEST:g}, "
            f"L to {MOST_PIEZOVISCOUS:g}); check their units"
        )


def _typical_speed(scene: Scene, contact: HertzContact) -> float:
    """Mean speed of the entrainment over eight points halfway out in Hertz's ellipse [m/s]."""
    angles = [k * pi / 4 for k in range(8)]
    x = np.array([contact.semi_axis_x * cos(angle) / 2 for angle in angles])
    y = np.array([contact.semi_axis_y * sin(angle) / 2 for angle in angles])
    u, v = scene.entrainment(x, y)
    return float(np.mean(np.hypot(u, v)))


@dataclass(frozen=True)
class LineScales:
    """Scales of a line contact."""

    hertz: HertzLine
    """The dry contact of the radius at the contact point."""
    groups: LineGroups
    """Dimensionless groups."""
    film: float
    """Film of smooth surfaces where the pressure is largest by Moes, less where its oil is short [m]."""
    open_film: float
    """Film that rough surfaces keep open, oil and asperities together [m]; `film` of smooth ones."""
    supply_ratio: float
    """Thickness of the oil that arrives over the flooded film [-]; infinite where there is always enough."""
    regime: Regime
    """The regime of lubrication, of smooth surfaces with enough oil."""


def line_scales(scene: LineScene) -> LineScales:
    """Scales of a line contact; ValueError without entrainment, load, viscosity or any proportion."""
    viscosity = scene.oil.viscosity
    if not abs(scene.entrainment) > 0:
        raise ValueError(
            f"{scene.name}: the surfaces entrain no oil (mean velocity 0 m/s); "
            "give them velocities whose mean is not zero"
        )
    if not (scene.load > 0 and viscosity.eta0 > 0):
        raise ValueError(
            f"{scene.name}: a load of {scene.load:g} N/m on an oil of {viscosity.eta0:g} Pa s forms no film; "
            "both must be positive"
        )
    groups = line_groups(
        scene.radius,
        scene.load,
        scene.reduced_modulus,
        abs(scene.entrainment),
        viscosity.eta0,
        viscosity.alpha,
    )
    require_proportion(scene.name, groups)
    contact = hertz_line(scene.radius, scene.load, scene.reduced_modulus)
    flooded = moes_line(groups).central_number
    ratio = _supply_ratio(scene, flooded)
    film = flooded * max(film_over_flooded(ratio, inf), NEVER_BELOW)
    mean_pressure = LINE_MEAN * contact.pressure_max
    regime = line_regime(groups, reciprocal_alpha(viscosity, viscosity.alpha))
    return LineScales(contact, groups, film, _open_film(scene, film, mean_pressure), ratio, regime)
