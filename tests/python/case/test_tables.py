"""Tables of case files that have the fields of a dataclass."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Literal, get_type_hints

import pytest
from folders import ROOT
from pydantic import ValidationError
from pydantic.fields import FieldInfo

import pyworm
from pyworm.case.kinds import SUBJECTS, case_model
from pyworm.case.table import Table, plain
from pyworm.io import units
from pyworm.kernel.numbers import flow_numbers


@dataclass(frozen=True)
class Rod:
    """A rod."""

    length: units.Length
    diameter: units.Length = 5e-3


@dataclass(frozen=True)
class Frame:
    """A frame of rods."""

    rods: tuple[Rod, ...]
    spare: Rod | None = None


class RodTable(Table, Rod):
    """A rod as a file has it."""

    kind: Literal["rod"] = "rod"


class FrameTable(Table, Frame):
    """A frame as a file has it."""

    rods: tuple[RodTable, ...]
    spare: RodTable | None = None


def test_a_table_is_read_by_the_types_of_its_dataclass():
    table = RodTable.model_validate({"kind": "rod", "length": "2 mm"})
    assert plain(table, Rod) == Rod(2e-3, 5e-3)
    assert type(plain(table, Rod)) is Rod
    for wrong in ({"length": "2 kg"}, {"length": 2.0}, {"length": "2 mm", "width": "1 mm"}, {}):
        with pytest.raises(ValidationError):
            RodTable.model_validate(wrong)


def test_tables_inside_become_dataclasses_too():
    given = {"rods": [{"length": "2 mm"}, {"length": "3 mm"}], "spare": {"length": "1 mm"}}
    assert plain(FrameTable.model_validate(given), Frame) == Frame(
        (Rod(2e-3), Rod(3e-3)), Rod(1e-3)
    )


def _tables(kind: type[Table]) -> Iterator[type[Table]]:
    for derived in kind.__subclasses__():
        yield derived
        yield from _tables(derived)


def test_tables_have_all_fields_of_their_dataclasses():
    for about, kinds in SUBJECTS.items():
        for kind in kinds:
            case_model(about, kind)  # which imports the tables
    found = [table for table in _tables(Table) if hasattr(table, "__dataclass_fields__")]
    assert len(found) > 10
    for table in found:
        kinds = [base for base in table.__mro__ if "__dataclass_fields__" in vars(base)]
        assert all(
            not (issubclass(parent, Table) and hasattr(parent, "__dataclass_fields__"))
            for parent in table.__mro__[1:]
        ), (
            f"{table} is derived from a table of a dataclass: pydantic forgets the types of its fields"
        )
        for kind in kinds:
            hints = get_type_hints(kind, include_extras=True)
            for part in fields(kind):
                of = table.model_fields[part.name]
                if part.name not in table.__annotations__:
                    assert of.metadata == FieldInfo.from_annotation(hints[part.name]).metadata


def test_the_way_of_a_key_to_the_kernel_is_as_the_contributors_read_it():
    text = (ROOT / "CONTRIBUTING.md").read_text()
    steps = re.findall(r"^\d\. `(\S+)`: .*?`([A-Za-z]\S*)`", text, re.MULTILINE)
    assert len(steps) == 8
    for file, name in steps:
        content = (ROOT / file).read_text()
        for part in name.split("."):
            assert re.search(rf"^ *(class |def |subroutine )?{part}\b", content, re.MULTILINE), (
                file,
                name,
            )
    (case, _), *_ = steps
    law = pyworm.load(ROOT / case).scene(phase=0.5).oil.flow
    assert flow_numbers(law)[:2] == (3, 3e6)
    arguments = re.search(
        r"subroutine film_shear\((.*?)\)", (ROOT / steps[-1][0]).read_text(), re.DOTALL
    )
    assert "law, reference," in arguments[1]
