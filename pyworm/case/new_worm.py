"""Text of a new case file about a worm drive, from the numbers of its drawing."""

import json
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from pyworm.drives.worm.flanks.worm_profiles import PROFILES

ASKED = {
    "centre_distance": ("centre distance", "100 mm"),
    "threads": ("threads of the worm", "2"),
    "teeth": ("teeth of the wheel", "41"),
    "module": ("axial module", "4 mm"),
    "diameter_factor": ("diameter factor q", "10"),
    "worm_speed": ("speed of the worm", "1500 1/min"),
    "wheel_torque": ("torque of the wheel", "600 Nm"),
    "worm_material": ("material of the worm", "16MnCr5"),
    "wheel_material": ("material of the wheel", "CuSn12Ni2-C-GZ"),
    "oil": ("oil", "PAG VG 220"),
    "oil_temperature": ("temperature of the oil", "80 C"),
    "life": ("rated life in operating hours", "25000 h"),
    "application_factor": ("application factor K_A, 1 for uniform load", "1.25"),
}
"""Number of the drawing or of the duty that has to be known -> what it is called, and an example."""

OPTIONAL = {
    "profile": ("flank profile, one of " + ", ".join(PROFILES), "ZI"),
    "pressure_angle": ("pressure angle in the section that defines the profile", "20 deg"),
    "face_width": ("face width of the wheel", "30 mm"),
    "hand": ("hand of the threads", "right"),
    "hob_oversize": ("hob reference diameter minus that of the worm", "1.6 mm"),
    "starts_per_hour": ("starts per hour, which wear the wheel", "2"),
    "ambient_temperature": ("ambient temperature", "20 C"),
}
"""Number that may be left out, likewise."""

PLAIN = ("threads", "teeth", "diameter_factor", "application_factor", "starts_per_hour")
"""Those that are numbers without unit."""

CASE_KEYS = {
    **{
        key: f"drive.{key}"
        for key in (
            *("centre_distance", "threads", "teeth", "module", "diameter_factor"),
            *("profile", "pressure_angle", "face_width", "hand"),
        )
    },
    "worm_speed": "operation.worm_speed",
    "wheel_torque": "operation.wheel_torque",
    "worm_material": "bodies.worm.material",
    "wheel_material": "bodies.wheel.material",
    "oil": "oil.name",
    "oil_temperature": "oil.temperature",
    "hob_oversize": "drive.hob.oversize",
    **{
        key: f"worm_rating.{key}"
        for key in ("life", "application_factor", "starts_per_hour", "ambient_temperature")
    },
}
"""Number of `ASKED` or `OPTIONAL` -> its key in a case file."""

_COMMENTS = {
    "centre_distance": "a",
    "threads": "z1",
    "teeth": "z2",
    "module": "axial, m",
    "diameter_factor": "q, reference diameter of the worm over the module",
    "pressure_angle": "normal, at the worm's reference cylinder; of ZA axial, of ZN the blade's, of ZK and "
    "ZC the disc's",
    "face_width": "of the wheel",
}


PHASES = (0.2, 0.4, 0.55, 0.7, 0.9)
"""Phases to be solved where a tooth pair carries load all along. None in the first fifth: a transient
solution begins with a steady film where the flanks meet, whose influence fades as they move on."""

MIN_LOAD_SHARE = 0.1
"""Load of a tooth pair over its largest one below which no phase is proposed: there tips and roots barely
touch, and a film says nothing about the drive."""

_SOUGHT = 41
"""Phases at which the load is looked at."""


def loaded_phases(load: Callable[[float], float]) -> tuple[float, ...]:
    """Phases to solve, `PHASES` of the part of a mesh cycle under load, by the load at a phase."""
    phases = np.linspace(0, 1, _SOUGHT)
    loads = np.array([load(phase) for phase in phases])
    carrying = phases[loads > MIN_LOAD_SHARE * loads.max()]
    first, last = float(carrying[0]), float(carrying[-1])
    return tuple(round(first + (last - first) * part, 3) for part in PHASES)


def new_worm_text(
    answers: Mapping[str, str],
    title: str,
    assumed: Sequence[str] = (),
    phases: Sequence[float] = PHASES,
) -> str:
    """The case file of a worm drive from the numbers of `ASKED` and `OPTIONAL`, as they stand on a drawing.

    Usual values of what is not given (`WormDrive.assumed`) stand in it as comments.
    """
    rows = {"": _drive_rows(answers), "worm": [], "wheel": [], "hob": []}
    if "hob_oversize" in answers:
        oversize = _toml("hob_oversize", answers["hob_oversize"])
        rows["hob"].append(f"oversize = {oversize} # on the reference diameter")
    for choice in assumed:
        key, _, rest = choice.partition(" = ")
        value, _, words = rest.partition(", ")
        part, _, name = key.rpartition(".")
        rows[part].append(f"# {name} = {json.dumps(value)} # default: {words}")
    drive = "\n\n".join(
        "\n".join([f"[drive.{part}]" if part else "[drive]", *lines])
        for part, lines in rows.items()
        if lines
    )
    return _TEXT.format(
        title=json.dumps(title, ensure_ascii=False),
        drive=drive,
        rating="\n".join(_rating_rows(answers)),
        phases=", ".join(f"{phase:g}" for phase in phases),
        **{key: _toml(key, answers[key]) for key in _AFTER},
    )


def _drive_rows(answers: Mapping[str, str]) -> list[str]:
    """Rows of `[drive]`, each with its comment."""
    profile = answers.get("profile", "ZI")
    what = {str(name): words for name, words in PROFILES.items()}.get(profile, "form of the flanks")
    rows = ['kind = "worm"', f"profile = {json.dumps(profile)} # {what}"]
    for key in (*ASKED, *OPTIONAL):
        if key in answers and key not in (*_AFTER, *_RATED, "hob_oversize", "profile"):
            comment = f" # {_COMMENTS[key]}" if key in _COMMENTS else ""
            rows.append(f"{key} = {_toml(key, answers[key])}{comment}")
    return rows


def _rating_rows(answers: Mapping[str, str]) -> list[str]:
    """Rows of `[worm_rating]`; what is left out stands as a comment with its usual value."""
    return [
        f"{key} = {_toml(key, answers[key])} # {words}"
        if key in answers
        else f"# {key} = {_toml(key, usual)} # if not given; {words}"
        for key, (usual, words) in _RATED.items()
    ]


def answer_value(key: str, answer: str) -> str | int | float:
    """An answer as a value of a case file: a number where it has no unit, else a text."""
    if key in PLAIN and answer.replace(".", "", 1).isdigit():
        return int(answer) if answer.isdigit() else float(answer)
    return answer


def _toml(key: str, answer: str) -> str:
    """An answer as TOML has it: a number alone where it has no unit, else a text."""
    value = answer_value(key, answer)
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else answer


_AFTER = (
    *("worm_speed", "wheel_torque", "worm_material", "wheel_material"),
    *("oil", "oil_temperature"),
)
"""Numbers outside of `[drive]`."""

_RATED = {
    "life": ("25000 h", "hours of running"),
    "application_factor": ("1", "K_A on the torque"),
    "starts_per_hour": ("0", "they wear the wheel"),
    "ambient_temperature": ("20 C", "of the surroundings"),
}
"""Numbers of `[worm_rating]` -> usual values, and their comments."""

_TEXT = """\
title = {title}
source = "Drawing of the gear unit"
accuracy = "5 %" # maximum numerical error of films and pressures

# As drawn, in the terms of DIN 3975 and ISO 1122-2. Keys behind a # show their defaults:
# take the # away where the drawing has another one. pyworm check prints the whole drawing back.

{drive}

# phases: places in the mesh of a pair of teeth at which its film is solved, from 0, where it meets, to 1;
# spread over those at which it carries load.

[operation]
worm_speed = {worm_speed}
wheel_torque = {wheel_torque}
phases = [{phases}]

# Constants of materials come by name; any of them may stand with it. finish: the usual roughness of flanks
# so made; roughness_ra = "0.4 um" in its place gives a measured one.

[bodies.worm]
material = {worm_material}
finish = "ground"

[bodies.wheel]
material = {wheel_material}
finish = "run-in"

[oil]
name = {oil}
temperature = {oil_temperature} # where it enters the contact

# pyworm rate: the safeties of ISO/TS 14521 and DIN 3996. Materials, oil, temperature and roughness are those
# above. [drive.shaft] gives the bearings of the worm, on which the deflection of its shaft depends.

[worm_rating]
{rating}
"""
