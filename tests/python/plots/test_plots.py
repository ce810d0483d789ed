"""Pictures: all are drawn, and they show what their scales and outlines claim."""

import warnings
from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.image import imread
from matplotlib.quiver import Quiver
from matplotlib.text import Text
from synthetic_solution import (
    line_with_heat,
    make_hot_worm,
    make_line_solution,
    make_mesh_cycle,
    make_result,
    make_solution,
    make_worm_solution,
    with_heat,
    without_heat,
)

from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.formulas.regimes import Regime, regime_number
from pyworm.io.quantities import describe
from pyworm.plots.contact.across_film import draw_across_film
from pyworm.plots.contact.convergence import draw_history
from pyworm.plots.contact.entrainment import LINES, draw_entrainment, inflow_points
from pyworm.plots.contact.film import draw_film, interferogram
from pyworm.plots.contact.gap import draw_gap
from pyworm.plots.contact.line_profiles import (
    draw_line_friction,
    draw_line_profiles,
    draw_line_temperature,
)
from pyworm.plots.contact.maps import draw_friction, draw_pressure, draw_temperature
from pyworm.plots.contact.profiles import draw_profiles
from pyworm.plots.draw import draw
from pyworm.plots.drives.worm import draw_cycle
from pyworm.plots.error_bars import draw_figure, estimates_of
from pyworm.plots.layout import Window, contact_window, heading
from pyworm.plots.overlays import draw_tooth, signed_square
from pyworm.plots.regimes import draw_chart, draw_regimes, numbers_of
from pyworm.plots.traction import draw_traction
from pyworm.result.result import Result
from pyworm.solver.solution import Estimate

SCENE_NAMES = ["gap", "pressure", "film", "entrainment", "profiles", "history"]
LINE_NAMES = ["profiles", "history"]
HOTTEST = "maximum temperature\n$T_\\mathrm{max}$ / °C"
HEAT_NAMES = ["friction", "temperature", "across_film"]


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
    assert [path.name for path in written] == [*expected, "mesh_cycle.png", "regimes.png"]
    for path in written:
        pixels = imread(path)[..., :3]
        assert min(pixels.shape[:2]) > 400
        assert np.ptp(pixels) == 1.0
        assert np.unique(pixels @ [1.0, 300.0, 90000.0]).size > 20


def test_key_pictures_are_those_of_the_thinnest_converged_film(tmp_path):
    result = make_result()
    thick, thin = result.solutions
    figures = replace(thin.figures, film_min=Estimate(1e-7, 0.01))
    thin = replace(thin, converged=True, figures=figures)
    result = replace(result, solutions=(thick, thin))
    assert result.thinnest == 1
    written = [path.name for path in draw(result, tmp_path, key_only=True)]
    assert written == ["scene_001_film.png", "mesh_cycle.png", "regimes.png"]
    assert replace(result, solutions=(thick, replace(thin, converged=False))).thinnest == 0


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
    written = draw(Result("shape", {}, (with_heat(solution),), None, {}), tmp_path)
    assert len(written) == len([*SCENE_NAMES, *HEAT_NAMES, "regimes"])


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
    assert [path.name for path in written] == [*expected, "regimes.png"]


def test_contacts_stand_on_the_chart_of_their_kind():
    point, line = make_solution(), make_line_solution()
    figure = draw_regimes(Result("both", {}, (point, line), None, {}))
    for axes, solution in zip(figure.axes, (point, line), strict=True):
        way, dots = axes.lines
        place = solution.regime.moes_m, solution.regime.moes_l
        assert tuple(way.get_xydata()[0]) == tuple(dots.get_xydata()[0]) == place
    assert "circular contact" in texts(figure)
    legends = [[text.get_text() for text in axes.get_legend().get_texts()] for axes in figure.axes]
    assert [names[-1] for names in legends] == [point.regime.name, line.regime.name]
    assert "Hamrock and Dowson" in legends[0] and "Johnson and Hooke" in legends[1]


def test_a_contact_outside_the_published_chart_has_none_drawn():
    """Radii 1 : 30, entrained along the long axis: ellipticity 0.1."""
    solution = make_solution()
    along = replace(solution, regime=replace(solution.regime, ratio=30.0, angle=np.pi / 2))
    figure = draw_regimes(Result("along", {}, (along,), None, {}))
    words = "\n".join(text.get_text() for text in figure.axes[0].get_legend().get_texts())
    assert "no published chart: ellipticity 0.11, charted 1 to 8" in words
    assert "Hamrock" not in words
    assert "radii 1 : 30, entrained at 90° to the smaller one" in texts(figure)


@pytest.mark.parametrize("shape", [{}, {"ratio": 1.0, "angle": 0.0}, {"ratio": 20.0, "angle": 1.2}])
def test_the_chart_shades_the_regime_of_both_numbers(shape):
    axes = Figure().subplots()
    middle = Regime(1.0, 1.0, 0.1, 0.3, 20.0, 10.0, **shape)
    draw_chart(axes, middle, np.array([0.3, 300.0]), np.array([0.3, 30.0]))
    (shades,) = axes.images
    left, right, bottom, top = shades.get_extent()
    numbers = shades.get_array()
    assert set(np.unique(numbers)) == {0, 1, 2, 3}
    for row, column in np.random.default_rng(3).integers(1, len(numbers) - 1, (200, 2)):
        across = left + (right - left) * (column + 0.5) / numbers.shape[1]
        up = bottom + (top - bottom) * (row + 0.5) / numbers.shape[0]
        to_data = axes.transAxes + axes.transData.inverted()
        place = np.array(to_data.transform((across, up)))
        near = [np.array([place * (a, b)]).T for a in (0.95, 1.05) for b in (0.95, 1.05)]
        found = {int(regime_number(*numbers_of(middle)(m, el))[0]) for m, el in near}
        assert int(numbers[row, column]) in found


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
    assert "x / mm  (scales differ: y stretched 2 times)" in texts(draw_film("case", worm))
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


# -------------------------------------------------------------------------------------------- heat


@pytest.fixture(scope="module")
def hot():
    return make_hot_worm()


def arrows(axes):
    """Direction of each arrow on a panel: from x to y [rad]."""
    (quiver,) = (artist for artist in axes.collections if isinstance(artist, Quiver))
    return np.arctan2(quiver.V / axes.get_aspect(), quiver.U)


@pytest.mark.filterwarnings("error")
def test_only_what_was_simulated_is_drawn(tmp_path, monkeypatch, hot):
    monkeypatch.setattr("pyworm.plots.attempts.write", lambda figure, path: path)
    line = line_with_heat(make_line_solution())
    solutions = (hot, without_heat(hot), line, without_heat(line))
    written = draw(Result("hot", {}, solutions, None, {}), tmp_path)
    expected = [
        *(f"scene_000_{name}.png" for name in SCENE_NAMES + HEAT_NAMES),
        *(f"scene_001_{name}.png" for name in [*SCENE_NAMES, "friction"]),
        *(f"scene_002_{name}.png" for name in LINE_NAMES + HEAT_NAMES),
        *(f"scene_003_{name}.png" for name in [*LINE_NAMES, "friction"]),
        "regimes.png",
    ]
    assert [path.name for path in written] == expected


def test_temperatures_share_one_scale_and_state_their_maxima(hot):
    figure = draw_temperature("case", hot)
    levels = [axes.collections[0].levels for axes in figure.axes[:3]]
    assert np.array_equal(levels[0], levels[1]) and np.array_equal(levels[0], levels[2])
    hottest = float(hot.fields["temperature_middle"].max()) - 273.15
    assert levels[0][0] <= 60 and levels[0][-1] >= hottest
    assert f"film: at most {hottest:.1f} °C" in texts(figure)
    body = hot.figures.temperature_max_body_2.value - 273.15
    assert f"surface of body 2: at most {body:.1f} °C" in texts(figure)
    assert "temperature / °C" in texts(figure)
    (mark,) = (line for line in figure.axes[2].lines if line.get_marker() == "o")
    assert float(mark.get_xdata()[0]) == pytest.approx(1e3 * float(hot.profile["profile_x"]))


def test_arrows_follow_each_body_and_the_stress_on_the_first(hot):
    first, second = (arrows(axes) for axes in draw_temperature("case", hot).axes[:2])
    assert second == pytest.approx(np.arctan2(-1.1, -0.3))  # the velocity it was made with
    fields = hot.fields
    u1 = fields["entrainment_x"] + fields["sliding_x"] / 2
    v1 = fields["entrainment_y"] + fields["sliding_y"] / 2
    everywhere = np.arctan2(v1, u1)
    assert float(everywhere.min()) <= first.min() < first.max() <= float(everywhere.max())
    ball = with_heat(make_solution(), (2.5, 0.0), (1.5, 0.0), spin=0.0)
    stress = arrows(draw_friction("case", ball).axes[0])
    assert np.abs(stress) == pytest.approx(np.pi)  # against the faster body


def test_a_body_at_rest_has_no_arrows():
    still = with_heat(make_solution(), (2.0, 0.0), (1e-9, 0.0), spin=0.0)
    fields = still.fields.assign(
        entrainment_x=still.fields["entrainment_x"] * 0 + 1.0,
        sliding_x=still.fields["sliding_x"] * 0 + 2.0,
    )
    first, second = draw_temperature("case", replace(still, fields=fields)).axes[:2]
    assert arrows(first) == pytest.approx(0)
    assert arrows(second).size == 0


def test_slip_is_shown_where_there_is_some(hot):
    assert draw_friction("case", hot).axes[0].get_legend() is not None
    sticking = replace(hot, fields=hot.fields.assign(slip=0 * hot.fields["slip"]))
    assert draw_friction("case", sticking).axes[0].get_legend() is None


def test_friction_states_coefficient_and_loss(hot):
    figure = draw_friction("case", hot)
    assert f"friction coefficient {hot.figures.friction_coefficient.value:.3g}" in texts(figure)
    assert f"in all {hot.figures.power_loss.value:.3g} W" in texts(figure)
    strong = Estimate(2345.0, 0.01)
    loud = replace(hot, figures=replace(hot.figures, power_loss=strong))
    assert "in all 2.35 kW" in texts(draw_friction("case", loud))
    assert (
        float(hot.fields["friction_power"].max()) * 1e-6 <= figure.axes[1].collections[0].levels[-1]
    )


def test_a_uniform_temperature_is_drawn():
    cold = make_solution()
    warm = with_heat(cold, traction=0.0)
    assert draw_temperature("case", warm).axes[0].collections[0].levels[0] <= 60


def test_profiles_go_from_wall_to_wall(hot):
    figure = draw_across_film("case", hot)
    warm, fast = figure.axes
    height = warm.lines[0].get_ydata()
    film = float(hot.fields["film"].interp(x=hot.profile["profile_x"], y=hot.profile["profile_y"]))
    assert (height[0], height[-1]) == pytest.approx((0, film * 1e6))
    temperature = warm.lines[0].get_xdata()
    at = {"x": hot.profile["profile_x"], "y": hot.profile["profile_y"]}
    for end, name in ((0, "temperature_body_1"), (-1, "temperature_body_2")):
        assert temperature[end] == pytest.approx(float(hot.fields[name].interp(at)) - 273.15)
    assert [line.get_label() for line in fast.lines] == ["along x", "along y"]
    assert fast.lines[1].get_xdata()[-1] == -1.1
    (only,) = draw_across_film("case", line_with_heat(make_line_solution())).axes[1].lines
    assert (only.get_xdata()[0], only.get_xdata()[-1]) == pytest.approx((0.9, 0.1))


def test_a_line_contact_shows_its_heat():
    line = line_with_heat(make_line_solution())
    warm = draw_line_temperature("roller", line).axes[0]
    labels = [curve.get_label() for curve in warm.lines]
    assert labels == ["surface of body 1", "surface of body 2", "middle of the film", "inlet"]
    second = float(line.fields["temperature_body_2"].max()) - 273.15
    assert max(warm.lines[1].get_ydata()) == pytest.approx(second)
    stress, power = draw_line_friction("roller", line).axes
    assert min(stress.lines[0].get_ydata()) < -10
    largest = float(line.fields["friction_power"].max()) * 1e-6
    assert max(power.lines[0].get_ydata()) == pytest.approx(largest)


def test_the_cycle_shows_friction_and_temperatures_where_solved():
    hot = tuple(make_hot_worm(phase) for phase in (0.25, 0.75))
    figure = draw_cycle(Result("cycle", {}, hot, make_mesh_cycle(), {}))
    said = texts(figure)
    for label in ("friction\ncoefficient", "power loss\n$P$ / W", HOTTEST, "inlet"):
        assert label in said
    plain = draw_cycle(Result("cycle", {}, (make_worm_solution(),), make_mesh_cycle(), {}))
    assert "friction" not in texts(plain) and "temperature" not in texts(plain)
    sheared = tuple(without_heat(solution) for solution in hot)
    said = texts(draw_cycle(Result("cycle", {}, sheared, make_mesh_cycle(), {})))
    assert "power loss\n$P$ / W" in said and "temperature" not in said


def make_curve(ratios):
    """Friction that saturates, at these slide-roll ratios."""
    ball = make_solution(points=(33, 33))
    return tuple(
        replace(
            with_heat(
                ball, (2 + ratio, 0.0), (2 - ratio, 0.0), 0.0, 0.02 * np.tanh(abs(ratio) / 0.1)
            ),
            slide_roll_ratio=ratio,
        )
        for ratio in ratios
    )


def test_rounding_is_no_transmission_error():
    def drawn(error):
        cycle = make_mesh_cycle()
        cycle["transmission_error"] = cycle["transmission_error"] * 0 + error * (-1) ** np.arange(
            cycle.sizes["phase"]
        )
        return draw_cycle(Result("cycle", {}, (), cycle, {})).axes[0].get_ylim()

    assert drawn(1e-17) == (-0.01, 0.01)
    assert drawn(1e-6)[1] > 1.0


def test_a_traction_curve_has_the_sign_of_its_sliding_and_is_drawn_in_order():
    ratios = (0.5, -1.0, 0.1, -0.5)
    curve = make_curve(ratios)
    figure = draw_traction(Result("ball", {}, curve, None, {}))
    line = figure.axes[0].lines[0]
    assert list(line.get_xdata()) == sorted(ratios)
    size = [curve[ratios.index(of)].figures.friction_coefficient.value for of in sorted(ratios)]
    assert list(line.get_ydata()) == pytest.approx(np.sign(sorted(ratios)) * size)
    said = texts(figure)
    for label in ("slide-roll ratio", "friction coefficient", HOTTEST):
        assert label in said
    cold = tuple(without_heat(solution) for solution in curve)
    assert len(draw_traction(Result("ball", {}, cold, None, {})).axes) == 1
    assert "not converged" not in said
    failed = (replace(curve[0], converged=False), *curve[1:])
    assert "not converged" in texts(draw_traction(Result("ball", {}, failed, None, {})))


def test_only_a_sweep_whose_shear_was_simulated_is_a_traction_curve(tmp_path, monkeypatch):
    monkeypatch.setattr("pyworm.plots.attempts.write", lambda figure, path: path)
    monkeypatch.setattr("pyworm.plots.draw.SCENE_PICTURES", {"point": {}})
    curve = make_curve((0.1, 0.5))
    plain = tuple(replace(make_solution(points=(9, 9)), slide_roll_ratio=of) for of in (0.1, 0.5))
    single = tuple(replace(of, slide_roll_ratio=None) for of in curve)
    for solutions, names in ((curve, ["traction.png"]), (plain, []), (single, [])):
        written = draw(Result("ball", {}, solutions, None, {}), tmp_path)
        assert [path.name for path in written] == ["regimes.png", *names]


@pytest.mark.parametrize("half", [1.0, 30.0])
def test_sides_of_the_tooth_are_named_at_the_edges_of_a_panel_that_shows_a_part_of_it(half):
    """A tooth of 20 mm by 10 mm about the origin, its tip below."""
    corners = np.array([[-10, -5], [10, -5], [10, 5], [-10, 5], [-10, -5]]) * 1e-3
    outline = np.concatenate(
        [np.linspace(*side, 10, endpoint=False) for side in pairwise(corners)] + [corners[:1]]
    )
    places = np.linspace(-half, half, 3) * 1e-3
    fields = xr.Dataset(
        {
            "covered": (("x", "y"), np.ones((3, 3))),
            "tooth_outline_x": ("outline", outline[:, 0]),
            "tooth_outline_y": ("outline", outline[:, 1]),
        },
        {"x": places, "y": places},
    )
    axes = Figure().add_subplot(xlim=(-half, half), ylim=(-half, half))
    draw_tooth(axes, fields)
    named = {text.get_text(): text.get_position() for text in axes.texts}
    if half < 10:
        assert named["to the wheel's tip"] == (0.5, 0.03)
        assert named["to the wheel's root"] == (0.5, 0.97)
        assert named["to the leaving side"] == (0.99, 0.5)
        assert named["to the entering side"] == (0.01, 0.5)
    else:
        assert set(named) == {"tip", "root", "leaving side", "entering side"}


def test_a_figure_that_was_not_found_is_a_gap_without_error_bars():
    """Its rise may be none and its error without bound (drive 1 of seed 99013 of `tests/hard`)."""
    found, lost = (
        SimpleNamespace(
            figures=SimpleNamespace(temperature_max_film=Estimate(value, error)),
            converged=converged,
            rise=lambda estimate: estimate.value - 313.0,
        )
        for value, error, converged in ((353.0, 0.05, True), (313.0, np.inf, False))
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        draw_figure(Figure().subplots(), [0.1, 0.9], [found, lost], "temperature_max_film", {})
        _, values, sizes = estimates_of([found, lost], "temperature_max_film")
    np.testing.assert_array_equal(np.isnan([values, sizes]), [[False, True]] * 2)
    assert sizes[0] == pytest.approx(40.0)
