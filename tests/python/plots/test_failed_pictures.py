"""A picture that fails costs neither figures nor table nor other pictures: it is one sentence."""

import json
import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from folders import CASES
from synthetic_solution import make_result, make_worm_solution

from pyworm.batch.workers import WorkerPool
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED, FAILED, NOT_CONVERGED
from pyworm.io.quantities import describe
from pyworm.plots.attempts import ROOM, PicturesError
from pyworm.plots.contact.gap import draw_gap
from pyworm.plots.draw import SCENE_PICTURES, draw
from pyworm.result.result import open_result
from pyworm.solver.ending import Ending

CASE = CASES / "point_m20_l10.toml"
RUN = ("run", str(CASE), "--accuracy", "30%", "--effects", "isothermal", "--pictures", "all")

KILLED = """
import os, signal, sys
import pyworm.plots.draw
from pyworm.cli.main import main

def draw(result, directory, executor, key_only):
    (directory / "scene_000_film.png").write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)

pyworm.plots.draw.draw = draw
sys.exit(main(sys.argv[1:]))
"""

SHORT = """
import resource, sys
import pyworm.plots.draw
from pyworm.cli.main import main
draw = pyworm.plots.draw.draw
left = int(sys.argv.pop(1))

def with_little_memory(result, directory, executor, key_only):
    used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + left, resource.RLIM_INFINITY))
    try:
        return draw(result, directory, executor, key_only=key_only)
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))

pyworm.plots.draw.draw = with_little_memory
sys.exit(main(sys.argv[1:]))
"""

MEASURED = """
import sys
import pyworm.plots.draw
from pyworm.cli.main import main
draw = pyworm.plots.draw.draw

def kilobytes(key):
    return next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith(key))

def measured(result, directory, executor, key_only):
    before = kilobytes("VmSize")
    drawn = draw(result, directory, executor, key_only=key_only)
    print(1024 * (kilobytes("VmPeak") - before), file=sys.stderr)
    return drawn

pyworm.plots.draw.draw = measured
sys.exit(main(sys.argv[1:]))
"""


def fails(case_name, solution):
    raise ValueError("arange:\ncannot compute length")


def needs_much(case_name, solution):
    raise MemoryError


def ends_its_process(case_name, solution):
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.fixture(scope="module")
def result():
    built = make_result()
    return replace(built, solutions=tuple(built.solutions), mesh_cycle=None)


@pytest.fixture
def unrendered(monkeypatch):
    """Files of pictures are empty, in tests of which ones there are."""
    monkeypatch.setattr("pyworm.plots.attempts.write", lambda figure, path: path.touch() or path)


@pytest.mark.usefixtures("unrendered")
def test_one_that_fails_costs_no_other(tmp_path, result, monkeypatch):
    every = {path.name for path in draw(result, tmp_path / "all")}
    monkeypatch.setitem(SCENE_PICTURES["point"], "gap", fails)
    with pytest.raises(PicturesError) as told:
        draw(result, tmp_path / "some")
    assert str(told.value) == (
        "not drawn: scene_000_gap.png, scene_001_gap.png: ValueError: arange: cannot compute length"
    )
    left = {path.name for path in (tmp_path / "some").iterdir()}
    assert left == {path.name for path in told.value.drawn} == {n for n in every if "_gap" not in n}


@pytest.mark.usefixtures("unrendered")
@pytest.mark.parametrize("json_asked", [True, False], ids=["json", "table"])
def test_figures_and_table_come_first_and_the_exit_code_is_theirs(
    tmp_path, capsys, monkeypatch, json_asked
):
    shown = []

    def after_the_table(case_name, solution):
        shown.append(capsys.readouterr().out)
        raise MemoryError

    monkeypatch.setitem(SCENE_PICTURES["point"], "pressure", after_the_table)
    out = tmp_path / "out"
    assert main([*RUN, "--out", str(out), *["--json"] * json_asked]) == CONVERGED
    told = capsys.readouterr()
    assert told.err == "pyworm: not drawn: scene_000_pressure.png: there is not enough memory\n"
    assert open_result(out / "result.nc").converged
    drawn = {path.name for path in out.glob("*.png")}
    assert "scene_000_film.png" in drawn and "scene_000_pressure.png" not in drawn
    if json_asked:
        assert {Path(name).name for name in json.loads(told.out)["pictures"]} == drawn
    else:
        assert "Minimum film" in shown[0] and "result.nc" in shown[0]
    # the pictures alone are what `plot` is asked for
    assert main(["plot", str(out / "result.nc"), "--pictures", "all"]) == FAILED


def test_a_scene_that_did_not_converge_still_gives_its_exit_code(tmp_path, monkeypatch, capsys):
    solved = {}

    def unconverged(scene, plan, *how):
        from pyworm.solver.solve import solve

        lost = {"converged": False, "ending": Ending.NO_FILM, "stop_reason": "lost"}
        solved["one"] = replace(solve(scene, plan), **lost)
        return solved["one"]

    monkeypatch.setattr("pyworm.batch.task.solve", unconverged)
    for name in SCENE_PICTURES["point"]:
        monkeypatch.setitem(SCENE_PICTURES["point"], name, fails)
    assert main([*RUN, "--out", str(tmp_path)]) == NOT_CONVERGED
    said = capsys.readouterr().err
    assert "_gap.png, scene_000_pressure.png, scene_000_film.png and" in said
    assert said.count("\n") == 2
    assert "(lost)" in said


def test_a_disk_that_is_full_costs_no_figure(tmp_path, capsys, monkeypatch):
    def full(result, directory, executor, key_only):
        (directory / "half.png").write_text("half")
        raise OSError("No space left on device")

    monkeypatch.setattr("pyworm.plots.draw.draw", full)
    assert main([*RUN, "--out", str(tmp_path / "out")]) == CONVERGED
    where = f"{tmp_path / 'out'}: cannot be written (No space left on device)"
    assert capsys.readouterr().err == f"pyworm: no pictures: {where}\n"
    assert [path.name for path in tmp_path.rglob("*")] == ["out", "result.nc"]


def test_a_process_that_dies_while_drawing_costs_the_pictures_of_its_scene(tmp_path, result):
    """As when memory runs out: the system ends the process."""
    pictures = {"point": SCENE_PICTURES["point"]}
    with WorkerPool(1) as pool:
        pool.submit(_replace_picture, "gap", ends_its_process).result()
        with pytest.raises(PicturesError) as told:
            draw(replace(result, solutions=result.solutions[:1]), tmp_path, pool)
    assert str(told.value).startswith(
        "not drawn: scene_000_*.png: WorkerDiedError: its process was"
    )
    assert [path.name for path in told.value.drawn] == ["regimes.png"]
    assert SCENE_PICTURES == {**SCENE_PICTURES, **pictures}


def _replace_picture(name, picture):
    SCENE_PICTURES["point"][name] = picture


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs Linux's /proc")
@pytest.mark.parametrize(
    "left",
    [
        *(0, 4_000_000, 290_000_000),
        *(pytest.param(of, marks=pytest.mark.long) for of in (1_000_000, 16_000_000, 38_500_000)),
    ],
)
def test_little_memory_while_drawing_costs_no_figure(tmp_path, left):
    """With a few MB left libraries crash; with 39 they did where they were loaded."""
    command = [sys.executable, "-c", SHORT, str(left), *RUN, "--out", str(tmp_path)]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ended.returncode == CONVERGED, ended.stderr
    assert "Traceback" not in ended.stderr
    assert ended.stderr.startswith(("pyworm: not drawn: ", "pyworm: no pictures: "))
    assert ended.stderr.count("\n") == 1
    assert "Minimum film" in ended.stdout
    assert open_result(tmp_path / "result.nc").converged


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs Linux's /proc")
def test_pictures_and_what_draws_them_need_no_more_than_is_asked_for(tmp_path):
    command = [sys.executable, "-c", MEASURED, *RUN, "--out", str(tmp_path)]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    print(f"{float(told) / 1e6:.0f} MB")
    assert float(told) < ROOM


def test_a_run_killed_while_drawing_leaves_nothing_behind_after_the_next(tmp_path, monkeypatch):
    out = tmp_path / "out"
    command = [*RUN, "--out", str(out)]
    ended = subprocess.run([sys.executable, "-c", KILLED, *command], check=False)
    assert ended.returncode == -signal.SIGKILL
    assert len(list(tmp_path.rglob("scene_000_film.png"))) == 1
    monkeypatch.setattr("pyworm.plots.draw.draw", lambda result, directory, executor, key_only: [])
    assert main(command) == CONVERGED
    assert [path.name for path in tmp_path.rglob("*")] == ["out", "result.nc"]


def test_a_tooth_whose_gap_is_unknown_shows_that_of_the_grid():
    nowhere = xr.Dataset(
        {"tooth_gap": (("tooth_y", "tooth_x"), np.full((3, 3), np.nan))},
        coords={"tooth_x": [-1.0, 0.0, 1.0], "tooth_y": [-1.0, 0.0, 1.0]},
    )
    worm = make_worm_solution()
    unknown = replace(worm, fields=worm.fields.merge(describe(nowhere)))
    levels = [
        np.concatenate([of.levels for of in draw_gap("case", one).axes[0].collections[:1]])
        for one in (worm, unknown)
    ]
    assert levels[0].size > 5
    assert np.array_equal(*levels)


def test_a_gap_of_zero_has_no_contours():
    worm = make_worm_solution()
    flat = replace(worm, fields=worm.fields.assign(gap=0 * worm.fields["gap"]))
    axes = draw_gap("case", flat).axes[0]
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts[0] == "dry contact"
