"""The films of a transient solve, from one of its steps to the next."""

from dataclasses import dataclass, field
from math import inf

from pyworm.io.present import present
from pyworm.planning.grid import Grid
from pyworm.solver.level import Level
from pyworm.solver.transient.heat_memory import HeatedTimeLevel, remembered
from pyworm.solver.transient.next_film import EARLIER_FILMS, heated_levels, reached
from pyworm.solver.transient.restart import Restart
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_level import TimeLevel, time_level_of
from pyworm.solver.transient.time_steps import Step


class TooMuchWorkError(Exception):
    """Films that take more than the largest work."""


@dataclass
class FilmSeries:
    """Films of a transient solve up to one of its steps, and what the next film needs of them."""

    time_grid: TimeGrid
    """The time grid of the life."""
    step: Step
    """The step, at first that of the first film."""
    before: list[TimeLevel]
    """Films before the next step, the latest first."""
    heat: list[HeatedTimeLevel] = field(default_factory=list)
    """Heat of the surfaces at these and earlier times, likewise."""
    held: bool = True
    """Whether the separation of the surfaces is given where they are apart, rather than their load."""
    level: Level | None = None
    """The film of the step."""
    newton_steps: int = 0
    """Newton steps of all films."""
    work: float = 0.0
    """Newton steps of its steps times the nodes of their grids."""
    most_work: float = inf
    """Largest work, beyond which it is given up."""

    def reach(self, step: Step) -> Level:
        """Go on to the film of a step; NoFilmError if none is found, TooMuchWorkError beyond `most_work`."""
        before, heat = _led_on(self.time_grid, self.step, step, self.before, self.heat)
        self.step = step
        if before:
            level, before, heat, taken = reached(self.time_grid, step, before, heat, self.held)
            self._count(taken, level)
            if self.held and level.carried() > self.time_grid.life.touch:
                self.held = False
                level, before, heat, taken = reached(self.time_grid, step, before, heat, False)
                self._count(taken, level)
            self.level = level
        level = present(self.level, "the first film")
        self.heat = [*heated_levels(self.time_grid, level, step.seconds), *heat]
        self.before = [time_level_of(level, step.seconds), *before[: EARLIER_FILMS - 1]]
        return level

    def _count(self, taken: int, level: Level) -> None:
        """Count Newton steps to a film."""
        self.newton_steps += taken
        self.work += taken * level.grid.nodes
        if self.work > self.most_work:
            raise TooMuchWorkError

    def turned(self, time: float) -> tuple[Level, list[TimeLevel]]:
        """The film of a time after the last step by a step of its own, and films up to it, latest first."""
        if not time > self.step.seconds:
            return present(self.level, "the last film"), self.before
        turn = Step(time, self.step.refinement)
        before, heat = _led_on(self.time_grid, self.step, turn, self.before, self.heat)
        level, known, _, taken = reached(self.time_grid, turn, before, heat, self.held)
        self._count(taken, level)
        return level, [time_level_of(level, time), *known]

    def restart(self) -> Restart:
        """The last film and those before it, from which another solve goes on."""
        level = present(self.level, "the last film")
        heat = tuple(remembered(self.heat, level.scene))
        return Restart(self.step, tuple(self.before), heat, self.held)


def _led_on(
    time_grid: TimeGrid,
    last: Step,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
) -> tuple[list[TimeLevel], list[HeatedTimeLevel]]:
    """Films and heat up to a last step on the kind of grid of the next."""
    if step.refinement > last.refinement:
        before, heat = [film.finer() for film in before], [film.finer() for film in heat]
    if time_grid.come_together(last.seconds) and not time_grid.come_together(step.seconds):
        grids = time_grid.grid, time_grid.grid_of_contact
        large, small = (grid(last.seconds, step.refinement) for grid in grids)
        if isinstance(large, Grid) and isinstance(small, Grid):  # lines do not come together
            window = large.window_of(small)
            before, heat = (
                [film.finer(window) for film in before],
                [film.finer(window) for film in heat],
            )
    return before, heat
