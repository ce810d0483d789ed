"""A full disk, and directories that take no files: nothing is half written, one sentence says so."""

import os
from pathlib import Path

import numpy as np
import pytest
from folders import CASES
from full_disk import Disk, files, refusals

from pyworm.case.new_worm import ASKED
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED, FAILED
from pyworm.io.atomic import NotWrittenError
from pyworm.io.cache import cache_directory
from pyworm.io.kept_arrays import keep
from pyworm.report import pdf
from pyworm.result.export import write_csv, write_vtk
from pyworm.result.result import open_result
from pyworm.solver.cost.calibration import calibration

POINT = CASES / "point_m20_l10.toml"
COARSE = ("--accuracy", "30%", "--effects", "isothermal")

SWEEP = f"""
title = "two loads"
case = "{POINT}"
effects = "isothermal"
fixed = {{ accuracy = "30 %" }}
vary = [{{ "contact.load" = ["3 N", "4 N"] }}]
"""

DRAWING = tuple(
    word for key, (_, example) in ASKED.items() for word in (f"--{key.replace('_', '-')}", example)
)


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """A directory with a result and a solved sweep."""
    directory = tmp_path_factory.mktemp("made")
    (directory / "two.toml").write_text(SWEEP)
    run = ["run", str(POINT), *COARSE, "--pictures", "none", "--out", str(directory / "out")]
    sweep = ["sweep", str(directory / "two.toml"), "--out", str(directory / "sweep")]
    assert [main(run), main(sweep)] == [CONVERGED, CONVERGED]
    return directory


def commands(built, out):
    """What writes files, and where it is to."""
    result = str(built / "out" / "result.nc")
    return {
        "run": ["run", str(POINT), *COARSE, "--pictures", "none", "--out", str(out)],
        "report": ["report", result, "--out", str(out / "report.html")],
        "variants": ["report", result, result, "--out", str(out / "variants.html")],
        "explore": ["explore", result, "--out", str(out / "explore.html")],
        "plot": ["plot", result, "--out", str(out)],
        "sweep": ["sweep", str(built / "two.toml"), "--out", str(out)],
        "oil": ["oil", "chart", "mineral VG 220", "--out", str(out)],
        "surface": ["surface", str(CASES / "surfaces/ground.toml"), "--out", str(out)],
        "precision": ["precision", str(CASES / "line_m20_l10.toml"), "--out", str(out)],
        "new": ["new", str(out / "worm.toml"), *DRAWING],
    }


NAMES = tuple(commands(Path(), Path()))


SOON = tuple(name for name in NAMES if name != "precision")
"""Those that end in a second or so."""


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize(
    ("name", "room"), [*((name, room) for name in SOON for room in (0, 1000)), ("precision", 0)]
)
def test_a_full_disk_leaves_what_was_there_and_nothing_in_part(built, tmp_path, capsys, name, room):
    out = tmp_path / "out"
    out.mkdir()
    for place in ("report.html", "explore.html", "result.nc", "sweep.nc"):
        (out / place).write_bytes(b"of an earlier run")
    before = files(out)
    command = commands(built, out)[name]
    capsys.readouterr()
    with Disk(room):
        assert main(command) == FAILED
    said = refusals(capsys.readouterr().err)
    assert said and "File too large" in said[-1], said
    assert str(out) in said[-1] or said[-1].startswith("pyworm: not drawn: "), said
    after = files(out)
    assert {path: after[path] for path in before} == before
    assert not [path for path in after if path.suffix == ".part"]
    if room == 0:
        assert after == before


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("name", SOON)
def test_a_directory_that_takes_no_files_is_named_in_one_sentence(built, capsys, name):
    nowhere = Path("/proc/pyworm")
    command = commands(built, nowhere)[name]
    capsys.readouterr()
    assert main(command) in (BAD_INPUT, FAILED)
    (said,) = refusals(capsys.readouterr().err)
    assert "/proc" in said


def test_other_writers_leave_nothing_in_part(built, tmp_path):
    (solution,) = open_result(built / "out" / "result.nc").solutions
    arrays = {"depth": np.random.default_rng(1).random(1000)}
    for file, write in (
        ("film.csv", lambda path: write_csv(solution, path)),
        ("film.vti", lambda path: write_vtk(solution, path)),
        ("wear.npz", lambda path: keep(path, **arrays)),
    ):
        with Disk(1000), pytest.raises(NotWrittenError, match=file):
            write(tmp_path / file)
    assert files(tmp_path) == {}


def test_without_room_for_a_cache_the_machine_is_measured_again(tmp_path, monkeypatch):
    known, measured = calibration(), []
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(
        "pyworm.solver.cost.calibration.calibrate", lambda: measured.append(1) or known
    )
    with Disk(10):
        assert calibration() == calibration() == known
    assert len(measured) == 2
    assert files(cache_directory()) == {}


@pytest.mark.skipif(pdf.browser() is None, reason="no Chromium on this machine")
def test_a_full_disk_leaves_no_pdf_and_the_page_stays(built, tmp_path, capsys, monkeypatch):
    out = tmp_path / "report.html"
    real = pdf.print_pdf

    def printed(page, target):
        with Disk(10_000):
            real(page, target)

    monkeypatch.setattr(pdf, "print_pdf", printed)
    code = main(["report", str(built / "out" / "result.nc"), "--pdf", "--out", str(out)])
    (said,) = refusals(capsys.readouterr().err)
    assert code in (BAD_INPUT, FAILED) and said.startswith("pyworm: --pdf: ")
    assert len(said.replace(str(tmp_path), "")) < 500
    assert os.listdir(tmp_path) == ["report.html"]
