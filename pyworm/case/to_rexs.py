"""A case about a worm drive as a REXS model: geometry, tools, materials, oil and loads."""

from collections.abc import Iterator, Mapping
from typing import Any

from pyworm.case.case import Case
from pyworm.case.rexs_slots import (
    BASE_CYLINDERS,
    BASES,
    COMPUTED,
    CONDITIONS,
    COUNTS,
    CUSTOM,
    FLANK_FORMS,
    GEOMETRY,
    KINDS,
    MATERIAL,
    Role,
    in_rexs,
)
from pyworm.case.worm import WormCase
from pyworm.drives.worm.drive import WormDrive
from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.rexs import Component, Model, Value
from pyworm.materials.library import named_oil, names

Attributes = dict[str, tuple[Value, str]]
"""Identifier of an attribute -> its value and unit."""

NOT_WRITTEN = {
    "drive.worm.deviations": "flank deviations",
    "drive.wheel.deviations": "flank deviations",
    "lubrication": "lubrication of the teeth",
    "cooling": "cooling of the housing",
}
"""Key of a case -> what a REXS model of this program lacks."""


def rexs_model(case: Case) -> Model:
    """The REXS model of a case; CaseError of one that is not about a worm drive."""
    tables, drive = case.tables, case.drive
    if not isinstance(tables, WormCase) or not isinstance(drive, WormDrive):
        raise CaseError(f"{case.name}: REXS is written for worm drives (drive.kind = worm) only")
    attributes = _attributes(case.title, tables, drive)
    model = Model("pyworm")
    parts = {
        role: model.add(KINDS[role], _name(role, tables), attributes[role])
        for role in KINDS
        if attributes[role] or role not in ("hob", "disc", "hob_setting")
    }
    _relate(model, parts, drive)
    return model


def unwritten_in_rexs(case: Case) -> tuple[str, ...]:
    """What the case gives and its REXS model lacks, in words."""
    return tuple(
        dict.fromkeys(
            words for key, words in NOT_WRITTEN.items() if _given(case.tables, key) is not None
        )
    )


def _given(tables: Any, key: str) -> Any:
    """The value at a dotted key of checked tables; None where it is absent."""
    found = tables
    for name in key.split("."):
        found = getattr(found, name, None)
    return found


def _name(role: Role, tables: WormCase) -> str:
    if role == "oil":
        return tables.oil.name
    if role in ("worm_material", "wheel_material"):
        return _given(tables.bodies, role.partition("_")[0]).material or ""
    return role.replace("_", " ")


def _attributes(title: str, tables: WormCase, drive: WormDrive) -> dict[Role, Attributes]:
    """The attributes of each part."""
    found: dict[Role, Attributes] = {role: {} for role in KINDS}
    numbers = {f"drive.{key}": value for key, value in _numbers(tables).items()}
    by_module = tables.drive.module is not None
    for slot in (*COUNTS, *GEOMETRY, *(() if by_module else BASE_CYLINDERS)):
        if slot.key in numbers:
            value = numbers[slot.key]
            whole = value if slot in COUNTS else in_rexs(value, slot.unit)
            found[slot.role][slot.attribute] = whole, slot.unit
    for slot in CONDITIONS:
        value = _condition(slot.key, tables, drive)
        if value is not None and value not in (0.0, float("inf")):
            found[slot.role][slot.attribute] = in_rexs(value, slot.unit), slot.unit
    geometry = drive.geometry() | {"gear_ratio": drive.wheel.teeth / drive.worm.threads}
    for part, attribute, unit, entry in COMPUTED:
        value = float(geometry[entry])
        number = value if entry.endswith("_deg") else in_rexs(value, unit)
        found[part].setdefault(attribute, (number, unit))
    found["unit"]["model_name"] = title, "none"
    found["hob"] |= _hob(tables, drive, numbers)
    found["hob_setting"]["center_distance_correction"] = (
        in_rexs(drive.hob.centre_distance - drive.centre_distance, "mm"),
        "mm",
    )
    _add_form(found, drive, geometry)
    found["worm_material"] = dict(_material(tables.bodies.worm))
    found["wheel_material"] = dict(_material(tables.bodies.wheel))
    found["oil"] = dict(_oil(tables, drive))
    found["stage"] |= dict(_tooth_load(drive))
    found["worm_shaft"] |= {
        "rotational_speed": (in_rexs(drive.speed, "1 / min"), "1 / min"),
        "defines_speed": (True, "none"),
    }
    return found


def _numbers(tables: WormCase) -> Mapping[str, Any]:
    return tables.drive.completed_numbers()


def _condition(key: str, tables: WormCase, drive: WormDrive) -> float | None:
    """The value of a key of `CONDITIONS` in SI; None where it is absent."""
    if key == "oil.temperature":
        return None if drive.oil.heat is None else drive.oil.heat.inlet_temperature
    if key.endswith("roughness"):
        return drive.bodies[0 if "worm" in key else 1].roughness
    found: float | None = _given(tables, key)
    return found


def _hob(tables: WormCase, drive: WormDrive, numbers: Mapping[str, Any]) -> Attributes:
    """Size of the hob: tip, addendum and depth; of base cylinders, which give the rest, the depth."""
    hob = drive.hob
    about: Attributes = {
        "number_of_teeth": (drive.worm.threads, "none"),
        "tip_diameter_worm_gear": (in_rexs(2 * hob.tip_radius, "mm"), "mm"),
        "tooth_depth_worm_wheel_hob": (in_rexs(hob.tip_radius - hob.root_radius, "mm"), "mm"),
        "lead": (in_rexs(hob.lead, "mm"), "mm"),
    }
    if tables.drive.module is not None:
        reference = numbers["drive.diameter_factor"] * numbers["drive.module"]
        addendum = hob.tip_radius - (reference + numbers["drive.hob.oversize"]) / 2
        about["tooth_addendum_worm_wheel_hob"] = in_rexs(addendum, "mm"), "mm"
    return about


def _add_form(
    found: dict[Role, Attributes], drive: WormDrive, geometry: Mapping[str, float | str]
) -> None:
    """Add flank form, hand and pressure angle to gears and tools."""
    forms = {profile: form for form, profile in FLANK_FORMS.items()}
    form = forms.get(drive.worm.profile, "zc")
    angle = found["worm"]["pressure_angle_worm_gear"]
    roles: tuple[Role, ...] = ("worm", "wheel", "hob", "disc")
    for role in roles:
        if role != "disc" or found["disc"]:
            found[role] |= {"flank_form": (form, "none"), "pressure_angle_worm_gear": angle}
    if drive.worm.profile not in forms:
        found["worm"][f"{CUSTOM}profile"] = drive.worm.profile, "none"
    sign = 1.0 if drive.hand == "right" else -1.0
    found["worm"]["lead_angle_worm_gear"] = sign * float(geometry["lead_angle_deg"]), "deg"


def _material(body: Any) -> Iterator[tuple[str, tuple[Value, str]]]:
    """Attributes of a material, by the table of a body."""
    if body.material is not None:
        yield "material_designation", (body.material, "none")
    for attribute, unit, key in MATERIAL:
        value = getattr(body, key)
        if value is not None:
            yield attribute, (in_rexs(value, unit), unit)


def _oil(tables: WormCase, drive: WormDrive) -> Iterator[tuple[str, tuple[Value, str]]]:
    """Attributes of the oil: those of a data sheet where it is one of the library."""
    yield "name", (tables.oil.name, "none")
    yield "kind", ("oil", "none")
    heat = drive.oil.heat
    if heat is not None:
        yield "thermal_conductivity", (heat.conductivity, "W / (m K)")
        yield "thermal_capacity", (heat.specific_heat, "J / (kg K)")
    if tables.oil.name not in names():
        return
    oil = named_oil(tables.oil.name)
    kinds = {base: kind for kind, base in reversed(BASES.items())}
    if oil.stock.name in kinds:
        yield "lubricant_type_iso_6336_2019", (kinds[oil.stock.name], "none")
    yield "density_at_15_degree_celsius", (in_rexs(oil.stock.density_15, "kg / dm^3"), "kg / dm^3")
    for degrees, temperature in ((40, DEGREES_40), (100, DEGREES_100)):
        viscosity = float(oil.kinematic_viscosity(temperature))
        yield f"viscosity_at_{degrees}_degree_celsius", (in_rexs(viscosity, "mm^2 / s"), "mm^2 / s")


def _tooth_load(drive: WormDrive) -> Iterator[tuple[str, tuple[Value, str]]]:
    """The load of one tooth, where it is given in place of a torque."""
    if drive.tooth_load is not None:
        yield f"{CUSTOM}load", (drive.tooth_load, "N")


def _relate(model: Model, parts: Mapping[Role, Component], drive: WormDrive) -> None:
    """Relations of the parts, the data of the gears in their stage, flanks and the external load."""
    stage = parts["stage"]
    model.relate("stage", stage=stage, gear_1=parts["worm"], gear_2=parts["wheel"])
    model.relate("assembly", assembly=parts["unit"], part=stage)
    model.relate("reference", origin=stage, referenced=parts["oil"])
    gears: tuple[tuple[Role, Role, Role], ...] = (
        ("worm", "worm_shaft", "worm_material"),
        ("wheel", "wheel_shaft", "wheel_material"),
    )
    for gear, shaft, material in gears:
        model.relate("assembly", assembly=parts["unit"], part=parts[shaft])
        model.relate("assembly", assembly=parts[shaft], part=parts[gear])
        model.relate("reference", origin=parts[gear], referenced=parts[material])
        driving: Attributes = {"is_driving_gear": (drive.driver == gear, "none")}
        data = model.add("worm_stage_gear_data", f"{gear} in its stage", driving)
        model.relate("stage_gear_data", stage=stage, gear=parts[gear], stage_gear_data=data)
        left, right = (
            model.add("worm_gear_flank", f"{side} flank of the {gear}", {})
            for side in ("left", "right")
        )
        model.relate("flank", gear=parts[gear], left=left, right=right)
        _relate_tool(model, parts, gear, (left, right))
    if drive.transmission is not None:
        torque: Attributes = {
            "torque_around_u_axis": (drive.transmission.torque, "N m"),
            "defines_torque": (True, "none"),
        }
        load = model.add("external_load", "torque", torque)
        shaft = "worm_shaft" if drive.transmission.shaft == "worm" else "wheel_shaft"
        model.relate("assembly", assembly=parts[shaft], part=load)


def _relate_tool(
    model: Model, parts: Mapping[Role, Component], gear: Role, flanks: tuple[Component, ...]
) -> None:
    """Manufacturing steps of a gear's flanks: the wheel's by the hob, the worm's by the disc, if any."""
    if gear == "worm" and "disc" not in parts:
        return
    tool = parts["disc" if gear == "worm" else "hob"]
    setting = (
        present(parts.get("hob_setting"), "hob_setting")
        if gear == "wheel"
        else model.add(KINDS["hob_setting"], "grinding", {})
    )
    for flank in flanks:
        model.relate(
            "manufacturing_step",
            order=1,
            workpiece=flank,
            tool=tool,
            manufacturing_settings=setting,
        )
