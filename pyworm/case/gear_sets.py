"""Gear sets from Python: the keys of a case file as arguments, `WormDrive(centre_distance="125 mm", ...)`."""

from typing import Any

from pyworm.case.case import Case, load, subject_kind
from pyworm.case.kinds import case_model
from pyworm.io.input_error import CaseError, models_of, right_key

PHASES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Phases of the mesh cycle to solve where none are given; those without load are omitted."""

TABLES = ("drive", "operation")
"""Tables whose keys are arguments of their own."""


def gear_set(kind: str, *, name: str | None = None, **keys: Any) -> Case:
    """A gear set of any kind, those of other packages too, from the keys of a case file.

    Args:
        kind: Kind of gears, as `drive.kind` of a case file: "worm", "gear-pair", "roller-worm", or that of an
            installed package.
        name: Name in tables and pictures; by default the kind.
        **keys: Keys of the tables `drive` and `operation`, and further tables of the case file (`WormDrive`).

    Raises:
        CaseError: The first error found, as one line.
    """
    model = case_model("drive", subject_kind({"drive": {"kind": kind}}, "drive"))
    tables = {
        key: table
        for table in TABLES
        for inner in models_of(model.model_fields[table].annotation)
        for key in inner.model_fields
        if key != "kind"
    }
    content: dict[str, Any] = {"drive": {"kind": kind}, "operation": {}}
    if "phases" in tables:
        content["operation"]["phases"] = PHASES
    for key, value in keys.items():
        if key in tables:
            content[tables[key]][key] = value
        elif key in model.model_fields and key not in TABLES:
            content[key] = value
        else:
            models = models_of(model.model_fields["drive"].annotation)
            raise CaseError(f"{key}: no such key; {right_key(key, [*models, model], tables)}")
    return load(content, name or kind)


def WormDrive(*, name: str | None = None, **keys: Any) -> Case:  # noqa: N802  a noun: it makes one
    """A worm gear set from its drawing and its operation, checked as a case file is.

        gears = pyworm.WormDrive(
            profile="ZI", centre_distance="100 mm", threads=2, teeth=41, module="4 mm",
            diameter_factor=9, worm_speed="1500 rpm", wheel_torque="500 N m",
            oil=pyworm.named_oil("PAG VG 220").oil("80 degC"), bodies=("16MnCr5", "CuSn12Ni2-C-GZ"),
        )

    Args:
        name: Name in tables and pictures.
        **keys: The keys of the tables `drive` and `operation`, then the other tables of a case file: `worm`,
            `wheel`, `hob`, `cooling`, `worm_rating` and more, as dictionaries. Values are texts with units
            or numbers in SI. `oil` is an `Oil` or a table; `bodies` are two, worm and wheel, each a `Body`, a
            material by name or a table. Without `phases` five of the mesh cycle are solved.

    Raises:
        CaseError: The first error found, as one line.
    """
    return gear_set("worm", name=name, **keys)


def GearPair(*, name: str | None = None, **keys: Any) -> Case:  # noqa: N802  a noun: it makes one
    """A pair of involute gears on parallel axes, from their drawing and operation.

    Args:
        name: Name in tables and pictures.
        **keys: As of `WormDrive`: `pinion` and `gear` are dictionaries, `bodies` are pinion and gear.

    Raises:
        CaseError: The first error found, as one line.
    """
    return gear_set("gear-pair", name=name, **keys)


def RollerWorm(*, name: str | None = None, **keys: Any) -> Case:  # noqa: N802  a noun: it makes one
    """A roller enveloping worm gear set, from its drawing and operation.

    Args:
        name: Name in tables and pictures.
        **keys: As of `WormDrive`: `worm` and `rollers` are dictionaries, `bodies` are worm and rollers.

    Raises:
        CaseError: The first error found, as one line.
    """
    return gear_set("roller-worm", name=name, **keys)
