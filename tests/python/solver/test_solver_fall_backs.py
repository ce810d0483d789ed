"""What the solver does where a step, a past or its own cache fails."""

from dataclasses import replace
from math import log2
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.kernel.core import NO_DESCENT, NO_MEMORY, NOT_FINITE, KernelError
from pyworm.planning.effects.geometry import as_line
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.solver.cost import calibration as calibration_module
from pyworm.solver.cost.calibration import calibration
from pyworm.solver.cost.expected_motion import motion, time_grid_if_any
from pyworm.solver.estimate import Estimate
from pyworm.solver.newton import newton_step
from pyworm.solver.transient import film_series, next_film, time_integration, transient
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import TimeIntegration
from pyworm.solver.transient.time_records import TimeRecord
from pyworm.solver.transient.time_steps import steps_of
from pyworm.solver.transient.transient import Rates


def ball(speed=1.0):
    """A ball that rolls at a speed [m/s]."""
    motion = speed, 0.0
    return point("ball", (0.02, 0.02), 50.0, (motion, motion), (STEEL, STEEL), mineral(0.09, 2e-8))


def in_life(at, transits=5.0, present=None):
    """The contact of the end of a life, or of another time of it [transits]."""
    transit = predicted(ball()).transit
    life = Life(transits * transit, at)
    return replace(ball(), past=Past(life, (transits if present is None else present) * transit))


def unloaded(seconds):
    raise ValueError("no load")


def diverged(*given):
    raise NoFilmError("no film")


def planned(scene):
    return pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))


@pytest.fixture
def accelerated():
    return in_life(lambda seconds: ball(1 + 100 * seconds))


def test_a_contact_without_a_life_under_load_has_no_time_steps(accelerated):
    plan = planned(accelerated)
    empty = in_life(unloaded)
    assert time_grid_if_any(empty, plan) is None
    assert motion(empty, plan) is None
    # a course whose contact carries no load at present
    over = replace(accelerated, past=Past(accelerated.past.life, 2 * accelerated.past.seconds))
    time_grid = time_grid_of(accelerated.past.life, plan)
    assert motion(over, plan, time_grid) is None


def test_a_contact_at_rest_is_no_knot_of_a_course():
    def starting(seconds):
        line = as_line(ball())
        return replace(line, velocities=(0.0, 0.0)) if seconds < 1e-3 else line

    life = Life(5e-3, starting)
    scene = replace(starting(5e-3), past=Past(life, 5e-3))
    time_grid = time_grid_of(life, pyworm.plan(scene, 0.2, ("isothermal", "squeeze"), ("film",)))
    assert time_grid.begin == 0.0 and time_grid.end == pytest.approx(5e-3)


@pytest.mark.parametrize(
    ("module", "name"), [(transient, "integrate_in_time"), (next_film, "_onward")]
)
def test_a_finer_transient_solve_that_finds_no_film_leaves_the_rates_as_they_are(
    accelerated, monkeypatch, module, name
):
    """Whether it finds none from which to begin, or loses its film on the way."""
    monkeypatch.setattr(module, name, diverged)
    rates = Rates((SimpleNamespace(limited=False),))
    assert transient.finer(accelerated, planned(accelerated), rates) == replace(rates, finest=True)


def test_a_transient_solve_that_loses_its_film_on_the_way_leaves_the_reason(
    accelerated, monkeypatch
):
    monkeypatch.setattr(next_film, "_onward", diverged)
    rates = transient.rates_at_present(accelerated, planned(accelerated))
    assert rates == Rates((), flaw="no film")


def test_what_coarser_transient_solves_found_is_kept_where_the_next_loses_its_film(
    accelerated, monkeypatch
):
    """Else a finer request would end with a steady film where a coarser one has that in motion."""
    solved = transient.integrate_on

    def lost(*given):
        return replace(solved(*given), rates={}, failure="no film")

    monkeypatch.setattr(transient, "integrate_on", lost)
    plan = planned(accelerated)
    monkeypatch.setattr(transient, "solves_of_life", lambda accuracy: 2)
    rates = transient.rates_at_present(accelerated, plan)
    assert len(rates.found) == len(rates.records) == 1
    assert rates.finest
    assert rates.flaw is None


@pytest.mark.parametrize("status, raised", [(NO_DESCENT, False), (NO_MEMORY, True)])
def test_a_newton_step_that_does_not_descend_is_none_and_other_failures_are_raised(status, raised):
    def step(forcing):
        raise KernelError(status)

    film = SimpleNamespace(balance=SimpleNamespace(residual=1e-3, warming=0.0), step=step)
    level = SimpleNamespace(film=film, forcing=0.1)
    if raised:
        with pytest.raises(KernelError):
            newton_step(level)
    else:
        assert newton_step(level) is None


def test_an_estimate_is_no_number_beside_what_is_none():
    with pytest.raises(TypeError):
        Estimate(1.0, 0.1) + None


def test_where_nothing_can_be_kept_the_speed_is_measured_each_time(tmp_path, monkeypatch):
    occupied = tmp_path / "cache"
    occupied.write_text("no directory")
    measured = []

    def calibrate():
        measured.append(calibration_module.Calibration({}, {}, {}, {}))
        return measured[-1]

    monkeypatch.setenv("XDG_CACHE_HOME", str(occupied))
    monkeypatch.setattr(calibration_module, "calibrate", calibrate)
    assert calibration() is measured[0] and calibration() is measured[1]


def test_a_processor_without_a_file_of_its_name_has_that_of_the_platform(monkeypatch):
    def unreadable(path, *how, **named):
        raise OSError

    monkeypatch.setattr(calibration_module.platform, "processor", lambda: "of the platform")
    monkeypatch.setattr(Path, "read_text", unreadable)
    assert calibration_module._processor() == "of the platform"


@pytest.mark.parametrize("error", [ValueError("at rest"), KernelError(NOT_FINITE)])
def test_a_film_that_the_kernel_gives_up_is_lost_at_its_time(error):
    with (
        pytest.raises(NoFilmError, match=r"0\.125 s after the first touch"),
        next_film._told(0.125),
    ):
        raise error
    with pytest.raises(KernelError), next_film._told(0.125):
        raise KernelError(7)  # an interrupt is no film that is lost


def test_films_before_one_that_is_lost_are_kept_with_the_reason(accelerated, monkeypatch):
    time_grid = time_grid_of(accelerated.past.life, planned(accelerated))
    reached, tried = next_film._onward, []

    def onward(*how):
        tried.append(how[1].seconds)
        return reached(*how) if len(tried) < 5 else diverged()

    monkeypatch.setattr(next_film, "_onward", onward)
    found = time_integration.integrate_in_time(time_grid, 0, 0.0, [accelerated.past.seconds])
    assert found.failure == "no film" and found.rates == {}
    assert 1 < len(found.records) < 9


def test_films_after_one_that_is_lost_are_found_once_another_beginning_is_forgotten(monkeypatch):
    """A line whose speed grows slowly; what a beginning leaves after two transits is 0.3 %."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    transit = predicted(as_line(ball())).transit
    life = Life(8 * transit, lambda at: as_line(ball(1 + 0.05 * at / transit)))
    scene = replace(as_line(ball()), past=Past(life, life.duration))
    time_grid = time_grid_of(life, pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",)))
    wanted = [time_grid.time_at(place) for place in (1.0, 3.5, 7.0)]
    whole = time_integration.integrate_in_time(time_grid, 0, 0.0, wanted)
    reached, lost = film_series.reached, time_grid.time_at(3.0)

    def lost_once(time_grid, step, *how):
        if how[0] and how[0][0].seconds < lost <= step.seconds:
            diverged()
        return reached(time_grid, step, *how)

    monkeypatch.setattr(film_series, "reached", lost_once)
    found = time_integration.integrate_in_time(time_grid, 0, 0.0, wanted)
    assert found.failure == "no film"
    assert list(found.rates) == [
        wanted[0],
        wanted[2],
    ]  # 3.5 is half a transit after the other beginning
    seconds = np.array([time_record.seconds for time_record in found.records])
    assert np.all(np.diff(seconds) > 0)
    assert not np.any((seconds > lost) & (seconds < time_grid.time_at(4.9)))
    for name in ("film_min", "film_central"):
        last, usual = (solve.records[-1].figures[name] for solve in (found, whole))
        assert last == pytest.approx(usual, rel=3e-3)


def test_where_no_other_beginning_is_found_films_before_the_lost_one_are_kept(
    accelerated, monkeypatch
):
    film = TimeIntegration({}, {}, (TimeRecord(0.0, None, 1.0, (1.0,), {}),), 1, failure="no film")
    time_grid = time_grid_of(accelerated.past.life, planned(accelerated))
    steps = steps_of(time_grid, 0, 0.0, time_grid.end)
    monkeypatch.setattr(time_integration, "_through", lambda *how: diverged())
    request = time_integration.Request([time_grid.end])
    assert time_integration._resumed(time_grid, steps, request, film) is film


def test_a_life_without_steady_films_is_given_up_after_a_few(accelerated, monkeypatch):
    """A contact whose steady film is not found costs most; one is not sought at each of a hundred steps."""
    time_grid, tried = time_grid_of(accelerated.past.life, planned(accelerated)), []

    def none(time_grid, step):
        tried.append(step.seconds)
        return diverged()

    monkeypatch.setattr(time_integration, "steady_level", none)
    with pytest.raises(next_film.NoFilmError):
        time_integration.integrate_in_time(time_grid, 2, 0.0, [accelerated.past.seconds])
    steps = steps_of(time_grid, 2, 0.0, accelerated.past.seconds)
    assert len(tried) <= 5 + log2(len(steps)) < len(steps) / 4
    assert tried[:4] == [step.seconds for step in steps[:4]]
    assert tried[-1] >= accelerated.past.seconds > tried[-2]


@pytest.mark.parametrize(
    ("count", "wanted", "tried"),
    [(1, 5, [0]), (9, 3, [0, 1, 2, 3]), (99, 40, [0, 1, 2, 3, 4, 8, 16, 32, 40])],
)
def test_a_solve_begins_within_half_of_what_comes_before(count, wanted, tried):
    assert list(time_integration._beginnings(range(count), wanted)) == tried


def test_a_step_that_is_lost_is_halved(accelerated, monkeypatch):
    time_grid = time_grid_of(accelerated.past.life, planned(accelerated))
    reached, tried = next_film._onward, []

    def onward(*how):
        tried.append(how[1].seconds)
        return diverged() if len(tried) == 2 else reached(*how)

    monkeypatch.setattr(next_film, "_onward", onward)
    found = time_integration.integrate_in_time(time_grid, 0, 0.0, [accelerated.past.seconds])
    assert found.failure is None and accelerated.past.seconds in found.rates
    assert tried[2] == pytest.approx((tried[0] + tried[1]) / 2)


def test_where_the_life_after_the_touch_is_lost_too_what_was_found_before_it_is_kept(
    accelerated, monkeypatch
):
    life = replace(accelerated.past.life, touched=accelerated.past.seconds / 2)
    time_grid = time_grid_of(life, planned(accelerated))
    first = time_integration.TimeIntegration({}, {}, (SimpleNamespace(seconds=0.0),), 1, "lost")

    def through(time_grid, steps, *how):
        return first if steps[0].seconds == 0 else diverged()

    monkeypatch.setattr(time_integration, "_through", through)
    found = time_integration.integrate_in_time(time_grid, 0, 0.0, [accelerated.past.seconds])
    assert found is first
