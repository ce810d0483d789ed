"""Figures of a film with their error bars, from grids, windows and the last Newton steps."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pyworm.planning.plan import Plan
from pyworm.solver.contact import ContactSolver
from pyworm.solver.error_estimate import LEAST_PEAK, Reading, hot_spike, peak_errors, unresolved
from pyworm.solver.estimate import Estimate
from pyworm.solver.grid_limit import grid_limits
from pyworm.solver.level import Level
from pyworm.solver.newton import Iteration
from pyworm.solver.stop_reason import film_is_sound
from pyworm.solver.window_limit import WindowLimit


def estimates(
    solver: ContactSolver,
    level: Level,
    readings: Sequence[Reading],
    window: Mapping[str, WindowLimit],
    iteration: Iteration,
    plan: Plan,
    approximations: Mapping[str, float],
    uncertainties: Mapping[str, float],
) -> dict[str, Estimate]:
    """Estimate figures with error bars, which are infinite where the equations are not met.

    `readings` are figures on grids of halving spacing, this one last; `window` is what an endless one adds,
    empty where no wider one was solved: its error is infinite then, or of a plan without one none.
    `iteration` has the algebraic errors; `approximations` are relative errors by levels across the film and
    by integration in time, `uncertainties` those by the model's assumptions.
    """
    limits = grid_limits(readings or [iteration.reading], solver.convergence)
    grid = {name: limit.error for name, limit in limits.items()}
    grid |= {name: max(grid[name], error) for name, error in peak_errors(iteration.reading).items()}
    grid |= {name: grid[name] + left for name, left in iteration.reading.left.items()}
    reasons = {"pressure_max": unresolved(iteration.reading)}
    if not film_is_sound(level, iteration, plan):
        grid = dict.fromkeys(grid, np.inf)
    unknown = WindowLimit(0.0, np.inf if plan.wider_grids else 0.0)
    window = {name: window.get(name, unknown) for name in limits}
    conduction = level.conduction_errors()
    found = {
        name: Estimate(
            solver.origins.get(name, 0.0) + limits[name].value + window[name].rest * abs(value),
            grid[name],
            window[name].error,
            iteration.algebra[name],
            conduction.get(name, 0.0) + approximations.get(name, 0.0),
            reasons.get(name),
            on_grid=solver.origins.get(name, 0.0) + value,
            model=uncertainties.get(name),
            datum=solver.origins.get(name, 0.0),
        )
        for name, value in iteration.reading.figures.items()
    }
    spike, name = hot_spike(iteration.reading), "temperature_max_film"
    if spike is not None and found[name].error > plan.accuracy:
        bar = np.inf if iteration.reading.peaks[name].nodes < LEAST_PEAK else grid[name]
        found[name] = replace(found[name], grid=bar, reason=spike)
    return found
