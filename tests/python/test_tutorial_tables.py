"""Tables of the tutorials: every row that a page shows is one that its commands print."""

import re

import pytest
from folders import ROOT
from printed_rows import same_row

from pyworm.cli.main import main

ROW = re.compile(r"^(?:│.*│|(?:[a-z ]+  +)?\d+ .*\d(?:  <-)?)$", re.M)
"""A row of a table with lines, or of numbers, which may have a name."""

COMMANDS = {
    "choosing-an-oil": (
        ("oil", "choose", "cases/oil_zi.toml"),
        ("rate", "cases/oil_zi.toml"),
    ),
    "conveyor": (("duty", "cases/conveyor.toml"),),
    "zi-drive": (
        ("check", "cases/zi_drive.toml", "--phase", "0.5"),
        ("run", "cases/zi_drive.toml", "--pictures", "none"),
    ),
}
"""Commands whose tables a page shows."""

LONG = "zi-drive", "conveyor"
"""Pages that take minutes, and a third of one."""


@pytest.mark.parametrize(
    "page",
    [pytest.param(page, marks=pytest.mark.long if page in LONG else ()) for page in COMMANDS],
)
def test_rows_of_a_page_are_printed(page, tmp_path, monkeypatch, capsys):
    (tmp_path / "cases").symlink_to(ROOT / "cases")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "110")
    for command in COMMANDS[page]:
        assert main(list(command)) == 0
    printed = [line.strip() for line in capsys.readouterr().out.splitlines()]
    shown = ROW.findall((ROOT / f"docs/tutorials/{page}.md").read_text())
    assert len(shown) > 5
    missing = [
        row
        for row in shown
        if not any(same_row(row.strip(), line, value=5e-3, others=0.1) for line in printed)
    ]
    assert not missing
