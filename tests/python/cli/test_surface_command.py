"""The command `surface`: table, JSON, pictures, and what it refuses."""

import json

import numpy as np
import pytest
from refusals import refusal

from pyworm.cli.main import main
from pyworm.surfaces.generated import gaussian

GENERATED = """
[generated]
spectrum = "gaussian"
roughness = "0.4 um"
correlation_length = "20 um"
seed = 1
"""


@pytest.fixture
def heights(tmp_path):
    built = gaussian(0.4e-6, 20e-6, seed=1)
    path = tmp_path / "flank.npy"
    np.save(path, built.height[:128, :96].T * 1e6)
    return path, built.spacing[0]


def test_a_file_is_shown(heights, capsys):
    path, spacing = heights
    options = ["--spacing", f"{spacing} m", "--height-unit", "um"]
    assert main(["surface", str(path), *options]) == 0
    table = capsys.readouterr().out
    assert "128 x 96" in table
    for name in (
        "Rq, root",
        "Ra",
        "Rsk",
        "Rku",
        "Rk,",
        "Rpk",
        "Rvk",
        "slope",
        "Peklenik",
        "Sal, Str",
        "Lay",
    ):
        assert name in table
    assert main(["surface", str(path), *options, "--nesting-index", "100 um", "--json"]) == 0
    (own,) = json.loads(capsys.readouterr().out)["surfaces"]
    assert 0.3e-6 < own["rq_m"] < 0.4e-6
    assert np.hypot(own["rq_m"], own["long_waves_rq_m"]) == pytest.approx(0.4e-6, rel=0.15)
    assert "curves" not in own


def test_a_generated_surface_is_solved_and_drawn(tmp_path, monkeypatch, capsys):
    from pyworm.surfaces import cell_table

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(cell_table, "SEPARATIONS", np.array([4.0, 2.0, 1.0]))
    path = tmp_path / "rough.toml"
    path.write_text(GENERATED)
    out = tmp_path / "out"
    command = ["surface", str(path), "--json", "--out", str(out), "--hardness", "1 GPa"]
    assert main(command) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["pictures"] == ["rough_heights.png", "rough_curves.png"]
    assert all((out / name).stat().st_size > 10_000 for name in content["pictures"])
    curves = content["surfaces"][0]["curves"]
    assert curves["separation_m"][0] == pytest.approx(1.6e-6)
    assert np.all(np.diff(curves["pressure_Pa"]) > 0)
    assert max(curves["pressure_Pa"]) < 1e9
    assert curves["pressure_flow_factor_xx"][0] == pytest.approx(0.91, abs=0.02)


@pytest.mark.parametrize(
    "options, sentence",
    [
        ([], "has numbers without a unit"),
        (["--spacing", "3 kg", "--height-unit", "um"], "spacing"),
        (
            ["--spacing", "1 um", "--height-unit", "um", "--modulus", "5 m"],
            "--modulus 5 m: must be",
        ),
        (
            ["--spacing", "1 um", "--height-unit", "um", "--outliers", "no"],
            'outliers = "no": must be',
        ),
    ],
)
def test_what_is_wrong_is_one_sentence(heights, tmp_path, capsys, options, sentence):
    path, _ = heights
    assert sentence in refusal(["surface", str(path), *options], tmp_path, capsys)


def test_a_case_without_surfaces_is_refused(tmp_path, capsys):
    said = refusal(["surface", "cases/point_m20_l10.toml"], tmp_path, capsys)
    assert "no body has a surface" in said
