"""Rooms of the package: which there are, what each may import, where the compiled extension is imported."""

import ast
import re
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from folders import PACKAGE

from pyworm.drives.kinds import BUILT_IN, name_of

FLOORS = {
    "formulas": 1, "io": 1,
    "materials": 2,
    "kernel": 3, "surfaces": 3, "scene": 3,
    "planning": 4, "drives": 4,
    "solver": 5, "case": 5,
    "precision": 6, "result": 6,
    "plots": 7, "ratings": 7, "batch": 7,
    "report": 8,
    "cli": 9,
}  # fmt: skip
"""Room -> its floor; a room imports nothing from above."""


WORM_ROOMS = ("flanks", "drawing", "teeth", "loads", "patterns")
"""Folders of the worm drive, from its flanks up to what its drive answers with."""

FOLDERS = {name_of(kind) for kind in BUILT_IN}
"""Folders of the drives."""

LONGEST = 60
"""Lines of a function."""

GRAMMAR = {"of", "one", "at", "own", "way"}
"""Words that name nothing: a variable, an argument or a field is called as what it is."""

CALLED_AT = {("scene/life.py", "at"): "Life.at, a public function of time"}
"""File and public name that reads as the word it is -> what it names."""

BACKWARD = ("The same", "Likewise")
"""First words of a docstring that cannot be read alone."""

OLD_WORDS = {
    "march", "marches", "course", "moment", "moments", "instant", "instants", "lead", "settle",
    "settled", "unsettled", "lost", "hopeless", "senseless", "firmer", "firmest", "firmed", "softened",
    "softened_again", "left_out", "leftout", "headed", "aim", "remembered_rise", "made", "made_of",
}  # fmt: skip
"""Names of the program's own language; the field says time integration, time grid, time record, time level,
iterate, converge, converged, diverged, unusable start, stress factor, neglected effects, qualified, accuracy
target, residual rise, and what is made has its own name."""

OLD_PARTS = re.compile(r"(^|_)(march(es|ed)?|glances?|films?_in_motion|in_motion)(_|$)")
"""Parts of names for which the field says time integration, estimate, transient solution."""

OLD_PHRASES = re.compile(
    r"(?<!-)\bmarch(es|ed)?\b|\bglances?\b|\bfilms? in motion\b", re.IGNORECASE
)
"""Their words in docstrings, comments and messages; the compiler's option -march is another word."""

FIELD_WORDS = {
    ("formulas", "lead"): "lead of a thread",
    ("drives", "lead"): "lead of a thread",
    ("case", "lead"): "lead of a thread",
    ("formulas", "moment"): "moment of a force, or of a distribution",
    ("drives", "moment"): "moment of a force",
}
"""Room and old word that is the field's own there -> its meaning."""

BARE_WORDS = {
    "MOST", "ANYHOW", "HEAVIER", "LEFT", "FAR", "NEAR", "PART", "PARTS", "LONGEST", "SHORTEST",
    "LARGEST", "SMALLEST", "LEAST", "MARGIN", "FIRMEST", "HOPELESS", "SENSELESS", "LOST", "SETTLED",
    "UNSETTLED", "LATE", "LIGHT", "WIDE", "WIDER", "WIDEST", "FULL", "DEEPEST", "HIGHEST", "LOWEST",
    "SLOWEST", "FASTEST", "FINEST", "COARSER", "COARSEST", "CLOSE", "CLOSED", "CLOSER", "BLEND",
    "BLENDED", "KEPT", "SAME", "STILL", "TINY", "REACH", "RATIO", "REGULAR", "MOVED", "WARM", "WARMING",
    "TURNED", "TELLING", "UNREACHED", "UNJUDGED", "FORGOTTEN", "SCARCE", "FARTHEST", "NARROWEST",
    "SHALLOWEST", "STEEPER", "STEEPEST", "FLATTEST", "WHOLE", "ABOUT", "BEFORE", "BESIDE", "BESIDES",
    "BEYOND", "FALL", "DEGREE", "FEWEST", "ENDS", "MORE", "COMMON", "DRAWN", "TRACE", "FLOOR", "SIDE",
    "SURE", "EXTREME", "FACTOR", "SHARE", "SPREAD", "STRIDE", "WORTHLESS", "SEEN", "SHOWN", "GROWTH",
    "APART", "NUMBER", "CARRYING", "BEARABLE", "ON", "WANTED", "NEEDED",
}  # fmt: skip
"""Names of constants that name no quantity."""

NAMED = tuple(FLOORS)
"""Rooms without `GRAMMAR` as names."""

STANDING_ALONE = NAMED
"""Rooms whose docstrings can be read alone."""

TRANSLATED = tuple(FLOORS)
"""Rooms without `OLD_WORDS` as names, of modules too."""

QUANTIFIED = tuple(FLOORS)
"""Rooms whose constants name a quantity."""


def _imports(file: Path) -> Iterator[str]:
    """Modules, and names of modules, that a file imports from the package."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def _arrows() -> Iterator[tuple[Path, str, str]]:
    """Every import across rooms: the file, its room and the room that it imports from."""
    for file in sorted(PACKAGE.rglob("*.py")):
        room = file.relative_to(PACKAGE).parts[0]
        for name in _imports(file):
            parts = name.split(".")
            if parts[0] == "pyworm" and len(parts) > 1 and parts[1] in FLOORS and room in FLOORS:
                yield file, room, parts[1]


def test_there_are_rooms_only_and_at_most_seventeen():
    found = {path.name for path in PACKAGE.iterdir() if path.is_dir() and any(path.glob("*.py"))}
    files = {path.name for path in PACKAGE.glob("*.py")}
    print(f"{len(found)} rooms on {len(set(FLOORS.values()))} floors")
    assert found == set(FLOORS)
    assert len(found) <= 17
    assert files == {"__init__.py"}


def test_nothing_is_imported_from_above():
    arrows = list(_arrows())
    upward = [
        f"{file.relative_to(PACKAGE)} imports {other}"
        for file, room, other in arrows
        if FLOORS[other] > FLOORS[room]
    ]
    print(f"{len(arrows)} imports between rooms, {len(upward)} of them upward")
    assert len(arrows) > 500
    assert not upward


def test_rooms_of_one_floor_do_not_import_each_other_in_a_circle():
    beside = {
        (room, other)
        for _, room, other in _arrows()
        if FLOORS[room] == FLOORS[other] and room != other
    }
    assert not {(one, other) for one, other in beside if (other, one) in beside}


def _module(name: str) -> str:
    """The module of an imported name, itself or what it is taken from, as a path in the package."""
    parts = name.split(".")[1:]
    while parts and not PACKAGE.joinpath(*parts).with_suffix(".py").exists():
        parts.pop()
    return "/".join(parts)


def test_modules_do_not_import_each_other_in_a_circle():
    """Late imports and those for types alone (`TYPE_CHECKING`) count too."""
    imported = {
        file.relative_to(PACKAGE).with_suffix("").as_posix(): set(map(_module, _imports(file)))
        for file in sorted(PACKAGE.rglob("*.py"))
    }
    order = tuple(TopologicalSorter(imported).static_order())  # CycleError names the circle
    assert len(order) > 250


def _kinds_known(file: Path) -> Iterator[str]:
    """What a file imports of kinds of drives, and kinds that it names."""
    for name in _imports(file):
        parts = name.split(".")
        if parts[:2] == ["pyworm", "drives"] and "".join(parts[2:3]) in FOLDERS:
            yield name
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Constant) and node.value in BUILT_IN and node.value != "worm":
            yield node.value
        # "worm" names a body and a shaft, too: as a kind it is known where a kind is compared with it
        if isinstance(node, ast.Compare) and "'worm'" in (asked := ast.unparse(node)):
            if "kind" in asked or "'drive'" in asked:
                yield asked


def test_only_drives_and_case_files_know_kinds_of_drives():
    """All else asks `Drive`; modules about one kind are found by its name (`pyworm.drives.kinds`)."""
    outside = [
        file
        for file in sorted(PACKAGE.rglob("*.py"))
        if file.relative_to(PACKAGE).parts[0] not in ("drives", "case")
    ]
    assert len(outside) > 100
    assert not {file: known for file in outside if (known := list(_kinds_known(file)))}


def test_a_drive_knows_no_other():
    for file in sorted((PACKAGE / "drives").rglob("*.py")):
        own = {file.relative_to(PACKAGE / "drives").parts[0]}
        known = {name.split(".")[2] for name in _imports(file) if name.startswith("pyworm.drives.")}
        assert not known & FOLDERS - own, file


def test_rooms_of_the_worm_drive_import_those_before_them():
    folder = PACKAGE / "drives" / "worm"
    assert {path.name for path in folder.iterdir() if any(path.glob("*.py"))} == set(WORM_ROOMS)
    for number, room in enumerate(WORM_ROOMS):
        for file in sorted((folder / room).glob("*.py")):
            within = [name for name in _imports(file) if name.startswith("pyworm.drives.worm.")]
            assert {name.split(".")[3] for name in within} <= set(WORM_ROOMS[: number + 1]), file


def test_no_function_is_longer_than_a_page():
    long = [
        f"{file.relative_to(PACKAGE)}: {node.name}"
        for file in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.FunctionDef) and node.end_lineno - node.lineno >= LONGEST
    ]
    assert not long


def _files(rooms: tuple[str, ...]) -> Iterator[tuple[str, ast.Module]]:
    """Path and content of each file of some rooms."""
    for room in rooms:
        for file in sorted((PACKAGE / room).rglob("*.py")):
            yield file.relative_to(PACKAGE).as_posix(), ast.parse(file.read_text())


def _defined(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Line and name of all that a file defines: variables, arguments, fields, functions and classes."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.lineno, node.id
        elif isinstance(node, ast.arg):
            yield node.lineno, node.arg
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.lineno, node.name


def test_variables_arguments_and_fields_are_nouns():
    methods = (ast.FunctionDef, ast.ClassDef)
    wrong = []
    for file, tree in _files(NAMED):
        called = {(node.lineno, node.name) for node in ast.walk(tree) if isinstance(node, methods)}
        wrong += [
            f"{file}:{line}: {name}"
            for line, name in _defined(tree)
            if name.strip("_") in GRAMMAR
            and (line, name) not in called
            and (file, name) not in CALLED_AT
        ]
    assert not wrong


def test_a_docstring_stands_alone():
    wrong = [
        f"{file}:{node.lineno}"
        for file, tree in _files(STANDING_ALONE)
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if str(node.value.value).lstrip().startswith(BACKWARD)
    ]
    assert not wrong


def test_names_are_words_of_the_field():
    wrong = []
    for file, tree in _files(TRANSLATED):
        room = file.partition("/")[0]
        names = [*_defined(tree), (0, Path(file).stem)]
        wrong += [
            f"{file}:{line}: {name}"
            for line, name in names
            if ((word := name.strip("_").lower()) in OLD_WORDS and (room, word) not in FIELD_WORDS)
            or OLD_PARTS.search(word)
        ]
    assert not wrong


def test_texts_are_in_words_of_the_field():
    sources = [*PACKAGE.rglob("*.py"), *(PACKAGE.parent / "fortran").rglob("*.f90")]
    wrong = [
        f"{file.relative_to(PACKAGE.parent)}:{number}"
        for file in sorted(sources)
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
        if OLD_PHRASES.search(line)
    ]
    assert len(sources) > 400
    assert not wrong


def test_a_constant_names_its_quantity():
    wrong = [
        f"{file}:{line}: {name}"
        for file, tree in _files(QUANTIFIED)
        for line, name in _defined(tree)
        if name.isupper() and name.strip("_") in BARE_WORDS
    ]
    assert not wrong


def test_one_file_casts_computed_numbers_to_indices():
    """A number that is not finite would become an index like any other; `whole` refuses it."""
    cast = re.compile(r"\.astype\(int\)")
    casting = [
        file.relative_to(PACKAGE).as_posix()
        for file in PACKAGE.rglob("*.py")
        if cast.search(file.read_text(encoding="utf-8"))
    ]
    assert casting == ["formulas/whole_numbers.py"]


def test_zip_drops_nothing():
    """A shorter argument would end `zip(strict=False)` unseen; one that may be longer is cut by a slice."""
    dropping = [
        f"{file.relative_to(PACKAGE)}:{node.lineno}"
        for file in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "zip"
        if not any(
            word.arg == "strict" and getattr(word.value, "value", None) is True
            for word in node.keywords
        )
    ]
    assert not dropping


def test_one_file_imports_the_extension():
    importers = [
        file.relative_to(PACKAGE).as_posix()
        for file in sorted(PACKAGE.rglob("*.py"))
        if any(
            name == "pyworm._core" or name.startswith("pyworm._core.") for name in _imports(file)
        )
    ]
    assert importers == ["kernel/core.py"]


def test_tests_lie_in_the_room_that_they_test():
    folders = {path.parent.name for path in Path(__file__).parent.glob("*/test_*.py")}
    assert folders <= set(FLOORS)


@pytest.mark.parametrize("name", ["plan", "solve", "load"])
def test_public_functions_are_not_hidden_by_rooms(name):
    assert not (PACKAGE / name).exists()
