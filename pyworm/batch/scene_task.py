"""A scene of a script as a task: identified by its content, so that a store knows it again."""

import io
import pickle
from collections.abc import Iterator
from dataclasses import asdict, dataclass, fields, replace
from functools import cached_property
from hashlib import sha256
from types import CodeType, FunctionType, ModuleType
from typing import Any

from pyworm.batch.provenance import program_digest, provenance
from pyworm.batch.task import key_of
from pyworm.io.given import Names
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import AUTO
from pyworm.planning.plan import Plan, plan
from pyworm.result.result import FORMAT_VERSION, Result
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.solve import solve
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.transient import Rates, present_in_life


@dataclass(frozen=True)
class SceneTask:
    """One scene and how accurately to solve it; what `batch.task.Task` is to a contact of a case."""

    scene: Scene | LineScene
    """The contact."""
    accuracy: float
    """Accuracy as `pyworm.plan` takes it."""
    effects: Names = AUTO
    """Effects as `pyworm.plan` takes them."""
    quantities: tuple[str, ...] | None = None
    """Quantities as `pyworm.plan` takes them."""
    largest_grid: int | None = None
    """Nodes beyond which grids are not refined, where fewer than the plan's."""

    @property
    def case(self) -> Any:
        """What scenes of one life have in common, by which they share its transient solve."""
        return self if self.scene.past is None else self.scene.past.life

    @property
    def place(self) -> ContactIndex:
        """Where in a mesh cycle or on a traction curve it is."""
        return ContactIndex.of(self.scene)

    @cached_property
    def plan(self) -> Plan:
        """Plan of the solve; ValueError if it cannot be planned."""
        found = plan(self.scene, self.accuracy, self.effects, self.quantities)
        if self.largest_grid is None:
            return found
        return replace(found, largest_grid=min(self.largest_grid, found.largest_grid))

    @cached_property
    def time_grid(self) -> TimeGrid:
        """The time grid of its life; ValueError if that carries no load in motion."""
        return time_grid_of(present_in_life(self.scene).life, self.plan)

    @cached_property
    def identity(self) -> dict[str, Any]:
        """Everything that decides the solution, including the program; for JSON."""
        return {
            "program": program_digest(),
            "result_format": FORMAT_VERSION,
            "scene": content_digest(self.scene),
            "accuracy": self.accuracy,
            "effects": self.effects,
            "quantities": self.quantities,
            "largest_grid": self.largest_grid,
        }

    @cached_property
    def key(self) -> str:
        """Key of the solution: a digest of its identity."""
        return key_of(self.identity)

    def solved(self, progress: Progress | None = None, rates: Rates | None = None) -> Result:
        """Solve the scene; as of `Task.solved`."""
        solution = solve(self.scene, self.plan, progress, rates)
        kept = provenance({self.key: asdict(self.plan)})
        return Result(self.scene.name, {}, (solution,), None, kept)

    def __reduce__(self) -> tuple:
        given = tuple(getattr(self, part.name) for part in fields(self))
        # the key and the plan are those of the process that has the functions' text
        return SceneTask, given, {"key": self.key, "plan": self.plan, "identity": self.identity}


class _Content(pickle.Pickler):
    """Writes an object with the code of its functions and classes, where `pickle` writes their names."""

    def reducer_override(self, obj: Any) -> Any:
        if isinstance(obj, FunctionType):
            held = tuple(cell.cell_contents for cell in obj.__closure__ or ())
            return str, (repr(_code(obj.__code__)),), (held, obj.__defaults__)
        if isinstance(obj, type) and obj.__module__.split(".")[0] not in _KNOWN:
            attributes = {
                name: _code(value.__code__) if isinstance(value, FunctionType) else repr(value)
                for name, value in sorted(vars(obj).items())
                if isinstance(value, FunctionType | int | float | str)
            }
            return str, (repr((obj.__qualname__, attributes)),)
        if isinstance(obj, ModuleType):
            return str, (obj.__name__,)
        return NotImplemented


_KNOWN = {"pyworm", "numpy", "scipy", "builtins", "functools", "math", "types", "collections"}
"""Packages whose classes are told by their names: `program_digest`, or no part of the program."""


def _code(code: CodeType) -> tuple:
    """What a function does: its code, the names and constants in it, functions within it likewise."""
    constants = tuple(
        _code(constant) if isinstance(constant, CodeType) else repr(constant)
        for constant in code.co_consts
    )
    return code.co_code, code.co_names, constants


def content_digest(content: Any) -> str:
    """Digest of an object, of functions and classes in it by their code, and not by their names alone.

    Global variables that a function reads are not followed.
    """
    written = io.BytesIO()
    _Content(written).dump(content)
    return sha256(written.getvalue()).hexdigest()


def require_sendable(task: SceneTask) -> None:
    """Refuse a scene that cannot be sent to another process; ValueError with what it is and why."""
    for name, part in _parts(task.scene):
        try:
            pickle.dumps(part)
        except Exception:
            what = getattr(part, "__qualname__", type(part).__qualname__)
            raise ValueError(
                f"{task.scene.name}: its {name}, {what}, cannot go to other processes, which find "
                "functions and classes by their names in a module only; define it with def or class at the "
                "top of a module, or solve with processes=1"
            ) from None


def _parts(scene: Scene | LineScene) -> Iterator[tuple[str, Any]]:
    """Attributes of a scene, functions in tuples one by one."""
    for part in fields(scene):
        value = getattr(scene, part.name)
        if isinstance(value, tuple):
            yield from ((f"{part.name}[{place}]", entry) for place, entry in enumerate(value))
        else:
            yield part.name, value
