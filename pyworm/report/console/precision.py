"""The cheapest model and grid of a work-precision study on the console."""

from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import duration
from pyworm.precision.grid_series import Point
from pyworm.precision.study import TARGETS, Curve, Study
from pyworm.report.table import Table


def cheapest_table(study: Study) -> Table:
    """The cheapest model and grid for each accuracy, by figure and for all together."""
    figures = list(study.references)
    rows: list[tuple[str, ...]] = []
    for accuracy in TARGETS:
        choices = [study.cheapest(accuracy, (figure,)) for figure in figures]
        choices.append(study.cheapest(accuracy, tuple(figures)))
        rows += [(f"{accuracy * 100:g} %", *map(_shown, choices)), ()]
    head = ("Error", *(QUANTITIES[figure].title() for figure in figures), "All of them")
    texts = tuple(range(1, len(head)))
    return Table(head, tuple(rows[:-1]), "Cheapest model and grid", texts=texts)


def _shown(choice: tuple[Curve, Point] | None) -> str:
    if choice is None:
        return "none"
    curve, point = choice
    grid = f"{point.label}, " if point.shape else ""
    return f"{curve.name}\n{grid}{duration(point.seconds)}"
