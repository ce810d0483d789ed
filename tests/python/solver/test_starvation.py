"""Films from the oil there is: gaps that are filled in part, and films of starved contacts."""

import tomllib
from dataclasses import replace
from itertools import pairwise
from math import cos, pi
from pathlib import Path

import numpy as np
import pytest
from contacts import ball as sliding_ball
from draws import DRAWS
from folders import CASES
from scipy.integrate import quad
from scipy.optimize import brentq

import pyworm
from pyworm.case.case import case_of
from pyworm.formulas.starvation import film_over_flooded, supply_after_passes
from pyworm.kernel import LineFilm, PointFilm
from pyworm.materials.oil import Oil
from pyworm.materials.oil_layer import OilLayer
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.target import HEAT_FIGURES

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


POCKET = {
    "narrow": (
        10e-3,
        81,
        {0.5037: 8.504, 0.6018: 6.288, 0.7023: 4.847, 0.8028: 3.275, 0.9023: 2.096},
        0.10,
    ),
    "wide": (0.3, 41, {0.5037: 41.81, 0.6018: 36.00, 0.7023: 28.89, 0.8028: 20.04}, 0.01),
}
"""Pad -> its width [m], nodes across, mid-line pressure [MPa] at parts of its length, and their tolerance.

C. Bertocchi, D. Dini, M. Giacopini, M. Fowell and A. Baldini, Tribology International 67 (2013) 61, read from
its figure by E. Hansen et al. (Tribology Letters 70, 2022); readings of the narrow pad scatter by a tenth.
"""


@pytest.mark.parametrize("name", POCKET)
def test_published_pad_with_a_pocket(name):
    """Oil ruptures where a pad's pocket begins, and fills it again before its end."""
    width, across, published, tolerance = POCKET[name]
    length, oil = 20e-3, Oil(Barus(0.01, 1.2e-8), Density(850.0, 0.66 / 2.22e9, 1 / 2.22e9))
    x, y = np.linspace(0, length, 321), np.linspace(-width / 2, width / 2, across)
    along, beside = np.meshgrid(x, y, indexing="ij")
    pocket = (along > 4e-3) & (along < 10e-3) & (abs(beside) < 0.35 * width)
    gap = 1.1e-6 - 0.1e-6 * along / length + np.where(pocket, 0.4e-6, 0.0)
    speed = np.full_like(gap, 0.5)
    film = PointFilm(
        gap,
        np.ones_like(gap, dtype=bool),
        (speed, 0 * speed),
        x[1] - x[0],
        y[1] - y[0],
        STIFF,
        1.0,
        oil,
        1e-9,
    )
    film.hold()
    film.feed(np.ones_like(gap))
    settled(film, np.asfortranarray(np.full_like(gap, 1e5)), tolerance=1e-8)
    middle = film.pressure[:, across // 2]
    for part, pressure in published.items():
        assert np.interp(part * length, x, middle) == pytest.approx(1e6 * pressure, rel=tolerance)
    ruptured = x[middle == 0] / length
    end = {"narrow": 0.43, "wide": 0.265}[name]
    assert ruptured.min() == pytest.approx(0.2, abs=0.01)
    assert ruptured.max() == pytest.approx(end, abs=0.015)


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


def ball(radius_y=12.7e-3, load=40.0, supply=None, **oil):
    """A steel ball, or a wider body, that rolls at 0.5 m/s in PAO VG 220."""
    steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
    given = pyworm.named_oil("PAO VG 220").oil(333.15)
    return pyworm.Scene(
        name="ball",
        gap=pyworm.Paraboloid(12.7e-3, radius_y),
        load=load,
        motions=(pyworm.RigidMotion(0.5, 0),) * 2,
        bodies=(steel, steel),
        oil=replace(given, **({"flow": None, "heat": None} | oil), supply=supply),
    )


def solved(scene, accuracy=0.02, effects="isothermal"):
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    assert solution.converged, solution.stop_reason
    return solution


def oil_of(scene):
    """Oil of the flooded film, rho h in the middle [m]."""
    figures = solved(scene).figures
    density = scene.oil.density
    return figures.film_central.value * density(figures.pressure_max.value) / density(0.0)


@pytest.mark.parametrize("ratio", [0.3, 0.8, 0.95, 1.5])
def test_lines_carry_all_their_oil(ratio):
    """In a line contact no oil escapes to the sides: the film is the oil there is, or the flooded one."""
    scene = pyworm.load(CASES / "line_m20_l10.toml").scene()
    supply = ratio * oil_of(scene)
    starved = replace(scene, oil=replace(scene.oil, supply=supply))
    # beyond one film the contact is flooded, and the plan says so
    film = solved(starved, effects="isothermal" if ratio > 1 else ("isothermal", "starvation"))
    flooded = solved(scene).figures.film_central.value
    share = film.figures.film_central.value / flooded
    assert share == pytest.approx(min(1.0, ratio), rel=0.02)
    if ratio < 1:
        assert film.figures.supply.film_over_flooded == pytest.approx(share, rel=0.01)
        assert film.figures.supply.supply_ratio == pytest.approx(ratio, rel=0.01)


@pytest.mark.parametrize(
    ("radius_y", "load", "ratio", "low", "high"),
    [(12.7e-3, 40, 0.5, 2.5, 4), (12.7e-3, 40, 1, 2.5, 4), (0.381, 200, 1, 8, 20)],
)
def test_exponents_of_starved_films(radius_y, load, ratio, low, high):
    """Chevalier et al. (1998): exponents of 2.5 to 4 for circles, 8 to 20 for wide ellipses."""
    scene = ball(radius_y, load)
    flooded = solved(scene).figures.film_central.value
    starved = solved(replace(scene, oil=replace(scene.oil, supply=ratio * oil_of(scene))))
    share = starved.figures.film_central.value / flooded
    assert film_over_flooded(ratio, low) < share < film_over_flooded(ratio, high)


def test_heated_starved_film():
    """A sliding ball with heat and limiting stress: thinner films of the same oil, more friction."""
    given = pyworm.named_oil("PAO VG 220").oil(333.15)
    scene = replace(
        ball(flow=given.flow, heat=given.heat),
        motions=(pyworm.RigidMotion(0.6, 0), pyworm.RigidMotion(0.4, 0)),
    )
    whole, half = (
        solved(replace(scene, oil=replace(scene.oil, supply=of)), 0.05, "all")
        for of in (2.4e-7, 1.2e-7)
    )
    assert "film-heating" in {effect.name for effect in half.effects if effect.on}
    assert half.figures.film_central.value < 0.65 * whole.figures.film_central.value
    assert half.figures.friction_coefficient.value > whole.figures.friction_coefficient.value
    assert half.fields["oil_fraction"].values.min() > 0


def test_profile_of_the_supply():
    """A layer that is the same everywhere is a number; one that ends beside the middle starves that side."""
    even = OilLayer((-1e-3, 1e-3), (2e-7, 2e-7))
    lone, profile = (solved(ball(supply=of)) for of in (2e-7, even))
    assert profile.figures.film_central.value == lone.figures.film_central.value
    to_the_left = OilLayer((-3e-5, 3e-5), (1e-7, 4e-7))
    film = solved(ball(supply=to_the_left)).fields["film"]
    left, right = (float(film.sel(x=0, y=at, method="nearest")) for at in (1e-4, -1e-4))
    assert left > 1.3 * right


@pytest.mark.parametrize(
    ("across", "thickness", "sentence"),
    [
        ((0.0,), (1e-7,), "two numbers at least"),
        ((0.0, 1e-3), (1e-7,), "as many"),
        ((1e-3, 0.0), (1e-7, 1e-7), "must increase"),
        ((0.0, 1e-3), (1e-7, -1e-7), "thickness"),
    ],
)
def test_profiles_that_are_none(across, thickness, sentence):
    with pytest.raises(ValueError, match=sentence):
        OilLayer(across, thickness)


def test_plans_starve_where_oil_is_known_and_short():
    """Without a supply the plan says that it assumes plenty; with little, starvation is simulated."""
    judged = {
        supply: next(
            of for of in pyworm.plan(ball(supply=supply), 0.05).effects if of.name == "starvation"
        )
        for supply in (None, 1e-5, 1e-7)
    }
    assert judged[None].reason == "flooded, assumed: oil.supply not given"
    assert judged[1e-5].reason.startswith("flooded: the supply is")
    assert judged[1e-7].on
    assert judged[1e-7].influence["film"] > 0.4


def test_repeated_passes():
    """Without new oil each pass leaves less: near Chevalier's (r^-g + n)^(-1/g) with one exponent."""
    scene = ball()
    flooded, oil = solved(scene).figures.film_central.value, oil_of(scene)
    films = [
        of.figures.film_central.value / flooded
        for of in pyworm.passes(
            replace(scene, oil=replace(scene.oil, supply=oil)), 4, 0.05, "isothermal"
        )
    ]
    assert all(after < before for before, after in pairwise(films))
    low, high = (supply_after_passes(1.0, 4, exponent) for exponent in (2.0, 4.5))
    assert low < films[-1] < high


def test_rough_and_moving_films_starve_too():
    """Beside asperities, and after a load that falls, the film stays that of the oil there is."""
    scene = pyworm.load(CASES / "starved_ball.toml").scene()
    smooth = solved(scene, 0.05).figures.film_central.value
    bodies = tuple(replace(body, roughness=3e-8) for body in scene.bodies)
    between = solved(replace(scene, bodies=bodies), 0.05, ("isothermal", "roughness")).figures
    assert 0 < between.asperity_load_fraction.value < 0.05
    assert between.film_central.value == pytest.approx(smooth, rel=0.05)
    tables = tomllib.loads((CASES / "starved_ball.toml").read_text())
    tables["past"] = {"times": ["0 s", "0.6 ms", "1.5 ms"], "load": [1.5, 1.5, 1.0]}
    moving = solved(
        case_of(tables, "moving", CASES).scene(), 0.05, ("isothermal", "squeeze", "starvation")
    ).figures
    assert moving.film_central.value == pytest.approx(smooth, rel=0.1)


@pytest.mark.parametrize(("supply", "accuracy"), [(3e-7, 0.02), (1e-7, 0.05)])
def test_films_of_first_order_are_within_their_error_bars(supply, accuracy):
    """By second order the limit of the central film would be off by 0.2 and 0.3 %, with bars of 0.07 %."""
    scene = replace(sliding_ball(), oil=ball(supply=supply).oil)
    told, truth = (
        solved(scene, of, ("isothermal", "starvation")).figures for of in (accuracy, 0.003)
    )
    for name in ("film_min", "film_central"):
        bar, known = getattr(told, name), getattr(truth, name)
        assert abs(bar.value - known.value) < bar.error * bar.value + known.error * known.value


def test_a_window_that_holds_the_meniscus_changes_films_by_its_warmth_only():
    """On the first grid films differ by 0.5 % from window to window, on finer ones by less and less."""
    scene = sliding_ball()
    scene = replace(scene, oil=replace(scene.oil, supply=3e-8))
    figures = solved(scene, 0.1, "all").figures
    hot = [getattr(figures, name) for name in HEAT_FIGURES]
    off = 2 * scene.oil.beta * max(of.domain * (of.value - of.datum) for of in hot)
    assert 0 < figures.film_min.domain == figures.film_central.domain < off < 5e-3


def test_no_oil_is_pressed_in_from_a_coarser_grid():
    """Obliquely past an ellipse the meniscus of a coarser grid stood farther out than the next one reaches.

    Its pressure there, kept, fed films 22 % too thick, 47 % from those whose grids happened to be larger.
    """
    scene = case_of(DRAWS["starved"](7, 99100).tables, "starved", Path()).scene()
    found = [
        pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal", ("film",)))
        for accuracy in (0.05, 0.1)
    ]
    one, other = (solution.figures.film_central for solution in found)
    assert one.agrees_with(other) and max(one.error, other.error) < 0.01
    for solution in found:
        pressure = solution.fields["pressure"].values
        assert not any(side.any() for side in (*pressure[[0, -1]], *pressure.T[[0, -1]]))
