"""What plans leave out, what that changes, and what it saves: every scene of `plan_scenes`.

For each scene the automatic plan against everything on: processor time of both solves at the accuracy asked
for, and how far the asked quantities differ on one grid. Then, one after another, each effect left out is
switched off from everything on: its true influence against the estimate. Run from the repository's root:

    python benchmarks/accuracy/plans.py [ACCURACY ...] [--out DIR]   the whole table; by default 1 % and 5 %
    python benchmarks/accuracy/plans.py 5% "worm, phase 0.5"          only the scenes named

Leaves plan.csv, leave_one_out.csv and leave_one_out.png in DIR (results/plan).
"""

import argparse
import csv
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np
from matplotlib.figure import Figure
from plan_scenes import TRIALS, Trial

import pyworm
from pyworm.io.quantity import SHARE_KIND, parse
from pyworm.kernel.core import KernelError
from pyworm.planning.effects.catalogue import EFFECTS
from pyworm.planning.effects.judgement import Judgement
from pyworm.planning.plan import Plan
from pyworm.planning.prediction import predicted
from pyworm.planning.target import HEAT_FIGURES
from pyworm.solver.grid_sequence import SOLVERS
from pyworm.solver.newton import converge
from pyworm.solver.solution import Solution

FINER = 1
"""Halvings of a plan's first grid on which the figures of two plans are compared."""

PART_OF = {effect.name: effect.part_of for effect in EFFECTS}

TIGHT = 0.005
"""Accuracy to which both are solved where they have no grid in common, a point and a line contact."""


@dataclass(frozen=True)
class Numbers:
    """What is asked of a contact, in numbers."""

    film: tuple[float, float]
    friction: float | None
    rises: tuple[float, ...]


def on_one_grid(scene, plan: Plan) -> Numbers:
    """The figures of a plan on a grid that does not depend on how well they are known."""
    simple = plan.simplified(scene)
    solver = SOLVERS[type(simple)](simple, plan)
    level, _ = solver.begin(plan.grids)
    for _ in range(FINER):
        converge(level, plan.tolerance, plan.target, 0.1 * plan.accuracy)
        level, _ = solver.refined(level)
    converge(level, plan.tolerance / 10, plan.target, 0.01 * plan.accuracy)
    figures = level.read().figures
    return Numbers(
        (figures["film_min"], figures["film_central"]),
        figures.get("friction_coefficient"),
        tuple(figures[name] for name in HEAT_FIGURES if name in figures),
    )


class Figures:
    """What plans of one scene say, each found once."""

    def __init__(self, scene):
        self.scene = scene
        self._known: dict[tuple, Numbers] = {}

    def pair(self, first: Plan, second: Plan) -> tuple[Numbers, Numbers]:
        """Two plans compared so that the errors of their grids do not show."""
        kinds = {type(plan.simplified(self.scene)) for plan in (first, second)}
        # heated films have first grids of their own, transient films more than a grid
        still = "squeeze" not in first.on | second.on
        same = len(kinds) == 1 and first.grids == second.grids and still
        by = on_one_grid if same else solved
        return self._of(by, first), self._of(by, second)

    def _of(self, by, plan: Plan) -> Numbers:
        key = by, plan.on
        if key not in self._known:
            self._known[key] = by(self.scene, plan)
        return self._known[key]


def solved(scene, plan: Plan) -> Numbers:
    """The figures of a plan's effects, whatever grid that takes."""
    names = [judgement.name for judgement in plan.effects if judgement.on]
    figures = pyworm.solve(scene, pyworm.plan(scene, TIGHT, names, plan.quantities)).figures
    friction = figures.friction_coefficient
    heat = [getattr(figures, name) for name in HEAT_FIGURES]
    inlet = scene.oil.heat.inlet_temperature if scene.oil.heat else 0.0
    return Numbers(
        (figures.film_min.value, figures.film_central.value),
        None if friction is None else friction.value,
        tuple(one.value - inlet for one in heat if one is not None),
    )


def difference(scene, whole: Numbers, part: Numbers, quantities) -> dict[str, float]:
    """How far a part is from the whole, in the measure of influences."""
    found = {"film": max(abs(a / b - 1) for a, b in zip(part.film, whole.film, strict=True))}
    slides = predicted(scene).sliding > 0  # without it friction has no size
    if "friction" in quantities and slides and part.friction is not None:
        found["friction"] = abs(part.friction / whole.friction - 1)
    if "temperature" in quantities and whole.rises:
        rises = part.rises or (0.0, 0.0, 0.0)
        size = max(max(whole.rises), 1 / predicted(scene).inlet_beta)
        found["temperature"] = (
            max(abs(a - b) for a, b in zip(rises, whole.rises, strict=True)) / size
        )
    return found


def timed(scene, plan: Plan) -> tuple[Solution, float]:
    """A solution and the processor time it took [s]."""
    start = process_time()
    solution = pyworm.solve(scene, plan)
    return solution, process_time() - start


def trial(name: str, of: Trial, accuracy: float) -> tuple[dict, list[dict]]:
    """A row of the table, and those of the effects that were left out."""
    scene = of.scene()
    plan = pyworm.plan(scene, accuracy, quantities=of.quantities)
    whole = pyworm.plan(scene, accuracy, "all", of.quantities)
    # each solves a scene of its own, so that neither finds its teeth sampled by the other
    found, seconds = timed(of.scene(), plan)
    everything, seconds_all = timed(of.scene(), whole)
    plan = replace(plan, effects=found.effects)
    figures = Figures(scene)
    numbers, part = figures.pair(whole, plan)
    apart = difference(scene, numbers, part, of.quantities)
    left = [judgement for judgement in found.effects if not judgement.on and judgement.influence]
    simulated = {judgement.name for judgement in whole.effects if judgement.on}
    row = {
        "scene": name,
        "accuracy": accuracy,
        "seconds": seconds,
        "seconds_all": seconds_all,
        "converged": found.accurate,
        "converged_all": everything.converged,
        "worst": max(apart.values()),
        **{f"by_{quantity}": value for quantity, value in apart.items()},
        "off": " ".join(judgement.name for judgement in left if judgement.name in simulated),
        "not_simulated": " ".join(
            f"{judgement.name} ({max(judgement.influence.values()):.0%})"
            for judgement in left
            if judgement.name not in simulated
        ),
    }
    return row, [
        one
        for judgement in left
        # what is part of another effect that is off too went with that one
        if judgement.name in simulated and PART_OF[judgement.name] not in simulated - plan.on
        for one in leave_one_out(figures, judgement, whole, of.quantities)
    ]


def leave_one_out(figures: Figures, judgement: Judgement, whole: Plan, quantities) -> list[dict]:
    """True and estimated influence of one effect on each quantity."""
    scene = figures.scene
    try:
        less = pyworm.plan(scene, whole.accuracy, ("all", f"-{judgement.name}"), quantities)
        numbers, part = figures.pair(whole, less)
    except (ValueError, KernelError) as error:
        print(f"    {judgement.name}: cannot be neglected, {error}", flush=True)
        return []
    true = difference(scene, numbers, part, quantities)
    return [
        {
            "scene": scene.name,
            "accuracy": whole.accuracy,
            "effect": judgement.name,
            "quantity": quantity,
            "estimate": judgement.influence[quantity],
            "true": value,
        }
        for quantity, value in true.items()
    ]


def told(row: dict) -> str:
    """A line for people."""
    marks = "" if row["converged"] and row["converged_all"] else " NOT CONVERGED"
    return (
        f"{row['scene']:24} {row['accuracy']:5.1%} {row['seconds']:8.2f} {row['seconds_all']:8.2f} "
        f"{row['seconds'] / row['seconds_all']:6.2f} {row['worst']:8.2%}  {row['off']}{marks}"
    )


def draw(ones: list[dict], path: Path) -> None:
    """True influences against the estimates, all of effects that were left out."""
    figure = Figure(figsize=(7, 6), layout="constrained")
    axes = figure.subplots()
    floor = 1e-6
    for number, effect in enumerate(sorted({one["effect"] for one in ones})):
        points = [one for one in ones if one["effect"] == effect]
        axes.loglog(
            [max(one["estimate"], floor) for one in points],
            [max(one["true"], floor) for one in points],
            "os^vD<>Pp*X"[number % 11],
            label=effect,
            alpha=0.7,
        )
    span = np.array([floor, 1.0])
    axes.loglog(span, span, color="0.5", linewidth=1)
    axes.text(2e-6, 3e-6, "true = estimated", rotation=45, color="0.4", fontsize=9)
    for accuracy in sorted({one["accuracy"] for one in ones}):
        axes.axhline(accuracy, color="tab:red", linestyle="--", linewidth=1)
        axes.text(1.1e-6, accuracy * 1.1, f"accuracy: {accuracy:.0%}", color="tab:red", fontsize=9)
    axes.set(
        xlabel="estimated influence of the neglected effect",
        ylabel="true influence (1e-6 or less at the bottom)",
        xlim=(floor / 1.5, 1.0),
        ylim=(floor / 1.5, 1.0),
        title="Effects neglected by plans",
    )
    axes.legend(frameon=False, fontsize=9)
    axes.grid(True, color="0.92")
    figure.savefig(path, dpi=150)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("words", nargs="*", help="accuracies and names of scenes")
    parser.add_argument("--out", type=Path, default=Path("results/plan"))
    options = parser.parse_args()
    accuracies = [parse(word, SHARE_KIND) for word in options.words if word.endswith("%")]
    names = [word for word in options.words if not word.endswith("%")] or list(TRIALS)
    rows, ones = [], []
    first = TRIALS["gear, tip"].scene()
    pyworm.solve(first, pyworm.plan(first))  # loads modules, which no scene is charged for
    print(f"{'scene':24} {'asked':>5} {'s':>8} {'all, s':>8} {'ratio':>6} {'differ':>8}  left out")
    for accuracy in accuracies or [0.01, 0.05]:
        for name in names:
            row, ones_here = trial(name, TRIALS[name], accuracy)
            rows.append(row)
            ones += ones_here
            print(told(row), flush=True)
            for one in ones_here:
                high = " ABOVE THE ESTIMATE" if one["true"] > one["estimate"] else ""
                print(
                    f"    {one['effect']:20} {one['quantity']:12} true {one['true']:9.3%} "
                    f"estimate {one['estimate']:9.3%}{high}",
                    flush=True,
                )
    for accuracy in accuracies or [0.01, 0.05]:
        here = [row["seconds"] / row["seconds_all"] for row in rows if row["accuracy"] == accuracy]
        kept = [row["worst"] <= accuracy for row in rows if row["accuracy"] == accuracy]
        print(
            f"at {accuracy:.0%}: median ratio {median(here):.2f}, kept in {sum(kept)} of {len(kept)}"
        )
    options.out.mkdir(parents=True, exist_ok=True)
    draw(ones, options.out / "leave_one_out.png")
    for name, table in (("plan", rows), ("leave_one_out", ones)):
        keys = dict.fromkeys(key for row in table for key in row)
        with open(options.out / f"{name}.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, list(keys))
            writer.writeheader()
            writer.writerows(table)


if __name__ == "__main__":
    main()
