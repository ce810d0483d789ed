"""Random gear drives as they are built: worm sets, steel gear pairs and roller worms, each by its number.

Drawn are the sizes that a designer chooses; what follows from them (module, centre distance, torque) is
worked out here by the formulas of handbooks, not by pyworm. Every drive depends on nothing but seed and
number. Some draws make no drive (flanks that cut each other away): these are refused, and counted so.
"""

from collections.abc import Sequence
from math import atan, cos, pi, radians, sin, sqrt, tan
from typing import Any

import numpy as np
from draws import SEED, Drawn, Range

PROFILES = ("ZA", "ZN", "ZI", "ZK", "ZC", "ZC2")
CONCAVE = ("ZC", "ZC2")

BASES = ("mineral", "PAO", "PAG")
GRADES = (68, 100, 150, 220, 320, 460, 680, 1000)

WHEELS = {
    "CuSn12Ni2-C-GZ": "CuSn12Ni2",
    "CuSn12-C-GZ": "CuSn12",
    "CuAl10Fe5Ni5-C-GZ": "CuAl10Fe5Ni5",
}
"""Material of a wheel -> what ratings call it."""

CENTRE_DISTANCE = Range(0.025, 0.4)
RATIO = Range(5.0, 100.0)
THREADS = range(1, 7)
TEETH = range(24, 105)
"""Teeth of the wheel: fewer are cut away at their feet, more are not usual."""

WORM_SPEED = Range(5.0, 5000.0)
"""Speed of the worm [rpm]."""

FASTEST = 22.0
"""Largest speed of the worm's reference cylinder [m/s]: faster worms are built otherwise."""

LOAD_SHARE = Range(0.1, 1.0)
"""Torque over that of a catalogue."""

CATALOGUE_TORQUE = 0.6e6
"""Torque of the wheel over the cube of the centre distance [N/m2] at 1500 rpm: 600 N m at 100 mm, about what
catalogues of worm units have."""

OIL_TEMPERATURE = Range(20.0, 100.0)
"""Temperature of the oil [degC]."""

ACCURACY_CLASSES = range(6, 10)
"""Classes of DIN 3974 within which errors of assembly are drawn."""

LOCKING = 12.0
"""Lead angle [deg] below which no wheel is drawn as the driving member: friction may lock it."""

DRIVEN_BY_WHEEL = 0.25
"""Share of the others that the wheel drives."""

PHASES = [0.1, 0.3, 0.5, 0.7, 0.9]
"""Phases to be solved, near the ends of the mesh, too."""

KINDS = ("worm",) * 7 + ("spur", "helical", "roller")
"""Kind of a drive by the last digit of its number."""


def drive(number: int, seed: int = SEED) -> Drawn:
    """The drive of a number: seven of ten worm sets, a spur and a helical pair, a roller worm."""
    random = np.random.default_rng([seed, 5, number])
    kind = KINDS[number % len(KINDS)]
    built = {"worm": worm, "spur": spur, "helical": helical, "roller": roller}[kind](random)
    title = f"{kind.capitalize()} drive {number} of seed {seed}"
    head = {"title": title, "source": "drawn at random (tests/hard/gear_draws.py)"}
    return Drawn(head | built.tables, built.traits | {"kind": kind})


def worm(random: np.random.Generator) -> Drawn:
    """A worm set by the numbers of its drawing, with errors of its assembly."""
    distance, threads, teeth, factor, shift, profile = _worm_sizes(random)
    module = distance / (shift + (factor + teeth) / 2)
    lead_angle = atan(threads / factor)
    diameter = factor * module
    fastest = min(WORM_SPEED.high, 60 * FASTEST / (pi * diameter))
    rpm = Range(WORM_SPEED.low, fastest).draw(random)
    torque = LOAD_SHARE.draw(random) * _catalogue_torque(distance, rpm)
    locks = lead_angle < radians(LOCKING)
    driver = "worm" if locks or random.random() > DRIVEN_BY_WHEEL else "wheel"
    oil, temperature = _oil(random)
    material = _one(random, list(WHEELS))
    face = 0.7 * (factor + 2) * module
    tables = {
        "drive": {
            "kind": "worm",
            "profile": profile,
            "centre_distance": _with(distance * 1e3, "mm"),
            "threads": threads,
            "teeth": teeth,
            "module": f"{module * 1e3:.9g} mm",
            "diameter_factor": factor,
            "pressure_angle": "20 deg" if profile not in CONCAVE else "23 deg",
            "face_width": _with(face * 1e3, "mm"),
            "hand": _one(random, ("right", "left")),
            "assembly": _assembly(random, distance, face),
        },
        "operation": {
            "worm_speed": _with(rpm, "rpm"),
            "wheel_torque": _with(torque, "N m"),
            "driver": driver,
            "phases": PHASES,
        },
        "bodies": {
            "worm": {"material": "16MnCr5", "finish": "ground"},
            "wheel": {"material": material, "finish": _one(random, ("hobbed", "run-in"))},
        },
        "oil": {"name": oil, "temperature": temperature},
        "worm_rating": {"oil": oil, "wheel_material": WHEELS[material], "life": "25000 h"},
    }
    traits = {
        "profile": profile,
        "centre_distance": distance,
        "ratio": teeth / threads,
        "threads": threads,
        "rpm": rpm,
        "torque": torque,
        "lead_angle": lead_angle,
    }
    return Drawn(tables, traits)


def _worm_sizes(
    random: np.random.Generator,
) -> tuple[float, int, int, float, float, str]:
    """Centre distance [m], threads, teeth, diameter factor, profile shift and profile of a worm set.

    Worms of few threads are slender, so that they are stiff, those of many threads thick: from 6.5 to 20
    modules, as in the rows of DIN 3976. Concave flanks are cut with a positive shift.
    """
    profile = PROFILES[int(random.integers(len(PROFILES)))]
    distance = float(f"{CENTRE_DISTANCE.draw(random):.3g}")
    while True:
        threads = int(random.choice(THREADS))
        teeth = round(RATIO.draw(random) * threads)
        if teeth in TEETH and teeth / threads in RATIO:
            break
    factor = float(f"{random.uniform(8, 18 if threads == 1 else 13):.3g}")
    shift = random.uniform(0.2, 0.8) if profile in CONCAVE else random.uniform(-0.2, 0.5)
    return distance, threads, teeth, factor, shift, profile


def _catalogue_torque(distance: float, rpm: float) -> float:
    """Torque of a catalogue's unit [N m]: it falls with the fourth root of the speed, within limits."""
    return CATALOGUE_TORQUE * distance**3 * min(max((1500 / rpm) ** 0.25, 0.6), 1.8)


def _assembly(random: np.random.Generator, distance: float, face: float) -> dict[str, str]:
    """Errors of assembly of a class: of lengths by the tolerance unit of ISO 286, of the angle by ISO 1328.

    i = 0.45 D^(1/3) + 0.001 D [um, mm]; grades 6 to 9 have 10, 16, 25 and 40 of them. The helix tolerance of
    class 5, 0.1 sqrt(d) + 0.63 sqrt(b) + 4.2 [um, mm], grows by sqrt(2) a class; the axes may stray from each
    other by half of it over the face width.
    """
    accuracy = int(random.choice(ACCURACY_CLASSES))
    size = distance * 1e3
    unit = 0.45 * size ** (1 / 3) + 0.001 * size
    half = {6: 10, 7: 16, 8: 25, 9: 40}[accuracy] * unit / 2
    helix = (0.1 * sqrt(2 * size) + 0.63 * sqrt(face * 1e3) + 4.2) * sqrt(2) ** (accuracy - 5)
    angle = helix * 1e-6 / 2 / face
    return {
        "centre_distance": f"{random.uniform(-half, half):.4g} um",
        "axial_shift": f"{random.uniform(-half, half):.4g} um",
        "shaft_angle": f"{random.uniform(-angle, angle):.4g} rad",
    }


def spur(random: np.random.Generator) -> Drawn:
    """A spur pair of hard steel."""
    return _pair(random, 0.0)


def helical(random: np.random.Generator) -> Drawn:
    """A helical pair of hard steel."""
    return _pair(random, float(f"{random.uniform(8.0, 25.0):.3g}"))


MODULE = Range(1e-3, 12e-3)
PINION_TEETH = range(17, 41)
GEAR_RATIO = Range(1.0, 6.0)
PITCH_LINE_VELOCITY = Range(0.2, 35.0)
"""Speed of the pitch circles [m/s]."""

FLANK_PRESSURE = Range(0.3e9, 1.5e9)
"""Hertz pressure at the pitch point of a hard pair [Pa]."""

STEEL_MODULUS = 2.264e11
"""E' of steel on steel [Pa], 2 over the sum of (1 - nu^2)/E."""


def _pair(random: np.random.Generator, helix_angle: float) -> Drawn:
    """A pair whose load gives a drawn Hertz pressure at its pitch point."""
    module = float(f"{MODULE.draw(random):.2g}")
    teeth = int(random.choice(PINION_TEETH))
    others = max(round(GEAR_RATIO.draw(random) * teeth), teeth + 1)
    shifts = random.uniform(0.0, 0.4), random.uniform(0.0, 0.3)
    helix, normal = radians(helix_angle), radians(20)
    angle = atan(tan(normal) / cos(helix))
    working = _inverse_involute(
        tan(angle) - angle + 2 * tan(normal) * sum(shifts) / (teeth + others)
    )
    distance = module * (teeth + others) / (2 * cos(helix)) * cos(angle) / cos(working)
    pitch = distance * teeth / (teeth + others)
    speed = PITCH_LINE_VELOCITY.draw(random) / pitch
    width = random.uniform(8, 14) * module
    pressure = FLANK_PRESSURE.draw(random)
    radius = distance * sin(working) * teeth * others / (teeth + others) ** 2
    # p^2 = E' w/(2 pi R) of a line contact; the base helix spreads the load over a longer line
    load = 2 * pi * radius * pressure**2 / STEEL_MODULUS * width
    power = load * pitch * cos(working) * speed
    oil, temperature = _oil(random)
    body = {"material": "16MnCr5", "roughness_ra": f"{Range(0.2, 1.0).draw(random):.3g} um"}
    tables = {
        "drive": {
            "kind": "gear-pair",
            "centre_distance": f"{distance * 1e3:.9g} mm",
            "module": _with(module * 1e3, "mm"),
            "pressure_angle": "20 deg",
            "helix_angle": f"{helix_angle:.4g} deg",
            "face_width": _with(width * 1e3, "mm"),
            "load_sharing": _one(random, ("ramp", "elastic")),
            "pinion": {"teeth": teeth, "profile_shift": shifts[0]},
            "gear": {"teeth": others, "profile_shift": shifts[1]},
        },
        "operation": {
            "driver": _one(random, ("pinion", "gear")),
            "pinion_speed": _with(speed * 30 / pi, "rpm"),
            "power": _with(power * 1e-3, "kW"),
            "phases": PHASES,
        },
        "surfaces": {"friction_coefficient": 0.05},
        "bodies": {"pinion": dict(body), "gear": dict(body)},
        "oil": {"name": oil, "temperature": temperature},
        "gear_rating": {"scuffing_load_stage": 12, "micropitting_load_stage": 9},
    }
    traits = {
        "centre_distance": distance,
        "ratio": others / teeth,
        "rpm": speed * 30 / pi,
        "torque": power / speed,
        "hertz_pressure": pressure,
        "helix_angle": helix,
    }
    return Drawn(tables, traits)


def _inverse_involute(value: float) -> float:
    """The angle whose involute function tan - angle is a value, by Newton's steps from above."""
    angle = (3 * value) ** (1 / 3)
    for _ in range(20):
        angle -= (tan(angle) - angle - value) / tan(angle) ** 2
    return angle


ROLLER_DISTANCE = Range(0.08, 0.32)


def roller(random: np.random.Generator) -> Drawn:
    """A roller enveloping worm of the shape of cases/roller_crowned.toml, of another size and load."""
    distance = float(f"{ROLLER_DISTANCE.draw(random):.3g}")
    scale = distance / 0.16
    rpm = Range(50.0, 3000.0).draw(random)
    torque = Range(0.1, 1.0).draw(random) * 1100.0 * scale**3
    oil, temperature = _oil(random)
    steel = {"material": "16MnCr5"}
    tables = {
        "drive": {
            "kind": "roller-worm",
            "centre_distance": _with(distance * 1e3, "mm"),
            "worm": {
                "threads": 1,
                "hand": _one(random, ("right", "left")),
                "throat_coefficient": float(f"{random.uniform(0.37, 0.43):.3g}"),
                "throat_angle": "5 deg",
                "outer_angle": "60 deg",
                "addendum": f"{6 * scale:.5g} mm",
                "dedendum": f"{6 * scale:.5g} mm",
            },
            "rollers": {
                "count": int(random.integers(30, 41)),
                "radius": f"{6.5 * scale:.5g} mm",
                "length": f"{14 * scale:.5g} mm",
                "crown": {
                    "radius": f"{random.uniform(0.3, 1.0) * scale:.4g} m",
                    "straight": f"{8 * scale:.4g} mm",
                },
            },
        },
        "operation": {
            "wheel_torque": _with(torque, "N m"),
            "worm_speed": _with(rpm, "rpm"),
            "preload": _with(0.1 * torque, "N m"),
            "phases": [0.2, 0.5, 0.8],
        },
        "bodies": {
            "worm": steel | {"roughness": "0.4 um"},
            "rollers": steel | {"roughness": "0.2 um"},
        },
        "oil": {"name": oil, "temperature": temperature},
    }
    traits = {"centre_distance": distance, "rpm": rpm, "torque": torque}
    return Drawn(tables, traits)


def _oil(random: np.random.Generator) -> tuple[str, str]:
    """Name and temperature of an oil."""
    name = f"{_one(random, BASES)} VG {random.choice(GRADES)}"
    return name, f"{random.uniform(OIL_TEMPERATURE.low, OIL_TEMPERATURE.high):.3g} degC"


def _with(value: float, unit: str) -> str:
    """A quantity as a drawing has it, to four digits."""
    return f"{value:.4g} {unit}"


def _one(random: np.random.Generator, some: Sequence[Any]) -> Any:
    """One of some."""
    return some[int(random.integers(len(some)))]
