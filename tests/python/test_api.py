"""The public names: all documented, found on demand, listed where a reader looks for them."""

import ast
import dataclasses
import importlib
import inspect
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest
from attribute_literals import attribute_literals
from folders import ROOT

import pyworm

PACKAGE = Path(pyworm.__file__).parent


def imported(stub: Path) -> dict[str, str]:
    """Names that a stub imports, each with its module; "" of a module itself."""
    return {
        alias.name: node.module or ""
        for node in ast.walk(ast.parse(stub.read_text()))
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


HOMES = imported(PACKAGE / "__init__.pyi")
NAMES = [name for name in pyworm.__all__ if name not in ("__version__", "formulas", "plots")]


def test_dir_is_what_is_exported():
    assert dir(pyworm) == sorted(pyworm.__all__)
    assert len(NAMES) == len(set(NAMES)) > 35


def test_the_package_says_that_it_has_types():
    assert (PACKAGE / "py.typed").is_file()


@pytest.mark.parametrize("name", NAMES)
def test_a_public_name_is_in_the_table_of_contents_and_has_a_docstring(name):
    assert re.search(rf"^    (\w+, )*{name}\b", pyworm.__doc__, re.MULTILINE)
    assert len(inspect.getdoc(getattr(pyworm, name))) > 20


@pytest.mark.parametrize("package", ["", "formulas", "plots"])
def test_editors_read_the_names_that_are_loaded(package):
    """Each name once, from the module that defines it."""
    folder = PACKAGE / package
    module = importlib.import_module(f"pyworm.{package}".rstrip("."))
    names = imported(folder / "__init__.pyi")
    assert sorted(names) == module.__all__ == dir(module)
    for name, home in names.items():
        where = f"{module.__name__}.{home or name}"
        found = getattr(module, name)
        assert getattr(found, "__module__", where) == where if home else found.__name__ == where
    with pytest.raises(AttributeError, match="nowhere"):
        module.nowhere  # noqa: B018


def test_every_module_of_formulas_is_public():
    files = (PACKAGE / "formulas").glob("*.py")
    assert {file.stem for file in files} - {"__init__"} == set(
        imported(PACKAGE / "formulas/__init__.pyi")
    )


def public_members(of):
    """Methods and properties of a public class that are its own, and are no part of Python's protocols."""
    for name, member in vars(of).items():
        function = getattr(member, "fget", None) or getattr(member, "__func__", member)
        if not name.startswith("_") and inspect.isfunction(function):
            yield name, member


@pytest.mark.parametrize("name", NAMES)
def test_every_member_and_argument_of_a_public_name_is_documented(name):
    of = getattr(pyworm, name)
    for part, member in public_members(of) if inspect.isclass(of) else ():
        doc = inspect.getdoc(member) or ""
        assert doc or name == part, f"{name}.{part}"
    if inspect.isfunction(of):
        doc = inspect.getdoc(of)
        assert not [part for part in inspect.signature(of).parameters if part not in doc]


def dataclasses_with_public_names():
    """Dataclasses of the package without those of a module's own use."""
    for file in sorted(PACKAGE.rglob("*.py")):
        place = file.relative_to(PACKAGE).with_suffix("").as_posix()
        if file.name not in ("__init__.py", "__main__.py"):
            module = importlib.import_module(f"pyworm.{place.replace('/', '.')}")
            for name, of in vars(module).items():
                own = inspect.isclass(of) and of.__module__ == module.__name__
                if own and dataclasses.is_dataclass(of) and not name.startswith("_"):
                    yield of


def test_every_field_of_a_dataclass_has_a_literal_under_it():
    """A sentence, which may begin with a symbol; of inherited fields that of their base."""
    found = {of: attribute_literals(of) for of in dataclasses_with_public_names()}
    assert len(found) > 300
    wrong = [
        f"{of.__module__}.{of.__name__}.{part.name}"
        for of, literals in found.items()
        for part in dataclasses.fields(of)
        if not part.name.startswith("_") and not literals.get(part.name, "").endswith(".")
    ]
    assert not wrong


def test_no_docstring_lists_attributes():
    """What an attribute means stands under it, once, beside its type."""
    listing = [
        f"{file.relative_to(PACKAGE)}: {node.name}"
        for file in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.ClassDef) and "\nAttributes:\n" in (ast.get_docstring(node) or "")
    ]
    assert not listing


@pytest.mark.parametrize("name", NAMES)
def test_type_hints_survive(name):
    """Annotations are there for every argument of public functions and attribute of public dataclasses."""
    of = getattr(pyworm, name)
    if inspect.isfunction(of):
        hints = inspect.signature(of)
        assert hints.return_annotation is not inspect.Signature.empty
        empty = inspect.Parameter.empty
        assert all(one.annotation is not empty for one in hints.parameters.values())


def test_help_reads_as_a_table_of_contents():
    text = subprocess.run(
        [sys.executable, "-c", "import pyworm; help(pyworm)"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    head = text[:6000]
    for heading in ("A contact", "Solids and oils", "Solving", "Results", "What goes wrong"):
        assert heading in head


def test_importing_pyworm_loads_nothing_of_it_and_counts_threads_before_numpy():
    program = (
        "import os, sys, pyworm;"
        " print([name for name in sys.modules if name.startswith(('pyworm.', 'numpy'))],"
        " os.environ['OMP_NUM_THREADS'], os.environ['OPENBLAS_NUM_THREADS'])"
    )
    unset = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    for asked, number in ({}, "1"), ({"OMP_NUM_THREADS": "2"}, "2"):
        run = subprocess.run(
            [sys.executable, "-c", program],
            capture_output=True, text=True, check=True, env=unset | asked,
        )  # fmt: skip
        assert run.stdout.strip() == f"[] {number} 1"


def test_public_values_can_be_sent_to_other_processes():
    for one in (pyworm.Paraboloid(0.01, 0.02), pyworm.Body(2e11, 0.3), pyworm.Estimate(1.0, 0.1)):
        assert pickle.loads(pickle.dumps(one)) == one


def test_formulas_and_plots_have_their_modules_on_demand():
    assert pyworm.formulas.hertz.hertz(0.01, 0.01, 50.0, 2.2e11).pressure_max > 1e9
    assert "film" in dir(pyworm.formulas)
    assert callable(pyworm.plots.draw_traction)


def test_the_page_of_the_interface_has_every_name():
    page = (ROOT / "docs/reference/python.md").read_text()
    assert not [name for name in NAMES if f"::: pyworm.{HOMES[name]}.{name}\n" not in page]
