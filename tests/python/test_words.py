"""Pages and screens use the field's words: none of `tests/support/words.toml` in any text that a user reads.

Read are pages without their code, the help of every command, labels of quantities, texts in the package's
sources (messages, titles, axes, notes) and docstrings of what `pyworm` exports.
"""

import argparse
import ast
import inspect
import re
import textwrap
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from folders import ROOT

import pyworm
from pyworm.cli.main import _parser
from pyworm.io.quantities import QUANTITIES

PACKAGE = ROOT / "pyworm"

PAGES = [
    ROOT / "README.md",
    *(page for page in sorted((ROOT / "docs").rglob("*.md")) if page.name != "bibliography.md"),
]
"""Pages that users read; the bibliography has the words of others."""

CODE = re.compile(
    r"^ *(?:```|~~~)[\s\S]*?^ *(?:```|~~~) *$|^::: .*$|<!--[\s\S]*?-->|\$\$[\s\S]*?\$\$|"
    r"(?<=\n)\n(?:(?: {4,}.*)?\n)+|``.+?``|`(?:[^`\n]|\n(?!\n))+`|\$[^$\n]+\$|\]\([^)]*\)|https?://\S+|<[^>\n]+>",
    re.MULTILINE,
)
"""What no reader takes for prose: code, equations, targets of links."""

FOOT_LINE = re.compile(r"^.*\bcommit\b.*$", re.MULTILINE)
"""The line under a generated table, which alone has a commit."""


@dataclass(frozen=True)
class Word:
    """A word that is not used."""

    pattern: re.Pattern
    use: str
    where: tuple[str, ...]


def _words() -> Iterator[Word]:
    kinds = ("page", "help", "label", "message", "docstring")
    for entry in tomllib.loads((ROOT / "tests/support/words.toml").read_text())["word"]:
        spaced = re.sub(
            r"\(\?<!.*?\)| (?![*?+])",  # what looks behind has one width
            lambda space: r"\s+" if space[0] == " " else space[0].replace(" ", r"\s"),
            entry["not"],
        )
        start = "" if spaced.startswith("^") else r"(?<![\w.-])"
        pattern = re.compile(f"{start}(?:{spaced})(?![\\w-])", re.IGNORECASE)
        yield Word(pattern, entry["use"], tuple(entry.get("where", kinds)))


WORDS = tuple(_words())


def found(text: str, kind: str, name: str, first: int = 1) -> list[str]:
    """Words of a text that are not to be used, each with its line and what is used instead."""
    lines = (
        (text.count("\n", 0, match.start()) + first, " ".join(match[0].split()), word.use)
        for word in WORDS
        if kind in word.where
        for match in word.pattern.finditer(text)
    )
    return [f"{name}:{line}: {words!r}: {use}" for line, words, use in sorted(lines)]


def prose(text: str) -> str:
    """A page without its code; lines stay where they are."""
    blank = CODE.sub(lambda match: " § " + "\n" * match[0].count("\n"), text)
    return FOOT_LINE.sub("", blank)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_a_page_has_the_words_of_the_field(page):
    wrong = found(prose(page.read_text()), "page", page.relative_to(ROOT).as_posix())
    assert not wrong, f"{len(wrong)} words\n" + "\n".join(wrong)


def parsers(parser, name="pyworm"):
    """Every command with its parser."""
    yield name, parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command, below in action.choices.items():
                yield from parsers(below, f"{name} {command}")


COMMANDS = dict(parsers(_parser()))


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_of_a_command_has_the_words_of_the_field(command):
    assert not found(COMMANDS[command].format_help(), "help", command)


def test_labels_of_quantities_have_the_words_of_the_field():
    labels = [
        text for quantity in QUANTITIES.values() for text in (quantity.words(), quantity.worst())
    ]
    assert not [line for label in labels for line in found(label, "label", label)]


FILED = {"central film", "minimum film", "window of film", "window of heat"}
"""Keys and words of files, which no reader sees (`ratings/rating.py`, `solver/ending.py`)."""


def texts(file: Path) -> Iterator[tuple[int, str]]:
    """Texts of a source that a user may see: literals of several words that are no docstrings."""
    tree = ast.parse(file.read_text())
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts = node.values
            silent |= {id(part) for part in parts}
            text = "".join(part.value if isinstance(part, ast.Constant) else "§" for part in parts)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = node.value
        else:
            continue
        if id(node) not in silent and " " in text.strip() and text not in FILED:
            yield node.lineno, text


ROOMS = sorted(path.name for path in PACKAGE.iterdir() if path.is_dir() and any(path.glob("*.py")))


@pytest.mark.parametrize("room", ROOMS)
def test_messages_titles_and_notes_have_the_words_of_the_field(room):
    wrong = [
        line
        for file in sorted((PACKAGE / room).rglob("*.py"))
        for number, text in texts(file)
        for line in found(text, "message", file.relative_to(ROOT).as_posix(), number)
    ]
    assert not wrong, f"{len(wrong)} words\n" + "\n".join(wrong)


def docstrings(value, name: str) -> Iterator[tuple[str, str]]:
    """Docstrings of a public object and of its public members from the package."""
    yield name, inspect.getdoc(value) or ""
    if inspect.isclass(value):
        tree = ast.parse(textwrap.dedent(inspect.getsource(value)))
        for node in ast.walk(tree):
            if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
                yield name, str(node.value.value)


@pytest.mark.parametrize("name", pyworm.__all__)
def test_docstrings_of_what_is_exported_have_the_words_of_the_field(name):
    value = getattr(pyworm, name)
    if not (inspect.isclass(value) or inspect.isfunction(value)):
        return
    wrong = [
        line
        for owner, text in dict.fromkeys(docstrings(value, name))
        for line in found(text, "docstring", owner)
    ]
    assert not wrong, f"{len(wrong)} words\n" + "\n".join(wrong)


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("The least film\nis thin.", 1),
        ("minimum film thickness", 0),
        ("Its error bars, and the `least film` in code", 1),
        ("a pressure of 3 bar, least squares, at least two grids, past the exit", 0),
        ("the worm drives the wheel of a gear drive; a worm drive", 0),
        ("bearing life, wear life over the life of the wheel", 0),
        ("March 2024; Windows", 0),
        ("```\nthe least film\n```\nfine $h_{least film}$ [text](a least film)", 0),
    ],
)
def test_the_list_sees_words_in_their_sense_alone(text, wrong):
    assert len(found(prose(text), "page", "text")) == wrong
