"""Whether the accuracy asked for is met, and at what price: 20 isothermal and 10 thermal random scenes.

Each is solved as a user would, for 5, 1 and 0.2 %, with the effects that the plan picks. The true error is
that of the worst figure asked for against the most complete model extrapolated (`pyworm.precision`); the
price is relative to that of the cheapest sufficient grid of that model, both without the dry contact and the
fields. Solved scenes are saved in results/accuracy/asked.csv, from where the next run continues.
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from math import cos, exp, log, pi, sin
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np
from plan_scenes import STEEL, mineral

import pyworm
from pyworm.formulas.film import radii_at_angle
from pyworm.formulas.hertz import hertz
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.precision.study import Study
from pyworm.precision.survey import study
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record
from kept_rows import keep_rows, kept_rows

ACCURACIES = (0.05, 0.01, 0.002)

COLD, HOT = 20, 10

BUDGETS = {"isothermal": 20.0, "thermal": 60.0}
"""Processor time for the reference of a scene [s]."""

RADIUS = 0.01

COLD_STEEL = Body(205.66e9, 0.3)
COLD_OIL = Oil(Roelands.from_alpha(0.04, 22e-9), Density.dowson_higginson(870.0))

OUT = Path("results/accuracy/asked.csv")


def isothermal_scene(random: np.random.Generator) -> Scene:
    """A point contact: M 5 to 500, L 1 to 15, ratio of radii 1/10 to 10, any angle, spin up to rolling."""
    m, lubricant, ratio = (
        exp(random.uniform(log(a), log(b))) for a, b in ((5, 500), (1, 15), (0.1, 10))
    )
    angle = random.uniform(0, pi / 2)
    radii = (RADIUS, RADIUS / ratio)
    along, _ = radii_at_angle(*radii, angle)
    modulus = COLD_STEEL.youngs_modulus / (1 - COLD_STEEL.poisson_ratio**2)
    speed_group = (lubricant / (COLD_OIL.viscosity.alpha * modulus)) ** 4 / 2
    speed = speed_group * modulus * along / COLD_OIL.viscosity.eta0
    load = m * (2 * speed_group) ** 0.75 * modulus * along**2
    contact = hertz(*radii, load, modulus)
    spin = random.uniform(-1, 1) * speed / max(contact.semi_axis_x, contact.semi_axis_y)
    motion = RigidMotion(speed * cos(angle), speed * sin(angle), spin)
    return Scene(
        name=f"M {m:.3g} L {lubricant:.3g} Rx/Ry {ratio:.3g} at {np.degrees(angle):.0f} deg",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=(motion, motion),
        load=load,
        bodies=(COLD_STEEL, COLD_STEEL),
        oil=COLD_OIL,
    )


def thermal_scene(random: np.random.Generator) -> Scene:
    """Steel, 0.4 to 1.5 GPa, 0.3 to 5 m/s, radii 1:5 to 5:1, slide-roll ratio 0.02 to 1.5, any angle."""
    pressure, speed, ratio, slip = (
        exp(random.uniform(log(low), log(high)))
        for low, high in ((0.4e9, 1.5e9), (0.3, 5.0), (0.2, 5.0), (0.02, 1.5))
    )
    angle = random.uniform(0, pi / 2)
    radii = (RADIUS, RADIUS / ratio)
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    first, second = (
        RigidMotion(*(speed * (1 + sign * slip / 2) * part for part in (cos(angle), sin(angle))))
        for sign in (1, -1)
    )
    return Scene(
        name=f"{pressure / 1e9:.2g} GPa, {speed:.2g} m/s, slip {slip:.2g}, Rx/Ry {ratio:.2g}",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=(first, second),
        load=(pressure / hertz(*radii, 1.0, modulus).pressure_max) ** 3,
        bodies=(STEEL, STEEL),
        oil=mineral(0.04, 2e-8),
    )


def scenes() -> Iterator[tuple[str, Scene]]:
    """Kind and scene."""
    random = np.random.default_rng(1)
    for _ in range(COLD):
        yield "isothermal", isothermal_scene(random)
    random = np.random.default_rng(2)
    for _ in range(HOT):
        yield "thermal", thermal_scene(random)


def true_errors(made: Study, solution) -> dict[str, float]:
    """Relative errors of a solution's figures."""
    errors = {}
    for name, reference in made.references.items():
        estimate = getattr(solution.figures, name)
        value = 0.0 if estimate is None else estimate.value
        if name == "temperature_max_film" and estimate is not None:
            value -= solution.inlet_temperature
        errors[name] = abs(value - reference.value) / reference.size
    return errors


def without_formulas(made: Study) -> Study:
    """A study without its formulas."""
    return replace(made, curves=tuple(curve for curve in made.curves if curve.kind == "model"))


def trial(kind: str, scene: Scene, accuracy: float, made: Study) -> dict:
    """One solve."""
    plan = pyworm.plan(scene, accuracy)
    started = process_time()
    solution = pyworm.solve(scene, plan)
    whole = process_time() - started
    errors = true_errors(made, solution)
    # the study has no other model; formulas do not compete
    cheapest = without_formulas(made).cheapest(accuracy, tuple(made.references))
    worst = max(errors, key=errors.get)
    return {
        "kind": kind,
        "scene": scene.name,
        "accuracy": accuracy,
        "converged": solution.accurate,
        "error": errors[worst],
        "of": worst,
        "unsure": max(of.band for of in made.references.values()),
        "seconds": solution.cost.convolutions * solution.cost.unit_seconds,
        "whole_seconds": whole,
        "cheapest": cheapest[1].seconds if cheapest else float("nan"),
        "stop_reason": solution.stop_reason,
    }


COLUMNS = (
    "contacts",
    "accuracy requested",
    "converged",
    "met",
    "median error",
    "largest error",
    "median cost / cheapest",
    "largest cost / cheapest",
)


def table_of(rows: list[dict]) -> list[list[str]]:
    """Kinds and accuracies, under `COLUMNS`."""
    table = []
    for kind in BUDGETS:
        for accuracy in ACCURACIES:
            here = [row for row in rows if (row["kind"], row["accuracy"]) == (kind, accuracy)]
            claimed = [row for row in here if row["converged"]]
            if not claimed:
                continue
            ratios = [row["seconds"] / row["cheapest"] for row in claimed]
            ratios = [ratio for ratio in ratios if np.isfinite(ratio)]
            table.append(
                [
                    kind,
                    f"{accuracy * 100:g} %",
                    f"{len(claimed)} of {len(here)}",
                    f"{sum(row['error'] <= accuracy for row in claimed)} of {len(claimed)}",
                    f"{median(row['error'] for row in claimed) * 100:.2g} %",
                    f"{max(row['error'] for row in claimed) * 100:.2g} %",
                    f"{median(ratios):.1f}" if ratios else "",
                    f"{max(ratios):.1f}" if ratios else "",
                ]
            )
    return table


def main() -> None:
    rows = kept_rows(OUT, ("kind", "scene", "of", "stop_reason"), {"converged"})
    for kind, scene in scenes():
        if sum(row["scene"] == scene.name for row in rows) == len(ACCURACIES):
            continue
        try:
            made = study(scene, None, BUDGETS[kind], complete_only=True, clock=process_time)
        except ValueError as error:
            print(f"{scene.name}: {error}", file=sys.stderr, flush=True)
            continue
        rows += [trial(kind, scene, accuracy, made) for accuracy in ACCURACIES]
        for row in rows[-len(ACCURACIES) :]:
            accuracy = row["accuracy"]
            print(
                f"{kind:10} {scene.name:44} {accuracy:5.1%} true {row['error']:8.3%} of {row['of']:20} "
                f"± {row['unsure']:.3%} {row['seconds']:7.2f} s ({row['whole_seconds']:.2f} in all), "
                f"cheapest {row['cheapest']:7.2f} s "
                f"{'' if row['converged'] else row['stop_reason']}"
                f"{'  MISSED' if row['converged'] and row['error'] > accuracy else ''}",
                flush=True,
            )
        keep_rows(OUT, rows)
    record("asked_accuracy", COLUMNS, table_of(rows))


if __name__ == "__main__":
    main()
