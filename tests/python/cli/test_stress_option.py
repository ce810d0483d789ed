"""pyworm run --stress: table, keys under --json, file and picture."""

import json

import pyworm
from pyworm.cli.main import main


def test_a_run_has_the_stress_below_its_surfaces(tmp_path, capsys):
    case = "cases/line_m20_l10.toml"
    assert (
        main(["run", case, "--accuracy", "10%", "--stress", "--json", "--out", str(tmp_path)]) == 0
    )
    shown = capsys.readouterr()
    assert "stress by the pressure alone" in shown.err  # of an oil without flow law
    found = json.loads(shown.out)
    scene = found["scenes"][0]
    assert 0 < scene["von_mises_max_body_1_Pa"] < scene["pressure_max_Pa"]
    assert 0 < scene["von_mises_depth_body_1_m"] < 1e-3
    assert 0 < scene["von_mises_max_body_2_error"] < 0.2
    assert any(name.endswith("scene_000_stress.png") for name in found["pictures"])
    solution = pyworm.open_result(found["results"]).solutions[0]
    assert solution.stress(body=1).von_mises_max.value.value > 0
    assert main(["report", found["results"]]) == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Stress below the surface" in page


def test_thermal_stress_without_heat_is_reported(tmp_path, capsys):
    case = "cases/line_m20_l10.toml"
    run = ["run", case, "--accuracy", "20%", "--thermal-stress", "--json", "--pictures", "none"]
    assert main([*run, "--out", str(tmp_path)]) == 0
    shown = capsys.readouterr()
    assert "no thermal stress: heat was not simulated" in shown.err
    assert json.loads(shown.out)["scenes"][0]["von_mises_max_body_1_Pa"] > 0
