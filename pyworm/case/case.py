"""A case: the user's input, checked completely before any work starts."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from math import isfinite
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from pyworm.case.case_file import CaseTable, PublishedValue
from pyworm.case.contact import GapCase, PointCase, contact_scene
from pyworm.case.deviation_file import with_deviations
from pyworm.case.drive_case import DriveCase
from pyworm.case.fitted_values import with_fitted
from pyworm.case.kinds import case_model, kind_model
from pyworm.case.python_input import as_file
from pyworm.case.ratings import RATING_TABLES
from pyworm.case.uncertain_inputs import UncertainInputs, best_estimates
from pyworm.case.unusual import unusual
from pyworm.drives.drive import Drive
from pyworm.io import units
from pyworm.io.input_error import CaseError, sentence
from pyworm.io.present import present
from pyworm.io.quantity_text import percent
from pyworm.io.shown import Shown
from pyworm.io.stage import stage
from pyworm.io.toml import read_toml
from pyworm.scene.index import INDEX_NAMES, ContactIndex, combinations
from pyworm.scene.line import LineScene
from pyworm.scene.plausibility import beyond_limits, doubts, require_possible
from pyworm.scene.point import Scene

ModelT = TypeVar("ModelT", bound=BaseModel)

NO_PHYSICS: dict[str, bool | set[str]] = {
    **dict.fromkeys(
        (
            *("title", "source", "published", "assumed", "accuracy", "effects", "quantities"),
            *RATING_TABLES,
            *("duty", "running_in"),
        ),
        True,
    ),
    "operation": {"sections", "phases", "stations"},
    "motion": {"slide_roll_ratios"},
}
"""Keys of case files that do not affect a contact."""

MESH_PLACES = {"section": "sections", "phase": "phases", "station": "stations"}
"""Name of a place in a drive's mesh -> key of `[operation]` that lists those to be solved."""


@dataclass(frozen=True, repr=False)
class Case(Shown):
    """A checked case; makes the scenes that are to be solved."""

    name: str
    """File name without its ending."""
    directory: Path
    """Where the case file lies; files that it names are relative to it."""
    tables: Any  # a CaseTable, of which each kind of case has its own with further keys
    """The file, in SI."""
    doubts: tuple[str, ...] = ()
    """Unusual values in the file and its contacts, as sentences of `warnings`."""
    content: dict[str, Any] = field(default_factory=dict, compare=False)
    """The file as written, with best estimates of uncertain inputs; empty of a case stored in a result."""
    uncertain: UncertainInputs = field(default_factory=UncertainInputs, compare=False)
    """Inputs that are written with an uncertainty."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the case in words."""
        return f"Case {self.name}", {
            "title": self.title,
            "contacts": f"{len(self.places())}",
            "accuracy": percent(self.accuracy, 3),
            "effects": ", ".join(self.effects),
            "warnings": f"{len(self.warnings)}",
        }

    @property
    def _common(self) -> CaseTable:
        """The tables by the keys that all kinds of cases share."""
        return self.tables

    @property
    def title(self) -> str:
        """Title of the case."""
        return self._common.title

    @property
    def source(self) -> str:
        """Source of the case's numbers."""
        return self._common.source

    @property
    def accuracy(self) -> float:
        """Relative error wanted in films and maximum pressure [-]."""
        return self._common.accuracy

    @property
    def published(self) -> dict[str, PublishedValue]:
        """Numbers that the source prints, by name."""
        return self._common.published

    @property
    def body_names(self) -> tuple[str, str]:
        """What the bodies of its contacts are called: worm and wheel of a worm drive."""
        first, second = type(self.tables.bodies).model_fields
        return first.replace("_", " "), second.replace("_", " ")

    @property
    def effects(self) -> tuple[str, ...]:
        """Effects to simulate by default, as an argument of `pyworm.plan`."""
        return self._common.effects

    @property
    def quantities(self) -> tuple[str, ...] | None:
        """Quantities that have to be accurate by default, likewise."""
        return self._common.quantities

    @property
    def mesh_places(self) -> dict[str, tuple[Any, ...]]:
        """Sections, phases and stations of the mesh of its gears to solve, by name; empty without gears.

        Phases at which the contact carries no load are omitted, unless none carries any.
        """
        listed = self._listed_places
        if "phase" not in listed:
            return listed
        return {**listed, "phase": _without(self._idle_phases, listed["phase"])}

    @property
    def _listed_places(self) -> dict[str, tuple[Any, ...]]:
        """Places of the mesh as they are listed."""
        if self.drive is None:
            return {}
        operation = self.tables.operation
        return {
            name: getattr(operation, key) or ()
            for name, key in MESH_PLACES.items()
            if hasattr(operation, key)
        }

    @cached_property
    def _idle_phases(self) -> tuple[float, ...]:
        """Listed phases at which neighbouring contacts carry all of the load."""
        return self.idle_phases(self._listed_places.get("phase", ()))

    def idle_phases(self, phases: Sequence[float]) -> tuple[float, ...]:
        """Those of some phases at which neighbouring contacts carry all of the load."""
        if self.drive is None:
            return ()
        return tuple(phase for phase in phases if 0 <= phase <= 1 and self.drive.idle(phase))

    @property
    def phases_under_load(self) -> tuple[float, ...]:
        """Tenths of the mesh cycle at which the contact of its gears carries load; empty without gears."""
        if self.drive is None:
            return ()
        return tuple(tenth / 10 for tenth in range(1, 10) if not self.drive.idle(tenth / 10))

    @property
    def slide_roll_ratios(self) -> tuple[float, ...]:
        """Slide-roll ratios of a traction curve; empty where velocities are given, or gears."""
        tables = self.tables
        if not isinstance(tables, PointCase | GapCase):
            return ()
        return tables.motion.slide_roll_ratios or ()

    @property
    def resolved(self) -> dict[str, Any]:
        """The whole case as plain numbers in SI, defaults filled in: for provenance."""
        return {"name": self.name, **self.tables.model_dump(mode="json")}

    @property
    def physics(self) -> dict[str, Any]:
        """The physics of the case: its tables in SI without names, comparisons, accuracy and lists of places.

        A file that the case names is there with a digest of what it holds.
        """
        tables: dict[str, Any] = self._common.model_dump(mode="json", exclude=NO_PHYSICS)
        if isinstance(self.tables, GapCase):
            content = (self.directory / self.tables.contact.file).read_bytes()
            tables["contact"]["file"] = sha256(content).hexdigest()
        for name, surface in self.tables.bodies.surfaces.items():
            tables["bodies"][name]["surface"] |= surface.contents
        return tables

    @property
    def left_open(self) -> dict[str, tuple[str, ...]]:
        """Unknowns that the solution has to determine by iteration: table -> keys in it."""
        return self.tables.left_open if isinstance(self.tables, DriveCase) else {}

    def with_found(self, found: dict[str, dict[str, Any]]) -> "Case":
        """The case with some values replaced: table -> key -> value."""
        tables = {
            name: getattr(self.tables, name).model_copy(update=values)
            for name, values in found.items()
        }
        return replace(self, tables=self.tables.model_copy(update=tables))

    def __reduce__(self) -> tuple:
        # Files must be found from where the case goes; its drive, once made, goes along with what it knows.
        directory = self.directory.absolute()
        given = self.name, directory, self.tables, self.doubts, self.content, self.uncertain
        return Case, given, {"drive": self.drive} if "drive" in vars(self) else None

    @cached_property
    def drive(self) -> Drive | None:
        """The machine that makes the contacts; None for a contact written directly.

        Raises:
            CaseError: The parts do not make a gear set.
        """
        if not isinstance(self.tables, DriveCase):
            return None
        try:
            drive = self.tables.make_drive()
        except ValueError as error:
            raise CaseError(f"drive.{error}") from error
        try:
            drive.oil_supply  # noqa: B018  a lubrication that is not possible is refused here
        except ValueError as error:
            raise CaseError(f"lubrication.{error}") from error
        return drive

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about unusual values, one sentence each, beginning with the key."""
        if self.drive is None:
            return self.doubts
        brought = self.drive.oil_supply
        idle = ", ".join(f"{phase:g}" for phase in self._idle_phases)
        return (
            *self.doubts,
            *(
                [
                    f"operation.phases: at {idle} neighbouring teeth carry all of the load; not solved"
                ]
                if idle
                else []
            ),
            *(f"drive.{warning}" for warning in self.drive.warnings),
            *(() if brought is None else brought.warnings),
        )

    @property
    def beyond_limits(self) -> tuple[str, ...]:
        """Bodies that are hotter than their material bears, a sentence each."""
        tables = self.tables
        bodies = tables.bodies.pair(tables.oil.oil()) if self.drive is None else self.drive.bodies
        return beyond_limits(self.body_names, bodies)

    def scene(
        self,
        phase: float | None = None,
        slide_roll_ratio: float | None = None,
        section: str | None = None,
        station: float | None = None,
    ) -> Scene | LineScene:
        """One contact at one instant.

        Args:
            phase: Place in the mesh cycle, 0 to 1; by default the first of the case's phases. Only for
                drives.
            slide_roll_ratio: Place on the traction curve; by default the first of the case's slide-roll
                ratios. Only for cases that give a mean velocity.
            section: Section of the worm; by default the first of the case's. Only for drives that have some.
            station: Place along the contact line, 0 to 1; by default the first of the case's, if it lists
                some. Only for drives with contact lines.

        Raises:
            CaseError: No contact at this place, or none that can be; a place given where there is no mesh
                cycle, or a slide-roll ratio where no mean velocity is given.
        """
        if slide_roll_ratio is not None and not self.slide_roll_ratios:
            raise CaseError(
                f"slide-roll ratio {slide_roll_ratio:g}: {self.name} gives no motion.mean_velocity"
            )
        if slide_roll_ratio is not None and not isfinite(slide_roll_ratio):
            raise CaseError(f"slide-roll ratio {slide_roll_ratio:g}: must be finite")
        if self.drive is None:
            for name, value in (("section", section), ("phase", phase), ("station", station)):
                if value is not None:
                    raise CaseError(
                        f"{name} {value}: {self.name} has no mesh cycle, it is one contact"
                    )
            if slide_roll_ratio is None and self.slide_roll_ratios:
                slide_roll_ratio = self.slide_roll_ratios[0]
            scene = contact_scene(self.tables, self.name, self.directory, slide_roll_ratio)
        else:
            place = self._mesh_place({"section": section, "phase": phase, "station": station})
            try:
                scene = self.drive.scene(**place.given)
            except ValueError as error:
                raise CaseError(f"drive at {place}: {error}") from error
        require_possible(scene, self._load_key)
        return scene

    @property
    def _load_key(self) -> str:
        """The key that gives the load."""
        return self.tables.load_key if isinstance(self.tables, DriveCase) else "contact.load"

    def _mesh_place(self, wanted: dict[str, Any]) -> ContactIndex:
        """A position in the mesh, by default the first that the case lists."""
        given: dict[str, Any] = {}
        sections = present(self.drive, "drive").sections
        for name, value in wanted.items():
            listed = self.mesh_places.get(name)
            if value is None:
                given[name] = listed[0] if listed else None
                continue
            if listed is None:
                raise CaseError(f"{name} {value}: the gear set of {self.name} has no {name}s")
            if name == "section" and value not in (*listed, *sections):
                raise CaseError(f"section {value}: choose one of {', '.join(sections)}")
            if name != "section" and not 0 <= value <= 1:
                raise CaseError(f"{name} {value:g}: must lie between 0 and 1")
            given[name] = value
        return ContactIndex(**given)

    def places(self, **wanted: Sequence[Any] | None) -> tuple[ContactIndex, ...]:
        """Places of the contacts to solve: by default those that the case lists.

        Args:
            **wanted: Others, by the names of `ContactIndex`; of several phases those without load are
                omitted.
        """
        if phases := wanted.get("phase"):
            wanted["phase"] = _without(self.idle_phases(phases), phases)
        listed = self.mesh_places | {"slide_roll_ratio": self.slide_roll_ratios}
        return combinations(
            {name: wanted.get(name) or listed.get(name, ()) for name in INDEX_NAMES}
        )

    def scenes(self, **wanted: Sequence[Any] | None) -> Iterator[Scene | LineScene]:
        """The contacts at `places` of these arguments."""
        return (self.scene(**place.given) for place in self.places(**wanted))


def _without(idle: Sequence[float], phases: Sequence[float]) -> tuple[float, ...]:
    """Phases that are not idle; all where none is left."""
    return tuple(phase for phase in phases if phase not in idle) or tuple(phases)


def load(source: str | Path | Mapping[str, Any], name: str = "case") -> Case:
    """Read a case and check it completely.

    Args:
        source: A TOML file; `pyworm example` lists those that come with pyworm. Or its tables as a
            dictionary, with texts or numbers in SI, `oil` and `bodies` as of `WormDrive`.
        name: Name of a case of a dictionary, in tables and pictures.

    Raises:
        CaseError: The first error found, as one line.
    """
    if isinstance(source, Mapping):
        return case_of(as_file(source, name, _model(source)), name, Path())
    if not isinstance(source, str | Path):
        raise CaseError(
            f"case = {source!r:.40}: must be the path of a case file, its tables as a dictionary, or a Case"
        )
    path = Path(source)
    data = read_toml(path)
    try:
        with stage(f"checking the contacts of {path}"):
            return case_of(data, path.stem, path.parent)
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from error


def case_of(data: dict[str, Any], name: str, directory: Path) -> Case:
    """The completely checked case of a case file's content; CaseError as of `load`."""
    case = case_without_contacts(data, name, directory)
    # All contacts are made: the drive must mesh and the gap file must hold a gap.
    found = unusual(case.tables, case.content) + doubts(case.scenes(), case._load_key)
    checked_case = replace(case, doubts=found)
    vars(checked_case).update(drive=case.drive)
    return checked_case


def case_without_contacts(data: dict[str, Any], name: str, directory: Path) -> Case:
    """The case of a content whose tables are checked, and not its contacts, such as one solved before."""
    fitted = with_fitted(data, directory)
    content, uncertain = best_estimates(fitted.content, fitted.correlations)
    tables = _tables(with_deviations(content, directory))
    case = Case(name, directory, tables, content=content, uncertain=uncertain)
    for body, surface in case.tables.bodies.surfaces.items():
        surface.lie_in(directory)
        try:
            surface.waves()
        except ValueError as error:
            raise CaseError(f"bodies.{body}.{error}") from error
    return case


def case_again(resolved: dict[str, Any]) -> Case:
    """The case of a result, from the stored `Case.resolved`; files that it names are no longer found.

    CaseError if this version does not know it, or the result was not made from a case.
    """
    if not resolved:
        raise CaseError("the result has no case file; pyworm explore and pyworm plot show it")
    tables = {key: value for key, value in resolved.items() if key != "name"}
    return Case(resolved.get("name", ""), Path(), _tables(_said(tables), units.SI))


def _said(table: dict[str, Any]) -> dict[str, Any]:
    """A table of a case without the keys that are not given."""
    return {
        key: _said(value) if isinstance(value, dict) else value
        for key, value in table.items()
        if value is not None
    }


def _tables(data: dict[str, Any], context: str | None = None) -> CaseTable:
    """The tables of a case file in SI, by its kind; context as of `checked`."""
    return checked(_model(data), data, context)


def _model(data: Mapping[str, Any]) -> type[CaseTable]:
    """The tables that a case file has, by its kind; CaseError of a content without a kind."""
    if not {"drive", "contact"} & data.keys() and set(RATING_TABLES) & data.keys():
        raise CaseError("gives nothing to be solved, ratings only; pyworm rate shows them")
    if ("drive" in data) == ("contact" in data):
        raise CaseError("give either a [drive] or a [contact], one of the two")
    about = "drive" if "drive" in data else "contact"
    return case_model(about, subject_kind(data, about))


def subject_kind(data: Mapping[str, Any], about: str) -> str:
    """Kind of the subject of a file's content, `drive` or `contact`; CaseError of one that there is not."""
    kind: str = getattr(checked(kind_model(about), dict(data)), about).kind
    return kind


def checked(model: type[ModelT], data: dict[str, Any], context: str | None = None) -> ModelT:
    """The content of a file validated by a model; CaseError with the message about the first error.

    With the context `units.SI` it holds numbers in SI instead of quantities with units.
    """
    try:
        return model.model_validate(data, context=context)
    except ValidationError as error:
        raise CaseError(sentence(error, model, data)) from None
