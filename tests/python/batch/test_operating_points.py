"""Results of operating points of gears: from the friction of contacts to efficiency and temperatures."""

from dataclasses import replace

import pytest
from folders import ROOT

import pyworm
from pyworm.batch.operating_points import OperatingPoint, Solving, quantities_for
from pyworm.batch.task import Task

FRICTION = 0.03


def scalars(task: Task) -> dict:
    """Scalars of a contact with a friction that falls a little as the oil warms."""
    scene = task.scene
    warm = scene.oil.heat.inlet_temperature - 333.15
    friction = FRICTION * (1 - 2e-3 * warm)
    sliding = abs(scene.motions[0].velocity(0.0, 0.0)[0]) + 1.0
    return {
        "converged": True,
        "kind": "point",
        "phase": task.place.phase,
        "section": None,
        "station": None,
        "load_N": scene.load,
        "film_min_m": 3e-7,
        "film_min_error": 0.1,
        "friction_coefficient": friction,
        "power_loss_W": friction * scene.load * sliding,
        "power_loss_error": 0.05,
    }


@pytest.fixture
def solved(monkeypatch):
    """Friction without a solve."""

    def found(self, tasks):
        return {task.key: scalars(task) for task in tasks}

    monkeypatch.setattr(Solving, "solved", found)


def points(tmp_path, cooling):
    text = (ROOT / "cases/gearbox_test.toml").read_text()
    (tmp_path / "unit.toml").write_text(text + cooling)
    case = pyworm.load(tmp_path / "unit.toml")
    return OperatingPoint(case, case.places(), ("friction",)), Solving(tmp_path, 0.1, ("auto",))


def test_a_cooled_unit_finds_its_sump_temperature(tmp_path, solved):
    """Heat through the housing is the loss of the teeth at the temperature found, and of all else."""
    cooling = '\n[cooling]\nambient_temperature = "20 degC"\nconductance = "25 W/K"\nother_loss = "200 W"\n'
    point, solving = points(tmp_path, cooling)
    (found,) = solving.results([point])
    print({name: computed.value for name, computed in found.items()})
    loss, sump = found["power_loss"].value, found["sump_temperature"].value
    assert sump - 293.15 == pytest.approx((loss + 200) / 25)
    power = loss / (1 - found["efficiency"].value)
    assert found["unit_efficiency"].value == pytest.approx(1 - (loss + 200) / (power + 200))
    assert found["efficiency"].error == pytest.approx(found["power_loss"].error / power)
    # the loss belongs to that temperature within half a kelvin
    (again,) = solving.results([point.with_tooth_loss(loss)])
    assert again["power_loss"].value == pytest.approx(loss, abs=0.5 * 25)


def test_temperatures_stay_where_too_few_contacts_give_a_loss(tmp_path, solved):
    cooling = '\n[cooling]\nambient_temperature = "20 degC"\nconductance = "25 W/K"\n'
    point, solving = points(tmp_path, cooling)
    (found,) = solving.balanced([replace(point, places=point.places[:1])])
    assert found.point.case is point.case and "power_loss" not in found.results


def test_what_has_to_be_accurate_follows_from_what_is_measured():
    assert quantities_for(["film_min"]) == ("film",)
    assert quantities_for(["efficiency", "film_central"]) == ("film", "friction")
    assert quantities_for(["sump_temperature", "temperature_max_film"]) == (
        "friction",
        "temperature",
    )
