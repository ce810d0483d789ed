"""Map of films, asperities and temperatures of a gear set over speed and load."""

import json

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.formulas.thermal_reduction import thermal_loading, wilson_sheu
from pyworm.planning.prediction import predicted
from pyworm.plots.operating_map import draw_operating_map
from pyworm.ratings.operating_map import operating_map
from pyworm.report.operating_map import operating_map_table
from pyworm.scene.index import ContactIndex

PLACES = [ContactIndex(section="left", phase=phase, station=0.5) for phase in (0.2, 0.9)]


@pytest.fixture(scope="module")
def drive():
    return pyworm.load(CASES / "roller_ref.toml").drive


@pytest.fixture(scope="module")
def found(drive):
    speeds = [drive.speed * factor for factor in (0.2, 1.0)]
    torque = drive.torque * drive.ratio
    return operating_map(drive, PLACES, speeds, [0.5 * torque, torque])


def test_extremes_are_those_of_the_contacts_by_their_formulas(drive, found):
    """At the drive's own speed and torque the thinner film of both contacts, with inlet heating."""
    films = []
    for place in PLACES:
        contact = predicted(drive.scene(**place.given))
        heat = contact.oil.thermal
        loading = thermal_loading(
            contact.oil.viscosity.eta0, contact.inlet_beta, contact.speed, heat.conductivity
        )
        left = wilson_sheu(loading, contact.sliding / contact.speed)
        films.append(contact.film_min * float(left))
    assert found.values["film_min"][1, 1] == pytest.approx(min(films), rel=1e-6)
    ratio = found.values["film_min"] / found.values["specific_film"]
    assert ratio == pytest.approx(np.hypot(0.4e-6, 0.2e-6) * np.ones((2, 2)))


def test_trends_are_those_of_the_formulas(found):
    films, asperities = found.values["film_min"], found.values["asperity_load_fraction"]
    assert (films[1] > films[0]).all() and (films[:, 0] > films[:, 1]).all()
    assert (asperities[0] > asperities[1]).all()
    assert (found.values["temperature_max"] > 333.15).all()


def test_table_picture_and_objects_have_every_point(found):
    table = operating_map_table(found)
    assert len(table.rows) == len(found.summary()) == 4
    assert table.rows[3][:2] == ("1500", "1114")
    assert found.summary()[0]["film_min_m"] == found.values["film_min"][0, 0]
    figure = draw_operating_map("rollers", found)
    assert [axes.get_xlabel() for axes in figure.axes].count("speed of the first shaft / rpm") == 4


def test_the_command_refuses_half_a_map(tmp_path, capsys):
    case = str(CASES / "roller_ref.toml")
    assert main(["rate", case, "--speeds", "300 rpm", "--out", str(tmp_path)]) == BAD_INPUT
    assert "needs --speeds and --torques" in capsys.readouterr().err
    options = ["--speeds", "300 rpm", "--torques", "-3 N m", "--out", str(tmp_path)]
    assert main(["rate", case, *options]) == BAD_INPUT
    assert list(tmp_path.iterdir()) == []


@pytest.mark.long
def test_the_command_writes_map_and_picture(tmp_path, capsys):
    case = str(CASES / "roller_ref.toml")
    options = ["--speeds", "300 rpm", "--torques", "1 kN m", "--out", str(tmp_path), "--json"]
    assert main(["rate", case, *options]) == 0
    assert len(json.loads(capsys.readouterr().out)["operating_points"]) == 1
    assert [path.name for path in tmp_path.iterdir()] == ["roller_ref_operating_map.png"]
