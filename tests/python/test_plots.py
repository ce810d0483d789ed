"""Pictures: all are drawn, and they show what their scales and outlines claim."""

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.contour import ContourSet
from matplotlib.image import imread
from matplotlib.text import Text
from synthetic_solution import (
    make_line_solution,
    make_mesh_cycle,
    make_result,
    make_solution,
    make_worm_solution,
)

from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.plots import draw
from pyworm.plots.entrainment import LINES, draw_entrainment, inflow_points
from pyworm.plots.film import draw_film, interferogram
from pyworm.plots.gap import draw_gap
from pyworm.plots.history import draw_history
from pyworm.plots.line_profiles import draw_line_profiles
from pyworm.plots.outline import signed_square
from pyworm.plots.pressure import draw_pressure
from pyworm.plots.profiles import draw_profiles
from pyworm.plots.style import Window, contact_window, heading
from pyworm.result import Result
from pyworm.variables import describe

SCENE_NAMES = ["gap", "pressure", "film", "entrainment", "profiles", "history"]
LINE_NAMES = ["profiles", "history"]


@pytest.fixture(scope="module")
def circle():
    return make_solution()


@pytest.fixture(scope="module")
def worm():
    return make_worm_solution()


def texts(figure):
    """All words on a figure."""
    return " ".join(text.get_text() for text in figure.findobj(Text))


def test_all_pictures_of_a_file(tmp_path):
    result = make_result()
    file = result.save(tmp_path / "result.nc")
    written = draw(file, tmp_path / "pictures" / "here")
    expected = [f"scene_{i:03d}_{name}.png" for i in range(2) for name in SCENE_NAMES]
    assert [path.name for path in written] == [*expected, "mesh_cycle.png"]
    for path in written:
        pixels = imread(path)[..., :3]
        assert min(pixels.shape[:2]) > 400
        assert np.ptp(pixels) == 1.0
        assert np.unique(pixels @ [1.0, 300.0, 90000.0]).size > 20


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "solution",
    [
        make_solution(),
        make_worm_solution(radii=(0.0954, 3.046), edge=None, points=(49, 97), angle=0.0),
        make_worm_solution(turn=0.6, edge=5e-3, extent=((-1.6, 1.6), (-1.6, 1.6))),
        make_solution(film_central=0.0, converged=False),
    ],
    ids=["circle", "tall", "turned and cut", "failed"],
)
def test_every_shape_draws_without_warnings(solution, tmp_path):
    written = draw(Result("shape", {}, (solution,), None, {}), tmp_path)
    assert len(written) == len(SCENE_NAMES)


def test_film_scale_ends_at_three_central_films(circle):
    axes = draw_film("case", circle).axes[0]
    filled = axes.collections[0]
    assert filled.get_clim() == pytest.approx((0, 3 * 0.213), rel=1e-12)
    assert filled.levels[-1] == pytest.approx(3 * 0.213, rel=1e-12)
    (marker,) = (line for line in axes.lines if line.get_marker() == "o")
    place = [float(marker.get_xdata()[0]), float(marker.get_ydata()[0])]
    assert place == pytest.approx([1e3 * at for at in circle.figures.film_min_at])


def test_dry_outline_is_the_hertz_ellipse(worm):
    """The drawn outline follows the ellipse to a small part of the grid spacing."""
    fields = worm.fields
    axes = draw_entrainment("case", worm).axes[0]
    (outline,) = (
        collection
        for collection in axes.collections
        if isinstance(collection, ContourSet) and list(collection.levels) == [0]
    )
    x, y = outline.get_paths()[0].vertices.T * 1e-3
    contact = hertz(
        *(
            fields.attrs[name]
            for name in ("radius_x_m", "radius_y_m", "load_N", "reduced_modulus_Pa")
        )
    )
    distance = np.hypot(x / contact.semi_axis_x, y / contact.semi_axis_y) - 1
    spacing = float(np.diff(fields["y"])[0]) / contact.semi_axis_y
    assert np.abs(distance).max() < 0.1 * spacing


def test_signed_square_of_an_edge():
    """Where the pressure ends at full height the boundary is half-way to the next point."""
    pressure = np.array([[0.0, 0.0, 3.0, 3.0, 3.0, 0.0]] * 3)
    field = signed_square(pressure)
    assert np.all(field[:, 2:5] == 9)
    assert np.all(field[1, [1, 5]] == -9)


def test_pressures_share_one_scale_and_state_their_maxima(circle):
    figure = draw_pressure("case", circle)
    dry, oil = (axes.collections[0].levels for axes in figure.axes[:2])
    assert np.array_equal(dry, oil)
    assert np.sqrt(dry[-1]) >= 383.03
    assert "dry contact: at most 383 MPa" in texts(figure)
    assert "oil film: at most 371.5 MPa" in texts(figure)


def test_profiles_have_hertz_dashed(circle):
    figure = draw_profiles("case", circle)
    contact = hertz(12.5e-3, 12.5e-3, 15.0, 110e9)
    for axes in figure.axes[:2]:
        (dashed,) = (line for line in axes.lines if line.get_linestyle() == "--")
        assert max(dashed.get_ydata()) == pytest.approx(contact.pressure_max * 1e-6, rel=1e-4)
        loaded = np.asarray(dashed.get_xdata())[np.asarray(dashed.get_ydata()) > 0]
        assert loaded.max() == pytest.approx(contact.semi_axis_x * 1e3, rel=0.01)
    assert figure.axes[2].get_ylim() == pytest.approx((0, 3 * 0.213))


def test_streamlines_enter_evenly(circle):
    axes = draw_entrainment("case", circle).axes[0]
    segments = np.concatenate(
        [
            collection.get_segments()
            for collection in axes.collections
            if type(collection).__name__ == "LineCollection"
        ]
    )
    heights = np.unique(np.round(segments[:, :, 1], 6))
    assert heights.size == LINES
    assert np.ptp(np.diff(heights)) == pytest.approx(0, abs=3e-6)


@pytest.mark.filterwarnings("error")
def test_a_line_contact_has_profiles_and_a_history(tmp_path):
    solutions = (make_line_solution(), make_line_solution(converged=False))
    written = draw(Result("lines", {}, solutions, None, {}), tmp_path)
    expected = [f"scene_{i:03d}_{name}.png" for i in range(2) for name in LINE_NAMES]
    assert [path.name for path in written] == expected


def test_a_line_profile_has_hertz_dashed_and_shows_the_contact():
    solution = make_line_solution()
    figure = draw_line_profiles("roller", solution)
    contact = hertz_line(0.01, 183e3, 226e9)
    (dashed,) = (line for line in figure.axes[0].lines if line.get_linestyle() == "--")
    assert max(dashed.get_ydata()) == pytest.approx(contact.pressure_max * 1e-6, rel=1e-4)
    left, right = figure.axes[0].get_xlim()
    assert left < -contact.half_width * 1e3 and right > contact.half_width * 1e3
    assert figure.axes[1].get_ylim() == pytest.approx((0, 3 * 0.175))
    assert "roller  ·  line  ·  183 kN/m" in texts(figure)
    assert "33 points" in texts(draw_history("roller", solution))


@given(left=st.floats(-30, -0.1), width=st.floats(0.1, 60), angle=st.floats(0, 6.3))
def test_streamlines_start_inside_whatever_the_rounding(left, width, angle):
    x, y = left + np.linspace(0, width, 7), left / 3 + np.linspace(0, width / 3, 7)
    u, v = np.cos(angle) * np.ones((7, 7)), np.sin(angle) * np.ones((7, 7))
    points = inflow_points(x, y, u, v)
    assert np.all((points >= [x[0], y[0]]) & (points <= [x[-1], y[-1]]))
    assert np.all(points <= [x[0] + (x[-1] - x[0]), y[0] + (y[-1] - y[0])])


def test_interferogram_is_dark_without_a_film_and_grey_where_fringes_are_too_fine():
    axis = np.linspace(-1e-3, 1e-3, 21)
    window = Window(-1.0, 1.0, -1.0, 1.0)

    def light(film):
        fields = xr.Dataset({"film": (("y", "x"), film)}, coords={"x": axis, "y": axis})
        return interferogram(fields, window)

    flat = np.ones((21, 21))
    assert np.all(light(0 * flat) == 0)
    bright = light(0.532e-6 / 4 / 1.47 * flat)
    np.testing.assert_allclose(bright[..., 1], 1)
    np.testing.assert_allclose(light(flat * axis), 0.5, atol=1e-12)


def test_heading_names_case_phase_load_and_failure(worm):
    assert heading("case", worm) == "case  ·  phase 0.5  ·  14 kN"
    failed = make_solution(converged=False)
    assert heading("ball", failed) == (
        "ball  ·  circular  ·  15 N  ·  NOT CONVERGED (too many iterations)"
    )
    assert "NOT CONVERGED" in texts(draw_film("ball", failed))


def test_slender_windows_say_how_much_they_are_stretched(worm):
    assert contact_window(worm.fields).stretch == 2.0
    assert "y / mm  (stretched 2 times)" in texts(draw_film("case", worm))
    assert "stretched" not in texts(draw_film("case", make_solution()))
    assert Window(0, 1, 0, 20).stretch == 1 / 5


def test_tooth_outline_and_path_are_drawn_where_given(worm):
    tooth = xr.Dataset(
        {
            "tooth_outline_x": ("outline", np.array([-0.03, 0.03, 0.03, -0.03, -0.03])),
            "tooth_outline_y": ("outline", np.array([-0.01, -0.01, 0.002, 0.002, -0.01])),
            "contact_path_x": ("path", np.array([-0.01, 0.01])),
            "contact_path_y": ("path", np.array([-0.001, 0.001])),
        }
    )
    with_tooth = replace(worm, fields=worm.fields.merge(describe(tooth)))
    axes = draw_gap("case", with_tooth).axes[0]
    assert "path of contact" in [text.get_text() for text in axes.get_legend().get_texts()]
    left, right = axes.get_xlim()
    assert left < -30 < 30 < right
    assert "path of contact" not in texts(draw_gap("case", worm))


def test_mesh_cycle_without_solved_phases(tmp_path):
    result = Result("cycle", {}, (), make_mesh_cycle(), {})
    assert [path.name for path in draw(result, tmp_path)] == ["mesh_cycle.png"]
