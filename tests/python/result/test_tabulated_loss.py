"""Losses read from the file of a loss table, between its points and beyond them."""

import numpy as np
import pytest

from pyworm.formulas.unit_factors import RPM
from pyworm.result.tabulated_loss import read_loss_table

HEAD = "worm_speed_rpm,wheel_torque_N_m,oil_temperature_C,friction_torque_N_m"


@pytest.fixture
def table(tmp_path):
    """Loss 3 T^1.2 n^0.5 exp(-0.01 theta), in W, N m, rpm and degC."""
    rows = [
        f"{rpm},{torque},{warm},{3 * torque**1.2 * rpm**0.5 * np.exp(-0.01 * warm) / (rpm / RPM)}"
        for rpm in (500, 1500)
        for torque in (50, 100, 400)
        for warm in (20, 90)
    ]
    path = tmp_path / "table.csv"
    path.write_text("\n".join([HEAD, *rows[::-1], ""]))
    return read_loss_table(path)


def test_powers_and_exponentials_are_met_between_the_points(table):
    expected = 3 * 70**1.2 * 800**0.5 * np.exp(-0.01 * 55)
    assert table.at(800 / RPM, 70.0, 55 + 273.15) == pytest.approx(expected, rel=1e-9)
    hot, cold = table.at(500 / RPM, 50.0, 500.0), table.at(500 / RPM, 50.0, 200.0)
    assert cold / hot == pytest.approx(np.exp(0.7))


def test_other_speeds_and_torques_are_refused(table):
    with pytest.raises(ValueError, match="speed 1600 rpm is not between the 500 and 1500 rpm"):
        table.at(1600 / RPM, 70.0, 300.0)
    with pytest.raises(ValueError, match="torque 20 N m is not between"):
        table.at(800 / RPM, 20.0, 300.0)


def test_a_table_of_one_speed_is_one_of_torques(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text(f"{HEAD}\n1000,10,60,1\n1000,20,60,2\n")
    power = read_loss_table(path).at(1000 / RPM, 15.0, 300.0)
    assert power == pytest.approx(1.5 * 1000 / RPM, rel=1e-6)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a,b\n1,2\n", "no column worm_speed_rpm"),
        (f"{HEAD}\n1,2,3\n", "no number"),
        (f"{HEAD}\n", "above 0"),
        (f"{HEAD}\n1,2,3,0\n", "above 0"),
        (f"{HEAD}\n1,2,3,1\n2,3,3,1\n", "no whole grid"),
    ],
)
def test_other_files_are_refused(tmp_path, text, words):
    path = tmp_path / "table.csv"
    path.write_text(text)
    with pytest.raises(ValueError, match=words):
        read_loss_table(path)
    with pytest.raises(ValueError, match="no such file"):
        read_loss_table(tmp_path / "none.csv")
