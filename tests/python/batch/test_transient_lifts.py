"""Lifts of a drive's teeth by transient films."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from pyworm.batch import transient_solutions


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
