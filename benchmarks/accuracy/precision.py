"""All of docs/evidence/accuracy.md: its pictures and its tables.

Run from the repository's root:

    python benchmarks/accuracy/precision.py                    everything; takes some hours
    python benchmarks/accuracy/precision.py scenes [NAME ...]  error against time, the scenes of `SCENES`
    python benchmarks/accuracy/precision.py expected           seconds expected and measured, shipped cases
    python benchmarks/accuracy/precision.py asked              accuracy asked and true error, random scenes
    python benchmarks/accuracy/precision.py cycle              certainty of a whole mesh cycle against time

Errors do not depend on the machine, seconds do; the tables have convolutions too, which depend on it less.
"""

import argparse
import pickle
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import asked_accuracy
import cycle_certainty
import expected_cost
from accuracy_page import fill, markdown

import pyworm
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import duration, percent
from pyworm.plots.layout import write
from pyworm.plots.precision import draw_precision
from pyworm.precision.study import TARGETS, Study
from pyworm.precision.survey import study

PICTURES = Path("docs/pictures")
RESULTS = Path("results/accuracy")


@dataclass(frozen=True)
class Shown:
    """A scene of the page: where it is, and the processor time that its study may take [s]."""

    case: str
    place: dict
    budget: float


SCENES = {
    "point_m20_l10": Shown("point_m20_l10", {}, 60.0),
    "point_m1000_l10": Shown("point_m1000_l10", {}, 100.0),
    "ellipse10_along": Shown("ellipse10_along", {}, 100.0),
    "zi": Shown("zi_sharif_2001", {"phase": 0.5}, 400.0),
    "roller": Shown("roller_ref", {"section": "left", "phase": 0.5, "station": 0.5}, 100.0),
    "gear": Shown("spur_pair", {"phase": 0.2}, 100.0),
}


def scenes(names: Sequence[str]) -> None:
    """Pictures and tables of some scenes, or of all."""
    for name in names or SCENES:
        shown = SCENES[name]
        contact = pyworm.load(Path(f"cases/{shown.case}.toml")).scene(**shown.place)
        made = study(contact, None, shown.budget, tell, clock=process_time)
        print(file=sys.stderr)
        RESULTS.mkdir(parents=True, exist_ok=True)
        (RESULTS / f"{name}.pkl").write_bytes(pickle.dumps(made))
        show(name, made)


def show(name: str, made: Study) -> None:
    """Picture and tables of one study."""
    where = ", ".join(f"{key} {value}" for key, value in SCENES[name].place.items())
    heading = ", ".join(part for part in (SCENES[name].case, where) if part)
    write(draw_precision(made, heading), PICTURES / f"accuracy_{name}.png")
    fill(f"{name} cheapest", markdown(cheapest_rows(made)))
    fill(f"{name} formulas", markdown(point_rows(made, "formula")))
    fill(f"{name} grids", markdown(point_rows(made, "model")))
    print(f"{name}: {made.seconds:.0f} s", flush=True)


def cheapest_rows(made: Study) -> Iterable[Sequence[str]]:
    """Accuracies against figures: the cheapest model and grid."""
    figures = list(made.references)
    yield ["error", *(QUANTITIES[figure].title() for figure in figures), "all of them"]
    for accuracy in TARGETS:
        choices = [
            made.cheapest(accuracy, of) for of in (*((one,) for one in figures), tuple(figures))
        ]
        yield [
            f"{accuracy * 100:g} %",
            *(
                "none"
                if choice is None
                else ", ".join(
                    part
                    for part in (choice[0].name, choice[1].label, duration(choice[1].seconds))
                    if part
                )
                for choice in choices
            ),
        ]


def point_rows(made: Study, kind: str) -> Iterable[Sequence[str]]:
    """All points of formulas, or of models, with their errors."""
    figures = list(made.references)
    grid = ["grid", "s", "convolutions"] if kind == "model" else ["s"]
    yield [kind, *grid, *(QUANTITIES[figure].title() for figure in figures)]
    for curve in made.curves:
        if curve.kind != kind:
            continue
        for point in curve.points:
            cost = f"{point.seconds:.2g}"
            where = [point.label, cost, f"{point.convolutions:.0f}"] if kind == "model" else [cost]
            errors = [made.error(point, figure) for figure in figures]
            yield [
                curve.name,
                *where,
                *("" if error is None else percent(error) for error in errors),
            ]


def tell(message: str, share: float) -> None:
    print(f"\r{share:4.0%} {message:70}", end="", file=sys.stderr, flush=True)


PARTS = {
    "scenes": scenes,
    "expected": lambda names: expected_cost.main(),
    "asked": lambda names: asked_accuracy.main(),
    "cycle": lambda names: cycle_certainty.main(),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("part", nargs="?", choices=list(PARTS))
    parser.add_argument("names", nargs="*", help="scenes, by default all")
    options = parser.parse_args()
    for part in [options.part] if options.part else PARTS:
        PARTS[part](options.names)


if __name__ == "__main__":
    main()
