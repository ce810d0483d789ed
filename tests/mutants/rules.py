"""The list of mutations: each changes one line of the program, and some of its tests have to fail then.

A table of a TOML file here is one mutation, its name the table's:

    [far-field-load-halved]
    file = "pyworm/solver/point/far_field.py"
    old = "return FarField(outline, pressure, load)"
    new = "return FarField(outline, pressure, load / 2)"
    tests = ["solver/test_film.py::test_the_load_beyond_a_window_is_that_of_the_exact_field"]

`old` stands in the file once and within one line. `tests` are Fortran programs of `tests/fortran` by their
name in meson, or files of `tests/python`, or tests in these, most likely first. `survives`, if it is there,
says why none of them can fail.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent


@dataclass(frozen=True)
class Mutation:
    """One line of the program changed."""

    name: str
    """What it is called."""
    file: str
    """The file, from the root of the tree."""
    old: str
    """A part of a line."""
    new: str
    """What stands there instead."""
    tests: tuple[str, ...]
    """What touches it."""
    survives: str | None = None
    """Why no test can tell; None where one has to."""

    @property
    def programs(self) -> list[str]:
        """Fortran programs among the tests."""
        return [test for test in self.tests if ".py" not in test]

    @property
    def python_tests(self) -> list[str]:
        """Tests in Python, as pytest takes them at the root of the tree."""
        return [f"tests/python/{test}" for test in self.tests if ".py" in test]

    @property
    def in_kernel(self) -> bool:
        """Whether it is one of Fortran."""
        return self.file.startswith("fortran/")

    def applied(self, root: Path = ROOT) -> str | None:
        """The file changed; None where the line does not stand in it once."""
        path = root / self.file
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        return text.replace(self.old, self.new) if text.count(self.old) == 1 else None


def mutations(directory: Path = HERE) -> list[Mutation]:
    """All that are listed; TypeError for a table with a key too many or too few."""
    found = []
    for path in sorted(directory.glob("*.toml")):
        for name, table in tomllib.loads(path.read_text(encoding="utf-8")).items():
            found.append(Mutation(name, **table | {"tests": tuple(table["tests"])}))
    return found
