"""What was left out beside the figures: effects beyond the accuracy, lubrication, the loss of rough teeth."""

import json
from dataclasses import replace
from math import atan, tan

import numpy as np
import pytest
from folders import CASES
from swept_cycle import PHASES, cycle_result
from synthetic_solution import make_hot_worm, make_line_solution, make_mesh_cycle
from zi_drives import without_allowed_errors

import pyworm
from pyworm.batch import drive_iteration
from pyworm.cli.main import main
from pyworm.formulas.lubrication import lubrication
from pyworm.planning.effects.judgement import Judgement
from pyworm.plots.layout import heading
from pyworm.ratings.heating import heating_loss, heating_of
from pyworm.ratings.rated_case import rating_request, ratings
from pyworm.ratings.standard_loss import NoStandard, StandardLoss, standard_loss
from pyworm.report.console.mesh_cycle import loss_table
from pyworm.report.console.scenes import figures_table, heat_table, scenes_table
from pyworm.report.console.sweep import rows_table
from pyworm.report.page.build import build_report
from pyworm.report.page.content import Picture
from pyworm.report.table import Table
from pyworm.result.headline import headline, of_all, opening
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result, open_result
from pyworm.result.sweep_result import SweepResult, sweep_table
from pyworm.solver.neglected_effects import NeglectedEffects, beyond, expected, judged, worst

EFFECTS = (
    Judgement("film-heating", True, 0.3, {"film": 1.7, "friction": 0.4}, "more than 2 %"),
    Judgement("squeeze", False, 0.1, {"film": 0.4, "friction": 0.1}, "neglected as requested"),
    Judgement("starvation", False, None, {}, "flooded"),
    Judgement("viscosity-across", False, 0.01, {"film": 0.01, "friction": 0.02}, "within 2 %"),
    Judgement("roughness", False, 0.9, {"film": 0.53, "friction": 0.53}, "not simulated"),
)
WORDS = "neglected: roughness up to 53 %, squeeze up to 40 %"


def rough_worm(phase=0.5, roughness=0.6e-6, **changes):
    """The synthetic worm contact: central film 1.4 um, hot, solved to 2 %."""
    known = {"effects": EFFECTS, "composite_roughness": roughness, "accuracy": 0.02}
    return replace(make_hot_worm(phase), **(known | changes))


@pytest.fixture(scope="module")
def case():
    return pyworm.load(CASES / "zi_sharif_2001.toml")


@pytest.fixture(scope="module")
def rough(case):
    """Two solved phases of a case whose central film is 2.3 times its roughness."""
    solutions = tuple(rough_worm(phase) for phase in (0.25, 0.75))
    return Result(case.name, case.resolved, solutions, make_mesh_cycle(), {})


# ------------------------------------------------------------------------------ what is beyond the accuracy


def test_effects_that_are_off_count_beyond_the_accuracy_the_largest_first():
    assert list(beyond(EFFECTS, 0.02).items()) == [("roughness", 0.53), ("squeeze", 0.4)]
    assert list(beyond(EFFECTS, 0.45)) == ["roughness"]
    assert beyond(EFFECTS, 0.6) == {}
    boundless = replace(EFFECTS[1], influence={"film": 0.1, "friction": np.inf})
    assert beyond([boundless], 0.02) == {"squeeze": 1.0}
    assert (
        NeglectedEffects(beyond([boundless], 0.02)).words == "neglected: squeeze by more than 99 %"
    )
    assert NeglectedEffects(beyond(EFFECTS, 0.02)).words == WORDS


@pytest.mark.parametrize(
    ("central", "least", "name"),
    [
        (3.0, 1.0, "full"),
        (2.99, 2.0, "mixed"),
        (8.0, 0.99, "mixed"),  # touches where the film is thinnest
        (1.0, 0.5, "mixed"),
        (0.99, 0.5, "boundary"),
        (None, None, "unknown"),
        (2.0, -2.4, "unknown"),  # no film is negative
        (np.inf, 1.0, "unknown"),
    ],
)
def test_lubrication_goes_by_central_and_least_film(central, least, name):
    assert lubrication(central, least) == name


@pytest.mark.parametrize(
    ("central", "share", "name"),
    [(0.9, 0.15, "mixed"), (0.41, 0.9, "boundary"), (2.0, 0.02, "mixed"), (4.0, 1e-6, "full")],
)
def test_a_simulated_share_tells_boundary_from_mixed_lubrication(central, share, name):
    assert lubrication(central, 1.0, share) == name


def test_the_worst_of_several_contacts_counts():
    full = NeglectedEffects({"squeeze": 0.9}, "full", 5.0, 3.0)
    mixed = NeglectedEffects({"roughness": 0.3, "squeeze": 0.1}, "mixed", 2.0, 1.5)
    thinner = NeglectedEffects({"roughness": 0.5}, "mixed", 1.5, 1.2)
    of_them = worst([full, mixed, thinner])
    assert of_them.influence == {"squeeze": 0.9, "roughness": 0.5}
    assert (of_them.lubrication, of_them.lambda_central, of_them.contacts) == ("mixed", 1.5, 3)
    assert worst([full, NeglectedEffects()]).lubrication == "unknown"
    assert not worst([full, NeglectedEffects()]).as_if_smooth


def test_a_film_that_did_not_converge_has_no_lubrication():
    lost = rough_worm(converged=False)
    assert (
        lost.neglected_effects.lubrication == "unknown"
        and lost.neglected_effects.lambda_min is None
    )
    good = rough_worm()
    assert of_all([lost, good]) == good.neglected_effects
    assert headline([lost]) == WORDS


# ---------------------------------------------------------------------------------------- what is said first


def test_a_scene_s_json_begins_with_what_was_left_out_and_a_saved_result_keeps_it(rough, tmp_path):
    summary = rough.solutions[0].summary()
    keys = list(summary)
    assert keys.index("left_out") < keys.index("lubrication") < keys.index("film_min_m")
    assert summary["left_out"] == {"roughness": 0.53, "squeeze": 0.4}
    assert summary["lubrication"] == "mixed"
    assert summary["lambda_central"] == pytest.approx(1.4 / 0.6)
    assert summary["lambda_min"] == summary["specific_film"]
    assert NeglectedEffects.read(summary) == rough.solutions[0].neglected_effects
    again = open_result(rough.save(tmp_path / "result.nc"))
    assert [of.neglected_effects for of in again.solutions] == [
        of.neglected_effects for of in rough.solutions
    ]


def test_the_opening_names_lubrication_least_film_and_the_standard(rough, case):
    sentence, film, beside = opening(rough.solutions, standard_loss(case).words)
    assert sentence == (
        "The worst of 2 contacts runs in mixed lubrication (central film thickness 2.3, minimum film "
        "thickness 1.1 times the composite roughness), with smooth surfaces assumed."
    )
    thin = min(of.figures.film_min.value for of in rough.solutions)
    assert film == f"Minimum film thickness {thin * 1e6:.4g} µm ± 1.3 % (numerical); {WORDS}"
    assert beside.startswith("Rough teeth by the methods of DIN 3996:2012")
    smooth = [rough_worm(roughness=0.2e-6, effects=())]
    assert opening(smooth, "unsaid") == []


def test_without_a_roughness_the_opening_says_which_one_would_matter():
    """Of films, the one that the least roughness reaches; figures are not headed, since nothing is known."""
    of_thick, of_thin = (
        judged((), 0.01, films, None) for films in ((1.5e-6, 0.9e-6), (1.4e-6, 0.3e-6))
    )
    assert of_thick.lubrication == "unknown" and not of_thick.as_if_smooth
    assert of_thick.sentence == (
        "Roughness is not given: smooth surfaces are assumed, and the lubrication regime is not judged. "
        "Above a composite roughness of 0.5 µm (Rq) it would be mixed; two ground surfaces of Ra 0.4 µm "
        "have 0.71 µm."
    )
    both = worst([of_thin, NeglectedEffects(), of_thick])
    assert both.mixed_above_roughness_m == 0.3e-6
    assert "0.3 µm (Rq) it would be mixed in the worst of 3 contacts;" in both.sentence
    assert NeglectedEffects.read(of_thin.summary()) == of_thin
    assert judged((), 0.01, (), None).sentence == ""
    assert judged((), 0.01, (2e-6, 1e-6), 0.5e-6).mixed_above_roughness_m is None


def test_simulated_roughness_is_told_with_its_share_and_its_bar():
    share = {"asperity_load_fraction": 0.031, "asperity_load_fraction_model_error": 0.5}
    mixed = NeglectedEffects({}, "mixed", 2.0, 1.5, rough=True, **share)
    assert not mixed.as_if_smooth
    assert mixed.qualified("Friction") == "Friction"
    assert mixed.sentence.endswith("; asperities carry 3.1 % ± 1.6 % (model) of the load.")
    assert NeglectedEffects.read(mixed.summary() | share) == mixed
    planned = NeglectedEffects({}, "mixed", 2.0, 1.5, rough=True)
    assert planned.sentence.endswith("times the composite roughness).")


def test_tables_begin_with_what_was_left_out_and_head_friction_as_if_smooth(case):
    solution = rough_worm()
    scene, summary = case.scene(phase=0.5), solution.summary()
    for table in (
        figures_table(scene, summary, {}),
        scenes_table([scene], [summary]),
        heat_table([scene], [summary]),
    ):
        assert f"{WORDS}; uncertainties: numerical" in table.title
    labels = figures_table(scene, summary, {}).column(0)
    assert (
        "Friction coefficient, smooth surfaces" in labels
        and "Power loss, smooth surfaces" in labels
    )
    separated = rough_worm(roughness=0.2e-6, effects=()).summary()
    plain = figures_table(scene, separated, {})
    assert "\n" not in plain.title and "Friction coefficient" in plain.column(0)


@pytest.mark.usefixtures("undrawn")
def test_pictures_and_reports_show_what_was_left_out(rough):
    assert WORDS.replace(" %", "\N{NO-BREAK SPACE}%") in heading("case", rough.solutions[0])
    report = build_report(rough)
    assert "mixed lubrication" in report.warnings[0] and WORDS in report.warnings[1]
    pictures = [
        block for part in report.sections for block in part.blocks if isinstance(block, Picture)
    ]
    assert pictures and all(
        WORDS in one.caption for one in pictures if not one.caption.startswith("Contacts on")
    )
    named = {part.title: part.blocks for part in report.sections}
    for title in ("Key results", "Film and pressure", "Friction, loss and temperature"):
        assert "uncertainties: numerical" in named[title][0]
    tables = [block for block in named["Key results"] if isinstance(block, Table)]
    rows = {row[0] for table in tables for row in table.rows}
    assert "Efficiency of the teeth, forward, smooth surfaces" in rows
    assert "  rough, by the standard" in rows


def test_ratings_head_the_simulation_as_if_smooth(rough, case):
    worm, flanks, films, *bearings = ratings(rating_request(case), rough)
    assert worm.headings == ("Standard", "Simulation, smooth surfaces")
    assert all(WORDS in rating.titled for rating in (worm, flanks, films))
    assert all(bearing.titled == bearing.title for bearing in bearings)
    assert "simulation" in worm.summary()


def test_rate_opens_with_the_lubrication(capsys):
    assert main(["rate", str(CASES / "errichello_speed_increaser.toml")]) == 0
    assert "runs in boundary lubrication" in capsys.readouterr().out.split("┏")[0]
    assert main(["rate", str(CASES / "oil_zi.toml"), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["lubrication"] == "mixed" and 1 < said["lambda_central"] < 3


def test_check_shows_what_the_plan_leaves_out(capsys, monkeypatch):
    without_allowed_errors(monkeypatch)
    line = ["check", str(CASES / "zi_sharif_2001.toml"), "--phase", "0.5"]
    assert main(line) == 0
    shown = capsys.readouterr().out
    assert "runs in mixed lubrication" in shown.split("│")[0]
    assert "neglected: squeeze up to" in " ".join(shown.split())
    assert main([*line, "--effects", "auto,-roughness,-squeeze", "--json"]) == 0
    (scene,) = json.loads(capsys.readouterr().out)["scenes"]
    off = {
        of["name"]: max(of["influence"].values())
        for of in scene["effects"]
        if not of["on"] and of["influence"]
    }
    assert scene["left_out"] == {
        name: pytest.approx(share) for name, share in off.items() if share > 0.01
    }
    assert {"roughness", "squeeze"} <= set(scene["left_out"])


def test_a_run_opens_with_what_was_left_out(tmp_path, capsys):
    text = (CASES / "ball_pag_460.toml").read_text()
    for before, after in (("0.02 um", "0.5 um"), ("0.05 um", "0.5 um")):
        assert f'roughness = "{before}"' in text
        text = text.replace(f'roughness = "{before}"', f'roughness = "{after}"')
    path = tmp_path / "rough.toml"
    path.write_text(text)
    line = ["run", str(path), "--accuracy", "20%", "--out", str(tmp_path / "out")]
    assert main([*line, "--effects", "auto,-roughness"]) == 0
    first = " ".join(capsys.readouterr().out.split("Quantity")[0].split())
    assert "This contact runs in boundary lubrication" in first
    assert "Neglected: roughness" in first and "smooth surfaces" in first
    assert first.index("Lubrication regime") < first.index("Minimum film thickness")
    assert "No friction, loss and efficiency by a standard" in first


# ------------------------------------------------------------------------------------ the table of a sweep


def test_a_sweep_s_table_shows_the_worst_of_its_scenes():
    def row(roughness, **changes):
        return rough_worm(roughness=roughness, **changes).summary()

    rows = [row(0.6e-6), row(0.9e-6), row(9e-6, converged=False)]
    values = [{"contact.load": f"{load} N"} for load in (1, 2, 3)]
    table = sweep_table(values, rows, ["a", "b", "c"])
    assert table["left_out_roughness"].values == pytest.approx([0.53] * 3)
    assert table["lubrication"].values.tolist() == ["mixed", "mixed", "unknown"]
    swept = SweepResult("s", "loads", [["contact.load"]], table, {})
    assert swept.neglected_effects.lambda_central == pytest.approx(1.4 / 0.9)
    shown = rows_table(swept)
    assert WORDS in shown.title
    assert "µ\nsmooth\nsurfaces" in shown.head
    odd = replace(swept, table=table.assign(lubrication=("scene", ["of no kind"] * 3)))
    assert odd.neglected_effects.lubrication == "unknown"


def test_a_sweep_s_table_has_every_effect_in_one_column():
    """Names are no components of a vector; a line's places have one, a point's two."""
    point, line = rough_worm().summary(), make_line_solution().summary()
    values = [{"contact.load": "1 N"}]
    effects = ["film-heating", "compressibility", "squeeze"]
    for row, directions in ((point, "xy"), (line, "x")):
        table = sweep_table(values, [row | {"effects": effects}], ["a"])
        assert table["effects"].values.tolist() == [",".join(effects)]
        assert [name for name in table if str(name).startswith("effects")] == ["effects"]
        places = [name for name in table if str(name).startswith("film_min_at_m")]
        assert places == [f"film_min_at_m_{axis}" for axis in directions]


# ------------------------------------------------------------------------------------ the standard's loss


def test_the_standard_s_loss_is_that_of_its_friction_and_lead(case):
    found = standard_loss(case)
    (rated, *_) = ratings(rating_request(case))
    standard = rated.summary()["standard"]
    assert found.friction == standard["friction"]
    # an output of T2 w2 asks for more by 1/eta: eta = tan gamma/tan(gamma + rho)
    lead = found.friction / standard["locking"]
    efficiency = lead / tan(atan(lead) + atan(found.friction))
    assert found.efficiency == pytest.approx(efficiency)
    output = case.drive.wheel_torque * 1500 * np.pi / 30 * 3 / 59
    assert found.power == pytest.approx(output * (1 / found.efficiency - 1))


def test_without_a_rating_table_the_case_s_own_oil_counts_or_the_reason_is_given(tmp_path):
    text = (CASES / "zi_sharif_2001.toml").read_text()
    start, end = text.index("[worm_rating]"), text.index("[bearings")
    bare = text[:start] + text[end:]
    bare = "\n".join(line for line in bare.splitlines() if not line.startswith("worm_rating."))
    path = tmp_path / "bare.toml"
    path.write_text(bare)
    unnamed = standard_loss(pyworm.load(path))
    assert isinstance(unnamed, NoStandard) and "worm_rating.oil is missing" in unnamed.reason
    start, end = bare.index("[oil]"), bare.index("[bearings")
    path.write_text(
        f'{bare[:start]}[oil]\nname = "PAG VG 460"\ntemperature = "60 degC"\n{bare[end:]}'
    )
    named = standard_loss(pyworm.load(path))
    whole = standard_loss(pyworm.load(CASES / "zi_sharif_2001.toml"))
    assert named.friction * 0.95 == pytest.approx(whole.friction)  # Y_W of its bronze
    for name, reason in (
        ("zi_drive", "worm_rating.oil is missing"),
        ("ball_pag_460", "a contact without gears"),
        ("spur_pair", None),
    ):
        other = standard_loss(pyworm.load(CASES / f"{name}.toml"))
        if reason is None:
            assert other.efficiency == pytest.approx(1 - other.power / 33e3, abs=1e-3)
        else:
            assert reason in other.reason


BOUNDARY_CYCLE = drive_cycle(cycle_result(PHASES, roughness=2e-6))


@pytest.mark.parametrize(("more", "by"), [(1.5, "standard"), (0.5, "simulation")])
def test_rough_teeth_are_warmed_by_the_larger_loss(more, by):
    smooth = BOUNDARY_CYCLE.loss.power
    found = heating_loss(BOUNDARY_CYCLE, StandardLoss(0.03, 0.9, more * smooth, "book"))
    assert found.by == by and found.power == max(more, 1.0) * smooth
    assert "smooth surfaces" in found.words and "book" in found.words


def test_separated_teeth_are_warmed_by_the_simulated_loss():
    cycle = drive_cycle(cycle_result(PHASES, roughness=0.05e-6))
    assert cycle.neglected_effects.lubrication == "full"
    found = heating_loss(cycle, StandardLoss(0.03, 0.9, 2 * cycle.loss.power, "book"))
    assert (found.by, found.power) == ("simulation", cycle.loss.power)


def test_the_table_of_losses_has_the_standard_beside():
    standard = StandardLoss(0.0312, 0.8812, 567.8, "book")
    table = loss_table(BOUNDARY_CYCLE, standard, None)
    assert table.head[1] == "Smooth surfaces"
    beside = dict(zip(table.column(0), table.column(2), strict=True))
    assert beside["Power loss of the teeth"] == "567.8 W"
    assert beside["Mean friction coefficient of the teeth"] == "0.0312"
    assert beside["Efficiency of the teeth"] == "88.1 %"
    assert len(loss_table(BOUNDARY_CYCLE, NoStandard("none"), None).head) == 2


def test_the_sump_is_as_warm_as_the_standard_s_loss_makes_it(tmp_path, monkeypatch):
    """Smooth teeth that lose 300 W, rough ones by the standard more: the balance ends on the latter."""
    text = (CASES / "zi_cooled.toml").read_text()
    for body in ("worm", "wheel"):
        text = text.replace(f"[bodies.{body}]", f'[bodies.{body}]\nroughness = "2 um"')
    text += '\n[worm_rating]\noil = "PAG VG 460"\n'
    path = tmp_path / "rough_cooled.toml"
    path.write_text(text)
    case = pyworm.load(path)
    loss = replace(BOUNDARY_CYCLE.loss, power=300.0, friction=0.0096)
    cycle = replace(BOUNDARY_CYCLE, loss=loss, lifts=())
    said, solved = [], []
    monkeypatch.setattr(
        drive_iteration, "run", lambda case, tasks, **how: solved.append(tasks[0].case)
    )
    monkeypatch.setattr(drive_iteration, "drive_cycle", lambda result: cycle)
    tasks = [pyworm.batch.task.Task(case, place, 0.03) for place in case.places()]
    _, tasks = drive_iteration.run_balanced(case, tasks, tmp_path, print_message=said.append)
    power = standard_loss(case).power
    assert power > 1000
    sump = tasks[0].case.drive.oil.heat.inlet_temperature - 273.15
    assert sump == pytest.approx(20 + (power + 500) / 40, abs=0.5)
    assert (
        f"{power:.4g} W of rough teeth" in said[0]
        and "300 W simulated with smooth surfaces" in said[0]
    )
    heating = heating_of(tasks[0].case, cycle, standard_loss(case))
    assert heating.summary() == {
        "taken_W": pytest.approx(power, rel=5e-3),
        "found_W": power,
        "by": "standard",
        "other_W": 500.0,
        "other_by": "given",
        "whole_W": power + 500,
    }
    assert "lose 500 W as given" in heating.words


def test_a_cycle_s_json_begins_with_the_worst_of_its_scenes():
    told = BOUNDARY_CYCLE.summary()
    assert list(told)[:2] == ["left_out", "lubrication"]
    assert told["lubrication"] == "boundary"
    central = min(of.figures.film_central.value for of in cycle_result(PHASES).solutions)
    assert told["lambda_central"]["value"] == pytest.approx(central / 2e-6)


def test_a_plan_without_roughness_expects_the_film_of_smooth_surfaces():
    """That which asperities keep open is expected only where they are simulated."""
    scene = pyworm.load(CASES / "errichello_speed_increaser.toml").scene(phase=0.5)
    rough, smooth = (
        expected(scene, pyworm.plan(scene, 0.05, effects))
        for effects in ("auto", ("auto", "-roughness"))
    )
    assert smooth.lambda_central < 0.15 < rough.lambda_central
    assert smooth.as_if_smooth and not rough.as_if_smooth
