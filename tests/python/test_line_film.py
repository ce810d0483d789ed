"""Line contacts against exact rigid films, an independent solver and their own symmetries."""

import csv
from dataclasses import replace
from math import log1p, pi
from pathlib import Path

import numpy as np
import pytest

from pyworm.kernels import KernelError, LineFilm
from pyworm.line_climb import climb_line, relative_error
from pyworm.line_scene import LineScene, Parabola
from pyworm.oils import Barus, Density, Oil, Roelands

ETA0, ALPHA, MODULUS, RADIUS = 0.04, 22e-9, 226e9, 0.01
OILS = {
    "incompressible": Oil(Barus(ETA0, ALPHA), Density.incompressible(870.0)),
    "compressible": Oil(Roelands.from_alpha(ETA0, ALPHA), Density.dowson_higginson_pole(870.0)),
}


def line(m, lubricant, oil="compressible"):
    """A line contact of given Moes parameters; L = 0 is an isoviscous oil."""
    speed_group = ((lubricant or 5.0) / (ALPHA * MODULUS)) ** 4 / 2
    chosen = OILS[oil]
    return LineScene(
        gap=Parabola(RADIUS),
        radius=RADIUS,
        speed=speed_group * MODULUS * RADIUS / ETA0,
        load=m * (2 * speed_group) ** 0.5 * MODULUS * RADIUS,
        reduced_modulus=MODULUS,
        oil=chosen if lubricant else replace(chosen, viscosity=Barus(ETA0, 0.0)),
    )


def rows():
    with open(Path(__file__).parents[1] / "data" / "line_films.csv") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@pytest.mark.parametrize("oil", OILS)
@pytest.mark.parametrize("row", rows(), ids=lambda row: f"M{row['M']}-L{row['L']}")
def test_films_of_an_independent_solver(row, oil):
    scene = line(float(row["M"]), float(row["L"]), oil)
    solution = climb_line(scene, accuracy=0.0005)
    unit = scene.groups.moes_film
    assert solution.converged
    central, minimum = float(row[f"{oil}_central"]), float(row[f"{oil}_minimum"])
    assert solution.film_central.value / unit == pytest.approx(central, rel=0.003)
    assert solution.film_min.value / unit == pytest.approx(minimum, rel=0.01)


def test_film_at_two_gigapascal():
    """The case of Venner and Lubrecht (1994), M = 100, L = 11.04, computed by the same independent solver."""
    scene = replace(
        line(100, 11.04), gap=Parabola(0.0141), radius=0.0141, speed=0.97, load=1.5708e6
    )
    solution = climb_line(scene, accuracy=0.001)
    unit = scene.groups.moes_film
    assert scene.dry.pressure_max == pytest.approx(2e9, rel=0.001)
    assert solution.film_central.value / unit == pytest.approx(3.639, rel=0.003)
    assert solution.film_min.value / unit == pytest.approx(3.276, rel=0.01)


@pytest.mark.parametrize(("m", "lubricant"), [(5, 5), (20, 10), (100, 10), (200, 10), (500, 25)])
def test_central_film_converges_by_second_order(m, lubricant):
    solution = climb_line(line(m, lubricant), accuracy=0.0, largest_grid=8400)
    values = [reading.film_central for reading in solution.readings]
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
        gap=Parabola(RADIUS),
        radius=RADIUS,
        speed=SPEED,
        load=float((pressure / np.cos(angle) ** 2) @ weights) * half_span * LENGTH,
        reduced_modulus=1e17,
        oil=Oil(Barus(ETA0, alpha), Density.incompressible(870.0)),
    )


@pytest.mark.parametrize("stiffening", [0.0, 0.5, 0.95, 0.99])
def test_rigid_films_are_exact_to_second_order(stiffening):
    solution = climb_line(rigid(stiffening), accuracy=0.0, largest_grid=1100)
    errors = [abs(reading.film_min / RIGID_FILM - 1) for reading in solution.readings]
    # each halving of the spacing takes off three quarters; where the rupture line falls between nodes wobbles
    assert np.log2(errors[0] / errors[-1]) / (len(errors) - 1) > 1.6
    assert errors[-1] < 1e-4


def test_rigid_isoviscous_film():
    """Martin: H_M = 2.4475/M, and 3.0000/M where the pressure is largest; rupture at 0.47513 sqrt(2 R h0)."""
    scene = rigid(0.0)
    solution = climb_line(scene, accuracy=0.0001)
    unit, m = scene.groups.moes_film, scene.groups.moes_m
    assert solution.film_min.value / unit == pytest.approx(2.4475 / m, rel=3e-4)
    peak = np.argmax(solution.pressure) + np.arange(-1, 2)
    curve = np.polynomial.Polynomial.fit(solution.x[peak], solution.pressure[peak], 2)
    film = np.interp(curve.deriv().roots()[0], solution.x, solution.film)
    assert film / unit == pytest.approx(3.0 / m, rel=1e-3)
    # dp/dx = 0 there, so that the root of the pressure ends as a straight line
    last = np.flatnonzero(solution.pressure > 0)[-1]
    before, after = np.sqrt(solution.pressure[last - 1 : last + 1])
    step = solution.x[1] - solution.x[0]
    rupture = solution.x[last] + step * after / (before - after)
    assert rupture / LENGTH == pytest.approx(RUPTURE, abs=2e-3)


def test_rigid_piezoviscous_film():
    """Blok: where the reduced pressure reaches 1/alpha, H_M = 1.0497 L^(2/3)."""
    stiffening = 0.99
    scene = rigid(stiffening)
    solution = climb_line(scene, accuracy=0.0003)
    blok = 1.0497 * scene.groups.moes_l ** (2 / 3) / stiffening ** (2 / 3)
    assert solution.film_min.value / scene.groups.moes_film == pytest.approx(blok, rel=1e-3)
    assert solution.pressure_max.value == pytest.approx(
        -log1p(-stiffening) / scene.oil.viscosity.alpha, rel=3e-3
    )


@pytest.mark.parametrize("oil", OILS)
@pytest.mark.parametrize("m", [0.02, 0.5, 2, 20, 100, 500])
def test_every_regime_converges_with_the_same_settings(m, oil):
    for lubricant in (0, 1, 5, 10, 15, 25):
        scene = line(m, lubricant, oil)
        solution = climb_line(scene)
        assert solution.converged, (m, lubricant, solution.stop_reason)
        assert solution.film_min.error <= 0.01 and solution.film_central.error <= 0.01
        assert solution.film_min.value <= solution.film_central.value
        # the film ruptures within the grid
        assert np.all(solution.pressure[-3:] == 0)


@pytest.mark.parametrize(("m", "lubricant"), [(0.1, 1), (0.5, 1), (5, 5), (20, 10), (200, 10)])
def test_the_oil_supply_does_not_end_at_the_inlet(m, lubricant):
    near, usual, far = (
        climb_line(line(m, lubricant), accuracy=0.0003, inlet_films=films) for films in (3, 12, 100)
    )
    for name in ("film_central", "film_min"):
        truth = getattr(far, name).value
        assert getattr(usual, name).value == pytest.approx(truth, rel=7e-4)
        assert getattr(near, name).value == pytest.approx(truth, rel=3e-3)


def test_error_bars_hold_against_a_finer_grid():
    random = np.random.default_rng(1)
    misses = 0
    for _ in range(20):
        scene = line(10 ** random.uniform(-0.3, 2.5), random.uniform(0.2, 20))
        rough, fine = climb_line(scene, accuracy=0.01), climb_line(scene, accuracy=0.001)
        for name in ("film_central", "film_min"):
            estimate, truth = getattr(rough, name), getattr(fine, name)
            error = abs(estimate.value / truth.value - 1)
            misses += error > estimate.error + truth.error
            assert error <= 2 * (estimate.error + truth.error)
    assert misses <= 1


@pytest.mark.parametrize(("m", "lubricant"), [(0.5, 5), (20, 10), (200, 15)])
def test_reversing_the_speed_mirrors_the_film(m, lubricant):
    scene = line(m, lubricant)
    forth, back = climb_line(scene), climb_line(replace(scene, speed=-scene.speed))
    assert np.allclose(back.x[::-1], -forth.x, rtol=0, atol=1e-12 * RADIUS)
    assert np.allclose(back.film[::-1], forth.film, rtol=1e-6)
    assert np.allclose(
        back.pressure[::-1], forth.pressure, rtol=0, atol=1e-5 * forth.pressure.max()
    )
    assert back.film_min_at == pytest.approx(-forth.film_min_at, rel=1e-4)


def test_the_load_is_carried():
    scene = line(20, 10)
    solution = climb_line(scene, accuracy=0.001)
    assert abs(solution.load_error) < 1e-6
    assert np.trapezoid(solution.pressure, solution.x) == pytest.approx(scene.load, rel=5e-3)


def test_a_tooth_edge_carries_no_pressure_beyond_it():
    scene = line(20, 10)
    whole, edge = scene.gap, 0.8 * scene.dry.half_width

    def ends(x):
        gap, _ = whole(x)
        return gap, x < edge

    solution = climb_line(replace(scene, gap=ends), accuracy=0.05)
    assert solution.converged
    assert solution.pressure[solution.x >= edge].max() == 0
    assert solution.pressure.max() > 1.1 * scene.dry.pressure_max


def test_a_climb_that_ends_early_is_marked():
    solution = climb_line(line(200, 10), accuracy=0.001, largest_grid=300)
    assert not solution.converged
    assert "largest grid allowed" in solution.stop_reason
    assert solution.film_min.error > 0.001


def test_a_solve_is_the_same_to_the_last_bit_again():
    first, second = (climb_line(line(50, 10)) for _ in range(2))
    assert np.array_equal(first.pressure, second.pressure)


def test_what_makes_no_sense_is_refused():
    scene = line(20, 10)
    with pytest.raises(ValueError, match="entrain no oil"):
        climb_line(replace(scene, speed=0.0))
    with pytest.raises(ValueError, match="0 N/m"):
        climb_line(replace(scene, load=0.0))
    with pytest.raises(ValueError, match="0 Pa s"):
        climb_line(replace(scene, oil=replace(scene.oil, viscosity=Barus(0.0, ALPHA))))
    with pytest.raises(KernelError):
        climb_line(replace(scene, gap=lambda x: (np.where(x > 0, np.nan, x**2), x < 1)))


@pytest.mark.parametrize(
    "wrong", [{"load": 0.0}, {"load": np.nan}, {"dx": -1.0}, {"reduced_modulus": np.nan}]
)
def test_the_kernel_refuses_with_a_status(wrong):
    x = np.linspace(-1, 1, 11)
    good = {
        "gap": x**2,
        "covered": x < 2,
        "entrainment": np.ones(11),
        "squeeze": np.zeros(11),
        "dx": 0.2,
        "reduced_modulus": 4.0,
        "load": 1.0,
        "oil": OILS["compressible"],
        "floor": 1e-4,
    }
    LineFilm(**good)
    with pytest.raises(KernelError):
        LineFilm(**(good | wrong))


@pytest.mark.parametrize(
    ("values", "order", "error"),
    [([1.0], 2, np.inf), ([2.0, 1.0], 2, 1.0), ([21.0, 5.0, 1.0], 2, 4 / 3), ([3, 2, 1], 2, 1.0)],
)
def test_relative_error_of_a_climb(values, order, error):
    assert relative_error(values, order) == pytest.approx(error)


def test_steepest_fall_believed_is_the_order():
    assert relative_error([100.0, 2.0, 1.0], 1.0) == pytest.approx(1.0)


def test_flow_through_the_contact_is_what_the_pressure_peak_lets_through():
    scene = line(20, 10)
    solution = climb_line(scene, accuracy=0.001)
    peak = np.argmax(solution.pressure * (solution.x < 0.5 * scene.dry.half_width))
    core = abs(solution.x) < 0.5 * scene.dry.half_width
    flow = solution.density * solution.film
    assert np.allclose(flow[core], flow[peak], rtol=5e-3)
