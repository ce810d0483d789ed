"""A case about a worm drive from a REXS model."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import copysign
from pathlib import Path
from typing import Any

from pyworm.case.case import Case, case_of
from pyworm.case.dotted_keys import with_values
from pyworm.case.rexs_slots import (
    BASE_CYLINDERS,
    BASES,
    BY_MODULE,
    CONDITIONS,
    COUNTS,
    CUSTOM,
    FLANK_FORMS,
    GEOMETRY,
    HAND,
    KINDS,
    MATERIAL,
    Role,
    Slot,
    in_case,
)
from pyworm.formulas.gear_oil import ISO_GRADES
from pyworm.io.input_error import CaseError
from pyworm.io.rexs import Component, Model, read_rexs
from pyworm.materials.library import names
from pyworm.materials.solids import is_named

GRADE_WIDTH = 0.1
"""Relative width of a grade to both sides of its viscosity at 40 degC (ISO 3448)."""

USUAL_FINISH = {"worm": "ground", "wheel": "run-in"}
"""Finish of flanks whose roughness the file does not give."""

REQUIRED: dict[str, tuple[Role, str, str]] = {
    "drive.threads": ("worm", "number_of_teeth", "--threads"),
    "drive.teeth": ("wheel", "number_of_teeth", "--teeth"),
    "drive.profile": ("worm", "flank_form", "--profile"),
    "drive.module": ("worm", "axial_module", "--module"),
    "drive.diameter_factor": ("worm", "form_factor_worm_gear", "--diameter-factor"),
    "drive.centre_distance": ("stage", "center_distance", "--centre-distance"),
    "operation.worm_speed": ("worm_shaft", "rotational_speed", "--worm-speed"),
    "operation.wheel_torque": ("wheel_shaft", "torque_around_u_axis", "--wheel-torque"),
    "bodies.worm.material": ("worm_material", "elastic_modulus", "--worm-material"),
    "bodies.wheel.material": ("wheel_material", "elastic_modulus", "--wheel-material"),
    "oil.name": ("oil", "viscosity_at_40_degree_celsius", "--oil"),
    "oil.temperature": ("stage", "temperature_lubricant", "--oil-temperature"),
}
"""Key that a case must have -> part and attribute of the model, and the option in its place."""

ONE_OF = {
    "drive.diameter_factor": ("drive.worm.reference_diameter", "drive.profile_shift"),
    "drive.centre_distance": ("drive.profile_shift",),
    "operation.worm_speed": ("operation.wheel_speed",),
    "operation.wheel_torque": ("operation.worm_torque", "operation.power", "operation.load"),
    "bodies.worm.material": ("bodies.worm.youngs_modulus",),
    "bodies.wheel.material": ("bodies.wheel.youngs_modulus",),
}
"""Required key -> others that may stand in its place."""


@dataclass
class _Reading:
    """Values of a case found in a model."""

    model: Model
    parts: dict[Role, Component]
    values: dict[str, Any] = field(default_factory=dict)
    """Key of the case -> value as a case file has it."""
    origins: dict[str, tuple[Component, str]] = field(default_factory=dict)
    """Key -> component and attribute from which it is."""

    def take(self, slot: Slot) -> None:
        """Take an attribute as the value of a key, if it is there.

        Zero stands for what is not known in files of other programs, except in attributes of one's own.
        """
        part = self.parts.get(slot.role)
        value = None if part is None else part.number_of(slot.attribute, slot.unit)
        if part is not None and (value or (value == 0 and slot.attribute.startswith(CUSTOM))):
            self.put(slot.key, in_case(value, slot.unit), part, slot.attribute)

    def put(self, key: str, value: Any, part: Component, attribute: str) -> None:
        """Enter a value with its origin."""
        self.values[key] = value
        self.origins[key] = part, attribute


def rexs_content(path: Path, instead: Mapping[str, Any]) -> tuple[dict[str, Any], Case]:
    """The content of a case file about the worm drive of a REXS file, and its checked case.

    Args:
        path: The REXS file.
        instead: Values by dotted key that go in place of the file's.

    Raises:
        CaseError: No worm drive, or a wrong or a missing attribute: one sentence with component, attribute,
            value and what would be right.
    """
    model = read_rexs(path)
    try:
        reading = _read(model)
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from None
    for key in instead:
        for other in _displaced(key):
            reading.values.pop(other, None)
            reading.origins.pop(other, None)
        reading.origins.pop(key, None)
    values = reading.values | dict(instead)
    _require(path, reading, values)
    bare: dict[str, Any] = {
        "title": _title(reading.parts["unit"], path) if "unit" in reading.parts else path.stem,
        "source": f"REXS file {path.name} of {model.application}",
        "accuracy": "5 %",
        "drive": {"kind": "worm"},
    }
    content = with_values(bare, values)
    try:
        return content, case_of(
            with_values(content, {"operation.phases": [0.5]}), path.stem, path.parent
        )
    except CaseError as error:
        raise CaseError(f"{path}: {_by_attribute(str(error), reading)}") from None


def _title(unit: Component, path: Path) -> str:
    return unit.word("model_name") or path.stem


def _displaced(key: str) -> tuple[str, ...]:
    """Keys that give the same as a key, the constants of a material among them."""
    others = ONE_OF.get(key, ())
    if key.endswith(".material"):
        body = key.removesuffix(".material")
        return (*others, *(f"{body}.{constant}" for _, _, constant in MATERIAL))
    return others


def _require(path: Path, reading: _Reading, values: Mapping[str, Any]) -> None:
    """CaseError of a key without a value."""
    for key, (role, attribute, option) in REQUIRED.items():
        if key in BY_MODULE and "drive.worm.base_diameter" in values:
            continue
        if not {key, *ONE_OF.get(key, ())} & values.keys():
            part = reading.parts.get(role)
            lacks = f"there is no {KINDS[role]} with" if part is None else f"{part} has no"
            raise CaseError(
                f"{path}: {lacks} attribute {attribute} that gives {key}; add it, or give {option}"
            )


def _by_attribute(message: str, reading: _Reading) -> str:
    """A message about a key, with the component and the attribute from which its value is."""
    for key in sorted(reading.origins, key=len, reverse=True):
        if message.startswith(key):
            part, attribute = reading.origins[key]
            found = part.attributes[attribute]
            unit = "" if found.unit == "none" else f" {found.unit}"
            return f"{part}: attribute {attribute} = {found.text}{unit}: {message}"
    return message


def _read(model: Model) -> _Reading:
    """All values of a model."""
    reading = _Reading(model, dict(_parts(model)))
    worm = reading.parts["worm"]
    by_cylinders = f"{CUSTOM}base_diameter" in worm.attributes
    for slot in (*GEOMETRY, *(BASE_CYLINDERS if by_cylinders else ())):
        if not (by_cylinders and slot.key in BY_MODULE):
            reading.take(slot)
    for slot in COUNTS:
        _take_count(reading, slot)
    _read_form(reading, worm)
    _read_sizes_of_other_programs(reading, worm)
    _read_hob(reading)
    for slot in CONDITIONS:
        reading.take(slot)
    _read_bodies(reading)
    _read_oil(reading)
    _read_operation(reading)
    return reading


def _take_count(reading: _Reading, slot: Slot) -> None:
    part = reading.parts[slot.role]
    value = part.number_of(slot.attribute, slot.unit)
    if value is not None:
        if value < 1 or value != int(value):
            part.refuse(slot.attribute, "must be a whole number from 1")
        reading.put(slot.key, int(value), part, slot.attribute)


def _one(found: list[Component], kind: str) -> Component | None:
    """The one component of some; CaseError of several."""
    if len(found) > 1:
        raise CaseError(f"has {len(found)} components {kind}; must have one")
    return found[0] if found else None


def _parts(model: Model) -> Iterator[tuple[Role, Component]]:
    """The parts of the worm drive that there are; CaseError without stage, worm or wheel."""
    stage = _one(model.of_kind("worm_stage"), "worm_stage")
    if stage is None:
        raise CaseError("has no component worm_stage; REXS is read of worm stages only")
    yield "stage", stage
    gears: tuple[tuple[Role, str, Role, Role], ...] = (
        ("worm", "gear_1", "worm_shaft", "worm_material"),
        ("wheel", "gear_2", "wheel_shaft", "wheel_material"),
    )
    for role, place, shaft, material in gears:
        related = list(model.related("stage", place, stage=stage))
        gear = _one(related or model.of_kind(KINDS[role]), KINDS[role])
        if gear is None or gear.kind != KINDS[role]:
            raise CaseError(f"{stage}: has no {place} of the type {KINDS[role]}")
        yield role, gear
        yield from _first(shaft, model.related("assembly", "assembly", part=gear))
        yield from _first(material, model.related("reference", "referenced", origin=gear))
        for flank in (
            *model.related("flank", "left", gear=gear),
            *model.related("flank", "right", gear=gear),
        ):
            step = "manufacturing_step"
            tool: Role = "disc" if role == "worm" else "hob"
            yield from _first(tool, model.related(step, "tool", workpiece=flank))
            if role == "wheel":
                settings = model.related(step, "manufacturing_settings", workpiece=flank)
                yield from _first("hob_setting", settings)
    yield from _first("unit", iter(model.of_kind("gear_unit")))
    oils = [*model.related("reference", "referenced", origin=stage), *model.of_kind("lubricant")]
    yield from _first("oil", iter(oils))


def _first(role: Role, found: Iterator[Component]) -> Iterator[tuple[Role, Component]]:
    """The first component of the type that a part has."""
    for component in found:
        if component.kind == KINDS[role]:
            yield role, component
            return


def _read_form(reading: _Reading, worm: Component) -> None:
    """Profile and hand."""
    form = worm.word("flank_form")
    if form is not None:
        if form not in FLANK_FORMS:
            worm.refuse("flank_form", f"must be one of {', '.join(FLANK_FORMS)}")
        profile = worm.word(f"{CUSTOM}profile") or FLANK_FORMS[form]
        reading.put("drive.profile", profile, worm, "flank_form")
        if form not in ("zk", "zc"):  # discs of other profiles do not form the flank
            reading.values.pop("drive.worm.disc_diameter", None)
    angle = worm.number_of("lead_angle_worm_gear", "deg")
    if angle:
        reading.put("drive.hand", HAND[int(copysign(1, angle))], worm, "lead_angle_worm_gear")


def _read_sizes_of_other_programs(reading: _Reading, worm: Component) -> None:
    """Sizes that stand for others which are absent."""
    wheel, values = reading.parts["wheel"], reading.values
    if "drive.worm.base_diameter" in values:
        return
    if "drive.diameter_factor" not in values:
        key = "drive.worm.reference_diameter"
        reading.take(Slot("worm", "reference_diameter_worm_gear", "mm", key))
    if "drive.centre_distance" not in values:
        shift = "addendum_modification_coefficient_worm_wheel"
        reading.take(Slot("wheel", shift, "none", "drive.profile_shift"))
    if "drive.face_width" not in values and wheel.word("face_width_worm_wheel"):
        reading.take(Slot("wheel", "face_width_worm_wheel", "mm", "drive.face_width"))


def _read_hob(reading: _Reading) -> None:
    """Oversize and centre distance of the hob, whose setting is known only with its size."""
    hob, setting, values = (
        reading.parts.get("hob"),
        reading.parts.get("hob_setting"),
        reading.values,
    )
    by_cylinders = "drive.worm.base_diameter" in values
    tip = None if hob is None else hob.number_of("tip_diameter_worm_gear", "mm")
    addendum = None if hob is None else hob.number_of("tooth_addendum_worm_wheel_hob", "mm")
    worm = reading.parts["worm"].number_of("reference_diameter_worm_gear", "mm")
    if not by_cylinders and (hob is None or tip is None or addendum is None or worm is None):
        return
    if hob is not None and not by_cylinders and tip is not None and addendum is not None and worm:
        oversize = float(f"{tip - 2 * addendum - worm:.12g}")
        # differences of rounded numbers: what is below the noise of the largest is none
        oversize = 0.0 if abs(oversize) < 1e-12 * tip else oversize
        reading.put("drive.hob.oversize", f"{oversize!r} mm", hob, "tip_diameter_worm_gear")
    distance = reading.parts["stage"].number_of("center_distance", "mm")
    name = "center_distance_correction"
    more = None if setting is None else setting.number_of(name, "mm")
    if setting is not None and more is not None and distance is not None:
        reading.put("drive.hob.centre_distance", f"{distance + more!r} mm", setting, name)
    if setting is not None and "drive.hob.swivel" not in values:
        reading.take(Slot("hob_setting", "lyra_angle", "deg", "drive.hob.swivel"))


def _read_bodies(reading: _Reading) -> None:
    """Materials and roughness of worm and wheel."""
    bodies: tuple[tuple[str, Role], ...] = (("worm", "worm_material"), ("wheel", "wheel_material"))
    for body, role in bodies:
        if f"bodies.{body}.roughness" not in reading.values:
            reading.values[f"bodies.{body}.finish"] = USUAL_FINISH[body]
        part = reading.parts.get(role)
        if part is None:
            continue
        name = part.word("material_designation")
        if is_named(name):
            reading.put(f"bodies.{body}.material", name, part, "material_designation")
        for attribute, unit, key in MATERIAL:
            reading.take(Slot(role, attribute, unit, f"bodies.{body}.{key}"))


def _read_oil(reading: _Reading) -> None:
    """The oil of the library that the lubricant is: by its name, or by its type and its grade."""
    oil = reading.parts.get("oil")
    if oil is None:
        return
    if oil.word("kind") == "grease":
        oil.refuse("kind", "must be oil")
    viscosity = oil.number_of("viscosity_at_40_degree_celsius", "mm^2 / s")
    written = oil.word("lubricant_type_iso_6336_2019") or oil.word("lubricant_type_iso_6336_2006")
    base = BASES.get(written or "")
    name = oil.word("name")
    if name in names():
        reading.put("oil.name", name, oil, "name")
    else:  # of a trade name the grade says what is known
        for grade in ISO_GRADES:
            if base and viscosity and abs(viscosity / grade - 1) <= GRADE_WIDTH:
                found = f"{base} VG {grade}"
                reading.put("oil.name", found, oil, "viscosity_at_40_degree_celsius")
    if "oil.temperature" not in reading.values:
        casing = _one(reading.model.of_kind("gear_casing"), "gear_casing")
        degrees = None if casing is None else casing.number_of("temperature_lubricant", "C")
        if casing is not None and degrees is not None:
            reading.put("oil.temperature", in_case(degrees, "C"), casing, "temperature_lubricant")


def _read_operation(reading: _Reading) -> None:
    """Speed of one shaft, load, and the driving member."""
    parts, model, stage = reading.parts, reading.model, reading.parts["stage"]
    load = stage.number_of(f"{CUSTOM}load", "N")
    if load is not None:
        reading.put("operation.load", f"{load!r} N", stage, f"{CUSTOM}load")
    gears: tuple[tuple[Role, Role], ...] = (("wheel", "wheel_shaft"), ("worm", "worm_shaft"))
    for gear, shaft in gears:
        for role in (gear, shaft):
            _take_size(reading, role, "rotational_speed", "1 / min", f"operation.{gear}_speed")
        data = model.related("stage_gear_data", "stage_gear_data", stage=stage, gear=parts[gear])
        loads = model.related("assembly", "part", assembly=parts.get(shaft))
        for component in (*loads, *data):
            if component.kind not in ("external_load", "worm_stage_gear_data"):
                continue
            if component.flag("is_driving_gear"):
                reading.put("operation.driver", gear, component, "is_driving_gear")
            torque = "torque_around_u_axis" if component.kind == "external_load" else "torque"
            for attribute, unit, key in (
                (torque, "N m", f"{gear}_torque"),
                ("power", "kW", "power"),
            ):
                value = component.number_of(attribute, unit)
                if value and not _loaded(reading):
                    text = f"{abs(value)!r} {unit}"
                    reading.put(f"operation.{key}", text, component, attribute)
    if "operation.worm_speed" in reading.values:
        reading.values.pop("operation.wheel_speed", None)


def _loaded(reading: _Reading) -> bool:
    keys = ("wheel_torque", "worm_torque", "power", "load")
    return any(f"operation.{key}" in reading.values for key in keys)


def _take_size(reading: _Reading, role: Role, attribute: str, unit: str, key: str) -> None:
    """Take the size of a number that has a sign by the sense of rotation."""
    part = reading.parts.get(role)
    value = None if part is None else part.number_of(attribute, unit)
    if part is not None and value:
        reading.put(key, in_case(abs(value), unit), part, attribute)
