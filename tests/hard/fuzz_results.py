"""Mutated result and sweep files: whatever is in one, it is used or refused in one sentence.

A mutation changes, drops or renames an attribute, a variable, a group or an entry of what is kept as JSON, or
damages the file. Each mutant is met by one command that reads such files. Pictures are made and not written,
which would take most of the time.
"""

import io
import json
import random
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from shutil import rmtree
from typing import Any
from unittest.mock import patch

import numpy as np
import xarray as xr
from fuzz import CASES, FACTORS, LITTER, LONGEST

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED, FAILED, NOT_CONVERGED
from pyworm.result.netcdf import as_netcdf
from pyworm.result.result import _load, open_result

COARSE = ("--accuracy", "30%")

RUNS = {
    "traction_steel": ("--effects", "isothermal", "--slide-roll-ratio", "0"),
    "line_thermal": ("--effects", "all"),
    "spur_pair": ("--effects", "isothermal", "--phase", "0.3", "0.5", "0.7"),
}
"""Cases whose results are mutated, and how they are solved in a second or so."""

SWEEP = f"""
title = "two loads"
case = "{CASES / "traction_steel.toml"}"
effects = "isothermal"
fixed = {{ accuracy = "30 %", "motion.slide_roll_ratios" = [0, 1] }}
vary = [{{ "contact.load" = ["20 N", "40 N"] }}]
"""

ODD = (
    0, -1, 3.5, np.nan, np.inf, "", "no", "4", "[bold]", "a\nb", [1.0, 2.0], "{", "[1, 2]", "null",
    "9" * 5000,
)  # fmt: skip
"""Attributes that belong nowhere."""


@dataclass(frozen=True)
class Base:
    """A sound file."""

    case: str
    """The case or the sweep that it is of."""
    content: bytes
    """The file."""

    @property
    def commands(self) -> tuple[str, ...]:
        """What reads such files."""
        if self.case == "sweep":
            return ("plot",)
        rated = self.case == "spur_pair"
        return (
            "plot",
            "report",
            "explore",
            *["rate"] * rated,
            *["run"] * (self.case == "traction_steel"),
        )


def bases(directory: Path, names: tuple[str, ...] = (*RUNS, "sweep")) -> list[Base]:
    """Sound files of these cases."""
    built = []
    for name in names:
        out = directory / name
        if name == "sweep":
            (directory / "sweep.toml").write_text(SWEEP)
            command = ["sweep", str(directory / "sweep.toml"), "--out", str(out)]
        else:
            command = ["run", str(CASES / f"{name}.toml"), *COARSE, *RUNS[name], "--out", str(out)]
        with _without_pictures(), redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            main(command)
        built.append(
            Base(name, (out / ("sweep.nc" if name == "sweep" else "result.nc")).read_bytes())
        )
    return built


def mutated(base: Base, rng: random.Random, directory: Path) -> tuple[str, bytes]:
    """What was done to a file, and what became of it."""
    if rng.random() < 0.15:
        return _damaged(base.content, rng)
    file = directory / "sound.nc"
    file.write_bytes(base.content)
    groups = _load(file)
    file.unlink()
    while True:
        name = rng.choice(list(groups))
        changes = [_attribute, _json, _json, _variable, _variable, _group]
        try:
            changed = dict(groups) | {name: groups[name].copy(deep=True)}
            what = rng.choice(changes)(changed, name, rng)
            if what is not None:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    return f"{name}: {what}", bytes(as_netcdf(changed))
        except (ValueError, TypeError, LookupError, AttributeError, OverflowError, RuntimeError):
            continue  # nothing that NetCDF can hold


def outcome(base: Base, command: str, content: bytes, directory: Path) -> tuple[int, list[str]]:
    """Exit code of a command that reads a file, and what is wrong with that."""
    place = directory / "met"
    place.mkdir()
    file = place / "result.nc"
    file.write_bytes(content)
    case = str(CASES / f"{base.case}.toml")
    words = {
        "plot": ["plot", str(file)],
        "report": ["report", str(file)],
        "explore": ["explore", str(file)],
        "rate": ["rate", case, "--result", str(file), "--anyway"],
        "run": ["run", case, *COARSE, *RUNS.get(base.case, ()), "--out", str(place)],
    }[command]
    said, told = io.StringIO(), io.StringIO()
    try:
        with (
            redirect_stdout(told),
            redirect_stderr(said),
            warnings.catch_warnings(),
            _without_pictures(),
        ):
            warnings.simplefilter("ignore")
            code = main(words)
        return code, list(_flaws(command, code, said.getvalue(), told.getvalue(), place))
    except SystemExit as end:
        return -1, [f"ended by {end.code}: {said.getvalue()}"]
    except Exception as error:
        return -1, [f"{type(error).__name__}: {error}"]
    finally:
        rmtree(place)


def _flaws(command: str, code: int, said: str, told: str, place: Path) -> Iterator[str]:
    lines = said.splitlines()
    if any(not line.startswith("pyworm: ") or len(line) > LONGEST for line in lines):
        yield f"not sentences: {said!r:.300}"
    if code == BAD_INPUT:
        if len(lines) != 1 or told:
            yield f"refused by {lines!r:.300}, and printed {told!r:.100}"
    elif code == FAILED:
        if command != "plot" or not said.startswith("pyworm: not drawn: "):
            yield f"failed: {said!r:.300}"
    elif code not in (CONVERGED, NOT_CONVERGED) or (code == NOT_CONVERGED and command != "run"):
        yield f"exit code {code}: {said!r:.300}"
    if command == "run" and not open_result(place / "result.nc").solutions:
        yield "no scenes after a run"
    kept = {".nc", ".html", ".png"}
    for path in place.rglob("*"):
        if path.suffix not in kept or path.name.startswith("."):
            yield f"left {path.name} behind"


MANY = 1000
"""Mutants of result files and of sweep files that are met in the suite, each."""


def many(tell: Callable[[str], None], directory: Path, count: int = MANY) -> list[str]:
    """Meet many mutants; what is wrong with any of them."""
    sound = bases(directory)
    found = []
    for kind in ("result", "sweep"):
        of_kind = [base for base in sound if (base.case == "sweep") == (kind == "sweep")]
        codes: Counter[int] = Counter()
        before = len(found)
        for number in range(count):
            code, flaws = met(of_kind, number, directory)
            codes[code] += 1
            found += flaws
        used = codes[CONVERGED] + codes[NOT_CONVERGED]
        tell(
            f"{count} mutated {kind} files: {codes[BAD_INPUT]} refused in one sentence, {used} used, "
            f"{codes[FAILED]} with pictures told as not drawn, {len(found) - before} flaws"
        )
    return found


def many_explored(
    tell: Callable[[str], None], directory: Path, numbers: range = range(MANY)
) -> list[str]:
    """Make the page to explore of many mutated result files; what is wrong with any of them."""
    sound = bases(directory, tuple(RUNS))
    codes: Counter[int] = Counter()
    found = []
    for number in numbers:
        code, flaws = met(sound, number, directory, "explore")
        codes[code] += 1
        found += flaws
    tell(
        f"{len(numbers)} mutated result files explored: {codes[BAD_INPUT]} refused in one sentence, "
        f"{codes[CONVERGED]} used, {len(found)} flaws"
    )
    return found


def met(
    sound: list[Base], number: int, directory: Path, command: str | None = None
) -> tuple[int, list[str]]:
    """The mutant of a number: exit code of the command that met it, and what is wrong with that.

    The command is drawn where none is given.
    """
    rng = random.Random(number)
    base = rng.choice(sound)
    command = command or rng.choice(base.commands)
    what, content = mutated(base, rng, directory)
    code, flaws = outcome(base, command, content, directory)
    return code, [f"{number}: {command} {base.case}, {what}: {flaw}" for flaw in flaws]


def _without_pictures() -> Any:
    def empty(figure, target, **options):
        if isinstance(target, Path):
            target.write_bytes(b"")

    return patch("matplotlib.figure.Figure.savefig", empty)


def _damaged(content: bytes, rng: random.Random) -> tuple[str, bytes]:
    at, length = rng.randrange(len(content)), rng.choice((1, 40, 4000))
    kind = rng.choice(("cut", "zeros", "other"))
    if kind == "cut":
        return f"cut at {at}", content[:at]
    filling = bytes(length) if kind == "zeros" else rng.randbytes(length)
    return f"{length} {kind} bytes at {at}", content[:at] + filling + content[at + length :]


def _attribute(groups: dict[str, xr.Dataset], name: str, rng: random.Random) -> str | None:
    attributes = groups[name].attrs
    if not attributes:
        return None
    key = rng.choice(list(attributes))
    if rng.random() < 0.3:
        del attributes[key]
        return f"without {key}"
    attributes[key] = rng.choice(ODD)
    return f"{key} = {attributes[key]!r:.40}"


def _json(groups: dict[str, xr.Dataset], name: str, rng: random.Random) -> str | None:
    attributes = groups[name].attrs
    texts = [key for key in ("case", "provenance", "solution", "axes") if key in attributes]
    if not texts:
        return None
    key = rng.choice(texts)
    content = json.loads(attributes[key])
    path = rng.choice(list(_paths(content)))
    inner = content
    for step in path[:-1]:
        inner = inner[step]
    last = path[-1]
    if rng.random() < 0.3:
        del inner[last]
        change = "gone"
    elif isinstance(inner[last], float) and rng.random() < 0.5:
        inner[last] *= rng.choice(FACTORS)
        change = inner[last]
    else:
        inner[last] = change = rng.choice(LITTER)
    attributes[key] = json.dumps(content)
    return f"{key}: {path} {change!r:.40}"


def _paths(content: Any, above: tuple = ()) -> Iterator[tuple]:
    entries = content.items() if isinstance(content, dict) else enumerate(content)
    for key, value in entries:
        yield (*above, key)
        if isinstance(value, dict | list):
            yield from _paths(value, (*above, key))


def _variable(groups: dict[str, xr.Dataset], name: str, rng: random.Random) -> str | None:
    group = groups[name]
    if not group.variables:
        return None
    key = rng.choice(list(group.variables))
    values = group[key].values
    what = rng.choice(("gone", "renamed", "one", "all", "texts", "shorter", "one place", "scaled"))
    if what == "gone":
        groups[name] = group.drop_vars(key)
    elif what == "renamed":
        groups[name] = group.rename({key: "other"})
    elif what == "shorter":
        axis = rng.choice(group[key].dims)
        groups[name] = group.isel({axis: slice(rng.choice((0, 1, 2)))})
    elif what == "one place":
        groups[name] = group.isel({rng.choice(group[key].dims): 0})
    elif what == "texts":
        groups[name] = group.assign({key: (group[key].dims, np.full(values.shape, "no", object))})
    else:
        number = rng.choice((np.nan, np.inf, -1.0, 0.0, 1e300))
        changed = values.astype(float)
        if what == "one":
            changed.flat[rng.randrange(changed.size)] = number
        elif what == "all":
            changed[...] = number
        else:
            with np.errstate(over="ignore"):
                changed *= rng.choice(FACTORS)
        groups[name] = group.assign({key: (group[key].dims, changed, group[key].attrs)})
    return f"{key} {what}"


def _group(groups: dict[str, xr.Dataset], name: str, rng: random.Random) -> str | None:
    if name == "/":
        return None
    group = groups.pop(name)
    if rng.random() < 0.4:
        groups[rng.choice(list(groups))] = group
        return "in place of another"
    if rng.random() < 0.5:
        groups["/scene_999"] = group
        return "as a scene"
    for below in [other for other in groups if other.startswith(f"{name}/")]:
        del groups[below]
    return "gone"
