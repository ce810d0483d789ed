"""A new figure touches one file: an entry in the table of quantities shows it everywhere."""

import json
from dataclasses import replace
from io import StringIO

import pytest
from folders import CASES
from rich.console import Console
from source_copy import SourceCopy
from synthetic_solution import make_hot_worm, make_mesh_cycle

from pyworm.case.case import load
from pyworm.io.quantities import DECISIVE, QUANTITIES, SCALES, Quantity
from pyworm.plots.sweep import draw_sweep
from pyworm.report.console.scenes import figures_table
from pyworm.report.console.sweep import rows_table
from pyworm.report.explore.scenes import scene_rows
from pyworm.report.findings import findings
from pyworm.report.page.build import build_report
from pyworm.report.page.figures import key_result_rows
from pyworm.report.page.html import render
from pyworm.result.result import Result
from pyworm.result.sweep_result import SweepResult, sweep_table

CASE = load(CASES / "zi_sharif_2001.toml")

SQUEEZED = Quantity(
    "pressure_by_film", "Pa/m", "maximum pressure over film thickness", "MPa/µm", "p/h",
    lambda one: one.figures.pressure_max / one.figures.film_min,
    key="pressure_by_film_Pa_m", places=DECISIVE, extreme="maximum",
)  # fmt: skip


@pytest.fixture(autouse=True)
def entry(monkeypatch):
    """The made-up figure in the one table, with its unit."""
    monkeypatch.setitem(QUANTITIES, SQUEEZED.name, SQUEEZED)
    monkeypatch.setitem(SCALES, "MPa/µm", 1e-12)


def value(solution):
    return solution.figures.pressure_max.value / solution.figures.film_min.value


def test_summary_and_table_of_a_contact_have_it():
    solution = make_hot_worm(0.5)
    summary = solution.summary()
    assert summary["pressure_by_film_Pa_m"] == pytest.approx(value(solution))
    bars = solution.figures.pressure_max.error + solution.figures.film_min.error
    assert summary["pressure_by_film_error"] == pytest.approx(bars, rel=0.5)
    console = Console(file=StringIO(), width=120)
    console.print(figures_table(CASE.scene(0.5), summary, {}))
    (row,) = (line for line in console.file.getvalue().splitlines() if SQUEEZED.title() in line)
    assert f"{value(solution) * 1e-12:.4g} MPa/µm ± " in row


@pytest.mark.usefixtures("undrawn")
def test_the_pages_have_it():
    solutions = tuple(make_hot_worm(phase) for phase in (0.25, 0.5))
    result = Result(CASE.name, CASE.resolved, solutions, make_mesh_cycle(), {})
    page = render(build_report(result))
    worst = max(map(value, solutions)) * 1e-12
    assert page.count(SQUEEZED.title()) >= 2  # key results, and of every contact
    assert f"{worst:.4g} MPa/µm" in page
    rows = dict(scene_rows(solutions[0], ("worm", "wheel")))
    assert rows[SQUEEZED.title()].startswith(f"{value(solutions[0]) * 1e-12:.4g} MPa/µm ± ")


def test_the_worst_contact_decides():
    thin, thick = make_hot_worm(0.25), make_hot_worm(0.5)
    twice = replace(thick.figures, film_min=2 * thick.figures.film_min)
    solutions = thin, replace(thick, figures=twice)
    for order in (solutions, solutions[::-1]):
        result = Result(CASE.name, CASE.resolved, order, make_mesh_cycle(), {})
        rows = {label: where for label, _, where in key_result_rows(findings(result))}
        assert rows["Minimum film thickness"] == rows[SQUEEZED.title()] == "phase 0.25"


def test_table_and_picture_of_a_sweep_have_it():
    summaries = [make_hot_worm(phase).summary() for phase in (0.25, 0.5, 0.75)]
    values = [{"contact.load": f"{load} N"} for load in (1, 2, 3)]
    table = sweep_table(values, summaries, ["a", "b", "c"])
    swept = SweepResult("s", "loads", [["contact.load"]], table, {})
    column = rows_table(swept).head.index("p/h\nMPa/µm")
    first = summaries[0]["pressure_by_film_Pa_m"] * 1e-12
    assert rows_table(swept).column(column)[0] == f"{first:.4g}"
    panels = {axes.get_ylabel(): axes for axes in draw_sweep(swept).axes}
    panel = panels["maximum pressure over film thickness $p/h$ / (MPa/µm)"]
    assert panel.lines[0].get_ydata()[0] == pytest.approx(first)


ENTRY = """\
    Quantity(
        "pressure_by_film", "Pa/m", "maximum pressure over film thickness", "MPa/µm", "p/h",
        lambda one: one.figures.pressure_max / one.figures.film_min,
        key="pressure_by_film_Pa_m", places=DECISIVE, extreme="maximum",
    ),
"""


def test_one_file_takes_it_from_a_case_file_to_its_results(tmp_path):
    table = "pyworm/io/quantities.py"
    copy = SourceCopy.in_folder(tmp_path)
    copy.insert(table, ')  # fmt: skip\n"""Figures of one contact', ENTRY)
    copy.insert(table, '"°C": 1.0, ', '"MPa/µm": 1e-12, ')
    assert copy.changed() == {table}
    case = "cases/line_m20_l10.toml"
    said = json.loads(copy.pyworm("run", case, "--json", "--accuracy", "5%", "--out", "out"))
    (scene,) = said["scenes"]
    found = scene["pressure_by_film_Pa_m"]
    assert found == pytest.approx(scene["pressure_max_Pa"] / scene["film_min_m"])
    assert scene["pressure_by_film_error"] > 0
    copy.pyworm("report", "out/result.nc", "--out", "report.html")
    page = (tmp_path / "report.html").read_text()
    assert SQUEEZED.title() in page and f"{found * 1e-12:.4g} MPa/µm" in page
