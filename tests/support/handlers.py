"""Fall-backs of the program: every `except` and `suppress`, and every branch on a failure.

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

FAILURES = {
    *("diverged", "failure", "_diverged", "taken", "flaw", "UNUSABLE_START_RESIDUAL", "unsolved"),
    *("UNRECOVERABLE_RESIDUAL", "MAX_GUESS_RESIDUAL", "MAX_TRANSIENT_RESIDUAL"),
    *("MAX_TEMPERATURE_RESIDUAL", "MAX_UNCONVERGED_GRIDS", "MAX_STRESS_FACTOR", "unconverged"),
    *("film_is_sound", "converged", "_converged", "status", "COARSE_TOLERANCE", "HEATED_TOLERANCE"),
    *("MOST_HALVINGS", "MOST_RETRIES", "MAX_SOLVES"),
    *("shear_tolerance", "rests_on_edge", "short", "refusal", "in_vain", "carried_by_heat"),
    *("rates", "solved", "followed", "unread", "held"),
}
"""Names of what an iteration, a film or a plan is asked when it may have failed: a condition with one of them
chooses another way, an earlier end or a reason."""

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
    """Name and node of each fall-back of a file: "solver/newton.py iterate KernelError"."""
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


def _fails(condition: ast.expr) -> bool:
    """Whether a condition asks for a failure."""
    names = {getattr(of, "id", getattr(of, "attr", None)) for of in ast.walk(condition)}
    return bool(names & FAILURES)


def _another_way(node: ast.AST) -> bool:
    """Whether it is a value `A or B`, not a question, and B more than words or nothing."""
    return (
        isinstance(node, ast.BoolOp)
        and isinstance(node.op, ast.Or)
        and not any(isinstance(of, ast.Compare | ast.UnaryOp) for of in node.values)
        and ast.unparse(node.values[-1]) not in ("None", "{}", "()")
        and not isinstance(getattr(node.values[-1], "value", None), str)
        and not isinstance(node.values[-1], ast.Lambda)
    )


def branches(tree: ast.Module, file: str) -> Iterator[tuple[str, Any]]:
    """Name and node of each branch on a failure: "solver/newton.py iterate if taken is None".

    Conditions that hold or do not, and values `A or B` of which B is another way to them.
    """
    seen: Counter[str] = Counter()

    def within(node: ast.AST, function: str, asked: bool) -> Iterator[tuple[str, Any]]:
        for field, value in ast.iter_fields(node):
            for child in value if isinstance(value, list) else [value]:
                if not isinstance(child, ast.AST):
                    continue
                inner, condition = function, asked and isinstance(node, ast.BoolOp | ast.UnaryOp)
                condition |= field in ("test", "ifs")
                if isinstance(child, ast.FunctionDef | ast.ClassDef):
                    inner = f"{function}.{child.name}".lstrip(".")
                words = None
                if isinstance(child, ast.If | ast.IfExp | ast.While) and _fails(child.test):
                    words = f"if {ast.unparse(child.test)}"
                elif not condition and _another_way(child):
                    words = f"or {ast.unparse(child.values[-1])}"
                if words is not None:
                    name = f"{file} {function} {words}"
                    seen[name] += 1
                    yield (name if seen[name] == 1 else f"{name} {seen[name]}"), child
                yield from within(child, inner, condition)

    yield from within(tree, "", False)


def all_branches() -> list[str]:
    """Names of all branches on a failure in the rooms."""
    return [
        name
        for room in ROOMS
        for file in sorted((PACKAGE / room).rglob("*.py"))
        for name, _ in branches(ast.parse(file.read_text()), _name(file))
    ]


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


_told_before: set[tuple[str, str]] = set()


def reached(name: str) -> None:
    """Write that a fall-back was reached, once in each test."""
    test = os.environ.get("PYTEST_CURRENT_TEST", "")
    if (name, test) in _told_before:
        return
    _told_before.add((name, test))
    with open(os.environ[REACHED], "a") as file:
        file.write(f"{name}\t{test}\n")


def _tell_sides(name: str, node: Any) -> None:
    """Put calls of `reached` where a condition holds (": yes"), where it does not (": no"), or on B."""

    def call(side: str) -> ast.Expr:
        (statement,) = ast.parse(f"__import__('handlers').reached({name + side!r})").body
        assert isinstance(statement, ast.Expr)
        return statement

    def before(side: str, value: ast.expr) -> ast.expr:
        pair = ast.Tuple([call(side).value, value], ast.Load())
        return ast.Subscript(pair, ast.Constant(1), ast.Load())

    if isinstance(node, ast.BoolOp):
        node.values[-1] = before("", node.values[-1])
    elif isinstance(node, ast.IfExp):
        node.body, node.orelse = before(": yes", node.body), before(": no", node.orelse)
    else:
        node.body.insert(0, call(": yes"))
        node.orelse.insert(0, call(": no"))


def _told(source: bytes, file: Path) -> ast.Module:
    """The code of a file with a call of `reached` where each of its fall-backs begins.

    What a `suppress` suppresses is told from an `except` around what it holds, which raises it again.
    """
    tree = ast.parse(source)
    for name, node in list(branches(tree, _name(file))):
        _tell_sides(name, node)
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
