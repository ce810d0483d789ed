"""Criteria by which a grid sequence stops, and their reasons."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from pyworm.io.quantity_text import percent
from pyworm.planning import error_budget
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.estimate import Estimate
from pyworm.solver.level import Level
from pyworm.solver.newton import HOPELESS, Settled
from pyworm.solver.prospect import spike_stays

WIDEST = 0.5
"""Largest error of the figures asked for with which a film is used: in means and losses over a mesh cycle it
is better than none, and its error bar is that of the whole. Temperatures may be less accurate: at a sharp
edge they grow from grid to grid where films and friction have settled."""

TELLING = 1e-2
"""Residual beyond which the figures of a grid have no error estimate, unless the tolerance is larger."""

MOST_UNSETTLED = 3
"""Number of grids of the figures that may miss the tolerance: some are too coarse for the pressure gradients
of a film with a limiting stress."""

MOST_LOST_ON_EDGE = 2
"""The same of films that coarser grids had, where the load rests on a sharp edge: on finer grids the pressure
there is higher, and each costs four times the one before."""


def with_wider_bars(
    stop: Stop, estimates: Mapping[str, Estimate], figures: Mapping[str, float], plan: Plan
) -> Stop:
    """How the solve of a sound film ended, qualified where its figures have error bars that are too wide.

    Parameters
    ----------
    stop : Stop
        How the sequence of grids ended.
    estimates : mapping
        The figures with their error bars.
    figures : mapping
        Their values on the last grid.
    plan : Plan
        Accuracy and figures asked for.
    """
    errors = {name: of.error for name, of in estimates.items()}
    worst, cold = (of.worst(errors, figures) for of in (plan.aim, plan.aim.without(*HEAT_FIGURES)))
    if stop.ending.accurate or not cold <= WIDEST:
        return stop
    if worst <= WIDEST:
        return Ending.WIDER_BARS.stop(error=percent(worst), reason=stop.reason)
    return Ending.WIDER_BARS_OF_HEAT.stop(
        error=percent(cold), widest=percent(WIDEST), reason=stop.reason
    )


def film_is_sound(level: Level, settled: Settled, plan: Plan) -> bool:
    """Whether the equations are met by a film that is positive everywhere."""
    return level.film.balance.worst <= plan.tolerance and settled.reading.film_min > 0


def stop_reason(
    level: Level,
    settled: Settled,
    estimates: Mapping[str, Estimate],
    unsettled: int,
    most_unsettled: int,
    plan: Plan,
) -> Stop | None:
    """How the sequence ends on a level, or None if a finer grid follows.

    Parameters
    ----------
    level : Level
        The film on the last grid.
    settled : Settled
        Figures on it.
    estimates : mapping
        The figures with their error bars.
    unsettled, most_unsettled : int
        Number of grids so far that missed the tolerance, and how many may.
    plan : Plan
        Accuracy, tolerance and largest grid.
    """
    figures = settled.reading.figures
    error = plan.aim.worst({name: of.error for name, of in estimates.items()}, figures)
    met = level.film.balance.worst <= plan.tolerance
    resolved = min(settled.reading.film_min, estimates["film_min"].value) > 0
    if met and resolved and error <= plan.accuracy:
        return Ending.ACCURATE.stop()
    domains = {name: of.domain for name, of in estimates.items()}
    domain = plan.aim.worst(domains, figures)
    if np.isfinite(domain) and domain > plan.accuracy:
        if plan.aim.without(*HEAT_FIGURES).worst(domains, figures) > plan.accuracy:
            return Ending.WINDOW_OF_FILM.stop(error=percent(domain))
        # temperatures go on to finer grids, without which nothing is known of what the grids leave
        grids = {name: of.grid for name, of in estimates.items()}
        if plan.aim.worst(grids, figures) <= domain:
            return Ending.WINDOW_OF_HEAT.stop(error=percent(domain))
    last = level.grid.finer().nodes > plan.largest_grid
    if not met and (last or unsettled >= most_unsettled):
        return _not_met(level, plan)
    but_for = _accurate_but_for(level, settled, estimates, plan) if met and resolved else None
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
    """Temperatures whose error is that of the approximation of conduction, which no grid mends.

    All else of their error is within the accuracy.
    """

    def is_bound(name: str, conduction: float) -> bool:
        aim = replace(plan.aim, figures=(name,))
        rest = aim.worst({name: estimates[name].error - conduction}, figures)
        least = aim.worst({name: conduction}, figures)
        return least > error_budget.CONDUCTION * plan.accuracy and rest <= plan.accuracy

    return tuple(name for name, of in level.conduction_errors().items() if is_bound(name, of))


def _not_met(level: Level, plan: Plan) -> Stop:
    """Names the equations that are not met."""
    if level.film.unsolved():
        return Ending.NO_SHEAR_STRESS.stop(places=level.film.unsolved())
    worst = level.film.balance.worst
    if not worst <= HOPELESS:
        return Ending.NO_FILM.stop()
    return Ending.RESIDUAL.stop(residual=worst, tolerance=plan.tolerance)


def _accurate_but_for(
    level: Level, settled: Settled, estimates: Mapping[str, Estimate], plan: Plan
) -> Stop | None:
    """The end that names temperatures which no grid allowed brings to the accuracy, if all else has it."""
    figures = settled.reading.figures
    errors = {name: of.error for name, of in estimates.items()}

    def without(*names: str) -> bool:
        return plan.aim.without(*names).worst(errors, figures) <= plan.accuracy

    hottest = "temperature_max_film"
    if (
        spike_stays(settled.reading, level.grid, plan.largest_grid)
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
