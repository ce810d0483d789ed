"""What summaries and tables say of friction and heat, and that they say nothing where none was simulated."""

import json
from dataclasses import replace
from io import StringIO

import pytest
from folders import CASES
from rich.console import Console
from synthetic_solution import (
    INLET,
    line_with_heat,
    make_hot_worm,
    make_line_solution,
    make_solution,
    without_heat,
)

from pyworm.case.case import load
from pyworm.report.console.scenes import figures_table, heat_table
from pyworm.solver.solution import Estimate

SHEAR_KEYS = {"friction_coefficient", "power_loss_W", "shear_rate_max_1_s"}
HEAT_KEYS = {
    "inlet_temperature_C",
    "temperature_max_C",
    "temperature_max_error_K",
    "heat_balance",
}


@pytest.fixture(scope="module")
def hot():
    figures = {
        "temperature_max_body_1": Estimate(108 + 273.15, 0.01),
        "temperature_max_body_2": Estimate(106 + 273.15, 0.02, 0.015, 0.0, 0.005),
        "temperature_max_film": Estimate(117 + 273.15, 0.016, 0.012),
        "friction_coefficient": Estimate(0.0231, 0.0024, 0.0032),
        "power_loss": Estimate(1234.0, 0.006),
        "shear_rate_max": Estimate(1.1e7, 0.05),
    }
    worm = make_hot_worm()
    return replace(worm, figures=replace(worm.figures, **figures))


@pytest.fixture(scope="module")
def drive():
    return load(CASES / "zi_sharif_2001.toml")


def printed(table):
    console = Console(file=StringIO(), width=120)
    console.print(table)
    return console.file.getvalue()


def test_temperatures_are_shown_in_celsius_with_errors_in_kelvin(hot):
    summary = hot.summary()
    assert INLET == 333.15
    assert summary["inlet_temperature_C"] == pytest.approx(60)
    assert summary["temperature_max_C"] == pytest.approx(
        {"body_1": 108, "body_2": 106, "film": 117}
    )
    # of the rise over the inlet: 1 % of 48 K, 3 % of 46 K, 2 % of 57 K
    errors = {"body_1": 0.48, "body_2": 1.38, "film": 1.14}
    assert summary["temperature_max_error_K"] == pytest.approx(errors)


def test_friction_power_and_shear_rate_have_error_bars(hot):
    summary = hot.summary()
    assert summary["friction_coefficient"] == 0.0231
    assert summary["friction_coefficient_error"] == pytest.approx(0.004)
    assert summary["friction_coefficient_error_domain"] == 0.0032
    assert (summary["power_loss_W"], summary["power_loss_error"]) == (1234.0, 0.006)
    assert (summary["shear_rate_max_1_s"], summary["shear_rate_max_error"]) == (1.1e7, 0.05)
    assert json.loads(json.dumps(summary)) == summary


def test_quantities_not_simulated_have_no_key(hot):
    assert set(hot.summary()) >= SHEAR_KEYS | HEAT_KEYS
    sheared = set(without_heat(hot).summary())
    assert sheared >= SHEAR_KEYS and not sheared & HEAT_KEYS
    assert not set(make_solution().summary()) & (SHEAR_KEYS | HEAT_KEYS)


def test_the_power_of_a_line_contact_is_that_for_each_length():
    summary = line_with_heat(make_line_solution()).summary()
    assert "power_loss_W" not in summary
    assert summary["power_loss_per_length_W_m"] > 1e3


def test_the_table_of_a_scene_shows_heat_beside_what_is_published(hot, drive):
    said = printed(
        figures_table(drive.scene(0.5), hot.summary(), drive.published, drive.body_names)
    )
    for label, value, published in (
        ("Maximum surface temperature (worm)", "108.0 °C ± 0.48 K", "108 degC"),
        ("Maximum surface temperature (wheel)", "106.0 °C ± 1.4 K", "106 degC"),
        ("Maximum film temperature", "117.0 °C ± 1.1 K", "117 degC"),
        ("Friction coefficient", "0.0231 ± 0.4 %", ""),
        ("Power loss", "1234 W ± 0.6 %", ""),
        ("Maximum shear rate", "1.1e+07 1/s ± 5 %", ""),
        ("Relative heat imbalance", "0.3 %", ""),
    ):
        (row,) = (line for line in said.splitlines() if label in line)
        assert value in row and published in row


def test_the_table_of_a_scene_without_heat_has_no_temperatures(drive):
    said = printed(figures_table(drive.scene(0.5), make_solution().summary(), drive.published))
    assert "temperature" not in said and "Friction" not in said
    line = line_with_heat(make_line_solution())
    scene = load(CASES / "line_m20_l10.toml").scene()
    assert "kW/m" in printed(figures_table(scene, line.summary(), {}))


def test_the_table_of_all_scenes_compares_friction_and_heat(hot, drive):
    scenes = list(drive.scenes(phase=[0.3, 0.5]))
    said = printed(heat_table(scenes, [hot.summary()] * 2, drive.body_names))
    assert all(word in said for word in ("Film", "Worm", "Wheel"))
    assert "Film" in said and "± K" in said
    (row,) = (line for line in said.splitlines() if line.startswith(" 0.3 "))
    for cell in ("0.0231", "1234", "108.0", "106.0", "117.0", "1.4"):
        assert cell in row
    assert "Film" not in printed(heat_table(scenes, [without_heat(hot).summary()] * 2))
