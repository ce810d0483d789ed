"""Variants side by side: what differs, verdicts, figures; names, refusals; PDF."""

from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from folders import CASES
from synthetic_solution import make_hot_worm, make_line_solution, make_mesh_cycle
from zi_drives import coarse_patterns, coarse_springs

import pyworm
from pyworm.cli.main import main
from pyworm.io.input_error import CaseError
from pyworm.report import pdf
from pyworm.report.page.html import render_variants
from pyworm.report.page.variants import variants_page
from pyworm.result.result import Result

RATED = """
[worm_rating]
oil = "PAG VG 460"
wheel_material = "CuSn12Ni2"
life = "25000 h"
"""


@pytest.fixture(autouse=True, scope="module")
def coarse():
    """Fewer places, phases and loads for patterns and load sharing."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_patterns(patch)
        coarse_springs(patch)
        yield


@cache
def rated():
    """A drive by its drawing, with what the standard needs."""
    with TemporaryDirectory() as directory:
        path = Path(directory) / "unit.toml"
        path.write_text((CASES / "worm_drawing.toml").read_text() + RATED)
        return pyworm.load(path)


def variant(torque=300.0):
    case = rated().with_found({"operation": {"wheel_torque": torque}})
    return Result(case.name, case.resolved, (make_hot_worm(0.5),), make_mesh_cycle(), {})


@pytest.fixture(scope="module")
def page():
    return variants_page((variant(), variant(600.0)), ("as drawn", "twice the torque"))


def table(page, title):
    """Cells of a table of variants by the names of its rows."""
    (rows,) = (section.blocks[0].rows for section in page.sections if section.title == title)
    return {name: cells for name, *cells in rows}


def test_only_what_differs_is_listed_with_both_values(page):
    rows = table(page, "What differs")
    assert rows["operation.wheel_torque"] == ["300 N m", "600 N m"]
    assert len(rows) == 1


def test_each_variant_has_its_own_verdicts_and_figures(page):
    rows = {name.partition(",")[0]: cells for name, cells in table(page, "Verdicts").items()}
    assert {"S_W", "S_H", "S_delta", "S_F", "S_T"} <= set(rows)
    light, heavy = (float(cell) for cell in rows["S_F"])
    # the stress of a tooth that is worn less is less than proportional to the torque
    assert 2 <= light / heavy < 3
    figures = table(page, "Figures")
    assert all(len(cells) == 2 for cells in figures.values())
    films = figures["Minimum film thickness"]
    assert all("±" in cell for cell in films)


def test_the_page_has_every_variant_and_its_badges(page):
    text = render_variants(page)
    assert text.count('<th scope="col">twice the torque</th>') == 3
    assert 'class="verdict sufficient"' in text and "<h2>What differs</h2>" in text
    assert "http" not in text.replace("http-equiv", "")


def test_a_drive_and_a_contact_without_ratings_stand_beside_each_other():
    line = pyworm.load(CASES / "line_thermal.toml")
    other = Result(line.name, line.resolved, (make_line_solution(),), None, {})
    built = variants_page((variant(), other), ("drive", "contact"))
    assert all(cells[1] == "" for cells in table(built, "Verdicts").values())
    assert table(built, "Figures")["Minimum film thickness"][1]


@pytest.mark.parametrize("count", [1, 7])
def test_one_and_too_many_are_refused(count):
    results = [variant()] * count
    with pytest.raises(CaseError, match=f"{count} results: 2 to 6"):
        variants_page(results, [str(n) for n in range(count)])


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    directory = tmp_path_factory.mktemp("results")
    paths = [directory / name / "result.nc" for name in ("a", "b")]
    for path, torque in zip(paths, (300.0, 600.0), strict=True):
        path.parent.mkdir()
        replace(variant(torque), provenance={"pyworm": "0"}).save(path)
    return paths


def test_the_command_names_variants_by_their_folders(files, capsys):
    out = files[0].with_name("variants.html")
    assert main(["report", *map(str, files)]) == 0
    assert capsys.readouterr().out.strip() == str(out)
    assert '<th scope="col">b</th>' in out.read_text()


@pytest.mark.usefixtures("plain")
def test_simulated_wear_stands_on_the_pages_to_sign(files, capsys, tmp_path):
    out = tmp_path / "report.html"
    assert main(["report", str(files[0]), "--wear", str(tmp_path), "--out", str(out)]) == 2
    assert "has no wear.png" in capsys.readouterr().err
    (tmp_path / "wear.png").write_bytes(b"PNG")
    assert main(["report", str(files[0]), "--wear", str(tmp_path), "--out", str(out)]) == 0
    behind = out.read_text().partition('class="overleaf"')[2].partition("<nav>")[0]
    assert "Simulated wear of the wheel" in behind


def test_options_of_one_result_are_refused_of_several(files, capsys):
    assert main(["report", *map(str, files), "--drawing", "4711"]) == 2
    assert "--drawing: is of one result, 2 are given" in capsys.readouterr().err


@pytest.mark.usefixtures("plain")
def test_without_a_browser_a_pdf_is_refused_in_a_sentence(files, capsys, monkeypatch):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    out = files[0].with_name("here.html")
    assert main(["report", str(files[0]), "--pdf", "--out", str(out)]) == 2
    said = capsys.readouterr().err
    assert "--pdf: none of chromium" in said and f"open {out} in any browser" in said
    assert out.is_file() and not out.with_suffix(".pdf").exists()


def test_a_browser_that_fails_leaves_no_pdf(tmp_path, monkeypatch):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: "/bin/false")
    with pytest.raises(CaseError, match="did not print"):
        pdf.print_pdf(tmp_path / "a.html", tmp_path / "a.pdf")
    assert not (tmp_path / "a.pdf").exists()


@pytest.mark.skipif(pdf.browser() is None, reason="no Chromium on this machine")
def test_a_pdf_begins_with_the_pages_to_sign(files):
    out = files[0].with_name("signed.html")
    assert main(["report", str(files[0]), "--pdf", "--out", str(out)]) == 0
    printed = out.with_suffix(".pdf").read_bytes()
    assert printed.startswith(b"%PDF") and printed.count(b"/Type /Page\n") >= 3
