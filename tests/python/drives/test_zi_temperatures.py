"""Temperatures of a worm drive from its losses; the search for a loss that agrees with itself."""

import tomllib

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.batch import drive_iteration
from pyworm.batch.task import Task
from pyworm.case.case import case_of
from pyworm.drives.tooth_loss import Loss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.result.mesh_cycle import DriveCycle, Extreme


@pytest.fixture(scope="module")
def case():
    return pyworm.load(CASES / "zi_cooled.toml")


def with_loss(case, power):
    return case.with_found({"cooling": {"tooth_loss": power}})


def test_heat_leaves_through_the_housing_and_the_wheel(case):
    drive = with_loss(case, 1100.0).drive
    sump = 20 + (1100 + 500) / 40
    assert drive.oil.heat.inlet_temperature - ZERO_CELSIUS == pytest.approx(sump)
    worm, wheel = (body.bulk_temperature - ZERO_CELSIUS for body in drive.bodies)
    # c_k (1940 + 15 n1) of DIN 3996 on the rim of the wheel, z2 px/pi by b2
    rim = 59 * 28.73e-3 / np.pi * 60.33e-3
    assert wheel == pytest.approx(sump + 1100 / ((1940 + 15 * 1500) * rim))
    assert worm == pytest.approx(wheel + 15)
    assert drive_iteration.tooth_loss_of(with_loss(case, 1100.0)) == pytest.approx(1100)


def test_losses_besides_the_teeth_are_the_standards_unless_given(case):
    """8.9e-5 a n^(4/3), 0.03 P2 a^0.44 u/d_m2 and twice 1.178e-5 d_m1^2 n in W, mm and rpm."""
    text = (CASES / "zi_cooled.toml").read_text().replace('other_loss = "500 W"\n', "")
    bare = case_of(tomllib.loads(text), "bare", CASES).with_found(
        {"cooling": {"tooth_loss": 1100.0}}
    )
    churning = 8.9e-5 * 304.8 * 1500 ** (4 / 3)
    wheel = 2 * 304.8 - 8.4997 * 9.14504
    bearings = 0.03 * 4000 * 50 * np.pi * 3 / 59 * 304.8**0.44 * 59 / 3 / wheel
    seals = 2 * 1.178e-5 * (8.4997 * 9.14504) ** 2 * 1500
    other = bare.tables.cooling_of(bare.drive).other
    assert (
        other.standard.churning,
        other.standard.bearings,
        other.standard.seals,
    ) == pytest.approx((churning, bearings, seals), rel=1e-3)
    assert other.summary()["other_W"] == other.power > 1000
    assert "assumed by the worm standard's regressions" in other.words
    sump = bare.drive.oil.heat.inlet_temperature - ZERO_CELSIUS
    assert sump == pytest.approx(20 + (1100 + other.power) / 40)
    assert drive_iteration.tooth_loss_of(bare) == pytest.approx(1100)
    floating = text.replace("[cooling]", '[cooling]\nbearings = "fixed and floating"')
    case = case_of(tomllib.loads(floating), "bare", CASES)
    less = case.tables.cooling_of(case.drive).other
    assert less.standard.bearings / other.standard.bearings == pytest.approx(13 / 30)


def test_oil_of_the_sump_is_the_oil_warmed_by_its_own_laws(case):
    oil = with_loss(case, 1300.0).drive.oil
    given = case.tables.oil.oil()
    rise = oil.heat.inlet_temperature - given.heat.inlet_temperature
    assert rise != 0
    for pressure in (0.0, 0.3e9):
        for further in (0.0, 20.0):
            expected = given.eta(pressure, rise + further)
            assert oil.eta(pressure, further) == pytest.approx(expected, rel=1e-12)
    held, before = (
        of.heat.specific_heat * of.density.rho0 * (1 + of.heat.heat_capacity_b0 * warm)
        for of, warm in ((oil, 0.0), (given, rise))
    )
    assert held == pytest.approx(before)


@pytest.mark.parametrize("fall", (-0.2, -1.0, -3.0))
def test_the_loss_found_agrees_with_its_own_temperatures(case, monkeypatch, tmp_path, fall):
    """Teeth that lose less the warmer the oil: found = 1100 W + fall (assumed - 1000 W)."""
    ran, said = [], []

    def run(case, tasks, directory, **rest):
        assumed = drive_iteration.tooth_loss_of(tasks[0].case)
        ran.append((len(tasks), assumed, 1100 + fall * (assumed - 1000)))

    def cycle(result):
        power = ran[-1][2]
        loss = Loss(power, 1.0, 1.0, 1.0, 0.0096, 4000.0, 210.0, 0.97, 0.97)
        nothing = Extreme(0.0, 0.0, 0.5)
        return DriveCycle((0.5,), (), nothing, nothing, {}, None, loss, {})

    monkeypatch.setattr(drive_iteration, "run", run)
    monkeypatch.setattr(drive_iteration, "drive_cycle", cycle)
    tasks = [Task(case, place, 0.03) for place in case.places()]
    _, solved = drive_iteration.run_balanced(case, tasks, tmp_path, print_message=said.append)
    _, assumed, found = ran[-1]
    assert abs(found - assumed) / 40 < 1.001 * drive_iteration.WARMTH
    assert assumed == pytest.approx(1000 + 100 / (1 - fall), abs=25)
    # most passes solve a few of the phases, all of them only in the end
    counts = [count for count, *_ in ran]
    assert counts[0] < len(tasks) == counts[-1]
    assert sum(count == len(tasks) for count in counts) <= 2
    assert len(ran) <= 6
    assert solved[0].case.tables.cooling.tooth_loss == pytest.approx(assumed)
    assert len(said) >= 1
