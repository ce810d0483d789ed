"""Whether error bars hold: random scenes, all figures against finer grids in a wider window.

Scenes, solved to 2 % or another accuracy, are those of `tests/hard/draws.py`, COUNT of each kind and seed:
isothermal and thermal points, thermal lines, both between bodies 10 K colder to 40 K warmer than the oil
supplied, rough points, and points to which a thin layer of oil comes (whose window has no wider one). The
truth is Richardson's limit over grids down to a quarter of the solution's spacing, half of it with heat (as
far as MOST_NODES allows), in a window of twice the reach, with more levels across the film, corrected for the
end of that window: by the power with which a film's error falls, and of temperatures by windows of four and
eight times the reach on a coarse grid and by how their changes fall. It may be off by the limit's own
uncertainty (`pyworm.precision.limits`) and half of what no window shows; a bar is judged where that is below
half of it. From the repository's root:

    python benchmarks/accuracy/error_bars.py [--kinds KIND,...] [--accuracy 0.1] [COUNT [SEED ...]]

Truths, by far the most of the work, are kept in results/truths.csv, which serves later runs whose bars are
told in another way; what was found in results/error_bars.csv. The next run goes on from there.
"""

import csv
import sys
from argparse import ArgumentParser
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import count, product
from math import inf, nan
from pathlib import Path
from statistics import median

import pyworm
from pyworm.batch.task import Task
from pyworm.case.case import case_of
from pyworm.planning import error_budget
from pyworm.planning.grid import Grid, nest
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.precision.extrapolation import limit
from pyworm.scene.index import ContactIndex
from pyworm.solver.error_estimate import Reading
from pyworm.solver.grid_sequence import SOLVERS

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import JUDGED_DRAWS, Drawn

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record
from kept_rows import keep_rows, kept_rows

ACCURACY = 0.02
EXACT = 0.1
"""Accuracy of the truth's levels and algebra over that of the solution."""

EFFECTS = dict.fromkeys(JUDGED_DRAWS, "all") | {"isothermal": "isothermal"}
MOST_NODES = dict.fromkeys(("thermal-line", "warm-line"), 20_000) | {
    "isothermal": 3_000_000,
    **dict.fromkeys(("thermal", "warm", "rough", "starved"), 1_000_000),
}
FINER = dict.fromkeys(JUDGED_DRAWS, 0.6) | {"isothermal": 0.3}
"""Spacing of the truth's last grid over the solution's."""

LEVELS = dict.fromkeys(JUDGED_DRAWS, 13) | dict.fromkeys(("thermal-line", "warm-line"), 17)
"""Levels across a heated film of the truth. What two fewer change is part of how far that of a line may be
off; levels of points cost too much for another."""

LEFT = 2**-1.5
"""Share of a film's error by its window that is left when the reach is doubled (`docs/theory/film.md`)."""

FAR_NODES = 250_000
"""Nodes beyond which no window of eight times the reach is solved."""

SLOWEST = 0.75
"""Largest fall of the changes by the window that is extrapolated."""

KNOWN = 0.5
"""Uncertainty of the truth over a bar up to which the bar is judged."""

FIGURES = {
    "film_min": "h_min",
    "film_central": "h_c",
    "pressure_max": "p_max",
    "friction_coefficient": "friction",
    "power_loss": "power loss",
    "asperity_load_fraction": "asperity load ratio",
    "temperature_max_body_1": "T_max of body 1",
    "temperature_max_body_2": "T_max of body 2",
    "temperature_max_film": "T_max of the film",
}
OUT, TRUTHS = Path("results/error_bars.csv"), Path("results/truths.csv")

Truth = dict[str, tuple[float, float]]
"""Value of each figure, and how far it may be off."""


def refined(
    scene: pyworm.Scene, plan: Plan, grids: Sequence[Grid], spacing: float, most: float
) -> dict[int, Reading]:
    """Readings on grids of halving spacing by number, the last ones on which the equations are met."""
    solver = SOLVERS[type(scene)](scene, plan)
    level, _ = solver.begin(grids)
    readings: dict[int, Reading] = {}
    for number in count():
        iteration = solver.converged(level, plan, error_budget.ALGEBRA * plan.accuracy)
        if level.film.balance.worst > 10 * plan.tolerance or iteration.reading.film_min <= 0:
            readings = {}
        else:
            readings[number] = iteration.reading
        if level.grid.dx <= spacing or level.grid.finer().nodes > most:
            return readings
        level, _ = solver.refined(level)


def farther(plan: Plan) -> Iterator[tuple[Grid | LineGrid, ...]]:
    """The plan's grids to windows of about four and eight times the reach, in which gaps rise as squares."""
    for growth in (2**0.5, 2.0):
        if isinstance(plan.grids[-1], LineGrid):
            wide = plan.wider_grids[-1]  # oil enters at its first node
            first = round(growth * wide.first)
            yield (LineGrid(wide.dx, first, wide.nodes + wide.first - first),)
            continue
        inner, outer = (
            tuple(growth * side for side in plan.wider_grids[place].box) for place in (-1, 0)
        )
        grids = nest(inner, outer, *plan.grids[-1].spacing)
        yield grids[-len(plan.wider_grids) :]


def rest_of(values: Sequence[float], name: str) -> float:
    """What an endless window adds to the last of some windows of growing reach, each of twice the one before.

    From the values of a figure in them, on one grid.
    """
    last = values[-1] - values[-2]
    left = LEFT
    if name in HEAT_FIGURES:
        before = values[-2] - values[-3]
        left = min(max(last / before, 0.0), SLOWEST) if before else 0.0
    return last * left / (1 - left)


def truth(scene: pyworm.Scene, plan: Plan, spacing: float, kind: str) -> Truth:
    """Figures on an infinitely fine grid in an endless window, and how far each may be off.

    Nothing where no two grids of the wider window have a film, or none has one in all windows.
    """
    most = MOST_NODES[kind]
    wide = refined(scene, plan, plan.wider_grids or plan.grids, FINER[kind] * spacing, most)
    if not plan.wider_grids:
        return within(wide)
    coarse = 1.1 * plan.grids[-1].dx / 2 ** min(wide, default=0)
    near = refined(scene, plan, plan.grids, coarse / 2, most)
    first = min(wide.keys() & near.keys(), default=None)
    if first is None or len(wide) < 2:
        return {}
    by_levels = left_by_levels(scene, plan, 1.1 * plan.grids[-1].dx / 2**first, near[first])
    ends = [near[first], wide[first]]
    for grids in farther(plan) if plan.model.heated else ():
        if len(ends) < 3 or grids[-1].nodes * 4**first < FAR_NODES:
            coarse = 1.1 * plan.grids[-1].dx / 2**first
            ends.append(refined(scene, plan, grids, coarse, most).get(first))
    if None in ends:
        return {}
    found = {}
    for name in wide[first].figures:
        fine = limit([reading.figures[name] for reading in wide.values()])
        # films in windows farther out are off by the coarse grids there
        seen = ends if name in HEAT_FIGURES else ends[:2]
        values = [reading.figures[name] for reading in seen]
        rest = rest_of(values, name)
        unsure = fine.error + abs(rest) / 2 + by_levels.get(name, 0.0)
        found[name] = fine.value + values[-1] + rest - values[1], unsure
    return found


def left_by_levels(
    scene: pyworm.Scene, plan: Plan, spacing: float, here: Reading
) -> dict[str, float]:
    """Change of each figure of a heated line by its last two levels across the film; nothing of others."""
    if not (plan.model.heated and isinstance(plan.grids[-1], LineGrid)):
        return {}
    fewer = refined(scene, with_levels(plan, plan.model.levels - 2), plan.grids, spacing, inf)
    if not fewer:
        return dict.fromkeys(here.figures, inf)
    *_, before = fewer.values()
    return {name: abs(value - before.figures[name]) for name, value in here.figures.items()}


def within(readings: dict[int, Reading]) -> Truth:
    """Figures on an infinitely fine grid in a window beyond which there is no oil; nothing of one grid."""
    if len(readings) < 2:
        return {}
    values = {
        name: [reading.figures[name] for reading in readings.values()]
        for name in next(iter(readings.values())).figures
    }
    limits = {name: limit(of) for name, of in values.items()}
    return {name: (of.value, of.error) for name, of in limits.items()}


def truth_of(task: Task, solution: pyworm.Solution, kind: str) -> Truth:
    """The truth of a scene in a window and on grids that do for one of its solutions."""
    exact = pyworm.plan(task.scene, EXACT * task.accuracy, EFFECTS[kind])
    # temperatures of films that hardly warm are settled too
    exact = replace(exact, target=replace(exact.target, warmth=0.0))
    if exact.model.heated:
        exact = with_levels(exact, LEVELS[kind])
    x = solution.fields.x.values
    return truth(exact.simplified(task.scene), exact, float(x[1] - x[0]), kind)


def with_levels(plan: Plan, levels: int) -> Plan:
    """The plan with a number of levels across the film."""
    return replace(plan, model=replace(plan.model, levels=levels))


def judged(
    scene: str, kind: str, drawn: Drawn, accuracy: float, truths: dict[str, Truth]
) -> Iterator[dict]:
    """Each figure of a scene: its bar, and how far it is from the truth, which is added to those known."""
    task = Task(case_of(drawn.tables, kind, Path()), ContactIndex(), accuracy, EFFECTS[kind])
    solution = pyworm.solve(task.scene, task.plan)
    if scene not in truths:
        truths[scene] = truth_of(task, solution, kind)
        save_truths(truths)
    real = truths[scene]
    for name in FIGURES:
        bar = getattr(solution.figures, name)
        # friction without sliding has no size
        if bar is None or bar.value == bar.datum:
            continue
        size = abs(bar.value - bar.datum)
        value, unsure = real.get(name, (nan, nan))
        yield {
            "scene": scene,
            "figure": name,
            "converged": solution.converged,
            "bar": bar.error,
            "error": abs(bar.value - bar.datum - value) / size,
            "unsure": unsure / size,
            "reason": bar.reason or "",
        }


TEXTS = "scene", "figure", "reason"
"""Columns of words."""


def saved_truths() -> dict[str, Truth]:
    """Truths of earlier runs by scene."""
    if not TRUTHS.exists():
        return {}
    truths: dict[str, Truth] = {}
    with TRUTHS.open() as file:
        for scene, name, value, unsure in csv.reader(file):
            of = truths.setdefault(scene, {})
            if name:
                of[name] = float(value), float(unsure)
    return truths


def save_truths(truths: dict[str, Truth]) -> None:
    """Write the truths known so far; a scene without any has one line without a figure."""
    TRUTHS.parent.mkdir(parents=True, exist_ok=True)
    with TRUTHS.open("w", newline="") as file:
        writer = csv.writer(file)
        for scene, real in truths.items():
            writer.writerows((scene, name, *of) for name, of in (real or {"": ("", "")}).items())


def judgeable(row: dict) -> bool:
    """Whether the truth is known well enough for a bar."""
    return bool(row["reason"]) or row["unsure"] <= KNOWN * row["bar"] < inf


CONTACTS = (
    "kind",
    "seeds",
    "contacts",
    "converged",
    "judged",
    "hold",
    "share",
    "largest error / uncertainty",
)
ESTIMATES = (
    "kind",
    "seeds",
    "quantity",
    "estimates",
    "judged",
    "hold",
    "without estimate",
    "median error / uncertainty",
    "largest error / uncertainty",
)


def counted(rows: list[dict]) -> tuple[int, int, list[float]]:
    """Judged estimates of converged solutions, how many hold, and the errors over those that are finite."""
    known = [row for row in rows if row["converged"] and judgeable(row)]
    ratios = [row["error"] / row["bar"] for row in known if not row["reason"]]
    return len(known), sum(ratio <= 1 for ratio in ratios) + len(known) - len(ratios), ratios


def by_kind(rows: list[dict], kind: str, seeds: str) -> tuple:
    """A row under `CONTACTS`."""
    contacts = {row["scene"]: row["converged"] for row in rows}
    judged_count, held, ratios = counted(rows)
    share = f"{held / judged_count:.1%}".replace("%", " %") if judged_count else ""
    counts = len(contacts), sum(contacts.values()), judged_count, held, share
    return (kind, seeds, *counts, f"{max(ratios):.2f}" if ratios else "")


def by_figure(rows: list[dict], kind: str, seeds: str) -> Iterator[tuple]:
    """A row under `ESTIMATES` for each quantity."""
    for name, words in FIGURES.items():
        of = [row for row in rows if row["figure"] == name and row["converged"]]
        known, held, ratios = counted(of)
        if ratios:
            errors = f"{median(ratios):.2f}", f"{max(ratios):.2f}"
            yield (kind, seeds, words, len(of), known, held, known - len(ratios), *errors)


def by_scene(rows: list[dict]) -> Iterator[tuple[str, ...]]:
    """A row for each contact: estimates of its films and pressure, and its largest error over one."""
    for scene in dict.fromkeys(row["scene"] for row in rows):
        of = {row["figure"]: row for row in rows if row["scene"] == scene}
        finite = {
            name: row["error"] / row["bar"]
            for name, row in of.items()
            if judgeable(row) and not row["reason"]
        }
        worst = max(finite, key=finite.get, default=None)
        film = max(of[name]["bar"] for name in ("film_min", "film_central"))
        pressure = of["pressure_max"]
        yield (
            scene,
            "yes" if pressure["converged"] else "no",
            f"{film * 100:.2g}",
            pressure["reason"] or f"{pressure['bar'] * 100:.2g}",
            "" if worst is None else f"{finite[worst]:.2f}",
            "" if worst is None else FIGURES[worst],
        )


def record_all(rows: list[dict], kinds: Sequence[str], seeds: Sequence[int]) -> None:
    """Write the tables of some kinds and seeds."""
    words = " ".join(map(str, seeds))
    some = [row for row in rows if any(row["scene"].endswith(f" of {seed}") for seed in seeds)]
    of = {kind: [row for row in some if row["scene"].startswith(f"{kind}:")] for kind in kinds}
    of = {kind: part for kind, part in of.items() if part}
    contacts = [by_kind(part, kind, words) for kind, part in of.items()]
    record("error_contacts", CONTACTS, contacts, key=("kind", "seeds"))
    figures = [row for kind, part in of.items() for row in by_figure(part, kind, words)]
    record("error_estimates", ESTIMATES, figures, key=("kind", "seeds", "quantity"))
    columns = "uncertainty of film / %", "uncertainty of p_max / %", "largest error / uncertainty"
    record(
        "error_scenes", ("contact", "converged", *columns, "of"), by_scene(some), key=("contact",)
    )


def main() -> None:
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", type=int, nargs="?", default=15)
    parser.add_argument("seeds", type=int, nargs="*", default=[1, 2])
    parser.add_argument("--kinds", default=",".join(EFFECTS))
    parser.add_argument("--accuracy", type=float, default=ACCURACY)
    asked = parser.parse_args()
    kinds = asked.kinds.split(",")
    rows, truths = kept_rows(OUT, TEXTS, {"converged"}), saved_truths()
    for seed, place, kind in product(asked.seeds, range(asked.count), kinds):
        scene = f"{kind}:{place} of {seed}"
        if asked.accuracy != ACCURACY:
            scene += f" at {asked.accuracy:.0%}"
        if any(row["scene"] == scene for row in rows):
            continue
        rows += judged(scene, kind, JUDGED_DRAWS[kind](place, seed), asked.accuracy, truths)
        keep_rows(OUT, rows)
        shown = by_scene([row for row in rows if row["scene"] == scene])
        print(*next(shown), sep="  ", flush=True)
    if asked.accuracy == ACCURACY:
        record_all(rows, kinds, asked.seeds)


if __name__ == "__main__":
    main()
