"""The same batch on the workers of dask.distributed, one of which is killed in mid-run."""

import json
import os
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path

import pytest
from test_batch import CHEAP, Deadly, some_tasks

from pyworm.batch import solve_all
from pyworm.cli import BAD_INPUT, CONVERGED, main
from pyworm.cluster import cluster as workers_of
from pyworm.place import Place
from pyworm.store import Store
from pyworm.sweep_table import open_sweep

pytest.importorskip("distributed")

SWEEP = f"""
title = "Friction of a ball on a disc"
case = "{Path(__file__).parents[2] / "cases"}/traction_steel.toml"
effects = "isothermal"
fixed = {{ accuracy = "10 %" }}
vary = [{{ "contact.load" = ["20 N", "40 N"] }}]
"""


SETTINGS = {
    "PYTHONPATH": str(Path(__file__).parent),  # where tasks of tests are found
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
        yield json.loads(file.read_text())["address"], workers


def test_nothing_is_lost_when_a_worker_is_killed(cluster, tmp_path):
    address, workers = cluster
    path = tmp_path / "friction.toml"
    path.write_text(SWEEP)
    out = tmp_path / "out"
    command = "import sys; from pyworm.cli import main; sys.exit(main())"
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
    deadly = Deadly(tasks[0].case, Place(slide_roll_ratio=7.0), **CHEAP)
    store = Store(tmp_path / "scenes", fields=True)
    with workers_of(cluster[0]) as executor:
        failed = solve_all([deadly, *tasks], store, executor)
    assert list(failed) == [deadly.key]
    assert "worker" in failed[deadly.key]
    assert store.missing([deadly, *tasks]) == [deadly]


def test_no_scheduler_is_told(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("pyworm.cluster.PATIENCE", 0.5)
    path = tmp_path / "friction.toml"
    path.write_text(SWEEP)
    arguments = ["sweep", str(path), "--out", str(tmp_path / "out"), "--scheduler"]
    for address in ("tcp://127.0.0.1:9", "nowhere"):
        assert main([*arguments, address]) == BAD_INPUT
        said = capsys.readouterr().err
        assert said.startswith(f"pyworm: --scheduler {address}: no scheduler answers there")
        assert said.count("\n") == 1
