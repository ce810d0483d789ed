"""REXS models: components with attributes, and relations between them.

Reusable Engineering EXchange Standard, and its database of components and attributes: FVA, www.rexs.info,
version 2.0.0. Files are plain XML (`.rexs`). A document type definition is refused, so that no entity of a
file expands.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import NoReturn
from xml.etree import ElementTree

from pyworm.io.atomic import whole_file
from pyworm.io.input_error import CaseError, shortened

VERSION = "2.0.0"
"""Version of the standard of files that are written."""

MAX_FILE_BYTES = 2**26
"""Bytes of the largest file that is read: a gear unit with all its results has a few million."""

EQUIVALENT_UNITS = ({"deg", "°", "degree"}, {"MPa", "N / mm^2"})
"""Spellings of one unit in different versions of the standard."""

Value = bool | int | float | str | tuple[float, ...]
"""Value of an attribute; several numbers are an array."""


@dataclass(frozen=True)
class Attribute:
    """Attribute of a component, its value as written."""

    text: str
    """Value as the file has it; the entries of an array stand between blanks."""
    unit: str
    """Unit by the standard's name; "none" of pure numbers and words."""
    array: bool = False
    """Whether it is an array."""


@dataclass
class Component:
    """Component of a model: a gear, a tool, a material."""

    number: int
    """Identifier in the file."""
    kind: str
    """Type by the standard, such as "worm_gear"."""
    name: str
    """Name for people; may be empty."""
    attributes: dict[str, Attribute] = field(default_factory=dict)
    """Attributes by identifier."""

    def __str__(self) -> str:
        named = f' "{self.name}"' if self.name else ""
        return f"component {self.number} ({self.kind}{named})"

    def word(self, name: str) -> str | None:
        """The text of an attribute; None where it is absent or empty."""
        found = self.attributes.get(name)
        return found.text if found is not None and found.text else None

    def flag(self, name: str) -> bool | None:
        """The truth value of an attribute; None where it is absent, CaseError where it is none."""
        text = self.word(name)
        if text is None:
            return None
        if text.lower() not in ("true", "false"):
            self.refuse(name, "must be true or false")
        return text.lower() == "true"

    def number_of(self, name: str, unit: str) -> float | None:
        """The number of an attribute in a unit of the standard; None where it is absent.

        CaseError of another unit, or of no finite number.
        """
        text = self.word(name)
        if text is None:
            return None
        written = self.attributes[name].unit
        if written != unit and not any({written, unit} <= same for same in EQUIVALENT_UNITS):
            self.refuse(name, f"must have the unit {unit}")
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not isfinite(value):
            self.refuse(name, "must be a number")
        return value

    def refuse(self, name: str, wanted: str) -> NoReturn:
        """Raise the CaseError of a wrong attribute: component, attribute, value, what would be right."""
        found = self.attributes[name]
        unit = "" if found.unit in ("none", "") else f" {found.unit}"
        raise CaseError(f"{self}: attribute {name} = {shortened(found.text)}{unit}: {wanted}")


@dataclass(frozen=True)
class Relation:
    """Relation between components."""

    kind: str
    """Type by the standard, such as "assembly"."""
    parts: tuple[tuple[str, int], ...]
    """Role and identifier of each component."""
    order: int | None = None
    """Place in a sequence, of relations that have one."""


@dataclass
class Model:
    """A REXS model."""

    application: str
    """Program that wrote it."""
    components: dict[int, Component] = field(default_factory=dict)
    """Components by identifier."""
    relations: list[Relation] = field(default_factory=list)
    """Relations in order."""

    def of_kind(self, kind: str) -> list[Component]:
        """Components of a type, in order."""
        return [found for found in self.components.values() if found.kind == kind]

    def related(self, relation: str, role: str, **others: Component | None) -> Iterator[Component]:
        """Components in a role of a relation in which others have theirs; none where one of those is None."""
        for found in self.relations:
            if found.kind == relation and all(
                other is not None and (name, other.number) in found.parts
                for name, other in others.items()
            ):
                yield from (self.components[number] for name, number in found.parts if name == role)

    def add(self, kind: str, name: str, values: Mapping[str, tuple[Value, str]]) -> Component:
        """Add a component with its attributes, identifier -> value and unit; arrays stay arrays."""
        built = Component(len(self.components) + 1, kind, name)
        for key, (value, unit) in values.items():
            built.attributes[key] = Attribute(_text(value), unit, isinstance(value, tuple))
        self.components[built.number] = built
        return built

    def relate(self, kind: str, order: int | None = None, **parts: Component) -> None:
        """Add a relation of components by role."""
        numbered = tuple((role, part.number) for role, part in parts.items())
        self.relations.append(Relation(kind, numbered, order))


def _text(value: Value) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return " ".join(map(repr, value)) if isinstance(value, tuple) else str(value)


class _NoEntities(ElementTree.TreeBuilder):
    """Builder of the tree that refuses a document type definition, the place of entities."""

    def doctype(self, name: str, public: str | None, system: str | None) -> None:
        raise CaseError("has a document type definition, which a REXS file must not have")


def read_rexs(path: Path) -> Model:
    """Read a REXS file; CaseError of none, with one sentence."""
    try:
        if path.stat().st_size > MAX_FILE_BYTES:
            raise CaseError(f"has more than {MAX_FILE_BYTES / 1e6:.0f} MB")
        root = ElementTree.fromstring(
            path.read_bytes(), ElementTree.XMLParser(target=_NoEntities())
        )
        return _model(root)
    except OSError as error:
        raise CaseError(f"{path}: cannot be read ({error.strerror})") from None
    except ElementTree.ParseError as error:
        raise CaseError(
            f"{path}: is no REXS file in XML ({error}); .rexsj and .rexsz are not read"
        ) from None
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from None


def _local(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]


def _model(root: ElementTree.Element) -> Model:
    """The model of a parsed file; of load cases the first adds its attributes."""
    if _local(root) != "model":
        raise CaseError(f"is no REXS file: its root is {_local(root)}, must be model")
    model = Model(root.get("applicationId", "an unnamed program"))
    for element in root.iter():
        kind = _local(element)
        if kind == "relation":
            parts = tuple((ref.get("role", ""), _number(ref)) for ref in element)
            model.relations.append(Relation(element.get("type", ""), parts))
        elif kind == "load_case":
            break
        elif kind == "component":
            built = Component(_number(element), element.get("type", ""), element.get("name", ""))
            model.components[built.number] = built
            _take_attributes(built, element)
    first = next((found for found in root.iter() if _local(found) == "load_case"), ())
    for element in first:
        if (number := _number(element)) in model.components:
            _take_attributes(model.components[number], element)
    for relation in model.relations:
        for _, number in relation.parts:
            if number not in model.components:
                raise CaseError(f"a relation {relation.kind} names component {number}: no such one")
    return model


def _take_attributes(component: Component, element: ElementTree.Element) -> None:
    for found in element:
        text = " ".join(" ".join(found.itertext()).split())
        array = any(_local(part) == "array" for part in found)
        component.attributes[found.get("id", "")] = Attribute(
            text, found.get("unit", "none"), array
        )


def _number(element: ElementTree.Element) -> int:
    text = element.get("id", "")
    if not text.isdecimal() or len(text) > 12:
        raise CaseError(f'{_local(element)} has the id "{text:.20}": must be a whole number')
    return int(text)


def write_rexs(model: Model, path: Path, version: str, date: str) -> None:
    """Write a model, of a version of this program, made at a date (ISO 8601)."""
    root = ElementTree.Element(
        "model",
        version=VERSION,
        applicationId=model.application,
        applicationVersion=version,
        date=date,
    )
    relations = ElementTree.SubElement(root, "relations")
    for number, relation in enumerate(model.relations, 1):
        about = {"id": str(number), "type": relation.kind}
        if relation.order is not None:
            about["order"] = str(relation.order)
        built = ElementTree.SubElement(relations, "relation", about)
        for role, part in relation.parts:
            hint = model.components[part].kind
            ElementTree.SubElement(built, "ref", id=str(part), role=role, hint=hint)
    components = ElementTree.SubElement(root, "components")
    for component in model.components.values():
        about = {"id": str(component.number), "type": component.kind, "name": component.name}
        built = ElementTree.SubElement(components, "component", about)
        for key, attribute in component.attributes.items():
            _write_attribute(built, key, attribute)
    ElementTree.indent(root)
    with whole_file(path) as partial:
        ElementTree.ElementTree(root).write(partial, encoding="UTF-8", xml_declaration=True)


def _write_attribute(component: ElementTree.Element, key: str, attribute: Attribute) -> None:
    built = ElementTree.SubElement(component, "attribute", id=key, unit=attribute.unit)
    if not attribute.array:
        built.text = attribute.text
        return
    array = ElementTree.SubElement(built, "array")
    for entry in attribute.text.split():
        ElementTree.SubElement(array, "c").text = entry
