"""Keys of `[bodies.NAME.surface]` as options of `pyworm surface`."""

import argparse
from pathlib import Path
from typing import Any

FILE_KEYS = (
    "spacing", "height_unit", "nesting_index", "shortest_wave", "outliers", "fill", "channel", "crop", "mask",
    "along", "aspect",
)  # fmt: skip
"""Keys of `[bodies.NAME.surface]` that are options beside a file."""

OF_PROFILES = ("along", "aspect")
"""Those with which the file is a profile across the lay."""


def add_keys(surface: argparse.ArgumentParser) -> None:
    """Add the options to the command."""
    surface.add_argument("--spacing", help='point spacing, "0.5 um", if not in the file')
    surface.add_argument("--height-unit", help="unit of the heights, um, if not in the file")
    surface.add_argument("--nesting-index", help='longest wave of roughness, "0.25 mm"')
    surface.add_argument("--shortest-wave", help='cut-off wavelength against noise, "2.5 um"')
    surface.add_argument(
        "--outliers", help="refuse, fill or keep outliers (default: fill them, and say how many)"
    )
    surface.add_argument(
        "--fill", type=float, help="largest fraction of missing points that is filled, 0.1"
    )
    surface.add_argument("--channel", help="name or number of the channel of a file with several")
    surface.add_argument(
        "--crop",
        nargs=4,
        metavar="LENGTH",
        help='part of an area, x from, x to, y from, y to: "0 mm" "1 mm" "0.2 mm" "0.8 mm"',
    )
    surface.add_argument(
        "--mask",
        metavar="FILE",
        help="numbers, .npy or text, that are 0 at points not to be counted",
    )
    surface.add_argument(
        "--along",
        nargs="+",
        metavar="FILE",
        help="profiles along the lay, FILE being one across it: a surface with their spectra is shown",
    )
    surface.add_argument(
        "--aspect",
        type=float,
        help="correlation length along the lay over that across, in the place of profiles along it",
    )


def given_keys(options: argparse.Namespace) -> dict[str, Any]:
    """Keys of `[bodies.NAME.surface]` that are given as options."""
    given = {key: getattr(options, key) for key in FILE_KEYS if getattr(options, key) is not None}
    if str(given.get("channel", "")).isdigit():
        given["channel"] = int(given["channel"])
    for key in ("along", "mask"):  # beside the file, as its own name is
        if key in given:
            names = given[key] if key == "along" else [given[key]]
            whole = [str(Path(name).absolute()) for name in names]
            given[key] = whole if key == "along" else whole[0]
    return given


def keys_of(path: Path, given: dict[str, Any]) -> dict[str, Any]:
    """Keys of a file with those given: its name, and outliers filled, since the table tells their number."""
    if set(given) & set(OF_PROFILES):
        return {"outliers": "fill"} | given | {"across": [path.name]}
    return {"outliers": "fill"} | given | {"file": path.name}
