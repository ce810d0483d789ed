"""Types that the package ships: a script of public uses is clean, and stated signatures are the fields."""

import ast
import dataclasses
import inspect
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path

import pytest
from folders import ROOT

import pyworm
from pyworm.io.given import quantities

SCRIPT = ROOT / "tests" / "data" / "public_uses.py"


STRICT = (
    "# mypy: check-untyped-defs, disallow-any-generics, disallow-incomplete-defs, extra-checks\n"
    "# mypy: disallow-subclassing-any, disallow-untyped-decorators, strict-equality\n"
)
"""What `mypy --strict` asks beyond the settings of the project, by which the cache of `make lint` serves."""


def errors(script: Path) -> list[str]:
    """What mypy says of a script, as strictly as it can."""
    assert STRICT in script.read_text()
    ended = subprocess.run(
        [sys.executable, "-m", "mypy", "--no-error-summary", str(script)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert not ended.stderr
    # the package itself is what `make lint` reads
    return [
        line
        for line in ended.stdout.splitlines()
        if f"{script.name}:" in line and ": error:" in line
    ]


def test_twenty_public_uses_are_clean():
    uses = {
        node.attr
        for node in ast.walk(ast.parse(SCRIPT.read_text()))
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "pyworm"
    }
    assert len(uses & set(pyworm.__all__)) >= 20
    assert (ROOT / "pyworm" / "py.typed").exists()
    assert not errors(SCRIPT)


def test_arguments_with_units_have_one_type():
    """The alias, and no second way to write it in what is public."""
    for name in pyworm.__all__:
        public = getattr(pyworm, name)
        if inspect.isclass(public) or inspect.isfunction(public):
            written = inspect.getsource(public)
            assert ": float | str" not in written and ": str | float" not in written, name


def test_wrong_uses_are_seen(tmp_path):
    script = tmp_path / "wrong.py"
    script.write_text(
        f"{STRICT}import pyworm\n"
        "pyworm.Barus([0.04], 2e-8)\n"
        'pyworm.Paraboloid("10 mm", radius=2.0)\n'
        'text: str = pyworm.Parabola("10 mm").radius\n'
    )
    assert [line.split(":")[1] for line in errors(script)] == ["4", "5", "6"]


def stated() -> Iterator[tuple[type, ast.FunctionDef]]:
    """Public dataclasses that take quantities, and the `__init__` that a type checker reads."""
    for name in pyworm.__all__:
        kind = getattr(pyworm, name)
        if not (inspect.isclass(kind) and dataclasses.is_dataclass(kind) and quantities(kind)):
            continue
        for owner in kind.__mro__[:-1]:
            found = [
                node
                for node in ast.walk(ast.parse(textwrap.dedent(inspect.getsource(owner))))
                if isinstance(node, ast.FunctionDef) and node.name == "__init__"
            ]
            if found:
                yield kind, found[0]
                break
        else:
            pytest.fail(f"{name} states no types of what it takes")


@pytest.mark.parametrize(
    ("kind", "init"), list(stated()), ids=lambda value: getattr(value, "__name__", "")
)
def test_stated_arguments_are_the_fields(kind, init):
    given = inspect.signature(kind).parameters.values()
    needed = len(init.args.args) - len(init.args.defaults)
    arguments = [
        (argument.arg, "positional", number >= needed)
        for number, argument in enumerate(init.args.args)
    ][1:] + [
        (argument.arg, "keyword", default is not None)
        for argument, default in zip(init.args.kwonlyargs, init.args.kw_defaults, strict=True)
    ]
    assert arguments == [
        (
            one.name,
            "keyword" if one.kind is inspect.Parameter.KEYWORD_ONLY else "positional",
            one.default is not inspect.Parameter.empty,
        )
        for one in given
    ]
