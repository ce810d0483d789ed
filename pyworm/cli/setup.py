"""pyworm setup: the hob's set-up for a wanted contact pattern, its regrinding, and the wheel's shim."""

import argparse
from collections.abc import Sequence
from math import isfinite, isnan
from pathlib import Path

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_json
from pyworm.cli.shared import CONVERGED, NOT_CONVERGED, option_value, warn_of_unusual
from pyworm.drives.answers import Row
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity import SHARE_KIND, Kind
from pyworm.io.terminal import print_message, print_result

PLACE = Kind("a place along the face", "m", "2 mm", sign="any", possible=("1e-24 m", "5 m"))

DRY, FILM = QUANTITIES["dry_pressure_max"], QUANTITIES["film_central"]

COLUMNS = {
    "hob_oversize_m": ("Hob oversize, mm", 1e3, ".3f"),
    "hob_swivel_deg": ("Hob swivel, °", 1.0, ".4f"),
    "hob_axial_shift_m": ("Hob axial shift, mm", 1e3, ".3f"),
    "hob_centre_distance_m": ("Hob centre distance, mm", 1e3, ".3f"),
    "marking_face_m": ("Pattern centre along the face, mm", 1e3, ".1f"),
    "marking_fraction": ("Marked share of the flank, %", 100.0, ".1f"),
    "contact_ratio": ("Contact ratio", 1.0, ".2f"),
    "radius_long_m": ("Long radius at mid-mesh, mm", 1e3, ".0f"),
    "radius_short_m": ("Short radius at mid-mesh, mm", 1e3, ".1f"),
    DRY.key: (f"{DRY.title()}, {DRY.shown}", DRY.scale, ".0f"),
    "formula_film_m": (f"{FILM.title()} by formula, {FILM.shown}", FILM.scale, ".3f"),
}
"""Key -> its words, the factor to the shown unit, and the format."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    setup = commands.add_parser(
        "setup",
        help="hob settings for a contact pattern, hob life, and shim of the wheel",
    )
    setup.add_argument("case", type=Path, metavar="CASE.toml")
    setup.add_argument(
        "--place",
        help='centre of the required pattern along the face, "2 mm", positive to the leaving side',
    )
    setup.add_argument("--size", help='required marked share of the flank, "30%%"')
    setup.add_argument(
        "--shim",
        nargs="?",
        const="",
        metavar="PLACE",
        help="shim of the wheel that restores the nominal pattern, or sets its centre to a position, "
        '"2 mm"',
    )
    add_json(setup)
    setup.set_defaults(command=_setup)


def _setup(options: argparse.Namespace) -> int:
    wanted = _wanted(options)
    case = load(options.case)
    if options.shim is not None:
        return _shim(case, options, wanted.get("shim"))

    from pyworm.case.hob_setup import case_setup

    setup = case_setup(case, wanted, options.case, lambda words: print_message(f"warning: {words}"))
    warn_of_unusual(case)
    if options.json:
        print_json({"case": case.name, **setup.summary()})
    else:
        proposed = {} if setup.proposed is None else {"proposed": setup.proposed}
        _print({"current": setup.current} | proposed, setup.hob_life)
        _print_allowed(setup.allowed_errors or {})
    if not setup.reached:
        print_message(
            "warning: no set-up near the present one has that pattern without the worm cutting into the "
            "wheel or teeth parting before the next ones meet; the nearest is shown"
        )
    return CONVERGED if setup.reached else NOT_CONVERGED


def _shift_in_words(shift: float) -> str:
    """The shift of the wheel [m], to the micrometre that a shim has."""
    amount = f"{abs(shift) * 1e3:.3f}"
    if float(amount) == 0:
        return "The wheel needs no shift."
    return f"Shift the wheel {amount} mm to the {'leaving' if shift > 0 else 'entering'} side."


def _shim(case: Case, options: argparse.Namespace, wanted: float | None) -> int:
    """The shim under the wheel, told to a fitter."""
    if options.place or options.size:
        raise CaseError(
            "--shim moves the wheel that is cut; omit --place and --size, which set the hob"
        )
    from pyworm.case.hob_setup import case_shim

    shim = case_shim(case, wanted, options.case)
    if options.json:
        content = {f"{key}_m": value for key, value in vars(shim).items() if key != "reached"}
        print_json({"case": case.name, "reached": shim.reached, "shim": content})
    else:
        print_result(_shift_in_words(shim.shift))
        for flank, before, after in (
            ("driven flank", shim.before, shim.after),
            ("other flank", shim.other_before, shim.other_after),
        ):
            if isnan(before) or isnan(after):
                print_result(
                    f"The {flank} touches on no tooth {'without' if isnan(before) else 'with'} the shim."
                )
                continue
            print_result(
                f"Pattern centre on the {flank}: from {before * 1e3:+.2f} mm to {after * 1e3:+.2f} mm."
            )
        print_result(f"Required on the driven flank: {shim.wanted * 1e3:+.2f} mm.")
        print_result("Positions are along the face, + towards the leaving side.")
    if not shim.reached:
        print_message(
            "warning: no shim brings the pattern there; the nearest that was found is shown"
        )
    return CONVERGED if shim.reached else NOT_CONVERGED


def _wanted(options: argparse.Namespace) -> dict[str, float]:
    """What is asked of the pattern: `face` and `size` as `found_setting` takes them, `shim` a place [m]."""
    wanted = {}
    for name, option, kind in (
        ("face", "place", PLACE),
        ("size", "size", SHARE_KIND),
        ("shim", "shim", PLACE),
    ):
        if text := getattr(options, option):
            wanted[name] = option_value(option, text, kind)
    if not 0 < wanted.get("size", 0.5) < 1:
        raise CaseError(f"--size {options.size}: must lie between 0 and 100 %")
    return wanted


def _print(rows: dict[str, Row], life: Sequence[Row]) -> None:
    """Tables of the set-ups, and of the hob's life."""
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    def shown(title: str, columns: dict[str, Row]) -> None:
        lines = []
        for key, (words, factor, form) in COLUMNS.items():
            if any(key in row for row in columns.values()):
                values = (row[key] * factor for row in columns.values())
                cells = (f"{value:{form}}" if isfinite(value) else "at edge" for value in values)
                lines.append((words, *cells))
        Console().print(Table(("", *columns), tuple(lines), title))

    shown("Set-up of the hob", rows)
    if "proposed" in rows:
        found = rows["proposed"]
        print_result(
            f'\n[drive.hob]\nswivel = "{found["hob_swivel_deg"]:.5f} deg"\n'
            f'axial_shift = "{found["hob_axial_shift_m"] * 1e3:.4f} mm"\n'
            f'centre_distance = "{found["hob_centre_distance_m"] * 1e3:.4f} mm"\n'
        )
    if life:
        shown(
            "The hob over its service life, swivelled anew after each regrinding",
            {f"{row['hob_oversize_m'] * 1e3:.3g} mm left": row for row in life},
        )


def _print_allowed(allowed: dict[str, dict[str, float | str]]) -> None:
    """The errors of the assembly that the drive allows, each alone."""
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    rows = []
    for entry, row in allowed.items():
        unit, factor, shown = ("m", 1e3, "mm") if "from_m" in row else ("deg", 1.0, "°")
        cells = []
        for end in ("from", "to"):
            value = float(row[f"{end}_{unit}"]) * factor
            cells += [f"{value:+.3f} {shown}", str(row[f"{end}_limited_by"])]
        rows.append((f"assembly.{entry}", *cells))
    head = "Parameter", "Lower limit", "set by", "Upper limit", "set by"
    Console().print(Table(head, tuple(rows), "Allowed assembly errors, each alone", texts=(2, 4)))
