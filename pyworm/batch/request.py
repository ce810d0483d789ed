"""What a script or a command asks of a case: its contacts, accuracy, effects and quantities."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypedDict, TypeVar
from warnings import warn

from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.formulas.ranges import scalar
from pyworm.io import units
from pyworm.io.given import Names, WithUnit, kind_of, number, row, text
from pyworm.io.input_error import CaseError
from pyworm.io.stage import stage
from pyworm.planning.effects.selection import effect_names, quantity_names
from pyworm.scene.index import INDEX_NAMES, ContactIndex
from pyworm.scene.plausibility import UnusualWarning


class Request(TypedDict, total=False):
    """Which contacts of a case are meant, and how they are solved; by default as the case has it."""

    accuracy: WithUnit | None
    """Relative error wanted [-], as of `pyworm.plan`."""
    effects: Names | None
    """Effects to simulate, as of `pyworm.plan`."""
    quantities: Names | None
    """Requested quantities, as of `pyworm.plan`."""
    phases: Sequence[float] | None
    """Mesh phases, 0 to 1."""
    sections: Sequence[str] | None
    """Sections of a roller worm."""
    stations: Sequence[float] | None
    """Positions along contact lines, 0 to 1."""
    slide_roll_ratios: Sequence[float] | None
    """Slide-roll ratios of a traction curve."""


PLACES = {
    "phase": "phases",
    "section": "sections",
    "station": "stations",
    "slide_roll_ratio": "slide_roll_ratios",
}
"""Name of `ContactIndex` -> name of a request that lists such places."""

F = TypeVar("F", bound=Callable[..., Any])


def takes_request(function: F) -> F:
    """Show what a function takes of a request, `**request`, among its arguments: `help` and completion."""
    signature = inspect.signature(function)
    shown = [part for part in signature.parameters.values() if part.kind is not part.VAR_KEYWORD]
    asked = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=hint)
        for name, hint in Request.__annotations__.items()
    ]
    first = sum(part.kind is not part.KEYWORD_ONLY for part in shown)
    parameters = [*shown[:first], *asked, *shown[first:]]
    vars(function)["__signature__"] = signature.replace(parameters=parameters)
    return function


def requested(case: Case, request: Request) -> list[Task]:
    """Tasks of a case as a script asks for them, with an `UnusualWarning` for phases without load.

    Raises:
        CaseError: None of the phases is under load, or a contact that cannot be planned.
        TypeError: An argument that no request has.
    """
    for name in request:
        if name not in Request.__annotations__:
            raise TypeError(
                f"{name} is none of the arguments: {', '.join(Request.__annotations__)}"
            )

    def said(sentence: str) -> None:
        warn(f"{case.name}: {sentence}", UnusualWarning, stacklevel=4)

    wanted = {place: _listed(name, request.get(name)) for place, name in PLACES.items()}
    return planned(case, requested_places(case, wanted, say=said), request)


def _listed(name: str, values: Any) -> tuple[Any, ...] | None:
    """Places in a row, sections by their names and others by numbers; ValueError of anything else."""
    if values is None:
        return None
    given = row(name, values)
    if name == PLACES["section"]:
        return tuple(text(f"{name}[{place}]", value) for place, value in enumerate(given))
    return tuple(scalar(f"{name}[{place}]", value) for place, value in enumerate(given))


def requested_places(
    case: Case,
    wanted: Mapping[str, Any],
    key: str = "phases",
    say: Callable[[str], None] = lambda message: None,
) -> tuple[ContactIndex, ...]:
    """Contacts of a case that are asked for; phases without load, which are omitted, are named.

    Args:
        wanted: Sections, phases, stations and slide-roll ratios, by the names of `ContactIndex`; by default
            the case's.
        key: What phases are called where they are asked for.

    Raises:
        CaseError: None of the phases is under load.
    """
    phases = wanted.get("phase") or ()
    idle = case.idle_phases(asked := phases or case.mesh_places.get("phase", ()))
    words = ", ".join(f"{phase:g}" for phase in idle)
    if idle and len(idle) == len(asked):
        loaded = ", ".join(f"{phase:g}" for phase in case.phases_under_load) or "none of its tenths"
        raise CaseError(
            f"{case.name}: {key if phases else 'operation.phases'} {words}: neighbouring teeth carry all of "
            f"the load; the pair carries some at {loaded}"
        )
    if phases and idle:
        say(f"{key} {words}: neighbouring teeth carry all of the load; not solved")
    return case.places(**{name: wanted.get(name) for name in INDEX_NAMES})


def planned(case: Case, places: Sequence[ContactIndex], request: Request) -> list[Task]:
    """The tasks of some contacts of a case, all planned before the first is solved.

    Raises:
        CaseError: One cannot be planned.
    """
    how = _how(case, request)
    tasks = [Task(case, place, *how) for place in places]
    try:
        with stage(f"planning {len(tasks)} contacts"):
            for task in tasks:
                _ = task.plan
    except ValueError as error:
        raise CaseError(str(error)) from error
    return tasks


def _how(case: Case, request: Request) -> tuple[float, tuple[str, ...], tuple[str, ...] | None]:
    """Accuracy, effects and quantities, those of the case where none are requested."""
    accuracy, effects = request.get("accuracy"), request.get("effects")
    quantities = quantity_names(request.get("quantities"))
    return (
        case.accuracy if accuracy is None else number("accuracy", accuracy, kind_of(units.Share)),
        case.effects if effects is None else effect_names(effects),
        case.quantities if quantities is None else quantities,
    )
