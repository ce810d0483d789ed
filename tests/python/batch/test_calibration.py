"""Values fitted to measurements of a made-up bench: the truth is found, and what cannot be is named."""

import re
from dataclasses import replace

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.batch.calibrate import calibration
from pyworm.batch.calibration import Bench, Responses, fitted
from pyworm.batch.operating_points import NotSolvedError, OperatingPoint, Solving
from pyworm.case.measured_table import Measurement
from pyworm.case.parameters import parameters

TRUTH = np.array([0.227, 0.25])
"""z, and viscosity [Pa s]."""

FITTED = ("z", "oil.viscosity.eta0")

ERROR = 0.03
"""Relative standard uncertainty of the films."""

DRAWS = 20

RIG = ROOT / "cases/film_rig.toml"


def bench(directory, loads, fit=FITTED, speeds=(0.02, 0.4)):
    """A rig that measures central films, without its measurements."""
    case = pyworm.load(RIG)
    rows = tuple(
        Measurement(
            number,
            "film_central",
            1e-7,
            1e-9,
            {"contact.load": f"{load} N", "motion.mean_velocity[0]": f"{speed} m/s"},
            {},
        )
        for number, (load, speed) in enumerate([(load, u) for load in loads for u in speeds], 2)
    )
    return Bench(case, rows, parameters(case, fit), Solving(directory, 0.05, ("auto",)))


def measured(rig, films, error=ERROR):
    """The rig with films that it measures."""
    rows = (
        replace(row, value=float(film), standard=float(error * film))
        for row, film in zip(rig.rows, films, strict=True)
    )
    return replace(rig, rows=tuple(rows))


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    return bench(tmp_path_factory.mktemp("rig"), (1, 10, 100))


@pytest.fixture(scope="module")
def films(rig):
    (found,) = rig.responses([TRUTH])
    return found.values


def test_the_truth_lies_within_the_intervals_of_19_of_20_draws(rig, films):
    generator = np.random.default_rng(50)
    within = 0
    for _ in range(DRAWS):
        noisy = films * (1 + ERROR * generator.standard_normal(len(films)))
        found = fitted(measured(rig, noisy))
        within += bool((np.abs(found.values - TRUTH) <= found.statistics.half_widths).all())
    print(f"{within} of {DRAWS}")
    assert within >= 19


def test_exact_films_give_the_truth(rig, films):
    found = calibration(measured(rig, films), "films.csv")
    # a fit ends at a tenth of the uncertainty, here 3 %
    assert [value.value for value in found.values] == pytest.approx(TRUTH, rel=3e-3)
    assert found["z"].start == 0.35 and not found["z"].at_bound
    assert max(abs(row.leave_one_out / row.standard) for row in found.rows) < 0.1
    assert "The data determine every free value" in found.statements[0]


class StraightBench:
    """A bench whose responses are straight in the parameters, far from their start."""

    start = np.array([3.0, 0.5])
    bounds = (start / 5, start * 5)
    logarithmic = np.zeros(8, bool)
    uncertainties = np.array([0.13, 0.21, 0.25, 0.17, 0.11, 0.29, 0.15, 0.22])
    lines = np.c_[np.ones(8), np.linspace(1, 5, 8)]
    measured = lines @ [1.5, 0.8] + uncertainties * [0.4, -1.1, 0.9, 0.2, -0.6, 1.8, -1.5, 0.3]
    rows = range(8)

    def responses(self, every):
        return [Responses(self.lines @ values, np.zeros(8)) for values in every]

    def exact(self, chosen):
        """Parameters and their covariance by the normal equations of some rows."""
        weighted = (self.lines / self.uncertainties[:, None])[chosen]
        inverse = np.linalg.inv(weighted.T @ weighted)
        return inverse @ weighted.T @ (self.measured / self.uncertainties)[chosen], inverse


def test_statistics_of_a_straight_model_are_those_of_the_normal_equations():
    """Uncertainties come from slopes at the optimum, not from a parabola half of the start away."""
    straight = StraightBench()
    found = fitted(straight)
    values, covariance = straight.exact(slice(None))
    residuals = (straight.measured - straight.lines @ values) / straight.uncertainties
    enlargement = max(1.0, float(np.sqrt(residuals @ residuals / 6)))
    standard = enlargement * np.sqrt(np.diag(covariance))
    assert found.values == pytest.approx(values, rel=1e-3)
    assert found.statistics.standard == pytest.approx(standard, rel=0.02)
    # Student's t for 6 degrees of freedom
    assert found.statistics.half_widths == pytest.approx(2.4469 * standard, rel=0.02)
    left_out = [
        straight.measured[row] - straight.lines[row] @ straight.exact(np.arange(8) != row)[0]
        for row in range(8)
    ]
    assert found.leave_one_out == pytest.approx(np.array(left_out), abs=2e-3)


def test_films_of_one_regime_fix_a_product_alone(tmp_path):
    """At one load far in the piezoviscous regime both raise films alike."""
    rig = bench(tmp_path, (20,), speeds=(0.1, 0.2, 0.4))
    (truth,) = rig.responses([TRUTH])
    found = calibration(measured(rig, truth.values, error=0.1), "films.csv")
    (sentence, *_) = found.statements
    print(sentence)
    assert re.match(r"The data fix only z\^0\.\d+ oil\.viscosity\.eta0 \(to", sentence)


def test_a_value_beyond_its_bound_is_held_there(rig, films, tmp_path):
    case = rig.case
    held = replace(rig, parameters=parameters(case, ["z = 0.3 to 0.5", FITTED[1]]))
    found = calibration(measured(held, films), "films.csv")
    assert found["z"].at_bound and found["z"].value == pytest.approx(0.3)
    assert found["z"].standard == 0
    assert "or at a bound: z" in found.save(tmp_path / "fitted.toml").read_text()
    assert any("z is at its bound" in sentence for sentence in found.statements)
    assert any("times the stated uncertainties" in sentence for sentence in found.statements)


def test_what_the_data_cannot_see_is_said_without_a_nothing(rig, films):
    blind = replace(rig, parameters=parameters(rig.case, ["oil.heat.conductivity"]))
    found = calibration(measured(blind, films, error=1.0), "films.csv")
    assert found.statements[0] == "The data do not determine oil.heat.conductivity."
    held = replace(rig, parameters=parameters(rig.case, ["z = 0.3 to 0.5"]))
    (sentence, *_) = calibration(measured(held, films), "films.csv").statements
    assert sentence.startswith("z is at its bound")


def test_a_case_takes_the_file_of_fitted_values(rig, films, tmp_path):
    found = calibration(measured(rig, films), "films.csv")
    found.save(tmp_path / "fitted.toml")
    text = RIG.read_text().replace('title = "', 'fitted = "fitted.toml"\ntitle = "', 1)
    (tmp_path / "rig.toml").write_text(text)
    case = pyworm.load(tmp_path / "rig.toml")
    assert case.tables.oil.viscosity.z == pytest.approx(found["z"].value, rel=1e-5)
    assert case.tables.oil.viscosity.eta0 == pytest.approx(found.values[1].value, rel=1e-5)
    keys = ["oil.viscosity.z", "oil.viscosity.eta0"]
    assert set(case.uncertain.values) == set(keys)
    assert case.uncertain.correlation(*keys) == pytest.approx(found.correlation[0][1], abs=1e-4)
    assert "fitted by pyworm calibrate" in case.tables.assumed["oil.viscosity.z"]


def test_a_contact_without_a_solution_ends_a_fit_with_the_reason(tmp_path, monkeypatch):
    rig = bench(tmp_path, (20,), speeds=(0.1, 0.2, 0.4))
    points = [replace(point, by_formula=False) for point in rig.points(TRUTH)]
    monkeypatch.setattr(
        "pyworm.batch.operating_points.solve_all",
        lambda tasks, *how: {task.key: "no film" for task in tasks},
    )
    with pytest.raises(NotSolvedError, match="could not be solved: no film"):
        rig.solving.results(points)


class FakeStore:
    """Scalars of films that did not converge."""

    def __init__(self, directory, fields):
        self.directory = directory

    def missing(self, tasks):
        return []

    def summary(self, task):
        return {"converged": False, "stop_reason": "too thin"}


def test_a_contact_that_did_not_converge_ends_a_fit_with_the_reason(tmp_path, monkeypatch):
    rig = bench(tmp_path, (20,), speeds=(0.1, 0.2, 0.4))
    (point, *_) = (replace(point, by_formula=False) for point in rig.points(TRUTH))
    monkeypatch.setattr("pyworm.batch.operating_points.Store", FakeStore)
    with pytest.raises(NotSolvedError, match="did not converge: too thin"):
        rig.solving.results([point])


def test_what_a_case_does_not_compute_is_refused(rig):
    rows = tuple(replace(row, quantity="sump_temperature") for row in rig.rows)
    with pytest.raises(
        pyworm.CaseError, match="measurements, line 2: sump_temperature is that of gears"
    ):
        replace(rig, rows=rows)
    friction = tuple(replace(row, quantity="friction_coefficient") for row in rig.rows)
    with pytest.raises(pyworm.CaseError, match="measurements, line 2: film_rig does not"):
        replace(rig, rows=friction)._of_rows([{}] * len(friction))


def test_a_line_contact_has_no_film_of_the_atlas(tmp_path):
    case = pyworm.load(ROOT / "cases/line_m20_l10.toml")
    point = OperatingPoint(case, case.places(), ("film",), by_formula=True)
    with pytest.raises(ValueError, match="the atlas has point contacts alone"):
        Solving(tmp_path, 0.05, ("auto",)).results([point])
