"""pyworm export: files written, fields on the flank, and sentences about what cannot be exported."""

import sys
from base64 import b64decode
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from worm_drawings import of_profile

from pyworm.cli.main import main
from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.solids import solids
from pyworm.io.kept_arrays import keep
from pyworm.io.on_demand import xarray as xr
from pyworm.io.solid import Solid
from pyworm.result.flank_surface import on_flank

CASES = Path(__file__).parents[3] / "cases"

DRAWING = CASES / "worm_drawing.toml"


@pytest.fixture
def coarse(monkeypatch):
    monkeypatch.setattr("pyworm.io.triangles.SAG", 0.2e-3)


@pytest.mark.usefixtures("coarse")
def test_meshes_and_wear_are_written(tmp_path, capsys):
    keep(
        tmp_path / "wear.npz",
        radius=np.array([0.07, 0.1]),
        face=np.array([-0.02, 0.02]),
        depths=np.array([[[0.0, 0.0], [0.0, 0.0]], [[0.0, 8e-6], [0.0, 8e-6]]]),
    )
    out = tmp_path / "solids"
    wear = ["--wear", f"{tmp_path / 'wear.npz'}"]
    assert main(["export", f"{DRAWING}", "--formats", "stl,glb", *wear, "--out", f"{out}"]) == 0
    names = ["flank.vts", "hob.stl", "pair.glb", "wheel.stl", "worm.stl"]
    assert sorted(path.name for path in out.iterdir()) == names
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [f"{out / name}" for name in names]
    grid = ElementTree.parse(out / "flank.vts").getroot()
    arrays = {a.get("Name"): np.frombuffer(b64decode(a.text)[8:]) for a in grid.iter("DataArray")}
    face = arrays["points"].reshape(-1, 3)[:, 1]
    assert arrays["wear_depth"] == pytest.approx(8e-6 * (face + 0.02) / 0.04)


def test_extremes_of_a_cycle_lie_on_the_flank(monkeypatch):
    radius, face = np.linspace(0.07, 0.1, 31), np.linspace(-0.02, 0.02, 41)
    film = np.where(np.abs(face) < 5e-3, 1e-6, np.nan) + 0 * radius[:, None]
    fields = {"film": film, "pressure": 1e9 + 1e11 * radius[:, None] + 0 * film}
    found = xr.Dataset(
        {name: (("radius", "face"), values) for name, values in fields.items()},
        coords={"radius": radius, "face": face},
    )
    monkeypatch.setattr("pyworm.result.flank_surface.flank_map", lambda result: found)
    drawing, _ = with_swivel(of_profile("ZI"))
    points = solids(drawn_gears(drawing), "left")["wheel"].flank_points(2)
    there = on_flank(points, None)
    distance = np.hypot(points[..., 0], points[..., 2])
    middle = np.abs(points[..., 1]) < 4e-3
    assert there["film"][middle] == pytest.approx(1e-6)
    assert np.isnan(there["film"][np.abs(points[..., 1]) > 6e-3]).all()
    assert there["pressure"][middle] == pytest.approx(1e9 + 1e11 * distance[middle])
    assert (there["pressure"][np.abs(points[..., 1]) > 6e-3] == 0).all()
    monkeypatch.setattr("pyworm.result.flank_surface.flank_map", lambda result: None)
    assert on_flank(points, None) is None


def test_a_result_is_checked_against_the_case(monkeypatch, capsys, tmp_path):
    """Of the result only its flank's map matters here; a cylinder stands for the wheel."""
    angle = np.pi - np.linspace(0.0, 0.1, 7)[:, None]
    along = np.linspace(-0.01, 0.01, 9)
    net = np.stack(
        [0.08 * np.cos(angle) + 0 * along, along + 0 * angle, 0.08 * np.sin(angle) + 0 * along], -1
    )
    wheel = Solid("wheel", (net,), (0, 8), 63, np.zeros(3), np.array([0.0, 1.0, 0.0]), 0.05, (0,))
    field = xr.Dataset(
        {"pressure": (("radius", "face"), np.full((2, 2), 5e8))},
        coords={"radius": [0.07, 0.09], "face": [-0.02, 0.02]},
    )
    monkeypatch.setattr(
        "pyworm.drives.worm.drive.WormDrive.solids", lambda drive: {"worm": wheel, "wheel": wheel}
    )
    monkeypatch.setattr("pyworm.cli.export.opened_result", lambda path: object())
    monkeypatch.setattr(
        "pyworm.result.result_case.differences", lambda case, result: ("drive.teeth is 41, was 40",)
    )
    export = [
        "export",
        f"{DRAWING}",
        "--formats",
        "glb",
        "--result",
        "r.nc",
        "--out",
        f"{tmp_path / 'out'}",
    ]
    assert main(export) == 2
    assert (
        "drive.teeth is 41, was 40; solve it again, or take it with --anyway"
        in capsys.readouterr().err
    )
    monkeypatch.setattr("pyworm.result.result_case.as_solved", lambda case, result: case)
    monkeypatch.setattr("pyworm.result.flank_surface.flank_map", lambda result: None)
    assert main([*export, "--anyway"]) == 2
    assert "r.nc: has too few converged phases for fields on the flank" in capsys.readouterr().err
    monkeypatch.setattr("pyworm.result.flank_surface.flank_map", lambda result: field)
    assert main([*export, "--anyway"]) == 0
    assert "warning: the result is of another case" in capsys.readouterr().err
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"flank.vts", "pair.glb"}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            [f"{CASES / 'spur_pair.toml'}", "--formats", "stl"],
            "solids are made of worm gear sets only",
        ),
        (
            [f"{CASES / 'roller_ref.toml'}", "--formats", "stl"],
            "solids are made of worm gear sets only",
        ),
        (
            [f"{DRAWING}", "--formats", "stl,iges"],
            "--formats stl,iges: iges is none of step, stl, glb",
        ),
        (["missing.toml"], "missing.toml"),
        (
            [f"{DRAWING}", "--formats", "stl", "--out", f"{DRAWING}"],
            "is a file, results need a directory",
        ),
        ([f"{DRAWING}", "--formats", "stl", "--wear", "missing.npz"], "missing.npz: no such file"),
        ([f"{DRAWING}", "--formats", "stl", "--wear", f"{DRAWING}"], "is damaged"),
        ([f"{DRAWING}", "--formats", "stl", "--result", "missing.nc"], "missing.nc"),
    ],
)
def test_one_sentence_says_what_cannot_be_exported(arguments, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["export", *arguments]) == 2
    message = capsys.readouterr().err.strip().splitlines()
    assert words in message[-1]
    assert not list(tmp_path.iterdir())


def test_step_without_its_kernel_names_the_extra(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "OCP.STEPControl", None)
    assert main(["export", f"{DRAWING}"]) == 2
    assert 'pip install "pyworm[cad]"' in capsys.readouterr().err


def test_a_wheel_without_a_solid_is_refused(monkeypatch, capsys):
    def refuse(drive):
        raise ValueError("wheel: it is undercut")

    monkeypatch.setattr("pyworm.drives.worm.drive.WormDrive.solids", refuse)
    assert main(["export", f"{DRAWING}", "--formats", "stl"]) == 2
    assert f"{DRAWING}: wheel: it is undercut" in capsys.readouterr().err
