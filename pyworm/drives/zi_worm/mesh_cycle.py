"""Unloaded tooth contact over the mesh cycle of one tooth pair."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from pyworm.drives.zi_worm.flank_height import FlankHeight, WheelPlanes, WormPlanes
from pyworm.drives.zi_worm.helicoid import Array, Helicoid
from pyworm.drives.zi_worm.meshing import LineOfAction, WheelFlank, across_axis, lines_of_action
from pyworm.drives.zi_worm.tooth import WheelTooth, WormTooth

FLAT = 1e-9
"""Ratio of principal relative curvatures that counts as zero, since it is rounding."""


@dataclass(frozen=True)
class ToothContact:
    """Worm and wheel tooth touching, unloaded, at one instant of the mesh cycle.

    Vectors are in the drive frame (see `pyworm.drives.zi_worm.helicoid`).

    Attributes
    ----------
    phase : float
        Place in the mesh cycle, 0 where the teeth meet, 1 where they part.
    worm_angle, wheel_angle : float
        Rotation angles [rad].
    transmission_error : float
        Wheel angle ahead of the ideal, worm angle times threads / teeth, zero at phase 0.5 [rad].
    point : ndarray
        The contact point, (3,) [m].
    normal, x_axis, y_axis : ndarray
        The contact frame, each (3,): the common normal from worm to wheel; the direction of the larger
        relative radius of curvature, along which the worm sweeps positively; normal cross x_axis.
    radii : tuple of float
        Relative radii of curvature along x_axis and y_axis [m]; infinite for line contact.
    velocity : ndarray
        Velocity of the contact point in space, (3,) [m/s].
    worm_height, wheel_height : FlankHeight
        The flanks over the tangent plane.
    """

    phase: float
    worm_angle: float
    wheel_angle: float
    transmission_error: float
    point: Array
    normal: Array
    x_axis: Array
    y_axis: Array
    radii: tuple[float, float]
    velocity: Array
    worm_height: FlankHeight
    wheel_height: FlankHeight

    @property
    def axes(self) -> Array:
        """Rows x_axis, y_axis, normal, (3, 3)."""
        return np.array([self.x_axis, self.y_axis, self.normal])


@dataclass(frozen=True)
class MeshCycle:
    """The mesh cycle of one tooth pair: the part of the line of action that lies on both teeth.

    Attributes
    ----------
    worm : Helicoid
        The worm as assembled.
    flank : WheelFlank
        The wheel flank.
    line : LineOfAction
        Path of the contact point.
    begin, end : float
        Place of the contact point on the line, from its foot, at phase 0 and 1 [m].
    begin_boundary, end_boundary : str
        The tooth boundaries at phase 0 and 1.
    """

    worm: Helicoid
    flank: WheelFlank
    line: LineOfAction
    begin: float
    end: float
    begin_boundary: str
    end_boundary: str

    @property
    def speed_ratio(self) -> float:
        """Wheel speed by worm speed while this tooth pair leads: worm base travel by wheel lever.

        Equals threads / teeth where worm and hob have the same normal base pitch.
        """
        return self.worm.base_travel / self.flank.lever

    @property
    def worm_rotation(self) -> float:
        """Rotation of the worm over the cycle [rad]."""
        return (self.begin - self.end) / self.worm.base_travel

    def angles(self, place: float) -> tuple[float, float]:
        """Worm and wheel angle [rad] when the contact is at a place on the line [m]."""
        line, hob = self.line, self.flank.hob
        reach = float(line.direction @ (line.foot + place * line.direction))
        worm = (self.worm.supports(line.worm_theta)[0] - reach) / self.worm.base_travel
        roll = (hob.supports(line.hob_theta)[0] - reach) / self.flank.lever
        return float(worm), float(roll) - line.lag

    def points(self, phases: Array) -> Array:
        """The contact point at some phases, (3, phases) [m]."""
        place = self.begin + np.asarray(phases) * (self.end - self.begin)
        return self.line.foot[:, None] + self.line.direction[:, None] * place

    def transmission_error(self, phases: Array) -> Array:
        """Wheel angle ahead of the ideal if the pair at a phase leads [rad]: linear, zero at phase 0.5."""
        middle = self.angles((self.begin + self.end) / 2)
        end = self.angles(self.end)
        half = end[1] - middle[1] - self.flank.ratio * (end[0] - middle[0])
        return 2 * half * (np.asarray(phases) - 0.5)

    def contact(self, phase: float, speed: float = 0.0) -> ToothContact:
        """The contact at a phase.

        Parameters
        ----------
        phase : float
            Place in the cycle; the tooth pair touches from 0 to 1, the flanks beyond.
        speed : float
            Worm speed [rad/s].
        """
        line = self.line
        place = self.begin + phase * (self.end - self.begin)
        point = line.foot + place * line.direction
        worm_angle, wheel_angle = self.angles(place)
        normal = -line.direction
        worm_planes = WormPlanes(self.worm, worm_angle)
        wheel_planes = WheelPlanes(self.flank, wheel_angle)
        worm_start, wheel_start = (line.worm_theta,), (line.hob_theta, line.lag)
        first = across_axis(normal)
        first = first / np.linalg.norm(first)
        axes = np.array([first, np.cross(normal, first), normal])
        relative = (
            FlankHeight(wheel_planes, point, axes, wheel_start).curvatures
            - FlankHeight(worm_planes, point, axes, worm_start).curvatures
        )
        curvatures, directions = np.linalg.eigh(relative)
        x_axis = directions[:, 0] @ axes[:2]
        sweep = np.cross(self.worm.axes[:, 2], point - self.worm.axis_point)
        x_axis = x_axis * np.sign(x_axis @ sweep)
        y_axis = np.cross(normal, x_axis)
        axes = np.array([x_axis, y_axis, normal])
        flat = abs(curvatures[0]) < FLAT * abs(curvatures[1])
        radii = (np.inf if flat else float(1 / curvatures[0])), float(1 / curvatures[1])
        return ToothContact(
            phase=phase,
            worm_angle=worm_angle,
            wheel_angle=wheel_angle,
            transmission_error=float(self.transmission_error(phase)),
            point=point,
            normal=normal,
            x_axis=x_axis,
            y_axis=y_axis,
            radii=radii,
            # a plane of the worm moves along its normal by the base travel per radian
            velocity=self.worm.base_travel * speed * normal,
            worm_height=FlankHeight(worm_planes, point, axes, worm_start),
            wheel_height=FlankHeight(wheel_planes, point, axes, wheel_start),
        )


def find_mesh_cycle(
    worm: Helicoid, flank: WheelFlank, worm_tooth: WormTooth, wheel_tooth: WheelTooth
) -> MeshCycle:
    """Find the mesh cycle and its ends at the tooth boundaries.

    Raises
    ------
    ValueError
        If the flanks do not touch on the teeth, or interfere.
    """
    cuts = False
    cycles = []
    for line in lines_of_action(worm, flank):

        def margins(place: Array | float, line: LineOfAction = line) -> dict[str, Array]:
            at = np.asarray(place)
            spread = (3,) + (1,) * at.ndim
            point = line.foot.reshape(spread) + line.direction.reshape(spread) * at
            return {**worm_tooth.margins(point), **wheel_tooth.margins(point)}

        def margin(place: Array | float, margins=margins) -> Array:
            return np.min(np.stack(list(margins(place).values())), axis=0)

        def boundary(place: float, margins=margins) -> str:
            here = margins(place)
            return min(here, key=lambda name: float(here[name]))

        # the line leaves the worm's tip cylinder within a few tip radii of the worm's mid-plane
        centre = -line.foot[2] / line.direction[2]
        places = centre + np.linspace(-4, 4, 4001) * worm_tooth.tip_radius
        inside = margin(places) > 0
        edges = np.flatnonzero(inside[:-1] != inside[1:])
        for low, high in pairwise(edges):
            if not inside[low + 1]:
                continue
            end = scipy.optimize.brentq(margin, places[low], places[low + 1], xtol=1e-15)
            begin = scipy.optimize.brentq(margin, places[high], places[high + 1], xtol=1e-15)
            cycle = MeshCycle(worm, flank, line, begin, end, boundary(begin), boundary(end))
            if all(min(cycle.contact(phase).radii) > 0 for phase in (0.0, 0.5, 1.0)):
                cycles.append(cycle)
            else:
                cuts = True
    if cycles:
        return max(cycles, key=lambda cycle: cycle.worm_rotation)
    if cuts:
        raise ValueError(
            "hob: the wheel it cuts would interfere with the worm (a relative radius of curvature is "
            "negative); a hob at least as large as the worm, set up near the wheel's mid-plane, "
            "is needed"
        )
    raise ValueError(
        f"hob.swivel and hob.axial_shift are {np.degrees(flank.hob.swivel):.4g} deg and "
        f"{flank.hob.axial_shift * 1e3:.4g} mm, for which no common normal of worm and wheel lies on "
        "the teeth; a set-up that brings the contact between the face ends is needed"
    )
