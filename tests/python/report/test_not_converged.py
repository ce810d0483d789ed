"""What did not converge is told as such, and nothing simulated of it is shown as a figure."""

import json
import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from folders import CASES, DATA
from matplotlib.axes import Axes
from swept_cycle import cycle_result
from synthetic_solution import make_hot_worm, make_line_solution, make_mesh_cycle, make_solution

import pyworm
from pyworm.cli.main import main
from pyworm.plots.contact.film import draw_film
from pyworm.plots.drives.worm import draw_cycle
from pyworm.plots.drives.worm_flank import draw_flank
from pyworm.plots.layout import heading
from pyworm.ratings.rated_case import rating_request, ratings
from pyworm.report.findings import findings
from pyworm.report.page.build import build_report
from pyworm.report.page.figures import key_result_rows
from pyworm.result.flank_map import flank_map
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result
from pyworm.solver.ending import Ending
from pyworm.solver.grid_sequence import GridSequence
from pyworm.solver.stop_reason import CURE, rests_on_edge

REASON = "the residual stayed at 5.0e+02, 1.0e-05 is required" + CURE
PHASES = (0.1, 0.3, 0.5, 0.7, 0.9)


def failed(solution):
    """A solution as the solver leaves it where Newton's method fails: films below zero, bars without end."""
    figures = solution.figures
    worse = {
        name: replace(getattr(figures, name), value=value, grid=np.inf)
        for name, value in {
            "film_min": -7.77e-6,
            "film_central": -8.88e-6,
            "pressure_max": 4.444e9,
            "friction_coefficient": 25.0,
            "power_loss": 9e6,
            "temperature_max_film": 5555.0,
        }.items()
    }
    figures = replace(figures, **worse)
    return replace(
        solution, figures=figures, converged=False, ending=Ending.NO_FILM, stop_reason=REASON
    )


@pytest.fixture(scope="module")
def case():
    return pyworm.load(CASES / "zi_sharif_2001.toml")


def result(case, bad=(0.9,)):
    rough = [replace(make_hot_worm(phase), composite_roughness=0.583e-6) for phase in PHASES]
    solutions = tuple(failed(one) if one.phase in bad else one for one in rough)
    return Result(case.name, case.resolved, solutions, make_mesh_cycle(), {})


@pytest.fixture(scope="module")
def torn(case):
    """Five phases of which the last did not converge."""
    return result(case)


def drawn(axes: Axes) -> np.ndarray:
    """All heights of curves of a panel, but those across the whole of it."""
    curves = [line for line in axes.lines if line.get_transform() == axes.transData]
    return np.concatenate([np.asarray(line.get_ydata(), float) for line in curves])


def test_a_negative_film_is_rated_as_if_it_were_not_there(case, torn):
    """Means, the thinnest film and its lubrication are those of the phases that converged."""
    good = replace(torn, solutions=torn.solutions[:-1])
    built, expected = (ratings(rating_request(case), of) for of in (torn, good))
    assert [one.summary() for one in built] == [one.summary() for one in expected]
    assert built[0].summary()["simulation"]["specific_film"] > 0


def test_the_efficiency_of_report_and_rating_names_the_phase_that_it_lacks(case, torn):
    missing = "1 of 5 contacts missing: worm 0.9"
    key_results = key_result_rows(findings(torn, case))
    (line,) = (row for row in key_results if "Efficiency" in row[0])
    assert line[2].endswith(missing)
    labels = [of.label for of in ratings(rating_request(case), torn)[0].figures]
    assert f"Efficiency, worm driving (simulation: {missing})" in labels


def test_without_a_converged_phase_only_closed_forms_are_rated(case):
    nothing = result(case, bad=PHASES)
    worm, films = ratings(rating_request(case), nothing)[:2]
    assert worm.columns == ("standard",)
    assert "simulated_m" not in films.summary()["minimum film"]


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("bad", [(0.9,), PHASES], ids=["one", "all"])
def test_rate_and_report_name_it_and_succeed(case, tmp_path, monkeypatch, capsys, bad):
    monkeypatch.chdir(tmp_path)
    path = result(case, bad).save("result.nc")
    command = ["rate", str(CASES / "zi_sharif_2001.toml"), "--result", str(path)]
    assert main([*command, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["not_converged"]
    assert len(told) == len(bad) and told[-1].startswith("phase 0.9 did not converge")
    assert "tip relief" in told[-1]
    assert main(command) == 0
    assert "-7.77" not in capsys.readouterr().out.replace("\n", " ")
    assert main(["report", str(path)]) == 0
    page = re.sub(r'data:image[^"]*', "", Path("report.html").read_text())
    assert page.count("did not converge: the residual stayed at 5.0e+02") == len(bad)
    for nonsense in ("-7.77", "-13.3", "-8.88", "4444", "5282", "inf %"):
        assert nonsense not in page, nonsense


@pytest.mark.usefixtures("undrawn")
def test_the_report_shows_a_gap_where_figures_would_be(case, torn):
    report = build_report(torn)
    sections = {section.title: section for section in report.sections}
    rows = {row[0]: row for row in sections["Film and pressure"].blocks[0].rows}
    assert rows["phase 0.9"][-1].startswith("NO: ") and rows["phase 0.5"][-1] == "yes"
    assert sum(cell == "" for cell in rows["phase 0.9"]) > 3
    assert any("phase 0.9 did not converge" in warning for warning in report.warnings)


def test_curves_and_scales_have_gaps_where_a_phase_did_not_converge(torn):
    figure = draw_cycle(torn)
    for axes in figure.axes:
        if axes.get_ylabel().startswith(("film", "largest", "friction", "power")):
            heights = drawn(axes)
            assert np.nanmin(heights) >= 0 and np.nanmax(heights) < 3000
            assert np.abs(axes.get_ylim()).max() < 4000
    legends = [
        text.get_text()
        for axes in figure.axes
        if axes.get_legend()
        for text in axes.get_legend().get_texts()
    ]
    assert "not converged: 0.9" in legends
    gaps = [line for axes in figure.axes for line in axes.lines if line.get_linestyle() == ":"]
    assert any(list(line.get_xdata()) == [0.9, 0.9] for line in gaps)


def test_a_cycle_without_any_converged_phase_is_drawn(case):
    draw_cycle(result(case, bad=PHASES))


def test_the_film_of_what_did_not_converge_has_no_circle():
    good = make_solution(edge=0.1e-3, phase=0.5)
    bad = replace(good, converged=False, ending=Ending.NO_FILM, stop_reason=REASON)
    circles = [
        [
            line
            for axes in draw_film("case", one).axes
            for line in axes.lines
            if line.get_marker() == "o"
        ]
        for one in (good, bad)
    ]
    assert len(circles[0]) == 1 and not circles[1]
    assert "NOT CONVERGED (the residual stayed at 5.0e+02, 1.0e-05 is required)" in heading(
        "case", bad
    )


@pytest.mark.long
def test_the_flank_map_is_not_blended_across_a_phase_that_failed():
    """Between its neighbours the contact passes over places that no phase that converged touches."""
    whole = cycle_result((0.0, 0.25, 0.5, 0.75, 1.0))
    torn = replace(
        whole,
        solutions=tuple(failed(one) if one.phase == 0.5 else one for one in whole.solutions),
    )
    passed = [int(np.isfinite(flank_map(of)["pressure"]).sum()) for of in (whole, torn)]
    assert passed[1] < 0.9 * passed[0]
    assert float(flank_map(torn)["film"].min()) > 0
    title = draw_flank(torn).get_suptitle()
    assert "phase 0.5 not converged, not shown" in title


def test_extremes_of_the_cycle_leave_out_what_did_not_converge():
    whole = cycle_result(PHASES)
    torn = replace(
        whole,
        solutions=tuple(failed(one) if one.phase == 0.5 else one for one in whole.solutions),
    )
    cycle = drive_cycle(torn)
    assert cycle.unconverged == (0.5,)
    assert cycle.film_min.value > 0 and cycle.pressure_max.value < 4e9


def test_no_lambda_is_given_where_a_film_did_not_converge(torn):
    told = [one.summary() for one in torn.solutions]
    assert all("specific_film" in one for one in told[:-1]) and "specific_film" not in told[-1]


@pytest.mark.parametrize("kind", ["point", "line"])
def test_a_load_on_a_sharp_edge_is_distinguished_from_one_within_the_surfaces(kind):
    x = np.linspace(-1, 1, 41)
    hertz = np.sqrt(np.maximum(1 - (x / 0.6) ** 2, 0))
    fields = {
        "point": lambda covered: xr.Dataset(
            {
                "covered": (("x", "y"), np.repeat(covered[:, None], 5, axis=1)),
                "dry_pressure": (("x", "y"), np.repeat((hertz * covered)[:, None], 5, axis=1)),
            }
        ),
        "line": lambda covered: xr.Dataset(
            {"covered": ("x", covered), "pressure": ("x", hertz * covered)}
        ),
    }[kind]
    assert not rests_on_edge(fields(np.ones(41, int)))
    assert not rests_on_edge(fields((x < 0.7).astype(int)))
    assert rests_on_edge(fields((x < 0.3).astype(int)))
    assert not rests_on_edge(make_line_solution().fields)


@pytest.mark.parametrize(
    ("lost", "found", "edge", "most"),
    [(2, 1, 0.3, 2), (1, 1, 0.3, 3), (2, 0, 0.3, 3), (2, 1, 0.7, 3)],
)
def test_a_film_lost_on_a_sharp_edge_is_sought_on_fewer_grids(lost, found, edge, most):
    """Only where a coarser grid had it, and the load does rest on the edge."""
    x = np.linspace(-1, 1, 41)
    pressure = np.sqrt(np.maximum(1 - (x / 0.6) ** 2, 0)) * (x < edge)
    fields = xr.Dataset({"covered": ("x", (x < edge).astype(int)), "pressure": ("x", pressure)})
    sequence = object.__new__(GridSequence)
    sequence._unconverged, sequence._readings, sequence._level = lost, ["found"] * found, None
    sequence._solver = SimpleNamespace(outcome=lambda level: SimpleNamespace(fields=fields))
    assert sequence._max_unconverged == most


def test_the_solver_says_that_a_sharp_edge_is_the_cause():
    """The contact runs out over the worm's sharp tip there; a few grids tell it, and cost little."""
    case = pyworm.load(DATA / "zi_a100.toml")
    scene = case.scene(phase=0.9)
    plan = pyworm.plan(scene, accuracy=0.5, effects="isothermal")
    solution = pyworm.solve(scene, replace(plan, largest_grid=plan.grids[-1].nodes))
    assert not solution.converged
    assert solution.stop_reason.endswith(CURE) and "tip relief" in CURE
