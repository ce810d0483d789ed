"""Effects that the kernel does not simulate; their influence is told all the same, as far as it is known."""

from math import cos, exp, inf, isfinite, log, sin

from pyworm.effects.bodies import SPEED_POWER, departure
from pyworm.effects.effect import Contact, Effect, Influence
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
    """Change of the expected film while oil passes through the contact [-]."""
    then = _before(sketch)
    real = abs(departure(sketch) - departure(then))
    shift = abs(log(sketch.film_central / then.film_central))
    return shift + real if isfinite(real) else inf


def spread(sketch: Sketch) -> float:
    """What a contact that grows or shrinks gains or loses in area, over what oil sweeps: u + da/dt for u."""
    then = _before(sketch)
    passed = sketch.speed * _seconds(sketch)
    if isinstance(sketch.scene, LineScene):
        return abs(sketch.half_width - then.half_width) / passed
    size, was = scales(sketch.scene), scales(then.scene)
    a_x, a_y = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    gained = abs(a_x - was.hertz.semi_axis_x) * a_y + abs(a_y - was.hertz.semi_axis_y) * a_x
    return gained / (passed * (abs(cos(size.angle)) * a_y + abs(sin(size.angle)) * a_x))


def _seconds(sketch: Sketch) -> float:
    """Time that oil takes to pass, or since the contact's mesh cycle began."""
    return min(sketch.transit, sketch.scene.past.seconds)


def _before(sketch: Sketch) -> Sketch:
    (then,) = sketch.scene.past.back([_seconds(sketch)])
    return sketch_of(then.contact)


def _by_squeeze(sketch: Sketch) -> Influence:
    change = lag(sketch) + SPEED_POWER * spread(sketch)
    return Influence(change, change, change)


def _lasting(scene: Contact) -> str | None:
    if scene.past is None:
        return "steady"
    seconds = _seconds(sketch_of(scene))
    return None if seconds > 0 and scene.past.back([seconds]) else "nothing before"


SQUEEZE = Effect(
    name="squeeze",
    symbol="d ln h + da/2b, in 2b/u",
    source="a film is as old as the oil in it; the contact's edge runs to the oil or from it, h ~ u^0.7",
    indicator=lambda sketch: lag(sketch) + spread(sketch),
    influence=_by_squeeze,
    without=None,
    lacking=_lasting,
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
