"""Films of contacts by the formula of the atlas, from sizes with units and from scenes."""

from time import process_time

import numpy as np
import pytest
from folders import CASES

import pyworm


def oil():
    return pyworm.Oil(
        pyworm.Roelands.from_alpha(0.04, 22e-9), pyworm.Density.dowson_higginson(870.0)
    )


def test_arrays_give_what_numbers_give():
    loads = np.array([5.0, 50.0, 200.0])
    together = pyworm.film((0.01, 0.03), loads, 226e9, (1.0, 0.5), oil())
    for load, central, minimum in zip(loads, together.central, together.minimum, strict=True):
        alone = pyworm.film((0.01, 0.03), load, 226e9, (1.0, 0.5), oil())
        assert alone.central == pytest.approx(central, rel=1e-12)
        assert alone.minimum == pytest.approx(minimum, rel=1e-12)


def test_mirrors_and_exchanged_axes_give_the_same_film():
    one = pyworm.film((0.01, 0.08), 80.0, 226e9, (0.6, 0.8), oil(), 40.0)
    turned = [
        pyworm.film((0.01, 0.08), 80.0, 226e9, (-0.6, -0.8), oil(), 40.0),
        pyworm.film((0.01, 0.08), 80.0, 226e9, (0.6, -0.8), oil(), -40.0),
        pyworm.film((0.08, 0.01), 80.0, 226e9, (0.8, 0.6), oil(), -40.0),
        pyworm.film((0.08, 0.01), 80.0, 226e9, (-0.8, 0.6), oil(), 40.0),
    ]
    other = pyworm.film((0.01, 0.08), 80.0, 226e9, (0.6, 0.8), oil(), -40.0)
    for of in turned:
        assert float(of.central) == pytest.approx(float(one.central), rel=1e-9)
        assert float(of.minimum) == pytest.approx(float(one.minimum), rel=1e-9)
    assert float(other.minimum) != pytest.approx(float(one.minimum), rel=1e-4)


def test_mouriers_published_film():
    """Central film 209.3 nm by simulation, digitised to a hundredth; least 119 nm by a dense solver."""
    found = pyworm.film_of(pyworm.load(CASES / "mourier_2006.toml").scene())
    print(found.central, found.central_error, found.minimum, found.minimum_error)
    assert float(found.central) == pytest.approx(209.3e-9, rel=float(found.central_error) + 0.01)
    assert float(found.minimum) == pytest.approx(119e-9, rel=float(found.minimum_error))


@pytest.mark.parametrize("name", ["point_m100_l10", "ellipse10_across", "ellipse10_oblique"])
def test_it_agrees_with_a_solve_within_its_bar(name):
    scene = pyworm.load(CASES / f"{name}.toml").scene()
    solved = pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal")).figures
    found = pyworm.film_of(scene)
    for told, error, film in (
        (found.central, found.central_error, solved.film_central),
        (found.minimum, found.minimum_error, solved.film_min),
    ):
        print(name, float(told), float(error), film)
        assert abs(float(told) / film.value - 1) <= float(error) + film.error


def test_a_scene_with_spin_has_the_spin_of_its_motions():
    scene = pyworm.load(CASES / "spin_zi_like.toml").scene()
    groups = pyworm.film_of(scene).groups
    assert abs(float(groups.spin)) == pytest.approx(
        1.0, rel=0.01
    )  # the case's own words: u/b of spin


def test_what_is_not_possible_is_refused():
    with pytest.raises(ValueError, match="load = -3 N"):
        pyworm.film((0.01, 0.01), -3.0, 226e9, (1.0, 0.0), oil())
    with pytest.raises(ValueError, match="entrainment speed"):
        pyworm.film((0.01, 0.01), 3.0, 226e9, (0.0, 0.0), oil())


def test_a_contact_costs_no_more_than_some_hundred_exponentials():
    """Costs are compared with NumPy's own exponential, since machines differ: 1 ns and 0.8 us."""
    count = 200_000
    loads = np.random.default_rng(0).uniform(10, 200, count)
    pyworm.film((0.01, 0.03), loads, 226e9, (1.0, 0.5), oil())
    started = process_time()
    pyworm.film((0.01, 0.03), loads, 226e9, (1.0, 0.5), oil())
    film = process_time() - started
    started = process_time()
    for _ in range(200):
        np.exp(loads / 200)
    exponentials = (process_time() - started) / 200
    print(f"{1e6 * film / count:.2f} us a contact, {film / exponentials:.0f} exponentials")
    assert film < 2500 * exponentials
