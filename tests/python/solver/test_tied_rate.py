"""Rates of change that are tied to the oil of the transient solve itself."""

from dataclasses import replace

import numpy as np
import pytest
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.planning.grid import Grid
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.solver.error_estimate import change
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.transient.rated_films import rated_films
from pyworm.solver.transient.tied_rate import TIES, TiedRate, tied
from pyworm.solver.transient.time_integration import RateOfChange
from pyworm.solver.transient.time_level import content_of
from pyworm.solver.transient.time_records import TimeRecord
from pyworm.solver.transient.transient import Rates, transient

TRANSITS = 5.0


@pytest.fixture(scope="module")
def rolling():
    """A ball that has rolled on for long, its plan, and its film on the first grid of the figures."""
    contact = point(
        "ball", (0.02, 0.02), 50.0, ((1.0, 0.0),) * 2, (STEEL, STEEL), mineral(0.09, 2e-8)
    )
    age = TRANSITS * predicted(contact).transit
    scene = replace(contact, past=Past(Life(age, lambda seconds: contact), age))
    plan = pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    return scene, plan, level


def rate_of(scene, level, share, known=True):
    """A rate of change that is off by a share of the film in a transit, with the film's own oil."""
    of = predicted(scene)
    field = np.full(level.grid.shape, share * of.film_central / of.transit)
    return RateOfChange(level.grid, field, content=content_of(level) if known else None)


def test_a_film_with_a_tied_rate_is_off_by_what_is_summed_up_over_an_eighth_of_a_passage(rolling):
    scene, plan, level = rolling
    rates = [rate_of(scene, level, share) for share in (0.0, 0.1)]
    changes = [
        change(*rated_films(scene, plan, some, False, level).readings[1:])["film_central"]
        for some in (rates, tied(scene, rates))
    ]
    assert 0.03 < changes[0] < 0.15
    assert 0.5 / TIES < changes[1] / changes[0] < 2 / TIES


def test_beyond_the_grid_of_the_solve_the_oil_follows_the_gap(rolling):
    """Without a rate, the explicit part is that of the oil, which fills the gap where it is wide."""
    scene, _, level = rolling
    own = level.grid
    wider = Grid(
        1.5 * own.west, 1.5 * own.south, own.dx, own.dy, *(3 * (n // 2) + 1 for n in own.shape)
    )
    rate = TiedRate(scene, rate_of(scene, level, 0.0), content_of(level))
    tie, explicit = rate.on(wider)
    gap, _ = scene.gap(*wider.mesh())
    assert tie == pytest.approx(TIES / predicted(scene).transit)
    oil = -explicit / tie
    assert oil[0, 0] - gap[0, 0] == pytest.approx(
        content_of(level)[0, 0] - scene.gap(own.west, own.south)[0], rel=1e-6
    )
    assert -rate.on(own)[1] / tie == pytest.approx(content_of(level), rel=1e-9)
    assert rate.grid == own and not rate.limited
    assert rate.remembered(wider) is None and rate.stored(wider) is None


def test_ties_are_taken_where_they_leave_less_and_known_oil_allows(rolling):
    scene, plan, level = rolling
    figures = dict.fromkeys(("film_min", "film_central"), predicted(scene).film_central)
    records = (TimeRecord(scene.past.seconds, None, 50.0, (1.0, 0.0), figures),)

    def found(*shares, known=True):
        """The film by solves whose rates are off by some shares, and whose films are the same."""
        rates = tuple(rate_of(scene, level, share, known) for share in shares)
        return transient(scene, plan, Rates(rates, (records,) * len(rates)))

    near, far, unknown = found(0.04, 0.05), found(0.1, 0.6), found(0.1, 0.6, known=False)
    assert isinstance(near.rate, RateOfChange) and isinstance(unknown.rate, RateOfChange)
    assert isinstance(far.rate, TiedRate)
    assert far.errors["film_central"] < 0.3 * unknown.errors["film_central"]
    assert tied(scene, [rate_of(scene, level, 0.1), rate_of(scene, level, 0.1, known=False)]) == ()
