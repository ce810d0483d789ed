"""Triangle meshes as files: binary STL in millimetres, and glTF 2.0 (GLB) in metres."""

import json
import struct
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from pyworm.io.solid import Array

MILLIMETRES = 1e3
"""Unit of STL files over the metre."""

STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
"""A triangle of a binary STL file."""

COLOURS = {"worm": (0.56, 0.58, 0.62), "wheel": (0.78, 0.57, 0.24), "hob": (0.35, 0.38, 0.42)}
"""Name of a solid -> its colour, linear RGB."""

GLB_MAGIC, GLB_JSON, GLB_BINARY = 0x46546C67, 0x4E4F534A, 0x004E4942
"""Marks of a GLB file and of its two chunks."""

FLOATS, UNSIGNED = 5126, 5125
"""Component types of glTF accessors."""


def write_stl(path: Path, name: str, triangles: Array) -> None:
    """Write corners of triangles (triangles, 3, 3) [m] as binary STL in millimetres."""
    rows = np.zeros(len(triangles), STL_TRIANGLE)
    rows["corners"] = triangles * MILLIMETRES
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    size = np.linalg.norm(normal, axis=1, keepdims=True)
    rows["normal"] = normal / np.where(size > 0, size, 1.0)
    head = f"{name}, millimetres".encode("ascii").ljust(80)
    path.write_bytes(head + struct.pack("<I", len(rows)) + rows.tobytes())


def write_glb(path: Path, meshes: Mapping[str, Array]) -> None:
    """Write corners of triangles [m] of several solids, each a node under its name, as GLB."""
    binary = b""
    views: list[dict[str, int]] = []
    accessors: list[dict[str, object]] = []
    for triangles in meshes.values():
        places, index = np.unique(
            triangles.reshape(-1, 3).astype("<f4"), axis=0, return_inverse=True
        )
        bounds = {"min": places.min(axis=0).tolist(), "max": places.max(axis=0).tolist()}
        for data, kind, component, more in (
            (places.tobytes(), "VEC3", FLOATS, {"count": len(places), **bounds}),
            (index.astype("<u4").tobytes(), "SCALAR", UNSIGNED, {"count": index.size}),
        ):
            accessors.append(
                {"bufferView": len(views), "componentType": component, "type": kind, **more}
            )
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
            binary += data
    content = {
        "asset": {"version": "2.0", "generator": "pyworm"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(meshes)))}],
        "nodes": [{"name": name, "mesh": place} for place, name in enumerate(meshes)],
        "meshes": [
            {
                "name": name,
                "primitives": [
                    {
                        "attributes": {"POSITION": 2 * place},
                        "indices": 2 * place + 1,
                        "material": place,
                    }
                ],
            }
            for place, name in enumerate(meshes)
        ],
        "materials": [_material(name) for name in meshes],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    text = json.dumps(content, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    length = 12 + 8 + len(text) + 8 + len(binary)
    path.write_bytes(
        struct.pack("<5I", GLB_MAGIC, 2, length, len(text), GLB_JSON)
        + text
        + struct.pack("<2I", len(binary), GLB_BINARY)
        + binary
    )


def _material(name: str) -> dict[str, object]:
    return {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*COLOURS[name], 1.0],
            "metallicFactor": 0.6,
            "roughnessFactor": 0.45,
        },
    }
