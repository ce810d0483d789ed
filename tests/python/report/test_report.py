"""`pyworm report`: one page that needs nothing else, says what the result says, and marks what is wrong."""

import json
import re
from base64 import b64decode
from dataclasses import replace
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from folders import CASES
from hypothesis import given, settings
from hypothesis import strategies as st
from refusals import refusal
from synthetic_solution import (
    line_with_heat,
    make_hot_worm,
    make_line_solution,
    make_mesh_cycle,
    make_solution,
)
from undrawn_pages import undrawn_pages
from zi_drives import quickly_described

import pyworm
from pyworm.case.case import case_again
from pyworm.cli.main import main
from pyworm.formulas.film import chittenden
from pyworm.io.input_error import CaseError
from pyworm.materials.viscosity_density import Barus
from pyworm.planning.effects.judgement import Judgement
from pyworm.report.page.assumptions import plan_section
from pyworm.report.page.build import build_report
from pyworm.report.page.content import Picture
from pyworm.report.page.html import render
from pyworm.report.page.sensitivity import sensitivity, thickened
from pyworm.report.table import Table
from pyworm.result.result import Result
from pyworm.scene.scales import scales

SECTIONS = [
    "Key results",
    "Film and pressure",
    "Friction, loss and temperature",
    "Ratings: gears, scuffing, bearings",
    "Comparison with published values",
    "Sensitivity",
    "The whole cycle",
    "Contacts",
    "What was assumed",
    "Effects simulated and neglected (requested accuracy: 2 %)",
    "Inputs",
    "Provenance",
]

EFFECTS = (
    Judgement("film-heating", True, 0.3, {"film": 1.7, "friction": 0.4}, "more than 2 %"),
    Judgement("squeeze", False, 0.02, {"film": 0.024, "friction": 0.01}, "not simulated"),
)


def result_of(name, solutions, mesh_cycle=None, **provenance):
    case = pyworm.load(CASES / f"{name}.toml")
    said = {"pyworm": pyworm.__version__, "plans": [{"accuracy": 0.02}], **provenance}
    return Result(case.name, case.resolved, tuple(solutions), mesh_cycle, said)


def worm_result(**changes):
    known = {"effects": EFFECTS, "composite_roughness": 0.34**0.5 * 1e-6}
    solutions = [replace(make_hot_worm(p, **changes), **known) for p in (0.25, 0.5)]
    return result_of("zi_sharif_2001", solutions, make_mesh_cycle())


@pytest.fixture(scope="module")
def worm():
    result = worm_result()
    return result, build_report(result)


@pytest.fixture(scope="module")
def increaser():
    case = pyworm.load(CASES / "errichello_speed_increaser.toml")
    solutions = [
        line_with_heat(make_line_solution(load=1582e3, film_central=60e-9, phase=phase))
        for phase in (0.13, 0.87)
    ]
    result = result_of("errichello_speed_increaser", solutions, case.drive.cycle_data())
    with undrawn_pages():
        return result, build_report(result)


def section(report, title):
    return next(one for one in report.sections if one.title == title)


def rows(report, title, table=0):
    tables = [block for block in section(report, title).blocks if isinstance(block, Table)]
    return {row[0].strip(): row[1:] for row in tables[table].rows}


def words(report, title):
    """All text of a section."""
    parts = []
    for block in section(report, title).blocks:
        parts += [block] if isinstance(block, str) else block if isinstance(block, tuple) else ()
        parts += [getattr(block, name) for name in ("note", "caption") if hasattr(block, name)]
        parts += [block.title] if isinstance(block, Table) else []
        parts += [cell for row in getattr(block, "rows", ()) for cell in row]
    return "\n".join(parts)


# ------------------------------------------------------------------------------------- the page


class Page(HTMLParser):
    """Tags, what they refer to, and whether each is closed."""

    VOID = ("meta", "img")

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.sources = set(), [], []
        self.anchors, self.ids = set(), set()
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.tags.add(tag)
        if tag not in self.VOID:
            self.open.append(tag)
        self.sources += [attrs[key] for key in ("src", "href") if key in attrs]
        self.ids.add(attrs.get("id"))
        if tag == "img":
            assert attrs["alt"]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_the_page_needs_nothing_else(worm):
    text = render(worm[1])
    page = Page(text)
    assert page.open == []
    assert not page.tags & {"script", "link", "iframe", "object"}
    assert "@import" not in text and "url(" not in text
    pictures = [source for source in page.sources if not source.startswith("#")]
    assert len(pictures) > 5
    for picture in pictures:
        kind, data = picture.split(",", 1)
        assert kind == "data:image/png;base64"
        assert b64decode(data, validate=True).startswith(b"\x89PNG")
    anchors = {source[1:] for source in page.sources if source.startswith("#")}
    assert len(anchors) == len(SECTIONS) and anchors <= page.ids


def test_text_of_a_case_cannot_break_the_page(worm):
    report = replace(worm[1], title='<script>"&', warnings=("a < b",))
    text = render(report)
    assert "<script>" not in text and "&lt;script&gt;&#34;&amp;" in text and "a &lt; b" in text


def test_every_section_is_there_and_listed(worm):
    assert [one.title for one in worm[1].sections] == SECTIONS
    contents = re.findall(r'<li><a href="#part-\d+">([^<]*)</a>', render(worm[1]))
    assert [unescape(title) for title in contents] == SECTIONS


def test_the_command_writes_beside_the_results(tmp_path, capsys, increaser):
    path = increaser[0].save(tmp_path / "result.nc")
    assert main(["report", str(path)]) == 0
    assert capsys.readouterr().out.strip() == str(tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>") and text.endswith("</html>\n")
    headings = [unescape(title) for title in re.findall("<h2>(.*)</h2>", text)]
    signed, *headings = headings  # of the page behind the page to sign
    assert signed == "What the verdicts rest on"
    assert headings == [one.title for one in increaser[1].sections]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["nowhere.nc"], "there is no result file at nowhere.nc"),
        (["notes.nc"], "notes.nc is not a pyworm result"),
        (["notes.nc", "--out", "."], "is a directory, a file such as report.html is needed"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(tmp_path, monkeypatch, capsys, arguments, sentence):
    monkeypatch.chdir(tmp_path)
    Path("notes.nc").write_text("no NetCDF")
    assert sentence in refusal(["report", *arguments], tmp_path, capsys)


# ------------------------------------------------------------------------------------- what it says


def test_the_summary_shows_the_worst_of_every_figure(worm):
    result, report = worm
    key_results = rows(report, "Key results")
    thin = min(result.solutions, key=lambda of: of.figures.film_min.value)
    film = thin.figures.film_min.value
    assert key_results["Minimum film thickness"] == (
        f"{film * 1e6:.4g} µm ± 1.3 %",
        f"phase {thin.phase:g}",
    )
    label = "Minimum specific film thickness lambda (composite roughness 0.5831 µm)"
    specific, where = key_results[label]
    assert specific == f"{film / 0.34**0.5 * 1e6:.4g} ± 1.3 %" and where == f"phase {thin.phase:g}"
    friction = max(of.figures.friction_coefficient.value for of in result.solutions)
    assert key_results["Maximum friction coefficient, smooth surfaces"][0].startswith(
        f"{friction:.4g} ±"
    )
    losses = [of.figures.power_loss.value for of in result.solutions]
    # a pair is in mesh for 239.8 deg of the worm's turn, the next comes after 120 deg
    loss = np.mean(losses) * 239.8 / 120
    assert float(
        key_results["Power loss of the teeth, smooth surfaces"][0].split(" W ±")[0]
    ) == pytest.approx(loss, rel=1e-3)
    output = 6.69e3 * 50 * np.pi * 3 / 59  # 14 kN on each of two teeth, on an arm of 239 mm
    efficiency = float(
        key_results["Efficiency of the teeth, forward, smooth surfaces"][0].split(" %")[0]
    )
    assert efficiency == pytest.approx(100 * output / (output + loss), abs=0.02)
    pitting = key_results["S_H, pitting of the wheel flanks"]
    assert pitting == ("1.284, required 1: sufficient", "Worm gear, standard")
    assert key_results["Modified life L_nmh"][0].endswith(" h")


def test_every_figure_of_a_contact_has_its_error_bar(worm):
    film, heat = (
        rows(worm[1], title) for title in ("Film and pressure", "Friction, loss and temperature")
    )
    for solution in worm[0].solutions:
        cells = film[f"phase {solution.phase:g}"]
        assert sum("±" in cell for cell in cells) == 4
        assert all("±" in cell for cell in heat[f"phase {solution.phase:g}"])
        assert cells[-1] == "yes"


def test_printed_figures_stand_beside_those_of_their_phase(worm):
    beside = rows(worm[1], "Comparison with published values")
    solution = worm[0].solutions[1]  # phase 0.5, which the paper shows
    celsius = solution.figures.temperature_max_film.value - 273.15
    assert beside["Maximum film temperature"] == ("117 °C", f"{celsius:.4g} °C")
    assert beside["Larger radius of relative curvature"] == ("3.046 m", "3.049 m")
    assert "phase 0.25" not in words(worm[1], "Comparison with published values")


def test_ratings_and_those_left_out_are_shown(worm, increaser):
    text = words(worm[1], "Ratings: gears, scuffing, bearings")
    for said in (
        "Mean minimum film thickness h_min,m",
        "kappa",
        "DIN 3996",
        "ISO 281",
        "Scuffing: ",
    ):
        assert said in text
    text = words(increaser[1], "Ratings: gears, scuffing, bearings")
    for said in ("Probability of scuffing", "63 %", "Bearings: the case has no [bearings.NAME]."):
        assert said in text
    assert increaser[1].sections[0].title == "Key results"
    key_results = rows(increaser[1], "Key results")
    assert key_results["Risk of scuffing"][0] == "high"
    assert key_results["Probability of scuffing"][0] == "56.88 %"  # 429 degF against 418


def test_assumptions_are_shown_with_values(worm, increaser):
    text = words(increaser[1], "What was assumed")
    assert "drive.module = 5.08 mm: normal diametral pitch 5" in text
    assert "operation.load_factor = 2.25" in text
    assert "Load sharing by the rule 'ramp'; load factor 2.25." in text
    text = words(worm[1], "What was assumed")
    assert "drive.hob.swivel = 0.255 °: calibrated" in text
    assert "The load on the tooth, 14 kN, is given" in text
    assert "Oil enters at 60 °C; bulk temperatures given, not found" in text


def test_the_plan_shows_what_was_left_out(worm):
    plan = rows(worm[1], SECTIONS[9])
    assert plan["film-heating"] == ("on", "more than 2 %", "film >99 %, friction 40 %")
    assert plan["squeeze"] == ("off", "not simulated", "film 2.4 %, friction 1 %")


def test_where_contacts_differ_the_plan_shows_the_weightiest_reason():
    quiet = replace(EFFECTS[0], on=False, influence={"film": 0.001}, reason="within 2 %")
    first, second = worm_result().solutions
    result = result_of(
        "zi_sharif_2001",
        [replace(first, effects=(quiet,)), replace(second, effects=EFFECTS[:1])],
        make_mesh_cycle(),
    )
    (row,) = plan_section(result).blocks[0].rows
    assert row[1:3] == ("on at phase 0.5", "more than 2 % at phase 0.5")


def test_inputs_are_in_workshop_units(increaser):
    text = words(increaser[1], "Inputs")
    for said in ("406.4 mm", "375 rpm", "6.6 mPa s", "0.508 µm", "110 °C", "0.20684 MPa"):
        assert said in text
    assert not re.search(r"\d um\b|degC", text)


@pytest.mark.usefixtures("undrawn")
def test_a_hob_of_another_base_pitch_is_shown_first(tmp_path, capsys, monkeypatch):
    quickly_described(monkeypatch)
    text = (CASES / "zi_sharif_2001.toml").read_text()
    for old, new in (
        ('"85.97 mm"', '"86.3 mm"'),
        ('"28.66 mm"', '"28.767 mm"'),
        ("27.33", "27.41"),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / "apart.toml"
    path.write_text(text)
    case = pyworm.load(path)
    result = Result(case.name, case.resolved, (make_hot_worm(0.5),), make_mesh_cycle(), {})
    report = build_report(result)
    *_, told = report.warnings
    assert "um more than the worm's" in told
    # a worm turned by 1 mrad touches this wheel at an edge, for whose film there is no closed form
    film, change, pressure, note = rows(report, "Sensitivity")["shaft angle -1.0 mrad"]
    assert not film and not change and float(pressure.split()[0]) > 10
    assert note.endswith("; on an edge at phase 0.5")
    assert main(["check", str(path), "--phase", "0.5", "--json"]) == 0
    out, err = capsys.readouterr()
    assert json.loads(out)["warnings"] == [told]
    assert err == f"pyworm: warning: {told}\n"


@pytest.mark.usefixtures("undrawn")
def test_scenes_that_did_not_converge_are_shown_first():
    solution = make_solution("point_m20_l10", converged=False)
    failed = {"phase 0.9": "no contact"}
    report = build_report(result_of("point_m20_l10", [solution], failed=failed))
    assert report.warnings == (
        "point_m20_l10 did not converge: too many iterations",
        "phase 0.9 could not be solved: no contact",
    )
    text = render(report)
    assert text.index('class="warning"') < text.index("Key results</h2>")
    assert text.count('<td class="no">') == 1


@pytest.mark.usefixtures("undrawn")
def test_contacts_without_a_drive_are_reported_too():
    """A gap's file need not be found again."""
    report = build_report(result_of("gap_example", [make_solution("gap_example")]))
    titles = {one.title for one in report.sections}
    assert {"Key results", "Contacts", "Inputs"} <= titles
    assert not titles & {"Ratings: gears, scuffing, bearings", "Sensitivity"}
    pictures = [b for b in section(report, "Contacts").blocks if isinstance(b, Picture)]
    assert len(pictures) > 3


def test_a_result_without_a_case_is_referred_to_what_shows_it():
    with pytest.raises(CaseError, match="no case file; pyworm explore and pyworm plot show it"):
        build_report(Result("contact", {}, (make_hot_worm(0.5),), None, {}))


# ---------------------------------------------------------------------------------- sensitivity


def test_sensitivities_of_gears_to_oil_and_misalignment(increaser):
    """Film as Moes' line formula, which near here goes with viscosity as Dowson and Higginson's power 0.7."""
    result = increaser[0]
    case = case_again(result.case)
    found = {one.label: one for one in sensitivity(case, result).variations}
    thin, thick = found["one grade thinner"], found["one grade thicker"]
    assert np.log(thick.film_ratio / thin.film_ratio) / np.log(10 ** (1 / 3)) == pytest.approx(
        0.7, abs=0.05
    )
    assert found["oil 10 K warmer"].film_ratio < 1 < found["oil 10 K cooler"].film_ratio
    (uneven,) = [one for one in found.values() if one.label.startswith("flank lines")]
    # K_Hbeta = 1 + c F/(2 w) with 17 N/(mm um) and 10 um
    drive = case.drive
    factor = 1 + 17e9 * 10e-6 / (2 * drive.normal_force / drive.teeth.face_width)
    assert uneven.pressure_ratio == pytest.approx(factor**0.5)
    assert uneven.film_ratio == pytest.approx(factor**-0.13, abs=0.005)  # Dowson and Higginson


@pytest.mark.parametrize("share", [1.0, 0.01])
def test_uneven_load_balances_the_tilt_of_the_flank_lines(increaser, share):
    """A load that grows linearly over the face, where flanks touch: largest over mean (ISO 6336-1)."""
    result = increaser[0]
    operation = result.case["operation"] | {"power": share * result.case["operation"]["power"]}
    case = case_again(result.case | {"operation": operation})
    (uneven,) = [
        one for one in sensitivity(case, result).variations if one.label.startswith("flank lines")
    ]
    mean = case.drive.normal_force / case.drive.teeth.face_width
    place = (np.arange(100_000) + 0.5) / 100_000
    tilt = 17e9 * 10e-6 * place
    low, high = -20 * tilt[-1], tilt[-1] + mean
    while high - low > 1e-9 * mean:
        level = (low + high) / 2
        low, high = (level, high) if np.maximum(level + tilt, 0).mean() < mean else (low, level)
    assert uneven.pressure_ratio == pytest.approx(((low + tilt[-1]) / mean) ** 0.5, rel=1e-3)


def test_sensitivities_of_worms_to_assembly_errors():
    """At mid-mesh: dry pressure as Brewe and Hamrock's fit of the radii, within what ends and reliefs do to
    it, films by Chittenden's formula.
    """
    result = worm_result()
    middle = replace(result, solutions=result.solutions[1:])
    case = case_again(middle.case)
    found = {one.label: one for one in sensitivity(case, middle).variations}

    def pressure(long_radius, short_radius):
        ratio = long_radius / short_radius
        k, second = 1.0339 * ratio**0.636, 1.0003 + 0.5968 / ratio
        short = (second / k / (1 / long_radius + 1 / short_radius)) ** (1 / 3)
        return 1 / (k * short**2)

    mountings = (
        ("centre distance {:+.1f} mm", "assembly.centre_distance", 0.1e-3),
        ("worm shifted {:+.1f} mm along the wheel's axis", "assembly.axial_shift", 0.1e-3),
        ("shaft angle {:+.1f} mrad", "assembly.shaft_angle", 1e-3),
    )
    for label, entry, size in mountings:
        for by in (-size, size):
            one = found.pop(label.format(by * 1e3))
            radii = re.search(r"radii ([0-9.]+) m, ([0-9.]+) mm", one.note)
            ratio = pressure(float(radii[1]), float(radii[2]) * 1e-3) / pressure(3.049, 0.0954)
            assert one.pressure_ratio == pytest.approx(ratio, abs=0.025)
            films = [
                float(chittenden(scales(drive.scene_under(14e3, 0.5)).groups).central)
                for drive in (case.drive.varied(entry, by), case.drive)
            ]
            # Chittenden's films of so slender a contact change a third to twice as much
            assert 0.3 < (films[0] / films[1] - 1) / (one.film_ratio - 1) < 2
    assert [label.split()[0] for label in found] == ["one", "one", "oil", "oil"]


OIL = pyworm.load(CASES / "zi_sharif_2001.toml").scene(0.5).oil
LINE_OIL = replace(OIL, viscosity=Barus(0.08, 2e-8))


@settings(max_examples=50)
@given(st.floats(-30, 60), st.floats(0, 0.3e9))
def test_warmed_oils_follow_their_own_laws_at_every_pressure(rise, pressure):
    for oil in (OIL, LINE_OIL):
        warm = oil.warmed(rise).viscosity
        assert warm(pressure) == pytest.approx(oil.eta(pressure, rise), rel=1e-9)


@given(st.floats(0.2, 5))
def test_other_grades_keep_their_pressure_viscosity(ratio):
    for oil in (OIL, LINE_OIL):
        law = thickened(oil, ratio).viscosity
        assert law.eta0 == pytest.approx(ratio * oil.viscosity.eta0)
        assert law.alpha == pytest.approx(oil.viscosity.alpha)
