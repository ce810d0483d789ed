"""Criteria by which a grid sequence stops, and their reasons.

Among them whether the largest grid allowed can reach the accuracy, estimated before it is solved, and whether
the contact rests on a sharp edge, where no film converges.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.quantity_text import percent
from pyworm.planning import error_budget
from pyworm.planning.expected_work import MAX_FILM_ERROR
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan
from pyworm.planning.target import FILMS, HEAT_FIGURES
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.error_estimate import SPIKE, Reading, change, hot_spike
from pyworm.solver.estimate import Estimate
from pyworm.solver.level import Level
from pyworm.solver.newton import UNRECOVERABLE_RESIDUAL, Iteration

MAX_USED_ERROR = 0.5
"""Largest error of the figures asked for with which a film is used: in means and losses over a mesh cycle it
is better than none, and its error bar is that of the whole. Temperatures may be less accurate: at a sharp
edge they grow from grid to grid where films and friction have settled."""

MAX_JUDGED_RESIDUAL = 1e-2
"""Residual beyond which the figures of a grid have no error estimate, unless the tolerance is larger."""

MAX_UNCONVERGED_GRIDS = 3
"""Number of grids of the figures that may miss the tolerance: some are too coarse for the pressure gradients
of a film with a limiting stress."""

MAX_DIVERGED_ON_EDGE = 2
"""Number of grids whose film may diverge although coarser ones had one, where the load rests on a sharp edge:
on finer grids the pressure there is higher, and each costs four times the one before."""


def with_wider_bars(
    stop: Stop, estimates: Mapping[str, Estimate], figures: Mapping[str, float], plan: Plan
) -> Stop:
    """How the solve of a sound film ended, qualified where figures on the last grid have bars too wide."""
    errors = {name: estimate.error for name, estimate in estimates.items()}
    worst, cold = (
        target.worst(errors, figures)
        for target in (plan.target, plan.target.without(*HEAT_FIGURES))
    )
    if stop.ending.accurate or not cold <= MAX_USED_ERROR:
        return stop
    if worst <= MAX_USED_ERROR:
        return Ending.WIDER_BARS.stop(error=percent(worst), reason=stop.reason)
    return Ending.WIDER_BARS_OF_HEAT.stop(
        error=percent(cold), widest=percent(MAX_USED_ERROR), reason=stop.reason
    )


def rate_not_accurate(
    stop: Stop,
    flaw: str,
    estimates: Mapping[str, Estimate],
    figures: Mapping[str, float],
    plan: Plan,
) -> Stop:
    """How the solve of an accurate film ended whose transient solution has more than its share of the error.

    All sources together may be within the accuracy even so.
    """
    errors = {name: estimate.error for name, estimate in estimates.items()}
    within = plan.target.worst(errors, figures) <= plan.accuracy
    return stop if within else Ending.RATE_OF_CHANGE.stop(reason=flaw)


def film_is_sound(level: Level, iteration: Iteration, plan: Plan) -> bool:
    """Whether the equations are met by a film that is positive everywhere."""
    return level.film.balance.worst <= plan.tolerance and iteration.reading.film_min > 0


def stop_reason(
    level: Level,
    iteration: Iteration,
    estimates: Mapping[str, Estimate],
    unconverged: int,
    max_unconverged: int,
    plan: Plan,
) -> Stop | None:
    """How the sequence ends on a level, or None if a finer grid follows.

    `unconverged` grids so far missed the tolerance; `max_unconverged` may.
    """
    figures = iteration.reading.figures
    error = plan.target.worst(
        {name: estimate.error for name, estimate in estimates.items()}, figures
    )
    met = level.film.balance.worst <= plan.tolerance
    resolved = min(iteration.reading.film_min, estimates["film_min"].value) > 0
    if met and resolved and error <= plan.accuracy:
        return Ending.ACCURATE.stop()
    domains = {name: estimate.domain for name, estimate in estimates.items()}
    domain = plan.target.worst(domains, figures)
    last = level.grid.finer().nodes > plan.largest_grid
    if np.isfinite(domain) and domain > plan.accuracy:
        grids = {name: estimate.grid for name, estimate in estimates.items()}
        cold = plan.target.without(*HEAT_FIGURES)
        # without finer grids nothing is known of what the grids leave
        if cold.worst(domains, figures) > plan.accuracy:
            if last or np.isfinite(cold.worst(grids, figures)):
                return Ending.WINDOW_OF_FILM.stop(error=percent(domain))
        elif plan.target.worst(grids, figures) <= domain:
            return Ending.WINDOW_OF_HEAT.stop(error=percent(domain))
    if not met and (last or unconverged >= max_unconverged):
        return _not_met(level, plan)
    but_for = _accurate_but_for(level, iteration, estimates, plan) if met and resolved else None
    if but_for is not None:
        return but_for
    if not last:
        return None
    if not resolved:
        return Ending.NOT_RESOLVED.stop()
    if np.isinf(error):
        return Ending.NOT_COMPARED.stop()
    return Ending.LARGEST_GRID.stop(error=percent(error))


def bound_by_conduction(
    level: Level, estimates: Mapping[str, Estimate], figures: Mapping[str, float], plan: Plan
) -> tuple[str, ...]:
    """Temperatures off by the approximation of conduction, which no grid mends, and by nothing else."""

    def is_bound(name: str, conduction: float) -> bool:
        target = replace(plan.target, figures=(name,))
        rest = target.worst({name: estimates[name].error - conduction}, figures)
        least = target.worst({name: conduction}, figures)
        return least > error_budget.CONDUCTION * plan.accuracy and rest <= plan.accuracy

    return tuple(name for name, error in level.conduction_errors().items() if is_bound(name, error))


def _not_met(level: Level, plan: Plan) -> Stop:
    if level.film.unsolved():
        return Ending.NO_SHEAR_STRESS.stop(places=level.film.unsolved())
    worst = level.film.balance.worst
    if not worst <= UNRECOVERABLE_RESIDUAL:
        return Ending.NO_FILM.stop()
    return Ending.RESIDUAL.stop(residual=worst, tolerance=plan.tolerance)


def _accurate_but_for(
    level: Level, iteration: Iteration, estimates: Mapping[str, Estimate], plan: Plan
) -> Stop | None:
    """The end that names temperatures which no grid allowed brings to the accuracy, if all else has it."""
    figures = iteration.reading.figures
    errors = {name: estimate.error for name, estimate in estimates.items()}

    def without(*names: str) -> bool:
        return plan.target.without(*names).worst(errors, figures) <= plan.accuracy

    hottest = "temperature_max_film"
    if (
        spike_stays(iteration.reading, level.grid, plan.largest_grid)
        and hottest in estimates
        and (tip := estimates[hottest].reason) is not None
        and without(hottest)
    ):
        return Ending.ACCURATE_BUT_FOR_SPIKE.stop(spike=tip)
    bound = bound_by_conduction(level, estimates, figures, plan)
    if bound and without(*bound):
        left = max(errors[name] for name in bound)
        return Ending.ACCURATE_BUT_FOR_CONDUCTION.stop(error=percent(left))
    return None


LEAST_RATIO = 0.3
"""Least ratio of the dry pressure beside an edge to the largest for a contact that rests on it."""

CURE = (
    "; the load rests on a sharp edge of the surfaces, where pressure has no bound: ease the edge, as tip "
    "relief of teeth does (tip_relief, tip_relief_length), or keep the contact within the surfaces, by more "
    "crowning or less load"
)
"""Advice that a stop reason adds then."""


def rests_on_edge(fields: PlainDataset) -> bool:
    """Whether the dry pressure of a solution's fields [Pa] is large beside the end of a surface.

    At a sharp edge the elastic pressure grows without bound as the grid is refined (Johnson, Contact
    Mechanics, 1985, section 2.4), and no film converges there; a relieved edge has no such pressure.
    """
    if "covered" not in fields:
        return False
    covered = fields["covered"].values.astype(bool)
    pressure = fields["dry_pressure" if "dry_pressure" in fields else "pressure"].values
    beside = np.zeros_like(covered)
    for axis in range(covered.ndim):
        ends = np.diff(covered.astype(np.int8), axis=axis) != 0
        before, after = ([slice(None)] * covered.ndim for _ in range(2))
        before[axis], after[axis] = slice(None, -1), slice(1, None)
        beside[tuple(before)] |= ends
        beside[tuple(after)] |= ends
    at_edge = pressure[beside & covered]
    return bool(at_edge.size and at_edge.max() > LEAST_RATIO * pressure.max())


def refusal(
    plan: Plan, readings: Sequence[Reading], orders: Mapping[str, float], finer: Grid | LineGrid
) -> Stop | None:
    """How the sequence ends without the next grid; None if it, or those after it, may reach the accuracy.

    By figures on grids of halving spacing and the highest credible orders of their convergence.
    """
    if plan.refusal is not None:
        return Ending.REFUSED_BY_PLAN.stop(reason=plan.refusal)
    if not readings or not finer.nodes <= plan.largest_grid < finer.finer().nodes:
        return None
    target = (
        plan.target
        if hot_spike(readings[-1]) is None
        else plan.target.without("temperature_max_film")
    )
    least = target.worst(least_errors(readings, orders), readings[-1].figures)
    if least <= max(plan.accuracy, MAX_FILM_ERROR):
        return None
    return Ending.OUT_OF_REACH.stop(error=percent(least))


def spike_stays(reading: Reading, grid: Grid | LineGrid, largest: int) -> bool:
    """Whether the film's largest temperature is still a spike's tip on the `largest` grid [nodes] allowed.

    A spike that a grid resolves is no more than twice as wide, in nodes, on the next one.
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
