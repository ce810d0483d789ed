"""pyworm calibrate: tables, JSON, files and refusals."""

import json

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.batch.operating_points import NotSolvedError, Solving
from pyworm.cli.main import main

RIG, FILMS = str(ROOT / "cases/film_rig.toml"), str(ROOT / "cases/measured/film_rig.csv")


def test_z_of_a_film_rig_is_found_as_the_source_found_it(tmp_path, capsys):
    """Made-up films with z = 0.227 of Sharif et al. (2001)."""
    words = ["calibrate", RIG, "--measured", FILMS, "--fit", "z", "--out", str(tmp_path)]
    assert main(words) == 0
    shown = capsys.readouterr()
    print(shown.out)
    assert "operating points, expected CPU time" in shown.err
    assert "95 % interval" in shown.out and "leave-one-out" in shown.out
    assert max(map(len, shown.out.splitlines())) <= 80 or str(tmp_path) in shown.out
    found = json.loads((tmp_path / "calibration.json").read_text())
    low, high = found["values"]["z"]["interval"]
    assert low < 0.227 < high and found["degrees_of_freedom"] == 8
    assert {path.name for path in tmp_path.iterdir()} >= {"fitted.toml", "calibration.png"}
    assert "oil.viscosity.z" in (tmp_path / "fitted.toml").read_text()


def test_json_is_one_object(tmp_path, capsys, monkeypatch):
    """Two unknowns of which films of one regime fix the product."""

    def by_power_law(self, points):
        oils = [point.case.tables.oil.viscosity for point in points]
        speeds = [point.case.tables.motion.mean_velocity[0] for point in points]
        return [
            {"film_central": Film(1e-6 * (oil.eta0 * oil.z * speed) ** 0.7)}
            for oil, speed in zip(oils, speeds, strict=True)
        ]

    monkeypatch.setattr(Solving, "results", by_power_law)
    lines = ["motion.mean_velocity[0] [m/s], film_central [nm], u(film_central) [nm]"]
    speeds = np.geomspace(0.05, 0.4, 5)
    lines += [f"{u:.4g}, {1e3 * (0.3 * 0.3 * u) ** 0.7:.4g}, 3" for u in speeds]
    (tmp_path / "films.csv").write_text("\n".join(lines))
    words = ["calibrate", RIG, "--measured", str(tmp_path / "films.csv"), "--json"]
    words += ["--fit", "z", "oil.viscosity.eta0", "--out", str(tmp_path)]
    assert main(words) == 0
    found = json.loads(capsys.readouterr().out)
    print(found["statements"])
    assert found["values"]["z"]["standard_uncertainty"] is None
    assert found["statements"][0].startswith("The data fix only z oil.viscosity.eta0 (to ")
    value, other = (found["values"][name]["value"] for name in ("z", "oil.viscosity.eta0"))
    assert value * other == pytest.approx(0.09, rel=0.02)


class Film:
    """A film without uncertainties."""

    def __init__(self, value):
        self.value, self.error = value, 0.0


def test_a_contact_without_a_solution_ends_with_the_reason(tmp_path, capsys, monkeypatch):
    def unsolved(self, points):
        raise NotSolvedError("rig could not be solved: no film")

    monkeypatch.setattr(Solving, "results", unsolved)
    words = ["calibrate", RIG, "--measured", FILMS, "--fit", "z", "--out", str(tmp_path)]
    assert main(words) == 3
    assert "could not be solved: no film" in capsys.readouterr().err
    assert not list(tmp_path.glob("fitted*"))


def test_a_case_of_a_result_has_no_file_to_be_changed(tmp_path):
    case = pyworm.load(RIG)
    stored = type(case)(case.name, case.directory, case.tables)
    with pytest.raises(pyworm.CaseError, match="cannot be calibrated; load its file"):
        pyworm.calibrate(stored, FILMS, ["z"], progress=False)
