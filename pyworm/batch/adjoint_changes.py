"""Changes of the figures of contacts by their adjoint solutions, kept as those of solved contacts are.

One worker solves a contact with its adjoint and contracts it with all changes of its inputs: adjoint
solutions do not travel.
"""

import json
from collections.abc import Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from pyworm.batch.task import Task, key_of
from pyworm.case.case import Case
from pyworm.io.atomic import whole_file
from pyworm.io.bounded_number import read_json
from pyworm.kernel.core import KernelError
from pyworm.solver.adjoint import adjoint_of

ADJOINTS = "adjoints"
"""Directory, beside that of solved contacts, of what adjoint solutions gave."""


@dataclass(frozen=True)
class MovedContact:
    """A contact, and pairs of cases that lie close about its own."""

    task: Task
    """The contact and how it is solved."""
    sides: tuple[tuple[Case, Case], ...]
    """Lower and higher case of each pair."""

    @property
    def key(self) -> str:
        """Key of its changes: a digest of everything that decides them."""
        sides = [[case.physics for case in pair] for pair in self.sides]
        return key_of({"task": self.task.identity, "sides": sides})

    def changes(self) -> dict[str, Any]:
        """Its figures, and their changes from the lower to the higher case of each pair [SI].

        Raises:
            ValueError: A contact that has no adjoint, or a case without the contact.
            KernelError: If memory does not suffice.
        """
        adjoint, place = adjoint_of(self.task.scene, self.task.plan), self.task.place.given
        return {
            "figures": dict(adjoint.figures),
            "changes": [
                adjoint.change(high.scene(**place), low.scene(**place)) for low, high in self.sides
            ],
        }


def changes_of(
    contacts: Sequence[MovedContact], directory: Path, executor: Executor | None = None
) -> list[dict[str, Any]]:
    """Figures and changes of each contact; of one without an adjoint `reason` instead."""
    spread = map if executor is None else executor.map
    return list(spread(partial(_kept, directory.absolute() / ADJOINTS), contacts))


def _kept(directory: Path, contact: MovedContact) -> dict[str, Any]:
    file = directory / f"{contact.key}.json"
    with suppress(OSError):  # not there
        known: dict[str, Any] = read_json(file.read_bytes())
        return known
    try:
        found = contact.changes()
    except (ValueError, KernelError) as error:
        return {"reason": str(error)}
    directory.mkdir(parents=True, exist_ok=True)
    with whole_file(file) as partial_file:
        partial_file.write_text(json.dumps(found))
    return found
