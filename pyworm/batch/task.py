"""A task: one scene to be solved, identified by everything that decides its solution."""

import json
from dataclasses import asdict, dataclass, fields, replace
from functools import cached_property
from hashlib import sha256
from typing import Any

from pyworm.batch.provenance import program_digest, provenance
from pyworm.case.case import Case
from pyworm.io.given import Names
from pyworm.io.plain_dataset import merged
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import AUTO
from pyworm.planning.plan import Plan, plan_of
from pyworm.result.result import FORMAT_VERSION, Result
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.solve import solve
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.transient import Rates, present_in_life

KEY_LENGTH = 24
"""Hexadecimal digits of a key: 96 bits, so that no two of any number of scenes ever share one."""


@dataclass(frozen=True)
class Task:
    """One scene of a case and how accurately to solve it.

    Sent to another process it takes along its plan, if it has been made, and makes its scene again there.
    """

    case: Case
    """The case."""
    place: ContactIndex
    """Which of its contacts."""
    accuracy: float
    """Relative error wanted [-]."""
    effects: Names = AUTO
    """Which effects to simulate, as `pyworm.plan` takes them."""
    quantities: tuple[str, ...] | None = None
    """What is asked for, likewise."""
    wider_window: bool = True
    """Whether a wider window is solved too, for the window error; else error bars are without it."""
    largest_grid: int | None = None
    """Nodes beyond which no grid is refined, fewer than the plan's."""

    @cached_property
    def scene(self) -> Scene | LineScene:
        """The contact; CaseError if there is none."""
        return self.case.scene(**self.place.given)

    @cached_property
    def plan(self) -> Plan:
        """Plan of the solve; ValueError if it cannot be planned."""
        found = plan_of(self.scene, self.accuracy, self.effects, self.quantities)
        if not self.wider_window:
            found = replace(found, wider_grids=())
        if self.largest_grid is None:
            return found
        return replace(found, largest_grid=min(self.largest_grid, found.largest_grid))

    @cached_property
    def time_grid(self) -> TimeGrid:
        """The time grid of its life; ValueError if that carries no load in motion."""
        return time_grid_of(present_in_life(self.scene).life, self.plan)

    @property
    def identity(self) -> dict[str, Any]:
        """Everything that decides the solution, including the program; for JSON."""
        return {
            "program": program_digest(),
            "result_format": FORMAT_VERSION,
            "case": self.case.physics,
            "place": self.place.given,
            "accuracy": self.accuracy,
            "effects": self.effects,
            "quantities": self.quantities,
            "wider_window": self.wider_window,
            "largest_grid": self.largest_grid,
        }

    @cached_property
    def key(self) -> str:
        """Key of the solution: a digest of its identity."""
        return key_of(self.identity)

    def __reduce__(self) -> tuple:
        given = tuple(getattr(self, part.name) for part in fields(self))
        return Task, given, {"plan": self.plan} if "plan" in vars(self) else None

    def solved(self, progress: Progress | None = None, rates: Rates | None = None) -> Result:
        """Solve the scene, arguments as of `pyworm.solve`; KernelError if the kernel gives it up."""
        solution = solve(self.scene, self.plan, progress, rates)
        if self.case.drive is not None:
            beside = self.case.drive.scene_data(self.scene)
            solution = solution.changed(fields=merged(solution.dataset("fields"), beside))
        return Result(
            self.case.name,
            self.case.resolved,
            (solution,),
            None,
            provenance({self.key: asdict(self.plan)}),
        )


def key_of(identity: dict[str, Any]) -> str:
    """Key of a solution: a digest of everything that decides it, `Task.identity`."""
    return sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()[:KEY_LENGTH]
