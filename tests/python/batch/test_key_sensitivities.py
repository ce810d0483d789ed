"""Derivatives of results by the numbers of a case: against power laws, and through a known change."""

import json
from dataclasses import replace

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.batch import key_sensitivities as module
from pyworm.batch import run_sensitivities
from pyworm.batch.case_figures import (
    case_values,
    closed_form_summary,
    figures_of,
    moved_summary,
)
from pyworm.batch.key_sensitivities import Solved, by_closed_forms, key_sensitivities, moved_case
from pyworm.batch.operating_points import OperatingPoint
from pyworm.case.case import case_without_contacts
from pyworm.case.dotted_keys import with_values
from pyworm.case.numeric_keys import found_keys, numeric_key, numeric_keys
from pyworm.cli.main import main
from pyworm.ratings.standard_loss import StandardLoss
from pyworm.solver.adjoint import NoAdjointError
from pyworm.solver.alike import laws_alike, spread_alike


@pytest.fixture(scope="module")
def ball():
    return pyworm.load(ROOT / "cases/ball_pag_460.toml")


@pytest.fixture(scope="module")
def found(ball):
    return key_sensitivities(by_closed_forms(ball))


@pytest.mark.parametrize(
    ("key", "power"),
    [("contact.load", 1 / 3), ("bodies.body_1.poisson_ratio", None), ("oil.temperature", 0.0)],
)
def test_hertz_pressure_follows_its_power_law(found, key, power):
    """p is proportional to F^(1/3) (Hertz 1881); with the modulus to the power 2/3 of its share."""
    each = found[key]
    relative = each.derivatives["pressure_max"] * each.value / found.results["pressure_max"]
    if power is None:  # (1 - nu^2)/E of body 1 over that of both
        parts = [(1 - nu**2) / modulus for nu, modulus in ((0.3, 207.0), (0.35, 120.0))]
        power = 2 / 3 * 2 * 0.3**2 / (1 - 0.3**2) * parts[0] / sum(parts)
    assert relative == pytest.approx(power, abs=1e-6)


def test_specific_film_falls_with_roughness_as_their_ratio(found):
    """Of the composite roughness of 20 and 50 nm, 0.05^2 over both squares is the second body's."""
    each = found["bodies.body_2.roughness"]
    relative = each.derivatives["specific_film"] * each.value / found.results["specific_film"]
    film = each.derivatives["film_min"] * each.value / found.results["film_min"]
    assert relative - film == pytest.approx(-(0.05**2) / (0.02**2 + 0.05**2), rel=1e-4)


class OfLoad:
    """Figures of a contact that follow its load alone: a film of 2 nm less for each newton more."""

    def __init__(self):
        self.figures = {"film_min": 1e-6}

    def change(self, plus, minus):
        return {"film_min": -2e-9 * (plus.load - minus.load)}


def test_a_change_of_a_contact_reaches_the_key_through_the_closed_forms(ball):
    point = OperatingPoint(ball, ball.places())
    summary = closed_form_summary(ball.scene()) | {"film_min_m": 0.5e-6}
    solved = Solved(point, (summary,), (OfLoad(),))
    known = key_sensitivities(solved, keys=[numeric_key(ball, "contact.load")])["contact.load"]
    # kN, and half of the change, since the solved film is half as thick
    assert known.derivatives["film_min"] == pytest.approx(-2e-9 * 1e3 * 0.5, rel=1e-9)
    assert known.change_words == "1%" and known.change == pytest.approx(0.6e-3)


def test_numbers_that_cannot_be_moved_are_named_with_the_reason():
    case = pyworm.load(ROOT / "cases/roller_ref.toml")
    number = numeric_key(case, "drive.rollers.half_angle")
    found = key_sensitivities(by_closed_forms(case, case.places()[:1]), keys=[number])
    assert not found.keys and "to a cone only" in found.not_varied["drive.rollers.half_angle"]
    assert json.dumps(found.summary())


def test_a_missing_number_is_refused_with_those_nearby(ball):
    with pytest.raises(pyworm.CaseError, match=r"no such number; it has contact.radii\[0\]"):
        numeric_key(ball, "contact.radius")
    assert "motion.slide_roll_ratios" not in {number.key for number in numeric_keys(ball)}


def test_temperatures_move_by_degrees(ball):
    scene = ball.scene()
    summary = closed_form_summary(scene)
    moved = moved_summary(summary, scene, {"temperature_max_film": 2.0}, {})
    names = ["temperature_max_film", "specific_film"]
    before, after = (
        figures_of(OperatingPoint(ball, ball.places()), [each], names) for each in (summary, moved)
    )
    assert after[names[0]].value - before[names[0]].value == pytest.approx(2.0)
    assert after[names[1]] == before[names[1]]


def test_a_run_has_sensitivities_by_adjoints_or_by_closed_forms(tmp_path, capsys, monkeypatch):
    """Of an isothermal ball: the maximum pressure follows the load to the power of a third, nearly."""
    words = [
        "run",
        str(ROOT / "cases/ball_pag_460.toml"),
        "--effects",
        "isothermal",
        "--accuracy",
        "10%",
    ]
    words += ["--pictures", "none", "--sensitivities", "--out", str(tmp_path)]
    assert main(words) == 0
    shown = capsys.readouterr().out
    assert "Sensitivities of ball_pag_460" in shown and "by adjoint solutions" in shown
    found = json.loads((tmp_path / "sensitivities.json").read_text())["keys"]["contact.load"]
    assert found["changes"]["pressure_max"] / 0.8e9 == pytest.approx(0.01 / 3, rel=0.1)

    def none(scene, plan, solution):
        raise NoAdjointError("oil in plenty")

    monkeypatch.setattr(run_sensitivities, "adjoint_of", none)
    assert main([*words, "--json"]) == 0
    shown = capsys.readouterr()
    assert "changes by closed forms: oil in plenty" in shown.err
    changes = json.loads(shown.out)["sensitivities"]["keys"]["contact.load"]["changes"]
    assert changes["pressure_max"] / 0.8e9 == pytest.approx(0.01 / 3, rel=0.02)


@pytest.fixture(scope="module")
def cooled():
    """A worm gear set of which the loss between the teeth warms the housing."""
    case = pyworm.load(ROOT / "cases/gearbox_test.toml")
    housing = {
        "cooling.ambient_temperature": "20 degC",
        "cooling.conductance": "8 W/K",
        "cooling.other_loss": "200 W",
    }
    content = with_values(case.content, housing)
    return case_without_contacts(content, case.name, case.directory)


def by_conductance(case, conductance):
    content = with_values(case.content, {"cooling.conductance": f"{conductance!r} W/K"})
    return case_without_contacts(content, case.name, case.directory)


def held(case, loss, friction):
    """The case by closed forms with some loss and friction, and its results."""
    found = {"cooling": {"tooth_loss": loss}, "operation": {"friction": friction}}
    solved = by_closed_forms(case.with_found(found))
    results = figures_of(solved.point, solved.summaries)
    return solved, {name: each.value for name, each in results.items()}


def balanced(case, loss, friction):
    """The same with the loss and the friction that its contacts have."""
    for _ in range(4):
        solved, results = held(case, loss, friction)
        loss, friction = results["power_loss"], results["friction_coefficient"]
    return solved, results


@pytest.mark.long
def test_temperatures_and_loads_follow_the_loss_and_the_friction(cooled):
    """Derivatives against differences of cases whose balances of heat and torques are found anew."""
    solved, results = balanced(cooled, 113.2, 0.00888)
    start = results["power_loss"], results["friction_coefficient"]
    assert [each.key for each in found_keys(solved.point.case)] == [*module.FOUND]
    number = numeric_key(solved.point.case, "cooling.conductance")
    found = key_sensitivities(solved, keys=[number])["cooling.conductance"].derivatives
    less, more = (balanced(by_conductance(cooled, 8 + side), *start)[1] for side in (-0.01, 0.01))
    for name in ("film_min", "power_loss", "sump_temperature", "temperature_max_body_1"):
        assert found[name] == pytest.approx((more[name] - less[name]) / 0.02, rel=1e-4), name
    assert not found.keys() & module.FOUND


def test_a_standard_s_loss_warms_the_teeth_whatever_their_friction(cooled, monkeypatch):
    def standard(case):
        return StandardLoss(0.03, 0.9, 10.0 * case.tables.cooling.conductance, "a test")

    monkeypatch.setattr(module, "standard_loss", standard)
    solved, _ = held(cooled, 80.0, 0.0089)
    number = numeric_key(solved.point.case, "cooling.conductance")
    found = key_sensitivities(replace(solved, heated_by="standard"), keys=[number])
    less, more = (held(by_conductance(cooled, each), 10 * each, 0.0089)[1] for each in (7.99, 8.01))
    name = "temperature_max_body_2"
    slope = (more[name] - less[name]) / 0.02
    assert found["cooling.conductance"].derivatives[name] == pytest.approx(slope, rel=1e-3)


def test_teeth_that_move_alike_are_found_alike():
    """Of two drives by the same numbers; a thousandth of the speed tells them apart."""
    case = pyworm.load(ROOT / "cases/zi_sharif_2001.toml")
    scenes = [
        moved_case(case, values).scene(phase=0.5)
        for values in (
            {"operation.load": "14.1 kN"},
            {"operation.load": "14 kN"},
            {"operation.worm_speed": "1501.5 rpm"},
        )
    ]
    places = np.meshgrid([0.0, 1e-3], [0.0, 1e-3], indexing="ij")
    assert spread_alike(scenes[0], scenes[1], places)
    assert laws_alike(scenes[0], scenes[1], places, heated=True, rough=True)
    assert not spread_alike(scenes[1], scenes[2], places)
    assert not laws_alike(scenes[1], scenes[2], places, heated=False, rough=False)


@pytest.mark.long
def test_figures_that_no_contact_decides(ball):
    """The contact of Sharif et al. (2001) lies within the face, 60.33 mm wide; a ball has no face."""
    worm = pyworm.load(ROOT / "cases/zi_sharif_2001.toml")
    margin = case_values(worm, ["film_min", "pattern_margin"])["pattern_margin"]
    first, last = worm.drive.driven_pattern.along_face()
    assert 0 < margin < 60.33e-3 / 2 and last - first + 2 * margin <= 60.33e-3 + 1e-12
    assert case_values(ball, ["pattern_margin"]) == {} == case_values(worm, ["film_min"])
    roller = pyworm.load(ROOT / "cases/roller_ref.toml")
    printed = case_values(roller, ["printed_film_min"])["printed_film_min"]
    # 0.856 um at entry in the middle of the line (docs/evidence/data/roller_films.csv), less at its end
    assert 0.8 * 0.856e-6 < printed < 0.856e-6
