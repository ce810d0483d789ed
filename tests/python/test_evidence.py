"""Tables of docs/evidence are those of their data files, and each file has the command that writes it."""

import re
import shlex
import sys

import pytest
from drive_trial import DriveVerdict
from evidence_data import DATA, DataFile, Origin, path_of, read, save
from evidence_pages import NOT_RECORDED, names_on, table, with_tables
from evidence_record import record
from folders import ROOT
from hard_record import record_contacts, record_drives
from reproduce import LIST, commands, run
from trial import Verdict

PAGES = sorted((ROOT / "docs/evidence").glob("*.md"))
NAMES = sorted(path.stem for path in DATA.glob("*.csv"))
LISTED = [dict(zip(read(LIST).columns, row, strict=True)) for row in read(LIST).rows]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_has_the_tables_of_its_data(page):
    text = page.read_text()
    assert with_tables(text) == text, (
        "python benchmarks/evidence/evidence_pages.py writes them anew"
    )


def test_every_data_file_is_on_a_page():
    pages = [page.read_text() for page in PAGES]
    shown = set().union(*map(names_on, pages)) | {
        name for text in pages for name in re.findall(r"\(data/(\w+)\.csv\)", text)
    }
    assert shown == set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_data_say_where_they_come_from(name):
    data = read(name)
    assert data.rows
    assert all(data.columns[1:]) and len(set(data.columns)) == len(data.columns)
    if data.origin.command:
        assert data.origin.commit and data.origin.machine and data.origin.date


def test_the_list_has_each_command_that_writes_data():
    written = {name: row["command"] for row in LISTED for name in row["data"].split()}
    for name in NAMES:
        command = read(name).origin.command
        if command.endswith(f"{name}.csv") or "benchmarks/" in command or "tests/hard" in command:
            assert name in written, name


def test_programs_of_the_list_exist():
    words = [word for row in LISTED for word in shlex.split(row["command"])]
    programs = [word for word in words if word.startswith(("benchmarks/", "tests/", "cases/"))]
    assert programs and all((ROOT / word).exists() for word in programs)


def test_short_commands_and_those_of_some_data():
    assert len(commands([])) == sum(row["length"] == "short" for row in LISTED)
    (command,) = commands(["line_films", "line_errors"])
    assert command == "python benchmarks/validation/line.py"
    with pytest.raises(SystemExit, match="no_such"):
        commands(["no_such"])
    with pytest.raises(SystemExit, match="choose NUMBER, SEED"):
        commands(["hard_drives"])


def test_a_command_of_the_list_runs_with_its_variables(capfd):
    run("GIVEN=7 python -c 'import os; print(os.environ[\"GIVEN\"])'")
    assert capfd.readouterr().out.splitlines()[-1] == "7"


@pytest.fixture
def data(monkeypatch, tmp_path):
    """A directory for data, and no pages."""
    monkeypatch.setattr("evidence_data.DATA", tmp_path)
    monkeypatch.setattr("evidence_record.write_tables", lambda: None)
    monkeypatch.setattr("evidence_record.ROOT", tmp_path)
    monkeypatch.setattr("evidence_record.commit", lambda: "abc")
    monkeypatch.setattr("evidence_pages.PAGES", tmp_path.parent)
    return tmp_path


def test_rows_of_other_runs_stay_where_a_key_tells_them_apart(data, monkeypatch):
    monkeypatch.setattr(sys, "argv", [str(data / "program.py"), "1"])
    record("films", ("case", "film / um"), [("a", 1), ("b", 2)], key=("case",))
    assert read("films").origin.command == "python program.py 1"
    monkeypatch.setattr("evidence_record.commit", lambda: "def")
    record("films", ("case", "film / um"), [("b", "3, or 4")], key=("case",))
    assert read("films").rows == (("a", "1"), ("b", "3, or 4"))
    assert read("films").origin.commit == "abc, def"
    record("films", ("case", "film / um"), [("c", 5)])
    assert read("films").rows == (("c", "5"),) and read("films").origin.commit == "def"
    with pytest.raises(ValueError, match="other columns"):
        record("films", ("case",), [("a",)], key=("case",))


def test_tables_select_and_gather(data, monkeypatch):
    rows = (("x", "a", "1.5 %"), ("x", "b", "below -2 %"), ("y", "c", "3 %"), ("y", "d|", ""))
    origin = Origin("make it && show it", "abc", "a machine", NOT_RECORDED)
    save("some", DataFile(origin, ("kind", "name", "off"), rows))
    view = {"where": {"kind": "y"}, "columns": ["name", "off -> difference"]}
    gathered = {"data": "some", "by": "kind", "columns": ["name count", "off range -> difference"]}
    monkeypatch.setattr("evidence_pages.TABLES", {"some": view, "by kind": gathered})
    monkeypatch.setattr("evidence_pages._timed", lambda: {"some"})
    foot = f"*commit abc; a machine; [data]({path_of('some').relative_to(data.parent)})*"
    assert table("some") == (
        "`make it`, then `show it`\n\n|name |difference |\n|---|---|\n|c |3 % |\n|d\\| | |\n\n"
        + foot
    )
    shown = table("by kind")
    assert "|kind |name count |difference |" in shown
    assert "|x |2 |below -2 % to 1.5 % |" in shown and "|y |2 |3 % |" in shown
    monkeypatch.setattr("evidence_pages._timed", set)
    assert table("some").endswith(f"*commit abc; [data]{foot.split('[data]')[1]}")


def test_results_of_the_hard_suite_are_rows_of_its_data(data, monkeypatch):
    monkeypatch.setattr("hard_record.commit", lambda: "abc")
    run = DriveVerdict(
        "drive:0", "worm", "5 %", "incomplete", 5, 3, 500.0, 427.0, 240.0, "a reason"
    )
    for seed in (1, 2, 2):
        record_drives([run], seed)
    found = read("hard_drives")
    assert found.origin.commit == "of each row"
    assert [row[0] for row in found.rows] == ["1", "2"]
    assert found.rows[1][1:] == (
        "0", "worm", "5 %", "5", "3", "427", "240", "incomplete", "a reason", "abc",
    )  # fmt: skip
    some = [Verdict(f"rough:{k}", ("converged", "not converged")[k], "", 1, (), {}) for k in (0, 1)]
    record_contacts("rough", some, 7)
    assert read("hard_contacts").rows == (("rough", "7", "2", "1", "50.0 %", "97 %", "abc"),)
