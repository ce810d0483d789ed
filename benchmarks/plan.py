"""What plans leave out, what that changes, and what it saves: every scene of `plan_scenes`.

For each scene the automatic plan against everything on: seconds of both solves at the accuracy asked for,
and how far the asked quantities differ on one grid. Then, one after another, each effect is switched off from
everything on: its true influence against the estimate. Run from the repository's root:

    python benchmarks/plan.py [ACCURACY ...] [--out DIR]     the whole table, by default at 1 % and 5 %
    python benchmarks/plan.py 5% "worm, phase 0.5"            only the scenes named

Leaves plan.csv, leave_one_out.csv and leave_one_out.png in DIR (results/plan).
"""

import argparse
import csv
from dataclasses import dataclass, replace
from pathlib import Path

from plan_scenes import TRIALS, Trial

import pyworm
from pyworm.accuracy import HEAT_FIGURES
from pyworm.effects.judgement import Judgement
from pyworm.effects.sketch import sketch
from pyworm.kernels import KernelError
from pyworm.ladder import settle
from pyworm.planning import Plan
from pyworm.solver import LADDERS
from pyworm.units import SHARE, parse

FINER = 1
"""Halvings of a plan's first grid on which fields of two plans are compared."""


@dataclass(frozen=True)
class Numbers:
    """What is asked of a contact, in numbers."""

    film: tuple[float, float]
    friction: float | None
    rises: tuple[float, ...]


def on_one_grid(scene, plan: Plan) -> Numbers:
    """The figures of a plan on a grid that does not depend on how well they are known."""
    simple = plan.simplified(scene)
    ladder = LADDERS[type(simple)](simple, plan)
    rung, _ = ladder.enter(plan.grids)
    for _ in range(FINER):
        settle(rung, plan.tolerance, plan.aim, 0.1 * plan.accuracy)
        rung = ladder.higher(rung)
    settle(rung, plan.tolerance / 10, plan.aim, 0.01 * plan.accuracy)
    figures = rung.read().figures
    return Numbers(
        (figures["film_min"], figures["film_central"]),
        figures.get("friction_coefficient"),
        tuple(figures[name] for name in HEAT_FIGURES if name in figures),
    )


def difference(scene, whole: Numbers, part: Numbers, quantities) -> dict[str, float]:
    """How far a part is from the whole, in the measure of influences."""
    found = {"film": max(abs(a / b - 1) for a, b in zip(part.film, whole.film, strict=True))}
    slides = sketch(scene).sliding > 0  # without it friction has no size
    if "friction" in quantities and slides and part.friction is not None:
        found["friction"] = abs(part.friction / whole.friction - 1)
    if "temperature" in quantities and whole.rises:
        rises = part.rises or (0.0, 0.0, 0.0)
        size = max(max(whole.rises), 1 / sketch(scene).inlet_beta)
        found["temperature"] = (
            max(abs(a - b) for a, b in zip(rises, whole.rises, strict=True)) / size
        )
    return found


def trial(name: str, of: Trial, accuracy: float) -> tuple[dict, list[dict]]:
    """A row of the table, and those of the effects that were left out."""
    scene = of.scene()
    plan = pyworm.plan(scene, accuracy, quantities=of.quantities)
    whole = pyworm.plan(scene, accuracy, "all", of.quantities)
    solved = pyworm.solve(scene, plan)
    everything = pyworm.solve(scene, whole)
    plan = replace(plan, effects=solved.effects)
    part = on_one_grid(scene, plan)
    numbers = on_one_grid(scene, whole)
    apart = difference(scene, numbers, part, of.quantities)
    left = [judgement for judgement in solved.effects if not judgement.on and judgement.influence]
    simulated = {judgement.name for judgement in whole.effects if judgement.on}
    row = {
        "scene": name,
        "accuracy": accuracy,
        "seconds": solved.cost.seconds,
        "seconds_all": everything.cost.seconds,
        "converged": solved.converged,
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
        for judgement in solved.effects
        if judgement.name in simulated
        for one in leave_one_out(scene, judgement, whole, numbers, of.quantities)
    ]


def leave_one_out(
    scene, judgement: Judgement, whole: Plan, numbers: Numbers, quantities
) -> list[dict]:
    """True and estimated influence of one effect on each quantity."""
    try:
        less = pyworm.plan(scene, whole.accuracy, f"all,-{judgement.name}", quantities)
        part = on_one_grid(scene, less)
    except (ValueError, KernelError) as error:
        print(f"    {judgement.name}: cannot be left out, {error}", flush=True)
        return []
    true = difference(scene, numbers, part, quantities)
    return [
        {
            "scene": scene.name,
            "accuracy": whole.accuracy,
            "effect": judgement.name,
            "on": judgement.on,
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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("words", nargs="*", help="accuracies and names of scenes")
    parser.add_argument("--out", type=Path, default=Path("results/plan"))
    options = parser.parse_args()
    accuracies = [parse(word, SHARE) for word in options.words if word.endswith("%")]
    names = [word for word in options.words if not word.endswith("%")] or list(TRIALS)
    rows, ones = [], []
    print(f"{'scene':24} {'asked':>5} {'s':>8} {'all, s':>8} {'ratio':>6} {'differ':>8}  left out")
    for accuracy in accuracies or [0.01, 0.05]:
        for name in names:
            row, ones_here = trial(name, TRIALS[name], accuracy)
            rows.append(row)
            ones += ones_here
            print(told(row), flush=True)
            for one in ones_here:
                high = " ABOVE THE ESTIMATE" if one["true"] > one["estimate"] else ""
                state = "on" if one["on"] else "off"
                print(
                    f"    {one['effect']:20} {state:3} {one['quantity']:12} true {one['true']:9.3%} "
                    f"estimate {one['estimate']:9.3%}{high}",
                    flush=True,
                )
    options.out.mkdir(parents=True, exist_ok=True)
    for name, table in (("plan", rows), ("leave_one_out", ones)):
        keys = dict.fromkeys(key for row in table for key in row)
        with open(options.out / f"{name}.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, list(keys))
            writer.writeheader()
            writer.writerows(table)


if __name__ == "__main__":
    main()
