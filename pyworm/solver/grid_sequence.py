"""Newton's method on grids of halving spacing until the error bars are within the accuracy."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from time import perf_counter, process_time

import numpy as np
import xarray as xr

from pyworm.io.progress import Progress
from pyworm.io.variables import describe
from pyworm.kernel.core import NO_MEMORY, KernelError
from pyworm.planning.plan import Plan
from pyworm.scene.index import Place
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.contact import Ladder
from pyworm.solver.error_estimate import (
    LEAST_PEAK,
    Reading,
    domain_errors,
    grid_errors,
    hot_spike,
    peak_errors,
    unresolved,
)
from pyworm.solver.level import Rung
from pyworm.solver.line.contact import LineLadder
from pyworm.solver.memory import NoMemoryError, shortage
from pyworm.solver.newton import ALGEBRA_SHARE, HOPELESS, Settled, Stride, lead, settle
from pyworm.solver.point.contact import PointLadder
from pyworm.solver.prospect import refusal
from pyworm.solver.sharp_edge import CURE, rests_on_edge
from pyworm.solver.solution import Cost, Estimate, Figures, Solution
from pyworm.solver.timing import convolution_seconds
from pyworm.solver.transient import History, marched

LADDERS: dict[type, type[Ladder]] = {Scene: PointLadder, LineScene: LineLadder}
"""The climb of each kind of contact, by its scene."""

ACCURATE = "the figures are as accurate as asked for"
"""The stop reason of a converged solution, or how it begins."""

DOMAIN_SHARE = 0.3
"""Error of the films by the window beyond which the wider one is taken, as a share of the accuracy."""

TELLING = 1e-2
"""Residual beyond which the figures of a grid tell nothing of an error, unless the tolerance is larger."""

MOST_UNSETTLED = 2
"""Grids of the figures that may stay short of the tolerance: one too coarse for its film is no failure."""


def solve_on_grids(
    scene: Scene | LineScene, plan: Plan, tell: Progress, foot: Rung | None
) -> tuple[Solution, Rung]:
    """Solve a scene as it is; from a rung of the same grid, if there is one, solved with fewer effects.

    Returns the first rung of the figures too.
    """
    climb = LADDERS[type(scene)]
    domain: dict[str, float] = {}
    readings: list[Reading] = []
    unsettled = refinements = 0

    short = shortage(max((*plan.grids, *plan.wider_grids), key=lambda grid: grid.nodes), plan.model)
    if short is not None:
        raise NoMemoryError(short)
    started, started_work = perf_counter(), process_time()
    tell(f"{scene.name}: {'first grids' if scene.past is None else 'its past'}", 0.0)
    history = None if scene.past is None else marched(scene, plan, climb)
    ladder = climb(scene, plan, history and history.storage)
    if history is not None:
        rung, strides = history.rung, []
    elif isinstance(foot, ladder.rungs) and foot.grid == plan.grids[-1]:
        rung, strides = ladder.resume(foot)
    else:
        rung, strides = ladder.enter(plan.grids)
    foot = rung
    while True:
        settled = _settle_figures(rung, plan)
        strides += settled.strides
        if rung.film.balance.worst <= max(plan.tolerance, TELLING):
            readings.append(settled.reading)
        unsettled += rung.film.balance.worst > plan.tolerance
        stop_reason = (history and history.flaw) or refusal(
            plan, readings, ladder.convergence.orders, rung.grid.finer()
        )
        sound = _film_is_sound(rung, settled, plan)
        if stop_reason is None and sound and plan.wider_grids and not domain:
            tell(f"{scene.name}: wider window", 1 - 0.7 ** (refinements + 1))
            try:
                wider, settled_wider, steps = _in_wider_window(ladder, plan, refinements)
            except KernelError as error:
                stop_reason = _lack_of_memory(error)
            else:
                strides += steps
                if _film_is_sound(wider, settled_wider, plan):
                    domain = domain_errors(
                        settled.reading,
                        settled_wider.reading,
                        ladder.convergence.window_limits,
                        {
                            name: of + settled_wider.algebra[name]
                            for name, of in settled.algebra.items()
                        },
                    )
                    seen = plan.aim.worst(domain, settled.reading.figures)
                    if seen > DOMAIN_SHARE * plan.accuracy:
                        left = ladder.convergence.wider_shares
                        domain = {name: left[name] * error for name, error in domain.items()}
                        rung, settled, readings = wider, settled_wider, [settled_wider.reading]
        estimates = _estimates(ladder, rung, readings, domain, settled, plan, history)
        stop_reason = stop_reason or _stop_reason(rung, settled, estimates, unsettled, plan)
        if stop_reason is not None:
            break
        size = " x ".join(str(count) for count in rung.grid.finer().shape)
        refinements += 1
        tell(f"{scene.name}: {size}", 1 - 0.7 ** (refinements + 1))
        try:
            rung, steps = _finer(ladder, rung, plan)
        except KernelError as error:
            stop_reason = _lack_of_memory(error)
            break
        strides += steps
    seconds, work = perf_counter() - started, process_time() - started_work

    unit = convolution_seconds(rung.film)
    outcome = ladder.outcome(rung)
    stop_reason = outcome.flaw or stop_reason
    converged = stop_reason.startswith(ACCURATE)
    if not converged and rests_on_edge(outcome.fields):
        stop_reason += CURE
    solution = Solution(
        name=scene.name,
        kind=ladder.kind,
        **asdict(Place.of(scene)),
        load=scene.load,
        converged=converged,
        stop_reason=stop_reason,
        figures=Figures(
            **estimates,
            film_min_at=settled.reading.film_min_at,
            load_error=rung.film.balance.load_error,
            residual=rung.film.balance.residual,
            **outcome.figures,
        ),
        regime=plan.regime,
        fields=outcome.fields,
        history=_history(strides, "xy"[: len(rung.grid.shape)]),
        cost=Cost(seconds, work / unit, unit),
        inlet_temperature=scene.oil.heat.inlet_temperature if plan.model.heated else None,
        composite_roughness=scene.composite_roughness,
        profile=outcome.profile,
        accuracy=plan.accuracy,
    )
    return solution, foot


def _in_wider_window(
    ladder: Ladder, plan: Plan, refinements: int
) -> tuple[Rung, Settled, list[Stride]]:
    """The figures on as fine a grid in the plan's wider window."""
    rung, strides = ladder.enter(plan.wider_grids)
    for _ in range(refinements):
        strides += lead(rung, plan.tolerance)
        rung, steps = _finer(ladder, rung, plan)
        strides += steps
    settled = _settle_figures(rung, plan)
    return rung, settled, [*strides, *settled.strides]


def _finer(ladder: Ladder, rung: Rung, plan: Plan) -> tuple[Rung, list[Stride]]:
    """The rung of half the spacing; NoMemoryError where it will not fit."""
    short = shortage(rung.grid.finer(), plan.model)
    if short is not None:
        raise NoMemoryError(short)
    return ladder.higher(rung)


def _lack_of_memory(error: KernelError) -> str:
    """What to say of it; any other error is raised again."""
    if error.status != NO_MEMORY:
        raise error
    return str(error)


def _film_is_sound(rung: Rung, settled: Settled, plan: Plan) -> bool:
    """Whether the equations are met by a film that is positive everywhere."""
    return rung.film.balance.worst <= plan.tolerance and settled.reading.film_min > 0


def _estimates(
    ladder: Ladder,
    rung: Rung,
    readings: Sequence[Reading],
    domain: Mapping[str, float],
    settled: Settled,
    plan: Plan,
    history: History | None,
) -> dict[str, Estimate]:
    """The figures with their error bars, which are infinite where the film is none."""
    grid = grid_errors(readings or [settled.reading], ladder.convergence.orders)
    grid |= {name: max(grid[name], of) for name, of in peak_errors(settled.reading).items()}
    reasons = {"pressure_max": unresolved(settled.reading)}
    if not _film_is_sound(rung, settled, plan):
        grid = dict.fromkeys(grid, np.inf)
    modelled = rung.model_errors()
    marching = {} if history is None else history.errors
    estimates = {
        name: Estimate(
            ladder.origins.get(name, 0.0) + value,
            grid[name],
            domain.get(name, np.inf),
            settled.algebra[name],
            modelled.get(name, 0.0) + marching.get(name, 0.0),
            reasons.get(name),
        )
        for name, value in settled.reading.figures.items()
    }
    spike, name = hot_spike(settled.reading), "temperature_max_film"
    if spike is not None and estimates[name].error > plan.accuracy:
        bar = np.inf if settled.reading.peaks[name].nodes < LEAST_PEAK else grid[name]
        estimates[name] = replace(estimates[name], grid=bar, reason=spike)
    return estimates


def _settle_figures(rung: Rung, plan: Plan) -> Settled:
    return settle(rung, plan.tolerance, plan.aim, ALGEBRA_SHARE * plan.accuracy)


def _stop_reason(
    rung: Rung, reached: Settled, estimates: Mapping[str, Estimate], unsettled: int, plan: Plan
) -> str | None:
    """Why the climb ends here, or None if it goes on."""
    figures = reached.reading.figures
    error = plan.aim.worst({name: of.error for name, of in estimates.items()}, figures)
    settled = rung.film.balance.worst <= plan.tolerance
    resolved = estimates["film_min"].value > 0
    if settled and resolved and error <= plan.accuracy:
        return ACCURATE
    domain = plan.aim.worst({name: of.domain for name, of in estimates.items()}, figures)
    if np.isfinite(domain) and domain > plan.accuracy:
        return f"the end of the window leaves an error of {domain:.1%}: films depend on surfaces far out"
    last = rung.grid.finer().nodes > plan.largest_grid
    if not settled and (last or unsettled >= MOST_UNSETTLED):
        if rung.film.unsolved():
            return f"the shear stress was not found in {rung.film.unsolved()} places of the film"
        worst = rung.film.balance.worst
        if not worst <= HOPELESS:
            return "no film was found whose stresses and temperatures the laws of the oil bear"
        return f"the residual stayed at {worst:.1e}, {plan.tolerance:.1e} is wanted"
    if not last:
        return None
    if settled and resolved and _accurate_but_for_spike(plan, estimates, figures):
        tip = estimates["temperature_max_film"].reason
        return f"{ACCURATE} but for the film's largest temperature, the {tip}"
    if not resolved:
        return "the largest grid allowed does not resolve the film"
    if np.isinf(error):
        return "the largest grid allowed leaves no second grid, or window, to compare with"
    return f"the largest grid allowed leaves an error of {error:.1%}"


def _accurate_but_for_spike(
    plan: Plan, estimates: Mapping[str, Estimate], figures: Mapping[str, float]
) -> bool:
    """Whether all figures asked for are accurate but the film's largest temperature, the tip of a spike."""
    if "temperature_max_film" not in estimates or estimates["temperature_max_film"].reason is None:
        return False
    others = plan.aim.without("temperature_max_film")
    return (
        others.worst({name: of.error for name, of in estimates.items()}, figures) <= plan.accuracy
    )


def _history(strides: Sequence[Stride], axes: str) -> xr.Dataset:
    """Newton's steps, with the grid points along each of the axes."""
    columns = {
        f"points_{axis}": [stride.points[number] for stride in strides]
        for number, axis in enumerate(axes)
    }
    for name in ("residual", "load_error", "krylov"):
        columns[name] = [getattr(stride, name) for stride in strides]
    for name in strides[0].work if strides else ():
        columns[name] = [stride.work[name] for stride in strides]
    return describe(
        xr.Dataset(
            {name: ("iteration", np.array(values)) for name, values in columns.items()},
            coords={"iteration": np.arange(len(strides))},
        )
    )
