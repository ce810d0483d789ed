"""The page of troubleshooting has every outcome of a solve but the good one, with the program's messages."""

import re

import pytest
from folders import ROOT

from pyworm.cli.main import main
from pyworm.solver.ending import Ending

PAGE = (ROOT / "docs/how-to/troubleshooting.md").read_text()
CASE = (ROOT / "cases/ball_pag_460.toml").read_text()

MISTAKES = {
    "contact.laod": ('load = "60 N"', 'laod = "60 N"'),
    "contact.load": ('load = "60 N"', 'load = "60"'),
}
"""Message on the page, by its key -> what makes it in the case."""


def messages() -> set[str]:
    """What begins rows of tables and items of lists and is code, joined where a line breaks."""
    return {" ".join(text.split()) for text in re.findall(r"^(?:\||-) `([^`]+)`", PAGE, re.M)}


@pytest.mark.parametrize(
    "ending",
    [
        ending
        for ending in Ending
        if re.sub(r"\{\w+\}", "", ending.message) and ending != Ending.ACCURATE
    ],
)
def test_every_outcome_of_a_solve_is_on_the_page(ending):
    assert re.sub(r"\{[^}]+\}", "…", ending.message) in messages()


@pytest.mark.parametrize("key", MISTAKES)
def test_a_mistake_gives_the_message_of_the_page(key, tmp_path, capsys):
    (message,) = [text for text in messages() if re.match(rf"{re.escape(key)}\b", text)]
    case = tmp_path / "ball.toml"
    case.write_text(CASE.replace(*MISTAKES[key], 1))
    assert main(["check", str(case)]) == 2
    assert message in capsys.readouterr().err
