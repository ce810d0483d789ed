"""Sensitivities by the adjoint against differences of whole solves on the same grid, and their cost.

For eight contacts, isothermal and heated, smooth and rough, points and lines: largest deviation of
d ln J/d ln z from central differences over all inputs, where it is above JUDGED; what those differences are
not known to there; processor time of all sensitivities over that of `pyworm.solve` with all its grids; and
the share of the numerical uncertainties that hold against a grid of half the spacing. From the repository's
root:

    python benchmarks/accuracy/sensitivities.py [NAME ...]
"""

import sys
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeVar

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.materials.rough_surfaces import _curves
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.inputs import inputs_of, with_input
from pyworm.solver.adjoint import Adjoint, adjoint_of
from pyworm.solver.figure_weights import weights_of_figures
from pyworm.solver.newton import newton_step
from pyworm.solver.sensitivities import Inputs, Sensitivities, sensitivities

T = TypeVar("T")

CONTACTS = {
    "point": ("mourier_2006", None, ("isothermal",)),
    "oblique point": ("ellipse10_oblique", None, ("isothermal",)),
    "sheared point": ("traction_steel", None, ("isothermal", "shear-thinning")),
    "line": ("line_thermal", None, ("isothermal", "shear-thinning")),
    "rough line": ("spur_pair", 0.5, ("isothermal", "roughness")),
    "worm tooth": (
        "zi_sharif_2001",
        0.5,
        ("isothermal", "shear-thinning", "real-gap", "varying-velocity"),
    ),
    "heated line": ("line_thermal", None, ("all",)),
    "heated worm tooth": ("zi_sharif_2001", 0.5, ("all",)),
}
"""Case, phase and effects by name."""

ACCURACY = 0.01
"""Accuracy of the solves whose cost is compared."""

FEW = ("load", "oil.viscosity.eta0", "oil.flow.stress", "oil.heat.conductivity", "temperature")
"""Inputs by which whole solves of heated points are compared, each of which takes a minute."""

SLIDE_ROLL_RATIO = 0.2
"""Slide-roll ratio of the sheared point."""

JUDGED = 0.02
"""Least size of a sensitivity that is judged [-]."""

CHANGE, WARM_CHANGE = 2e-5, 2e-3
"""Relative change of the figure that changes most in the first and longest differences, without and with
heat."""

SCATTER, WARM_SCATTER = 1e-13, 4e-9
"""Relative scatter of the figures of films solved to the end, without heat and with it, whose bodies' rise
is known to single precision."""

SHORTENING, LENGTHS = 4.0, 4
"""Ratio of successive step lengths, and their number."""

REPEATED, MOST_REPEATS = 5.0, 3
"""Processor time [s] within which a cost is measured again, the least of so many times."""


@dataclass(frozen=True)
class Row:
    """What came of a contact."""

    name: str
    inputs: int
    worst: "Deviation"
    seconds: float
    ratio: float
    held: int
    judged: int

    def __str__(self) -> str:
        return (
            f"{self.name:18} {self.inputs:6d} {self.worst.size:9.1e} {self.worst.unknown:8.1e}  "
            f"{self.worst.what:48} {self.seconds:7.3f} {self.ratio:5.2f}  {self.held}/{self.judged}"
        )


@dataclass(frozen=True)
class Difference:
    """d ln J/d ln z by central differences of whole solves."""

    value: float
    """Extrapolated from those of two step lengths."""
    unknown: float
    """How far those two disagree and scatter, over the value."""


@dataclass(frozen=True)
class Deviation:
    """How far a sensitivity is from the differences of whole solves."""

    size: float
    """The deviation, relative."""
    unknown: float
    """What the differences themselves are not known to, relative."""
    what: str


def solved_figures(adjoint: Adjoint, scene: pyworm.Scene) -> dict[str, float]:
    """Output quantities of another contact, solved on the grid of an adjoint."""
    simplified = adjoint.plan.simplified(scene)
    level = adjoint.solver.of(simplified).isolated(adjoint.level.grid, adjoint.level.state())
    for _ in range(60):
        if level.film.balance.worst < 1e-13 or newton_step(level, 1e-6) is None:
            break
    origin = simplified.oil.thermal.inlet_temperature if level.film.heated else 0.0
    origin += simplified.coldest if level.film.heated else 0.0
    found = {
        name: value + (origin if name in HEAT_FIGURES else 0.0)
        for name, value in level.read().figures.items()
    }
    weights = weights_of_figures(level, ("film_min", "pressure_max"))
    found["film_min"] = float((weights["film_min"]["film"] * level.film.thickness()).sum())
    found["pressure_max"] = float((weights["pressure_max"]["pressure"] * level.film.pressure).sum())
    return found


def differences(
    adjoint: Adjoint, scene: pyworm.Scene, name: str, value: float
) -> dict[str, Difference]:
    """d ln J/d ln z by central differences of whole solves.

    The first step changes the figure that changes most by `CHANGE`; further ones are shorter by `SHORTENING`:
    a step that carries a node over the outline of the contact, or turns the convection at one, is too long,
    one whose change is not above the scatter too short. Each figure has the two successive lengths of the
    least disagreement and scatter, extrapolated. The adjoint has no part in the choice.
    """
    heated = adjoint.level.film.heated
    first, scatter = (WARM_CHANGE, WARM_SCATTER) if heated else (CHANGE, SCATTER)
    trial = central_difference(adjoint, scene, name, value, first / 10)
    steepest = max(1.0, *(abs(change) for change in trial.values()))
    steps = [first / steepest / SHORTENING**number for number in range(LENGTHS)]
    found = [central_difference(adjoint, scene, name, value, step) for step in steps]
    return {
        key: min(
            (
                extrapolated(long[key], short[key], scatter / step)
                for (long, short), step in zip(pairwise(found), steps[1:], strict=True)
            ),
            key=lambda each: each.unknown,
        )
        for key in adjoint.figures
    }


def central_difference(
    adjoint: Adjoint, scene: pyworm.Scene, name: str, value: float, step: float
) -> dict[str, float]:
    """d ln J/d ln z by whole solves with a relative step more and less of an input."""
    more, less = (
        solved_figures(adjoint, with_input(scene, name, value * (1 + side * step)))
        for side in (1, -1)
    )
    return {
        key: (more[key] - less[key]) / (2 * step * known) for key, known in adjoint.figures.items()
    }


def extrapolated(long: float, short: float, scatter: float) -> Difference:
    """The limit of differences of second order by those of two step lengths, with their scatter."""
    value = short + (short - long) / (SHORTENING**2 - 1)
    return Difference(value, (abs(short - long) + scatter) / max(abs(value), JUDGED))


def deviations(scene: pyworm.Scene, plan: pyworm.Plan) -> Iterator[Deviation]:
    """Deviation of each judged sensitivity from differences."""
    adjoint = adjoint_of(scene, plan, tolerance=1e-9, residual=1e-12)
    inputs = inputs_of(scene, heated=plan.model.heated, rough=plan.model.rough)
    if plan.model.heated and not isinstance(scene, pyworm.LineScene):
        inputs = {name: inputs[name] for name in FEW}
    table = Inputs(scene, plan, inputs).relative_changes(adjoint)
    for name, value in inputs.items():
        try:
            solved = differences(adjoint, scene, name, value)
        except KernelError as error:
            print(f"{scene.name}: no differences by {name}: {error}")
            continue
        for key, by_input in table.items():
            if abs(by_input[name]) > JUDGED:
                size = abs(by_input[name] / solved[key].value - 1)
                yield Deviation(size, solved[key].unknown, f"{key} by {name}")


def held(coarse: Sensitivities, scene: pyworm.Scene, plan: pyworm.Plan) -> tuple[int, int]:
    """How many uncertainties hold on a grid of half the spacing, and how many are judged."""
    finer = adjoint_of(scene, plan, grid=coarse.adjoint.level.grid.finer())
    truth = Inputs(scene, plan, coarse.inputs).relative_changes(finer)
    judged = [
        abs(one.value - truth[key][name]) <= one.error + 1e-3
        for key, by_input in coarse.table.items()
        for name, one in by_input.items()
        if abs(truth[key][name]) > JUDGED
    ]
    return sum(judged), len(judged)


def row(name: str) -> Row:
    """Compare a contact's sensitivities."""
    case, phase, effects = CONTACTS[name]
    loaded = pyworm.load(f"cases/{case}.toml")
    scene = loaded.scene() if phase is None else loaded.scene(phase=phase)
    if case == "traction_steel":
        scene = pyworm.with_slide_roll_ratio(scene, SLIDE_ROLL_RATIO)
    plan = pyworm.plan(scene, ACCURACY, effects)
    solving, solution = least_time(lambda: pyworm.solve(scene, plan))
    taken, found = least_time(lambda: sensitivities(scene, plan, solution))
    worst = max(
        deviations(scene, pyworm.plan(scene, 0.1, effects)), key=lambda deviation: deviation.size
    )
    ratio = taken / solving
    return Row(name, len(found.inputs), worst, solving, ratio, *held(found, scene, plan))


def least_time(work: Callable[[], T]) -> tuple[float, T]:
    """Least processor time of some work [s], and what it gives; averages of roughness are computed anew."""
    times: list[float] = []
    while len(times) < MOST_REPEATS and sum(times) < REPEATED:
        _curves.cache_clear()
        begun = time.process_time()
        given = work()
        times.append(time.process_time() - begun)
    return min(times), given


def main() -> None:
    """Compare the contacts named, or all."""
    unknown = [name for name in sys.argv[1:] if name not in CONTACTS]
    if unknown:
        sys.exit(f"{', '.join(unknown)}: no such contact; there are {', '.join(CONTACTS)}")
    print(
        f"{'contact':18} {'inputs':>6} {'deviation':>9} {'unknown':>8}  {'largest in':48} "
        f"{'solve/s':>7} {'cost':>5}  held"
    )
    for chosen in sys.argv[1:] or CONTACTS:
        print(row(chosen), flush=True)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    main()
