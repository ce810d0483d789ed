"""Random scenes: contacts drawn log-uniformly over all that the solver is to bear, each by its number.

What is drawn are the quantities whose extremes are hard: Hertz pressure, lubricant parameter, ellipticity,
pressure-viscosity, the bodies' stiffness, size. Load, speed and radii follow from them. A draw whose contact
lies outside the stated ranges is drawn again, so that the ranges are met exactly and every scene depends on
nothing but the seed, its kind and its number.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, exp, hypot, log, pi, sin
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.case.case import case_of
from pyworm.formulas.film import nijenbanning_venner_moes, point_groups, radii_at_angle
from pyworm.formulas.hertz import ellipticity, hertz
from pyworm.planning.prediction import predicted

SEED = 20260

POISSON_RATIO = 0.3

MOST_SPIN = 0.2
"""Largest spin drawn, as a velocity at the end of the contact's long axis over the entrainment."""

LEAST_SPINNING = 50.0
"""Moes' M below which no spin is drawn: around an ellipse that spins in a thick film the pressure far out
falls with the square of the distance only, so that its load has no end but that of the bodies. The solver
marks such films (`docs/evidence/hard-cases.md`); they are not hard, they are no property of the contact."""


@dataclass(frozen=True)
class Range:
    """What a quantity is drawn from, or must lie in."""

    low: float
    """Its lower end, in SI."""
    high: float
    """Its upper end, in SI."""

    def draw(self, random: np.random.Generator) -> float:
        """A value, log-uniformly."""
        return exp(random.uniform(log(self.low), log(self.high)))

    def __contains__(self, value: float) -> bool:
        return self.low <= value <= self.high


RANGES = {
    "hertz_pressure": Range(0.05e9, 4e9),
    "moes_l": Range(0.5, 25.0),
    "ellipticity": Range(1 / 30, 30.0),
    "alpha": Range(5e-9, 40e-9),
    "reduced_modulus": Range(5e9, 230e9),
    "radius": Range(1e-3, 1.0),
    "eta0": Range(2e-3, 2.0),
}
"""What is drawn of every scene: ellipticity is the Hertz contact's axis along y over that along x, the
radius that along the entrainment."""

SOFT, MOST_SOFT = 5.0, 1000.0
"""Moes' L below which M goes to 1000 only, as those of the named scenes do: in the corner beyond, of nearly
isoviscous films under heavy loads, minima at the sides are some percent of a film that is itself a thousandth
of the deformation, and one scene in nine needs more than the largest grid (`docs/evidence/hard-cases.md`)."""

LIMITS = {
    "moes_m": Range(2.0, 3000.0),
    "softness": Range(0.0, 1.0),
    "alpha_pressure": Range(0.0, 60.0),
    "film": Range(5e-9, 50e-6),
    "strain": Range(0.0, 0.02),
}
"""What a drawn scene must keep to: `strain` is the Hertz pressure over the reduced modulus, 0.02 in steel
at 4.5 GPa."""

HOT_RANGES = RANGES | {
    "hertz_pressure": Range(0.1e9, 3e9),
    "moes_l": Range(0.5, 20.0),
    "ellipticity": Range(1 / 10, 10.0),
    "radius": Range(3e-3, 0.3),
    "eta0": Range(5e-3, 0.5),
    "slide_roll_ratio": Range(0.01, 3.0),
    "eyring": Range(0.5e6, 20e6),
    "limit_share": Range(0.02, 0.12),
    "beta": Range(0.02, 0.06),
    "conductivity": Range(5.0, 80.0),
}
"""What is drawn of a thermal scene."""

HOT_LIMITS = LIMITS | {
    "speed": Range(0.02, 20.0),
    "film": Range(20e-9, 20e-6),
    "moes_m": Range(2.0, 1000.0),
}


ROUGH_RANGES = HOT_RANGES | {
    "lambda": Range(0.05, 5.0),
    "slope": Range(0.005, 0.05),
    "boundary_friction": Range(0.05, 0.15),
}
"""What is drawn of a rough scene: lambda by the film expected between smooth surfaces, composite slope."""

ROUGH_LIMITS = {"height": Range(10e-9, 10e-6), "rise": Range(0.0, 0.1)}
"""What it must keep to: the composite roughness, and that over the depth of the dry indentation, beyond
which the contact is no longer Hertz's."""


@dataclass(frozen=True)
class Drawn:
    """A drawn scene."""

    tables: dict[str, Any]
    """What its case file holds."""
    traits: dict[str, float]
    """The quantities by which scenes are told apart on the map."""


def isothermal(number: int, seed: int = SEED) -> Drawn:
    """A point contact of a Newtonian oil of one temperature, entrained at any angle, with or without spin."""
    random = np.random.default_rng([seed, 0, number])
    contact = _contact(random, RANGES, LIMITS)
    angle, spin = contact["angle"], contact["spin"]
    velocity = [contact["speed"] * cos(angle), contact["speed"] * sin(angle)]
    return Drawn(
        _tables(
            f"Isothermal scene {number} of seed {seed}", contact, [velocity, velocity], [spin] * 2
        ),
        _traits(contact),
    )


def thermal(number: int, seed: int = SEED) -> Drawn:
    """A sliding point contact with heat, Eyring's and a limiting stress."""
    return _hot(
        np.random.default_rng([seed, 1, number]),
        HOT_RANGES,
        f"Thermal scene {number} of seed {seed}",
    )


def rough(number: int, seed: int = SEED) -> Drawn:
    """A thermal scene between rough surfaces with lays of their own, as ground and hobbed ones have."""
    random = np.random.default_rng([seed, 2, number])
    title = f"Rough scene {number} of seed {seed}"
    while True:
        drawn = _hot(random, ROUGH_RANGES, title)
        traits = drawn.traits
        height = traits["film"] / traits["lambda"]
        if (
            height in ROUGH_LIMITS["height"]
            and height / traits["indentation"] in ROUGH_LIMITS["rise"]
        ):
            break
    share = random.uniform(0.1, 0.9)
    for body, part in zip(drawn.tables["bodies"].values(), (share, 1 - share), strict=True):
        body |= {
            "roughness": f"{height * part**0.5:.6g} m",
            "roughness_slope": traits["slope"] * part**0.5,
            "roughness_aspect": Range(1 / 6, 6.0).draw(random),
            "lay": f"{random.uniform(0, 180):.6g} deg",
        }
    drawn.tables["oil"]["boundary_friction"] = traits["boundary_friction"]
    return drawn


COLDEST, WARMEST = -10.0, 40.0
"""Bulk temperatures of bodies above that of the oil supplied [K]."""


def _warmed(drawn: Drawn, random: np.random.Generator) -> Drawn:
    """A thermal scene whose bodies have temperatures of their own."""
    inlet = 60.0
    for body in drawn.tables["bodies"].values():
        body["bulk_temperature"] = f"{inlet + random.uniform(COLDEST, WARMEST):.6g} degC"
    return drawn


def warm(number: int, seed: int = SEED) -> Drawn:
    """A thermal scene between bodies warmer or colder than the oil supplied."""
    random = np.random.default_rng([seed, 4, number])
    title = f"Scene {number} of seed {seed} between warm bodies"
    return _warmed(_hot(random, HOT_RANGES, title), random)


def thermal_line(number: int, seed: int = SEED) -> Drawn:
    """A line contact of the pressure, speeds and oil of a thermal scene."""
    random = np.random.default_rng([seed, 5, number])
    return _as_line(_hot(random, HOT_RANGES, f"Thermal line {number} of seed {seed}"))


def warm_line(number: int, seed: int = SEED) -> Drawn:
    """Such a line contact between bodies warmer or colder than the oil supplied."""
    random = np.random.default_rng([seed, 6, number])
    title = f"Line {number} of seed {seed} between warm bodies"
    return _warmed(_as_line(_hot(random, HOT_RANGES, title)), random)


def _as_line(drawn: Drawn) -> Drawn:
    """A line contact with the velocities, the largest pressure and the radius along x of a point contact."""
    scene = case_of(drawn.tables, drawn.tables["title"], Path()).scene()
    radius, modulus = scene.radii[0], scene.reduced_modulus
    load = 2 * pi * radius * drawn.traits["hertz_pressure"] ** 2 / modulus
    speeds = (hypot(*(float(part) for part in of(0.0, 0.0))) for of in scene.motions)
    line = {
        "contact": {
            "kind": "line-contact",
            "radius": f"{radius:.9g} m",
            "load": f"{load:.9g} N/m",
        },
        "motion": {
            f"velocity_{number}": f"{speed:.9g} m/s" for number, speed in enumerate(speeds, 1)
        },
    }
    return Drawn(drawn.tables | line, drawn.traits)


SUPPLY = Range(0.05, 10.0)
"""Oil supplied to a starved scene, over the flooded film that is expected."""


def starved(number: int, seed: int = SEED) -> Drawn:
    """An isothermal or, every second one, a thermal scene to which a thin layer of oil comes."""
    random = np.random.default_rng([seed, 3, number])
    if number % 2:
        drawn = _hot(random, HOT_RANGES, f"Starved scene {number} of seed {seed}")
    else:
        contact = _contact(random, RANGES, LIMITS)
        angle, spin = contact["angle"], contact["spin"]
        velocity = [contact["speed"] * cos(angle), contact["speed"] * sin(angle)]
        title = f"Starved scene {number} of seed {seed}"
        drawn = Drawn(_tables(title, contact, [velocity, velocity], [spin] * 2), _traits(contact))
    ratio = SUPPLY.draw(random)
    drawn.tables["oil"]["supply"] = f"{ratio * drawn.traits['film']:.9g} m"
    return Drawn(drawn.tables, drawn.traits | {"supply_ratio": ratio})


PASTS = {
    "blow": ("load", (0.0, 1.0, 1.5, 2.0, 2.7), (1.0, 1.0, 10.0, 1.0, 1.0)),
    "parting": ("load", (0.0, 1.5, 2.0, 2.5, 3.2), (1.0, 1.0, 0.0, 0.0, 1.0)),
    "start": ("speed", (0.0, 1.0, 3.0), (0.0, 0.0, 1.0)),
    "reversal": ("speed", (0.0, 2.0, 5.0), (-1.0, -1.0, 1.0)),
    "swing": ("speed", (0.0, 1.0, 2.0, 3.0, 4.0, 4.6), (1.0, -1.0, 1.0, -1.0, 0.2, 1.0)),
}
"""Name -> key of `[past]`, times in transits of the oil, and factors then."""


def past(number: int, seed: int = SEED) -> Drawn:
    """An isothermal scene after a blow, a parting of its surfaces, a start, a reversal or a swing."""
    drawn = isothermal(number, seed)
    name = list(PASTS)[number % len(PASTS)]
    key, times, factors = PASTS[name]
    scene = case_of(drawn.tables, name, Path()).scene()
    transit = predicted(scene).transit
    tables = drawn.tables | {
        "title": f"{name.capitalize()} {number} of seed {seed}",
        "past": {"times": [f"{of * transit:.9g} s" for of in times], key: list(factors)},
    }
    return Drawn(tables, drawn.traits)


def _hot(random: np.random.Generator, ranges: dict[str, Range], title: str) -> Drawn:
    """A sliding point contact with heat, Eyring's and a limiting stress."""
    contact = _contact(random, ranges, HOT_LIMITS)
    angle, ratio = contact["angle"], contact["slide_roll_ratio"]
    direction = cos(angle), sin(angle)
    velocities = [
        [contact["speed"] * (1 + side * ratio / 2) * part for part in direction] for side in (1, -1)
    ]
    tables = _tables(title, contact, velocities, [0.0, 0.0])
    for body in tables["bodies"].values():
        body |= {
            "density": "7850 kg/m^3",
            "conductivity": f"{contact['conductivity']:.6g} W/(m K)",
            "specific_heat": "450 J/(kg K)",
        }
    tables["oil"]["shear"] = {
        "law": "eyring-limited",
        "stress": f"{contact['eyring']:.6g} Pa",
        "limit": f"{contact['eyring']:.6g} Pa",
        "limit_pressure": contact["limit_share"],
    }
    tables["oil"]["heat"] = {
        "inlet_temperature": "60 degC",
        "beta": f"{contact['beta']:.6g} 1/K",
        "conductivity": "0.14 W/(m K)",
        "specific_heat": "2000 J/(kg K)",
        "expansivity": "7e-4 1/K",
    }
    of_roughness = {name: contact[name] for name in ranges if name not in HOT_RANGES}
    traits = {"slide_roll_ratio": ratio, "indentation": contact["indentation"]} | of_roughness
    return Drawn(tables, _traits(contact) | traits)


DRAWS: dict[str, Callable[[int], Drawn]] = {
    "isothermal": isothermal,
    "thermal": thermal,
    "rough": rough,
    "past": past,
    "starved": starved,
}
"""Kind of random scene -> what draws it by its number."""

JUDGED_DRAWS: dict[str, Callable[[int], Drawn]] = {
    "isothermal": isothermal,
    "thermal": thermal,
    "warm": warm,
    "thermal-line": thermal_line,
    "warm-line": warm_line,
    "rough": rough,
    "starved": starved,
}
"""Kinds whose error bars are judged (`benchmarks/accuracy/error_bars.py`)."""


def _contact(
    random: np.random.Generator, ranges: dict[str, Range], limits: dict[str, Range]
) -> dict[str, float]:
    """A contact within its limits, in SI."""
    while True:
        drawn = {name: of.draw(random) for name, of in ranges.items()}
        drawn["angle"] = random.uniform(0, 2 * pi)
        turning = random.uniform(-MOST_SPIN, MOST_SPIN)
        contact = drawn | _derived(drawn)
        spins = contact["moes_m"] >= LEAST_SPINNING
        contact["spin"] = spins * turning * contact["speed"] / contact["long_axis"]
        if all(contact[name] in of for name, of in limits.items()):
            return contact


def _derived(drawn: dict[str, float]) -> dict[str, float]:
    """Radii, load, speed and what limits are set for."""
    modulus, angle = drawn["reduced_modulus"], drawn["angle"]
    ratio = _radius_ratio(drawn["ellipticity"])
    along, _ = radii_at_angle(1.0, ratio, angle)
    radii = drawn["radius"] / along, ratio * drawn["radius"] / along
    # at a given shape the pressure goes with the cube root of the load
    load = (drawn["hertz_pressure"] / hertz(*radii, 1.0, modulus).pressure_max) ** 3
    contact = hertz(*radii, load, modulus)
    speed_number = (drawn["moes_l"] / (drawn["alpha"] * modulus)) ** 4 / 2
    speed = speed_number * modulus * drawn["radius"] / drawn["eta0"]
    groups = point_groups(
        *radii_at_angle(*radii, angle), load, modulus, speed, drawn["eta0"], drawn["alpha"]
    )
    return {
        "radius_x": radii[0],
        "radius_y": radii[1],
        "load": load,
        "speed": speed,
        "long_axis": max(contact.semi_axis_x, contact.semi_axis_y),
        "moes_m": groups.moes_m,
        "film": float(nijenbanning_venner_moes(groups).central),
        "alpha_pressure": drawn["alpha"] * drawn["hertz_pressure"],
        "strain": drawn["hertz_pressure"] / modulus,
        "indentation": max(contact.semi_axis_x**2 / radii[0], contact.semi_axis_y**2 / radii[1]),
        "softness": 0.0 if drawn["moes_l"] >= SOFT else groups.moes_m / MOST_SOFT,
    }


def _radius_ratio(axis_ratio: float) -> float:
    """Radius along y over radius along x of a Hertz contact with this axis along y over that along x."""
    ratio = axis_ratio**1.5
    for _ in range(
        40
    ):  # the exponent of the ratio varies so little that this settles within rounding
        ratio *= (axis_ratio / ellipticity(ratio)) ** 1.5
    return float(ratio)


def _tables(
    title: str, contact: dict[str, float], velocities: list[list[float]], spins: list[float]
) -> dict[str, Any]:
    """The case file of a contact."""
    body = {
        "youngs_modulus": f"{contact['reduced_modulus'] * (1 - POISSON_RATIO**2):.9g} Pa",
        "poisson_ratio": POISSON_RATIO,
    }
    return {
        "title": title,
        "source": "drawn at random (tests/hard/draws.py)",
        "contact": {
            "kind": "point-contact",
            "radii": [f"{contact['radius_x']:.9g} m", f"{contact['radius_y']:.9g} m"],
            "load": f"{contact['load']:.9g} N",
        },
        "motion": {
            f"{name}_{number}": value
            for number, (velocity, spin) in enumerate(zip(velocities, spins, strict=True), 1)
            for name, value in (
                ("velocity", [f"{component:.9g} m/s" for component in velocity]),
                ("spin", f"{spin:.9g} rad/s"),
            )
        },
        "bodies": {"body_1": dict(body), "body_2": dict(body)},
        "oil": {
            "name": "drawn at random",
            "viscosity": {
                "law": "roelands",
                "eta0": f"{contact['eta0']:.9g} Pa s",
                "alpha": f"{contact['alpha']:.9g} 1/Pa",
            },
            "density": {"law": "dowson-higginson", "rho0": "870 kg/m^3"},
        },
    }


_TRAITS = ("moes_m", "moes_l", "hertz_pressure", "ellipticity", "alpha_pressure", "film", "speed")


def _traits(contact: dict[str, float]) -> dict[str, float]:
    return {name: contact[name] for name in _TRAITS}
