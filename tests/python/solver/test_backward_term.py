"""Backward differences beside the end of a contact that moves over the nodes."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from contacts import ball as sliding_ball
from rough_bodies import rough
from test_transient import ball

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.newton import iterate, newton_step
from pyworm.solver.transient import next_film
from pyworm.solver.transient.backward_term import LEAST_TURN, MAX_TURN, BackwardTerm
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.settling import FORCING, TOLERANCE, settling_of
from pyworm.solver.transient.time_level import TimeLevel
from pyworm.solver.transient.time_steps import Step

STEP = 1e-4
TIMES = -STEP * np.arange(4)


def term_and_content(content, films=3):
    """The term now by some films before, and the oil now, of a content over time."""
    before = [TimeLevel(time, content(time), None) for time in TIMES[1 : films + 1]]
    return BackwardTerm(0.0, before, 0.0, None), content(0.0)


def rate(term, content):
    return term.implicit * content + term.explicit


def test_smooth_changes_are_not_limited_and_of_second_order():
    places = np.linspace(0.2, 1.0, 9)

    def content(time):
        return 1e-6 * places * (1 + 0.3 * np.sin(200 * time + 1))

    term, now = term_and_content(content)
    unlimited = rate(term, now)
    assert not term.limit(now)
    assert np.array_equal(rate(term, now), unlimited)
    exact = 1e-6 * places * 0.3 * 200 * np.cos(1)
    assert unlimited == pytest.approx(exact, rel=2e-3)


def test_where_the_end_of_a_contact_has_passed_a_node_no_oil_is_fed_that_is_not_there():
    """The gap falls until a film stays; nodes differ by when."""
    passed = STEP * np.linspace(-0.9, 0.5, 8)

    def content(time):
        return 0.5e-6 + 2e-6 / STEP * np.maximum(passed - time, 0) ** 2 / STEP

    term, now = term_and_content(content)
    chord = (now - content(-STEP)) / STEP
    exact = -4e-6 / STEP * np.maximum(passed, 0) / STEP
    unlimited = rate(term, now)
    assert np.all(unlimited[passed < -0.5 * STEP] > 0)  # the film would grow
    assert term.limit(now)
    limited = rate(term, now)
    assert np.all(np.abs(limited - chord) <= MAX_TURN * np.abs(chord) + LEAST_TURN * now / STEP)
    assert np.all(limited[passed < 0] <= LEAST_TURN * now[passed < 0] / STEP)
    assert np.abs(limited - exact).sum() < 0.8 * np.abs(unlimited - exact).sum()


def test_a_limit_follows_the_oil_and_is_lifted_where_it_no_longer_turns():
    def content(time):
        return np.array([1e-6 + 5e-3 * time, 1e-6])

    term, now = term_and_content(content)
    unlimited = rate(term, now)
    assert term.limit(np.array([3e-6, 1e-6]))
    assert term.limit(now)
    assert rate(term, now) == pytest.approx(unlimited, abs=1e-12)


def test_the_chord_to_one_film_before_is_never_limited():
    term, now = term_and_content(lambda time: np.array([1e-6 - time]), films=1)
    assert not term.limit(now)
    assert rate(term, now) == pytest.approx([-1.0])
    assert term.stored(None) is None
    assert term.remembered(None) is None


def time_grid_until(until):
    """A time grid whose surfaces come together until a time."""
    return SimpleNamespace(
        approach=SimpleNamespace(until=until), come_together=lambda seconds: seconds < until
    )


def film_at(seconds, limited=False):
    """What stands for a film of a time."""
    return SimpleNamespace(seconds=seconds, limited=limited)


@pytest.fixture
def solved(monkeypatch):
    """Times of the films that are solved, instead of films."""
    times = []

    def onward(time_grid, step, before, heat, held, halvings):
        times.append(step.seconds)
        return film_at(step.seconds), 1

    monkeypatch.setattr(next_film, "_onward", onward)
    monkeypatch.setattr(next_film, "heated_levels", lambda time_grid, level, seconds: [])
    monkeypatch.setattr(next_film, "time_level_of", lambda level, seconds: level)
    monkeypatch.setattr(next_film, "is_limited", lambda level: True)
    return times


def test_a_step_with_a_limited_rate_is_halved_once(solved):
    before = [film_at(1.0), film_at(0.0)]
    _, known, _, taken = next_film.reached(time_grid_until(0.5), Step(2.0, 0), before, [], False)
    assert solved == [2.0, 1.5, 2.0] and taken == 3
    assert [film.seconds for film in known] == [1.5, 1.0, 0.0]


def test_after_a_film_with_a_limited_rate_the_halves_of_a_step_come_first(solved):
    before = [film_at(1.0, limited=True), film_at(0.0)]
    _, known, _, taken = next_film.reached(time_grid_until(0.5), Step(2.0, 0), before, [], False)
    assert solved == [1.5, 2.0] and taken == 2
    assert [film.seconds for film in known] == [1.5, 1.0, 0.0]


def test_where_they_are_lost_the_whole_step_is_made_once(solved, monkeypatch):
    def lost(*how):
        raise NoFilmError("lost")

    monkeypatch.setattr(next_film, "_in_halves", lost)
    before = [film_at(1.0, limited=True), film_at(0.0)]
    _, known, _, taken = next_film.reached(time_grid_until(0.5), Step(2.0, 0), before, [], False)
    assert solved == [2.0] and known is before and taken == 1


def test_halves_of_a_step_begin_on_the_grid_of_the_contact(solved):
    before = [film_at(1.0), film_at(0.0)]
    next_film.reached(time_grid_until(1.75), Step(2.0, 0), before, [], False)
    assert solved == [2.0, 1.75, 2.0]


def test_where_its_halves_are_lost_a_step_with_a_limited_rate_is_kept(solved, monkeypatch):
    before = [film_at(1.0), film_at(0.0)]
    whole = next_film.reached(time_grid_until(2.0), Step(2.0, 0), before, [], False)
    assert solved == [2.0] and whole[1] is before

    def lost(*how):
        raise NoFilmError("lost")

    monkeypatch.setattr(next_film, "_in_halves", lost)
    _, known, _, taken = next_film.reached(time_grid_until(0.5), Step(2.0, 0), before, [], False)
    assert known is before and taken == 1


def test_oil_that_flows_in_moves_the_rupture_line_in_the_step_after_a_limit():
    """Between rough surfaces a start keeps the line where it is for a step; a changed rate must not."""
    scene = rough(ball(), 0.3e-6)
    plan = pyworm.plan(scene, 0.2, ("isothermal", "roughness"))
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    iterate(level, plan.tolerance)
    dry = ~level.flowing() & level.covered
    into = dry & np.roll(level.flowing(), 1, axis=0)
    assert into.any()
    explicit = np.where(into, -1e3 * level.film.thickness(), 0.0)
    term = SimpleNamespace(limit=lambda content: True, explicit=explicit)
    next_film._limit(level, term)
    newton_step(level)
    assert level.flowing()[into].any()  # none, where the line stands still


@pytest.mark.parametrize("supply", [None, 2e-7])
def test_a_limited_rate_changes_the_balance_as_an_evaluation_of_the_whole_film_does(supply):
    scene = ball()
    scene = replace(scene, oil=replace(scene.oil, supply=supply))
    plan = pyworm.plan(scene, 0.2, "isothermal")
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    iterate(level, plan.tolerance)
    film = level.film
    first = -2e-3 * film.thickness() * (1 + np.sin(np.arange(film.thickness().shape[1])))
    film.set_transient_term(3.0, first)
    film.restart()
    limited = film.limit_rate(first / 2), film.fields()[2]
    film.set_transient_term(3.0, first / 2)
    whole = film.restart(), film.fields()[2]
    assert limited[0].residual == pytest.approx(whole[0].residual, rel=1e-9)
    assert limited[0].load_error == pytest.approx(whole[0].load_error, abs=1e-12)
    assert limited[1] == pytest.approx(whole[1], abs=1e-9 * np.abs(whole[1]).max())
    film.limit_rate(first)
    assert film.fields()[2] != pytest.approx(whole[1], rel=1e-3)
    with pytest.raises(KernelError):
        film.limit_rate(np.full_like(first, np.nan))


def course(heated, approach=None, passages=1.0):
    """What stands for a time grid, of whose transits each counts some passages of oil."""
    plan = SimpleNamespace(model=SimpleNamespace(heated=heated))
    return SimpleNamespace(
        approach=approach,
        plan=plan,
        step=lambda refinement: 0.1 / 2**refinement,
        passages_of_transit=lambda seconds: passages,
    )


def test_films_settle_by_the_passages_of_oil_in_a_time_step():
    """What a rate of change is off by is summed up along the flow: over more of the shorter steps."""
    for hot, approach in ((False, None), (False, "approach"), (True, "approach")):
        whole, third = (
            settling_of(course(hot, approach, passages), Step(0.0, 1)).tolerance
            for passages in (1.0, 1 / 3)
        )
        assert third == pytest.approx(whole / 9)


def test_heated_films_of_surfaces_that_come_together_settle_in_exact_steps():
    cold, heated = (
        [settling_of(course(hot, "approach"), Step(0.0, number)) for number in (0, 1, 2)]
        for hot in (False, True)
    )
    assert [one.tolerance / TOLERANCE for one in cold] == pytest.approx([1e-2, 1e-2 / 4, 1e-2 / 16])
    assert [one.tolerance for one in heated[1:]] == pytest.approx(
        [2 * one.tolerance for one in cold[1:]]
    )
    assert heated[0] == heated[1]
    assert heated[0].exact and heated[0].forcing == FORCING
    assert not cold[0].exact and cold[0].forcing is None
    assert not settling_of(course(True), Step(0.0, 1)).exact


def test_temperatures_are_judged_where_the_pressure_is_large_enough():
    scene = sliding_ball()
    plan = pyworm.plan(scene, 0.2, "all")
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    level.film.judge(0.0)
    newton_step(level)
    everywhere = level.film.balance.warming
    level.film.judge(2.0)
    newton_step(level)
    assert everywhere > 0
    assert level.film.balance.warming < everywhere
