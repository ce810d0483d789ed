"""A run that takes twice the processor time expected of it says why."""

from dataclasses import replace

import pytest
from cheap_tasks import TRACTION, some_tasks

from pyworm.batch.expected_run import expected_run
from pyworm.batch.overrun import MAX_TIME_RATIO, MIN_SECONDS, overrun
from pyworm.cli import run as command
from pyworm.cli.main import main

LONG = 1e6


@pytest.fixture(scope="module")
def run():
    """Case, tasks and result of two cheap contacts."""
    tasks = some_tasks(2)
    return tasks[0].case, tasks, [task.solved().solutions[0] for task in tasks]


class Solved:
    """What of a result counts here."""

    def __init__(self, solutions):
        self.solutions = solutions


def taking(solution, seconds, **cost):
    """The solution as if it had taken some processor time."""
    cost = replace(solution.cost, convolutions=seconds, unit_seconds=1.0, **cost)
    return solution.changed(cost=cost)


def test_a_run_of_the_usual_time_says_nothing(run, monkeypatch):
    case, tasks, solutions = run
    whole = expected_run(case, tasks).seconds
    assert overrun(case, tasks, Solved(solutions), MIN_SECONDS) is None
    monkeypatch.setattr("pyworm.batch.overrun.MIN_SECONDS", 0.0)
    assert overrun(case, tasks, Solved(solutions), MAX_TIME_RATIO * whole) is None


def test_the_contact_that_took_longest_is_named_first(run):
    case, tasks, (first, second) = run
    found = overrun(case, tasks, Solved([taking(first, 1.0e4), taking(second, 2.0e4)]), LONG)
    assert found.sentence.startswith("took 1000000 s of CPU time where ")
    assert [of.split(" (")[0] for of in found.reasons] == [second.name, first.name]
    assert all("each Newton step took longer" in reason for reason in found.reasons)


def test_newton_steps_and_nodes_beyond_those_expected_are_named(run):
    case, tasks, (first, _) = run
    twice = replace(tasks[0], accuracy=0.5)
    work = twice.plan.work
    stages = tuple(
        replace(of, nodes=of.nodes / 4, cold=of.cold / 4, full=0.0) for of in work.stages
    )
    vars(twice)["plan"] = replace(twice.plan, work=replace(work, stages=stages))
    (reason,) = overrun(case, [twice], Solved([taking(first, 1.0e4)]), LONG).reasons
    assert f"{first.history.sizes['iteration']} Newton steps" in reason
    assert "a finest grid of" in reason


def test_more_transient_solves_than_expected_are_the_reason(run):
    case, tasks, (first, second) = run
    solutions = [taking(first, 1e-9), taking(second, 1.0e4, transient_solves=3)]
    (reason,) = overrun(case, tasks, Solved(solutions), LONG).reasons
    assert reason.startswith(second.name)
    assert "3 transient solves, 1 expected" in reason


def test_what_contacts_share_is_the_reason_where_none_of_them_is(run):
    case, tasks, solutions = run
    usual = Solved([taking(solution, 1e-9) for solution in solutions])
    assert "no contact by itself; the rest" in overrun(case, tasks, usual, LONG).sentence


def test_the_command_tells_it(monkeypatch, tmp_path, capsys):
    clock = iter((0.0, LONG))
    monkeypatch.setattr("pyworm.batch.overrun.processor_seconds", lambda: next(clock))
    how = [
        "--accuracy",
        "30%",
        "--effects",
        "isothermal",
        "--pictures",
        "none",
        "--out",
        str(tmp_path),
    ]
    assert main(["run", str(TRACTION), "--slide-roll-ratio", "0", *how]) == command.CONVERGED
    assert "of CPU time where" in capsys.readouterr().err
