"""Line contacts against exact rigid films, an independent solver and their own symmetries."""

import csv
from dataclasses import replace
from math import hypot, log1p, pi

import numpy as np
import pytest
from folders import DATA

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.kernel.line_film import LineFilm
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.scales import line_scales

ETA0, ALPHA, MODULUS, RADIUS = 0.04, 22e-9, 226e9, 0.01


def bodies(modulus):
    """Two bodies of a given reduced modulus [Pa]."""
    return (Body(modulus * (1 - 0.3**2), 0.3),) * 2


OILS = {
    "incompressible": Oil(Barus(ETA0, ALPHA), Density.incompressible(870.0)),
    "compressible": Oil(Roelands.from_alpha(ETA0, ALPHA), Density.dowson_higginson_pole(870.0)),
}


def line(m, lubricant, oil="compressible"):
    """A line contact of given Moes parameters; L = 0 is an isoviscous oil."""
    speed_group = ((lubricant or 5.0) / (ALPHA * MODULUS)) ** 4 / 2
    speed = speed_group * MODULUS * RADIUS / ETA0
    chosen = OILS[oil]
    return LineScene(
        name=f"M = {m:g}, L = {lubricant:g}",
        gap=Parabola(RADIUS),
        radius=RADIUS,
        velocities=(1.5 * speed, 0.5 * speed),
        load=m * (2 * speed_group) ** 0.5 * MODULUS * RADIUS,
        bodies=bodies(MODULUS),
        oil=chosen if lubricant else replace(chosen, viscosity=Barus(ETA0, 0.0)),
    )


def solved(scene, accuracy=0.01):
    return pyworm.solve(scene, pyworm.plan(scene, accuracy))


def on_grids(scene, count):
    """Solutions on grids of halving spacing, the first of them on the plan's own, whatever their errors."""
    plan = replace(pyworm.plan(scene, accuracy=1e-3), wider_grids=(), accuracy=1e-5)
    grid = plan.grids[0]
    for _ in range(count):
        yield pyworm.solve(scene, replace(plan, largest_grid=grid.nodes))
        grid = grid.finer()


def rows():
    with open(DATA / "line_films.csv") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@pytest.mark.parametrize("oil", OILS)
@pytest.mark.parametrize("row", rows(), ids=lambda row: f"M{row['M']}-L{row['L']}")
def test_films_of_an_independent_solver(row, oil):
    scene = line(float(row["M"]), float(row["L"]), oil)
    solution = solved(scene, accuracy=0.0005)
    unit, figures = line_scales(scene).groups.moes_film, solution.figures
    assert solution.converged
    central, minimum = float(row[f"{oil}_central"]), float(row[f"{oil}_minimum"])
    assert figures.film_central.value / unit == pytest.approx(central, rel=0.003)
    assert figures.film_min.value / unit == pytest.approx(minimum, rel=0.01)


def test_film_at_two_gigapascal():
    """The case of Venner and Lubrecht (1994), M = 100, L = 11.04, computed by the same independent solver."""
    scene = replace(
        line(100, 11.04),
        gap=Parabola(0.0141),
        radius=0.0141,
        velocities=(0.485, 1.455),
        load=1.5708e6,
    )
    size, figures = line_scales(scene), solved(scene, accuracy=0.001).figures
    unit = size.groups.moes_film
    assert size.hertz.pressure_max == pytest.approx(2e9, rel=0.001)
    assert figures.film_central.value / unit == pytest.approx(3.639, rel=0.003)
    assert figures.film_min.value / unit == pytest.approx(3.276, rel=0.01)


@pytest.mark.parametrize(("m", "lubricant"), [(5, 5), (20, 10), (100, 10), (200, 10), (500, 25)])
def test_central_film_converges_by_second_order(m, lubricant):
    solutions = on_grids(line(m, lubricant), 7)
    values = [solution.figures.film_central.on_grid for solution in solutions]
    assert np.log2((values[-2] - values[-3]) / (values[-1] - values[-2])) == pytest.approx(
        2.0, abs=0.1
    )


RUPTURE = 0.4751299
"""Where a rigid film ruptures, over sqrt(2 R h0); the pressure is largest at its mirror image."""

RIGID_FILM, SPEED = 1e-6, 1.0
LENGTH = (2 * RADIUS * RIGID_FILM) ** 0.5


def reduced_pressure(angle):
    """Isoviscous pressure of a rigid film h0 / cos(angle)^2, x = sqrt(2 R h0) tan(angle) (Martin 1916)."""
    sines = np.sin(2 * angle) / 4
    flow = 1 + RUPTURE**2
    shape = angle / 2 + sines + pi / 4
    shape -= flow * (3 * angle / 8 + sines + np.sin(4 * angle) / 32 + 3 * pi / 16)
    return 12 * ETA0 * SPEED * LENGTH / RIGID_FILM**2 * shape


def rigid(stiffening):
    """A rigid cylinder whose exact smallest film is RIGID_FILM; alpha times the largest reduced pressure."""
    exit_angle = np.arctan(RUPTURE)
    alpha = stiffening / reduced_pressure(-exit_angle)
    nodes, weights = np.polynomial.legendre.leggauss(400)
    half_span = (exit_angle + pi / 2) / 2
    angle = -pi / 2 + (nodes + 1) * half_span
    pressure = reduced_pressure(angle)
    if alpha > 0:
        pressure = -np.log1p(-alpha * pressure) / alpha
    return LineScene(
        name="rigid",
        gap=Parabola(RADIUS),
        radius=RADIUS,
        velocities=(SPEED, SPEED),
        load=float((pressure / np.cos(angle) ** 2) @ weights) * half_span * LENGTH,
        bodies=bodies(MODULUS),
        oil=Oil(Barus(ETA0, alpha), Density.incompressible(870.0)),
        rigid=True,
    )


@pytest.mark.parametrize("stiffening", [0.0, 0.5, 0.95, 0.99])
def test_rigid_films_are_exact_to_second_order(stiffening):
    films = [solution.figures.film_min for solution in on_grids(rigid(stiffening), 5)]
    errors = [abs(film.on_grid / RIGID_FILM - 1) for film in films]
    # each halving of the spacing takes off three quarters; where the rupture line falls between nodes wobbles
    assert np.log2(errors[0] / errors[-1]) / (len(errors) - 1) > 1.6
    assert errors[-1] < 1e-4


def test_rigid_isoviscous_film():
    """Martin: H_M = 2.4475/M, and 3.0000/M where the pressure is largest; rupture at 0.47513 sqrt(2 R h0)."""
    scene = rigid(0.0)
    solution, groups = solved(scene, accuracy=0.0001), line_scales(scene).groups
    unit, m = groups.moes_film, groups.moes_m
    x, pressure = solution.fields.x.values, solution.fields.pressure.values
    assert solution.figures.film_min.value / unit == pytest.approx(2.4475 / m, rel=3e-4)
    peak = np.argmax(pressure) + np.arange(-1, 2)
    curve = np.polynomial.Polynomial.fit(x[peak], pressure[peak], 2)
    film = np.interp(curve.deriv().roots()[0], x, solution.fields.film.values)
    assert film / unit == pytest.approx(3.0 / m, rel=1e-3)
    # dp/dx = 0 there, so that the root of the pressure ends as a straight line
    last = np.flatnonzero(pressure > 0)[-1]
    before, after = np.sqrt(pressure[last - 1 : last + 1])
    rupture = x[last] + (x[1] - x[0]) * after / (before - after)
    assert rupture / LENGTH == pytest.approx(RUPTURE, abs=2e-3)


def test_rigid_piezoviscous_film():
    """Blok: where the reduced pressure reaches 1/alpha, H_M = 1.0497 L^(2/3)."""
    stiffening = 0.99
    scene = rigid(stiffening)
    figures, groups = solved(scene, accuracy=0.0003).figures, line_scales(scene).groups
    blok = 1.0497 * groups.moes_l ** (2 / 3) / stiffening ** (2 / 3)
    assert figures.film_min.value / groups.moes_film == pytest.approx(blok, rel=1e-3)
    assert figures.pressure_max.value == pytest.approx(
        -log1p(-stiffening) / scene.oil.viscosity.alpha, rel=3e-3
    )


@pytest.mark.parametrize("oil", OILS)
@pytest.mark.parametrize("m", [0.02, 0.5, 2, 20, 100, 500, 3000])
def test_every_regime_converges_with_the_same_settings(m, oil):
    for lubricant in (0, 1, 5, 10, 15, 25):
        scene = line(m, lubricant, oil)
        solution = solved(scene)
        figures = solution.figures
        assert solution.converged, (m, lubricant, solution.stop_reason)
        assert figures.film_min.error <= 0.01 and figures.film_central.error <= 0.01
        assert figures.film_min.value <= figures.film_central.value
        # the film ruptures within the grid
        assert np.all(solution.fields.pressure[-3:] == 0)


@pytest.mark.parametrize(("m", "lubricant"), [(0.1, 1), (0.5, 1), (5, 5), (20, 10), (200, 10)])
def test_the_error_by_the_window_holds_against_a_much_larger_one(m, lubricant):
    scene = line(m, lubricant)
    plan = replace(pyworm.plan(scene, accuracy=0.01), accuracy=1e-5)
    near = plan.grids[0]
    far = replace(near, first=4 * near.first, nodes=near.nodes - 3 * near.first)
    figures, truth = (
        pyworm.solve(scene, replace(plan, largest_grid=near.nodes, **grids)).figures
        for grids in ({}, {"grids": (far,), "wider_grids": ()})
    )
    for name in ("film_central", "film_min"):
        estimate = getattr(figures, name)
        error = abs(estimate.value / getattr(truth, name).value - 1)
        assert error <= 1.1 * estimate.domain < 2e-3


def test_error_bars_hold_against_a_finer_grid():
    random = np.random.default_rng(1)
    misses = 0
    for _ in range(20):
        scene = line(10 ** random.uniform(-0.3, 2.5), random.uniform(0.2, 20))
        rough, fine = (solved(scene, accuracy).figures for accuracy in (0.01, 0.001))
        for name in ("film_central", "film_min"):
            estimate, truth = getattr(rough, name), getattr(fine, name)
            error = abs(estimate.value / truth.value - 1)
            misses += error > estimate.error + truth.error
            assert error <= 2 * (estimate.error + truth.error)
    assert misses <= 1


@pytest.mark.parametrize(("m", "lubricant"), [(0.5, 5), (20, 10), (200, 15)])
def test_reversing_the_speed_mirrors_the_film(m, lubricant):
    scene = line(m, lubricant)
    reversed_ = replace(scene, velocities=tuple(-u for u in scene.velocities))
    solutions = solved(scene), solved(reversed_)
    forth, back = (solution.fields for solution in solutions)
    assert np.allclose(back.x[::-1], -forth.x, rtol=0, atol=1e-12 * RADIUS)
    assert np.allclose(back.film[::-1], forth.film, rtol=1e-6)
    highest = float(forth.pressure.max())
    assert np.allclose(back.pressure[::-1], forth.pressure, rtol=0, atol=1e-5 * highest)
    (there,), (here,) = (solution.figures.film_min_at for solution in solutions)
    assert here == pytest.approx(-there, rel=1e-4)


def test_the_load_is_carried():
    scene = line(20, 10)
    solution = solved(scene, accuracy=0.001)
    assert abs(solution.figures.load_error) < 1e-6
    carried = np.trapezoid(solution.fields.pressure, solution.fields.x)
    assert carried == pytest.approx(scene.load, rel=5e-3)


def test_what_flows_in_flows_out():
    assert solved(line(20, 10)).figures.mass_error < 1e-5


def test_a_tooth_edge_carries_no_pressure_beyond_it():
    scene = line(20, 10)
    whole, hertz = scene.gap, line_scales(scene).hertz
    edge = 0.8 * hertz.half_width

    def ends(x):
        gap, _ = whole(x)
        return gap, x < edge

    solution = solved(replace(scene, gap=ends), accuracy=0.05)
    pressure = solution.fields.pressure
    assert solution.converged
    assert pressure.where(pressure.x >= edge).max() == 0
    assert pressure.max() > 1.1 * hertz.pressure_max


def test_a_grid_sequence_that_ends_early_is_marked():
    scene = line(200, 10)
    plan = replace(pyworm.plan(scene, accuracy=0.001), largest_grid=600)
    solution = pyworm.solve(scene, plan)
    assert not solution.accurate
    assert "largest grid allowed" in solution.stop_reason
    assert solution.figures.film_min.error > 0.001


def test_a_solve_is_the_same_to_the_last_bit_again():
    first, second = (solved(line(50, 10)).fields for _ in range(2))
    assert np.array_equal(first.pressure, second.pressure)


def test_the_summary_of_a_line_contact():
    scene = line(20, 10)
    solution = solved(scene)
    summary = solution.summary()
    assert summary["kind"] == "line"
    assert summary["load_per_length_N_m"] == scene.load
    assert (summary["moes_M"], summary["moes_L"]) == pytest.approx((20, 10))
    assert summary["grid"] == [solution.fields.sizes["x"]]
    assert len(summary["film_min_at_m"]) == 1
    parts = [summary[f"film_min_error_{part}"] for part in ("grid", "domain", "algebra")]
    whole = hypot(*parts) + summary["film_min_error_approximation"]
    assert summary["film_min_error"] == pytest.approx(whole)
    assert not {"load_N", "film_exit_min_m", "dry_pressure_max_Pa"} & set(summary)
    assert summary["convolutions"] > 0
    assert set(solution.fields.dims) == {"x"}
    assert set(solution.history) == {"points_x", "residual", "load_error", "krylov"}
    assert solution.fields.sliding_x[0] == scene.velocities[0] - scene.velocities[1]


def test_what_makes_no_sense_is_refused():
    scene = line(20, 10)
    with pytest.raises(ValueError, match="entrain no oil"):
        pyworm.plan(replace(scene, velocities=(1.0, -1.0)))
    with pytest.raises(ValueError, match="0 N/m"):
        pyworm.plan(replace(scene, load=0.0))
    with pytest.raises(ValueError, match="0 Pa s"):
        pyworm.plan(replace(scene, oil=replace(scene.oil, viscosity=Barus(0.0, ALPHA))))
    with pytest.raises(ValueError, match="near the contact point"):
        solved(replace(scene, gap=lambda x: (np.where(x > 0, np.nan, x**2), x < 1)))


@pytest.mark.parametrize(
    "wrong", [{"load": 0.0}, {"load": np.nan}, {"dx": -1.0}, {"reduced_modulus": np.nan}]
)
def test_the_kernel_refuses_with_a_status(wrong):
    x = np.linspace(-1, 1, 11)
    good = {
        "gap": x**2,
        "covered": x < 2,
        "entrainment": np.ones(11),
        "dx": 0.2,
        "reduced_modulus": 4.0,
        "load": 1.0,
        "oil": OILS["compressible"],
        "floor": 1e-4,
    }
    LineFilm(**good)
    with pytest.raises(KernelError):
        LineFilm(**(good | wrong))


def test_a_finer_grid_has_the_contact_point_to_the_last_bit():
    grid = LineGrid(1e-3, -7, 12)
    assert grid.x[7] == grid.finer().x[14] == 0.0
    assert np.array_equal(grid.finer().x[::2], grid.x)


def test_flow_through_the_contact_is_what_the_pressure_peak_lets_through():
    scene = line(20, 10)
    fields, half_width = solved(scene, accuracy=0.001).fields, line_scales(scene).hertz.half_width
    x, pressure = fields.x.values, fields.pressure.values
    peak = np.argmax(pressure * (x < 0.5 * half_width))
    core = abs(x) < 0.5 * half_width
    flow = scene.oil.density(pressure) * fields.film.values
    assert np.allclose(flow[core], flow[peak], rtol=5e-3)
