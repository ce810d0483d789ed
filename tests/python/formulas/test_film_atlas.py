"""The film formula of the atlas against exact limits, independent solutions and symmetry."""

from math import log, pi, sqrt

import numpy as np
import pytest

from pyworm.formulas import film_atlas
from pyworm.formulas.film import PointGroups, nijenbanning_venner_moes
from pyworm.formulas.film_atlas import AtlasGroups, films, limits, reciprocal_alpha
from pyworm.formulas.hertz import hertz
from pyworm.materials.viscosity_density import Barus, Roelands

ROELANDS = Roelands.from_alpha(0.04, 22e-9)
RATIO_OF_ALPHAS = reciprocal_alpha(ROELANDS, ROELANDS.alpha)

INDEPENDENT = {
    # (M, L, D): central and least film in Moes' unit of a dense Newton solver (docs/evidence/validation.md)
    (20, 10, 1): (4.208, 2.856),
    (100, 10, 1): (3.875, 2.069),
    (200, 10, 1): (3.690, 1.739),
    (200, 10, 1 / 30): (5.355, 4.456),
    (200, 10, 1 / 10): (4.945, 4.167),
    (200, 10, 1 / 5): (4.642, 3.702),
    (200, 10, 1 / 2): (4.147, 2.681),
    (200, 10, 2): (3.14, 0.99),
    (200, 10, 5): (2.38, 0.40),
}
OWN_ERROR = 0.03
"""Of those solutions, at most (least films)."""


def groups(m, el, ratio, compression=0.0):
    """Groups of an aligned contact whose radius along is `ratio` times that across."""
    along = ratio > 1
    return AtlasGroups(
        m, el, max(ratio, 1 / ratio), pi / 2 if along else 0.0, 0.0, RATIO_OF_ALPHAS, compression
    )


def compression(m, el, ratio):
    """Increase of density at the Hertz pressure, of alpha 22/GPa."""
    bare = groups(m, el, ratio)
    pressure = float(film_atlas.pressure(bare)) / 22e-9
    return 0.6e-9 * pressure / (1 + 1.7e-9 * pressure)


@pytest.mark.parametrize("contact", INDEPENDENT, ids=str)
def test_independent_solutions_lie_within_the_bars(contact):
    found = films(groups(*contact, compression(*contact)))
    for told, error, independent in zip(
        (found.central, found.minimum),
        (found.central_error, found.minimum_error),
        INDEPENDENT[contact],
        strict=True,
    ):
        print(contact, f"{float(told):.3f} ± {float(error):.1%}, {independent}")
        assert abs(told / independent - 1) <= error + OWN_ERROR


def test_a_rigid_cylinder_has_martins_and_bloks_film():
    """Least film of a long roller: 4.89497 eta u R/w; 1.6663 (eta u alpha)^(2/3) R^(1/3)."""
    constants = film_atlas._constants()
    ratio, m, el = 1e6, 1e-4, 3.0
    found = limits(
        AtlasGroups(np.array(m), np.array(el), np.array(ratio), np.array(0.0)), constants
    )
    # strips of Martin's w = 4.89497 eta u R/h over h0 + y^2/2 Rs: F = 4.89497 pi eta u R (2 Rs/h0)^(1/2)
    martin = log((4.89497 * pi / sqrt(2)) ** 2 * ratio / m**2)
    assert found.rigid_isoviscous == pytest.approx(martin, abs=0.002)
    assert found.rigid_piezoviscous == pytest.approx(log(1.0497 * el ** (2 / 3)), abs=0.002)


@pytest.mark.parametrize("angle", [0.0, 0.4, 1.2, pi / 2])
def test_rigid_films_are_those_of_the_exact_pressure_at_any_angle(angle):
    """By quadrature of the full pressure's positive half; the exit condition adds 1 to 22 % of load."""
    rx, ry, m = 1.0, 7.0, 1e-5
    u, v = np.cos(angle), np.sin(angle)
    x, y = np.meshgrid(*[np.sinh(np.linspace(-9, 9, 1501))] * 2, indexing="ij")
    h = 1 + x**2 / 2 / rx + y**2 / 2 / ry
    p = 4 * (u * x / (1 + 2 * rx / ry / 3) + v * y / (1 + 2 * ry / rx / 3)) / h**2
    weight = np.cosh(np.linspace(-9, 9, 1501)) * 18 / 1500
    load = weight @ np.maximum(p, 0) @ weight  # over eta u, at h0 = 1; it falls as h0^(-1/2)
    along = 1 / (u**2 / rx + v**2 / ry)
    # M = F/(E' Re^2) (2U)^(-3/4) with 2U = 1: eta u/E' = Re/2
    film = (load * along / 2 / (m * along**2)) ** 2 / along
    found = limits(
        AtlasGroups(np.array(m), np.array(1.0), np.array(ry), np.array(angle)),
        film_atlas._constants(),
    )
    excess = np.exp(float(found.rigid_isoviscous)) / film
    print(f"{angle:.2f}: {excess:.3f}")
    assert 1.0 < excess < 1.2238**2 + 0.01


def test_light_loads_tend_to_the_rigid_film():
    for angle in (0.0, 0.9, pi / 2):
        of = AtlasGroups(np.array(1e-3), np.array(1e-3), np.array(4.0), np.array(angle))
        exact = float(np.exp(limits(of, film_atlas._constants()).rigid_isoviscous))
        assert float(films(of).central) == pytest.approx(exact, rel=0.01)


def test_a_circular_contact_does_not_know_directions():
    angles = np.linspace(0, pi / 2, 7)
    found = films(AtlasGroups(150.0, 8.0, 1.0, angles, 0.1))
    assert np.ptp(found.central) < 1e-9 * found.central[0]
    assert np.ptp(found.minimum) < 1e-9 * found.minimum[0]


def test_the_film_is_continuous_and_the_least_is_least():
    random = np.random.default_rng(3)
    count = 20_000
    m, el = 10 ** random.uniform(-1, 4, count), 10 ** random.uniform(-1, 1.6, count)
    ratio, angle = 10 ** random.uniform(0, 2, count), random.uniform(0, pi / 2, count)
    spin = random.uniform(-0.2, 0.2, count)
    here = films(AtlasGroups(m, el, ratio, angle, spin, 0.9, 0.1))
    near = films(AtlasGroups(m * 1.001, el, ratio * 1.001, angle * 0.9999, spin, 0.9, 0.1))
    assert np.isfinite(here.central).all()
    assert (here.minimum > 0).all()
    assert (here.minimum <= here.central).all()
    assert np.abs(np.log(near.central / here.central)).max() < 0.02
    assert np.abs(np.log(near.minimum / here.minimum)).max() < 0.03


def test_elastic_isoviscous_films_are_those_of_the_field():
    """Nijenbanning, Venner and Moes' isoviscous limit of a circle, 1.3 % from independent solutions."""
    groups_of_circle = PointGroups(1.0, 1.0, 1e-12, 300 * (2e-12) ** 0.75, 1e-3)
    theirs = float(nijenbanning_venner_moes(groups_of_circle).central / groups_of_circle.moes_film)
    found = films(AtlasGroups(300.0, 0.3, 1.0, 0.0))
    assert float(found.central) == pytest.approx(theirs, rel=0.08)


def test_outside_its_box_it_says_so():
    inside = films(AtlasGroups(np.array([100.0, 100.0, 1e5]), np.array([5.0, 60.0, 5.0]), 3.0, 0.3))
    assert inside.inside.tolist() == [True, False, False]


def test_polynomials_of_ellipses_are_hertz():
    for ratio in (1.0, 3.0, 40.0, 900.0):
        exact = hertz(1.0, ratio, 1.0, 1.0)
        assert film_atlas.longer_semi_axis(ratio) == pytest.approx(exact.semi_axis_y, rel=1e-5)
        assert film_atlas.hertz_pressure(ratio) == pytest.approx(exact.pressure_max, rel=1e-5)


def test_the_reciprocal_alpha_of_laws():
    """Barus' is alpha; Roelands' by a rule of its own, int e^-y (1 + y/s)^(1/z - 1) dy."""
    assert reciprocal_alpha(Barus(0.1, 2e-8), 2e-8) == pytest.approx(1, rel=1e-6)
    s = ROELANDS.alpha * ROELANDS.p0 / ROELANDS.z
    place, weight = np.polynomial.laguerre.laggauss(60)
    area = weight @ (1 + place / s) ** (1 / ROELANDS.z - 1)
    assert reciprocal_alpha(ROELANDS, ROELANDS.alpha) == pytest.approx(1 / area, rel=1e-4)


def test_a_viscosity_that_overflows_adds_no_fluidity():
    """Where plans make an overflow an error, too: hard scene `isothermal:85`."""

    def viscosity(pressure):
        return np.exp(2e-8 * pressure + (1e-8 * pressure) ** 3)

    def bounded(pressure):
        return np.exp(np.minimum(2e-8 * pressure + (1e-8 * pressure) ** 3, 700.0))

    with np.errstate(over="raise"):
        assert reciprocal_alpha(viscosity, 2e-8) == reciprocal_alpha(bounded, 2e-8)
