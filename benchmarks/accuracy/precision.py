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
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import asked_accuracy
import cycle_certainty
import expected_cost

import pyworm
from pyworm.io.quantity_text import duration, percent
from pyworm.plots.layout import write
from pyworm.plots.precision import draw_precision
from pyworm.precision.study import TARGETS, Study
from pyworm.precision.survey import study

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

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
    record("precision_cheapest", CHEAPEST, cheapest_rows(name, made), key=("contact",))
    record("precision_formulas", FORMULAS, point_rows(name, made, "formula"), key=("contact",))
    record("precision_grids", GRIDS, point_rows(name, made, "model"), key=("contact",))
    print(f"{name}: {made.seconds:.0f} s", flush=True)


FIGURES = {
    "film_min": "h_min",
    "film_central": "h_c",
    "friction_coefficient": "friction",
    "temperature_max_film": "T_max of the film",
}
CHEAPEST = "contact", "error", *FIGURES.values(), "all"
FORMULAS = "contact", "formula", "time / s", *FIGURES.values()
GRIDS = "contact", "model", "grid", "time / s", "convolutions", *FIGURES.values()
"""Columns of the cheapest models and grids, of formulas, and of models; errors are relative."""


def cheapest_rows(contact: str, made: Study) -> Iterator[Sequence[str]]:
    """The cheapest model and grid of each accuracy and quantity."""
    for accuracy in TARGETS:
        texts = []
        for wanted in (*((name,) for name in FIGURES), tuple(made.references)):
            if not made.references.keys() >= set(wanted):
                texts.append("")
                continue
            choice = made.cheapest(accuracy, wanted)
            texts.append("none" if choice is None else _choice(*choice))
        yield contact, f"{accuracy * 100:g} %", *texts


def _choice(curve, point) -> str:
    """Model, grid and time of a choice."""
    return ", ".join(part for part in (curve.name, point.label, duration(point.seconds)) if part)


def point_rows(contact: str, made: Study, kind: str) -> Iterator[Sequence[str]]:
    """All points of formulas, or of models, with their errors."""
    for curve in made.curves:
        if curve.kind != kind:
            continue
        for point in curve.points:
            cost = [f"{point.seconds:.2g}"]
            if kind == "model":
                cost = [point.label, *cost, f"{point.convolutions:.0f}"]
            errors = [
                made.error(point, name) if name in made.references else None for name in FIGURES
            ]
            texts = ("" if error is None else percent(error) for error in errors)
            yield contact, curve.name, *cost, *texts


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
