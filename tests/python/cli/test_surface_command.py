"""The command `surface`: table, JSON, pictures, and what it refuses."""

import json
from dataclasses import replace

import numpy as np
import pytest
from refusals import refusal

from pyworm.cli.main import main
from pyworm.solver.patch.rough_patch import rough_patch
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
        "Sq (Rq), root",
        "Sa",
        "Sz",
        "Ssk",
        "Sku",
        "Sk,",
        "Spk",
        "Svk",
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


@pytest.fixture
def profile(tmp_path):
    built = gaussian(0.4e-6, 20e-6, seed=1)
    path = tmp_path / "line.txt"
    places = np.arange(256) * built.spacing[1]
    np.savetxt(path, np.c_[places, built.height[9]] * 1e6, header="x [um]  z [um]")
    return path


def test_a_profile_is_shown_and_drawn(profile, tmp_path, capsys):
    assert main(["surface", str(profile)]) == 0
    table = capsys.readouterr().out
    for name in ("256 points", "Rq, root", "Rz, maximum", "Rsm", "Rdq", "Rmrk1", "Section length"):
        assert name in table
    out = tmp_path / "out"
    assert main(["surface", str(profile), "--json", "--out", str(out)]) == 0
    content = json.loads(capsys.readouterr().out)
    (own,) = content["profiles"]
    assert 0.2e-6 < own["rq_m"] < 0.5e-6
    assert own["uncertainty"]["rq_m"] > 0
    assert content["pictures"] == ["line_profile.png"]
    assert (out / "line_profile.png").stat().st_size > 10_000


def test_a_profile_is_no_surface_of_a_table(profile, tmp_path, capsys):
    table = tmp_path / "flank.toml"
    table.write_text(f'file = "{profile.name}"')
    assert "is a profile along a line" in refusal(["surface", str(table)], tmp_path, capsys)
    said = refusal(["surface", str(profile), "--channel", "2"], tmp_path, capsys)
    assert "has one channel; omit channel" in said


def test_profiles_across_and_along_are_shown_as_a_surface(profile, capsys):
    command = ["surface", str(profile), "--along", str(profile), "--json"]
    assert main(command) == 0
    (own,) = json.loads(capsys.readouterr().out)["surfaces"]
    assert own["points"] == [512, 512]
    assert own["aspect"] == pytest.approx(1.0, rel=0.2)
    assert own["uncertainty"]["rq_m"] > 0


def test_outliers_are_left_out_and_told(heights, tmp_path, capsys):
    path, spacing = heights
    spiked = np.load(path)
    spiked[7, 9] = 99.0
    np.save(path, spiked)
    assert main(["surface", str(path), "--spacing", f"{spacing} m", "--height-unit", "um"]) == 0
    assert "Outliers among them" in capsys.readouterr().out


def test_parts_and_masks_are_options(heights, tmp_path, capsys):
    path, spacing = heights
    np.savetxt(tmp_path / "mask.txt", np.ones((96, 128)))
    options = [
        "--spacing",
        f"{spacing} m",
        "--height-unit",
        "um",
        "--mask",
        str(tmp_path / "mask.txt"),
    ]
    crop = ["--crop", "0 um", f"{64 * spacing} m", "0 um", f"{32 * spacing} m"]
    assert main(["surface", str(path), *options, *crop, "--json"]) == 0
    (own,) = json.loads(capsys.readouterr().out)["surfaces"]
    assert own["points"] == [64, 32]


BALL = """
title = "A ball on a disc"
source = "made up"
accuracy = "20 %"
effects = ["second-dimension", "elastic-deflection", "roughness"]
[contact]
kind = "point-contact"
radii = ["12.7 mm", "12.7 mm"]
load = "60 N"
[motion]
velocity_1 = ["0.2 m/s", "0 m/s"]
velocity_2 = ["0.2 m/s", "0 m/s"]
[bodies.body_1]
material = "16MnCr5"
finish = "ground"
[bodies.body_2]
material = "16MnCr5"
finish = "run-in"
[oil]
name = "PAG VG 460"
temperature = "60 degC"
"""


@pytest.fixture
def case(tmp_path, monkeypatch):
    from pyworm.surfaces import cell, cell_table, from_profiles

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(cell_table, "SEPARATIONS", np.geomspace(6.0, 0.5, 10))
    monkeypatch.setattr(cell, "NODES", 32)
    monkeypatch.setattr(from_profiles, "NODES", 64)
    path = tmp_path / "ball.toml"
    path.write_text(BALL)
    return path


def test_measured_surfaces_lead_to_a_film_before_and_after_running_in(
    heights, case, tmp_path, capsys
):
    path, spacing = heights
    options = ["--spacing", f"{spacing} m", "--height-unit", "um", "--with", str(path)]
    out = tmp_path / "out"
    command = ["surface", str(path), *options, "--case", str(case), "--out", str(out)]
    assert main(command) == 0
    table = capsys.readouterr().out
    for name in (
        "body_1, Sq",
        "body_2, Sq",
        "as measured",
        "run in",
        "Minimum film",
        "Asperity load",
    ):
        assert name in table
    assert (out / "between_surfaces.png").stat().st_size > 10_000


SMOOTH_WAVES = """
generated = { spectrum = "gaussian", roughness = "20 nm", correlation_length = "120 um", seed = 1 }
"""


def test_surfaces_move_through_the_contact_node_by_node(case, tmp_path, capsys, monkeypatch):
    surface, out = tmp_path / "waves.toml", tmp_path / "out"
    surface.write_text(SMOOTH_WAVES)
    options = ["surface", str(surface), "--case", str(case), "--resolved", "65"]
    patches, module = [], "pyworm.solver.patch.rough_patch.rough_patch"

    def kept(*given, **options):
        patches.append(rough_patch(*given, **options))
        return patches[-1]

    monkeypatch.setattr(module, kept)
    assert main([*options, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["contacts"]["resolved"]
    assert found["nodes"] == [65, 65]
    assert found["converged"] is True
    assert found["film_mean_m"] == pytest.approx(found["smooth_film_mean_m"], rel=0.1)
    assert found["mass_error"] <= 1e-3
    monkeypatch.setattr(module, lambda *_, **options: replace(patches[0], converged=False))
    assert main([*options, "--out", str(out)]) == 3
    table, message = capsys.readouterr()
    assert "some time steps did not converge" in message
    for name in ("averaged", "resolved, 65 x 65 nodes", "Central film thickness", "time steps"):
        assert name in table
    assert (out / "resolved_surfaces.png").stat().st_size > 10_000
    monkeypatch.setattr(module, rough_patch)
    surface.write_text(SMOOTH_WAVES.replace("120", "12"))
    assert main(options) == 2
    assert "give more nodes" in capsys.readouterr().err
    surface.write_text(SMOOTH_WAVES)

    def lost(*_, **options):
        raise RuntimeError("a step did not converge")

    monkeypatch.setattr(module, lost)
    assert main(options) == 3
    assert "did not converge" in capsys.readouterr().err


def test_a_second_surface_needs_a_case(heights, tmp_path, capsys):
    path, _ = heights
    said = refusal(["surface", str(path), "--with", str(path)], tmp_path, capsys)
    assert "give --case CASE.toml too" in said
    said = refusal(
        ["surface", str(tmp_path / "none.npy"), "--case", "cases/point_m20_l10.toml"],
        tmp_path,
        capsys,
    )
    assert "no such file" in said
