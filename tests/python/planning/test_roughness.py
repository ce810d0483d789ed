"""Roughness is the bodies': scenes carry it, plans judge it, closed forms and solutions are told over it."""

import json
import re
from dataclasses import replace
from io import StringIO
from math import hypot, inf

import pytest
from folders import CASES
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console
from synthetic_solution import make_line_solution, make_solution

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.materials.body import Body, composite_roughness
from pyworm.planning.prediction import predicted
from pyworm.report.console.scenes import figures_table, plan_table, scenes_table
from pyworm.result.result import Result, open_result
from pyworm.scene.summary import scene_summary
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.solution import Estimate

ROUGH = {
    "spur_pair": (0.51e-6, 0.40e-6),
    "errichello_speed_increaser": (20 * 25.4e-9, 20 * 25.4e-9),
    "errichello_optimised_addenda": (20 * 25.4e-9, 20 * 25.4e-9),
    "roller_ref": (0.4e-6, 0.2e-6),
    "roller_crowned": (0.4e-6, 0.2e-6),
}
"""Shipped cases that give roughness -> that of both bodies."""


def written(tmp_path, name, *changes):
    """A shipped case with passages replaced, and all but one of a drive's contacts left out."""
    text = (CASES / f"{name}.toml").read_text()
    text = re.sub(r"(phases|stations) = \[.*\]", r"\1 = [0.5]", text)
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / f"{name}.toml"
    path.write_text(text)
    return path


def printed(table):
    console = Console(file=StringIO(), width=120)
    console.print(table)
    return console.file.getvalue()


def judged(plan):
    (roughness,) = (one for one in plan.effects if one.name == "roughness")
    return roughness


def test_heights_of_both_surfaces_add_as_squares():
    bodies = Body(2e11, 0.3, roughness=0.3e-6), Body(2e11, 0.3, roughness=0.4e-6)
    assert composite_roughness(*bodies) == pytest.approx(0.5e-6, rel=1e-15)
    assert composite_roughness(bodies[0], Body(2e11, 0.3)) is None


@given(st.floats(1.1e-10, 0.9e-4), st.floats(1.1e-10, 0.9e-4))
def test_two_surfaces_are_rougher_than_either_and_not_than_their_sum(one, other):
    both = composite_roughness(Body(2e11, 0, roughness=one), Body(2e11, 0, roughness=other))
    assert max(one, other) <= both <= (one + other) * (1 + 1e-15)


@pytest.mark.parametrize("name", ROUGH)
def test_every_drive_s_scenes_carry_its_roughness_and_plans_judge_it(name, tmp_path):
    scene = pyworm.load(written(tmp_path, name)).scene()
    assert [body.roughness for body in scene.bodies] == pytest.approx(ROUGH[name], rel=1e-12)
    seen = judged(pyworm.plan(scene, 0.02))
    ratio = predicted(scene).film_min / hypot(*ROUGH[name])
    assert seen.indicator == pytest.approx(ratio, rel=1e-12)
    assert seen.on == (seen.influence["film"] > 0.02)


def test_a_worm_drive_s_roughness_is_judged_too(tmp_path):
    scene = pyworm.load(written(tmp_path, "zi_sharif_2001")).scene(phase=0.5)
    assert scene.composite_roughness == pytest.approx(hypot(0.3e-6, 0.5e-6), rel=1e-12)
    plan = pyworm.plan(scene)
    assert judged(plan).indicator == pytest.approx(
        predicted(scene).film_min / hypot(0.3e-6, 0.5e-6)
    )
    assert scene_summary(scene)["composite_roughness_m"] == scene.composite_roughness
    assert "0.5831 µm" in printed(plan_table(scene, plan, Expectation(1.0, 100.0)))


def test_without_roughness_there_is_no_lambda():
    scene = pyworm.load(CASES / "line_m20_l10.toml").scene()
    plan = pyworm.plan(scene)
    assert judged(plan).reason == "roughness not given"
    assert not {"composite_roughness_m", "specific_film"} & (
        set(scene_summary(scene)) | set(make_line_solution().summary())
    )
    said = (
        printed(plan_table(scene, plan, Expectation(1.0, 100.0))),
        printed(figures_table(scene, make_line_solution().summary(), {})),
    )
    assert not any("oughness" in text or "lambda" in text for text in said)


@pytest.mark.parametrize("make", [make_line_solution, make_solution])
def test_a_solution_has_its_film_over_the_roughness(make, tmp_path):
    solution = replace(make(), composite_roughness=0.5e-6)
    summary = solution.summary()
    film = solution.figures.film_min
    assert summary["composite_roughness_m"] == 0.5e-6
    assert summary["specific_film"] == pytest.approx(film.value / 0.5e-6, rel=1e-15)
    assert summary["specific_film_error"] == film.error
    path = Result("rough", {}, (solution,), None, {}).save(tmp_path / "result.nc")
    assert open_result(path).solutions[0].summary()["specific_film"] == summary["specific_film"]


def test_tables_show_the_specific_film_beside_what_is_published():
    case = pyworm.load(CASES / "errichello_speed_increaser.toml")
    scene = case.scene(phase=0.13)
    solution = replace(make_line_solution(), composite_roughness=scene.composite_roughness)
    solution = replace(
        solution, figures=replace(solution.figures, film_min=Estimate(5.6e-8, 0.012, 0.009))
    )
    said = printed(figures_table(scene, solution.summary(), case.published)).splitlines()
    (row,) = (line for line in said if "Specific film thickness lambda" in line)
    assert "0.07795 ± 1.5 %" in row and "0.073" in row
    (row,) = (line for line in said if "Composite roughness" in line)
    assert "0.7184 µm" in row
    scenes = scene, case.scene(phase=0.6)
    said = printed(scenes_table(scenes, [solution.summary()] * 2))
    assert "lambda" in said and "0.0779" in said
    said = printed(scenes_table(scenes, [solution.summary(), make_line_solution().summary()]))
    assert "lambda" not in said


def test_a_film_that_is_not_resolved_has_its_lambda_all_the_same():
    figures = replace(make_line_solution().figures, film_min=Estimate(-1e-9, inf))
    lost = replace(make_line_solution(), figures=figures, composite_roughness=0.5e-6)
    assert lost.summary()["specific_film"] == pytest.approx(-2e-3)


def test_a_run_prints_the_specific_film_of_line_and_point(tmp_path, capsys):
    spur = ["run", str(CASES / "spur_pair.toml"), "--phase", "0.5", "--json"]
    assert main([*spur, "--out", str(tmp_path / "spur"), "--effects", "isothermal"]) == 0
    (line,) = json.loads(capsys.readouterr().out)["scenes"]
    point = pyworm.load(CASES / "point_m20_l10.toml").scene()
    bodies = tuple(replace(body, roughness=0.05e-6) for body in point.bodies)
    rough = replace(point, bodies=bodies)
    solution = pyworm.solve(rough, pyworm.plan(rough, 0.05))
    for summary, composite in (
        (line, hypot(0.51e-6, 0.40e-6)),
        (solution.summary(), hypot(0.05e-6, 0.05e-6)),
    ):
        ratio = summary["film_min_m"] / composite
        assert summary["specific_film"] == pytest.approx(ratio, rel=1e-12)
        assert summary["specific_film_error"] == summary["film_min_error"]


@pytest.mark.parametrize(
    ("name", "old", "new", "sentence"),
    [
        (
            "spur_pair",
            '"0.51 um"',
            '"0.51 mm"',
            'bodies.pinion.roughness = "0.51 mm": must be a root mean square height between 0.1 nm a',
        ),
        (
            "spur_pair",
            '"0.51 um"',
            "0.51",
            "bodies.pinion.roughness = 0.51: must be a root mean square height with",
        ),
        (
            "spur_pair",
            '"0.51 um"',
            '"0 um"',
            'roughness = "0 um": must be a root mean square height greater than',
        ),
        (
            "spur_pair",
            "[surfaces]",
            '[surfaces]\npinion_roughness = "0.51 um"',
            "surfaces.pinion_roughness: no such key; valid keys are friction_coefficient",
        ),
        ("roller_ref", "[bodies.worm]", "[surfaces]\n[bodies.worm]", "surfaces: no such key"),
    ],
)
def test_one_sentence_for_bad_input(tmp_path, capsys, name, old, new, sentence):
    assert main(["check", str(written(tmp_path, name, (old, new)))]) == BAD_INPUT
    said = capsys.readouterr().err
    assert sentence in said
    assert said.count("\n") == 1
