"""Pareto front of two objectives."""

from matplotlib.figure import Figure

from pyworm.io.quantities import Quantity, quantity_of
from pyworm.plots.layout import add_grids, placed_panels
from pyworm.result.design import BestDesign, DesignFigure


def draw_front(found: BestDesign) -> Figure:
    """Both objectives of each design of a front, and of the case as it is."""
    first, second = [each for each in found.figures if "imised" in each.role][:2]
    size, room = (6.4, 5.2), (0.9, 0.2, 0.6, 0.2)
    figure, (axes,) = placed_panels(size, f"{found.title}  ·  Pareto front", room)
    points = [
        [_number(each, part.figures[each.name]) for each in (first, second)] for part in found.front
    ]
    points.sort()
    axes.plot(*zip(*points, strict=True), "o-", color="tab:blue", label="best designs")
    axes.plot(
        _number(first, first.before), _number(second, second.before), "s", mfc="none", color="0.4",
        label="case as it is",
    )  # fmt: skip
    axes.set_xlabel(_axis(first))
    axes.set_ylabel(_axis(second))
    axes.legend(frameon=False)
    add_grids([axes])
    return figure


def _quantity(each: DesignFigure) -> Quantity | None:
    """How a figure is shown; None of a rating."""
    try:
        return quantity_of(each.name)
    except KeyError:
        return None


def _number(each: DesignFigure, value: float) -> float:
    quantity = _quantity(each)
    return value if quantity is None else float(quantity.number(value))


def _axis(each: DesignFigure) -> str:
    quantity = _quantity(each)
    words = each.name if quantity is None else quantity.axis()
    return f"{words} ({each.role.split(',')[0]})"
