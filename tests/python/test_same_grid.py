"""Examples of the Fortran library on their grids: to rounding the films of the kernel called from Python.

Both are solved to 1e-10 from initial guesses of their own, which leaves some 1e-9 of a film.
"""

import re
from math import pi, sin, sqrt

import numpy as np
import pytest
from linked_programs import EXAMPLES

import pyworm
from pyworm import kernel
from pyworm.kernel.core import KernelError
from pyworm.materials.rough_surfaces import RoughPair, RoughSurface
from pyworm.materials.tabulated import TabulatedViscosity
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.transient.differences import backward_weights
from pyworm.solver.transient.heat_memory import (
    HeatedTimeLevel,
    residual_rise,
    velocities_at_origin,
)

TOLERANCE = 1e-10
WARM = 1e-8
"""Tolerance of films that warm, whose walls are balanced in single precision."""

CLOSE = 1e-7
"""What the tolerance leaves of figures, with a margin of some tens for those of single nodes."""

RADIUS, MODULUS = 0.01, 230e9
DENSITY = pyworm.Density.dowson_higginson(850.0)


def numbers(text):
    return [float(number) for number in re.findall(r"\d\.\d+E[-+]\d+", text)]


def solved(film, tolerance=TOLERANCE):
    """A film after Newton's iteration to the tolerance, or until rounding alone is left."""
    for _ in range(60):
        if film.balance.within(tolerance, 10 * tolerance):
            break
        try:
            film.step(1e-3)
        except KernelError:
            break
    assert film.balance.within(max(tolerance, 1e-8), 10 * tolerance)
    return film


class Roller:
    """The line contact of the examples on a grid: 5 half-widths of inlet, 1.5 of outlet."""

    load = 1e5

    def __init__(self, nodes):
        half_width = sqrt(8 * self.load * RADIUS / (pi * MODULUS))
        self.dx = 6.5 * half_width / (nodes - 1)
        self.x = -5 * half_width + self.dx * np.arange(nodes)
        self.dry = np.sqrt(np.maximum(1 - (self.x / half_width) ** 2, 0))
        for _ in range(2):
            self.dry[1:-1] = (self.dry[:-2] + 2 * self.dry[1:-1] + self.dry[2:]) / 4
        self.dry *= self.load / (self.dry.sum() * self.dx)

    def unstarted(self, oil, factor=1.0):
        """The Newtonian film under a factor of the load."""
        return kernel.LineFilm(
            self.x**2 / (2 * RADIUS),
            np.ones(self.x.size, bool),
            np.ones(self.x.size),
            self.dx,
            MODULUS,
            factor * self.load,
            oil,
            1e-10,
        )

    def film(self, oil, supply=None):
        """The Newtonian film, from the dry contact lifted by the expected film."""
        film = self.unstarted(oil)
        if supply is not None:
            film.feed(np.full(self.x.size, supply))
        film.start(self.dry, 0.0)
        deflected = film.thickness()[self.dry.argmax()]
        pressure = self.dry + 1e-6 * self.dry.max()
        pressure[[0, -1]] = 0
        film.start(pressure, 3.2e-7 - deflected)
        return film


def test_a_roller_in_an_oil_of_ones_own(linked):
    printed = linked(EXAMPLES / "line_film.f90", parts=[EXAMPLES / "own_viscosity.f90"])
    found = numbers(printed)

    def viscosity(pressure, temperature):
        warmth = 3500 * (1 / temperature - 1 / 333.15)
        return 0.04 * np.exp(20e-9 * pressure / (1 + pressure / 4e9) + warmth)

    oil = pyworm.Oil(TabulatedViscosity.of(viscosity, 333.15), DENSITY)
    film = solved(Roller(33).film(oil))
    for nodes in (65, 129, 257, 513, 1025):
        finer = Roller(nodes).film(oil)
        finer.start(np.maximum(kernel.prolong(film.pressure), 0), film.rigid_film)
        film = solved(finer)
    thickness = film.thickness()
    least = 32 * np.abs(Roller(33).x).argmin()  # a node of all grids
    expected = [thickness.min(), thickness[least], film.pressure.max()]
    assert found == pytest.approx(expected, rel=CLOSE)


def test_a_rough_roller_with_little_oil(linked):
    found = numbers(linked(EXAMPLES / "rough_line.f90"))
    roller = Roller(513)
    oil = pyworm.Oil(pyworm.Roelands(0.04, 0.6), DENSITY)
    film = solved(roller.film(oil, supply=0.6e-6))
    smooth, rigid_film = film.pressure, film.rigid_film
    surface = RoughSurface(0.15e-6, 0.03, hardness=7e9)
    curves = RoughPair((surface, surface), MODULUS / 2).curves()
    lift = curves.gap_under(smooth.max()) - film.thickness()[smooth.argmax()]
    film.shear(pyworm.FlowLaw("newtonian"), 7, [np.full(roller.x.size, 0.2)])
    film.roughen(curves, 0.1)
    film.start(smooth, rigid_film + max(lift, 0), smooth)
    solved(film)
    borne = film.asperities().pressure.sum() * roller.dx / roller.load
    assert found == pytest.approx([film.thickness().min(), film.pressure.max(), borne], rel=CLOSE)


def test_a_roller_in_liquids_with_flow_laws_of_ones_own(linked):
    found = np.reshape(numbers(linked(EXAMPLES / "thinning_line.f90")), (2, 3))
    branches = (pyworm.Branch(0.7, 1.0, 0.45, 2.0), pyworm.Branch(0.3, 20.0, 0.6, 1.5))
    pairs = tuple((float(y), float(np.arcsinh(y))) for y in 10 ** (0.2 * np.arange(-15, 41)))
    laws = (
        pyworm.FlowLaw("carreau-yasuda", stress=4e6, branches=branches),
        pyworm.FlowLaw("tabulated", stress=5e6, limit_pressure=0.06, table=pairs),
    )
    roller = Roller(257)
    film = solved(roller.film(pyworm.Oil(pyworm.Roelands(0.04, 0.6), DENSITY)))
    pressure, rigid_film = film.pressure, film.rigid_film
    for printed, law in zip(found, laws, strict=True):
        film.shear(law, 7, [np.full(roller.x.size, 0.1)])
        film.start(pressure, rigid_film)
        solved(film)
        friction = abs(film.shear_fields().stress[0].sum()) * roller.dx / roller.load
        expected = [film.thickness().min(), film.pressure.max(), friction]
        assert printed == pytest.approx(expected, rel=CLOSE)


def test_a_roller_whose_surfaces_remember_heat(linked):
    steps, speeds = 8, (1.2, 0.8)
    found = np.reshape(numbers(linked(EXAMPLES / "warming_line.f90")), (steps, 3))
    flow = pyworm.FlowLaw("eyring", stress=5e6)
    heat = pyworm.OilHeat(333.15, 1.1, 0.14, 2000.0, expansivity=7e-4)
    oil = pyworm.Oil(pyworm.Roelands(0.04, 0.6), DENSITY, flow, heat)
    steel = pyworm.Body(MODULUS * 0.91, 0.3, 7850.0, 47.0, 3.7e6 / 7850.0, 333.15)
    scene = pyworm.LineScene(
        gap=pyworm.Parabola(RADIUS),
        load=Roller.load,
        velocities=speeds,
        bodies=(steel, steel),
        oil=oil,
    )
    roller, grid = Roller(131), LineGrid(Roller(131).dx, -100, 131)

    def warmed(film, rise=None):
        film.shear(flow, 7, [np.full(131, speeds[0] - speeds[1])])
        film.heat(oil, (steel, steel), speeds, rise)

    film = solved(roller.film(oil))
    pressure, rigid_film = film.pressure, film.rigid_film
    warmed(film)
    film.start(pressure, rigid_film)
    solved(film, WARM)
    times, contents, history = [0.0], [film.fields()[0] * film.fields()[1]], []
    for step in range(1, steps + 1):
        flux, origin = film.heat_fields().flux, velocities_at_origin(scene)
        history.insert(0, HeatedTimeLevel(times[0], grid, flux, origin))
        times = [step * 38 * roller.dx / steps, *times[:3]]
        implicit, *earlier = backward_weights(times)
        rate = sum(weight * content for weight, content in zip(earlier, contents, strict=True))
        last, film = film, roller.unstarted(oil, 1 + 0.5 * sin(pi * step / steps))
        film.set_transient_term(implicit, rate)
        warmed(film, last.rise())
        film.remember(residual_rise(history, scene, grid, grid, times[0], 0.0))
        film.start(last.pressure, last.rigid_film)
        thickness, density, _ = solved(film, WARM).fields()
        contents = [thickness * density, *contents[:2]]
        walls = film.rise()[:, [0, -1]].max(axis=0)
        assert found[step - 1] == pytest.approx([thickness.min(), *walls], rel=CLOSE)


class Ball:
    """The point contact of the examples on 65 nodes a side: 4.2 radii of inlet, 1.8 of outlet."""

    nodes = 65

    def __init__(self, load, oil):
        self.load, self.oil = load, oil
        a = (3 * load * RADIUS / (2 * MODULUS)) ** (1 / 3)
        self.dx, self.dy = 6 * a / (self.nodes - 1), 5 * a / (self.nodes - 1)
        x, y = (
            -first * a + step * np.arange(self.nodes)
            for first, step in ((4.2, self.dx), (2.5, self.dy))
        )
        self.gap = (x[:, None] ** 2 + y[None, :] ** 2) / (2 * RADIUS)
        self.ones = np.ones(self.gap.shape)

    def film(self, factor=1.0):
        """The Newtonian film under a factor of the load, not started."""
        motion = (self.ones, 0 * self.ones)
        covered = np.ones(self.gap.shape, bool)
        sizes = (self.dx, self.dy, MODULUS, factor * self.load)
        return kernel.PointFilm(self.gap, covered, motion, *sizes, self.oil, 1e-10)

    def steady(self, expected):
        """The film of rolling, from the dry contact lifted by an expected film."""
        covered = np.ones(self.gap.shape, bool)
        dry = kernel.dry_contact(
            self.gap, covered, self.dx, self.dy, MODULUS, self.load, self.ones, 1e-3
        )
        pressure = np.zeros(self.gap.shape)
        pressure[1:-1, 1:-1] = dry.pressure[1:-1, 1:-1] + 1e-6 * dry.pressure.max()
        film = self.film()
        film.start(pressure, expected - dry.approach)
        return solved(film)


def test_a_ball_that_slides_in_an_oil_that_warms(linked):
    found = numbers(linked(EXAMPLES / "thermal_point.f90"))
    flow = pyworm.FlowLaw("eyring", stress=5e6)
    heat = pyworm.OilHeat(333.15, 1.1, 0.14, 2000.0, expansivity=7e-4)
    oil = pyworm.Oil(pyworm.Roelands(0.04, 0.6), DENSITY, flow, heat)
    steel = pyworm.Body(MODULUS * 0.91, 0.3, 7850.0, 47.0, 3.7e6 / 7850.0, 333.15)
    ball = Ball(20.0, oil)
    film = ball.steady(2e-7)
    pressure, rigid_film = film.pressure, film.rigid_film
    film.shear(flow, 7, [0.2 * ball.ones, 0 * ball.ones])
    semi_axis = sqrt(1.5 * ball.load / (pi * pressure.max()))
    motions = [(speed * ball.ones, 0 * ball.ones) for speed in (1.1, 0.9)]
    film.heat(oil, (steel, steel), motions, (semi_axis, semi_axis))
    film.start(pressure, rigid_film)
    solved(film, WARM)
    borne = film.pressure > 0.01 * film.pressure.max()
    friction = abs(film.shear_fields().stress[0][borne].sum()) * ball.dx * ball.dy / ball.load
    expected = [film.thickness().min(), film.pressure.max(), friction, film.rise()[..., 3].max()]
    assert found == pytest.approx(expected, rel=CLOSE)


def test_a_ball_under_a_pulse_of_load(linked):
    steps, load = 8, 6.3
    found = np.reshape(numbers(linked(EXAMPLES / "load_pulse.f90")), (steps, 2))
    a = (3 * load * RADIUS / (2 * MODULUS)) ** (1 / 3)
    oil = pyworm.Oil(pyworm.Barus(0.04, 16e-9), pyworm.Density(850.0, 0.0, 0.0))
    ball = Ball(load, oil)
    film = ball.steady(2.6e-7)
    # a node of every second grid line, too
    gap = ball.gap
    central = tuple(2 * (np.array(np.unravel_index(gap.argmin(), gap.shape)) // 2))
    times, contents = [0.0], [film.fields()[0] * film.fields()[1]]
    for step in range(1, steps + 1):
        times = [step * 2 * a / steps, *times[:3]]
        implicit, *earlier = backward_weights(times)
        rate = sum(weight * content for weight, content in zip(earlier, contents, strict=True))
        last, film = film, ball.film(1 + 0.5 * sin(pi * step / steps))
        film.set_transient_term(implicit, rate)
        film.start(last.pressure, last.rigid_film)
        thickness, density, _ = solved(film).fields()
        contents = [thickness * density, *contents[:2]]
        assert found[step - 1] == pytest.approx([thickness.min(), thickness[central]], rel=CLOSE)
