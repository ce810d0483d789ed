"""Films from the oil there is: gaps that are filled in part, and what starved contacts make of their supply."""

from dataclasses import replace
from math import cos, pi

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import pyworm
from pyworm.kernel import LineFilm
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density

VISCOSITY, SPEED, LENGTH, THROAT = 0.05, 2.0, 20e-3, 20e-6
BEARING_OIL = Oil(Barus(VISCOSITY, 1e-15), Density(870.0, 0.0, 1e-9))
STIFF = 1e22


def rigid_film(gap, spacing, speed):
    """A film between rigid bodies, held at its gap."""
    film = LineFilm(
        gap,
        np.ones_like(gap, dtype=bool),
        (np.full_like(gap, speed),),
        spacing,
        STIFF,
        1.0,
        BEARING_OIL,
        1e-3 * gap.min(),
    )
    film.hold()
    return film


def settled(film, pressure, tolerance=1e-10, most=200):
    film.start(pressure, 0.0)
    for _ in range(most):
        if film.balance.worst <= tolerance:
            return film
        film.step(1e-6)
    raise AssertionError(f"not settled: {film.balance}")


def two_throats(x):
    """A gap with two throats: oil ruptures behind the first and fills the second again."""
    deep = np.where(x < LENGTH / 2, 0.9, 0.87)
    return THROAT * (2.5 - deep + deep * np.cos(4 * pi * x / LENGTH))


def exact_bearing():
    """Flow, rupture, reformation and second rupture of the bearing of two throats.

    The flow q is one along the bearing: u h - h^3 p' / 12 eta = q where the gap is full, and where it has
    ruptured all that is carried. It ruptures where pressure and its slope vanish, h = q / u.
    """

    def slope(x, flow):
        h = two_throats(x)
        return 12 * VISCOSITY * (SPEED * h - flow) / h**3

    def rise(begin, end, flow):
        return quad(slope, begin, end, args=(flow,), limit=200, epsabs=1e-3)[0]

    def ruptures(flow, first):
        throat = first * LENGTH / 2 + LENGTH / 4
        return brentq(lambda x: SPEED * two_throats(x) - flow, throat, throat + LENGTH / 4)

    # the flow for which pressure is ambient at the rupture behind the first throat
    narrow, wide = (SPEED * two_throats(at) for at in (LENGTH / 4, LENGTH / 2))
    flow = brentq(
        lambda q: rise(0.0, ruptures(q, 0), q), narrow * 1.0001, narrow + 0.9 * (wide - narrow)
    )
    end = ruptures(flow, 1)
    narrows = brentq(lambda x: SPEED * two_throats(x) - flow, LENGTH / 2, 3 * LENGTH / 4)
    begin = brentq(lambda x: rise(x, end, flow), LENGTH / 2, narrows - 1e-9)
    return flow, ruptures(flow, 0), begin, end, rise


def test_bearing_with_rupture_and_reformation():
    """Two throats one after the other against the integral of Reynolds' equation in both full parts."""
    flow, ruptured, filled, end, rise = exact_bearing()
    x = np.linspace(0.0, LENGTH, 2049)
    film = rigid_film(two_throats(x), x[1] - x[0], SPEED)
    film.feed(np.full_like(x, 1.0))
    settled(film, np.where((x > 0) & (x < LENGTH), 1e3, 0.0))
    spacing = x[1] - x[0]
    between = (x > ruptured + 3 * spacing) & (x < filled - 3 * spacing)
    # what leaves a node is its fraction of the full film at the face behind it
    carried = film.fraction() * two_throats(x + spacing / 2)
    assert carried[between] == pytest.approx(flow / SPEED, rel=5e-4)
    full = np.flatnonzero((x > ruptured) & (film.pressure > 0))
    assert x[full[0]] == pytest.approx(filled, abs=3 * spacing)
    assert x[full[-1]] == pytest.approx(end, abs=3 * spacing)
    for begin, places in ((0.0, (3e-3, 4e-3)), (filled, (13e-3, 14e-3))):
        for place in places:
            assert np.interp(place, x, film.pressure) == pytest.approx(
                rise(begin, place, flow), rel=5e-3
            )


def test_oscillating_plates_keep_their_oil():
    """Two plates that part and close under ambient pressure at their ends: oil stored is oil that came in.

    While they part, oil ruptures from the middle; where it stays full, pressure and its slope vanish at the
    rupture, which so lies sqrt(p0 h^3 / 6 eta h') from the ends.
    """
    nodes, steps, period, ambient = 401, 400, 0.1, 2e4
    x = np.linspace(-5e-3, 5e-3, nodes)
    spacing, step = x[1] - x[0], period / steps
    gap = 30e-6
    film = rigid_film(np.full(nodes, gap), spacing, 0.0)
    film.feed(np.zeros(nodes))
    ends = np.zeros(nodes)
    ends[[0, -1]] = ambient
    pressure = np.full(nodes, ambient)
    stored, widest, last = np.full(nodes, gap), 0.0, np.inf
    for number in range(1, steps + 1):
        phase = 2 * pi * number / steps
        before, h = (gap * (1.4 - 0.4 * cos(of)) for of in (phase - 2 * pi / steps, phase))
        rate = (h - before) / step
        film.set_transient_term(1 / step, -stored / step)
        film.start(np.where(ends > 0, ends, pressure), h - gap)
        left = np.inf
        for _ in range(100):
            left = np.abs(film.fields()[2][film.pressure > 0]).max(initial=0.0)
            if left <= 1e-11 * gap / step:
                break
            film.step(1e-8)
        assert left <= 1e-11 * gap / step
        pressure = film.pressure
        now = film.fraction() * film.thickness()
        slope = (pressure[1] - pressure[0] + pressure[-2] - pressure[-1]) / spacing
        inflow = -slope * h**3 / (12 * VISCOSITY)
        gained = (now - stored)[1:-1].sum() * spacing / step
        assert gained == pytest.approx(inflow, abs=1e-9 * gap * x[-1] / step)
        stored = now
        full = ((pressure > 0)[: nodes // 2].sum() - 0.5) * spacing
        expected = (ambient * h**3 / (6 * VISCOSITY * rate)) ** 0.5 if rate > 0 else np.inf
        # as long as that distance falls, oil ruptures
        if expected < min(last, 4e-3):
            assert full == pytest.approx(expected, abs=2 * spacing)
            widest = max(widest, 5e-3 - full)
        last = expected
    assert widest > 2e-3
