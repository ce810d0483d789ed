"""Results as objects of a script: shown, compared, calculated with, exported; friction by one's own sum."""

import csv
from base64 import b64decode
from xml.etree import ElementTree

import numpy as np
import pytest
from contacts import ball

import pyworm


@pytest.fixture(scope="module")
def solution():
    scene = ball()
    return pyworm.solve(scene, pyworm.plan(scene, accuracy=0.1))


def test_objects_show_themselves_in_a_line_and_a_table(solution):
    scene = ball()
    for one in (
        scene,
        pyworm.plan(scene, 0.1),
        solution,
        solution.figures,
        pyworm.dry_contact(scene),
    ):
        line, table = repr(one), one._repr_html_()
        assert "\n" not in line and len(line) <= 160
        assert table.startswith("<table>") and table.endswith("</table>\n")


def test_a_figure_is_a_number_with_a_bar(solution):
    film = solution.figures.film_min
    assert float(film) == film.value
    assert f"{film:.3g}" == f"{film.value:.3g} ± {100 * film.error:.3g} %"
    assert film.bar == pytest.approx(film.error * film.value)
    twice = 2 * film
    assert (twice.value, twice.error) == (2 * film.value, film.error)


def test_bars_are_carried_through_calculation():
    one, other = pyworm.Estimate(3.0, 0.1), pyworm.Estimate(2.0, 0.05, 0.05)
    # errors of one origin add up, those of several by their squares
    assert (one + other).bar == pytest.approx(np.hypot(0.3 + 0.1, 0.1))
    assert (one - other).bar == pytest.approx(np.hypot(0.3 + 0.1, 0.1))
    assert (one - other).value == 1.0
    assert (one * other).error == pytest.approx(np.hypot(0.15, 0.05))
    assert (one / other).error == pytest.approx(np.hypot(0.15, 0.05))
    assert (other**2).error == pytest.approx(2 * other.error)
    assert (1 / one).value == pytest.approx(1 / 3)
    assert (one / other).grid == pytest.approx(0.15)
    assert one > other
    assert (5 - one).bar == pytest.approx(0.3)
    assert (-one).value == -3.0


def test_errors_of_temperatures_belong_to_the_rise(solution):
    hot = solution.figures.temperature_max_film
    rise = hot - hot.datum
    assert hot.datum == pytest.approx(333.15)
    assert rise.error == pytest.approx(hot.error)
    assert rise.bar == pytest.approx(hot.bar)


@pytest.mark.parametrize(("error", "agree"), [(0.02, True), (0.001, False)])
def test_figures_agree_within_both_bars(error, agree):
    assert pyworm.Estimate(1.0, error).agrees_with(pyworm.Estimate(1.02, error)) is agree


def test_equality_and_hash_are_those_of_the_content(solution):
    again = solution.changed()
    assert solution == again and hash(solution) == hash(again)
    assert solution != solution.changed(load=31.0)
    fields = solution.fields.copy(deep=True)
    fields["film"].values[0, 0] += 1e-9
    assert solution != solution.changed(fields=fields)
    axis = np.linspace(-1e-3, 1e-3, 9)
    heights = 1e2 * (axis[:, None] ** 2 + axis**2)
    one, same = (pyworm.SampledGap(axis, axis, heights.copy()) for _ in range(2))
    assert one == same and hash(one) == hash(same)
    assert one != pyworm.SampledGap(axis, axis, 2 * heights)
    assert ball(gap=one, radii=None) == ball(gap=same, radii=None)


def test_a_result_read_again_is_equal(solution, tmp_path):
    result = pyworm.Result("ball", {}, (solution,), None, {})
    assert pyworm.open_result(result.save(tmp_path / "ball.nc")) == result


def test_two_solutions_side_by_side(solution):
    scene = ball(load=40.0)
    heavier = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.1))
    both = pyworm.compare(solution, heavier)
    assert both.ratios["film_min"].value == pytest.approx(
        heavier.figures.film_min.value / solution.figures.film_min.value
    )
    assert "pressure_max" in both.differ
    assert not pyworm.compare(solution, solution).differ


def test_pictures_of_a_solution(solution, tmp_path):
    assert {"film", "pressure", "temperature"} <= set(dir(solution.plot))
    figure = solution.plot.film(tmp_path / "film.png")
    assert (tmp_path / "film.png").stat().st_size > 10_000
    assert figure.axes
    with pytest.raises(AttributeError, match="no picture 'wear'; it has across_film, entr"):
        _ = solution.plot.wear


def test_fields_as_a_table(solution, tmp_path):
    with pyworm.write_csv(solution, tmp_path / "fields.csv").open() as file:
        head, *rows = csv.reader(file)
    fields = solution.fields
    assert {"x [m]", "y [m]", "film [m]", "pressure [Pa]"} <= set(head)
    assert len(rows) == fields.sizes["x"] * fields.sizes["y"]
    table = dict(zip(head, np.array(rows, dtype=float).T, strict=True))
    place = np.argmax(table["pressure [Pa]"])
    x, y = table["x [m]"][place], table["y [m]"][place]
    there = fields["pressure"].sel(x=x, y=y, method="nearest")
    assert float(there) == pytest.approx(float(fields["pressure"].max()), rel=1e-6)


def test_fields_as_image_data(solution, tmp_path):
    root = ElementTree.parse(pyworm.write_vtk(solution, tmp_path / "fields.vti")).getroot()
    image = root.find("ImageData")
    fields = solution.fields
    extent = [int(end) for end in image.get("WholeExtent").split()]
    assert (extent[1] + 1, extent[3] + 1) == (fields.sizes["x"], fields.sizes["y"])
    assert float(image.get("Origin").split()[0]) == pytest.approx(float(fields["x"][0]))
    arrays = {
        of.get("Name"): np.frombuffer(b64decode(of.text)[8:]) for of in root.iter("DataArray")
    }
    film = arrays["film"].reshape(fields["film"].shape)
    assert np.allclose(film, fields["film"].values, rtol=1e-6)
    with pytest.raises(ValueError, match=r"end in \.vti"):
        pyworm.write_vtk(solution, tmp_path / "fields.vtk")


def own_friction(solution):
    """The recipe of docs/how-to/script.md: friction by a sum over the fields."""
    fields = solution.fields
    pressure = fields["pressure"].values
    counted = (fields["covered"].values == 1) & (pressure > 0.01 * pressure.max())
    cell = float(fields["x"].diff("x").mean() * fields["y"].diff("y").mean())
    force = fields["shear_stress_x"].values[counted].astype(float).sum() * cell
    return abs(force) / solution.load


def test_friction_by_ones_own_sum_is_the_figure(solution):
    figure = solution.figures.friction_coefficient
    assert own_friction(solution) == pytest.approx(figure.on_grid, rel=2e-3)


def test_without_the_threshold_the_sum_is_another(solution):
    """Oil outside the contact shears too: the rule of the figure's docstring matters."""
    fields = solution.fields
    cell = float(fields["x"].diff("x").mean() * fields["y"].diff("y").mean())
    all_of_it = abs(float(fields["shear_stress_x"].sum())) * cell / solution.load
    assert all_of_it > 1.002 * solution.figures.friction_coefficient.on_grid
