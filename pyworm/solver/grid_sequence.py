"""A contact solved on grids of halving spacing until the error bars are within the accuracy.

The procedure is that of `docs/theory/film.md`: settle the film on a grid; compare with a wider window once;
estimate the errors; stop, or halve the spacing.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from math import inf
from typing import Any, cast

from pyworm.io.progress import Progress
from pyworm.kernel.core import NO_MEMORY, KernelError
from pyworm.planning import error_budget
from pyworm.planning.grid import Grid, nest
from pyworm.planning.line_grid import LineGrid, twice_as_far
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.planning.window import enlarged
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.error_estimate import Reading, change, changes, hot_spike, largest_of_films
from pyworm.solver.estimates import estimates
from pyworm.solver.irreducible import TIME, beyond_refinement, time_would_do
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.levels_across import (
    MAX_FILM_CHANGE,
    UNJUDGED_LEVEL_ERROR,
    EnoughLevels,
    enough_levels,
    is_hot,
)
from pyworm.solver.memory import NoMemoryError, shortage
from pyworm.solver.newton import Iteration, NewtonStep, convergence_history
from pyworm.solver.solution import Estimate, Figures, Solution
from pyworm.solver.stop_reason import (
    CURE,
    MAX_DIVERGED_ON_EDGE,
    MAX_JUDGED_RESIDUAL,
    MAX_UNCONVERGED_GRIDS,
    bound_by_conduction,
    film_is_sound,
    rate_not_accurate,
    refusal,
    rests_on_edge,
    stop_reason,
    with_wider_bars,
)
from pyworm.solver.timing import Stopwatch
from pyworm.solver.transient.transient import Rates, transient
from pyworm.solver.vortex_heat import warmest_circulates
from pyworm.solver.window_limit import (
    WindowLimit,
    by_warmth,
    in_this_window,
    in_wider_window,
    with_falls,
)

MOST_RETRIES = 2
"""Number of grids of the figures that may be too coarse to show the window error of a thin film."""


OF_ONE_SIGN = "pressure_max", "power_loss"
"""Figures that vanish in no film, asked for or not."""

ANOTHER_FILM = 1.0
"""Relative error of one of them by the window above which the windows hold different films: an outline may
bear pressure in one of them, whose flow loses more than all friction does."""

MOST_WIDENINGS = 6
"""Number of times that the window of a heated line is doubled beyond the planned wider one."""


class GridSequence:
    """State of the grid sequence of a contact: its films on grids of halving spacing.

    Its `rates` of change of rho h are None of a steady film; `progress` gets a message and the fraction of
    the work that is done. Its methods raise `KernelError` as `pyworm.solve` does.
    """

    def __init__(
        self,
        scene: Scene | LineScene,
        plan: Plan,
        rates: Rates | None,
        progress: Progress,
        stopwatch: Stopwatch,
    ):
        self._scene, self._progress = scene, progress
        self._requested = self._plan = plan
        self._rates = rates
        self._stopwatch = stopwatch
        self._readings: list[Reading] = []
        self._window: dict[str, WindowLimit] = {}
        self._uncertainties: dict[str, float] = {}
        self._levels_errors: dict[str, float] | None = None
        self._judged: Reading | None = None
        self._unjudged = False
        self._steps: list[NewtonStep] = []
        self._unconverged = self._refinements = self._widenings = 0
        self._time_would_do = False

    def begin(self, warm_start: Level | None) -> Level:
        """The converged film on the first grid of the figures, from one solved there with fewer effects."""
        scene, plan = self._scene, self._plan
        self.check_memory(max((*plan.grids, *plan.wider_grids), key=lambda grid: grid.nodes))
        solver_type = SOLVERS[type(scene)]
        self._tell("first grids", 0.0)
        rates = self._rates
        self._transient = None if rates is None else transient(scene, plan, rates)
        rate = None if self._transient is None else self._transient.rate
        if self._transient is not None and self._transient.usable:
            self._plan = self._transient.attainable(plan)
        self._solver = solver_type(scene, plan, rate)
        if self._transient is not None:
            self._level = self._transient.level
        elif isinstance(warm_start, self._solver.level_type) and (
            warm_start.grid == plan.grids[-1]
        ):
            self._level, self._steps = self._solver.warm_started(warm_start)
        else:
            self._level, self._steps = self._solver.begin(plan.grids)
        self._converge()
        return self._level

    @property
    def wants_finer_rates(self) -> bool:
        """Whether one more transient solve may mend the error that the film's rate of change leaves.

        After the last grid also where that and errors which no grid reduces exceed the accuracy together.
        """
        return self._transient is not None and (self._transient.coarse or self._time_would_do)

    def figures(self) -> dict[str, float] | None:
        """The figures so far; None where there is no film yet."""
        if not film_is_sound(self._level, self._iteration, self._plan):
            return None
        return {name: estimate.value for name, estimate in self._estimates().items()}

    def finish(self) -> Solution:
        """Refine the grid as far as the accuracy asks."""
        stop = self._stop()
        while stop is None:
            stop = self._refine() or self._stop()
        return self._solution(stop)

    def _converge(self) -> None:
        """Settle the film on its grid and keep its figures."""
        self._settle_on_grid()
        self._keep_reading()

    def _settle_on_grid(self) -> None:
        """Settle the film on its grid and read its figures."""
        self._iteration = self._converge_on(self._level)
        self._steps += self._iteration.steps

    def _keep_reading(self) -> None:
        """Keep the figures of a grid whose film tells something of the limit."""
        plan, balance = self._plan, self._level.film.balance
        if balance.worst <= max(plan.tolerance, MAX_JUDGED_RESIDUAL):
            self._readings.append(self._iteration.reading)
        self._unconverged += balance.worst > plan.tolerance

    def _stop(self) -> Stop | None:
        """Estimate the errors; returns how the sequence ends here, or None."""
        plan = self._plan
        if self._solver.circulates(self._level):
            return Ending.CIRCULATING.stop()
        stop = self._rate_not_known() or refusal(
            plan, self._readings, self._solver.convergence.orders, self._level.grid.finer()
        )
        if film_is_sound(self._level, self._iteration, plan):
            if not self._levels_are_judged():
                self._add_levels()
                plan = self._plan
                if self._levels_disagree():
                    return Ending.CIRCULATING.stop()
            if not self._uncertainties:
                self._uncertainties = self._solver.uncertainties(self._level)
            if stop is None and plan.wider_grids and not self._window:
                stop = self._compare_windows()
        stop = stop or stop_reason(
            self._level,
            self._iteration,
            self._estimates(),
            self._unconverged,
            self._max_unconverged,
            plan,
        )
        if stop is None or stop.ending is Ending.LARGEST_GRID:
            return self._beyond_refinement() or stop
        return stop

    def _beyond_refinement(self) -> Stop | None:
        """The end where finer grids do not bring the accuracy; None where they may.

        Temperatures that may be left out of the accuracy in the end do not decide.
        """
        if not film_is_sound(self._level, self._iteration, self._plan):
            return None
        estimates, read = self._estimates(), self._iteration.reading
        bound = bound_by_conduction(self._level, estimates, read.figures, self._plan)
        spike = () if hot_spike(read) is None else ("temperature_max_film",)
        target, accuracy = self._plan.target.without(*bound, *spike), self._plan.accuracy
        sources = self._sources() | {
            "conduction in the bodies": self._level.conduction_errors(),
            "domain truncation": {name: estimate.domain for name, estimate in estimates.items()},
        }
        stop = beyond_refinement(estimates, sources, read.figures, target, accuracy)
        self._time_would_do = stop is not None and time_would_do(
            sources, read.figures, target, accuracy
        )
        return stop

    def _rate_not_known(self) -> Stop | None:
        """The end where the film's rate of change is of no use; None where it is."""
        if self._transient is None or self._transient.flaw is None or self._transient.usable:
            return None
        return Ending.RATE_OF_CHANGE.stop(reason=self._transient.flaw)

    def _levels_are_judged(self) -> bool:
        """Whether the error by the levels across the film is known, on a grid whose film is like this one."""
        if self._levels_errors is None or self._judged is None:
            return self._levels_errors is not None
        return largest_of_films(change(self._judged, self._iteration.reading)) <= MAX_FILM_CHANGE

    def _levels_disagree(self) -> bool:
        """Whether films with more levels are not found or far off, as oil circulates (`vortex_heat`)."""
        if not (self._plan.regime.deflection < 1 and warmest_circulates(self._level)):
            return False
        if not self._levels_errors:
            return self._levels_errors is None
        figures = self._iteration.reading.figures
        return self._plan.target.worst(self._levels_errors, figures) > self._plan.accuracy

    @property
    def _max_unconverged(self) -> int:
        """Number of grids that may miss the tolerance."""
        diverged = self._unconverged >= MAX_DIVERGED_ON_EDGE and self._readings
        on_edge = diverged and rests_on_edge(self._solver.outcome(self._level).fields)
        return MAX_DIVERGED_ON_EDGE if on_edge else MAX_UNCONVERGED_GRIDS

    def _add_levels(self) -> None:
        """Give the film more levels across it if it is so hot that the planned ones may not do.

        Where no film with more levels is found the next grids are tried, before which no error is known.
        """
        here = self._iteration.reading
        if not (self._plan.model.heated and is_hot(self._scene, here.figures)):
            self._levels_errors = {}
            return
        film = EnoughLevels(self._plan, self._solver, self._level, self._iteration, {})
        found = enough_levels(film, self._transient, again=self._judged is not None)
        if found is None:
            if self._judged is None:
                self._unjudged = self._refinements < MOST_RETRIES
                known = (
                    None if self._unjudged else dict.fromkeys(here.figures, UNJUDGED_LEVEL_ERROR)
                )
                self._levels_errors = known
            self._judged = None if self._unjudged else here
            return
        self._unjudged = False
        if found.level is not self._level:
            self._plan, self._solver, self._level = found.plan, found.solver, found.level
            self._steps += found.iteration.steps
            self._iteration, self._readings = found.iteration, [found.iteration.reading]
        self._levels_errors, self._judged = found.errors, self._iteration.reading

    def _refine(self) -> Stop | None:
        """Halve the spacing and settle the film; returns how it ends if that is not possible, or None."""
        self._refinements += 1
        size = " x ".join(str(count) for count in self._level.grid.finer().shape)
        self._tell(size, 1 - 0.7 ** (self._refinements + 1))
        try:
            self._settle_on_finer(self._level)
        except KernelError as error:
            return _lack_of_memory(error)
        self._keep_reading()
        return None

    def _settle_on_finer(self, coarser: Level) -> None:
        """Settle the film on the grid of half the spacing, from the one before or, where that loses it, anew.

        At a sharp edge, whose pressure grows from grid to grid, an interpolated film may be no guess.
        """
        self.check_memory(coarser.grid.finer())
        self._level, steps = self._solver.refined(coarser)
        self._steps += steps
        self._settle_on_grid()
        # where there are steps it has begun anew already
        if self._level.diverged() and not (steps or coarser.diverged()):
            self._level, steps = self._solver.begun_again(coarser)
            self._steps += steps
            self._settle_on_grid()

    def _solution(self, stop: Stop) -> Solution:
        scene, plan, level = self._scene, self._plan, self._level
        solves = 0 if self._rates is None else len(self._rates.found)
        cost = replace(self._stopwatch.cost(level.film), transient_solves=solves)
        outcome = self._solver.outcome(level)
        figures = self._estimates()
        if outcome.flaw is not None:
            stop = outcome.flaw.stop()
        elif film_is_sound(level, self._iteration, plan):
            read = self._iteration.reading.figures
            if stop.ending.accurate and self._transient is not None and self._transient.flaw:
                stop = rate_not_accurate(stop, self._transient.flaw, figures, read, self._requested)
            stop = with_wider_bars(stop, figures, read, self._requested)
        converged = stop.ending.converged
        if not converged and rests_on_edge(outcome.fields):
            stop = replace(stop, reason=stop.reason + CURE)
        datasets: dict[str, Any] = {
            "fields": outcome.fields,
            "history": convergence_history(self._steps, level.grid),
            "profile": outcome.profile,
            "life": None if self._transient is None else self._transient.life,
        }
        return Solution(
            name=scene.name,
            kind=self._solver.kind,
            **asdict(ContactIndex.of(scene)),
            load=scene.load,
            converged=converged,
            ending=stop.ending,
            stop_reason=stop.reason,
            figures=Figures(
                **cast("dict[str, Any]", figures),
                film_min_at=self._iteration.reading.film_min_at,
                load_error=level.film.balance.load_error,
                residual=level.film.balance.residual,
                **_extrapolated(outcome.figures, figures["film_min"]),
            ),
            regime=plan.regime,
            cost=cost,
            inlet_temperature=scene.oil.thermal.inlet_temperature if plan.model.heated else None,
            composite_roughness=scene.composite_roughness,
            **datasets,
            accuracy=self._requested.accuracy,
            accuracy_of=self._accurate_in(figures),
        )

    def _accurate_in(self, figures: Mapping[str, Estimate]) -> tuple[str, ...]:
        """Figures that the accuracy applies to: those asked for that grids may bring to it."""
        read = self._iteration.reading.figures
        bound = bound_by_conduction(self._level, figures, read, self._requested)
        return self._requested.target.without(*bound).figures

    def _compare_windows(self) -> Stop | None:
        """Estimate the window errors from a wider window; returns how it ends if that fails, or None.

        Where they are large the sequence continues in the wider window.
        """
        plan, solver = self._plan, self._solver
        if self._level.holds_all_pressure() and not plan.model.heated:
            exact = WindowLimit(0.0, 0.0)
            self._window = dict.fromkeys(self._iteration.reading.figures, exact)
            return None
        self._tell("wider domain", 1 - 0.7 ** (self._refinements + 1))
        try:
            wider, iteration = self._in_wider_window(plan.wider_grids)
            seen = self._falls_seen(iteration.reading)
        except KernelError as error:
            return _lack_of_memory(error)
        if not film_is_sound(wider, iteration, plan):
            return None if self._refinements < MOST_RETRIES else Ending.NO_WIDER_FILM.stop()
        here = self._iteration.reading
        algebra = {
            name: algebraic + iteration.algebra[name]
            for name, algebraic in self._iteration.algebra.items()
        }
        pair = here, iteration.reading, with_falls(solver.convergence, seen), algebra
        cut_off = solver.cut_off(self._level, wider)
        near, far = in_this_window(*pair), in_wider_window(*pair, cut_off)
        if self._level.holds_all_pressure():
            beta = self._scene.oil.beta
            near, far = (by_warmth(limits, iteration.reading, beta) for limits in (near, far))
        worst_near, worst_far = (
            plan.target.worst({name: limit.error for name, limit in limits.items()}, here.figures)
            for limits in (near, far)
        )
        films_off = max(far[name].error for name in ("film_min", "film_central"))
        if worst_far > plan.accuracy and self._widen(films_off):
            self._level, self._iteration, self._readings = wider, iteration, [iteration.reading]
            return self._compare_windows()
        may_refine = self._level.grid.finer().nodes <= plan.largest_grid
        another = any(far[name].error > ANOTHER_FILM for name in OF_ONE_SIGN if name in far)
        if (worst_far > plan.accuracy or another) and may_refine:
            if self._refinements < MOST_RETRIES:
                return None  # to be compared on the next grid, which resolves the film better
        self._window = near
        if cut_off or worst_near > error_budget.WINDOW * plan.accuracy:
            self._window = far
            self._level, self._iteration, self._readings = wider, iteration, [iteration.reading]
        return None

    def _widen(self, films_off: float) -> bool:
        """Plan a window of twice the reach of the wider one, by which films are so far off, if it may help.

        Bodies of different temperatures exchange heat through the oil far before a line contact. Friction
        and pressure of a point contact of large radii and light load spread far where films hardly change.
        """
        (narrow, *_), (*_, wide) = self._plan.grids, self._plan.wider_grids
        if isinstance(narrow, LineGrid) and isinstance(wide, LineGrid):
            if not self._plan.model.heated or self._widenings >= MOST_WIDENINGS:
                return False
            farther: Grid | LineGrid = twice_as_far(narrow, wide)
        else:
            if films_off > self._plan.accuracy or self._refinements + self._widenings > 0:
                return False
            farther = self._farther(wide)
        if farther == wide:
            return False
        self._plan = replace(self._plan, grids=(wide,), wider_grids=(farther,))
        self._widenings += 1
        return True

    def _farther(self, wide: Grid | LineGrid) -> Grid | LineGrid:
        """A grid of a point contact that reaches twice as far as the wider one, up to the surfaces' ends."""
        if not (isinstance(wide, Grid) and isinstance(self._scene, Scene)):
            return wide
        box = enlarged(self._scene, wide.box, 2.0)
        return nest(box, box, *wide.spacing)[-1]

    def _falls_seen(self, wider: Reading) -> dict[str, float]:
        """Ratio of a temperature's changes from window to window of a heated line, from a third one.

        Empty of other contacts. Falls of a film that is not found make error bars wider.
        """
        narrow, wide = self._plan.grids[0], self._plan.wider_grids[0]
        if not (isinstance(narrow, LineGrid) and isinstance(wide, LineGrid)):
            return {}
        if not self._plan.model.heated:
            return {}
        _, iteration = self._in_wider_window((twice_as_far(narrow, wide),))
        first = changes(self._iteration.reading, wider)
        second = changes(wider, iteration.reading)
        return {name: abs(second[name] / first[name]) for name in HEAT_FIGURES if first[name] != 0}

    def _in_wider_window(self, grids: Sequence[Grid | LineGrid]) -> tuple[Level, Iteration]:
        *_, grid = grids
        for _ in range(self._refinements):
            grid = grid.finer()
        self.check_memory(grid)
        level, steps = self._solver.in_wider_window(grids, self._level)
        iteration = self._converge_on(level, error_budget.WIDER_WINDOW_ALGEBRA)
        self._steps += [*steps, *iteration.steps]
        return level, iteration

    def check_memory(self, grid: Grid | LineGrid) -> None:
        """Raise NoMemoryError for a grid that memory will not hold."""
        short = shortage(grid, self._plan.model, stores=self._rates is not None)
        if short is not None:
            raise NoMemoryError(short)

    def _converge_on(self, level: Level, fraction: float = 1.0) -> Iteration:
        """Converge a level, if need be through larger stresses; `fraction` is of its algebraic error."""
        plan = self._plan
        wanted = fraction * error_budget.ALGEBRA * plan.accuracy
        iteration = self._solver.converged(level, plan, wanted)
        if level.film.balance.worst <= plan.tolerance:
            return iteration
        if self._solver.circulates(level):
            return iteration  # larger stresses do not mend that
        steps = self._solver.continued_from_larger_stresses(level)
        if steps:
            self._steps += [*iteration.steps, *steps]
            iteration = self._solver.converged(level, plan, wanted)
        return iteration

    def _estimates(self) -> dict[str, Estimate]:
        return estimates(
            self._solver,
            self._level,
            self._readings,
            self._window,
            self._iteration,
            self._plan,
            self._approximations(),
            self._uncertainties,
        )

    def _approximations(self) -> dict[str, float]:
        """Relative error of each figure by the levels across the film and by the integration in time."""
        errors = self._sources().values()
        return {
            name: sum(of_source.get(name, 0.0) for of_source in errors)
            for name in self._iteration.reading.figures
        }

    def _sources(self) -> dict[str, dict[str, float]]:
        """These errors by their source."""
        known = self._levels_errors or {}
        planned = inf if self._unjudged else self._plan.model.level_error
        return {
            "levels across the film": {
                name: known.get(name, planned) for name in self._iteration.reading.figures
            },
            TIME: {} if self._transient is None else self._transient.errors,
        }

    def _tell(self, what: str, fraction: float) -> None:
        self._progress(f"{self._scene.name}: {what}", fraction)


def _lack_of_memory(error: KernelError) -> Stop:
    """The end by a lack of memory; any other error is raised again."""
    if error.status != NO_MEMORY:
        raise error
    return Ending.MEMORY.stop(reason=str(error))


def _extrapolated(figures: Mapping[str, Any], film_min: Estimate) -> dict[str, Any]:
    """Figures of the last grid, the minimum film on the centre line extrapolated as that of the contact."""
    exit_min = figures.get("film_exit_min")
    if exit_min is None or not film_min.on_grid:
        return dict(figures)
    by = film_min.value / film_min.on_grid
    return {**figures, "film_exit_min": max(exit_min * by, film_min.value)}
