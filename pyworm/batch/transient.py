"""A transient contact from Python: its load, motion and radii over time."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from math import copysign, isfinite
from typing import Any

import numpy as np

from pyworm.batch.provenance import provenance
from pyworm.formulas.ranges import scalar
from pyworm.io import units
from pyworm.io.given import Given, Names, WithUnit, in_si, row
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import effect_names
from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.plan import plan
from pyworm.result.result import Result
from pyworm.result.transient_result import TransientResult
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.history import History, Interpolated, OverTime
from pyworm.scene.life import Past
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion, Scene
from pyworm.scene.waves import velocities
from pyworm.solver.solve import solve

GivenOverTime = Given | Callable[[float], float]
"""What stands for a quantity over time: a number or text with a unit, one for each time, or a function."""

KNOTS_OF_FUNCTIONS = 33
"""Times at which functions of time count as known to the plan of the solve."""

MIN_SPEED_RATIO = 0.1
"""Entrainment over its maximum down to which a contact may be the present one: the results of one that hardly
moves need far finer grids."""

CREEP_RATIO = 1e-3
"""Entrainment of surfaces at rest over its maximum: they creep, since without it no film has an inlet."""


def transient(
    scene: AnyContact,
    times: Sequence[WithUnit] | np.ndarray,
    *,
    load: GivenOverTime | None = None,
    speed: GivenOverTime | None = None,
    sliding: GivenOverTime | None = None,
    radii: Sequence[GivenOverTime] | None = None,
    separation: GivenOverTime | None = None,
    accuracy: WithUnit = 0.05,
    effects: Names = "auto",
    quantities: Names | None = None,
    progress: Progress | None = None,
) -> TransientResult:
    """Solve a contact whose load, motion or radii change within the transit time of the lubricant.

    What varies is given by one value for each of the times, straight between them, or by a function of time
    in s that returns SI; a number holds all the time, and what is not given stays that of the scene. The
    film begins with the steady one, or where the surfaces are apart with the oil between them.

    Args:
        scene: The contact; its surfaces translate and spin (`RigidMotion`).
        times: Times [s]; the first is zero, and they rise.
        load: Normal load [N], of a line contact for each length [N/m]. Zero where the surfaces are apart.
        speed: Entrainment velocity [m/s] in the direction of the scene's, negative against it. Spins follow
            it, and the sliding does if that is not given. At rest it counts as a thousandth of its maximum.
        sliding: Velocity of body 1 relative to body 2 [m/s] in the direction of the scene's sliding, or of
            its entrainment if it does not slide.
        radii: Relative radii of curvature along x and y [m], of a line contact the one across it: those of a
            cam. The gap is then a `Paraboloid` or a `Parabola`.
        separation: Distance of the undeformed surfaces [m], which holds where the load is zero.
        accuracy, effects, quantities: As of `pyworm.plan`; squeeze is simulated in any case.
        progress: As of `pyworm.solve`.

    Returns:
        `dataset` has the results over time with their uncertainties; `animate` shows pressure and film.

    Raises:
        ValueError: Times that do not rise, values of another number than the times, a contact that never
            moves under load, or of which no transient film was found.
    """
    if not isinstance(scene, Scene | LineScene):
        raise ValueError(f"scene is a {type(scene).__name__}: must be a Scene or a LineScene")
    knots = _times(times)
    laws = {"load": load, "speed": speed, "sliding": sliding, "separation": separation}
    history = _history(scene, knots, laws, radii)
    present = _present(history, knots)
    past = Past(history.life, present, knots[-1])
    contact = replace(history(present), past=past)
    chosen = plan(contact, accuracy, _with_squeeze(effects), quantities)
    solution = solve(contact, chosen, progress)
    if solution.held("life") is None:
        reasons = [effect.reason for effect in solution.effects if effect.name == SQUEEZE.name]
        raise ValueError(f"{scene.name}: no transient film ({', '.join(reasons)})")
    kept = provenance({scene.name: asdict(chosen)})
    return TransientResult(Result(scene.name, {}, (solution,), None, kept))


def _with_squeeze(effects: Names) -> tuple[str, ...]:
    """A choice of effects with the transient film; ValueError of one without."""
    names = effect_names(effects)
    if f"-{SQUEEZE.name}" in names:
        raise ValueError(
            f"effects = {','.join(names)}: without {SQUEEZE.name} no film is transient"
        )
    return names if {"all", SQUEEZE.name} & {*names} else (*names, SQUEEZE.name)


def _times(times: Any) -> tuple[float, ...]:
    """Times in s; ValueError where they do not rise from zero."""
    found = tuple(map(float, in_si("times", row("times", times), units.TimeOrZero)))
    rises = all(before < after for before, after in pairwise(found))
    if len(found) < 2 or found[0] != 0 or not rises or not isfinite(found[-1]):
        raise ValueError("times: must be two or more that begin with 0 and rise")
    return found


def _history(
    scene: AnyContact, times: tuple[float, ...], laws: dict[str, Any], radii: Any
) -> History:
    """The states of the contact over time."""
    line = isinstance(scene, LineScene)
    kinds = {
        "load": units.ForcePerLength if line else units.Force,
        "speed": units.Velocity,
        "sliding": units.Velocity,
        "separation": units.Separation,
    }
    scales = {}
    if laws["speed"] is not None or laws["sliding"] is not None:
        scales["speed"] = 1 / _entrainment(scene)
    given: dict[str, Any] = {
        name: _over_time(name, law, times, kinds[name], scales.get(name, 1.0))
        for name, law in laws.items()
        if law is not None
    }
    if radii is not None:
        given["radii"] = _radii(scene, times, radii)
    if not given:
        raise ValueError("nothing varies; give load, speed, sliding or radii over time")
    knots = {*times, times[-1] / 2}
    if any(callable(law) for law in (*laws.values(), *(radii or ()))):
        knots |= set(np.linspace(0.0, times[-1], KNOTS_OF_FUNCTIONS).tolist())
    if "speed" in given:
        fastest = max(abs(given["speed"](seconds)) for seconds in knots)
        given["speed"] = _NeverAtRest(given["speed"], CREEP_RATIO * fastest)
    return History(contact=scene, times=tuple(sorted(knots)), **given)


@dataclass(frozen=True)
class _Function:
    """A quantity by a function of time, whose values are checked."""

    name: str
    function: Callable[[float], float]
    scale: float

    def __call__(self, seconds: float) -> float:
        value = scalar(f"{self.name}({seconds:.4g} s)", self.function(seconds))
        if not isfinite(value):
            raise ValueError(f"{self.name}({seconds:.4g} s) = {value:g}: must be finite")
        return value * self.scale


@dataclass(frozen=True)
class _NeverAtRest:
    """A velocity over time that is never zero, since oil then has no direction in which to enter."""

    velocity: OverTime
    least: float

    def __call__(self, seconds: float) -> float:
        value = self.velocity(seconds)
        return value if abs(value) >= self.least else copysign(self.least, value)


def _over_time(
    name: str, law: GivenOverTime, times: tuple[float, ...], kind: Any, scale: float = 1.0
) -> OverTime:
    """A quantity as a function of time; ValueError of values of another number than the times."""
    if callable(law):
        return _Function(name, law, scale)
    values = np.asarray(in_si(name, law, kind), dtype=float)
    if values.ndim == 0:
        values = np.full(len(times), values)
    if values.shape != (len(times),):
        raise ValueError(
            f"{name} has {values.size} values and times {len(times)}; give one for each"
        )
    if not np.isfinite(values).all():
        raise ValueError(f"{name}: must be finite")
    if name != "speed" and name != "sliding" and values.min() < 0:
        raise ValueError(f"{name} has a value of {values.min():g}: must not be negative")
    return Interpolated(times, tuple(values.tolist()), scale)


def _entrainment(scene: AnyContact) -> float:
    """Entrainment of a contact [m/s]; ValueError of one whose velocities cannot be scaled."""
    if not isinstance(scene, LineScene) and not all(
        isinstance(motion, RigidMotion) for motion in scene.motions
    ):
        raise ValueError(f"{scene.name}: its motions are no RigidMotion, whose velocity can vary")
    speed = float(np.linalg.norm(np.mean(velocities(scene), axis=0)))
    if speed == 0:
        raise ValueError(f"{scene.name}: without entrainment speed and sliding have no direction")
    return speed


def _radii(scene: AnyContact, times: tuple[float, ...], radii: Any) -> tuple[OverTime, ...]:
    """Radii over time along each direction of a contact."""
    if not isinstance(scene.gap, Paraboloid | Parabola):
        raise ValueError(
            f"{scene.name}: its gap is a {type(scene.gap).__name__}; radii vary those of a Paraboloid or "
            "a Parabola"
        )
    count = len(scene.radii_along)
    if isinstance(radii, str) or not isinstance(radii, Sequence) or len(radii) != count:
        raise ValueError(
            f"radii: must be {count} in a row, each a number, one for each time or a function"
        )
    return tuple(
        _over_time(f"radii[{place}]", law, times, units.Radius) for place, law in enumerate(radii)
    )


def _present(history: History, times: tuple[float, ...]) -> float:
    """The last of the times at which the contact moves under load [s]."""
    speeds = {seconds: _speed_under_load(history, seconds) for seconds in times[1:]}
    least = MIN_SPEED_RATIO * max(speeds.values())
    if least == 0:
        raise ValueError(f"{history.contact.name}: its surfaces never move under load")
    return max(seconds for seconds, speed in speeds.items() if speed >= least)


def _speed_under_load(history: History, seconds: float) -> float:
    """Entrainment at a time [m/s]; zero without load."""
    if history.load is not None and not history.load(seconds) > 0:
        return 0.0
    return float(np.linalg.norm(np.mean(velocities(history(seconds)), axis=0)))
