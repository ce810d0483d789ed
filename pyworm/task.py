"""A task: one scene to be solved, told by what decides its solution, and small enough to send anywhere."""

import json
import platform
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from functools import cache, cached_property
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

import pyworm
from pyworm.case import Case
from pyworm.line.scene import LineScene
from pyworm.origin import origin
from pyworm.place import Place
from pyworm.planning import Plan, plan
from pyworm.result import FORMAT_VERSION, Result
from pyworm.scene import Scene
from pyworm.solver import Progress, solve

KEY_LENGTH = 24
"""Hexadecimal digits of a key: 96 bits, so that no two of any number of scenes ever share one."""


@dataclass(frozen=True)
class Task:
    """One scene of a case and how accurately to solve it.

    Sent to another process it takes along its plan, if it has been made, and makes its scene again there.

    Attributes
    ----------
    case : Case
        The case.
    place : Place
        Which of its contacts.
    accuracy : float
        Relative error wanted [-].
    effects : str
        Which effects to simulate, as `pyworm.plan` takes it.
    quantities : tuple of str or None
        What is asked for, likewise.
    """

    case: Case
    place: Place
    accuracy: float
    effects: str = "auto"
    quantities: tuple[str, ...] | None = None

    @cached_property
    def scene(self) -> Scene | LineScene:
        """The contact; CaseError if there is none."""
        return self.case.scene(**self.place.given)

    @cached_property
    def plan(self) -> Plan:
        """How it is solved; ValueError if it cannot be planned so."""
        return plan(self.scene, self.accuracy, self.effects, self.quantities)

    @property
    def identity(self) -> dict[str, Any]:
        """Everything that decides the solution, down to the program; JSON-able."""
        return {
            "program": program_digest(),
            "result_format": FORMAT_VERSION,
            "case": self.case.physics,
            "place": self.place.given,
            "accuracy": self.accuracy,
            "effects": self.effects,
            "quantities": self.quantities,
        }

    @cached_property
    def key(self) -> str:
        """Name of the solution by what decides it."""
        return key_of(self.identity)

    def __reduce__(self) -> tuple:
        given = self.case, self.place, self.accuracy, self.effects, self.quantities
        return Task, given, {"plan": self.plan} if "plan" in vars(self) else None

    def solved(self, progress: Progress | None = None) -> Result:
        """Solve the scene.

        Parameters
        ----------
        progress : callable, optional
            As of `pyworm.solve`.

        Raises
        ------
        KernelError
            The kernel gave it up.
        """
        solution = solve(self.scene, self.plan, progress=progress)
        if self.case.drive is not None:
            beside = self.case.drive.scene_data(self.scene)
            solution = replace(solution, fields=solution.fields.merge(beside))
        return Result(
            self.case.name,
            self.case.resolved,
            (solution,),
            None,
            provenance({self.key: asdict(self.plan)}),
        )


def key_of(identity: dict[str, Any]) -> str:
    """Name of a solution by everything that decides it, `Task.identity`."""
    return sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()[:KEY_LENGTH]


def provenance(plans: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """What made some solutions: the plan of each by its task's key, in their order; JSON-able."""
    return where_and_when() | {"plans": list(plans.values()), "keys": list(plans)}


def where_and_when() -> dict[str, str]:
    """Versions, commit, compiler, kernel, time and machine."""
    return {
        "pyworm": pyworm.__version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        **origin(),
        "machine": platform.machine(),
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
    }


@cache
def program_digest() -> str:
    """Digest of all of pyworm that makes solutions: a changed solver has solved nothing yet."""
    from pyworm import _core

    package = Path(pyworm.__file__).parent
    sources = {
        path.relative_to(package).as_posix(): path
        for path in package.rglob("*")
        if path.is_file() and path.suffix in _DECIDING and "plots" not in path.parts
    }
    sources["_core"] = Path(_core.__file__)
    digest = sha256()
    for name in sorted(sources):
        digest.update(name.encode() + sha256(sources[name].read_bytes()).digest())
    return digest.hexdigest()


_DECIDING = {".py", ".toml", ".json", ".csv", ".npz"}
"""Endings of files of the package that may decide a solution."""
