"""Comparison with measurements: arithmetic of E and u_val, moved inputs, rows of the recorded table."""

import json
from math import sqrt
from types import SimpleNamespace

import computed_rows
import pytest
from comparison_error import AGREES, DISAGREES, MODEL, Comparison, Computed, share
from computed_rows import COVERAGE, computed
from evidence_data import read
from folders import ROOT
from measured import COLUMNS, Compared

from pyworm.case.experiment import read_experiment, read_experiments

VALIDATION = ROOT / "validation"
RECORDED = {
    (row[0], row[1], row[2]): dict(zip(COLUMNS, row, strict=True)) for row in read("measured").rows
}


def number(text):
    return float(text.split()[0])


def test_the_uncertainty_of_a_comparison_by_hand():
    """S = 107 +- 1, moved by 2 and -2 by its inputs, against D = 100 +- 2: sqrt(1 + 8 + 4)."""
    found = Computed(107.0, 1.0, 0.0, {"load": 2.0, "speed": -2.0})
    compared = Comparison(found, 100.0, 2.0)
    assert compared.error == 7.0
    assert found.by_inputs == pytest.approx(sqrt(8))
    assert compared.uncertainty == pytest.approx(sqrt(13))
    assert found.largest_input == "load"


@pytest.mark.parametrize(
    ("value", "model", "verdict"),
    [(103.6, 0.0, AGREES), (96.4, 0.0, AGREES), (107.0, 3.3, DISAGREES), (107.0, 3.5, MODEL)],
)
def test_verdicts(value, model, verdict):
    found = Computed(value, 1.0, model, {"load": 2.0, "speed": -2.0})
    assert Comparison(found, 100.0, 2.0).verdict == verdict


def test_shares_count_the_verdicts_asked_for():
    verdicts = [AGREES, MODEL, MODEL, DISAGREES]
    assert share(verdicts, AGREES) == 0.25
    assert share(verdicts, AGREES, MODEL) == 0.75


def test_inputs_move_by_their_standard_uncertainties(monkeypatch):
    """With a film of load^2 speed/alpha in place of a solution."""

    def solved(content, folder, place, effects, accuracy):
        case = json.loads(content)
        load = float(case["contact"]["load"].split()[0])
        speed = float(case["motion"]["velocity_1"][0].split()[0])
        alpha = float(case["oil"]["viscosity"]["alpha"].split()[0])
        figures = SimpleNamespace(
            film_exit_min=load**2 * speed / alpha, film_min=SimpleNamespace(error=0.04)
        )
        return None, (SimpleNamespace(figures=figures),)

    monkeypatch.setattr(computed_rows, "_solved", solved)
    experiment = read_experiment(VALIDATION / "mourier_2006.toml")
    rolling = [row for row in experiment.rows if row.quantity == "film_exit_min"][:1]
    ((_, found),) = computed(experiment.model_copy(update={"rows": rolling}), VALIDATION)
    relative = {name: part / found.value for name, part in found.inputs.items()}
    assert found.value == pytest.approx(15**2 * 0.09 / 22)
    assert found.numerical == pytest.approx(0.04 / COVERAGE * found.value)
    assert relative["contact.load"] == pytest.approx(0.02, rel=1e-3)
    assert relative["motion.velocity_1[0], motion.velocity_2[0]"] == pytest.approx(0.01, rel=1e-3)
    assert relative["oil.viscosity.alpha"] == pytest.approx(-0.05, rel=5e-3)
    assert relative["oil.viscosity.eta0"] == 0


@pytest.mark.parametrize("name", ["madrid_2016", "mann_1995", "stachowiak", "bair"])
def test_recorded_rows_of_oils_are_what_is_computed(name):
    experiment = read_experiment(VALIDATION / f"{name}.toml")
    for row, found in computed(experiment, VALIDATION):
        measured = experiment.measured(row)
        cells = Compared(
            experiment, row, Comparison(found, measured.value, measured.standard)
        ).cells()
        assert RECORDED[cells[:3]] == dict(zip(COLUMNS, cells, strict=True))


def test_every_measured_row_is_recorded_with_its_value():
    """Those of contacts, too, whose figures are not solved anew here."""
    rows = [
        Compared(
            experiment, row, Comparison(Computed(1.0, 0.0, 0.0), measured.value, measured.standard)
        )
        for experiment in read_experiments(VALIDATION).values()
        for row in experiment.rows
        for measured in [experiment.measured(row)]
    ]
    assert len(rows) == len(RECORDED) >= 40
    assert len({row.source for row in rows}) >= 5
    for row in rows:
        cells = row.cells()
        recorded = RECORDED[cells[:3]]
        measured, computed_value = number(recorded["measured"]), number(recorded["computed"])
        assert recorded["measured"] == cells[COLUMNS.index("measured")]
        assert recorded["u_D"] == cells[COLUMNS.index("u_D")]
        error = (computed_value / measured - 1) * 100
        assert number(recorded["E"]) == pytest.approx(error, abs=0.16 + 0.001 * abs(error))
        parts = sqrt(sum(number(recorded[name]) ** 2 for name in ("u_D", "u_num", "u_input")))
        assert number(recorded["u_val"]) == pytest.approx(parts, abs=0.15)
        assert (recorded["verdict"] == AGREES) == (
            abs(number(recorded["E"])) <= number(recorded["u_val"])
        )
