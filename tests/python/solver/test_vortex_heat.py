"""Contacts whose oil circulates in a wide inlet, where no temperature is found."""

from types import SimpleNamespace

import numpy as np
import pytest
from contacts import ball, motions

import pyworm
from pyworm.solver import grid_sequence
from pyworm.solver.contact import ContactSolver
from pyworm.solver.ending import Ending
from pyworm.solver.grid_sequence import GridSequence
from pyworm.solver.vortex_heat import temperature_varies, warmest_circulates

HEAT = {"film-heating", "surface-heating", "viscosity-across"}


ACCURACY = 0.3


def level(warmest, warming, heated=True):
    """A film of pressure 0, 1 and 9 whose warmest oil is at a node."""
    rise = np.full((3, 5), 1.0)
    rise[warmest, 2] = -20.0
    balance = SimpleNamespace(warming=warming)
    film = SimpleNamespace(
        heated=heated, rise=lambda: rise, pressure=np.array([0.0, 1.0, 9.0]), balance=balance
    )
    return SimpleNamespace(film=film)


@pytest.mark.parametrize(("warmest", "outside"), [(0, True), (1, False), (2, False)])
def test_oil_circulates_where_it_is_warmest_without_pressure(warmest, outside):
    assert warmest_circulates(level(warmest, 1.0)) is outside
    assert temperature_varies(level(warmest, 1.0)) is outside
    assert not temperature_varies(level(warmest, 1e-3))
    assert not warmest_circulates(level(warmest, 1.0, heated=False))


def test_where_no_temperature_is_found_the_film_without_heat_is_the_result(monkeypatch):
    """Its heat is reported as neglected, with the reason."""
    monkeypatch.setattr(ContactSolver, "circulates", lambda self, level: level.film.heated)
    solution = pyworm.solve(ball(), accuracy=ACCURACY, effects=("auto", *HEAT))
    assert solution.converged
    assert not HEAT & {effect.name for effect in solution.effects if effect.on}
    assert {effect.reason for effect in solution.effects if effect.name in HEAT} == {
        Ending.CIRCULATING.message
    }
    assert solution.figures.temperature_max_film is None


def test_heat_that_was_asked_for_is_marked_as_not_found(monkeypatch):
    monkeypatch.setattr(ContactSolver, "circulates", lambda self, level: level.film.heated)
    solution = pyworm.solve(ball(), accuracy=ACCURACY, effects="all")
    assert solution.ending is Ending.CIRCULATING
    assert not solution.converged


@pytest.mark.parametrize(
    ("errors", "undetermined"), [(None, True), ({}, False), (0.1, False), (0.5, True)]
)
def test_levels_disagree_where_more_of_them_give_other_figures(monkeypatch, errors, undetermined):
    scene = ball(load=5.0, motions=motions(0.2, 4.0))
    plan = pyworm.plan(scene, ACCURACY, effects=("auto", *HEAT))
    assert plan.regime.deflection < 1
    sequence = GridSequence(scene, plan, None, lambda *told: None, None)
    monkeypatch.setattr(grid_sequence, "warmest_circulates", lambda level: True)
    figures = dict.fromkeys(plan.target.figures, 1e3)
    sequence._level = None
    sequence._iteration = SimpleNamespace(reading=SimpleNamespace(figures=figures))
    sequence._levels_errors = (
        dict.fromkeys(figures, errors) if isinstance(errors, float) else errors
    )
    assert sequence._levels_disagree() is undetermined
