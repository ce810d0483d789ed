"""Films between rough surfaces: their limits, the asperities' share, the sign of the shear factor, what they
cost."""

from dataclasses import replace
from math import exp, pi

import numpy as np
import pytest
from folders import CASES
from rough_bodies import rough
from rough_rings import dry_rough_pressure

import pyworm
from pyworm.formulas.rough_contact import greenwood_tripp
from pyworm.kernel import PointFilm
from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.materials.rough_surfaces import RoughPair, RoughSurface
from pyworm.scene.scales import line_scales
from pyworm.solver.newton import iterate
from pyworm.solver.point.contact import PointContactSolver


class SphericalAsperities(RoughPair):
    """Surfaces that bear by the curve of Greenwood and Tripp (1970)."""

    def contact(self, gap):
        return greenwood_tripp(gap, density=0.05, sharpness=0.01, modulus=self.modulus)


@pytest.fixture(scope="module")
def light_line():
    """A rolling line contact of 0.4 GPa, and its smooth film."""
    heavy = pyworm.load(CASES / "line_thermal.toml").scene()
    ratio = 0.4e9 / line_scales(heavy).hertz.pressure_max
    scene = replace(heavy, load=heavy.load * ratio**2, velocities=(heavy.entrainment,) * 2)
    return scene, solved(scene, "isothermal").figures.film_central.value


def solved(scene, effects, accuracy=0.02):
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    assert solution.converged, solution.stop_reason
    return solution


def test_vanishing_roughness_is_none():
    """Films of surfaces whose roughness is a millionth of them are those of smooth ones."""
    scene = pyworm.load(CASES / "point_m200_l10.toml").scene()
    plan = pyworm.plan(scene, 0.05, "isothermal")
    level, _ = PointContactSolver(plan.simplified(scene), plan).begin(plan.grids)
    iterate(level, 1e-9)
    smooth = level.read()
    finest = RoughSurface(1e-6 * smooth.film_central, 0.01)
    pair = RoughPair((finest, finest), scene.reduced_modulus / 2)
    level.film.shear(NEWTONIAN, 3, scene.sliding_at(*level.grid.mesh()))
    level.film.roughen(pair.curves(), 0.1)
    level.film.restart()
    iterate(level, 1e-9)
    assert level.film.balance.worst <= 1e-7
    figures = level.read()
    for name in ("film_min", "film_central", "pressure_max"):
        assert getattr(figures, name) == pytest.approx(getattr(smooth, name), rel=1e-6)
    assert figures.further["asperity_load_fraction"] == 0


def test_standstill_is_the_dry_rough_contact():
    """As the speed falls to nothing the asperities bear all, as in a dry rough contact solved on rings."""
    scene = pyworm.load(CASES / "point_m200_l10.toml").scene()
    radius, modulus, load = scene.radii[0], scene.reduced_modulus, scene.load
    half_width = (1.5 * load * radius / modulus) ** (1 / 3)
    approach = half_width**2 / radius
    surface = RoughSurface(0.1 * approach, 0.02)
    pair = SphericalAsperities((surface, surface), modulus / 2)
    places = np.linspace(-4 * half_width, 4 * half_width, 129)
    x, y = np.meshgrid(places, places, indexing="ij")
    still = np.zeros_like(x)
    film = PointFilm(
        (x**2 + y**2) / (2 * radius),
        np.ones_like(x, dtype=bool),
        (still + 1.0, still),
        places[1] - places[0],
        places[1] - places[0],
        modulus,
        load,
        scene.oil,
        1e-4 * pair.height,
    )
    film.shear(NEWTONIAN, 3, (still, still))
    film.roughen(pair.curves(), 0.1)
    hertz = 1.5 * load / (pi * half_width**2)
    dome = hertz * np.sqrt(np.maximum(1 - (x**2 + y**2) / half_width**2, 0))
    film.start(dome, 2 * pair.height - approach)
    for speed in 10.0 ** -np.arange(0, 7.1, 0.25):
        film.entrain((still + speed, still))
        film.start(film.pressure, film.rigid_film, film.oil_pressure())
        for _ in range(60):
            film.step(0.01)
            if film.balance.worst < 1e-8 * max(1, 1e-3 / speed):
                break
    radii, pressure = dry_rough_pressure(pair, radius, load, modulus, 4 * half_width)
    middle = len(places) // 2
    exact = np.interp(places[middle:], radii, pressure)
    assert film.pressure[middle:, middle] == pytest.approx(exact, abs=0.01 * pressure.max())
    assert film.asperities().pressure.sum() == pytest.approx(film.pressure.sum(), rel=1e-4)


@pytest.mark.parametrize("lambda_ratio", [0.5, 1.0, 1.5, 2.0])
def test_asperities_share_of_the_load(light_line, lambda_ratio):
    """exp(-1.8 lambda^1.2), a fit to Patir and Cheng's partial films below 0.4 GPa, to a factor of 1.3."""
    scene, film = light_line
    solution = solved(rough(scene, film / lambda_ratio), ("isothermal", "roughness"))
    share = solution.figures.asperity_load_fraction.value
    assert 1 / 1.3 < share / exp(-1.8 * lambda_ratio**1.2) < 1.3


def test_wear_falls_with_the_film_as_the_worm_standard_has_it(light_line):
    """J goes with the share of asperities: its power of the film from lambda 1 to 1.6, -3.1 +- 0.8."""
    scene, film = light_line
    shares, films = [], []
    for faster in (1.0, 1.9):
        quick = replace(scene, velocities=(faster * scene.entrainment,) * 2)
        films.append(solved(quick, "isothermal").figures.film_central.value)
        shares.append(
            solved(
                rough(quick, film), ("isothermal", "roughness")
            ).figures.asperity_load_fraction.value
        )
    exponent = np.log(shares[1] / shares[0]) / np.log(films[1] / films[0])
    assert exponent == pytest.approx(-3.1, abs=0.8)


def test_slower_rough_wall_thickens_the_film():
    """A rough wall that is slower than the mean carries less oil at the same gap, a faster one more.

    It does so most where the gap is narrowest: to pass what the inlet feeds, the film behind it must be
    thicker with a slower rough wall, thinner with a faster one (Patir and Cheng 1979: a slider bears more
    if its rough wall rests).
    """
    line = pyworm.load(CASES / "line_thermal.toml").scene()
    film = solved(line, "isothermal").figures.film_central.value

    def film_with(first, second):
        heights = zip(line.bodies, (first, second), strict=True)
        bodies = tuple(replace(body, roughness=height) for body, height in heights)
        return solved(
            replace(line, bodies=bodies), ("isothermal", "roughness")
        ).figures.film_central.value

    assert line.velocities[0] > line.velocities[1]
    height, polished = film / 3, 1e-3 * film
    equal = film_with(height / 2**0.5, height / 2**0.5)
    assert film_with(polished, height) > 1.01 * equal
    assert film_with(height, polished) < 0.99 * equal


@pytest.mark.parametrize("lambda_ratio", [0.3, 1.0, 3.0])
def test_newton_steps_of_heated_mixed_films(lambda_ratio):
    """At most 1.5 times those of the smooth film; the heat of oil, asperities and bodies balances."""
    scene = pyworm.load(CASES / "traction_steel.toml").scene(slide_roll_ratio=0.5)
    smooth = solved(scene, "auto")
    mixed = solved(rough(scene, smooth.figures.film_central.value / lambda_ratio), "auto")
    assert mixed.history.sizes["iteration"] <= 1.5 * smooth.history.sizes["iteration"]
    assert abs(mixed.figures.heat_balance) < 1e-3
    assert mixed.fields["pressure"].values.min() >= 0
    assert (mixed.fields["asperity_pressure"] <= 1.0001 * mixed.fields["pressure"]).all()
    loss = mixed.figures.power_loss.on_grid
    heat = mixed.fields["friction_power"].values
    pressure = mixed.fields["pressure"].values
    cell = float(np.diff(mixed.fields["x"])[0] * np.diff(mixed.fields["y"])[0])
    assert heat[pressure > 0.01 * pressure.max()].sum() * cell == pytest.approx(loss, rel=0.01)
    figures = mixed.summary()
    assert figures["friction_coefficient"] == pytest.approx(
        figures["friction_fluid"] + figures["friction_boundary"]
    )
    # asperities outside the contact bear load, too; their friction belongs to it no more than the oil's there
    boundary = scene.boundary_friction * figures["asperity_load_fraction"]
    assert 0.9 * boundary < figures["friction_boundary"] <= boundary
