"""Mutated files for each reader that is not of case files: read, or refused in one sentence, and soon.

Surfaces (numbers in texts, arrays, instruments), deviations of flanks, oils of one's own, gaps, and what
earlier runs have kept. A mutation changes what a number or a line of a text is, or damages the file's bytes.
Readers are called as the program calls them, and what they give back must be finite.
"""

import io
import random
import re
import time
import tomllib
import warnings
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from case_text import case_text
from fuzz import FACTORS, LITTER, LONGEST

from pyworm.case.deviation_file import read_deviations
from pyworm.case.surface import SurfaceTable
from pyworm.formulas.unit_factors import SQUARE_MILLIMETRE
from pyworm.io.bounded_number import read_json
from pyworm.io.input_error import CaseError
from pyworm.io.kept_arrays import DamagedError, kept
from pyworm.materials.oil_file import read_oil
from pyworm.scene.gap_file import read_gap
from pyworm.surfaces.cell_table import _of_arrays

SOON = 5.0
"""Processor time within which a mutant is read or refused [s]."""

NUMBERS = (
    "nan", "inf", "-inf", "-1", "0", "1e308", "-1e308", "1e999", "5e-324", "", "x", "9" * 400, "1,5", "1.5.5",
    "0x10", "1_000", "١٢", "1e", "--1", "\x00", "NULL", "1 2",
)  # fmt: skip
"""What a number in a text is replaced by."""

OIL = """\
name = "Shop oil 12"
source = "data sheet of 2024"
base = "PAO"
viscosity_40 = "225 mm^2/s"
viscosity_100 = "27 mm^2/s"
density_15 = "861 kg/m^3"
"""


@dataclass(frozen=True)
class Reader:
    """A reader of files."""

    name: str
    """What it reads."""
    ending: str
    """The ending of such files."""
    content: bytes
    """A sound file."""
    read: Callable[[Path], Any]
    """Reads a file; ValueError, or OSError with a sentence, where it cannot."""
    kind: str = "bytes"
    """Kind of mutations: "text" and "toml" are mutated as such, "bytes" only as bytes."""


def readers() -> list[Reader]:
    """All readers, each with a sound file."""
    heights = _heights()
    return [
        Reader("surface as csv", "csv", _text(heights, ";"), _surface, "text"),
        Reader("surface as txt", "txt", _text(heights, " "), _surface, "text"),
        Reader("surface as npy", "npy", _saved(np.save, heights), _surface),
        Reader("surface of an instrument", "nc", _instrument(heights), _instrument_surface),
        Reader("deviations", "csv", _deviations(), _read_deviations, "text"),
        Reader("oil", "toml", OIL.encode(), _oil, "toml"),
        Reader("gap as npz", "npz", _saved(np.savez, gap=_bowl(), dx=1e-5, dy=1e-5), _gap),
        Reader("gap as nc", "nc", _gap_netcdf(), _gap),
        Reader("kept arrays", "npz", _saved(np.savez_compressed, **_cell()), _kept),
        Reader("kept numbers", "json", b'{"a": [1, 2.5, null], "b": {"c": -3}}', _json, "text"),
    ]


def _heights() -> np.ndarray:
    return np.random.default_rng(7).normal(scale=0.4, size=(40, 48))


def _text(heights: np.ndarray, delimiter: str) -> bytes:
    stream = io.StringIO()
    np.savetxt(stream, heights, fmt="%.4g", delimiter=delimiter)
    return stream.getvalue().encode()


def _saved(save: Callable, *arrays: Any, **named: Any) -> bytes:
    stream = io.BytesIO()
    save(stream, *arrays, **named)
    return stream.getvalue()


def _instrument(heights: np.ndarray) -> bytes:
    """Heights as SurfaceTopography writes them, a NetCDF file."""
    from SurfaceTopography import Topography

    sides = tuple(0.5 * count for count in heights.shape)
    with TemporaryDirectory() as directory:
        file = Path(directory) / "flank.nc"
        Topography(heights, sides, unit="um").to_netcdf(str(file))
        return file.read_bytes()


def _deviations() -> bytes:
    rows = [
        f"{face},{radius},{face * 0.3 + radius * 0.01:.3g}"
        for face in range(-3, 4)
        for radius in range(80, 90, 3)
    ]
    return "\n".join(["face_mm,radius_mm,deviation_um", *rows, ""]).encode()


def _bowl() -> np.ndarray:
    axis = 1e-5 * np.arange(-12, 13)
    return (axis[:, None] ** 2 + axis**2) / 0.02


def _gap_netcdf() -> bytes:
    import xarray as xr

    axis = 1e-5 * np.arange(-12, 13)
    return bytes(
        xr.Dataset({"gap": (("y", "x"), _bowl())}, coords={"x": axis, "y": axis}).to_netcdf(
            engine="netcdf4"
        )
    )


def _cell() -> dict[str, Any]:
    from dataclasses import fields

    from pyworm.surfaces.cell_table import CellTable

    return {one.name: np.linspace(1, 2, 12) for one in fields(CellTable)} | {"height": 1.0}


def _surface(path: Path, **given: Any) -> None:
    table = SurfaceTable.model_validate(
        {"file": path.name, "spacing": "0.5 um", "height_unit": "um"}
    )
    table.lie_in(path.parent)
    _require_finite(table.waves().roughness.height)


def _instrument_surface(path: Path) -> None:
    table = SurfaceTable.model_validate({"file": path.name})
    table.lie_in(path.parent)
    _require_finite(table.waves().roughness.height)


def _read_deviations(path: Path) -> None:
    for numbers in read_deviations(path, "face_mm").values():
        _require_finite(np.array(numbers))


def _oil(path: Path) -> None:
    oil = read_oil(path)
    oil.oil(333.15)
    _require_finite(np.array([oil.kinematic_viscosity(353.15) / SQUARE_MILLIMETRE]))


def _gap(path: Path) -> None:
    height, covered = read_gap(path)(np.zeros((1, 1)), np.zeros((1, 1)))
    _require_finite(height[covered])


def _kept(path: Path) -> None:
    kept(path, _of_arrays)


def _json(path: Path) -> None:
    read_json(path.read_bytes())


def _require_finite(values: np.ndarray) -> None:
    if not np.isfinite(values).all():
        raise AssertionError("what was read is not finite everywhere")


def mutated(reader: Reader, rng: random.Random) -> tuple[str, bytes]:
    """What was done to a sound file, and what became of it."""
    if reader.kind == "text" and rng.random() < 0.7:
        return _mutated_text(reader.content.decode(), rng)
    if reader.kind == "toml" and rng.random() < 0.7:
        return _mutated_tables(tomllib.loads(reader.content.decode()), rng)
    return _damaged(reader.content, rng)


def _mutated_text(text: str, rng: random.Random) -> tuple[str, bytes]:
    lines = text.splitlines()
    at = rng.randrange(len(lines))
    what = rng.choice(
        ("number", "number", "scaled", "gone", "twice", "swapped", "delimiter", "ends", "encoding")
    )
    if what in ("number", "scaled"):
        found = list(re.finditer(r"-?\d+\.?\d*(e-?\d+)?", lines[at]))
        if found:
            one = rng.choice(found)
            new = rng.choice(NUMBERS)
            if what == "scaled":
                new = f"{float(one[0]) * rng.choice(FACTORS):g}"
            lines[at] = lines[at][: one.start()] + new + lines[at][one.end() :]
            what = f"{one[0]} is {new:.20}"
    elif what == "gone":
        del lines[at]
    elif what == "twice":
        lines.insert(at, lines[at])
    elif what == "swapped":
        lines[at], lines[0] = lines[0], lines[at]
    elif what == "delimiter":
        old, new = rng.choice(";, "), rng.choice(";,\t |")
        lines = [line.replace(old, new) for line in lines]
    elif what == "ends":
        return what, "\r\n".join(lines).encode()
    else:
        return what, text.encode(rng.choice(("utf-16", "utf-8-sig", "utf-32")))
    return f"{what} in line {at}", "\n".join(lines).encode("utf-8", "surrogatepass")


def _mutated_tables(tables: dict[str, Any], rng: random.Random) -> tuple[str, bytes]:
    key = rng.choice(list(tables))
    what = rng.choice(("value", "value", "without", "renamed"))
    if what == "value":
        tables[key] = rng.choice([one for one in LITTER if not isinstance(one, dict | list)])
        what = f"{key} = {tables[key]!r:.40}"
    else:
        value = tables.pop(key)
        if what == "renamed":
            tables[rng.choice(("x", "viscosity_index", "alpha", ""))] = value
        what = f"{key} {what}"
    return what, case_text(tables).encode("utf-8", "surrogatepass")


def _damaged(content: bytes, rng: random.Random) -> tuple[str, bytes]:
    at, length = rng.randrange(len(content)), rng.choice((1, 1, 4, 40, 4000))
    kind = rng.choice(("cut", "zeros", "other", "inserted", "nothing", "flipped"))
    if kind == "cut":
        return f"cut at {at}", content[:at]
    if kind == "nothing":
        return "an empty file", b""
    if kind == "inserted":
        return f"{length} bytes inserted at {at}", content[:at] + rng.randbytes(length) + content[
            at:
        ]
    if kind == "flipped":
        flipped = bytearray(content)
        flipped[at] ^= 1 << rng.randrange(8)
        return f"a bit flipped at {at}", bytes(flipped)
    filling = bytes(length) if kind == "zeros" else rng.randbytes(length)
    return f"{length} {kind} bytes at {at}", content[:at] + filling + content[at + length :]


def outcome(reader: Reader, content: bytes, directory: Path) -> tuple[str, list[str]]:
    """Whether a file was "read" or "refused", and what is wrong with that."""
    path = directory / f"mutant.{reader.ending}"
    path.write_bytes(content)
    begun = time.process_time()
    flaws, what = [], "read"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            reader.read(path)
    except (CaseError, DamagedError, ValueError) as error:
        what = "refused"
        if "\n" in str(error) or not 0 < len(str(error)) <= LONGEST:
            flaws.append(f"not one sentence: {error!s:.300}")
    except Exception as error:
        flaws.append(f"{type(error).__name__}: {error!s:.300}")
    finally:
        path.unlink()
    taken = time.process_time() - begun
    if taken > SOON:
        flaws.append(f"took {taken:.1f} s")
    return what, flaws


MANY = 1000
"""Mutants of each reader in the suite."""


def many(tell: Callable[[str], None], directory: Path, count: int = MANY) -> list[str]:
    """Read many mutants by each reader; what is wrong with any of them."""
    found = []
    for reader in readers():
        outcomes, flaws = met(reader, range(count), directory)
        found += flaws
        tell(
            f"{count} mutated files, {reader.name}: {outcomes['refused']} refused in one sentence, "
            f"{outcomes['read']} read, {len(flaws)} flaws"
        )
    return found


def met(reader: Reader, numbers: range, directory: Path) -> tuple[Counter[str], list[str]]:
    """Mutants of a reader by their numbers: how many were read and refused, and what is wrong."""
    outcomes: Counter[str] = Counter()
    found = []
    for number in numbers:
        what, content = mutated(reader, random.Random(f"{reader.name} {number}"))
        came_to, flaws = outcome(reader, content, directory)
        outcomes[came_to] += 1
        found += [f"{reader.name} {number}, {what}: {flaw}" for flaw in flaws]
    return outcomes, found
