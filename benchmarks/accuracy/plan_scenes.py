"""Contacts of all kinds, each calling for effects of its own: what plans are tried on."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import sin
from pathlib import Path

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

CELSIUS = 273.15
FILM = ("film",)
ALL = ("film", "friction", "temperature")
COLD = ("film", "friction")

STEEL = Body(210e9, 0.3, 7850.0, 47.0, 450.0, 60 + CELSIUS)
GLASS = Body(75e9, 0.22, 2500.0, 1.0, 800.0, 60 + CELSIUS)
COOL_GLASS = Body(75e9, 0.22, 2500.0, 1.0, 800.0, 20 + CELSIUS)
RUBBER = Body(5e6, 0.49, 1100.0, 0.2, 1600.0, 20 + CELSIUS)
BRONZE = Body(115e9, 0.34, 8800.0, 50.0, 380.0, 60 + CELSIUS)


def mineral(eta0: float, alpha: float, shear: FlowLaw | None = None, **more) -> Oil:
    """A mineral oil at 60 degC."""
    viscosity = Roelands.from_alpha(eta0, alpha)
    heat = OilHeat(
        inlet_temperature=60 + CELSIUS,
        viscosity_exponent=viscosity.s0(0.035, 60 + CELSIUS),
        conductivity=0.14,
        specific_heat=2000.0,
        expansivity=7e-4,
    )
    flow = shear or FlowLaw("eyring-limited", stress=5e6, limit=5e6, limit_pressure=0.05)
    return Oil(viscosity, Density.dowson_higginson(850.0), flow, heat, **more)


WATER = Oil(
    Barus(1.0e-3, 5e-10),
    Density.incompressible(998.0),
    FlowLaw("newtonian"),
    OilHeat(20 + CELSIUS, 0.024, 0.6, 4180.0),
)

GREASE = FlowLaw("carreau", stress=0.05e6, exponent=0.8)


def point(name, radii, load, velocities, bodies, oil, **more) -> Scene:
    """A paraboloid, both surfaces translating."""
    motions = tuple(RigidMotion(*velocity) for velocity in velocities)
    return Scene(
        name=name,
        gap=Paraboloid(*radii),
        radii=radii,
        motions=motions,
        load=load,
        bodies=bodies,
        oil=oil,
        **more,
    )


def line(name, radius, load, velocities, bodies, oil, **more) -> LineScene:
    """A cylinder on a plane."""
    return LineScene(
        name=name,
        gap=Parabola(radius),
        radius=radius,
        velocities=velocities,
        load=load,
        bodies=bodies,
        oil=oil,
        **more,
    )


def worm(phase: float) -> Callable[[], Scene]:
    """The worm of Sharif et al. (2001), at a place by itself as there."""
    case = Path("cases/zi_sharif_2001.toml")
    return lambda: replace(pyworm.load(case).scene(phase), past=None)


def polished_worm() -> Scene:
    """The worm's contact at mid-mesh between flanks so smooth that their roughness may be left out."""
    scene = worm(0.5)()
    return replace(scene, bodies=tuple(replace(body, roughness=0.1e-6) for body in scene.bodies))


def roller(phase: float) -> Callable[[], LineScene]:
    """A station of the roller drive's driving section, by itself."""
    case = Path("cases/roller_ref.toml")
    place = {"section": "left", "phase": phase, "station": 0.5}
    return lambda: replace(pyworm.load(case).scene(**place), past=None)


def aged(contact_at: Callable[[float], LineScene], transits: float) -> LineScene:
    """A line contact at the end of a life of some transits of its oil: contacts by transits passed."""
    now = contact_at(transits)
    transit = predicted(now).transit
    life = Life(transits * transit, lambda seconds: contact_at(seconds / transit))
    return replace(now, past=Past(life, transits * transit))


def spun_up(passed: float) -> LineScene:
    """A line whose speed rises by a thousandth in a transit."""
    speed = 2.0 + 0.002 * passed
    oil = mineral(0.03, 1.8e-8)
    return line("speed rising slowly", 0.012, 2e5, (speed, speed), (STEEL, STEEL), oil)


def swinging(passed: float) -> LineScene:
    """A line whose load swings by a third, once in six transits."""
    load = 2e5 * (1 + sin(passed) / 3)
    oil = mineral(0.03, 1.8e-8)
    return line("load swings", 0.012, load, (2.0, 2.0), (STEEL, STEEL), oil)


@dataclass(frozen=True)
class Trial:
    """A scene and what is asked of it."""

    scene: Callable[[], Scene | LineScene]
    quantities: tuple[str, ...]


ROLLING = ((0.1, 0.0), (0.1, 0.0))
ROUGH = replace(STEEL, roughness=0.4e-6)
POLISHED = replace(STEEL, roughness=0.012e-6)
LAPPED = replace(STEEL, roughness=0.02e-6)
HONED = replace(STEEL, roughness=0.03e-6)

TRIALS: dict[str, Trial] = {
    "rubber, feather load": Trial(
        lambda: point(
            "rubber, feather load",
            (0.01, 0.01),
            1e-3,
            ((0.002, 0.0),) * 2,
            (RUBBER, COOL_GLASS),
            replace(WATER, viscosity=Barus(1.0, 2e-8)),
        ),
        COLD,
    ),
    "rubber in water": Trial(
        lambda: point(
            "rubber in water",
            (0.01, 0.01),
            0.1,
            ((0.15, 0.0), (0.05, 0.0)),
            (RUBBER, COOL_GLASS),
            WATER,
        ),
        ALL,
    ),
    "steel, rolling slowly": Trial(
        lambda: point(
            "steel, rolling slowly",
            (0.01, 0.01),
            20.0,
            ROLLING,
            (STEEL, STEEL),
            mineral(0.04, 2e-8),
        ),
        ALL,
    ),
    "glass, sliding a little": Trial(
        lambda: point(
            "glass, sliding a little",
            (0.0095, 0.0095),
            15.0,
            ((0.0501, 0.0), (0.0499, 0.0)),
            (STEEL, GLASS),
            mineral(0.25, 2.2e-8),
        ),
        FILM,
    ),
    "steel, sliding fast": Trial(
        lambda: point(
            "steel, sliding fast",
            (0.01, 0.01),
            40.0,
            ((3.0, 0.0), (2.0, 0.0)),
            (STEEL, STEEL),
            mineral(0.04, 2e-8),
        ),
        ALL,
    ),
    "opposite sliding": Trial(
        lambda: pyworm.load(Path("cases/opposite_sliding.toml")).scene(), ALL
    ),
    "slender, along": Trial(
        lambda: point(
            "slender, along",
            (0.1, 0.01),
            30.0,
            ((0.3, 0.0),) * 2,
            (STEEL, STEEL),
            mineral(0.1, 2e-8),
        ),
        FILM,
    ),
    "slender, across": Trial(
        lambda: point(
            "slender, across",
            (0.01, 0.1),
            100.0,
            ((0.3, 0.0),) * 2,
            (STEEL, STEEL),
            mineral(0.1, 2e-8),
        ),
        FILM,
    ),
    "long roller": Trial(
        lambda: point(
            "long roller",
            (0.01, 3.0),
            1000.0,
            ((1.05, 0.0), (0.95, 0.0)),
            (STEEL, STEEL),
            mineral(0.03, 1.8e-8),
        ),
        FILM,
    ),
    "worm, phase 0.3": Trial(worm(0.3), ALL),
    "worm, phase 0.5": Trial(worm(0.5), ALL),
    "worm, phase 0.7": Trial(worm(0.7), ALL),
    "roller, at the throat": Trial(roller(0.125), FILM),
    "roller, half way": Trial(roller(0.5), FILM),
    "roller, at the outer end": Trial(roller(0.875), FILM),
    "gear, pitch point": Trial(
        lambda: line(
            "gear, pitch point", 0.012, 2e5, (2.0, 2.0), (STEEL, STEEL), mineral(0.03, 1.8e-8)
        ),
        FILM,
    ),
    "gear, tip": Trial(
        lambda: line("gear, tip", 0.009, 1.2e5, (3.2, 1.1), (STEEL, STEEL), mineral(0.03, 1.8e-8)),
        ALL,
    ),
    "speed rising slowly": Trial(lambda: aged(spun_up, 8.0), FILM),
    "load swings": Trial(lambda: aged(swinging, 8.0), FILM),
    "roller, as its worm turns": Trial(
        lambda: pyworm.load(Path("cases/roller_ref.toml")).scene(
            section="left", phase=0.5, station=0.5
        ),
        FILM,
    ),
    "starved bearing": Trial(
        lambda: point(
            "starved bearing",
            (0.005, 0.05),
            60.0,
            ((0.4, 0.0),) * 2,
            (STEEL, STEEL),
            mineral(0.05, 2e-8, supply=0.3e-6),
        ),
        FILM,
    ),
    "thick as grease": Trial(
        lambda: point(
            "thick as grease",
            (0.02, 0.02),
            20.0,
            ((0.02, 0.0), (0.018, 0.0)),
            (STEEL, STEEL),
            mineral(5.0, 2.5e-8, GREASE),
        ),
        FILM,
    ),
    "very rough": Trial(
        lambda: point(
            "very rough", (0.01, 0.02), 30.0, ((0.2, 0.0),) * 2, (ROUGH, ROUGH), mineral(0.04, 2e-8)
        ),
        FILM,
    ),
    "ball, polished": Trial(
        lambda: point(
            "ball, polished",
            (0.01, 0.01),
            20.0,
            ((0.6, 0.0),) * 2,
            (POLISHED, POLISHED),
            mineral(0.04, 2e-8),
        ),
        FILM,
    ),
    "ball, lapped": Trial(
        lambda: point(
            "ball, lapped",
            (0.01, 0.01),
            20.0,
            ((0.62, 0.0), (0.58, 0.0)),
            (LAPPED, LAPPED),
            mineral(0.04, 2e-8),
        ),
        COLD,
    ),
    "gear, honed": Trial(
        lambda: line("gear, honed", 0.012, 2e5, (2.0, 2.0), (HONED, HONED), mineral(0.03, 1.8e-8)),
        FILM,
    ),
    "gear, honed, sliding": Trial(
        lambda: line(
            "gear, honed, sliding", 0.012, 2e5, (1.05, 0.95), (HONED, HONED), mineral(0.03, 1.8e-8)
        ),
        COLD,
    ),
    "worm, polished": Trial(polished_worm, ALL),
}
"""Name -> scene and what is asked."""
