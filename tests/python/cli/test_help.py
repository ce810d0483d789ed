"""The help of every command: what it does, and an example as the last line, which parses."""

import argparse
import shlex
from pathlib import Path

import pytest

from pyworm.cli.examples import EXAMPLES
from pyworm.cli.main import _parser

ROOT = Path(__file__).parents[3]


def commands(parser, before=""):
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, below in action.choices.items():
                yield f"{before} {name}".strip(), below
                yield from commands(below, f"{before} {name}".strip())


COMMANDS = dict(commands(_parser()))


def test_every_command_has_an_example():
    assert COMMANDS.keys() == EXAMPLES.keys()


@pytest.mark.parametrize("name", COMMANDS)
def test_the_help_ends_with_an_example_that_parses(name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    lines = COMMANDS[name].format_help().rstrip().splitlines()
    begin = f"Example: pyworm {name}"
    assert lines[-1].startswith(begin) and max(map(len, lines)) <= 80
    words = shlex.split(lines[-1].removeprefix("Example: pyworm "))
    assert _parser().parse_args(words).command
    for word in words:
        if word.startswith("cases/"):
            assert (ROOT / word).is_file()
