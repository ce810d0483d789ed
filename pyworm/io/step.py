"""Solids as STEP files, by the CAD kernel Open CASCADE of the package cadquery-ocp.

Nets become B-spline surfaces through their points, end faces planes; all are sewn into one closed shell.
"""

from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.solid import Array, Solid, spline_through

MILLIMETRES = 1e3
"""Unit of STEP files over the metre."""

SEWING_TOLERANCE = 1e-5
"""Distance within which edges are one [mm]."""


class StepError(ValueError):
    """A solid that the CAD kernel does not close, or cannot write."""


def require_kernel() -> None:
    """Load the CAD kernel; ValueError with what to install without it."""
    try:
        import OCP.STEPControl  # noqa: F401
    except ImportError:
        raise ValueError(
            'STEP needs the CAD kernel of cadquery-ocp, which STL and GLB do not: pip install "pyworm[cad]"'
        ) from None


def write_step(path: Path, solid: Solid) -> None:
    """Write a solid in millimetres, under its name; StepError where it is not closed or not written."""
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.Interface import Interface_Static
    from OCP.Message import Message
    from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer

    Message.DefaultMessenger_s().ChangePrinters().Clear()  # it prints what it transfers
    writer = STEPControl_Writer()
    Interface_Static.SetCVal_s("write.step.product.name", solid.name)
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    writer.Transfer(cad_solid(solid), STEPControl_AsIs)
    if writer.Write(str(path)) != IFSelect_RetDone:
        raise StepError(f"{path.name}: the CAD kernel cannot write it")


def cad_solid(solid: Solid) -> Any:
    """The closed solid of the CAD kernel (`TopoDS_Solid`) [mm]; StepError if it is not valid."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepLib import BRepLib
    from OCP.TopAbs import TopAbs_SHELL
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    sewing = BRepBuilderAPI_Sewing(SEWING_TOLERANCE)
    for face in _faces(solid):
        sewing.Add(face)
    sewing.Perform()
    shells = TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL)
    if sewing.NbFreeEdges() or not shells.More():
        raise StepError(f"{solid.name}: its faces do not close ({sewing.NbFreeEdges()} free edges)")
    closed = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shells.Current())).Solid()
    BRepLib.OrientClosedSolid_s(closed)
    if not BRepCheck_Analyzer(closed).IsValid():
        raise StepError(f"{solid.name}: the CAD kernel finds its solid not valid")
    return closed


def _faces(solid: Solid) -> list[Any]:
    """Faces of all pitches, of both ends and of the bore."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_Transform
    from OCP.gp import gp_Ax1, gp_Cylinder, gp_Trsf

    poles = [[_poles(strip) for strip in strips] for strips in solid.smooth_nets]
    ends = [[_edge(strips[end][:, end]) for strips in poles] for end in (0, -1)]
    pitch = [
        BRepBuilderAPI_MakeFace(_surface(strip), SEWING_TOLERANCE).Face()
        for strips in poles
        for strip in strips
    ]
    axis = gp_Ax1(_point(solid.axis_point), _direction(solid.axis))
    faces: list[Any] = []
    outlines: list[list[Any]] = [[], []]
    for copy in range(solid.copies):
        turn = gp_Trsf()
        turn.SetRotation(axis, 2 * np.pi * copy / solid.copies)
        faces += [BRepBuilderAPI_Transform(face, turn, True).Shape() for face in pitch]
        for outline, edges in zip(outlines, ends, strict=True):
            outline += [BRepBuilderAPI_Transform(edge, turn, True).Shape() for edge in edges]
    faces += [
        _end_face(solid, outline, end) for outline, end in zip(outlines, (0, -1), strict=True)
    ]
    if solid.bore_radius:
        low, high = ((solid.end_middle(end) - solid.axis_point) @ solid.axis for end in (0, -1))
        cylinder = gp_Cylinder(_axes(solid, solid.axis_point), solid.bore_radius * MILLIMETRES)
        heights = sorted((low * MILLIMETRES, high * MILLIMETRES))
        faces.append(BRepBuilderAPI_MakeFace(cylinder, 0.0, 2 * np.pi, *heights).Face())
    return faces


def _end_face(solid: Solid, outline: list[Any], end: int) -> Any:
    """The plane face at an end within its outline, with the bore's circle as a hole."""
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakeFace,
        BRepBuilderAPI_MakeWire,
    )
    from OCP.gp import gp_Circ, gp_Pln
    from OCP.TopoDS import TopoDS

    wire = BRepBuilderAPI_MakeWire()
    for edge in outline:
        wire.Add(TopoDS.Edge(edge))
    if not wire.IsDone():
        raise StepError(f"{solid.name}: its faces do not close at its ends")
    middle = solid.end_middle(end)
    plane = gp_Pln(_axes(solid, middle))
    face = BRepBuilderAPI_MakeFace(plane, wire.Wire(), True)
    if solid.bore_radius:
        circle = gp_Circ(_axes(solid, middle).Ax2(), solid.bore_radius * MILLIMETRES)
        hole = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire()
        hole.Reverse()
        face.Add(hole)
    return face.Face()


def _axes(solid: Solid, origin: Array) -> Any:
    """Axes at a point of the axis, x towards the first line of the nets."""
    from OCP.gp import gp_Ax3

    out = solid.nets[0][0, 0] - solid.end_middle(0)
    return gp_Ax3(_point(origin), _direction(solid.axis), _direction(out))


def _poles(strip: Array) -> Array:
    """Poles of the surface through a smooth net (around, along, 3) [mm]."""
    across = spline_through(strip * MILLIMETRES, 0).c
    return np.swapaxes(spline_through(np.swapaxes(across, 0, 1), 0).c, 0, 1)


def _surface(poles: Array) -> Any:
    from OCP.collections import Array2_gp_Pnt
    from OCP.Geom import Geom_BSplineSurface

    net = Array2_gp_Pnt(1, poles.shape[0], 1, poles.shape[1])
    for row, line in enumerate(poles, 1):
        for column, pole in enumerate(line, 1):
            net.SetValue(row, column, _millimetre_point(pole))
    (knots_u, times_u, degree_u), (knots_v, times_v, degree_v) = (
        _knots(count) for count in poles.shape[:2]
    )
    return Geom_BSplineSurface(net, knots_u, knots_v, times_u, times_v, degree_u, degree_v)


def _edge(poles: Array) -> Any:
    """Edge along a line of a net by its poles (points, 3) [mm]."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.collections import Array1_gp_Pnt
    from OCP.Geom import Geom_BSplineCurve

    line = Array1_gp_Pnt(1, len(poles))
    for place, pole in enumerate(poles, 1):
        line.SetValue(place, _millimetre_point(pole))
    return BRepBuilderAPI_MakeEdge(Geom_BSplineCurve(line, *_knots(len(poles)))).Edge()


def _knots(count: int) -> tuple[Any, Any, int]:
    """Knots, their multiplicities and the degree of the spline through a number of points."""
    from OCP.collections import Array1_double, Array1_int

    spline = spline_through(np.zeros(count))
    values, times = np.unique(spline.t, return_counts=True)
    knots, multiplicities = Array1_double(1, len(values)), Array1_int(1, len(values))
    for place, (value, number) in enumerate(zip(values, times, strict=True), 1):
        knots.SetValue(place, float(value))
        multiplicities.SetValue(place, int(number))
    return knots, multiplicities, int(spline.k)


def _point(metres: Array) -> Any:
    return _millimetre_point(metres * MILLIMETRES)


def _millimetre_point(place: Array) -> Any:
    from OCP.gp import gp_Pnt

    return gp_Pnt(*map(float, place))


def _direction(vector: Array) -> Any:
    from OCP.gp import gp_Dir

    return gp_Dir(*map(float, vector))
