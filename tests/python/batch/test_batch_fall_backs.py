"""What batch work does where files and scenes do not do as they should."""

import os
import sys
from types import SimpleNamespace

import pytest
from contacts import ball

from pyworm.batch import study, transient_solutions, wear_run, workers
from pyworm.batch.cluster import cluster
from pyworm.batch.scene_task import SceneTask, require_sendable
from pyworm.batch.solved_scenes import Store
from pyworm.batch.transient_solutions import drop_rates, tasks_by_part
from pyworm.batch.wear_integration import UnsolvedError
from pyworm.io.input_error import CaseError
from pyworm.scene.point import Paraboloid


def test_a_file_that_cannot_be_removed_costs_nothing(tmp_path):
    (tmp_path / "one.rate-0.npz").mkdir()
    (tmp_path / "one.rate-1.npz").write_bytes(b"")
    drop_rates(SimpleNamespace(key="one"), tmp_path)
    assert [file.name for file in tmp_path.iterdir()] == ["one.rate-0.npz"]


def test_a_life_without_load_has_no_parts():
    class Unloaded:
        @property
        def time_grid(self):
            raise ValueError("no load")

    assert tasks_by_part([Unloaded()]) == []


def test_a_scene_that_no_process_would_find_is_refused():
    gap = Paraboloid(0.02, 0.02)
    scene = ball(gap=lambda x, y: gap(x, y), radii=(0.02, 0.02))
    with pytest.raises(ValueError, match="cannot go to other processes"):
        require_sendable(SceneTask(scene, 0.1))
    require_sendable(SceneTask(ball(), 0.1))


def test_what_cannot_be_secured_on_a_full_disk_does_not_hide_the_first_error(tmp_path):
    tried = []

    def save(path):
        tried.append(path.name)
        raise OSError("no space left")

    store = Store(tmp_path, fields=True)
    store._solved_here["one"] = SimpleNamespace(save=save)
    store.secure([SimpleNamespace(key="one"), SimpleNamespace(key="two")])
    assert tried == ["one.nc"]


def test_a_life_that_breaks_costs_its_own_tasks_alone(tmp_path, monkeypatch):
    def broken(part, directory):
        raise RuntimeError("of no kind that is expected")

    monkeypatch.setattr(transient_solutions.LifePart, "_solve_into", broken)
    part = object.__new__(transient_solutions.LifePart)
    assert "of no kind that is expected" in part.solve_into(tmp_path)


def test_a_contact_that_cannot_be_planned_is_refused_with_what_varies():
    with pytest.raises(ValueError, match="with load = 50: quantities: heat is none of"):
        study._study(lambda load: ball(), "t", [{"load": (50,)}], (0.1, "auto", ("heat",)), False)


class Broken:
    """A connection over which nothing can be sent."""

    def __init__(self, calls):
        self.calls = list(calls)
        self.sent = []

    def recv(self):
        if not self.calls:
            raise EOFError
        return self.calls.pop(0)

    def send(self, outcome):
        self.sent.append(outcome)
        if len(self.sent) > 1:
            raise OSError


def test_a_process_that_serves_sends_errors_and_ends_with_its_connection(monkeypatch):
    monkeypatch.setattr(workers, "_end_with_parent", lambda: None)
    monkeypatch.setattr(workers, "parent_process", lambda: SimpleNamespace(pid=os.getppid()))
    connection = Broken([(int, ("no number",)), (int, ("7",)), (int, ("8",))])
    workers._serve(connection)
    (first, error), second = connection.sent
    assert first is None and isinstance(error, ValueError)
    assert second == (7, None) and len(connection.calls) == 1  # ended where it could not answer
    ended = Broken([(int, ("7",))])
    workers._serve(ended)
    assert ended.sent == [(7, None)]


def test_worn_flanks_that_cannot_be_solved_are_told_with_the_contacts_that_are_not(
    tmp_path, monkeypatch
):
    def too_few(result, *side):
        raise ValueError("2 phases converged")

    bad = SimpleNamespace(stop_reason="no more nodes")
    monkeypatch.setattr(wear_run, "run_balanced", lambda *how, **named: (result, ()))
    monkeypatch.setattr(wear_run, "flank_grid", too_few)
    monkeypatch.setattr(wear_run.ContactIndex, "of", lambda one: "phase 0.5")
    result = SimpleNamespace(unsound=(bad,))
    run = object.__new__(wear_run.WearRun)
    vars(run).update(
        case=SimpleNamespace(drive=None), tasks=[], directory=tmp_path, print_message=print, how={}
    )
    vars(run).update(_grids=None)
    with pytest.raises(UnsolvedError, match=r"2 phases converged \(phase 0.5: no more nodes\)"):
        run._solved(None, (1e-6, 1e-6))


def test_without_dask_a_scheduler_is_refused_with_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(CaseError, match="install pyworm with its extra"):
        with cluster("tcp://127.0.0.1:9", print):
            pass
