"""Films of tooth pairs whose flanks come together."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import pyworm
from pyworm.drives.tooth_life import ToothLife
from pyworm.solver.transient import next_film, time_integration
from pyworm.solver.transient import time_grid as course_module
from pyworm.solver.transient.backward_term import BackwardTerm
from pyworm.solver.transient.time_grid import time_grid_of


@pytest.fixture(scope="module")
def drive():
    return pyworm.load("cases/zi_drive.toml").drive


def course_through(drive, life, effects=("isothermal", "squeeze")):
    scene = replace(drive.scene(0.5), past=life.past(0.5))
    return time_grid_of(scene.past.life, pyworm.plan(scene, 0.05, effects, ("film",)))


def integrated(drive, life, last=0.14, effects=("isothermal", "squeeze"), **changes):
    """Instants of the first transient solve of a life, its course changed, up to a phase."""
    time_grid = replace(course_through(drive, life, effects), **changes)
    return time_integration.integrate_in_time(time_grid, 0, 0.0, [life.past(last).seconds]).records


@pytest.mark.parametrize(
    "effects", [("isothermal", "squeeze"), pytest.param("auto", marks=pytest.mark.long)]
)
def test_the_film_between_flanks_that_come_together_takes_the_load_over(drive, effects):
    records = integrated(drive, drive.life, effects=effects)
    touch = drive.life.touch
    carried = [one.load for one in records]
    given = [drive.normal_load(one.phase) for one in records]
    # at first less than the load from which on it is given, and never less than at the time before
    assert records[0].phase < 0 and carried[0] < touch
    assert all(after >= 0.999 * before for before, after in pairwise(carried))
    # then the larger of that and the pair's share
    taken = next(number for number, load in enumerate(carried) if load > 0.999 * touch)
    assert given[taken] < touch  # oil carries it before dry flanks would touch
    assert carried[taken:] == pytest.approx([max(touch, load) for load in given[taken:]], rel=2e-3)
    films = [one.figures["film_min"] for one in records if one.phase < 0.01]
    assert films[0] > 5 * films[-1] and all(np.diff(films) < 0)


def test_a_steady_film_at_the_beginning_of_the_cycle_is_forgotten_and_too_thin_until_then(drive):
    steady = ToothLife(drive.scene_at, drive.phases_per_second, drive.contact_axes)
    films = []
    for life in (drive.life, steady):
        records = integrated(drive, life, 0.3)
        phases = [one.phase for one in records]
        least = [one.figures["film_min"] for one in records]
        films.append(np.interp([0.02, 0.1, 0.28], phases, least))
    excess = films[0] / films[1] - 1
    assert excess[0] > 0.4 and 0.1 < excess[1] < 0.4 and abs(excess[2]) < 0.05


def test_where_the_film_of_flanks_that_come_together_is_not_found_it_begins_with_a_steady_one(
    drive, monkeypatch
):
    def diverged(time_grid, step):
        raise next_film.NoFilmError("no film between them")

    monkeypatch.setattr(time_integration, "_at_rest", diverged)
    records = integrated(drive, drive.life, 0.04)
    assert 0 <= records[0].phase < 0.02
    assert records[0].load == pytest.approx(drive.normal_load(records[0].phase), rel=2e-3)


def test_oil_is_pressed_out_of_all_of_the_gap_between_flanks_that_come_together(drive):
    approach = course_through(drive, drive.life).approach
    larger = tuple((3 * before // 2, 3 * behind // 2) for before, behind in approach.sides)
    films = []
    steady = replace(approach, until=-np.inf)
    for window in (approach, replace(approach, sides=larger), steady):
        records = integrated(drive, drive.life, 0.04, approach=window)
        films.append([one.figures["film_min"] for one in records if 0.01 < one.phase < 0.03])
    as_they_are, in_a_larger_window, in_that_of_a_steady_film = np.array(films)
    assert as_they_are == pytest.approx(in_a_larger_window, rel=0.02)
    assert np.all(in_that_of_a_steady_film < 0.9 * as_they_are)


@pytest.mark.long
def test_films_that_form_on_an_edge_hardly_depend_on_the_time_step(monkeypatch):
    """A difference of higher order presses out of a film the gap that was there a time step before.

    The order by itself, rates not limited; where they are, the first solve's central film is 5 % too thick.
    """
    drive = pyworm.load("tests/data/worm_unit_a100.toml").drive
    first_order, films, central = next_film._differenced, [], []

    def higher_order(time_grid, seconds, before):
        return before

    limited, unlimited = BackwardTerm.limit, lambda term, content: False
    for steps, order, limit in (
        (9, first_order, unlimited),
        (9, higher_order, unlimited),
        (36, first_order, unlimited),
        (9, first_order, limited),
    ):
        monkeypatch.setitem(course_module.STEPS_A_TRANSIT, "point", steps)
        monkeypatch.setattr(next_film, "_differenced", order)
        monkeypatch.setattr(BackwardTerm, "limit", limit)
        records = integrated(drive, drive.life, 0.1)
        phases = [one.phase for one in records]
        least = [one.figures["film_min"] for one in records]
        films.append(np.interp([0.02, 0.06, 0.1], phases, least))
        central.append(np.interp(0.1, phases, [one.figures["film_central"] for one in records]))
    by_first_order, by_higher_order, by_short_steps, by_limited_rates = films
    # gaps between mean planes, which asperities let fall below zero; least ones lie on a sharp edge
    assert by_first_order == pytest.approx(by_short_steps, abs=0.3e-6)
    assert np.all(by_higher_order < by_short_steps - 0.5e-6)
    assert central[0] == pytest.approx(central[2], rel=0.02)
    assert central[1] < 0.8 * central[2]
    assert by_limited_rates == pytest.approx(by_short_steps, abs=0.2e-6)
    assert central[3] == pytest.approx(central[2], rel=0.06)


@pytest.mark.parametrize("refinement", [0, 2])
def test_the_grid_of_the_contact_is_part_of_the_one_before(drive, refinement):
    time_grid = course_through(drive, drive.life)
    before = time_grid.grid(np.nextafter(time_grid.approach.until, 0.0), refinement)
    after = time_grid.grid(time_grid.approach.until, refinement)
    part = before.part(before.window_of(after)).finer()
    assert (part.nx, part.ny) == (after.nx, after.ny)
    assert part.nodes < 4 * before.nodes
    assert (*part.box, *part.spacing) == pytest.approx((*after.box, *after.spacing))
