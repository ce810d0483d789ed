"""Unloaded tooth contact over the mesh cycle of one tooth pair."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import scipy

from pyworm.drives.worm.flanks.contact_curve import HobError
from pyworm.drives.worm.flanks.contact_path import ContactPath, Touches
from pyworm.drives.worm.flanks.flank_height import FlankHeight
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.wheel_envelope import across_axis
from pyworm.drives.worm.teeth.seen_path import SeenPath
from pyworm.drives.worm.teeth.tooth import WheelTooth, WormTooth

FLAT = 1e-9
"""Ratio of principal relative curvatures that counts as zero, since it is rounding."""


@dataclass(frozen=True)
class ToothContact:
    """Worm and wheel tooth touching, unloaded, at one instant of the mesh cycle.

    Vectors are in the drive frame (see `pyworm.drives.worm.flanks.helicoid`).
    """

    phase: float
    """Place in the mesh cycle, 0 where the teeth meet, 1 where they part."""
    worm_angle: float
    """Rotation angle of the worm [rad]."""
    wheel_angle: float
    """Rotation angle of the wheel [rad]."""
    transmission_error: float
    """Wheel angle ahead of the ideal, worm angle times threads / teeth, zero at phase 0.5 [rad]."""
    point: Array
    """The contact point, (3,) [m]."""
    normal: Array
    """The common normal from worm to wheel, (3,); with both axes the contact frame."""
    x_axis: Array
    """Direction of the larger relative radius, along which the worm sweeps positively, (3,)."""
    y_axis: Array
    """Normal cross x_axis, (3,)."""
    radii: tuple[float, float]
    """Relative radii of curvature along x_axis and y_axis [m]; infinite for line contact, and where flanks
    that touch at an edge are nearer to each other on both sides of the origin."""
    velocity: Array
    """Velocity of the contact point in space, (3,) [m/s]."""
    worm_height: FlankHeight
    """The worm's flank over the tangent plane."""
    wheel_height: FlankHeight
    """The wheel's flank over the tangent plane."""

    @property
    def axes(self) -> Array:
        """Rows x_axis, y_axis, normal, (3, 3)."""
        return np.array([self.x_axis, self.y_axis, self.normal])


@dataclass(frozen=True)
class MeshCycle:
    """The mesh cycle of one tooth pair: the part of the path of contact that lies on both teeth."""

    path: ContactPath
    """Path of the contact point."""
    ratio: float
    """Threads / teeth [-]."""
    begin: float
    """Place of the path at phase 0."""
    end: float
    """Place of the path at phase 1."""
    begin_boundary: str
    """The tooth boundary at phase 0."""
    end_boundary: str
    """The tooth boundary at phase 1."""

    def follows(self, phase: float) -> bool:
        """Whether the contact at a phase is followed, not continued from the end of its path."""
        first, last = self.path.ends()
        return first <= self.begin + phase * (self.end - self.begin) <= last

    @property
    def speed_ratio(self) -> float:
        """Wheel speed by worm speed while this tooth pair leads, in the middle of its cycle."""
        return float(self.speed_ratios(np.array([0.5]))[0])

    def speed_ratios(self, phases: Array) -> Array:
        """Wheel speed by worm speed at some phases while this tooth pair leads.

        Their velocities along the common normal are the same. The ratio of an involute worm is that of its
        base travel to the wheel's lever, at all phases.
        """
        touches = self._touches(phases)
        on_worm = np.sum(touches.normal * touches.travel, axis=0)
        return on_worm / np.sum(-across_axis(touches.point) * touches.normal, axis=0)

    @cached_property
    def worm_rotation(self) -> float:
        """Rotation of the worm over the cycle [rad]."""
        before, after = self.path.touches(np.array([self.begin, self.end])).worm_angle
        return float(after - before)

    def angles(self, place: float) -> tuple[float, float]:
        """Worm and wheel angle [rad] when the contact is at a place of the path."""
        touches = self.path.touches(np.array([place]))
        return float(touches.worm_angle[0]), float(touches.wheel_angle[0])

    def _touches(self, phases: Array) -> Touches:
        return self.path.touches(self.begin + np.asarray(phases) * (self.end - self.begin))

    def points(self, phases: Array) -> Array:
        """The contact point at some phases, (3, phases) [m]."""
        return self._touches(phases).point

    def normals(self, phases: Array) -> Array:
        """The common normal from worm to wheel at some phases, (3, phases)."""
        return self._touches(phases).normal

    def transmission_error(self, phases: Array) -> Array:
        """Wheel angle ahead of the ideal if the pair at a phase leads [rad], zero at phase 0.5; (phases,)."""
        return self._ahead(self._touches(phases)) - self._ahead_in_middle

    def _ahead(self, touches: Touches) -> Array:
        """Wheel angle ahead of threads / teeth times the worm's [rad], (phases,)."""
        return touches.wheel_angle - self.ratio * touches.worm_angle

    @property
    def absolute_error(self) -> float:
        """Wheel angle ahead of the ideal at phase 0.5, counted from where it is cut [rad]."""
        return self._ahead_in_middle

    @property
    def lever(self) -> float:
        """Lever of the common normal about the wheel's axis at phase 0.5 [m]."""
        touches = self._touches(np.array([0.5]))
        return float(np.sum(across_axis(touches.point) * touches.normal, axis=0)[0])

    @cached_property
    def _ahead_in_middle(self) -> float:
        return float(self._ahead(self._touches(np.array([0.5])))[0])

    def contact(self, phase: float, speed: float = 0.0) -> ToothContact:
        """The contact at a phase, 0 to 1, of the flanks beyond, and a speed of the worm [rad/s]."""
        seen = isinstance(self.path, SeenPath)
        touches = self._touches(np.array([phase]))
        point, normal = touches.point[:, 0], touches.normal[:, 0]
        flanks = (
            (self.path.worm_surface(float(touches.worm_angle[0])), touches.worm_start),
            (self.path.wheel_surface(float(touches.wheel_angle[0])), touches.wheel_start),
        )

        def heights(axes: Array) -> list[FlankHeight]:
            return [
                FlankHeight(surface, point, axes, tuple(map(float, start[:, 0])))
                for surface, start in flanks
            ]

        first = across_axis(normal)
        first = first / np.linalg.norm(first)
        axes = np.array([first, np.cross(normal, first), normal])
        worm, wheel = (height.curvatures for height in heights(axes))
        curvatures, directions = np.linalg.eigh(wheel - worm)
        x_axis = directions[:, 0] @ axes[:2]
        x_axis = x_axis * np.sign(x_axis @ self.path.worm.sweep(point))
        y_axis = np.cross(normal, x_axis)
        worm_height, wheel_height = heights(np.array([x_axis, y_axis, normal]))
        flat = abs(curvatures[0]) < FLAT * abs(curvatures[1]) or (seen and curvatures[0] < 0)
        radii = (np.inf if flat else float(1 / curvatures[0])), float(1 / curvatures[1])
        return ToothContact(
            phase=phase,
            worm_angle=float(touches.worm_angle[0]),
            wheel_angle=float(touches.wheel_angle[0]),
            transmission_error=float(self._ahead(touches)[0]) - self._ahead_in_middle,
            point=point,
            normal=normal,
            x_axis=x_axis,
            y_axis=y_axis,
            radii=radii,
            velocity=touches.travel[:, 0] * speed,
            worm_height=worm_height,
            wheel_height=wheel_height,
        )


def find_mesh_cycle(
    paths: Sequence[ContactPath], ratio: float, worm_tooth: WormTooth, wheel_tooth: WheelTooth
) -> MeshCycle:
    """The mesh cycle and its ends at the tooth boundaries, with `ratio` threads over teeth.

    ValueError if the flanks do not touch on the teeth, or interfere.
    """
    found = [cycle for path in paths for cycle in _on_teeth(path, ratio, worm_tooth, wheel_tooth)]
    cycles = [
        cycle
        for cycle in found
        if all(min(cycle.contact(phase).radii) > 0 for phase in (0.0, 0.5, 1.0))
    ]
    if cycles:
        return max(cycles, key=lambda cycle: cycle.worm_rotation)
    if found:
        raise HobError(
            "hob: the wheel it cuts would interfere with the worm (a relative radius of curvature is "
            "negative); a hob at least as large as the worm, set up near the wheel's mid-plane, or a "
            "larger pressure angle or profile shift is needed"
        )
    hob = wheel_tooth.hob
    raise HobError(
        f"hob.swivel, hob.axial_shift and hob.centre_distance are {np.degrees(hob.swivel):.4g} deg, "
        f"{hob.axial_shift * 1e3:.4g} mm and {hob.centre_distance * 1e3:.4g} mm, for which no common normal "
        "of worm and wheel lies on the teeth; a set-up that brings the contact between the face ends is "
        "needed"
    )


def _on_teeth(
    path: ContactPath, ratio: float, worm_tooth: WormTooth, wheel_tooth: WheelTooth
) -> Iterator[MeshCycle]:
    """The parts of a path that lie on both teeth."""

    def margins(places: Array) -> dict[str, Array]:
        point = path.touches(places).point
        return {**worm_tooth.margins(point), **wheel_tooth.margins(point)}

    def margin(places: Array) -> Array:
        return np.min(np.stack(list(margins(places).values())), axis=0)

    def end(before: float, after: float) -> tuple[float, str]:
        """Place and boundary between two places of which one is inside."""
        place = scipy.optimize.brentq(
            lambda place: float(margin(np.array([place]))[0]), before, after, xtol=1e-15
        )
        here = margins(np.array([place]))
        return place, min(here, key=lambda name: float(here[name][0]))

    places = path.search(worm_tooth.tip_radius)
    inside = margin(places) > 0
    edges = np.flatnonzero(inside[:-1] != inside[1:])
    for first, last in pairwise(edges):
        if inside[first + 1]:
            begin, begin_boundary = end(places[first], places[first + 1])
            finish, end_boundary = end(places[last], places[last + 1])
            yield MeshCycle(path, ratio, begin, finish, begin_boundary, end_boundary)
