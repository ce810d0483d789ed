"""The pages to sign: head, verdicts in words and colours, lines for names; looked at in a browser."""

import re
import shutil
import subprocess
import tomllib
from dataclasses import replace

import matplotlib.image
import numpy as np
import pytest
from folders import CASES
from synthetic_solution import make_hot_worm, make_line_solution, make_mesh_cycle
from undrawn_pages import undrawn_pages

import pyworm
from pyworm.case.case import case_of
from pyworm.io.html import typeset
from pyworm.ratings.rating import Safety
from pyworm.report.page.build import build_report
from pyworm.report.page.html import render
from pyworm.report.page.symbols import inputs_as_text
from pyworm.result.result import Result

BROWSER = (
    shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
)
GREEN, RED = (0x1B, 0x6B, 0x3A), (0xA4, 0x16, 0x1A)


@pytest.fixture(scope="module")
def page():
    case = pyworm.load(CASES / "zi_sharif_2001.toml")
    result = Result(case.name, case.resolved, (make_hot_worm(0.5),), make_mesh_cycle(), {})
    identity = (("Drawing", "4711-03 <b>"), ("Customer", "Works & Sons"))
    with undrawn_pages():
        return render(build_report(result, case, None, identity))


def test_the_page_names_drawing_and_customer_and_every_safety(page):
    cover = page[page.index('class="cover"') : page.index("</section>")]
    assert "4711-03 &lt;b&gt;" in cover and "Works &amp; Sons" in cover
    for index in ("W", "H", "δ", "F", "T"):
        assert f'<th scope="row">S<sub>{index}</sub>, ' in cover
    assert re.search("θ<sub>Slim</sub> = [0-9.]+\N{NO-BREAK SPACE}°C", cover)
    assert "polyglycol" in cover and "1500 rpm" in cover  # oil and operating point
    assert cover.count('class="verdict sufficient"') == 4
    assert cover.count('class="verdict not-sufficient"') == 1  # of bearings that are assumed
    assert cover.index('class="warning"') < cover.index("Calculated")  # seen by who signs
    assert all(word in cover for word in ("Calculated", "Checked", "Released"))


def test_standard_edition_and_clause_stand_above_the_verdicts(page):
    cover = page[page.index('class="cover"') : page.index("</section>")]
    above = cover[: cover.index("<thead>")]
    assert "ISO/TS 14521:2020" in above and "DIN 3996:2012" in above
    assert "The standard was not read" in above and "numbered from memory" in above
    assert "contact ratio of 2, not above 2.1" in above  # 1.998 of this drive
    for number in (8, 9, 10, 11, 12):
        assert f">clause {number}<" in cover


def test_the_page_has_the_computed_geometry(page):
    """Of the design table: m = p_x/pi, d = 2 r, c = a - r_a1 - r_f2, and what only flanks tell."""
    above = page[page.index('class="geometry"') : page.index("<thead>")]
    shown = dict(re.findall("<dt>(.*?)</dt><dd>(.*?)</dd>", above))
    assert shown["Centre distance"] == "304.8 mm"
    assert shown["Module"] == f"{28.73 / np.pi:.5g} mm"
    assert shown["Lead"] == "86.18 mm"
    assert shown["Worm tip diameter"] == f"{2 * 48.01:.5g} mm"
    assert shown["Wheel throat diameter"] == f"{2 * 274.03:.5g} mm"
    root = 305.62 - 51.63  # as far as the hob's tip comes
    assert shown["Wheel root diameter"] == f"{2 * root:.5g} mm"
    assert shown["Worm tip clearance"] == f"{304.8 - 48.01 - root:.5g} mm"
    assert shown["Wheel tip clearance"] == f"{304.8 - 274.03 - 29.03:.5g} mm"
    assert float(shown["Contact ratio"]) == pytest.approx(1.998, abs=1e-3)
    assert float(shown["Profile shift"]) == pytest.approx(-0.42, abs=0.01)


@pytest.mark.usefixtures("undrawn")
def test_a_drawing_s_backlash_is_on_the_page():
    text = (CASES / "worm_drawing.toml").read_text() + '\n[worm_rating]\nlife = "25000 h"\n'
    case = case_of(tomllib.loads(text), "drawn", CASES)
    result = Result(case.name, case.resolved, (make_hot_worm(0.5),), make_mesh_cycle(), {})
    cover = build_report(result, case).cover
    assert dict(cover.geometry)["Backlash"] == "0.12 mm"


def test_the_page_behind_has_figures_life_flanks_and_assumptions(page):
    behind = page[page.index('class="overleaf"') : page.index("<nav>")]
    assert "What the verdicts rest on" in behind
    assert "Minimum film thickness" in behind and "±" in behind
    assert "Required life" in behind and "25000" in behind
    assert "<h3>Assumptions</h3>" in behind and behind.count("<li>") >= 3


@pytest.mark.parametrize(
    ("key", "value", "shown"),
    [
        ("delta_Wlim_um", 1177.0, "δ<sub>Wlim</sub> = 1177\N{NO-BREAK SPACE}µm"),
        ("h_min_m_um", 0.5, "h<sub>min,m</sub> = 0.5\N{NO-BREAK SPACE}µm"),
        ("v_gm_m_s", 3.2, "v<sub>gm</sub> = 3.2\N{NO-BREAK SPACE}m/s"),
        ("L_h", 25000.0, "L = 25000\N{NO-BREAK SPACE}h"),
        ("theta_S_with_fan_C", 64.6, "θ<sub>S</sub> with fan = 64.6\N{NO-BREAK SPACE}°C"),
        ("p_m*", 0.92, "p<sub>m</sub>* = 0.92"),
        ("rim_over_module", 2.0, "rim over module = 2"),
        ("lambda_GFP", 0.2, "λ<sub>GFP</sub> = 0.2"),
        ("oil", "PAG <b>", "oil: PAG &lt;b&gt;"),
    ],
)
def test_symbols_are_printed_with_index_and_unit(key, value, shown):
    assert typeset(inputs_as_text(Safety("S_X", "", 1.0, 2.0, inputs={key: value}))) == shown


def test_words_of_files_are_no_symbols():
    for text in ("worm_rating.life", "zi_sharif_2001", "scuffing_load_stage"):
        assert typeset(text) == text


@pytest.mark.usefixtures("undrawn")
def test_a_contact_without_safeties_has_no_page_to_sign():
    case = pyworm.load(CASES / "line_thermal.toml")
    built = build_report(Result(case.name, case.resolved, (make_line_solution(),), None, {}))
    assert built.cover is None and 'class="cover"' not in render(built)


def _browse(page, directory, *arguments):
    file = directory / "report.html"
    file.write_text(page, encoding="utf-8")
    home = ("--no-sandbox", "--disable-gpu", f"--user-data-dir={directory / 'browser'}")
    command = [BROWSER, "--headless", *home, *arguments, file.as_uri()]
    subprocess.run(command, check=True, capture_output=True, timeout=120)


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
def test_a_browser_shows_the_verdicts_in_their_colours(page, tmp_path):
    picture = tmp_path / "page.png"
    _browse(page, tmp_path, f"--screenshot={picture}", "--window-size=1200,1100")
    seen = np.rint(matplotlib.image.imread(picture)[..., :3] * 255).astype(int)
    assert seen.shape == (1100, 1200, 3)
    badges = [int((np.abs(seen - colour).max(-1) <= 3).sum()) for colour in (GREEN, RED)]
    assert badges[0] > 2000 and badges[1] > 500


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
def test_printed_the_page_to_sign_stands_alone(page, tmp_path):
    """As a PDF of its own pages; the rest begins on the second."""
    printed = tmp_path / "report.pdf"
    _browse(page, tmp_path, f"--print-to-pdf={printed}", "--no-pdf-header-footer")
    content = printed.read_bytes()
    assert content.startswith(b"%PDF") and content.count(b"/Type /Page\n") >= 2


def test_gears_without_a_page_to_sign_have_their_sheet_in_the_report():
    case = pyworm.load(CASES / "roller_ref.toml")
    line = replace(make_line_solution(), phase=0.5, section="left", station=0.5)
    result = Result(case.name, case.resolved, (line,), None, {})
    with undrawn_pages():
        report = build_report(result, case)
    assert report.cover is None
    section = next(part for part in report.sections if part.title == "Geometry and inspection")
    rows = {row[0]: row[1:] for table in section.blocks for row in table.rows}
    assert rows["Throat diameter"][0] == "64 mm" and rows["Centre distance"] == ("160 mm",)
