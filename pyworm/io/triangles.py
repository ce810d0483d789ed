"""Closed triangle meshes of solids."""

import numpy as np

from pyworm.io.solid import Array, Solid, resampled

SAG = 20e-6
"""Distance of a mesh's chords from the surface [m]."""

BORE_STEPS = 6
"""Steps of a bore's circle in a pitch."""


def triangles(solid: Solid) -> Array:
    """Corners (triangles, 3, 3) [m] of the surface of a solid, right-handed seen from outside."""
    nets = _meshed_nets(solid)
    parts = [_of_net(net) for net in nets]
    outline = np.concatenate([net[:-1] for net in nets] + [nets[-1][-1:]])
    if solid.bore_radius == 0:
        for end in (0, -1):
            parts.append(_fan(solid.end_middle(end), outline[:, end], end))
    else:
        bore = _bore(solid)
        parts.append(_of_net(bore[::-1]))
        for end in (0, -1):
            parts.append(_face(solid, np.concatenate([outline[:, end], bore[::-1, end]]), end))
    pitch = np.concatenate(parts) - solid.axis_point
    copies = pitch @ np.swapaxes(solid.turns(), 1, 2)[:, None]
    return np.asarray(copies.reshape(-1, 3, 3) + solid.axis_point)


def _meshed_nets(solid: Solid) -> list[Array]:
    """Nets with the points of a mesh, each beginning with the line that ends the one before."""
    along = np.max([[_steps(strip, 1) for strip in strips] for strips in solid.smooth_nets], axis=0)
    nets: list[Array] = []
    for strips in solid.smooth_nets:
        around = max(_steps(strip, 0) for strip in strips)
        finer = [
            resampled(strip, around, steps) for strip, steps in zip(strips, along, strict=True)
        ]
        net = np.concatenate([strip[:, :-1] for strip in finer] + [finer[-1][:, -1:]], axis=1)
        if nets:
            net[0] = nets[-1][-1]
        nets.append(net)
    turn = solid.turns()[1 % solid.copies]
    nets[-1][-1] = (nets[0][0] - solid.axis_point) @ turn.T + solid.axis_point
    return nets


def _steps(net: Array, axis: int) -> int:
    """Even steps of a side of a net whose chords have the sag of meshes."""
    sag = np.linalg.norm(np.diff(net, 2, axis=axis), axis=-1).max() / 8
    return max(int(np.ceil((net.shape[axis] - 1) * np.sqrt(sag / SAG))), 1)


def _of_net(net: Array) -> Array:
    """Two triangles for each cell of a net, without those of no area."""
    a, b, c, d = net[:-1, :-1], net[1:, :-1], net[1:, 1:], net[:-1, 1:]
    return np.concatenate(
        [np.stack(corners, axis=-2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))]
    )


def _fan(middle: Array, outline: Array, end: int) -> Array:
    """Triangles from the middle of an end to its outline."""
    corners = [np.broadcast_to(middle, outline[1:].shape), outline[:-1], outline[1:]]
    return np.stack(corners if end else corners[::-1], axis=-2)


def _bore(solid: Solid) -> Array:
    """Points (around, 2, 3) [m] of the bore in a pitch."""
    lines = solid.bore_line() - solid.axis_point
    angle = np.linspace(0.0, 1.0, BORE_STEPS + 1)[:, None, None] * 2 * np.pi / solid.copies
    aside = np.cross(solid.axis, lines)
    along = (lines @ solid.axis)[:, None] * solid.axis
    out = np.cos(angle) * (lines - along) + np.sin(angle) * aside
    return np.asarray(solid.axis_point + along + out)


def _face(solid: Solid, outline: Array, end: int) -> Array:
    """Triangles of one pitch of an end face by its closed outline, which runs on with the nets."""
    first = outline[0] - solid.end_middle(end)
    x = first / np.linalg.norm(first)
    y = np.cross(solid.axis, x)
    flat = np.stack([(outline - outline[0]) @ x, (outline - outline[0]) @ y], axis=-1)
    corners = outline[ears(flat)]
    return np.asarray(corners if end else corners[:, ::-1])


def ears(polygon: Array) -> Array:
    """Corners (triangles, 3) of a simple polygon (points, 2), as indices, by cutting its ears.

    The polygon is right-handed, as are the triangles. ValueError if it crosses itself. Source:
    G. H. Meisters, Polygons have ears, American Mathematical Monthly 82, 1975.
    """
    left, found = list(range(len(polygon))), []
    while len(left) > 3:
        place = _ear(polygon, left)
        if place is None:
            raise ValueError("an end face crosses itself")
        found.append([left[place - 1], left[place], left[(place + 1) % len(left)]])
        del left[place]
    return np.array([*found, left])


def _ear(polygon: Array, left: list[int]) -> int | None:
    """Place of the ear with the largest smallest sine of its angles, for even triangles; None without any."""
    points = polygon[left]
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    area = _cross(points - before, after - points)
    longest = np.max(
        [np.sum(side**2, axis=-1) for side in (points - before, after - points, after - before)],
        axis=0,
    )
    for place in np.argsort(-area / longest):
        if area[place] <= 0:
            break
        corners = before[place], points[place], after[place]
        sides = [
            _cross(b - a, points - a)
            for a, b in zip(corners, (*corners[1:], corners[0]), strict=True)
        ]
        inside = np.min(sides, axis=0) >= 0
        inside[[place - 1, place, (place + 1) % len(left)]] = False
        if not inside.any():
            return int(place)
    return None


def _cross(first: Array, other: Array) -> Array:
    return np.asarray(first[..., 0] * other[..., 1] - first[..., 1] * other[..., 0])
