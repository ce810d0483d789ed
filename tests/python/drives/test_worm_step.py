"""STEP files of worm and wheel, read back by the CAD kernel: closed, exact, and without interference."""

from functools import cache

import numpy as np
import pytest
from worm_drawings import of_profile

from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_outline import flank_places
from pyworm.drives.worm.thread_solid import worm_solid
from pyworm.drives.worm.wheel_solid import wheel_solid
from pyworm.io.solid import Solid
from pyworm.io.step import StepError, cad_solid, require_kernel, write_step
from pyworm.io.triangles import triangles

pytest.importorskip("OCP")


@cache
def gears():
    """A wheel of few faces: 30 teeth without relief and without a throat."""
    sizes = {
        "teeth": 30,
        "centre_distance": 80e-3,
        "face_width": 24e-3,
        "wheel_outside_diameter": 0.128,
    }
    drawing, _ = with_swivel(of_profile("ZI", **sizes, wheel_tip_relief=0.0, worm_tip_relief=0.0))
    return drawn_gears(drawing)


def read(path):
    from OCP.STEPControl import STEPControl_Reader

    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    return reader.OneShape()


def volume(shape):
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, found)
    return found.Mass()


def closed_shells(shape):
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_SHELL
    from OCP.TopExp import TopExp_Explorer

    explorer, found = TopExp_Explorer(shape, TopAbs_SHELL), []
    while explorer.More():
        found.append(BRep_Tool.IsClosed_s(explorer.Current()))
        explorer.Next()
    return found


def distance(shape, point):
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.gp import gp_Pnt

    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, point * 1e3))).Vertex()
    return BRepExtrema_DistShapeShape(vertex, closed_shell(shape)).Value() * 1e-3


def closed_shell(shape):
    from OCP.TopAbs import TopAbs_SHELL
    from OCP.TopExp import TopExp_Explorer

    return TopExp_Explorer(shape, TopAbs_SHELL).Current()


def exact_wheel_points():
    """Points of the exact flank between the places of the net, at a wheel angle of zero, (points, 3)."""
    pair = gears()
    along = np.array([-9.7e-3, 0.4e-3, 10.9e-3])
    radius = pair.wheel_tooth.tip(along) - 1.7e-3
    q = flank_places(pair.wheel_flank, pair.within, np.stack([radius, along]))
    points = pair.wheel_flank.point(*q)
    assert wheel_radius(points) == pytest.approx(radius, abs=1e-9)
    return points.T


def exact_worm_points():
    """Points of the exact driving flank at an angle of zero, (points, 3)."""
    flank, worm = gears().worm_flank, gears().worm
    radius = np.linspace(gears().worm_tooth.start_radius + 0.2e-3, worm.tip_radius - 0.2e-3, 3)
    polar = np.linspace(-1.3, 1.9, 3)
    height = np.array([flank.axial_profile(r) for r in radius]) + flank.screw * polar
    local = np.stack([radius * np.cos(polar), radius * np.sin(polar), height])
    return (flank.axis_point[:, None] + flank.axes @ local).T


@pytest.mark.parametrize(
    ("make", "points"), [(worm_solid, exact_worm_points), (wheel_solid, exact_wheel_points)]
)
def test_solids_read_back_are_closed_and_on_the_exact_flanks(make, points, tmp_path):
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopAbs import TopAbs_SOLID

    solid = make(gears(), 0.0)
    write_step(tmp_path / "solid.step", solid)
    shape = read(tmp_path / "solid.step")
    assert shape.ShapeType() == TopAbs_SOLID
    assert BRepCheck_Analyzer(shape).IsValid()
    assert closed_shells(shape) == [True]
    corners = triangles(solid)
    mesh = np.sum(np.cross(corners[:, 0], corners[:, 1]) * corners[:, 2]) / 6
    assert volume(shape) == pytest.approx(mesh * 1e9, rel=0.01)
    off = [distance(shape, point) for point in points()]
    print(f"{solid.name}: {max(off) * 1e9:.1f} nm off the exact flank")
    assert max(off) < 1e-6


@pytest.mark.long
def test_the_kernel_finds_no_common_volume_within_the_backlash():
    """In the middle of its backlash the wheel is free; turned on by as much as that it is not."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

    pair = gears()
    middle = pair.cycle.contact(0.5)
    half = pair.wheel.backlash / pair.wheel_reference_radius / 2
    worm = cad_solid(worm_solid(pair, middle.worm_angle))
    free, jammed = (
        BRepAlgoAPI_Common(worm, cad_solid(wheel_solid(pair, middle.wheel_angle + ahead)))
        for ahead in (half, 3 * half)
    )
    assert free.IsDone() and jammed.IsDone()
    assert volume(free.Shape()) == 0
    assert volume(jammed.Shape()) > 1


def test_what_does_not_close_or_cannot_be_written_is_refused(tmp_path):
    whole = worm_solid(gears(), 0.0)
    parts = whole.breaks, whole.copies, whole.axis_point, whole.axis
    gap = Solid("worm", whole.nets[:-1], *parts)
    with pytest.raises(StepError, match="worm: its faces do not close"):
        cad_solid(gap)
    with pytest.raises(StepError, match=r"solid\.step: the CAD kernel cannot write it"):
        write_step(tmp_path / "missing" / "solid.step", whole)


def test_without_the_kernel_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "OCP.STEPControl", None)
    with pytest.raises(ValueError, match=r'pip install "pyworm\[cad\]"'):
        require_kernel()
