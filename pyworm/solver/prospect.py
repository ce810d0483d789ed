"""Whether the largest grid allowed can reach the accuracy, estimated before it is solved."""

from collections.abc import Mapping, Sequence

from pyworm.io.quantity_text import percent
from pyworm.planning.expected_work import WORTHLESS
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan
from pyworm.planning.target import FILMS
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.error_estimate import SPIKE, Reading, change, hot_spike


def refusal(
    plan: Plan,
    readings: Sequence[Reading],
    orders: Mapping[str, float],
    finer: Grid | LineGrid,
) -> Stop | None:
    """How the sequence ends without the next grid; None if it, or those after it, may reach the accuracy.

    Parameters
    ----------
    plan : Plan
        Accuracy and figures asked for.
    readings : sequence of Reading
        Figures on grids of halving spacing so far.
    orders : mapping
        Highest credible order of convergence of each figure with the spacing.
    finer : Grid or LineGrid
        The next grid.
    """
    if plan.refusal is not None:
        return Ending.REFUSED_BY_PLAN.stop(reason=plan.refusal)
    if not readings or not finer.nodes <= plan.largest_grid < finer.finer().nodes:
        return None
    aim = plan.aim if hot_spike(readings[-1]) is None else plan.aim.without("temperature_max_film")
    least = aim.worst(least_errors(readings, orders), readings[-1].figures)
    if least <= max(plan.accuracy, WORTHLESS):
        return None
    return Ending.OUT_OF_REACH.stop(error=percent(least))


def spike_stays(reading: Reading, grid: Grid | LineGrid, largest: int) -> bool:
    """Whether the film's largest temperature is still the tip of a spike on the largest grid allowed.

    A spike that a grid resolves is no more than twice as wide, in nodes, on the next one.

    Parameters
    ----------
    reading : Reading
        Figures on a grid.
    grid : Grid or LineGrid
        That grid.
    largest : int
        Nodes of the largest grid allowed.
    """
    if hot_spike(reading) is None:
        return False
    nodes = reading.peaks["temperature_max_film"].nodes
    while (grid := grid.finer()).nodes <= largest:
        nodes *= 2
    return nodes < SPIKE


def least_errors(readings: Sequence[Reading], orders: Mapping[str, float]) -> dict[str, float]:
    """Lower bound of the relative error of each figure on the next grid (`error_estimate.grid_errors`).

    There the present last change will be the one before, of which a quarter counts, and a film that is not
    positive now will have changed by 100 %. No error falls faster than its order of convergence allows.
    """
    last = readings[-1]
    before = change(readings[-2], last) if len(readings) > 1 else dict.fromkeys(last.figures, 0.0)
    errors = {}
    for name, value in last.figures.items():
        none_yet = name in FILMS and not value > 0
        errors[name] = float(max(before[name] / 4, none_yet) / (2 ** orders[name] - 1))
    return errors
