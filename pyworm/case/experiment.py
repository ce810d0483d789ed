"""Measurements that pyworm is compared with: files of `validation/`, one experiment each.

Only numbers are taken from a source; a file says where they stand, how they were read, and how uncertain they
are. What pyworm computes for them is a case, or an oil.
"""

from collections.abc import Iterator
from math import hypot
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field

from pyworm.case.case import checked
from pyworm.case.case_file import ChosenEffects
from pyworm.case.oil import RoelandsTable
from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.given import kind_of
from pyworm.io.input_error import CaseError
from pyworm.io.plain_values import Text
from pyworm.io.toml import read_toml
from pyworm.io.uncertain import UNIFORM, Uncertain, parse_uncertain
from pyworm.materials.base_stock import Base

KINDS = {
    "film": units.Film,
    "film_central": units.Film,
    "film_min": units.Film,
    "film_exit_min": units.Film,
    "friction_coefficient": units.Share,
    "friction_of_mesh": units.Share,
    "efficiency": units.Share,
    "efficiency_at_rest": units.Share,
    "power_loss": units.Power,
    "temperature_max_body_1": units.Temperature,
    "temperature_max_body_2": units.Temperature,
    "temperature_max_film": units.Temperature,
    "dry_length": units.Length,
    "pressure_viscosity": units.PressureViscosity,
    "viscosity": units.Viscosity,
    "viscosity_rise": units.Share,
    "density": units.OilDensity,
    "limiting_coefficient": units.Share,
}
"""Quantity that may be measured -> its kind."""


class SourceTable(Table):
    """`[source]`: the publication that the numbers are from."""

    author: Text
    year: Annotated[int, Field(strict=True, ge=1800, le=2100)] | None = None
    """None where it is not known."""
    title: Text
    doi: Text | None = None
    through: Text | None = None
    """Through what the numbers were read, where that is not the publication itself."""
    bibliography: Text
    """Anchor of the entry in the bibliography."""
    licence: Literal["numbers only"]


class UncertaintyTable(Table):
    """A standard uncertainty, or the half width of a uniform distribution, and what it rests on."""

    standard: Text | None = None
    half_width: Text | None = None
    basis: Text
    assumed: bool = False
    """Whether the source gives none, so that it is assumed here."""

    def flaws(self) -> Iterator[str]:
        """Both or neither of the two."""
        if len(self.given("standard", "half_width")) != 1:
            yield from self.unless_either("standard", "half_width")
            return
        try:
            width = self._width
        except ValueError as error:
            yield str(error)
            return
        if width.standard or width.value < 0:
            yield 'must be one width that is zero or more, such as "2 %" or "1 K"'

    @property
    def _width(self) -> Uncertain:
        return parse_uncertain(self.standard if self.standard is not None else self.half_width)

    def of(self, value: Uncertain) -> Uncertain:
        """A value with this standard uncertainty instead of its own.

        Raises:
            ValueError: An uncertainty of another kind than the value.
        """
        found = parse_uncertain(f"{value.value!r} {value.unit} +- {self._width.moved()}")
        divisor = UNIFORM if self.standard is None else 1.0
        return Uncertain(found.value, found.standard / divisor, found.unit)


class InputTable(UncertaintyTable):
    """One of `[[inputs]]`: what is uncertain in the case, keys of one cause moving together."""

    keys: Annotated[list[Text], Field(min_length=1)]
    """Dotted keys of the case; of oils "viscosity", "temperature" or "pressure"."""


class ReadingTable(UncertaintyTable):
    """`[reading]`: how the numbers were read, and how exactly."""

    how: Literal["text", "table", "figure", "abstract"]


class MeasuredOilTable(Table):
    """`[oils.NAME]`: an oil by its viscosities at ambient pressure (`NamedOil.from_table`), or a law."""

    base: Base | None = None
    temperatures: list[Text] | None = None
    eta: list[Text] | None = None
    nu: list[Text] | None = None
    viscosity: RoelandsTable | None = None
    """Roelands' law at one temperature, as a case file has it."""

    def flaws(self) -> Iterator[str]:
        """Two ways to a viscosity, or none."""
        if self.viscosity is None:
            yield from self.unless_either("eta", "nu")
            if len(self.given("base", "temperatures")) < 2:
                yield "base and temperatures are missing"
        elif named := self.given("base", "temperatures", "eta", "nu"):
            yield f"{named[0]} has no effect with viscosity"


class RowTable(Table):
    """One of `[[rows]]`: a measured value, and where it belongs."""

    quantity: Text
    value: Text | Annotated[float, Field(strict=True)]
    label: Text
    changes: dict[str, Any] = Field(default_factory=dict)
    """Values of the case by dotted key that belong to it."""
    place: dict[str, Any] = Field(default_factory=dict)
    """Place in the mesh, or slide-roll ratio, as of `Case.scene`."""
    reading: ReadingTable | None = None
    measurement: UncertaintyTable | None = None
    """Those of the row where they differ from the file's."""
    x: Text | None = None
    """Place on the centre line, along the entrainment, of a "film"."""
    oil: Text | None = None
    temperature: Text | None = None
    pressure: Text = "0 Pa"

    def flaws(self) -> Iterator[str]:
        """A quantity that nobody computes, or a value of another kind."""
        if self.quantity not in KINDS:
            yield f'quantity = "{self.quantity}": must be one of {", ".join(KINDS)}'
            return
        try:
            parse_uncertain(self.value).in_unit(kind_of(KINDS[self.quantity]).unit)
        except ValueError as error:
            yield f"value: {error}"
        if (self.x is None) == (self.quantity == "film"):
            yield 'x belongs to quantity = "film", and to no other one'


class ExperimentTable(Table):
    """A file of `validation/`."""

    title: Text
    source: SourceTable
    reading: ReadingTable
    measurement: UncertaintyTable
    case: Text | dict[str, Any] | None = None
    """Case file beside which the measurement stands, relative to the file, or a case's tables."""
    effects: ChosenEffects = ("auto",)
    accuracy: units.Share = 0.02
    oils: dict[str, MeasuredOilTable] = Field(default_factory=dict)
    inputs: list[InputTable] = Field(default_factory=list)
    assumptions: list[Text] = Field(default_factory=list)
    """What the source does not give and the computation needs."""
    rows: Annotated[list[RowTable], Field(min_length=1)]

    def flaws(self) -> Iterator[str]:
        """Rows without what computes them, or with what does not."""
        if bool(self.oils) == (self.case is not None):
            yield "give either case or oils, one of the two"
        for number, row in enumerate(self.rows):
            if self.oils and row.oil not in self.oils:
                yield f"rows[{number}].oil: must be one of {', '.join(self.oils)}"
            if self.oils and row.temperature is None:
                yield f"rows[{number}].temperature is missing"
            if not self.oils and row.given("oil", "temperature"):
                yield f"rows[{number}]: oil and temperature have no effect without [oils]"
            if self.oils and (row.changes or row.place):
                yield f"rows[{number}]: changes and place have no effect with [oils]"
            try:
                self.measured(row)
            except ValueError as error:
                yield f"rows[{number}]: its uncertainty {error}"

    def measured(self, row: RowTable) -> Uncertain:
        """The value D of a row in SI with its standard uncertainty u_D.

        By the root of the squares of the uncertainties of the measurement, of the reading, and of the row.
        """
        stated = parse_uncertain(row.value)
        uncertain = row.reading or self.reading, row.measurement or self.measurement
        parts = [part.of(stated).standard for part in uncertain]
        whole = Uncertain(stated.value, hypot(stated.standard, *parts), stated.unit)
        return whole.in_unit(kind_of(KINDS[row.quantity]).unit)


def read_experiment(path: str | Path) -> ExperimentTable:
    """Read the file of an experiment.

    Raises:
        CaseError: The first error found, as one line.
    """
    try:
        return checked(ExperimentTable, read_toml(Path(path)))
    except CaseError as error:
        said = str(error)
        raise CaseError(said if said.startswith(str(path)) else f"{path}: {said}") from None


def read_experiments(folder: str | Path) -> dict[str, ExperimentTable]:
    """All experiments of a folder by the name of their file, sorted; CaseError as of one."""
    return {path.stem: read_experiment(path) for path in sorted(Path(folder).glob("*.toml"))}
