"""The hob's set-up for a wanted contact pattern: swivel, shift along the wheel's axis, centre distance.

Shift and swivel move the pattern along the face, a smaller centre distance widens it until the worm cuts in.
The least changes by which place and size are the wanted ones are found by Newton's method with differences,
on the pattern without load (`contact_pattern`), its edge blurred so that place and size change smoothly.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees, nan, radians
from typing import Generic, TypeVar

import numpy as np

from pyworm.drives.answers import HobSetup, Row
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.loads.dry_contact import mid_mesh_contact
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.patterns.contact_pattern import THICKNESS, ContactPattern, contact_pattern

BLUR = 0.2
"""Width of the blurred edge over the thickness of the compound."""

USUAL_CHANGES = {"swivel": radians(0.1), "axial_shift": 0.3e-3, "centre_distance": 0.2e-3}
"""Entry of the set-up -> a change that shops make as a rule [rad], [m]: the unit of changes here."""

DIFFERENCE = 0.1
"""Change by which the effect of an entry is found, in usual ones."""

TOLERANCES = {"face": 0.1e-3, "size": 0.005}
"""Misses of the wanted place [m] and size [-] that are no misses any more."""

MOST_STEPS = 12

Change = dict[str, float]
"""Entry of the set-up -> its change in usual ones."""


@dataclass(frozen=True)
class Mark:
    """What is marked of a flank."""

    face: float
    """Middle of the marked part along the face [m], positive to the leaving side."""
    size: float
    """Part of the flank that is marked [-]."""


def mark_of(pattern: ContactPattern, thickness: float = THICKNESS) -> Mark:
    """Middle and size of a pattern marked by compound of a thickness [m], its edge blurred; NaN of none."""
    if not np.isfinite(pattern.separation).any():
        return Mark(nan, nan)
    depth = (thickness - np.nan_to_num(pattern.separation, nan=np.inf)) / (BLUR * thickness)
    weight = pattern.area / (1 + np.exp(-np.clip(depth, -50.0, 50.0)))
    known = pattern.area[np.isfinite(pattern.separation)].sum()
    return Mark(float((weight * pattern.face).sum() / weight.sum()), float(weight.sum() / known))


MeshT = TypeVar("MeshT", bound=WormMesh)
"""A mesh, or its drive."""


@dataclass(frozen=True)
class Setting(Generic[MeshT]):
    """A set-up of the hob and its pattern."""

    mesh: MeshT
    """The mesh with that set-up; a drive where one was given."""
    mark: Mark
    """Its pattern without load."""
    reached: bool = False
    """Whether the pattern is the wanted one."""

    @classmethod
    def of(cls, mesh: MeshT) -> "Setting[MeshT]":
        """The present set-up of a mesh."""
        rigid = mesh.with_rigid_shaft
        return cls(mesh, mark_of(contact_pattern(rigid, rigid.flank_grid)))


Misses = Callable[[Setting[MeshT]], Array]
"""What a set-up misses of what is wanted, in tolerances."""


def found_setting(mesh: MeshT, wanted: dict[str, float]) -> Setting[MeshT]:
    """The set-up nearest to the present one whose pattern has a wanted `face` [m], `size` [-], or both."""

    def misses(setting: Setting[MeshT]) -> Array:
        return np.array(
            [(getattr(setting.mark, name) - to) / TOLERANCES[name] for name, to in wanted.items()]
        )

    current = Setting.of(mesh)
    for _ in range(MOST_STEPS):
        if np.abs(misses(current)).max() <= 1:
            return replace(current, reached=True)
        better = _nearer(current, _newton_step(current, misses), misses)
        if better is None:
            break
        current = better
    return current


def _newton_step(current: Setting[MeshT], misses: Misses[MeshT]) -> Change:
    """The least change of the set-up by which the misses would vanish if they were linear in it."""
    missed = misses(current)
    columns = []
    for entry in USUAL_CHANGES:
        aside = ((step, _changed(current, {entry: step})) for step in (DIFFERENCE, -DIFFERENCE))
        step, beside = next(
            ((s, candidate) for s, candidate in aside if candidate is not None), (1.0, current)
        )
        columns.append((misses(beside) - missed) / step)
    change = -np.linalg.lstsq(np.array(columns).T, missed, rcond=None)[0]
    change /= max(1.0, np.abs(change).max())
    return dict(zip(USUAL_CHANGES, change, strict=True))


def _nearer(
    current: Setting[MeshT], change: Change, misses: Misses[MeshT]
) -> Setting[MeshT] | None:
    """The set-up a part of the change away that misses by less, if it meshes and stays in contact."""
    least = np.linalg.norm(misses(current))
    for part in (1.0, 0.5, 0.25, 0.1):
        tried = _changed(current, {entry: part * by for entry, by in change.items()})
        if tried is None or not np.linalg.norm(misses(tried)) < least:
            continue
        if tried.mesh.pitch <= 1 and tried.mesh.edge_contact is None:
            return tried
    return None


def _changed(current: Setting[MeshT], change: Change) -> Setting[MeshT] | None:
    """A changed set-up; None where worm and wheel do not touch."""
    hob = current.mesh.hob
    entries = {
        entry: getattr(hob, entry) + by * USUAL_CHANGES[entry] for entry, by in change.items()
    }
    try:
        return Setting.of(replace(current.mesh, hob=replace(hob, **entries)))
    except ValueError:
        return None


def hob_for_pattern(mesh: WormMesh, wanted: dict[str, float]) -> HobSetup:
    """The hob's set-up of a drive, and the one found for a wanted pattern; arguments of `found_setting`."""
    if not wanted:
        return HobSetup(_row(Setting.of(mesh)))
    found = found_setting(mesh, wanted)
    return HobSetup(_row(Setting.of(mesh)), _row(found), found.reached)


def _row(setting: Setting[WormMesh]) -> Row:
    mesh, mark = setting.mesh, setting.mark
    hob = mesh.hob
    contact = mid_mesh_contact(mesh, mesh.mid_mesh_load)
    return {
        "hob_swivel_deg": degrees(hob.swivel),
        "hob_axial_shift_m": hob.axial_shift,
        "hob_centre_distance_m": hob.centre_distance,
        "marking_face_m": mark.face,
        "marking_fraction": mark.size,
        "contact_ratio": contact["contact_ratio"],
        "radius_long_m": contact["radius_long"],
        "radius_short_m": contact["radius_short"],
        "dry_pressure_max_Pa": contact["dry_pressure_max"],
        "formula_film_m": contact["formula_film"],
    }
