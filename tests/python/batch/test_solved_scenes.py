"""Scenes kept on the way: damaged ones are solved again, and two runs at once do not harm each other."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from folders import CASES

from pyworm.batch.case_run import RESULT_NAME, SCENES, run
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.case.case import load
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.result.result import Result, open_result

TRACTION = CASES / "traction_steel.toml"
RUN = ("run", str(TRACTION), "--accuracy", "30%", "--effects", "isothermal", "--json")

TOGETHER = """
import sys, time
from pathlib import Path
import pyworm.batch.case_run, pyworm.plots.draw
from pyworm.cli.main import main

solve_all = pyworm.batch.case_run.solve_all

def together(*arguments):
    "Once the other run is as far."
    own, other = Path(sys.argv[1]), Path(sys.argv[2])
    own.touch()
    for _ in range(6000):
        if other.exists():
            return solve_all(*arguments)
        time.sleep(0.01)
    sys.exit("the other run does not come")

def one_picture(result, directory, executor, key_only):
    (directory / "mark.png").write_text(sys.argv[1])
    return [directory / "mark.png"]

pyworm.batch.case_run.solve_all, pyworm.plots.draw.draw = together, one_picture
if __name__ == "__main__":
    sys.exit(main(sys.argv[3:]))
"""


def tasks_of(count=2):
    case = load(TRACTION)
    return [Task(case, place, 0.3, "isothermal") for place in case.places()[:count]]


@pytest.fixture(scope="module")
def solved():
    """Two tasks and their results."""
    return [(task, task.solved()) for task in tasks_of()]


def cut_short(file, other):
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def zeros(file, other):
    file.write_bytes(bytes(file.stat().st_size))


def another_scene(file, other):
    file.write_bytes(other.read_bytes())


def nested(file, other):
    file.write_text("[" * 100_000)


def a_link_to_nothing(file, other):
    file.unlink()
    file.symlink_to(file.with_name("nowhere"))


@pytest.mark.parametrize("fields", [True, False], ids=["nc", "json"])
@pytest.mark.parametrize("damage", [cut_short, zeros, another_scene, nested, a_link_to_nothing])
def test_a_damaged_scene_is_solved_again(tmp_path, solved, monkeypatch, fields, damage):
    store = Store(tmp_path / "scenes", fields)
    results = {task.key: result for task, result in solved}
    first, second = (task for task, _ in solved)
    for task in (first, second):
        store.keep(task, results[task.key])
    sound = store.summary(first)
    (store.directory / os.fsdecode(b"\xff.json")).touch()  # a name that is no text
    assert store.missing([first, second]) == []
    damage(store.file(first), store.file(second))
    assert store.missing([first, second]) == [first]
    monkeypatch.setattr(Task, "solved", lambda task, *how: results[task.key])
    assert solve_all([first], store) == {}
    assert store.missing([first, second]) == []
    assert store.summary(first) == sound


def test_a_sweep_over_a_damaged_scene_solves_it_again(tmp_path, capsys):
    sweep = tmp_path / "sweep.toml"
    sweep.write_text(
        f'title = "two loads"\ncase = "{TRACTION}"\neffects = "isothermal"\n[fixed]\naccuracy = "30 %"\n'
        '"motion.slide_roll_ratios" = [0]\n[[vary]]\n"contact.load" = ["20 N", "40 N"]\n'
    )
    command = ["sweep", str(sweep), "--json", "--out", str(tmp_path / "out")]
    assert main(command) == CONVERGED
    whole = json.loads(capsys.readouterr().out)["scenes"]
    damaged = next((tmp_path / "out" / "scenes").glob("*.json"))
    damaged.write_text(damaged.read_text()[:100])
    assert main(command) == CONVERGED
    told = capsys.readouterr()
    assert told.err.startswith("pyworm: 1 of 2 contacts were solved before, in ")
    timed = dict.fromkeys(("seconds", "convolutions"))
    assert [row | timed for row in json.loads(told.out)["scenes"]] == [row | timed for row in whole]


def test_two_identical_runs_in_one_directory_at_once_both_succeed(tmp_path):
    out, marks = tmp_path / "out", [tmp_path / "one", tmp_path / "other"]
    command = [*RUN, "--slide-roll-ratio", "0", "1", "--out", str(out)]
    both = [
        subprocess.Popen(
            [sys.executable, "-c", TOGETHER, str(own), str(other), *command, *more],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for own, other, more in ((*marks, ()), (*reversed(marks), ("-j", "2")))
    ]
    told = [process.communicate() for process in both]
    assert [process.returncode for process in both] == [CONVERGED, CONVERGED], told
    for said, complaint in told:
        assert complaint == ""
        printed = json.loads(said)
        assert len(printed["scenes"]) == 2 and printed["failed"] == {}
    assert sorted(path.name for path in out.rglob("*")) == ["mark.png", "result.nc"]
    assert open_result(out / "result.nc").converged


def test_scenes_that_another_run_took_into_its_result_are_read_there(tmp_path, monkeypatch, solved):
    """As when the other run ends between this one's last solve and its reading of what was solved."""
    out = tmp_path / "out"
    command = [*RUN, "--slide-roll-ratio", "0", "--out", str(out)]
    monkeypatch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
    taken = []
    real = solve_all

    def and_the_other_ends(tasks, store, executor, progress):
        reasons = real(tasks, store, executor, progress)
        if not taken:
            taken.append(True)
            assert main(command) == CONVERGED  # takes it and removes it
            assert not store.directory.exists()
        return reasons

    monkeypatch.setattr("pyworm.batch.case_run.solve_all", and_the_other_ends)
    assert main(command) == CONVERGED
    assert len(open_result(out / "result.nc").solutions) == 1


def test_an_earlier_result_that_cannot_be_used_is_reported(tmp_path, capsys, monkeypatch):
    command = [*RUN, "--slide-roll-ratio", "0", "--out", str(tmp_path)]
    monkeypatch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
    (tmp_path / "result.nc").write_text("no result")
    assert main(command) == CONVERGED
    said = capsys.readouterr().err
    assert said.startswith(f"pyworm: {tmp_path / 'result.nc'} is not a pyworm result")
    assert said.endswith("its contacts are solved again\n") and said.count("\n") == 1


def test_a_file_of_another_scene_is_not_used(tmp_path, solved):
    (first, result), (second, _) = solved
    store = Store(tmp_path, fields=True)
    store.keep(first, replace(result, provenance=result.provenance | {"keys": [second.key]}))
    assert store.missing([first]) == [first]


@pytest.mark.parametrize("fields", [True, False], ids=["nc", "json"])
def test_scenes_that_did_not_converge_are_stored(tmp_path, solved, fields):
    """Such as a solve that ended before its first step, of films that no law of the oil bears."""
    task, result = solved[0]
    (solution,) = result.solutions
    nothing = replace(
        solution,
        converged=False,
        history=solution.history.isel(iteration=slice(0)),
        fields=solution.fields.assign(film=np.nan * solution.fields["film"]),
    )
    store = Store(tmp_path, fields)
    store.keep(task, replace(result, solutions=(nothing,)))
    assert store.missing([task]) == []
    assert not store.summary(task)["converged"]


def test_the_only_scene_is_kept_where_its_result_cannot_be_written(tmp_path, monkeypatch, solved):
    task, result = solved[0]
    tasks, case = [task], task.case
    with monkeypatch.context() as patched:
        patched.setattr(Task, "solved", lambda task, *how: result)
        save = Result.save

        def full(result, path):
            if path.name == RESULT_NAME:
                raise OSError("no space left")
            return save(result, path)

        patched.setattr(Result, "save", full)
        with pytest.raises(OSError, match="no space left"):
            run(case, tasks, tmp_path)
    assert [path.stem for path in (tmp_path / SCENES).iterdir()] == [task.key]
    said = []
    run(case, tasks, tmp_path, print_message=said.append)
    assert said == [f"1 of 1 contacts were solved before, in {tmp_path}"]
    assert [path.name for path in tmp_path.iterdir()] == [RESULT_NAME]
