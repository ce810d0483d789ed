"""Fall-backs of the program: every `except` and `suppress`, by file, function and exceptions.

As a plugin of pytest (`-p handlers`) it tells which of them are reached: each writes a line with its name and
the test at hand into the file that the environment's HANDLERS_REACHED names.
"""

import ast
import importlib._bootstrap_external as imports
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).parents[2] / "pyworm"
ROOMS = ("batch", "planning", "solver")
"""Rooms whose fall-backs are all to be made happen by a test."""

REACHED = "HANDLERS_REACHED"
"""Variable of the environment that names the file of those that are reached."""


def _suppressed(node: ast.stmt) -> str | None:
    """What a `with suppress(...)` suppresses; None of other statements."""
    for item in getattr(node, "items", ()) if isinstance(node, ast.With) else ():
        call = item.context_expr
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "suppress":
            return f"suppress {ast.unparse(call.args[0])}"
    return None


def handlers(tree: ast.Module, file: str) -> Iterator[tuple[str, ast.ExceptHandler | ast.With]]:
    """Name and node of each fall-back of a file: "solver/newton.py lead KernelError"."""
    seen: Counter[str] = Counter()

    def within(node: ast.AST, function: str) -> Iterator[tuple[str, Any]]:
        for child in ast.iter_child_nodes(node):
            inner = function
            if isinstance(child, ast.FunctionDef | ast.ClassDef):
                inner = f"{function}.{child.name}".lstrip(".")
            caught = None
            if isinstance(child, ast.ExceptHandler):
                caught = ast.unparse(child.type) if child.type else "everything"
            elif isinstance(child, ast.With):
                caught = _suppressed(child)
            if caught is not None:
                name = f"{file} {function} {caught}"
                seen[name] += 1
                yield (name if seen[name] == 1 else f"{name} {seen[name]}"), child
            yield from within(child, inner)

    yield from within(tree, "")


def all_handlers() -> list[str]:
    """Names of all fall-backs of the rooms."""
    return [
        name
        for room in ROOMS
        for file in sorted((PACKAGE / room).rglob("*.py"))
        for name, _ in handlers(ast.parse(file.read_text()), _name(file))
    ]


def _name(file: Path) -> str:
    return file.relative_to(PACKAGE).as_posix()


def reached(name: str) -> None:
    """Write that a fall-back was reached."""
    with open(os.environ[REACHED], "a") as file:
        file.write(f"{name}\t{os.environ.get('PYTEST_CURRENT_TEST', '')}\n")


def _told(source: bytes, file: Path) -> ast.Module:
    """The code of a file with a call of `reached` where each of its fall-backs begins.

    What a `suppress` suppresses is told from an `except` around what it holds, which raises it again.
    """
    tree = ast.parse(source)
    for name, node in list(handlers(tree, _name(file))):
        (call,) = ast.parse(f"__import__('handlers').reached({name!r})").body
        if isinstance(node, ast.ExceptHandler):
            node.body.insert(0, call)
            continue
        caught = name.split(" suppress ")[1].split()[0]
        (trial,) = ast.parse(f"try:\n    pass\nexcept {caught}:\n    raise").body
        trial.body, trial.handlers[0].body = node.body, [call, ast.Raise()]
        node.body = [trial]
    return ast.fix_missing_locations(tree)


def pytest_configure() -> None:
    """Load the rooms with calls of `reached`, past compiled files."""
    wanted = tuple(str(PACKAGE / room) + os.sep for room in ROOMS)
    compiled, cached = imports.SourceLoader.source_to_code, imports.cache_from_source

    def source_to_code(loader: Any, data: Any, path: Any, *more: Any, **named: Any) -> Any:
        if isinstance(data, bytes) and str(path).startswith(wanted):
            data = _told(data, Path(path))
        return compiled(loader, data, path, *more, **named)

    def cache_from_source(path: Any, *more: Any, **named: Any) -> Any:
        if str(path).startswith(wanted):
            raise NotImplementedError
        return cached(path, *more, **named)

    imports.SourceLoader.source_to_code = source_to_code
    imports.cache_from_source = cache_from_source
