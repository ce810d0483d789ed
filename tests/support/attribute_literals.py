"""Literals under the attributes of classes, which say what the attributes mean."""

import ast
import importlib
import inspect
from collections.abc import Iterator
from functools import cache
from itertools import pairwise


def _target(statement: ast.stmt) -> str | None:
    """The attribute that a statement declares, or sets of an object."""
    targets = getattr(statement, "targets", [getattr(statement, "target", None)])
    return getattr(targets[0], "id", getattr(targets[0], "attr", None))


def _literals(body: list[ast.stmt]) -> Iterator[tuple[str, str]]:
    """Attributes of the body of a class with their literals; those that its constructor sets, too."""
    for statement, after in pairwise([*body, ast.Pass()]):
        if isinstance(statement, ast.FunctionDef) and statement.name == "__init__":
            yield from _literals(statement.body)
        text = getattr(getattr(after, "value", None), "value", None)
        if isinstance(statement, ast.Assign | ast.AnnAssign) and isinstance(text, str):
            if isinstance(after, ast.Expr) and (name := _target(statement)):
                yield name, inspect.cleandoc(text)


@cache
def _literals_of_module(name: str) -> dict[str, dict[str, str]]:
    """Class of a module -> its own attributes -> their literals."""
    tree = ast.parse(inspect.getsource(importlib.import_module(name)))
    return {
        node.name: dict(_literals(node.body))
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef)
    }


def attribute_literals(owner: type) -> dict[str, str]:
    """Attributes of a class of the package, inherited ones too, with their literals."""
    return {
        name: text
        for base in reversed(owner.__mro__)
        if base.__module__.startswith("pyworm.")
        for name, text in _literals_of_module(base.__module__)[base.__name__].items()
    }
