"""Squeeze: films of contacts that change while oil passes through them."""

from dataclasses import replace
from math import cos, inf, isfinite, log, sin

from pyworm.io.present import present
from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.effects.geometry import SPEED_POWER, departure
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.entrainment_continuation import with_auxiliary_entrainment
from pyworm.scene.line import LineScene
from pyworm.scene.scales import scales
from pyworm.scene.waves import waves_in_gap

MOST_BY_EDGES = 0.4
"""Largest influence of edges and reliefs that come or go while oil passes. Of a contact that they cut in two
the real gap's influence has no bound; its transient solutions differ by up to 34 % from steady ones
(`benchmarks/drives/squeeze.py`)."""


def _before(prediction: Prediction) -> Prediction:
    """The contact as its oil entered."""
    return present(prediction.before, "the contact before")


def lag(prediction: Prediction, most_by_edges: float = inf) -> float:
    """Change of the expected film while oil passes through the contact, the real gap's up to a bound [-].

    Closed forms now and then: a solved film differs from them by more than it changes.
    """
    now, then = predicted(prediction.scene), _before(prediction)
    real = abs(departure(now) - departure(then))
    shift = abs(log(now.film_central / max(then.film_central, then.scene.separation or 0.0)))
    return shift + min(real if isfinite(real) else inf, most_by_edges)


def spread(prediction: Prediction) -> float:
    """Area gained or lost by the contact over the area swept by the oil: u + da/dt in place of u."""
    then = _before(prediction)
    passed = prediction.speed * prediction.age
    if isinstance(prediction.scene, LineScene) or isinstance(then.scene, LineScene):
        return abs(prediction.half_width - then.half_width) / passed
    size, was = (
        scales(with_auxiliary_entrainment(prediction.scene)),
        scales(with_auxiliary_entrainment(then.scene)),
    )
    a_x, a_y = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    gained = abs(a_x - was.hertz.semi_axis_x) * a_y + abs(a_y - was.hertz.semi_axis_y) * a_x
    return gained / (passed * (abs(cos(size.angle)) * a_y + abs(sin(size.angle)) * a_x))


def _by_squeeze(prediction: Prediction) -> Influence:
    change = lag(prediction, MOST_BY_EDGES) + SPEED_POWER * spread(prediction)
    if prediction.scene.travelled is not None:
        change += waves_in_gap(prediction.scene) / prediction.film_central
    return Influence(change, change, change)


def _lasting(scene: AnyContact) -> str | None:
    if scene.past is None:
        return "steady"
    return "nothing before" if predicted(scene).before is None else None


def _steady(scene: AnyContact) -> AnyContact:
    """The contact without its past; an instant of a life, which has none of its own, as it is."""
    return scene if scene.past is None else replace(scene, past=None, travelled=None)


SQUEEZE = Effect(
    name="squeeze",
    symbol="d ln h + da/2b, in 2b/u",
    source="a film is as old as the oil in it; the contact's edge runs to the oil or from it, h ~ u^0.7",
    indicator=lambda prediction: lag(prediction) + spread(prediction),
    influence=_by_squeeze,
    without=_steady,
    lacking=_lasting,
    # far from the contact the gap changes as its surfaces carry it along, each as fast as it is there
    together=("real-gap", "varying-velocity"),
    passing=True,
)
