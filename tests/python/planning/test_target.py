"""What errors of figures are relative to: figure, roughness of a film, difference of temperatures."""

import pytest

from pyworm.planning.target import AccuracyTarget


@pytest.mark.parametrize(
    ("film", "expected"), [(4e-6, 0.2), (1e-6, 0.2), (0.25e-6, 0.05), (0.0, 0.0)]
)
def test_errors_of_films_are_relative_to_the_roughness_where_they_are_thinner(film, expected):
    target = AccuracyTarget(("film_min",), roughness=1e-6)
    assert target.worst({"film_min": 0.2}, {"film_min": film}) == pytest.approx(expected)


def test_other_figures_are_not_judged_by_the_roughness():
    target = AccuracyTarget(("friction_coefficient",), roughness=1e-6)
    assert target.worst({"friction_coefficient": 0.2}, {"friction_coefficient": 1e-9}) == 0.2


@pytest.mark.parametrize(("rise", "expected"), [(40.0, 0.1), (5.0, 0.05)])
def test_errors_of_temperatures_are_relative_to_a_difference_where_the_rise_is_smaller(
    rise, expected
):
    target = AccuracyTarget(("temperature_max_film",), warmth=10.0, roughness=1e-6)
    errors = {"temperature_max_film": 0.1}
    assert target.worst(errors, {"temperature_max_film": rise}) == pytest.approx(expected)


def test_smooth_surfaces_have_errors_of_films_relative_to_these():
    errors, figures = (
        {"film_min": 0.2, "film_central": 0.1},
        {"film_min": 1e-9, "film_central": 2e-9},
    )
    assert AccuracyTarget(()).films().worst(errors, figures) == 0.2
