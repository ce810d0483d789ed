"""Mutated case files: whatever is in one, it runs or is refused in one sentence, and nothing else happens.

All are planned, some are rated or have their films emulated; of cases that are solved in a second, those that
can be planned are solved too.

A mutation changes what one key holds, drops, renames or adds one, or damages the file's text. Extreme values
are meant to get through the schema and to be met by what makes scenes and plans of them.
"""

import io
import json
import tomllib
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from shutil import rmtree
from typing import Any
from unittest.mock import patch

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from trial import flaws as flaws_of_solution

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED, NOT_CONVERGED
from pyworm.io.input_error import toml
from pyworm.io.stage import STILL_WORKING
from pyworm.result.result import open_result

CASES = Path(__file__).parents[2] / "cases"

DATA = Path(__file__).parents[1] / "data"

QUICK = (
    "point_m20_l10", "line_thermal", "traction_steel", "gap_example", "spin_zi_like", "impact_ball",
    "starved_ball", "reversal_line", "attacked_line",
)  # fmt: skip
"""Cases that are checked in milliseconds."""

SLOW = ("zi_sharif_2001", "worm_drawing", "spur_pair", "errichello_speed_increaser", "roller_ref")
"""Drives, which take a second."""

RATED = ("bearing_nu2210", "oil_zi", "errichello_speed_increaser", "attacked_pair")
"""Cases that are rated in a second."""

LITTER = (
    0, 1, -1, 3.5, 1e308, -1e308, 5e-324, float("nan"), float("inf"), -float("inf"), 10**400,
    True, "", " ", "0", "m", "1", "1 m", "-1 m", "nan m", "inf N", "1e999 m", "1e-320 m/s",
    "1 furlong", "1 m m m", "1,5 mm", "1.5.5 mm", "°", "\u0000", "\u202e14 kN", "ü" * 300, "{0.__class__}",
    "%s%n", "../../etc/passwd", [], [1], ["1 m"] * 2, ["1 m/s"] * 3, [[["1 m"]]], {}, {"kind": "gap"},
    {"": 1}, "auto", "all", "roelands", "point-contact",
)  # fmt: skip
"""Values that belong nowhere, or somewhere else."""

FACTORS = (0.0, -1.0, 1e-30, 1e-12, 1e-6, 1e-3, 0.5, 2.0, 1e3, 1e6, 1e12, 1e30, 1e300)
"""What a number is multiplied by."""


@dataclass(frozen=True)
class Mutant:
    """A mutated case file."""

    base: str
    """The case that it was."""
    what: str
    """What was done to it."""
    key: str | None
    """The key whose value was changed, where it was one."""
    content: bytes
    """The file."""


def mutants(bases: tuple[str, ...]) -> st.SearchStrategy[Mutant]:
    """Mutants of these cases."""
    return st.sampled_from(bases).flatmap(lambda base: _OF_CASE[base])


def outcome(
    mutant: Mutant, directory: Path, command: Sequence[str] = ("check",), result: Path | None = None
) -> tuple[int, str, list[str]]:
    """Exit code of a command on a mutant, what it said, and what is wrong with that.

    `result` is the file that the command may leave; of one that leaves none only success is no flaw.
    """
    before = {directory / "case.toml", *directory.rglob("*")}
    case = directory / "case.toml"
    case.write_bytes(mutant.content)
    said, told = io.StringIO(), io.StringIO()
    try:
        with redirect_stdout(told), redirect_stderr(said), warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            code = main([command[0], str(case), "--json", *command[1:]])
    except SystemExit as end:
        code = int(end.code)
    except Exception as error:
        return -1, "", [f"{type(error).__name__}: {error}"]
    finally:
        case.unlink()
    sentence = "".join(
        line
        for line in said.getvalue().splitlines(keepends=True)
        if not line.startswith(f"pyworm: {STILL_WORKING} ")
    )
    left = {*directory.rglob("*")} - before
    flaws = []
    if code == BAD_INPUT:
        flaws += _flaws_of_sentence(sentence, mutant)
        if told.getvalue():
            flaws.append("refused, and printed something")
    elif code == CONVERGED or (code == NOT_CONVERGED and result is not None):
        json.loads(told.getvalue())
        if result is not None:
            flaws += _flaws_of_result(result, code)
            left -= {result, result.parent}
    else:
        flaws.append(f"exit code {code}: {sentence}")
    return code, sentence, flaws + [f"left {path.name} behind" for path in sorted(left)]


SMALL_GRID = 50_000
"""Nodes of the largest grid on which mutants are solved: two or three grids, a second of work."""

SHORTER = {"traction_steel": ("--slide-roll-ratio", "0.5")}
"""What leaves one scene of cases with several."""


def solved(mutant: Mutant, directory: Path) -> tuple[int, str, list[str]]:
    """The same of a mutant that is run, if it can be planned; without pictures and on small grids."""
    planned = outcome(mutant, directory)
    if planned[0] != CONVERGED:
        return planned
    out = directory / "out"
    command = ("run", "--accuracy", "30%", "--out", str(out), *SHORTER.get(mutant.base, ()))
    with (
        patch("pyworm.plots.draw.draw", lambda *given, **options: []),
        patch("pyworm.planning.discretisation.LARGEST_GRID", SMALL_GRID),
    ):
        run = outcome(mutant, directory, command, out / "result.nc")
    if out.exists():
        rmtree(out)
    return run


def rated(mutant: Mutant, directory: Path) -> tuple[int, str, list[str]]:
    """The outcome of a mutant that is rated."""
    return outcome(mutant, directory, ("rate",))


def filmed(mutant: Mutant, directory: Path) -> tuple[int, str, list[str]]:
    """The outcome of a mutant whose films are emulated."""
    return outcome(mutant, directory, ("film", *SHORTER.get(mutant.base, ())))


def _flaws_of_result(file: Path, code: int) -> Iterator[str]:
    """A result that does not hold what its exit code says, or scenes that make no sense."""
    solutions = open_result(file).solutions
    if (code == CONVERGED) != all(solution.converged for solution in solutions):
        yield f"exit code {code} of scenes that are marked otherwise"
    for solution in solutions:
        yield from flaws_of_solution(solution)


MANY = {QUICK: 3000, SLOW: 120}
"""Mutants of each group of cases that are planned in the suite."""

MANY_RATED, MANY_FILMED = 1000, 1000
"""Mutants that are rated, and whose films are emulated."""

MANY_SOLVED = 800
"""Mutants that are solved where they can be planned, as every fourth can."""


def many(tell: Callable[[str], None], directory: Path) -> list[str]:
    """Plan many mutants of all cases, and solve some; what is wrong with any of them."""
    codes: Counter[int] = Counter()
    found: list[str] = []

    def meet(bases: tuple[str, ...], count: int, judge: Callable) -> None:
        @seed(count)
        @settings(
            max_examples=count,
            deadline=None,
            database=None,
            phases=[Phase.generate],
            suppress_health_check=list(HealthCheck),
        )
        @given(mutants(bases))
        def one(mutant: Mutant) -> None:
            code, _, flaws = judge(mutant, directory)
            codes[code] += 1
            found.extend(f"{mutant.base}, {mutant.what}: {flaw}" for flaw in flaws)

        one()

    for planned, count in MANY.items():
        meet(planned, count, outcome)
    tell(
        f"{codes.total()} mutated cases: {codes[BAD_INPUT]} refused in one sentence, {codes[CONVERGED]} "
        f"planned, {len(found)} flaws"
    )
    for bases, count, judge, what in (
        (RATED, MANY_RATED, rated, "rated"),
        (QUICK, MANY_FILMED, filmed, "with films"),
    ):
        codes.clear()
        meet(bases, count, judge)
        tell(
            f"{codes.total()} more: {codes[BAD_INPUT]} refused, {codes[CONVERGED]} {what}, "
            f"{len(found)} flaws in all"
        )
    codes.clear()
    meet(QUICK, MANY_SOLVED, solved)
    tell(
        f"{codes.total()} more: {codes[BAD_INPUT]} refused, {codes[CONVERGED]} converged, "
        f"{codes[NOT_CONVERGED]} marked as not converged, {len(found)} flaws in all"
    )
    return found


def _flaws_of_sentence(sentence: str, mutant: Mutant) -> Iterator[str]:
    if not (
        sentence.startswith("pyworm: ") and sentence.count("\n") == 1 and sentence.endswith("\n")
    ):
        yield f"not one sentence: {sentence!r}"
    if len(sentence) > LONGEST:
        yield f"a sentence of {len(sentence)} characters"
    if mutant.key is not None and mutant.key not in sentence and not _names_more(sentence):
        yield f"{mutant.key} was changed and is not named in: {sentence!r}"


LONGEST = 1000
"""Characters of a sentence that people still read."""

_OF_SEVERAL = (
    "check their units",  # values that only together are out of proportion
    "entrain no oil",
    "give either",
    "is missing",
    "no such key",
    "relative radii",
    "heat needs",
    "the gap does not rise",
    "thermal loading",
    "is at rest",
)


def _names_more(sentence: str) -> bool:
    """Whether it is about what several keys, of which it names some, come to together."""
    return any(words in sentence for words in _OF_SEVERAL)


def _mutants_of(base: str) -> st.SearchStrategy[Mutant]:
    text = next(
        path for path in (CASES / f"{base}.toml", DATA / f"{base}.toml") if path.is_file()
    ).read_text()
    tables = tomllib.loads(text)
    if "file" in tables.get("contact", {}):
        tables["contact"]["file"] = str(CASES / tables["contact"]["file"])
    places = list(_places(tables))
    place = st.sampled_from(places)

    def of_tables(
        what: str, change: Callable[[dict[str, Any], str, Any], None]
    ) -> Callable[[tuple], Mutant]:
        def make(drawn: tuple) -> Mutant:
            path, extra = drawn
            fresh = (
                tomllib.loads(text) | {"contact": tables["contact"]}
                if "contact" in tables
                else tables
            )
            fresh = json.loads(json.dumps(fresh))
            table = fresh
            for key in path[:-1]:
                table = table[key]
            change(table, path[-1], extra)
            named = path[-1] if what == "value" else None
            content = "\n".join(_lines(fresh)).encode("utf-8", "surrogatepass")
            return Mutant(base, f"{what} {'.'.join(path)} {extra!r:.60}", named, content)

        return make

    def put(table: dict[str, Any], key: str, value: Any) -> None:
        table[key] = value

    def scale(table: dict[str, Any], key: str, factor: float) -> None:
        table[key] = _scaled(table[key], factor)

    def drop(table: dict[str, Any], key: str, _: Any) -> None:
        del table[key]

    def rename(table: dict[str, Any], key: str, name: str) -> None:
        table[name] = table.pop(key)

    def add(table: dict[str, Any], key: str, name: str) -> None:
        table[name] = table[key]

    names = st.sampled_from(
        ["lod", "kind", "law", "x", "", "a b", "ü", "load", "velocity_1", "z", "heat"]
    )
    return st.one_of(
        st.tuples(place, st.sampled_from(LITTER)).map(of_tables("value", put)),
        st.tuples(place, st.sampled_from(FACTORS)).map(of_tables("value", scale)),
        st.tuples(place, st.none()).map(of_tables("without", drop)),
        st.tuples(place, names).map(of_tables("renamed", rename)),
        st.tuples(place, names).map(of_tables("twice", add)),
        _damaged(base, text.encode()),
    )


def _damaged(base: str, content: bytes) -> st.SearchStrategy[Mutant]:
    """Cut short, with bytes in the wrong place, or without some."""
    where = st.integers(0, len(content))
    cut = where.map(lambda at: Mutant(base, f"cut at {at}", None, content[:at]))
    inserted = st.tuples(where, st.binary(min_size=1, max_size=4)).map(
        lambda drawn: Mutant(
            base,
            f"{drawn[1]!r} at {drawn[0]}",
            None,
            content[: drawn[0]] + drawn[1] + content[drawn[0] :],
        )
    )
    neglected_effects = st.tuples(where, st.integers(1, 40)).map(
        lambda drawn: Mutant(
            base,
            f"without {drawn[1]} bytes at {drawn[0]}",
            None,
            content[: drawn[0]] + content[drawn[0] + drawn[1] :],
        )
    )
    return st.one_of(cut, inserted, neglected_effects)


def _places(tables: dict[str, Any], above: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Every key, and every table."""
    for key, value in tables.items():
        yield (*above, key)
        if isinstance(value, dict):
            yield from _places(value, (*above, key))


def _scaled(value: Any, factor: float) -> Any:
    """Numbers in a value times a factor."""
    if isinstance(value, list):
        return [_scaled(entry, factor) for entry in value]
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        try:
            return f"{float(number) * factor:g} {unit}"
        except ValueError:
            return value
    if isinstance(value, int | float) and not isinstance(value, bool):
        return value * factor
    return value


def _lines(tables: dict[str, Any], above: str = "") -> Iterator[str]:
    """A case file's lines."""
    if above:
        yield f"[{above}]"
    for key, value in tables.items():
        if not isinstance(value, dict):
            yield f"{json.dumps(key)} = {_value(value)}"
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from _lines(value, f"{above}.{json.dumps(key)}" if above else json.dumps(key))


def _value(value: Any) -> str:
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, list):
        return f"[{', '.join(_value(entry) for entry in value)}]"
    if isinstance(value, dict):
        return (
            "{" + ", ".join(f"{json.dumps(key)} = {_value(of)}" for key, of in value.items()) + "}"
        )
    return toml(value)


_OF_CASE = {base: _mutants_of(base) for base in dict.fromkeys((*QUICK, *SLOW, *RATED))}
