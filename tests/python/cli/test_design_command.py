"""pyworm design: tables, JSON, files, exit codes."""

import json

import pytest
from folders import ROOT

from pyworm.batch.operating_points import NotSolvedError, Solving
from pyworm.cli.main import main

BALL = f"""
title = "A ball on a disc"
case = "{ROOT}/cases/ball_pag_460.toml"
figures = "formula"
[variables]
"contact.radii[0]" = {{ low = "10 mm", high = "16 mm" }}
[objective]
minimise = "pressure_max"
[front]
minimise = "film_min"
designs = 3
"""


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.toml"
    path.write_text(BALL)
    return path


def test_tables_files_and_the_front_as_a_picture(ball, tmp_path, capsys):
    assert main(["design", str(ball), "--out", str(tmp_path / "out")]) == 0
    shown = capsys.readouterr().out
    print(shown)
    assert "Pareto front" in shown and "At a bound: contact.radii[0]." in shown
    assert all(len(line) <= 80 for line in shown.splitlines() if str(tmp_path) not in line)
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names >= {"best.toml", "design.json", "front.png"}
    found = json.loads((tmp_path / "out/design.json").read_text())
    assert found["variables"]["contact.radii[0]"]["best"] == "16 mm"
    assert len(found["front"]) == 3 and found["feasible"]


def test_a_constraint_that_cannot_be_met_ends_with_three_and_the_amount(ball, tmp_path, capsys):
    ball.write_text(BALL + '[constraints]\nfilm_min = { low = "2 um" }\n')
    assert main(["design", str(ball), "--json", "--out", str(tmp_path / "out")]) == 3
    shown = capsys.readouterr()
    assert "No design was found that meets film_min >= 2 µm" in shown.err
    found = json.loads(shown.out)
    assert not found["feasible"] and found["figures"]["film_min"]["margin"] < -0.5
    assert (tmp_path / "out/best.toml").exists()


def test_a_case_without_a_solution_ends_with_the_reason(ball, tmp_path, capsys, monkeypatch):
    def unsolved(self, tasks):
        raise NotSolvedError("ball could not be solved: no film")

    monkeypatch.setattr(Solving, "solved", unsolved)
    ball.write_text(BALL.replace('"formula"', '"simulation"'))
    assert main(["design", str(ball), "--out", str(tmp_path / "out")]) == 3
    assert "could not be solved: no film" in capsys.readouterr().err
