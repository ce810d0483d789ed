"""Batches: the same bits in any order and by any number of processes; what is solved is never lost."""

import os
import pickle
import random
import re
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cheap_tasks import CHEAP, TRACTION, Deadly, some_tasks
from folders import CASES

from pyworm.batch.provenance import program_digest
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.batch.workers import WorkerDiedError, WorkerPool
from pyworm.case.case import load
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED, NOT_CONVERGED
from pyworm.plots.draw import draw
from pyworm.result.result import open_result
from pyworm.scene.index import ContactIndex

RUN = ("run", str(TRACTION), "--accuracy", "30%", "--effects", "isothermal", "--json")
WITHOUT_PICTURES = """
import sys, pyworm.plots.draw
from pyworm.cli.__main__ import main
pyworm.plots.draw.draw = lambda *given, **options: []
sys.exit(main())
"""


def bits(store, tasks):
    """All that was solved but the time it took."""
    solutions = [store.result(task).solutions[0] for task in tasks]
    return [
        (one.figures, {name: one.fields[name].values.tobytes() for name in one.fields})
        for one in solutions
    ]


def test_a_task_takes_its_plan_along_once_made(monkeypatch):
    task, other = some_tasks(2)
    built = task.plan
    monkeypatch.setattr("pyworm.batch.task.plan_of", lambda *scene_and_more: None)
    assert [pickle.loads(pickle.dumps(one)).plan for one in (task, other)] == [built, None]


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Tasks, and what this process alone makes of them."""
    tasks, store = some_tasks(), Store(tmp_path_factory.mktemp("reference"), fields=True)
    assert solve_all(tasks, store) == {}
    return tasks, bits(store, tasks)


@pytest.mark.parametrize(
    "processes", [2, *(pytest.param(of, marks=pytest.mark.long) for of in (1, 3))]
)
def test_order_and_number_of_processes_do_not_change_a_bit(reference, tmp_path, processes):
    tasks, expected = reference
    store = Store(tmp_path / "scenes", fields=True)
    shuffled = random.Random(processes).sample(some_tasks(), len(tasks))
    shares = []
    with WorkerPool(processes) as pool:
        assert solve_all(shuffled, store, pool, lambda what, share: shares.append(share)) == {}
    assert bits(store, tasks) == expected
    assert shares == [0, 0.25, 0.5, 0.75, 1]


def test_a_task_that_kills_its_process_costs_no_other(reference, tmp_path):
    tasks, expected = reference
    deadly = Deadly(tasks[0].case, ContactIndex(slide_roll_ratio=7.0), **CHEAP)
    store = Store(tmp_path / "scenes", fields=True)
    with WorkerPool(2) as pool:
        failed = solve_all([tasks[0], deadly, *tasks[1:]], store, pool)
    assert failed == {
        deadly.key: "its process was ended by SIGKILL, as when memory runs out",
    }
    assert bits(store, tasks) == expected
    assert store.missing([*tasks, deadly]) == [deadly]


def test_a_process_that_died_is_replaced():
    with WorkerPool(1) as pool:
        first = pool.submit(os.getpid).result()
        assert pool.submit(os.getpid).result() == first
        with pytest.raises(WorkerDiedError, match="exit code 7"):
            pool.submit(os._exit, 7).result()
        assert pool.submit(os.getpid).result() not in (first, os.getpid())


def test_an_exception_of_a_call_is_the_callers():
    with WorkerPool(1) as pool:
        process = pool.submit(os.getpid).result()
        with pytest.raises(FileNotFoundError):
            pool.submit(os.stat, "/no/such/file").result()
        assert pool.submit(os.getpid).result() == process


def test_workers_have_one_thread_each(monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "2")
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    with WorkerPool(1) as pool:
        for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
            assert pool.submit(os.getenv, name).result() == "1"
    assert os.environ["OMP_NUM_THREADS"] == "2"
    assert "OPENBLAS_NUM_THREADS" not in os.environ


def test_a_failing_scene_is_reported_and_costs_no_other(reference, tmp_path):
    tasks, _ = reference
    bad = Task(tasks[0].case, tasks[0].place, accuracy=2.0)
    store = Store(tmp_path / "scenes", fields=True)
    failed = solve_all([bad, tasks[0]], store)
    assert list(failed) == [bad.key]
    assert failed[bad.key].startswith("ValueError: accuracy = 2: must be a relative error between")
    assert store.missing([bad, tasks[0]]) == [bad]


def test_stored_scalars_are_unchanged(reference, tmp_path):
    tasks, _ = reference
    full, lean = (Store(tmp_path / name, fields=name == "full") for name in ("full", "lean"))
    for store in (full, lean):
        assert store.missing([tasks[0], tasks[0]]) == [tasks[0]]
        assert solve_all(tasks[:1], store) == {}
        assert store.missing(tasks[:2]) == [tasks[1]]
    one, other = (store.summary(tasks[0]) for store in (full, lean))
    timed = dict.fromkeys(("seconds", "convolutions"))
    assert one | timed == other | timed
    lean.file(tasks[0]).write_bytes(b"")  # a power cut
    assert lean.missing(tasks[:1]) == tasks[:1]
    lean.drop(tasks)
    assert not lean.directory.exists()


def test_a_key_depends_on_what_decides_a_solution_and_nothing_else(tmp_path):
    text = TRACTION.read_text()

    def key(place=ContactIndex(slide_roll_ratio=0.5), accuracy=0.01, effects=("auto",), **changes):  # noqa: B008
        changed = text
        for old, new in changes.values():
            assert old in changed
            changed = changed.replace(old, new)
        (tmp_path / "case.toml").write_text(changed)
        return Task(load(tmp_path / "case.toml"), place, accuracy, effects).key

    alike = [
        key(),
        Task(load(TRACTION), ContactIndex(slide_roll_ratio=0.5), 0.01).key,
        key(title=("Traction curve of", "Friction of")),
        key(accuracy_of_case=('accuracy = "3 %"', 'accuracy = "5 %"')),
        key(places=("[0, 0.01, ", "[0, 0.011, ")),
        key(unit=('"41.33 N"', '"0.04133 kN"')),
    ]
    assert len(set(alike)) == 1
    unlike = [
        key(place=ContactIndex(slide_roll_ratio=0.6)),
        key(accuracy=0.02),
        key(effects=("isothermal",)),
        key(load=('"41.33 N"', '"41.34 N"')),
        key(oil=('conductivity_c1 = "1.4 1/GPa"', 'conductivity_c1 = "1.5 1/GPa"')),
    ]
    assert len({*alike, *unlike}) == 1 + len(unlike)


def test_a_key_depends_on_the_program_down_to_the_compiled_kernel(tmp_path, monkeypatch):
    kernel = tmp_path / "core"
    digests = []
    for content in (b"one build", b"another", b"one build"):
        kernel.write_bytes(content)
        monkeypatch.setattr("pyworm.kernel.core.EXTENSION", kernel)
        digests.append(program_digest.__wrapped__())
    assert digests[0] == digests[2] != digests[1]


def test_a_key_depends_on_the_content_of_a_gap_file(tmp_path):
    for name in ("gap_example.toml", "gap_example.npz"):
        (tmp_path / name).write_bytes((CASES / name).read_bytes())
    path = tmp_path / "gap_example.toml"
    before = Task(load(path), ContactIndex(), 0.01).key
    assert before == Task(load(CASES / path.name), ContactIndex(), 0.01).key
    with np.load(tmp_path / "gap_example.npz") as held:
        arrays = {name: held[name].copy() for name in held}
    arrays["gap"][0, 0] *= 1 + 1e-9
    np.savez(tmp_path / "gap_example.npz", **arrays)
    assert Task(load(path), ContactIndex(), 0.01).key != before


@pytest.mark.long
def test_processes_draw_the_same_pictures(whole_run, tmp_path):
    result = replace(whole_run, solutions=whole_run.solutions[:2])
    with WorkerPool(2) as pool:
        many = draw(result, tmp_path / "many", pool)
    alone = draw(result, tmp_path / "alone")
    assert [path.name for path in many] == [path.name for path in alone]
    for one, other in zip(many, alone, strict=True):
        assert one.read_bytes() == other.read_bytes()


def children(pid):
    """Worker processes of a process, those that clean up after it left out."""
    threads = Path(f"/proc/{pid}/task").glob("*/children")
    found = [child for thread in threads for child in thread.read_text().split()]
    commands = {child: Path(f"/proc/{child}/cmdline").read_bytes() for child in found}
    return [int(child) for child, command in commands.items() if b"spawn_main" in command]


def started(out):
    """A run of two processes that has solved some of its ten scenes and not all."""
    process = subprocess.Popen(
        [sys.executable, "-c", WITHOUT_PICTURES, *RUN, "-j", "2", "--out", str(out)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not list(out.glob("scenes/[!.]*.nc")):
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.005)
    return process


@pytest.fixture(autouse=True, scope="module")
def without_pictures():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
        yield


@pytest.fixture(scope="module")
def whole_run(tmp_path_factory):
    out = tmp_path_factory.mktemp("whole")
    assert main([*RUN, "--out", str(out)]) == CONVERGED
    return open_result(out / "result.nc")


def assert_same_scenes(result, expected):
    for one, other in zip(result.solutions, expected.solutions, strict=True):
        assert one.figures == other.figures
        assert one.name == other.name
        for name in one.fields:
            assert one.fields[name].values.tobytes() == other.fields[name].values.tobytes()


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs Linux's /proc")
@pytest.mark.parametrize(
    "end",
    [
        signal.SIGKILL,
        *(pytest.param(of, marks=pytest.mark.long) for of in (signal.SIGINT, signal.SIGTERM)),
    ],
)
def test_a_stopped_run_continues_where_it_ended(tmp_path, capsys, whole_run, end):
    process = started(tmp_path)
    workers = children(process.pid)
    assert len(workers) == 2
    process.send_signal(end)
    said = process.communicate()[1]
    if end != signal.SIGKILL:
        assert process.returncode == 128 + end
        assert said == (
            "pyworm: stopped; contacts already solved are kept, the same command continues from there\n"
        )
    assert not (tmp_path / "result.nc").exists()
    given_up = time.monotonic() + 30
    while any(Path(f"/proc/{pid}").exists() for pid in workers):
        assert time.monotonic() < given_up
        time.sleep(0.005)
    kept = len(list(tmp_path.glob("scenes/[!.]*.nc")))
    assert 0 < kept < 10
    assert main([*RUN, "--out", str(tmp_path)]) == CONVERGED
    assert re.match(rf"pyworm: {kept} of 10 contacts were solved before", capsys.readouterr().err)
    assert_same_scenes(open_result(tmp_path / "result.nc"), whole_run)
    assert not (tmp_path / "scenes").exists()


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs Linux's /proc")
def test_a_worker_killed_in_mid_run_costs_its_own_scene(tmp_path, capsys, whole_run):
    process = started(tmp_path)
    os.kill(children(process.pid)[0], signal.SIGKILL)
    process.communicate()
    partly = open_result(tmp_path / "result.nc")
    (reason,) = partly.provenance["failed"].values()
    assert reason == "its process was ended by SIGKILL, as when memory runs out"
    assert process.returncode == NOT_CONVERGED
    assert len(partly.solutions) == 9
    assert main([*RUN, "--out", str(tmp_path)]) == CONVERGED
    assert "9 of 10 contacts were solved before" in capsys.readouterr().err
    assert_same_scenes(open_result(tmp_path / "result.nc"), whole_run)


def test_a_second_run_solves_nothing_and_more_places_only_themselves(
    tmp_path, capsys, monkeypatch, whole_run
):
    arguments = [*RUN, "--out", str(tmp_path), "--slide-roll-ratio"]
    assert main([*arguments, "0", "1"]) == CONVERGED
    assert capsys.readouterr().err == ""
    assert main([*arguments, "1", "2", "0"]) == CONVERGED
    assert "2 of 3 contacts were solved before" in capsys.readouterr().err
    monkeypatch.setattr("pyworm.batch.task.solve", None)
    assert main([*arguments, "2", "1"]) == CONVERGED
    result = open_result(tmp_path / "result.nc")
    assert [solution.slide_roll_ratio for solution in result.solutions] == [2, 1]
