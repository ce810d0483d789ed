"""Lifts of a drive's teeth by transient films."""

from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import pytest

from pyworm.batch import drive_iteration, transient_solutions
from pyworm.solver.transient.lifts import Lift


class Part:
    """A part of a life whose solve finds a lift at its phase, or breaks."""

    def __init__(self, phase, moving):
        self.phase = phase

    def __call__(self):
        if self.phase > 0.5:
            raise MemoryError
        return {self.phase: 1e-6}


@pytest.mark.parametrize("processes", [0, 2])
def test_a_part_that_breaks_costs_its_own_lifts_alone(processes, monkeypatch):
    monkeypatch.setattr(transient_solutions, "PartLifts", Part)
    monkeypatch.setattr(transient_solutions, "tasks_by_part", lambda tasks: tasks)
    executor = ThreadPoolExecutor(processes) if processes else None
    assert transient_solutions.lifts_of([0.2, 0.8], True, executor) == {0.2: 1e-6}


def test_a_film_without_squeeze_is_not_transient_whatever_its_plan():
    assert not transient_solutions.is_transient(SimpleNamespace(effects=("auto", "-squeeze")))


def test_what_first_solves_lack_of_a_lift_is_interpolated_between_phases(monkeypatch):
    """Steady films of two phases find 0.1 and 0.3 um more than those on the first grids."""
    lifts = {phase: Lift(1e-6, 0.02, 3.0) for phase in (1.0, 0.0, 0.5)}
    monkeypatch.setattr(drive_iteration, "lifts_of", lambda *given: lifts)
    monkeypatch.setattr(drive_iteration, "load_change", lambda *given: 0.0)
    case = SimpleNamespace(with_found=lambda found: found)
    search = drive_iteration._Search({"operation": ("lifts", "friction")}, 0.05, print)
    found = search._by_motion(case, [], None, {0.0: 0.1e-6, 1.0: 0.3e-6})["operation"]
    assert found["friction"] == 0.02
    assert [phase for phase, _ in found["lifts"]] == [0.0, 0.5, 1.0]
    assert [lift for _, lift in found["lifts"]] == pytest.approx([1.1e-6, 1.2e-6, 1.3e-6])
