"""Attributes of REXS 2.0 and the keys of case files about worm drives that have the same meaning.

Identifiers and units are those of the standard's database (FVA, www.rexs.info, 2.0.0). What it has no
attribute for is an attribute of one's own, which the standard lets begin with `custom_`. Signs of the set-up
of hob and assembly, and the section of the pressure angle, which the database does not define, are those of
case files.
"""

from dataclasses import dataclass
from math import degrees
from typing import Literal

from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS

Role = Literal[
    "unit",
    "stage",
    "worm",
    "wheel",
    "hob",
    "disc",
    "hob_setting",
    "worm_shaft",
    "wheel_shaft",
    "worm_material",
    "wheel_material",
    "oil",
]
"""Part of a worm drive."""

KINDS: dict[Role, str] = {
    "unit": "gear_unit",
    "stage": "worm_stage",
    "worm": "worm_gear",
    "wheel": "worm_wheel",
    "hob": "worm_wheel_hob_tool",
    "disc": "worm_grinding_disc_tool",
    "hob_setting": "worm_gear_manufacturing_settings",
    "worm_shaft": "shaft",
    "wheel_shaft": "shaft",
    "worm_material": "material",
    "wheel_material": "material",
    "oil": "lubricant",
}
"""Part of a worm drive -> type of its component."""

FLANK_FORMS = {"za": "ZA", "zn": "ZN", "zi": "ZI", "zk": "ZK", "zc": "ZC"}
"""Flank form of the standard -> profile."""

CUSTOM = "custom_pyworm_"
"""Beginning of the identifiers that are not the standard's."""

PER_SI = {
    "mm": 1e3,
    "mum": 1e6,
    "deg": degrees(1),
    "MPa": 1e-6,
    "kg / dm^3": 1e-3,
    "W / (m K)": 1.0,
    "J / (kg K)": 1.0,
    "N / m": 1.0,
    "N / mm": 1e-3,
    "N": 1.0,
    "N m": 1.0,
    "kN": 1e-3,
    "kW": 1e-3,
    "W": 1.0,
    "m / s": 1.0,
    "mm^2 / s": 1e6,
    "1 / min": RPM,
    "h": 1 / 3600,
    "%": 100.0,
    "none": 1.0,
}
"""Unit of the standard -> number of them in the SI unit; of "C" the zero counts, too."""

CASE_UNITS = {
    "mum": "um",
    "kg / dm^3": "kg/dm^3",
    "W / (m K)": "W/(m K)",
    "J / (kg K)": "J/(kg K)",
    "N / m": "N/m",
    "C": "degC",
    "1 / min": "1/min",
    "none": "",
}
"""Unit of the standard -> as a case file writes it, where that differs."""


@dataclass(frozen=True)
class Slot:
    """An attribute of a part of the drive, and the key of the case with its value."""

    role: Role
    """Part of the drive."""
    attribute: str
    """Identifier of the attribute."""
    unit: str
    """Unit of the attribute by the standard."""
    key: str
    """Key of the case."""


def _slots(role: Role, unit: str, table: str, **keys: str) -> tuple[Slot, ...]:
    return tuple(Slot(role, attribute, unit, f"{table}.{key}") for attribute, key in keys.items())


def _custom(role: Role, unit: str, table: str, *keys: str) -> tuple[Slot, ...]:
    return tuple(Slot(role, f"{CUSTOM}{key}", unit, f"{table}.{key}") for key in keys)


_FLANK_ENDS = ("fillet_radius", "tip_relief", "tip_relief_length")

COUNTS = (
    Slot("worm", "number_of_teeth", "none", "drive.threads"),
    Slot("wheel", "number_of_teeth", "none", "drive.teeth"),
)
"""Whole numbers."""

GEOMETRY = (
    Slot("stage", "center_distance", "mm", "drive.centre_distance"),
    Slot("stage", "axial_backlash_increase", "mm", "drive.backlash"),
    *_slots("worm", "mm", "drive", axial_module="module"),
    *_slots("worm", "none", "drive", form_factor_worm_gear="diameter_factor"),
    *_slots("worm", "deg", "drive", pressure_angle_worm_gear="pressure_angle"),
    *_slots(
        *("worm", "mm", "drive.worm"),
        tip_diameter_worm_gear="tip_diameter",
        root_diameter_worm_gear="root_diameter",
    ),
    *_custom("worm", "mm", "drive.worm", "thickness", *_FLANK_ENDS),
    *_slots(
        *("wheel", "mm", "drive.wheel"),
        tip_diameter_worm_gear="throat_diameter",
        outer_diameter_worm_wheel="outside_diameter",
        root_diameter_worm_gear="root_diameter",
        throat_radius_worm_wheel="groove_radius",
    ),
    *_slots("wheel", "mm", "drive", effective_face_width_worm_wheel="face_width"),
    *_custom("wheel", "mm", "drive.wheel", *_FLANK_ENDS),
    *_slots(
        *("disc", "mm", "drive.worm"),
        grinding_disk_diameter="disc_diameter",
        profile_radius_zc_disc="arc_radius",
    ),
    *_slots("hob_setting", "deg", "drive.hob", lyra_angle="swivel"),
    *_custom("hob_setting", "mm", "drive.hob", "axial_shift"),
)
"""Geometry of a drawing; the hob's size and distance follow from several attributes (`HOB_SIZE`)."""

BASE_CYLINDERS = (
    *_slots("worm", "mm", "drive.worm", axial_pitch="axial_pitch", lead="lead"),
    *_custom("worm", "mm", "drive.worm", "base_diameter"),
    *_custom("worm", "deg", "drive.worm", "base_lead_angle"),
    *_slots("hob", "mm", "drive.hob", tip_diameter_worm_gear="tip_diameter", lead="lead"),
    *_custom("hob", "mm", "drive.hob", "root_diameter", "base_diameter", "axial_pitch"),
    *_custom("hob", "deg", "drive.hob", "base_lead_angle"),
)
"""Geometry of a drive that is given by the base cylinders of worm and hob, in place of a module."""

BY_MODULE = (
    *("drive.module", "drive.diameter_factor", "drive.pressure_angle", "drive.backlash"),
    *("drive.worm.thickness", "drive.worm.disc_diameter", "drive.worm.arc_radius"),
    *("drive.wheel.root_diameter", "drive.wheel.groove_radius"),
)
"""Keys of drawings that a drive given by its base cylinders does not have."""

CONDITIONS = (
    *_slots(
        *("stage", "mm", "drive.assembly"),
        center_distance_offset="centre_distance",
        width_offset="axial_shift",
    ),
    *_slots("stage", "deg", "drive.assembly", intersection_angle_offset="shaft_angle"),
    *_custom("worm_shaft", "mm", "drive.shaft", "bearing_span", "bearing_offset", "diameter"),
    *_custom("worm_shaft", "N / m", "drive.shaft", "bearing_stiffness"),
    *_custom("stage", "N / m", "drive", "stiffness"),
    *_slots("stage", "C", "oil", temperature_lubricant="temperature"),
    *_slots("stage", "none", "worm_rating", application_factor_din_3996_2019="application_factor"),
    *_slots("unit", "h", "worm_rating", operating_time="life"),
    *_custom("worm", "mum", "bodies.worm", "roughness"),
    *_custom("wheel", "mum", "bodies.wheel", "roughness"),
)
"""Assembly, shaft, oil temperature, rating and roughness (Rq)."""

MATERIAL = (
    ("elastic_modulus", "MPa", "youngs_modulus"),
    ("poisson_ratio", "none", "poisson_ratio"),
    ("density", "kg / dm^3", "density"),
    ("thermal_conductivity", "W / (m K)", "conductivity"),
    ("thermal_capacity", "J / (kg K)", "specific_heat"),
)
"""Attribute of a material, its unit, and the key of a body."""

COMPUTED: tuple[tuple[Role, str, str, str], ...] = (
    ("stage", "gear_ratio", "none", "gear_ratio"),
    ("stage", "contact_ratio_worm_stage", "none", "contact_ratio"),
    ("worm", "axial_module", "mm", "module_m"),
    ("worm", "form_factor_worm_gear", "none", "diameter_factor"),
    ("worm", "pressure_angle_worm_gear", "deg", "pressure_angle_deg"),
    ("worm", "lead", "mm", "lead_m"),
    ("worm", "reference_diameter_worm_gear", "mm", "worm_reference_diameter_m"),
    ("wheel", "axial_module", "mm", "module_m"),
    ("wheel", "reference_diameter_worm_gear", "mm", "wheel_reference_diameter_m"),
    ("wheel", "root_diameter_worm_gear", "mm", "wheel_root_diameter_m"),
    ("wheel", "addendum_modification_coefficient_worm_wheel", "none", "profile_shift"),
)
"""Part, attribute, unit, and entry of `Drive.geometry` that it shows where no key gives it."""

BASES = {
    "mineral_oil": "mineral",
    "polyalfaolefin": "PAO",
    "non_water_soluble_polyglycol": "PAG",
    "water_soluble_polyglycol": "PAG",
}
"""Lubricant type of ISO 6336 in the standard -> base stock."""


def in_rexs(value: float, unit: str) -> float:
    """A number in SI in a unit of the standard, without the noise of the conversion."""
    converted = value - ZERO_CELSIUS if unit == "C" else value * PER_SI[unit]
    return float(f"{converted:.15g}")


def in_case(value: float, unit: str) -> str | float:
    """A number in a unit of the standard as a case file has it."""
    written = CASE_UNITS.get(unit, unit)
    return f"{value!r} {written}" if written else value


HAND = {1: "right", -1: "left"}
"""Sign of the lead angle -> hand of the threads."""
