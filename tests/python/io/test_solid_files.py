"""Meshes and surfaces as files: STL, GLB and VTK read back, and end faces cut into triangles."""

import json
import struct
from base64 import b64decode
from xml.etree import ElementTree

import numpy as np
import pytest

from pyworm.io.mesh_files import STL_TRIANGLE, write_glb, write_stl
from pyworm.io.solid import Solid, accurate
from pyworm.io.triangles import ears, triangles
from pyworm.io.vtk import write_surface

RADIUS, LENGTH, BORE = 0.03, 0.02, 0.01


def ring(finer=1):
    """A ring of six pitches about the axis z."""
    angle = np.linspace(0.0, np.pi / 3, 6 * finer + 1)[:, None]
    along = np.linspace(0.0, LENGTH, 4 * finer + 1)
    net = [
        RADIUS * np.cos(angle) + 0 * along,
        RADIUS * np.sin(angle) + 0 * along,
        along + 0 * angle,
    ]
    axis = np.array([0.0, 0.0, 1.0])
    return Solid("worm", (np.stack(net, -1),), (0, 4 * finer), 6, np.zeros(3), axis, BORE, (0,))


def test_a_ring_has_the_volume_of_a_ring():
    corners = triangles(accurate(ring))
    volume = np.sum(np.cross(corners[:, 0], corners[:, 1]) * corners[:, 2]) / 6
    assert volume == pytest.approx(np.pi * (RADIUS**2 - BORE**2) * LENGTH, rel=0.01)


def test_uneven_surfaces_are_refused():
    def rough(finer):
        solid = ring(finer)
        net = solid.nets[0] + 1e-4 * np.sin(1e5 * solid.nets[0])
        return Solid(solid.name, (net,), solid.breaks, 6, solid.axis_point, solid.axis)

    with pytest.raises(ValueError, match="worm: its flanks are too uneven"):
        accurate(rough)


def test_the_flank_shown_is_the_one_towards_the_worm():
    points = ring().flank_points(2)
    assert points.shape == (13, 9, 3)
    assert points[..., 0].max() < 0


def test_ears_fill_a_polygon_that_is_no_star():
    spiral = np.array(
        [[0, 0], [4, 0], [4, 4], [1, 4], [1, 2], [2, 2], [2, 3], [3, 3], [3, 1], [0, 1]]
    )
    corners = spiral[ears(spiral.astype(float))]
    sides = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = (sides[0][:, 0] * sides[1][:, 1] - sides[0][:, 1] * sides[1][:, 0]) / 2
    x, y = spiral.T
    assert (areas >= 0).all()
    assert areas.sum() == np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) / 2
    with pytest.raises(ValueError, match="crosses itself"):
        ears(spiral[::-1].astype(float))


def test_stl_is_in_millimetres(tmp_path):
    corners = triangles(ring())
    write_stl(tmp_path / "ring.stl", "ring", corners)
    content = (tmp_path / "ring.stl").read_bytes()
    rows = np.frombuffer(content[84:], STL_TRIANGLE)
    assert struct.unpack("<I", content[80:84]) == (len(rows),) == (len(corners),)
    assert rows["corners"] == pytest.approx(corners * 1e3, abs=1e-4)
    outward = np.cross(*np.swapaxes(np.diff(corners, axis=1), 0, 1))
    assert (np.sum(rows["normal"] * outward, axis=1) >= 0).all()


def test_glb_holds_each_solid_in_metres(tmp_path):
    corners = triangles(ring())
    write_glb(tmp_path / "pair.glb", {"worm": corners, "wheel": corners + 1.0})
    content = (tmp_path / "pair.glb").read_bytes()
    mark, version, length, text_length, kind = struct.unpack_from("<4s3I4s", content)
    about = json.loads(content[20 : 20 + text_length])
    binary = content[20 + text_length + 8 :]
    assert (mark, version, kind) == (b"glTF", 2, b"JSON") and length == len(content)
    assert about["buffers"][0]["byteLength"] == len(binary)
    assert [node["name"] for node in about["nodes"]] == ["worm", "wheel"]

    def array(accessor, dtype):
        view = about["bufferViews"][accessor["bufferView"]]
        data = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
        return np.frombuffer(data, dtype)

    places, index = about["accessors"][2:]
    points = array(places, "<f4").reshape(-1, 3)
    assert points.min(axis=0).tolist() == places["min"] and places["count"] == len(points)
    assert points[array(index, "<u4")].reshape(-1, 3, 3) == pytest.approx(corners + 1.0, abs=1e-6)


def test_vtk_surfaces_keep_places_without_a_value(tmp_path):
    points = ring().flank_points(1)
    film = np.where(points[..., 2] > 0, 1e-6, np.nan)
    write_surface(tmp_path / "flank.vts", points, {"film": film}, "film")
    root = ElementTree.parse(tmp_path / "flank.vts").getroot()
    arrays = {
        part.get("Name"): np.frombuffer(b64decode(part.text)[8:]) for part in root.iter("DataArray")
    }
    assert root.find("StructuredGrid").get("WholeExtent") == "0 4 0 6 0 0"
    assert np.array_equal(arrays["points"], points.ravel())
    assert np.array_equal(arrays["film"], film.ravel(), equal_nan=True)
