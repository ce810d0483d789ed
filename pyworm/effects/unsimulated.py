"""Effects that the kernel does not simulate; their influence is told all the same, as far as it is known."""

from math import cos, exp, log, sin

from pyworm.effects.bodies import SPEED_POWER
from pyworm.effects.effect import Effect, Influence
from pyworm.effects.sketch import Sketch
from pyworm.effects.sketch import sketch as sketch_of
from pyworm.line.scene import LineScene
from pyworm.scales import scales

# ---------------------------------------------------------------------------------------- starvation

STARVATION_POWER = 2.0
"""Exponent g of the law, below the 3 to 5 that were measured: it tells more than there is."""


def _supply(sketch: Sketch) -> float:
    """Oil that arrives, over the film that would leave it."""
    return sketch.oil.supply / sketch.film_central


def _by_starvation(sketch: Sketch) -> Influence:
    share = _supply(sketch)
    change = 1 - share / (1 + share**STARVATION_POWER) ** (1 / STARVATION_POWER)
    return Influence(change, change, change)


STARVATION = Effect(
    name="starvation",
    symbol="h_oil / h",
    source="h/h_flooded = r/(1 + r^g)^(1/g), Chevalier, Lubrecht, Cann, Colin and Dalmaz (1998)",
    indicator=_supply,
    influence=_by_starvation,
    without=None,
    lacking=lambda scene: "flooded" if scene.oil.supply is None else None,
)


# ------------------------------------------------------------------------------------------- squeeze


def lag(sketch: Sketch) -> float:
    """Relative change of the film while oil passes through the contact."""
    growth = sketch.scene.neighbours.rate(lambda near: log(sketch_of(near).film_central))
    return abs(growth) * 2 * sketch.half_width / sketch.speed


def spread(sketch: Sketch) -> float:
    """What a contact that grows or shrinks gains or loses in area, over what oil sweeps: u + da/dt for u."""
    near = sketch.scene.neighbours
    if isinstance(sketch.scene, LineScene):
        return abs(near.rate(lambda of: sketch_of(of).half_width)) / sketch.speed
    size = scales(sketch.scene)
    a_x, a_y = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    spread_x = abs(near.rate(lambda of: scales(of).hertz.semi_axis_x))
    spread_y = abs(near.rate(lambda of: scales(of).hertz.semi_axis_y))
    swept = sketch.speed * (abs(cos(size.angle)) * a_y + abs(sin(size.angle)) * a_x)
    return (spread_x * a_y + spread_y * a_x) / swept


def _by_squeeze(sketch: Sketch) -> Influence:
    change = lag(sketch) + SPEED_POWER * spread(sketch)
    return Influence(change, change, change)


SQUEEZE = Effect(
    name="squeeze",
    symbol="2 b/u d(ln h)/dt + db/dt/u",
    source="a film is as old as the oil in it; the contact's edge runs to the oil or from it, h ~ u^0.7",
    indicator=lambda sketch: lag(sketch) + spread(sketch),
    influence=_by_squeeze,
    without=None,
    lacking=lambda scene: "steady" if scene.neighbours is None else None,
)


# ----------------------------------------------------------------------------------------- roughness


def _thickness(sketch: Sketch) -> float:
    """Specific film: minimum film over the composite roughness."""
    return sketch.film_min / sketch.scene.composite_roughness


def _by_roughness(sketch: Sketch) -> Influence:
    # Patir and Cheng (1978), isotropic: the pressure flow factor's 1 - 0.9 exp(-0.56 h/sigma)
    change = 0.9 * exp(-0.56 * _thickness(sketch))
    return Influence(change, change, change)


ROUGHNESS = Effect(
    name="roughness",
    symbol="h / sigma",
    source="Patir and Cheng (1978), pressure flow factor of isotropic surfaces",
    indicator=_thickness,
    influence=_by_roughness,
    without=None,
    lacking=lambda scene: "roughness not given" if scene.composite_roughness is None else None,
)
