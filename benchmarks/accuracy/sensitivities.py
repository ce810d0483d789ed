"""Sensitivities by the adjoint against differences of whole solves on the same grid, and their cost.

For eight contacts, isothermal and heated, smooth and rough, points and lines: largest deviation of
d ln J/d ln z from central differences, of two steps and extrapolated, over all inputs, where it is above
JUDGED; processor time of all sensitivities over that of the solve; and the share of the numerical
uncertainties that hold against a grid of half the spacing. From the repository's root:

    python benchmarks/accuracy/sensitivities.py [NAME ...]
"""

import sys
import time
import warnings
from collections.abc import Iterator
from dataclasses import dataclass

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.inputs import inputs_of, with_input
from pyworm.solver.adjoint import Adjoint, adjoint_of
from pyworm.solver.figure_weights import weights_of_figures
from pyworm.solver.newton import newton_step
from pyworm.solver.sensitivities import Sensitivities, relative_changes, sensitivities

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

COLD_STEP, WARM_STEP, ALIKE_STEP = 1e-5, 1e-3, 1e-6
"""Relative steps of the differences, without and with heat, whose films are known to 1e-14 and 1e-8, and of
those of a heated film's equations at one state, whose convection turns with larger ones."""


@dataclass(frozen=True)
class Row:
    """What came of a contact."""

    name: str
    inputs: int
    deviation: float
    worst: str
    ratio: float
    held: int
    judged: int

    def __str__(self) -> str:
        return (
            f"{self.name:18} {self.inputs:6d} {self.deviation:9.1e}  {self.worst:48} "
            f"{self.ratio:5.2f}  {self.held}/{self.judged}"
        )


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


def differences(adjoint: Adjoint, scene: pyworm.Scene, name: str, value: float) -> dict[str, float]:
    """d ln J/d ln z by central differences of whole solves, extrapolated from two steps."""
    step = WARM_STEP if adjoint.level.film.heated else COLD_STEP
    found = []
    for width in (2 * step, step):
        more, less = (
            solved_figures(adjoint, with_input(scene, name, value * (1 + side * width)))
            for side in (1, -1)
        )
        found.append(
            {
                key: (more[key] - less[key]) / (2 * width * adjoint.figures[key])
                for key in adjoint.figures
            }
        )
    return {key: (4 * found[1][key] - found[0][key]) / 3 for key in adjoint.figures}


def deviations(scene: pyworm.Scene, plan: pyworm.Plan) -> Iterator[tuple[float, str]]:
    """Relative deviation of each judged sensitivity from differences, and what it is."""
    adjoint = adjoint_of(scene, plan, tolerance=1e-9, residual=1e-12)
    inputs = inputs_of(scene, heated=plan.model.heated, rough=plan.model.rough)
    if plan.model.heated and not isinstance(scene, pyworm.LineScene):
        inputs = {name: inputs[name] for name in FEW}
    for name, value in inputs.items():
        try:
            solved = differences(adjoint, scene, name, value)
        except KernelError:
            continue
        for key, change in by_both_sides(adjoint, scene, name, value).items():
            if abs(change) > JUDGED:
                yield abs(change / solved[key] - 1), f"{key} by {name}"


def by_both_sides(
    adjoint: Adjoint, scene: pyworm.Scene, name: str, value: float
) -> dict[str, float]:
    """d ln J/d ln z by the adjoint, with differences of its equations to both sides."""
    step = COLD_STEP if not adjoint.level.film.heated else ALIKE_STEP
    if not adjoint.spreads_alike(with_input(scene, name, value * (1 + step))):
        step = WARM_STEP
    more, less = (with_input(scene, name, value * (1 + side * step)) for side in (1, -1))
    return {
        key: change / (2 * step * adjoint.figures[key])
        for key, change in adjoint.change(more, less).items()
    }


def held(coarse: Sensitivities, scene: pyworm.Scene, plan: pyworm.Plan) -> tuple[int, int]:
    """How many uncertainties hold on a grid of half the spacing, and how many are judged."""
    finer = adjoint_of(scene, plan, grid=coarse.adjoint.level.grid.finer())
    truth = relative_changes(finer, scene, coarse.inputs)
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
    begun = time.process_time()
    solution = pyworm.solve(scene, plan)
    taken = time.process_time() - begun
    begun = time.process_time()
    found = sensitivities(scene, plan, solution)
    ratio = (time.process_time() - begun) / taken
    worst, which = max(deviations(scene, pyworm.plan(scene, 0.1, effects)))
    return Row(name, len(found.inputs), worst, which, ratio, *held(found, scene, plan))


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(f"{'contact':18} {'inputs':>6} {'deviation':>9}  {'largest in':48} {'cost':>5}  held")
    for chosen in sys.argv[1:] or CONTACTS:
        print(row(chosen), flush=True)
