"""Work-precision studies: limits, models, the choice of the cheapest, the expected cost, the command."""

import csv
import json
from itertools import pairwise
from math import inf, isclose
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.planning.effects.selection import chosen
from pyworm.planning.expected_work import Stage, Work, expected_work, first_change
from pyworm.planning.model import Model
from pyworm.plots.precision import COLOURS, FORMULA_MARKERS
from pyworm.precision.extrapolation import limit, observed_order
from pyworm.precision.grid_series import Point, converged_row
from pyworm.precision.models import fidelities
from pyworm.precision.study import Curve, Reference, Study
from pyworm.precision.survey import BudgetError, closed_forms, study
from pyworm.solver.cost import calibration
from pyworm.solver.cost.calibration import Calibration, Pace

CASES = Path("cases")
LINE = CASES / "line_m20_l10.toml"


def scene(name, **place):
    return pyworm.load(CASES / f"{name}.toml").scene(**place)


# ------------------------------------------------------------------------------------------- limits


@given(
    value=st.floats(0.5, 2.0),
    error=st.floats(-0.3, 0.3).filter(lambda error: abs(error) > 1e-3),
    order=st.floats(1.0, 2.0),
    grids=st.integers(3, 6),
)
def test_a_series_of_one_order_is_extrapolated_to_its_limit(value, error, order, grids):
    values = [value + error * 2 ** (-order * grid) for grid in range(grids)]
    found = limit(values)
    assert found.value == pytest.approx(value, abs=1e-9)
    assert found.order == pytest.approx(order, abs=1e-6)
    assert abs(found.value - value) <= found.error


@given(
    second=st.floats(-0.2, 0.2).filter(lambda part: abs(part) > 1e-2),
    third=st.floats(-0.05, 0.05),
)
def test_the_error_of_a_limit_covers_a_series_with_a_further_term(second, third):
    values = [1 + second * 4.0**-grid + third * 8.0**-grid for grid in range(5)]
    assert abs(limit(values).value - 1) <= 3 * limit(values).error


def test_one_grid_has_no_limit_and_standing_changes_no_order():
    assert limit([1.0]).error == inf
    assert observed_order([1.0, 2.0, 3.0]) is None
    assert observed_order([1.0, 2.0, 1.5]) is None
    assert limit([1.0, 2.0, 3.0]).error >= 1 / 3


# ----------------------------------------------------------------------------------------- models


def test_a_heated_sliding_contact_has_every_model():
    models, lacking = fidelities(scene("traction_steel", slide_roll_ratio=0.5))
    assert [model.name for model in models] == [
        "line contact",
        "isothermal Newtonian point",
        "+ rheology",
        "+ surface heat",
        "+ film heat",
    ]
    assert not lacking
    assert [model.plan.model.heated for model in models] == [False, False, False, True, True]
    assert models[-1].plan.on == chosen(scene("traction_steel", slide_roll_ratio=0.5), ("all",))


def test_rough_surfaces_are_the_last_model_and_every_model_has_a_colour():
    models, _ = fidelities(scene("spur_pair", phase=0.2))
    assert models[-1].name == "+ roughness" and models[-1].plan.model.rough
    assert not any(model.plan.model.rough for model in models[:-1])
    assert {model.name for model in models} <= COLOURS.keys()


def test_every_formula_of_a_heated_point_contact_has_a_marker():
    assert 5 < len(closed_forms(scene("ball_pag_460"))) <= len(set(FORMULA_MARKERS))


def test_models_that_a_contact_does_not_have_are_listed_with_reasons():
    models, lacking = fidelities(scene("ellipse10_oblique"))
    assert [model.name for model in models] == ["isothermal Newtonian point"]
    assert "one axis" in lacking["line contact"]
    models, _ = fidelities(scene("line_thermal"))
    assert models[0].name == "isothermal Newtonian line"


# ----------------------------------------------------------------------------- errors and the cheapest


def a_point(seconds, film, converged=True):
    return Point((int(seconds * 100),), seconds, 1.0, {"film_min": film}, converged)


def a_study(*curves, band=0.0):
    return Study("a contact", None, {"film_min": Reference(1.0, 1.0, band)}, curves, (), 1.0)


def on_grids(name, *points):
    points = tuple(a_point(*point) for point in points)
    return Curve(
        name, "model", points, {"film_min": limit([p.figures["film_min"] for p in points])}
    )


GOOD = on_grids("good", (1.0, 1.16), (4.0, 1.04), (16.0, 1.01))
SIMPLE = on_grids("simple", (0.1, 1.23), (0.4, 1.08), (1.6, 1.0425))


def test_what_is_left_of_an_error_is_split_into_model_and_grid():
    built = a_study(GOOD, SIMPLE)
    assert built.model_error(GOOD, "film_min") == pytest.approx(0.0, abs=1e-12)
    assert built.model_error(SIMPLE, "film_min") == pytest.approx(0.03)
    assert built.grid_error(SIMPLE, SIMPLE.points[0], "film_min") == pytest.approx(0.2)
    assert built.error(SIMPLE.points[0], "film_min") == pytest.approx(0.23)


@pytest.mark.parametrize(
    ("accuracy", "band", "name", "seconds"),
    [
        (0.1, 0.0, "simple", 0.4),
        (0.041, 0.0, "good", 4.0),
        (0.041, 0.005, "good", 16.0),  # what is not known of the reference counts
    ],
)
def test_the_cheapest_model_and_grid(accuracy, band, name, seconds):
    curve, point = a_study(GOOD, SIMPLE, band=band).cheapest(accuracy, ("film_min",))
    assert (curve.name, point.seconds) == (name, seconds)


def test_no_model_is_accurate_enough():
    assert a_study(GOOD, SIMPLE).cheapest(1e-3, ("film_min",)) is None


def test_a_grid_that_is_right_by_chance_is_not_the_cheapest():
    lucky = on_grids("lucky", (0.1, 1.0), (0.2, 1.3), (0.3, 1.4))
    curve, _ = a_study(lucky, GOOD).cheapest(0.05, ("film_min",))
    assert curve.name == "good"


@pytest.mark.parametrize(
    ("converged", "row"),
    [
        ((True, True, True), (0, 1, 2)),
        ((True, False, True, True), (2, 3)),
        ((False, True, True, False), (1, 2)),
        ((False, False), ()),
    ],
)
def test_limits_are_of_the_finest_consecutive_converged_grids(converged, row):
    points = [a_point(1.0 + number, 1.0, one) for number, one in enumerate(converged)]
    assert converged_row(points) == [points[number] for number in row]


def test_unconverged_points_and_numerical_parameters_are_not_offered():
    unsettled = Curve("unsettled", "model", (a_point(0.1, 1.0, converged=False),), {})
    parameter = Curve("parameter", "parameter", (a_point(0.1, 1.0),), {})
    curve, _ = a_study(unsettled, parameter, GOOD).cheapest(0.05, ("film_min",))
    assert curve.name == "good"


# ---------------------------------------------------------------------------------- a study of a line


@pytest.fixture(scope="module")
def of_a_line():
    return study(scene("line_m20_l10"), budget=20.0)


def test_a_reference_agrees_with_a_solve_of_its_own(of_a_line):
    contact = scene("line_m20_l10")
    solved = pyworm.solve(contact, pyworm.plan(contact, 1e-3, "all")).figures
    for name, reference in of_a_line.references.items():
        bar = getattr(solved, name)
        assert abs(bar.value / reference.value - 1) <= bar.error + reference.band


def test_grids_of_a_line_come_near_at_second_order_and_cost_more(of_a_line):
    (complete,) = [curve for curve in of_a_line.curves if curve.kind == "model"]
    assert 1.7 <= complete.limits["film_central"].order <= 2.3
    seconds = [point.seconds for point in complete.points]
    assert seconds == sorted(seconds)
    # what is left at the end of the window, 1e-4, hides the grid's error from the fourth grid on
    errors = [
        of_a_line.grid_error(complete, point, "film_central") for point in complete.points[:4]
    ]
    assert all(3 <= first / second <= 5 for first, second in pairwise(errors))
    left = [of_a_line.limit_error(point, "film_central") for point in complete.points[1:4]]
    assert all(error < 2e-4 for error in left)
    assert of_a_line.limit_error(complete.points[0], "film_central") is None


def test_formulas_stand_beside_the_models(of_a_line):
    formulas = {
        curve.name: curve.points[0] for curve in of_a_line.curves if curve.kind == "formula"
    }
    # compressible oil; the formula was fitted to incompressible ones and is within some percent
    assert of_a_line.error(formulas["Moes"], "film_central") < 0.25
    assert "film_min" not in formulas["Dowson-Toyoda"].figures


def test_numerical_parameters_have_lines_of_their_own(of_a_line):
    names = [curve.name for curve in of_a_line.curves if curve.kind == "parameter"]
    assert any("domain" in name for name in names) and any("tolerance" in name for name in names)


def test_a_budget_that_leaves_no_reference_names_a_sufficient_one():
    with pytest.raises(BudgetError, match="3 grids of the most complete model"):
        study(scene("point_m100_l10"), budget=1e-6)


# ---------------------------------------------------------------------------------------- expected cost


def test_more_accuracy_is_more_work():
    def finest(accuracy):
        return expected_work("point", [[1e4]], 0.1, accuracy, 1e7, full=False).finest

    grids = [finest(accuracy) for accuracy in (0.1, 0.03, 0.01, 0.003, 0.001)]
    assert all(one < other for one, other in pairwise(grids))
    # at second order four times the accuracy takes four times the nodes, of extrapolated figures fewer
    assert 2.0 < finest(0.0005) / finest(0.002) < 4.0


def test_no_work_is_expected_beyond_the_largest_grid():
    work = expected_work("point", [[1e4]], 1.0, 1e-5, 2e5, full=False)
    assert work.finest == pytest.approx(2e5)


def test_the_first_change_is_of_the_direction_that_is_resolved_less():
    known = {"half_widths": (1e-4, 1e-3), "radii": (1e-2, 1e-2), "film": 1e-6, "moes_l": 10.0}
    both = first_change(spacing=(1e-5, 1e-5), **known)
    assert both == pytest.approx(first_change(spacing=(1e-7, 1e-5), **known))
    assert first_change(spacing=(1e-5, 5e-6), **known) < both


PACE = Pace(step=0.1, step_node=1e-3, grid=1.0, grid_node=1e-2)
FULL = (Pace(0.2, 2e-3, 1.0, 1e-2), Pace(0.4, 6e-3, 2.0, 3e-2))


def a_calibration():
    kinds = ("point", "line")
    return Calibration(
        dict.fromkeys(kinds, PACE),
        dict.fromkeys(kinds, FULL),
        dict.fromkeys(kinds, FULL),
        dict.fromkeys(kinds, ((100.0, 1.0), (400.0, 4.0))),
    )


def test_seconds_are_entries_and_steps():
    work = Work("point", (Stage(100.0, 3.0, 0.0), Stage(200.0, 1.0, 2.0)))
    cold = (1.0 + 100e-2) + 3 * (0.1 + 0.1) + 1 * (0.1 + 0.2)
    full = (1.5 + 200 * 2e-2) + 2 * (0.3 + 200 * 4e-3)  # seven levels, between five and nine
    assert a_calibration().seconds(work, Model(7, True)) == pytest.approx(cold + full)
    assert a_calibration().convolution("point", 1600.0) == pytest.approx(16.0)


def test_the_time_of_a_step_follows_from_two_grids():
    few, many = ((n, PACE.entry(n), PACE.steps(1, n)) for n in (100.0, 900.0))
    found = Pace.by(few, many)
    assert all(
        isclose(getattr(found, name), getattr(PACE, name))
        for name in ("step", "step_node", "grid", "grid_node")
    )


def test_a_machine_is_measured_once(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    measured = []
    monkeypatch.setattr(calibration, "calibrate", lambda: measured.append(1) or a_calibration())
    assert calibration.calibration() == calibration.calibration() == a_calibration()
    assert len(measured) == 1
    (kept,) = (tmp_path / "pyworm").iterdir()
    kept.write_text("{torn")
    assert calibration.calibration() == a_calibration()
    assert len(measured) == 2


# ------------------------------------------------------------------------------------------ the command


def test_the_command_leaves_table_and_picture(tmp_path, capsys):
    assert main(["precision", str(LINE), "--budget", "5", "--out", str(tmp_path), "--json"]) == 0
    told = capsys.readouterr()
    content = json.loads(told.out)
    assert "without a budget" in told.err
    assert json.loads((tmp_path / "precision.json").read_text()) == content
    with (tmp_path / "precision.csv").open() as file:
        table = list(csv.DictReader(file))
    assert len(table) == len(content["points"])
    first = next(row for row in table if row["kind"] == "rung")
    reference = content["references"]["film_min_m"]["value"]
    assert float(first["film_min_error"]) == pytest.approx(
        abs(float(first["film_min_m"]) / reference - 1)
    )
    assert (tmp_path / "precision.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "precision.svg").read_text()
    assert [one["accuracy"] for one in content["cheapest"]] == [0.1, 0.05, 0.01, 0.001]


@pytest.mark.parametrize("budget", ["0", "-3", "soon"])
def test_a_budget_is_a_time(budget, tmp_path, capsys):
    out = tmp_path / "out"
    with pytest.raises(SystemExit) as ended:
        main(["precision", str(LINE), f"--budget={budget}", "--out", str(out)])
    assert ended.value.code == BAD_INPUT
    assert "number of seconds above 0" in capsys.readouterr().err
    assert not out.exists()


def test_a_budget_too_small_is_refused_in_one_sentence(tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["precision", str(LINE), "--budget", "1e-6", "--out", str(out)]) == BAD_INPUT
    assert "--budget 1e-06" in capsys.readouterr().err
    assert not out.exists()


def test_check_shows_the_expected_time(capsys):
    assert main(["check", str(LINE), "--json"]) == 0
    (contact,) = json.loads(capsys.readouterr().out)["scenes"]
    assert np.isfinite(contact["expected_seconds"]) and contact["expected_seconds"] > 0
