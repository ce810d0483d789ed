"""The named scenes: each is a corner that is known to be hard, with a word on why."""

from collections.abc import Callable
from copy import deepcopy
from math import pi
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.formulas.hertz import hertz

STEEL, BRONZE, POLYMER = (206e9, 0.3), (115e9, 0.34), (3e9, 0.38)
"""Young's modulus [Pa] and Poisson's ratio."""

THERMAL = {
    STEEL: {
        "density": "7850 kg/m^3",
        "conductivity": "47 W/(m K)",
        "specific_heat": "450 J/(kg K)",
    },
    BRONZE: {
        "density": "8800 kg/m^3",
        "conductivity": "50 W/(m K)",
        "specific_heat": "380 J/(kg K)",
    },
    POLYMER: {
        "density": "1300 kg/m^3",
        "conductivity": "0.25 W/(m K)",
        "specific_heat": "1500 J/(kg K)",
    },
}

RADIUS, ETA0, ALPHA = 0.01, 0.04, 22e-9
"""Of scenes that do not say otherwise: radius [m], viscosity [Pa s] and its pressure coefficient [1/Pa]."""


def reduced_modulus(*bodies: tuple[float, float]) -> float:
    """E' of two bodies [Pa]."""
    return 2 / sum((1 - ratio**2) / modulus for modulus, ratio in bodies)


def contact(
    title: str,
    load: float,
    velocity_1: tuple[float, float],
    velocity_2: tuple[float, float] | None = None,
    radii: tuple[float, float] = (RADIUS, RADIUS),
    spins: tuple[float, float] = (0.0, 0.0),
    bodies: tuple = (STEEL, STEEL),
    eta0: float = ETA0,
    alpha: float = ALPHA,
    hot: bool = False,
    **more: Any,
) -> dict[str, Any]:
    """The case file of a paraboloid; `hot` gives it Eyring's law, a limiting stress and heat."""
    velocity_2 = velocity_2 or velocity_1
    tables: dict[str, Any] = {
        "title": title,
        "source": "a named hard case (tests/hard/named.py)",
        "contact": {
            "kind": "point-contact",
            "radii": [f"{radius:.9g} m" for radius in radii],
            "load": f"{load:.9g} N",
        },
        "motion": {
            "velocity_1": [f"{of:.9g} m/s" for of in velocity_1],
            "velocity_2": [f"{of:.9g} m/s" for of in velocity_2],
            "spin_1": f"{spins[0]:.9g} rad/s",
            "spin_2": f"{spins[1]:.9g} rad/s",
        },
        "bodies": {
            f"body_{number}": {"youngs_modulus": f"{body[0]:.9g} Pa", "poisson_ratio": body[1]}
            for number, body in enumerate(bodies, 1)
        },
        "oil": {
            "name": "model oil",
            "viscosity": {
                "law": "roelands",
                "eta0": f"{eta0:.9g} Pa s",
                "alpha": f"{alpha:.9g} 1/Pa",
            },
            "density": {"law": "dowson-higginson", "rho0": "870 kg/m^3"},
        },
    }
    if hot:
        for number, body in enumerate(bodies, 1):
            tables["bodies"][f"body_{number}"] |= THERMAL[body]
        tables["oil"]["shear"] = {
            "law": "eyring-limited",
            "stress": "5 MPa",
            "limit": "5 MPa",
            "limit_pressure": 0.05,
        }
        tables["oil"]["heat"] = {
            "inlet_temperature": "60 degC",
            "beta": "0.035 1/K",
            "conductivity": "0.14 W/(m K)",
            "specific_heat": "2000 J/(kg K)",
            "expansivity": "7e-4 1/K",
        }
    return _with(tables, more)


def _with(tables: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """Tables with values replaced, keys dotted with two underscores."""
    changed = deepcopy(tables)
    for name, value in changes.items():
        *path, key = name.split("__")
        place = changed
        for part in path:
            place = place[part]
        place[key] = value
    return changed


def moes(m: float, lubricant: float) -> dict[str, Any]:
    """A circular contact by Moes' parameters."""
    modulus = reduced_modulus(STEEL, STEEL)
    speed_number = (lubricant / (ALPHA * modulus)) ** 4 / 2
    speed = speed_number * modulus * RADIUS / ETA0
    load = m * (2 * speed_number) ** 0.75 * modulus * RADIUS**2
    return contact(f"Circular contact, M {m:g}, L {lubricant:g}", load, (speed, 0.0))


def pressed(pressure: float, speed: float = 1.0, **more: Any) -> dict[str, Any]:
    """A contact by its Hertz pressure [Pa]."""
    radii, bodies = more.get("radii", (RADIUS, RADIUS)), more.get("bodies", (STEEL, STEEL))
    load = (pressure / hertz(*radii, 1.0, reduced_modulus(*bodies)).pressure_max) ** 3
    title = more.pop("title", f"Hertz pressure {pressure / 1e9:g} GPa")
    motion = more.pop("velocity_1", (speed, 0.0))
    return contact(title, load, motion, **more)


def sliding(ratio: float, pressure: float = 1e9, mean: float = 2.0, **more: Any) -> dict[str, Any]:
    """A warm contact at a slide-roll ratio."""
    return pressed(
        pressure,
        velocity_1=((1 + ratio / 2) * mean, 0.0),
        velocity_2=((1 - ratio / 2) * mean, 0.0),
        title=more.pop("title", f"Slide-roll ratio {ratio:g}"),
        hot=True,
        **more,
    )


SAMPLES, HALF_SIDE = 241, 1.2e-3


def _sampled(
    title: str,
    gap: Callable[[np.ndarray, np.ndarray], np.ndarray],
    load: float,
    name: str,
    **more: Any,
) -> Callable[[Path], dict[str, Any]]:
    """What makes the case of a sampled gap, its arrays written into a directory."""

    def make(directory: Path) -> dict[str, Any]:
        axis = np.linspace(-HALF_SIDE, HALF_SIDE, SAMPLES)
        x, y = np.meshgrid(axis, axis)
        step = axis[1] - axis[0]
        np.savez(directory / name, gap=gap(x, y), dx=step, dy=step)
        about = {"kind": "gap", "file": name, "load": f"{load:g} N"}
        return contact(title, load, (1.0, 0.0), contact=about, **more)

    return make


def _ball(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return (x**2 + y**2) / (2 * RADIUS)


EDGE = 1.2e-4
"""Where a body ends beside the contact point [m], within the contact."""

GAPS = {
    "edge": _sampled(
        "A contact that runs off a tooth",
        lambda x, y: np.where(y < EDGE, _ball(x, y), np.nan),
        30.0,
        "edge.npz",
    ),
    "two-lobes": _sampled(
        "Two lobes along the entrainment's line of symmetry",
        lambda x, y: _ball(x, y) + 4e-7 * (np.cos(2 * pi * y / 4e-4) - 1),
        20.0,
        "two_lobes.npz",
    ),
    "ripple": _sampled(
        "A ripple of 50 nm on a ball",
        lambda x, y: _ball(x, y) - 25e-9 * np.cos(2 * pi * x / 1e-4),
        20.0,
        "ripple.npz",
    ),
    # around surfaces without ends the load of a film of pure spin has none either
    "pure-spin": _sampled(
        "Pure spin of an elliptic contact whose bodies end",
        lambda x, y: np.where(
            np.hypot(x, y) < HALF_SIDE / 1.5, x**2 / (4 * RADIUS) + y**2 / (2 * RADIUS), np.nan
        ),
        1.0,
        "pure_spin.npz",
        motion={
            "velocity_1": ["0 m/s", "0 m/s"],
            "velocity_2": ["0 m/s", "0 m/s"],
            "spin_1": "2000 rad/s",
            "spin_2": "2000 rad/s",
        },
    ),
    "step": _sampled(
        "A step of 200 nm across the entrainment",
        lambda x, y: _ball(x, y) + 1e-7 * (1 + np.tanh((x - 5e-5) / 1e-5)),
        20.0,
        "step.npz",
    ),
}
"""Name -> what writes the gap's file into a directory and makes its case."""

ISOTHERMAL: dict[str, dict[str, Any]] = {
    **{
        f"M{m:g}-L{lubricant:g}": moes(m, lubricant)
        for m, lubricant in ((1000, 10), (3000, 5), (200, 20), (100, 25), (2, 0.5))
    },
    "coarse-grid-lost": contact(
        "A film so thin that the first grids are lost",
        63.2455532034,
        (0.372759372031, 0.0),
        bodies=((205.66e9, 0.3),) * 2,
    ),
    **{
        f"{pressure / 1e9:g}-GPa": pressed(pressure, speed, alpha=min(ALPHA, 60 / pressure))
        for pressure, speed in ((0.05e9, 1e-3), (0.2e9, 0.05), (1e9, 1.0), (2e9, 1.0), (4e9, 1.0))
    },
    "alpha-p-60": pressed(2e9, alpha=30e-9, title="alpha times pressure of 60"),
    "film-5-nm": pressed(0.4e9, 0.005, eta0=0.02, title="A film of some 5 nm"),
    "film-50-um": contact("A film of some 50 um", 2e4, (8.0, 0.0), radii=(0.5, 0.5), eta0=2.0),
    **{
        f"ellipse-{name}-{way}": pressed(
            0.5e9,
            radii=radii,
            velocity_1=velocity,
            title=f"Ellipticity {name}, entrained {way}",
        )
        for name, radii in (("30", (RADIUS, 1.9)), ("1-over-30", (1.9, RADIUS)))
        for way, velocity in (("x", (1.0, 0.0)), ("y", (0.0, 1.0)), ("oblique", (0.7, 0.7)))
    },
    "bronze-steel": pressed(0.5e9, bodies=(BRONZE, STEEL), title="Bronze on steel"),
    "polymer-steel": pressed(0.05e9, bodies=(POLYMER, STEEL), title="Polymer on steel"),
    "near-zero-speed": pressed(0.5e9, 1e-5, eta0=1.0, title="Hardly any speed"),
    "near-zero-load": contact("Hardly any load", 1e-3, (0.01, 0.0)),
}
"""Name -> case file."""

HOT: dict[str, dict[str, Any]] = {
    **{f"slide-roll-{ratio:g}": sliding(ratio) for ratio in (0, 2)},
    "slide-roll-20": sliding(20.0, 0.5e9, 0.1),
    "slide-roll-20-fast": sliding(20.0, title="40 m/s of sliding at 1 GPa"),
    "opposite-sliding": sliding(
        0.0,
        0.5e9,
        title="Opposite sliding",
        motion__velocity_1=["3 m/s", "0 m/s"],
        motion__velocity_2=["-3 m/s", "0 m/s"],
    ),
    "eyring-far-below": sliding(
        0.5, oil__shear__stress="0.1 MPa", title="Eyring stress far below the contact's stresses"
    ),
    "eyring-far-above": sliding(
        0.01,
        0.6e9,
        oil__shear__stress="500 MPa",
        oil__shear__limit="500 MPa",
        title="Eyring stress far above the contact's stresses",
    ),
    "limit-all-over": sliding(
        1.0,
        oil__shear={
            "law": "eyring-limited",
            "stress": "5 MPa",
            "limit": "5 MPa",
            "limit_pressure": 0.02,
        },
        title="Limiting stress reached over most of the contact",
    ),
    "cold-inlet": sliding(
        0.1,
        0.5e9,
        0.05,
        eta0=50.0,
        oil__heat__inlet_temperature="-30 degC",
        oil__heat__beta="0.12 1/K",
        title="An inlet at which the oil nearly solidifies",
    ),
    "bulk-100-K-apart": sliding(
        0.2,
        bodies__body_1__bulk_temperature="110 degC",
        bodies__body_2__bulk_temperature="10 degC",
        title="Bulk temperatures 100 K apart",
    ),
    "bronze-steel-hot": sliding(
        0.5, 0.4e9, bodies=(BRONZE, STEEL), title="Bronze on steel, sliding"
    ),
    "polymer-steel-hot": sliding(
        0.5, 0.05e9, bodies=(POLYMER, STEEL), title="Polymer on steel, sliding"
    ),
    "spin-hot": sliding(0.5, motion__spin_1="3000 rad/s", title="Sliding and spin of one body"),
    "oblique-hot": sliding(
        0.5,
        radii=(RADIUS, 0.1),
        motion__velocity_1=["1.5 m/s", "1.2 m/s"],
        title="Sliding across an oblique entrainment",
    ),
}
"""The same with heat and a flow law."""

REFUSED = {
    "zero-speed": (contact("No speed", 20.0, (0.0, 0.0)), "entrain no oil"),
    "zero-load": (contact("No load", 0.0, (1.0, 0.0)), "greater than zero"),
}
"""What is no contact, and what the refusal says."""
