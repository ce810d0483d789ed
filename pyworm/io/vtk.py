"""VTK's XML files, as ParaView and PyVista read them: nodes of structured data with fields, in SI."""

from base64 import b64encode
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np


def write_image(
    path: Path, axes: list[np.ndarray], fields: Mapping[str, np.ndarray], scalars: str
) -> None:
    """Write fields over even axes, the fastest first, as image data (`.vti`)."""
    origin = [float(axis[0]) for axis in axes] + [0.0] * (3 - len(axes))
    spacing = [float(np.diff(axis).mean()) for axis in axes] + [1.0] * (3 - len(axes))
    whole = f'Origin="{_numbers(origin)}" Spacing="{_numbers(spacing)}"'
    _write(path, "ImageData", [axis.size for axis in axes], whole, _point_data(fields, scalars))


def write_surface(
    path: Path, points: np.ndarray, fields: Mapping[str, np.ndarray], scalars: str
) -> None:
    """Write fields over points of a surface (rows, columns, 3) [m] as a structured grid (`.vts`)."""
    places = f"<Points>\n{_array('points', points, 3)}</Points>\n"
    rows, columns, _ = points.shape
    _write(path, "StructuredGrid", [columns, rows], "", places + _point_data(fields, scalars))


def _write(path: Path, kind: str, counts: list[int], whole: str, content: str) -> None:
    extent = " ".join(f"0 {count - 1}" for count in counts) + " 0 0" * (3 - len(counts))
    path.write_text(
        f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" '
        'header_type="UInt64">\n'
        f'<{kind} WholeExtent="{extent}"{" " * bool(whole)}{whole}>\n'
        f'<Piece Extent="{extent}">{content}</Piece>\n'
        f"</{kind}></VTKFile>\n",
        encoding="utf-8",
    )


def _point_data(fields: Mapping[str, np.ndarray], scalars: str) -> str:
    arrays = "".join(_array(name, values) for name, values in fields.items())
    return f'<PointData Scalars="{scalars}">\n{arrays}</PointData>'


def _array(name: str, values: np.ndarray, components: int = 1) -> str:
    data = np.ascontiguousarray(values, "<f8").tobytes()
    encoded = b64encode(len(data).to_bytes(8, "little") + data).decode("ascii")
    several = f' NumberOfComponents="{components}"' if components > 1 else ""
    return (
        f'<DataArray type="Float64" Name="{name}"{several} format="binary">{encoded}</DataArray>\n'
    )


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{float(value):.9g}" for value in values)
