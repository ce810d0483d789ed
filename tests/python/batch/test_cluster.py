"""The same batch on the workers of dask.distributed, one of which is killed in mid-run."""

import json
import os
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path

import pytest
from cheap_tasks import CHEAP, Deadly, some_tasks
from folders import CASES

from pyworm.batch.cluster import cluster as workers_of
from pyworm.batch.solve_tasks import solve_all, solve_for
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.batch.workers import WorkerPool
from pyworm.case.case import load
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED, FAILED
from pyworm.result.sweep_result import open_sweep
from pyworm.scene.index import ContactIndex

pytest.importorskip("distributed")

pytestmark = pytest.mark.long


SWEEP = f"""
title = "Friction of a ball on a disc"
case = "{CASES}/traction_steel.toml"
effects = "isothermal"
fixed = {{ accuracy = "10 %" }}
vary = [{{ "contact.load" = ["20 N", "40 N"] }}]
"""


SETTINGS = {
    "PYTHONPATH": str(Path(__file__).parents[2] / "support"),  # where tasks of tests are found
    "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1",
}


@pytest.fixture
def cluster(tmp_path):
    """Address of a scheduler, and its three workers: four processes of their own."""
    file = tmp_path / "scheduler.json"
    common = ("--scheduler-file", str(file), "--no-dashboard")
    with ExitStack() as running:

        def start(*arguments):
            process = subprocess.Popen(
                [sys.executable, "-m", "dask", *arguments, *common],
                cwd=tmp_path,
                env=os.environ | SETTINGS,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            running.callback(process.wait)
            running.callback(process.kill)
            return process

        scheduler = start("scheduler", "--host", "127.0.0.1", "--port", "0")
        while not file.exists():
            assert scheduler.poll() is None
            time.sleep(0.02)
        workers = [start("worker", "--nthreads", "1", "--no-nanny") for _ in range(3)]
        yield json.loads(file.read_text())["address"], workers, scheduler


def test_nothing_is_lost_when_a_worker_is_killed(cluster, tmp_path):
    address, workers, _ = cluster
    path = tmp_path / "friction.toml"
    path.write_text(SWEEP)
    out = tmp_path / "out"
    command = "import sys; from pyworm.cli.main import main; sys.exit(main())"
    with subprocess.Popen(
        [
            *(sys.executable, "-c", command, "sweep", str(path)),
            *("--scheduler", address, "--out", str(out)),
        ],
        stdout=subprocess.DEVNULL,
    ) as process:
        while not list(out.glob("scenes/[!.]*.json")):
            assert process.poll() is None
            time.sleep(0.005)
        workers[0].kill()
        assert len(list(out.glob("scenes/[!.]*.json"))) < 20
    assert process.returncode == CONVERGED
    timed = ["seconds", "convolutions"]
    table = open_sweep(out / "sweep.nc").table.drop_vars(timed)
    assert main(["sweep", str(path), "--out", str(tmp_path / "alone")]) == CONVERGED
    assert table.identical(open_sweep(tmp_path / "alone" / "sweep.nc").table.drop_vars(timed))


def test_a_scene_that_kills_its_workers_is_given_up(cluster, tmp_path):
    """After two of three workers, as the scheduler is told here; what the third solves is kept."""
    tasks = some_tasks(2)
    deadly = Deadly(tasks[0].case, ContactIndex(slide_roll_ratio=7.0), **CHEAP)
    store = Store(tmp_path / "scenes", fields=True)
    said = []  # that there are no workers for a while, where they are slow to start again
    with workers_of(cluster[0], said.append) as executor:
        failed = solve_all([deadly, *tasks], store, executor)
    assert list(failed) == [deadly.key]
    assert "worker" in failed[deadly.key]
    assert store.missing([deadly, *tasks]) == [deadly]


def sweeping(tmp_path, address, out):
    """A sweep that has solved some of its twenty scenes."""
    path = tmp_path / "friction.toml"
    path.write_text(SWEEP)
    process = subprocess.Popen(
        [
            *(sys.executable, "-m", "pyworm.cli", "sweep", str(path)),
            *("--scheduler", address, "--out", str(out)),
        ],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not list(out.glob("scenes/[!.]*.json")):
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.005)
    return process


def test_a_scheduler_lost_on_the_way_is_one_sentence_and_what_was_solved_is_kept(cluster, tmp_path):
    address, _, scheduler = cluster
    out = tmp_path / "out"
    process = sweeping(tmp_path, address, out)
    scheduler.kill()
    said = process.communicate(timeout=60)[1]
    assert said == (
        f"pyworm: --scheduler {address}: was lost; contacts already solved are kept, "
        "the same command continues from there\n"
    )
    assert process.returncode == FAILED
    assert 0 < len(list(out.glob("scenes/[!.]*.json"))) < 20


def test_lost_workers_are_reported_and_waited_for_until_an_interrupt(cluster, tmp_path):
    address, workers, _ = cluster
    process = sweeping(tmp_path, address, tmp_path / "out")
    for worker in workers:
        worker.kill()
    assert process.stderr.readline() == (
        f"pyworm: --scheduler {address}: has no workers, waiting for some; contacts already solved are kept, "
        "the same command continues from there\n"
    )
    process.terminate()
    assert process.communicate(timeout=60)[1].startswith("pyworm: stopped")
    assert process.returncode == 143


def test_a_worker_of_another_build_fails_its_scenes_with_the_reason(tmp_path, monkeypatch):
    """What it unpickles has another key there, since the key counts the program in."""
    case = load(CASES / "traction_steel.toml")
    task = Task(case, ContactIndex(slide_roll_ratio=0.5), 0.3, "isothermal")
    monkeypatch.setattr("pyworm.batch.task.program_digest", lambda: "another")
    store = Store(tmp_path / "scenes", fields=False)
    reason = solve_for("0" * 24, task, store)
    assert reason == "its worker has another build of pyworm, or of what it builds on"
    assert not store.directory.exists()
    with WorkerPool(1) as pool:  # whose process has the program as it is
        assert solve_all([task], store, pool) == {task.key: reason}
    assert store.missing([task]) == [task]


def test_a_missing_scheduler_is_reported(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("pyworm.batch.cluster.PATIENCE", 0.5)
    path = tmp_path / "friction.toml"
    path.write_text(SWEEP)
    arguments = ["sweep", str(path), "--out", str(tmp_path / "out"), "--scheduler"]
    for address in ("tcp://127.0.0.1:9", "nowhere"):
        assert main([*arguments, address]) == BAD_INPUT
        said = capsys.readouterr().err
        assert said.startswith(f"pyworm: --scheduler {address}: no scheduler answers there")
        assert said.count("\n") == 1
