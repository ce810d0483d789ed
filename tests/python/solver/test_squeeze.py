"""Squeezing of oil between rigid bodies that hardly roll, against closed forms in the window of the grid.

A strip between walls h(x) that approach each other with V has p' = (c - 12 eta V x) / h^3, c such that p is
zero at both ends (Cameron 1966, The Principles of Lubrication, chapter 3).
"""

from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
import pytest
import scipy
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.planning.effects.geometry import as_line
from pyworm.scene.life import Life, Past
from pyworm.scene.line import Parabola
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time

RADIUS, VISCOSITY, CRAWL = 0.02, 0.09, 3e-4
APART, APPROACH, DURATION = 8e-6, 2e-3, 3e-3
NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)
"""Of Gauss' quadrature."""


@dataclass(frozen=True)
class Plate:
    """A flat of some width before a flat wall."""

    radius: float
    width: float

    def __call__(self, x):
        return np.zeros(x.shape), np.abs(x) <= self.width / 2 * (1 + 1e-9)


def steel_ball():
    """A steel ball whose scales, and so its window, are those of a large load."""
    motions = ((CRAWL, 0.0),) * 2
    oil = mineral(VISCOSITY, 1e-12)
    return point("ball", (RADIUS, RADIUS), 5000.0, motions, (STEEL, STEEL), oil)


def cylinder():
    """A steel cylinder likewise."""
    return as_line(steel_ball())


def time_grid_through(contact_at, kinks=(), effects=None):
    life = Life(DURATION, contact_at, kinks=kinks)
    present = replace(contact_at(DURATION), past=Past(life, DURATION))
    return time_grid_of(
        life,
        pyworm.plan(
            present,
            0.05,
            effects
            or ("squeeze" if isinstance(present.gap, Parabola) else ("real-gap", "squeeze")),
            ("film",),
        ),
    )


def integrated(contact_at, kinks=(), refinement=0, effects=None):
    time_grid = time_grid_through(contact_at, kinks, effects)
    found = integrate_in_time(time_grid, refinement, 0.0, [0.95 * DURATION])
    assert found.failure is None
    return time_grid, found.records


def strip_load(height, ends, rate, gap=lambda x: 0.0):
    """Load for each length of a strip whose walls approach at a rate, by quadratures of the closed form."""
    x = (ends[0] + ends[1] + (ends[1] - ends[0]) * NODES) / 2

    def over(power):
        return (ends[1] - ends[0]) / 2 * float(WEIGHTS @ (x**power / (height + gap(x)) ** 3))

    middle = over(1) / over(0)
    return 12 * VISCOSITY * rate * (over(2) - middle * over(1))


def parabola(x):
    return x**2 / (2 * RADIUS)


@pytest.mark.long
def test_a_cylinder_that_is_lowered_presses_as_the_closed_form_says():
    time_grid, records = integrated(
        lambda at: replace(cylinder(), separation=APART - APPROACH * at)
    )
    ends = time_grid.grid(0.0, 0).x[[0, -1]]
    for one in records[::20]:
        height = APART - APPROACH * one.seconds
        assert one.figures["film_min"] == pytest.approx(height, rel=1e-6)
        assert one.load == pytest.approx(strip_load(height, ends, APPROACH, parabola), rel=0.002)
    # of which an endless window has 3 sqrt(2) pi eta V (R/h)^1.5
    endless = 3 * sqrt(2) * np.pi * VISCOSITY * APPROACH * (RADIUS / height) ** 1.5
    assert one.load == pytest.approx(endless, rel=0.05)


@pytest.mark.parametrize("kind", [pytest.param("cylinder", marks=pytest.mark.long), "plate"])
def test_a_body_that_is_let_go_sinks_as_the_closed_form_says(kind):
    """It is lowered so that it presses with its load when it is let go; then the load alone squeezes."""
    gap = {"cylinder": Parabola(RADIUS), "plate": Plate(RADIUS, 1e-3)}[kind]
    body, release = replace(cylinder(), gap=gap), DURATION / 5
    shape = {"cylinder": parabola, "plate": lambda x: 0.0}[kind]
    height = APART - APPROACH * release

    def contact_at(seconds, load=1.0):
        if seconds < release:
            return replace(body, separation=APART - APPROACH * seconds)
        return replace(body, load=load)

    def ends(time_grid, seconds):
        """Where pressure is zero: at the ends of the grid, or half a cell beyond the plate's last nodes."""
        x = time_grid.grid(seconds, 0).x
        if kind == "cylinder":
            return x[[0, -1]]
        covered = x[gap(x)[1]]
        half = (x[1] - x[0]) / 2
        return covered[0] - half, covered[-1] + half

    time_grid = time_grid_through(contact_at, (release,))
    load = strip_load(height, ends(time_grid, release), APPROACH, shape)
    time_grid, records = integrated(lambda at: contact_at(at, load), (release,))
    sinking = scipy.integrate.solve_ivp(
        lambda t, h: -load / strip_load(h[0], ends(time_grid, t), 1.0, shape),
        (release, DURATION),
        [height],
        rtol=1e-6,
        atol=1e-13,
        dense_output=True,
    ).sol
    after = [one for one in records if one.seconds > release]
    assert len(after) > 50
    for one in after[::10]:
        assert one.figures["film_central"] == pytest.approx(sinking(one.seconds)[0], rel=0.002)
    assert after[-1].figures["film_central"] < 0.7 * height


def test_a_ball_that_is_lowered_presses_as_the_closed_form_says():
    """6 pi eta V R^2 / h in an endless window; beyond a circle of radius L is h / (h + L^2 / 2R) of it."""
    ball = steel_ball()
    time_grid, records = integrated(
        lambda at: replace(ball, separation=APART - APPROACH * at),
        refinement=2,
        effects=("second-dimension", "squeeze"),
    )
    one = records[-1]
    height = APART - APPROACH * one.seconds
    endless = 6 * np.pi * VISCOSITY * APPROACH * RADIUS**2 / height
    half = time_grid.grid(0.0, 0).x[-1]
    beyond = [height / (height + r**2 / (2 * RADIUS)) for r in (half, sqrt(2) * half)]
    # pressure that is zero at the sides is lower within, too: by that at the sides, all over the window
    assert 1 - 2 * beyond[0] - 0.01 < one.load / endless < 1 - 2 * beyond[1] + 0.01
