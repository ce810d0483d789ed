"""The gallery: every script runs, on short grids, and draws its picture; notebooks are the same scripts."""

import json
import runpy
import sys

import matplotlib
import pytest
from folders import ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
CASES = {"reversal": "reversal_line.toml", "worm_mid_mesh": "zi_sharif_2001.toml"}

sys.path.insert(0, str(ROOT / "tools"))
from notebooks import NOTEBOOKS, notebook  # noqa: E402


def test_there_are_twelve_short_scripts_three_of_them_notebooks():
    assert len(EXAMPLES) == 12
    assert all(len(script.read_text().splitlines()) <= 40 for script in EXAMPLES)
    assert len(NOTEBOOKS) == 3


@pytest.mark.parametrize("script", EXAMPLES, ids=lambda script: script.stem)
def test_a_script_draws_its_picture(script, tmp_path, monkeypatch, capsys):
    matplotlib.use("Agg")
    case = [str(ROOT / "cases" / CASES[script.stem])] if script.stem in CASES else []
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(script), "30 %", *case])
    runpy.run_path(str(script), run_name="__main__")
    assert (tmp_path / f"{script.stem}.png").stat().st_size > 5000
    assert capsys.readouterr().out


@pytest.mark.parametrize("script", EXAMPLES, ids=lambda script: script.stem)
def test_the_page_shows_it(script):
    page = (ROOT / "docs/how-to/gallery.md").read_text()
    assert f"`examples/{script.name}`" in page
    assert f"../pictures/gallery/{script.stem}.png" in page
    assert (ROOT / f"docs/pictures/gallery/{script.stem}.png").is_file()


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_its_script(name):
    held = (ROOT / f"examples/{name}.ipynb").read_text()
    assert held == notebook(name)
    code = "\n".join("".join(cell["source"]) for cell in json.loads(held)["cells"][1:])
    compile(code, name, "exec")
    assert "sys" not in code
