"""Films of point contacts by the formula of the atlas (`formulas.film_atlas`), a microsecond each."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pyworm.formulas.arrays import Array, Flags, Values
from pyworm.formulas.film import PointGroups
from pyworm.formulas.film_atlas import (
    MOST_SLENDER,
    AtlasGroups,
    films,
    hertz_pressure,
    longer_semi_axis,
    oil_thickening,
    reciprocal_alpha,
    regime_measures,
)
from pyworm.formulas.film_reduction import reduction
from pyworm.formulas.hertz import hertz
from pyworm.formulas.ranges import positive
from pyworm.formulas.regimes import (
    REGIMES,
    THICKENING_ERROR,
    UNKNOWN_ERROR,
    Regime,
    flattening,
    regime_number,
)
from pyworm.io import units
from pyworm.io.given import Given, in_si
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import with_bars
from pyworm.io.shown import Shown
from pyworm.materials.oil import Oil, require_oil
from pyworm.scene.formula_heat import heat_groups, lacks_heat
from pyworm.scene.point import Scene, require_point

LEAST_L = 1e-3
"""Moes' L of oils whose viscosity does not rise with pressure: far below where that thickens a film."""

SPIN_STEP = 0.1
"""Distance over which the spin of a scene's velocities is read, over Hertz's smaller semi-axis."""


@dataclass(frozen=True, repr=False)
class FormulaFilms(Shown):
    """Isothermal films of smooth point contacts with enough oil, by the formula of the atlas."""

    central: Array
    """Film at the contact point [m]."""
    minimum: Array
    """Minimum film thickness [m]."""
    central_error: Array
    """Relative error of the central film thickness, 95 % outside the fit [-]; infinite off the atlas."""
    minimum_error: Array
    """Relative error of the minimum film thickness, likewise [-]."""
    inside: Flags
    """Whether the contact is in that box."""
    groups: AtlasGroups
    """Its similarity groups."""
    holds: tuple[str, ...] = ()
    """Effects of `pyworm.planning.effects` that the films hold besides (`film_of`)."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the films in words; of several contacts from the thinnest to the thickest."""
        count = np.size(self.central)
        outside = count - np.count_nonzero(self.inside)
        return f"FormulaFilms of {count} contact{'s' * (count > 1)}", {
            "central": _in_words("film_central", self.central, self.central_error),
            "minimum": _in_words("film_min", self.minimum, self.minimum_error),
            **({"outside the box of the atlas": f"{outside}"} if outside else {}),
        }

    @property
    def regime(self) -> NDArray[np.str_]:
        """Names of the regimes of lubrication, `pyworm.formulas.regimes`."""
        regime: NDArray[np.str_] = np.array(REGIMES)[
            regime_number(self.deflection, self.thickening)
        ]
        return regime

    @property
    def deflection(self) -> Values:
        """Deflection over minimum film thickness, above 1 if elastic (`pyworm.formulas.regimes`) [-]."""
        return self._measures[0]

    @property
    def thickening(self) -> Values:
        """alpha times the pressure where the film forms, above 1 of a piezoviscous oil (likewise) [-]."""
        return self._measures[1]

    @cached_property
    def _measures(self) -> tuple[Values, Values]:
        """Both by the films without heat."""
        return regime_measures(self.groups, films(self.groups).minimum)

    def single_regime(self) -> Regime:
        """The regime of lubrication of a single contact.

        Raises:
            ValueError: For several contacts, whose names `regime` has.
        """
        if np.size(self.central) != 1:
            raise ValueError(f"{np.size(self.central)} contacts have no single regime")
        return Regime(
            deflection=float(self.deflection),
            thickening=float(self.thickening),
            deflection_error=float(films(self.groups).minimum_error)
            if self.inside
            else UNKNOWN_ERROR,
            thickening_error=THICKENING_ERROR if self.inside else UNKNOWN_ERROR,
            **{name: float(getattr(self.groups, name)) for name in _REGIME_GROUPS},
        )

    def specific(self, roughness: Given) -> Array:
        """Central film thickness over the composite roughness [m]: lambda [-]."""
        roughness = in_si("roughness", roughness, units.Roughness)
        positive("composite roughness", roughness, "m")
        return self.central / roughness


def _in_words(name: str, films: Array, errors: Array) -> str:
    """Films [m] in words, one with its error bar, of several the least and the largest."""
    quantity = QUANTITIES[name]
    if np.size(films) == 1:
        return with_bars(quantity.text(np.ravel(films)[0]), np.ravel(errors)[0])
    return " to ".join(quantity.text(float(extreme(films))) for extreme in (np.min, np.max))


def film(
    radii: tuple[Given, Given],
    load: Given,
    reduced_modulus: Given,
    velocity: tuple[Given, Given],
    oil: Oil,
    spin: Given = 0.0,
) -> FormulaFilms:
    """Films of point contacts by the formula of the atlas; numbers or arrays that broadcast together.

    Isothermal, smooth, with enough oil, whatever the oil's flow law: heat, shear thinning, roughness and a
    short supply are neglected. A contact outside the box of the atlas has infinite errors.

    Args:
        radii: Relative radii of curvature along x and y [m].
        load: Normal load [N].
        reduced_modulus: E' [Pa] with 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
        velocity: Mean velocity of both surfaces along x and y at the contact point [m/s].
        oil: The oil at its inlet temperature.
        spin: Mean angular velocity of both surfaces about the common normal, positive from x to y [rad/s].

    Returns:
        Films with left-out errors.

    Raises:
        ValueError: Radii, loads or moduli that are not positive, or no entrainment.
    """
    groups, unit = _groups(radii, load, reduced_modulus, velocity, oil, spin)
    found = films(groups)
    central_error, minimum_error = (
        np.where(found.inside, error, np.inf)
        for error in (found.central_error, found.minimum_error)
    )
    return FormulaFilms(
        unit * found.central,
        unit * found.minimum,
        central_error,
        minimum_error,
        found.inside,
        groups,
    )


def _pair(name: str, given: tuple[Given, Given]) -> tuple[Given, Given]:
    """Two values, along x and y; ValueError for what are none."""
    if isinstance(given, str) or not hasattr(given, "__len__") or len(given) != 2:
        raise ValueError(f"{name} = {given!r:.40}: must be two values, along x and along y")
    return given


def _groups(
    radii: tuple[Given, Given],
    load: Given,
    reduced_modulus: Given,
    velocity: tuple[Given, Given],
    oil: Oil,
    spin: Given,
) -> tuple[AtlasGroups, Array]:
    """The groups of contacts, and Moes' unit of their films [m]; arguments as of `film`."""
    require_oil(oil)
    rx, ry, load, modulus, u, v, spin = (
        np.asarray(in_si(name, value_given, kind), dtype=float)
        for name, value_given, kind in (
            *(("radii", value_given, units.Radius) for value_given in _pair("radii", radii)),
            ("load", load, units.Force),
            ("reduced_modulus", reduced_modulus, units.Modulus),
            *(
                ("velocity", value_given, units.Velocity)
                for value_given in _pair("velocity", velocity)
            ),
            ("spin", spin, units.Spin),
        )
    )
    speed = np.hypot(u, v)
    for name, value, unit in (
        ("radius along x", rx, "m"),
        ("radius along y", ry, "m"),
        ("load", load, "N"),
        ("reduced modulus", modulus, "Pa"),
        ("entrainment speed", speed, "m/s"),
    ):
        positive(name, value, unit)
    swapped = rx > ry
    short, long = np.minimum(rx, ry), np.maximum(rx, ry)
    cos2 = np.minimum((np.where(swapped, v, u) / speed) ** 2, 1.0)
    along = 1 / (cos2 / short + (1 - cos2) / long)
    twice = 2 * oil.viscosity.eta0 * speed / (modulus * along)
    semi_axis = longer_semi_axis(long / short) * np.cbrt(load * short / modulus)
    peak = hertz_pressure(long / short) * np.cbrt(load * (modulus / short) ** 2)
    # mirrors turn a spin about: that which exchanges the axes, and one for each part of the velocity
    turned = np.where((u < 0) ^ (v < 0) ^ swapped, -1.0, 1.0)
    alpha = oil.viscosity.alpha
    groups = AtlasGroups(
        moes_m=load / (modulus * along**2) * twice**-0.75,
        moes_l=np.maximum(alpha * modulus * twice**0.25, LEAST_L),
        ratio=long / short,
        angle=np.arccos(np.sqrt(cos2)),
        spin=turned * spin * semi_axis / speed,
        alpha_ratio=reciprocal_alpha(oil.viscosity, alpha),
        compression=oil.density(peak) / oil.density(np.zeros(())) - 1,
    )
    return groups, along * np.sqrt(twice)


_REGIME_GROUPS = ("moes_m", "moes_l", "alpha_ratio", "compression", "ratio", "angle", "spin")
"""Groups that a regime keeps."""


def unentrained_regime(groups: PointGroups, minimum: float, oil: Oil) -> Regime:
    """The regime of a point nearly at rest or of extreme radii, by limits of entrainment along an axis."""
    ratio = min(max(groups.ratio, 1 / groups.ratio), MOST_SLENDER)
    contact = hertz(1.0, 1 / groups.ratio, groups.load, 1.0)
    alike = AtlasGroups(
        moes_m=groups.moes_m,
        moes_l=max(groups.moes_l, LEAST_L),
        ratio=ratio,
        angle=0.0 if groups.ratio <= 1 else np.pi / 2,
        alpha_ratio=reciprocal_alpha(oil.viscosity, oil.viscosity.alpha),
    )
    deflection = flattening(contact.semi_axis_x, 1.0, minimum / groups.radius)
    return Regime(
        deflection=float(deflection),
        thickening=float(oil_thickening(alike, deflection)),
        deflection_error=UNKNOWN_ERROR,
        thickening_error=UNKNOWN_ERROR,
        **{name: float(getattr(alike, name)) for name in _REGIME_GROUPS},
    )


HEAT_AND_FLOW = (
    "film-heating",
    "surface-heating",
    "viscosity-across",
    "shear-thinning",
    "limiting-stress",
)
"""Effects of the thermal contacts of the atlas."""


def film_of(scene: Scene, reduced: bool = False) -> FormulaFilms:
    """The films of a scene by `film`: its radii, load and velocities at the contact point, its oil.

    Args:
        scene: The contact.
        reduced: Whether by heat and shear thinning too, where oil and bodies have the data and the contact is
            in the box of the thermal contacts; `holds` shows whether they are.

    Raises:
        ValueError: No entrainment at the contact point, such as under pure spin.
    """
    require_point(scene)
    axes = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    step = SPIN_STEP * min(axes.semi_axis_x, axes.semi_axis_y)
    places = (
        step * np.array([0.0, 1.0, -1.0, 0.0, 0.0]),
        step * np.array([0.0, 0.0, 0.0, 1.0, -1.0]),
    )
    u, v = (np.broadcast_to(component, 5) for component in scene.entrainment(*places))
    spin = ((v[1] - v[2]) - (u[3] - u[4])) / (4 * step)
    cold = film(scene.radii, scene.load, scene.reduced_modulus, (u[0], v[0]), scene.oil, spin)
    return cold if not reduced or lacks_heat(scene) else _reduced(scene, cold)


def _reduced(scene: Scene, cold: FormulaFilms) -> FormulaFilms:
    """Films with heat and shear thinning; those without outside the box of the thermal contacts."""
    heat = heat_groups(scene, cold.central)
    by = reduction(cold.groups, films(cold.groups).central, heat)
    if not (by.inside and cold.inside):
        return cold
    return replace(
        cold,
        central=cold.central * by.central,
        minimum=cold.minimum * by.minimum,
        central_error=cold.central_error + by.central_error,
        minimum_error=cold.minimum_error + by.minimum_error,
        holds=HEAT_AND_FLOW,
    )
