"""Films of isothermal point contacts by a formula fitted to the atlas of converged films.

The limits of the film are closed forms: exact ones for rigid bodies, at any angle of entrainment, and power
laws for elastic ones (`limits`). They are joined smoothly, and a small network, which is constant outside the
atlas and fades where bodies are rigid, gives what remains. Constants, box and left-out errors are data
(`benchmarks/atlas/fit.py`); `docs/reference/atlas.md` tells how they were found.

Inside, lengths are over the smaller radius, and 2U along the entrainment is 1.
"""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from functools import cache, cached_property
from importlib.resources import files
from math import log, pi
from typing import TypedDict

import numpy as np

from pyworm.formulas.arrays import Array, Flags, Values
from pyworm.formulas.hertz import hertz
from pyworm.formulas.regimes import flattening, thickening

CONTACTS_PER_BLOCK = 4096
"""Contacts computed together: what fits into a processor's cache."""

LEAST_NORMAL, TURNS = 0.02, 3
"""Least speed into the ellipse over the whole speed, and iterations for the place where oil enters."""

MOST_SLENDER = 1e3
"""Largest ratio of radii up to which Hertz's ellipses are fitted."""


@dataclass(frozen=True)
class AtlasGroups:
    """Similarity groups of isothermal point contacts, numbers or arrays that broadcast together."""

    moes_m: Values
    """Moes' M by the radius along the entrainment (`radii_at_angle`)."""
    moes_l: Values
    """Moes' L by the radius along the entrainment, with alpha at zero pressure."""
    ratio: Values
    """Larger relative radius over the smaller one, 1 or more [-]."""
    angle: Values
    """Angle of entrainment from the smaller radius' direction, 0 (across the long axis) to pi/2 [rad]."""
    spin: Values = 0.0
    """Mean angular velocity, positive from the smaller towards the larger radius, times Hertz's longer
    semi-axis over the entrainment speed [-]."""
    alpha_ratio: Values = 1.0
    """Reciprocal asymptotic isoviscous pressure coefficient over alpha [-]; 1 of Barus' law."""
    compression: Values = 0.0
    """Relative increase of the oil's density at the Hertz pressure [-]."""

    @cached_property
    def cos2(self) -> Values:
        """Square of the part of the entrainment along the smaller radius [-]."""
        return np.cos(self.angle) ** 2

    @cached_property
    def slender(self) -> Values:
        """ln of the ratio of radii."""
        return np.log(self.ratio)

    @cached_property
    def along(self) -> Values:
        """ln of the radius along the entrainment over the smaller one."""
        return -np.log(self.cos2 + (1 - self.cos2) / self.ratio)

    @cached_property
    def load(self) -> Values:
        """ln of F/E' in units of the smaller radius, with 2U = 1 along the entrainment."""
        return np.log(self.moes_m) + 2 * self.along

    @cached_property
    def inlet(self) -> tuple[Values, Values]:
        """Where the oil of the contact point enters Hertz's ellipse.

        The part of the long side in it, 1 where it enters across the middle of the long side and 0 at the
        tip, and ln of the speed normal to the outline there over the whole speed. Under spin the oil goes on
        a circle, with the curvature of the spin over the longer semi-axis: on a slender contact entrained
        along, a spin of a tenth leads it from a side.
        """
        aspect, cos, sin = np.exp(np.polyval(_ellipses()[0], self.slender)), *self._path
        half = self._arc(aspect, 1.0)  # of the angle by which the course turns
        x, y = aspect * (cos + half * sin), sin - half * cos
        normal = (x * (cos + 2 * half * sin) * aspect + y * (sin - 2 * half * cos)) / np.sqrt(
            (aspect * x) ** 2 + y**2
        )
        return x**2 / (x**2 + y**2), np.log(np.maximum(normal, LEAST_NORMAL))

    @cached_property
    def outlet(self) -> Values:
        """The part of the long side where that oil leaves, as of `inlet`."""
        aspect, cos, sin = np.exp(np.polyval(_ellipses()[0], self.slender)), *self._path
        half = self._arc(aspect, -1.0)
        x, y = aspect * (cos - half * sin), sin + half * cos
        outlet: Values = x**2 / (x**2 + y**2)
        return outlet

    @cached_property
    def _path(self) -> tuple[Values, Values]:
        return np.cos(self.angle), np.sin(self.angle)

    def _arc(self, aspect: Values, sense: float) -> Values:
        """Half the angle by which the oil turns inside Hertz's ellipse, up- (1) or downstream (-1)."""
        cos, sin = self._path
        half: Values = 0.0
        for _ in range(TURNS):
            x = aspect * (cos + sense * half * sin)
            length = 1 / np.sqrt(x**2 + (sin - sense * half * cos) ** 2)
            half = (half + self.spin * length / 2) / 2 if _ else self.spin * length / 2
        return half

    @cached_property
    def approach(self) -> Values:
        """ln of the Hertz approach in Moes' unit."""
        of_unit_load = np.asarray(np.polyval(_ellipses()[3], self.slender), dtype=np.float64)
        approach: Values = of_unit_load + 2 * self.load / 3 - self.along
        return approach


@dataclass(frozen=True)
class AtlasFilms:
    """Films by the formula, each shaped as the groups together."""

    central: Array
    """Film at the contact point in Moes' unit, R (2U)^(1/2) [-]."""
    minimum: Array
    """Least film in Moes' unit, R (2U)^(1/2) [-]."""
    central_error: Array
    """Relative error of the central film within which 19 of 20 contacts lay that the fit had not seen [-]."""
    minimum_error: Array
    """Relative error of the least film within which 19 of 20 contacts lay that the fit had not seen [-]."""
    inside: Flags
    """Whether the contact is in the box of the atlas; outside it the errors are not known."""


class AtlasConstants(TypedDict):
    """The constants of the fit."""

    isoviscous: Mapping[str, float]
    """Factor of the limit of elastic bodies and an isoviscous oil, over the ratio of radii and the angle."""
    piezoviscous: Mapping[str, float]
    """Factor of the limit of elastic bodies and a piezoviscous oil, over the ratio of radii and the angle."""
    joined: Mapping[str, float]
    """Powers by which the limits are joined, and how far a compressible oil thins the film."""
    network: Mapping[str, Array]
    """Weights of the network and the box of its features."""
    errors: Mapping[str, Array]
    """ln of the error of each film, linear in the features."""
    box: Mapping[str, tuple[float, float]]
    """Least and largest value of each group in the atlas."""


@dataclass(frozen=True)
class Limits:
    """Logarithms of the central film of the four limits, in Moes' unit."""

    rigid_isoviscous: Array
    """ln H of rigid bodies and an isoviscous oil."""
    elastic_isoviscous: Array
    """ln H of elastic bodies and an isoviscous oil."""
    rigid_piezoviscous: Array
    """ln H of rigid bodies and a piezoviscous oil."""
    elastic_piezoviscous: Array
    """ln H of elastic bodies and a piezoviscous oil."""
    wedge: Array
    """Part of the wedge that is entrained along the smaller radius, 0 to 1 [-]."""


def limits(groups: AtlasGroups, constants: AtlasConstants) -> Limits:
    """The four limits of the central film.

    Rigid bodies: p = 4 eta (u x/(1 + 2D/3) + v y/(1 + 2/(3D)))/h^2 solves Reynolds' equation for a paraboloid
    of D = Rx/Ry and constant viscosity; with the scaled wedge S^2 = 2 Rx u^2/(1 + 2D/3)^2 +
    2 Ry v^2/(1 + 2/(3D))^2 it carries F = 4 pi eta S (Rx Ry/h)^(1/2) where it is positive, and its largest
    value is 1.29904 eta S h^(-3/2), which is 1/alpha in the piezoviscous limit. Reynolds' exit condition
    raises both by the factors of `_exit`.

    Elastic bodies: power laws of load, speed and pressure-viscosity coefficient as of a line contact, as
    G. Nijenbanning, C. H. Venner and H. Moes, Wear 176 (1994) 217-229, have them, with fitted functions of D.
    At an angle the film is that of the speed normal to Hertz's outline where the oil of the contact point
    enters, between the films of both axes by how far round that is (`AtlasGroups.inlet`): a circular contact
    has the same film at any angle.

    Args:
        groups: The contacts, arrays of one shape.
    """
    r, load, re, cos2 = groups.slender, groups.load, groups.along, groups.cos2
    side, normal = groups.inlet
    along, across = (
        re + normal,
        re - r + normal,
    )  # ln 2U of the speed into the contact along either axis
    alpha = np.log(groups.moes_l * groups.alpha_ratio)
    elastic = []
    for given, speed, bearing, oil in (
        (constants["isoviscous"], 0.6, 2 / 15, 0.0),
        (constants["piezoviscous"], 0.75, 1 / 12, 0.75),
    ):
        long = _shape(-r, bearing / 2, given) - bearing * load + speed * along
        tip = _shape(r, bearing / 2, given) - bearing * (load - 2 * r) + speed * across + r
        elastic.append(tip + _turned(side, given["turn"]) * (long - tip) + oil * alpha - re)
    delta = np.exp(-r)
    x = 2 * cos2 / (1 + 2 * delta / 3) ** 2
    y = 2 * (1 - cos2) / delta / (1 + 2 / (3 * delta)) ** 2
    wedge = x / (x + y)
    exit_ = _exit(wedge, delta)
    viscous = 0.5 * np.log(x + y) + re - log(2)  # ln eta S
    rigid = 2 * (log(4 * pi) + viscous + r / 2 + np.log(exit_) - load) - re
    thick = (log(1.29904) + alpha + viscous + np.log1p(PEAK * (exit_ - 1))) * 2 / 3 - re
    return Limits(rigid, elastic[0], thick, elastic[1], wedge)


PEAK = 0.765
"""What Reynolds' exit condition raises the largest pressure by, over what it raises the load by: 1.171 and
1.224 of a cylinder, exact; of other paraboloids `benchmarks/atlas/rigid.py` finds 0.7 to 0.85."""


def _exit(wedge: Values, delta: Values) -> Values:
    """Factor of the load of rigid bodies by Reynolds' exit condition; exact for a cylinder, 0.5 % else.

    1.2238 = 4.89497/4 (Martin) of a cylinder; the rest is fitted to `benchmarks/atlas/rigid.py`.
    """
    return 1 + 0.22374 * (wedge / (1 + 0.83 * delta) + (1 - wedge) / (1 + 0.83 / delta))


def _shape(log_ratio: Values, slope: float, given: Mapping[str, float]) -> Values:
    """ln of a limit's factor for D = radius along over radius across; D^-slope towards a line contact."""
    bend = np.log1p(given["bend"] * np.exp(given["rate"] * log_ratio))
    shape: Values = given["factor"] - slope * log_ratio - given["fall"] * bend
    return shape


def _turned(side: Values, power: float) -> Values:
    """A part between 0 and 1, steeper in the middle by a power."""
    upper, lower = side**power, (1 - side) ** power
    return upper / (upper + lower)


def joined(groups: AtlasGroups, found: Limits, constants: AtlasConstants) -> Values:
    """ln of the central film of the limits joined, without the network."""
    how = constants["joined"]
    thin, thick = _thin_and_thick(groups, found, how)
    film = np.logaddexp(how["power"] * thin, how["power"] * thick) / how["power"]
    joined: Values = film - how["compression"] * np.log1p(groups.compression)
    return joined


def _thin_and_thick(
    groups: AtlasGroups, found: Limits, how: Mapping[str, float]
) -> tuple[Values, Values]:
    """ln of the central film of an oil that does not thicken under pressure, and of one that does."""
    n = how["isoviscous"]
    rigid, elastic = found.rigid_piezoviscous, found.elastic_piezoviscous
    thin = np.logaddexp(n * found.rigid_isoviscous, n * found.elastic_isoviscous) / n
    stiff = _rising(how["rate"] * (thickness(groups, rigid) - how["middle"]))
    return thin, elastic + stiff * (rigid - elastic)


def _rising(value: Values) -> Values:
    """1/(1 + e^-x), 0 to 1."""
    return (1 + np.tanh(value / 2)) / 2


@cache
def _ellipses() -> tuple[Array, ...]:
    """Polynomials of ln of the ratio of radii, highest power first.

    They give ln of ellipticity, longer semi-axis, pressure and approach of contacts of unit load, modulus and
    smaller radius, within 1e-5 of `pyworm.formulas.hertz`.
    """
    places = log(MOST_SLENDER) * (1 - np.cos(np.linspace(0, pi, 60))) / 2
    contacts = [hertz(1.0, ratio, 1.0, 1.0) for ratio in np.exp(places)]
    rows = (
        [contact.ellipticity for contact in contacts],
        [contact.semi_axis_y for contact in contacts],
        [contact.pressure_max for contact in contacts],
        [contact.approach for contact in contacts],
    )
    return tuple(np.polyfit(places, np.log(row), 12) for row in rows)


def longer_semi_axis(ratio: Values) -> Values:
    """Hertz's longer semi-axis over (F R/E')^(1/3), R the smaller radius [-], from the ratio of radii."""
    semi_axis: Values = np.exp(np.polyval(_ellipses()[1], np.log(ratio)))
    return semi_axis


def hertz_pressure(ratio: Values) -> Values:
    """Hertz's pressure over (F E'^2/R^2)^(1/3), R the smaller radius [-], from the ratio of radii."""
    pressure: Values = np.exp(np.polyval(_ellipses()[2], np.log(ratio)))
    return pressure


def pressure(groups: AtlasGroups) -> Values:
    """alpha times the Hertz pressure, by alpha at zero pressure [-]."""
    return groups.moes_l * hertz_pressure(groups.ratio) * np.exp(groups.load / 3)


def thickness(groups: AtlasGroups, film: Values) -> Values:
    """ln of the film over the Hertz approach, from ln of the film in Moes' unit."""
    return film - groups.approach


THICKNESS, PRESSURE = 13, 14
"""Places of the film over the approach and of alpha p_H in what the network reads, as logarithms."""


def features(groups: AtlasGroups, found: Limits, film: Values) -> Array:
    """What the network reads, (contacts, features); of a circular contact nothing turns with the angle."""
    oval = 1 - np.exp(-groups.slender)
    side, normal = groups.inlet
    return np.stack(
        np.broadcast_arrays(
            np.log(groups.moes_m),
            np.log(groups.moes_l),
            groups.slender,
            oval * (2 * groups.cos2 - 1),
            oval * (2 * found.wedge - 1),
            oval * (2 * side - 1),
            oval * (2 * groups.outlet - 1),
            normal,
            found.elastic_isoviscous - found.elastic_piezoviscous,
            found.rigid_piezoviscous - found.elastic_piezoviscous,
            np.logaddexp(0.0, found.rigid_isoviscous - found.elastic_isoviscous),
            np.logaddexp(0.0, found.elastic_isoviscous - found.elastic_piezoviscous),
            np.logaddexp(0.0, thickness(groups, film)),
            thickness(groups, film),
            np.log(pressure(groups)),
            np.log1p(groups.compression),
            groups.alpha_ratio,
            oval * groups.spin * np.sin(2 * groups.angle),
            groups.spin**2,
        ),
        axis=-1,
    )


RIGID = 10.0
"""Film over the Hertz approach at which half of the network's part of the central film remains."""


def fade(groups: AtlasGroups, film: Values) -> Values:
    """Share of the network in the central film: 1 of elastic bodies, 0 of rigid ones."""
    return _rising(2 * (log(RIGID) - thickness(groups, film)))


def scaled(read: Array, constants: Mapping[str, Array]) -> Array:
    """What the network reads inside the box, about 0 and of the size of 1."""
    inside: Array = np.clip(read, constants["low"], constants["high"])
    inside -= constants["shift"]
    inside /= constants["scale"]
    return inside


def network(kept: Array, constants: Mapping[str, Array]) -> Array:
    """The network: one layer of hyperbolic tangents, and straight lines beside it, (contacts, 2).

    The first column is added to ln of the central film, the second tells how far the least film is below it.
    """
    hidden = (
        kept @ constants["inner"]
    )  # in place from here: new arrays of this size cost more than tangents
    hidden += constants["inner_bias"]
    np.tanh(hidden, out=hidden)
    network: Array = hidden @ constants["outer"] + kept @ constants["straight"] + constants["bias"]
    return network


def films(groups: AtlasGroups) -> AtlasFilms:
    """Films, with their errors, of isothermal, fully flooded point contacts of smooth surfaces."""
    given = np.broadcast_arrays(*(getattr(groups, field.name) for field in fields(groups)))
    shape = given[0].shape
    flat = [np.asarray(values, dtype=float).ravel() for values in given]
    count = flat[0].size
    out = np.empty((4, count))
    inside = np.empty(count, dtype=bool)
    constants = _constants()
    for first in range(0, count, CONTACTS_PER_BLOCK):
        part = slice(first, first + CONTACTS_PER_BLOCK)
        out[:, part], inside[part] = _films(
            AtlasGroups(*(values[part] for values in flat)), constants
        )
    central, minimum, *errors = (row.reshape(shape) for row in out)
    return AtlasFilms(central, minimum, errors[0], errors[1], inside.reshape(shape))


def _films(groups: AtlasGroups, constants: AtlasConstants) -> tuple[Array, Flags]:
    found = limits(groups, constants)
    film = joined(groups, found, constants)
    read = features(groups, found, film)
    kept = scaled(read, constants["network"])
    beside = network(kept, constants["network"])
    central = film + fade(groups, film) * beside[:, 0]
    minimum = central - np.logaddexp(0, beside[:, 1])
    errors = scatter(kept, constants["errors"])
    return np.vstack([np.exp(central), np.exp(minimum), errors.T]), _inside(
        groups, read, constants["box"]
    )


def scatter(kept: Array, constants: Mapping[str, Array]) -> Array:
    """Relative errors of central and least film that 19 of 20 left-out contacts kept, (contacts, 2)."""
    level = kept @ constants["slope"] + constants["level"]
    scatter: Array = np.exp(np.clip(level, log(LEAST_ERROR), 0))
    return scatter


LEAST_ERROR = 0.005
"""Errors below the atlas' own are not told."""


def _inside(groups: AtlasGroups, read: Array, box: Mapping[str, tuple[float, float]]) -> Flags:
    """Whether contacts are in the box of the atlas."""
    values = {
        "moes_m": groups.moes_m,
        "moes_l": groups.moes_l,
        "ratio": groups.ratio,
        "spin": np.abs(groups.spin),
        "alpha_ratio": groups.alpha_ratio,
        "compression": groups.compression,
        "pressure": np.exp(read[:, PRESSURE]),
        "thickness": np.exp(read[:, THICKNESS]),
    }
    within = [
        np.logical_and(low <= values[name], values[name] <= high)
        for name, (low, high) in box.items()
    ]
    inside: Flags = np.all(within, axis=0)
    return inside


def regime_measures(groups: AtlasGroups, minimum: Values) -> tuple[Values, Values]:
    """Deflection over film and thickening of the inlet's oil, by the minimum film in Moes' unit."""
    long = longer_semi_axis(groups.ratio) * np.exp(groups.load / 3)
    short = long / np.exp(np.polyval(_ellipses()[0], groups.slender))
    half_width = 1 / np.sqrt(groups.cos2 / short**2 + (1 - groups.cos2) / long**2)
    radius = np.exp(groups.along)
    deflection = flattening(half_width, radius, radius * minimum)
    return deflection, oil_thickening(groups, deflection)


def oil_thickening(groups: AtlasGroups, deflection: Values) -> Values:
    """Thickening of the oil in the inlet by the limits of the fit, `pyworm.formulas.regimes.thickening`."""
    constants = _constants()
    found = limits(groups, constants)
    thin, thick = _thin_and_thick(groups, found, constants["joined"])
    return thickening(np.exp(thick - thin), deflection)


def reciprocal_alpha(viscosity: Callable[[Array], Array], alpha: float) -> float:
    """Reciprocal asymptotic isoviscous pressure coefficient over alpha [-], 1/(alpha int_0^inf eta0/eta dp).

    Weibull, Blok and Bair take it for the pressure-viscosity coefficient of films (S. Bair, High Pressure
    Rheology for Quantitative Elastohydrodynamics (2007)); 1 of Barus' law, and where alpha at zero pressure
    [1/Pa] is 0.
    """
    if alpha == 0:
        return 1.0
    place, weight = _gauss()
    parts = np.array([0.0, 3.0, 12.0, 40.0, 120.0])  # alpha p
    half = np.diff(parts)[:, None] / 2
    steps = (parts[:-1, None] + half * (1 + place)).ravel() / alpha
    with np.errstate(over="ignore"):  # an infinite viscosity adds nothing
        fluidity = viscosity(np.zeros(1)) / viscosity(steps)
    return float(1 / (fluidity @ (half * weight).ravel()))


@cache
def _gauss() -> tuple[Array, Array]:
    """Places and weights of Gauss and Legendre's rule between -1 and 1."""
    return np.polynomial.legendre.leggauss(64)


@cache
def _constants() -> AtlasConstants:
    content = json.loads(files("pyworm.formulas").joinpath("film_atlas.json").read_text("utf-8"))
    arrays = {
        name: {key: np.asarray(values) for key, values in content[name].items()}
        for name in ("network", "errors")
    }
    return {
        "isoviscous": content["isoviscous"],
        "piezoviscous": content["piezoviscous"],
        "joined": content["joined"],
        "network": arrays["network"],
        "errors": arrays["errors"],
        "box": content["box"],
    }
