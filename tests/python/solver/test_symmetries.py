"""Turned or mirrored axes, exchanged bodies and other units change no contact, all effects at once.

Transient films are solved to rounding. With the usual tolerance a residual that meets it but for rounding,
1e-4 of it since temperatures of surfaces are in single precision, takes one Newton step more in one view
than in another, and figures differ by 6e-5; with `OF_TOLERANCES` by 2e-8. Units are powers of two: others
round otherwise.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from symmetric_contacts import VIEWS, View, ellipse, line, seen

import pyworm
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.scene.life import Life, Past
from pyworm.solver.transient import settling
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time

pytestmark = pytest.mark.filterwarnings("ignore::pyworm.UnusualWarning")

FIGURES = (
    "film_min",
    "film_central",
    "pressure_max",
    "friction_coefficient",
    "power_loss",
    "temperature_max_body_1",
    "temperature_max_body_2",
    "temperature_max_film",
)

SAME = 5e-7
"""Largest relative difference: what rounding grows to on the way of Newton's iteration."""

OF_TOLERANCES = {"TOLERANCE": 1e-5, "TEMPERATURE_CHANGE": 1e-4}
"""Parts of the tolerances of `settling` to which the coarsest transient films are solved."""

ACCURACY = 0.2

LINE_VIEWS = [name for name, view in VIEWS.items() if view.axes[1] == (0, 1)]


LAYERS = {line: 5e-7, ellipse: 3e-7}
"""Layer of oil by which each contact is starved [m]."""


@cache
def figures(contact, name, starved=False, moves=False):
    """Figures of a contact as it is itself, from a view by its name."""
    view = VIEWS.get(name, View())
    scene = contact(view, moves, LAYERS[contact] if starved else None)
    solution = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "all"))
    assert solution.converged, solution.stop_reason
    found = {figure: getattr(solution.figures, figure).on_grid for figure in FIGURES}
    return seen(found, view, each_length=contact is line)


@pytest.fixture
def solved_to_rounding(monkeypatch):
    """Newton's iteration of transient films goes on until what it leaves is rounding."""
    for name, part in OF_TOLERANCES.items():
        monkeypatch.setattr(settling, name, part * getattr(settling, name))


@cache
def coarse_figures(contact, name):
    """Figures at the end of the coarsest transient solve of a contact, as it is itself."""
    view = VIEWS.get(name, View())
    scene = contact(view, moves=True)
    time_grid = time_grid_of(scene.past.life, pyworm.plan(scene, ACCURACY, "all"))
    found = integrate_in_time(time_grid, 0, 0.0, [scene.past.seconds])
    assert found.failure is None
    return seen(found.records[-1].figures, view, each_length=contact is line)


@pytest.mark.parametrize("starved", [False, True])
@pytest.mark.parametrize("name", LINE_VIEWS)
def test_a_line_contact(name, starved):
    own = figures(line, "own", starved)
    assert figures(line, name, starved) == pytest.approx(own, rel=SAME)


@pytest.mark.parametrize("name", VIEWS)
def test_an_ellipse(name):
    assert figures(ellipse, name) == pytest.approx(figures(ellipse, "own"), rel=SAME)


@pytest.mark.long
@pytest.mark.parametrize("name", VIEWS)
def test_a_starved_ellipse(name):
    own = figures(ellipse, "own", starved=True)
    assert figures(ellipse, name, starved=True) == pytest.approx(own, rel=SAME)


@pytest.mark.usefixtures("solved_to_rounding")
@pytest.mark.parametrize("name", LINE_VIEWS)
def test_a_line_contact_whose_entrainment_reverses(name, monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    own = coarse_figures(line, "own")
    assert coarse_figures(line, name) == pytest.approx(own, rel=SAME)


@pytest.mark.long
@pytest.mark.usefixtures("solved_to_rounding")
@pytest.mark.parametrize("name", VIEWS)
def test_an_ellipse_whose_entrainment_reverses(name):
    own = coarse_figures(ellipse, "own")
    assert coarse_figures(ellipse, name) == pytest.approx(own, rel=SAME)


@pytest.mark.long
@pytest.mark.parametrize("name", LINE_VIEWS)
def test_figures_of_a_line_contact_whose_entrainment_reverses(name):
    own = figures(line, "own", moves=True)
    assert figures(line, name, moves=True) == pytest.approx(own, rel=SAME)


def reversing(forward: bool) -> pyworm.LineScene:
    """A line contact that rolls at 1.6 m/s, and 0.35 ms after it came to rest at that speed the other way.

    Its oil hardly warms, and is no less viscous where it does.
    """
    steady = line(View(), moves=False)
    bodies = tuple(replace(of, bulk_temperature=333.15, roughness=None) for of in steady.bodies)
    sign = 1 if forward else -1

    def at(seconds):
        speed = sign * float(np.interp(seconds, [5e-4, 1.2e-3], [-1.6, 1.6]))
        return replace(steady, load=1.2e5, bodies=bodies, velocities=(speed, speed))

    return replace(at(1.2e-3), past=Past(Life(1.2e-3, at, kinks=(5e-4,)), 1.2e-3))


@pytest.mark.parametrize("forward", [True, False])
def test_a_reversal_has_the_inlets_of_both_directions_in_its_window(forward):
    """At most times one side is an exit, which reaches a quarter as far."""
    scene = reversing(forward)
    time_grid = time_grid_of(scene.past.life, pyworm.plan(scene, 0.04, ("isothermal", "squeeze")))
    wider = replace(
        time_grid, sides=tuple((2 * max(side), 2 * max(side)) for side in time_grid.sides)
    )
    own, wide = (
        integrate_in_time(of, 0, 0.0, [1.2e-3]).records[-1].figures for of in (time_grid, wider)
    )
    assert own["film_min"] == pytest.approx(wide["film_min"], rel=2e-3)
    assert own["film_central"] == pytest.approx(wide["film_central"], rel=2e-3)
