"""Forces of the mesh on both shafts, and of their bearings.

Each shaft has its own axes: radial from its axis to the mating one along the line of centres, axial to where
the mesh pushes it as the drive runs (its thrust side), tangential so that all three are right-handed.
"""

from dataclasses import dataclass, replace
from math import hypot
from typing import Any, Literal

import numpy as np

from pyworm.formulas.beam import support_forces
from pyworm.io import units

Array = np.ndarray

Side = Literal["thrust", "opposite"]
"""Bearing to which the thrust of the mesh pushes the shaft as the drive runs, or the other one."""


@dataclass(frozen=True)
class Supports:
    """Two bearings of a rigid shaft; ValueError if the mesh does not lie between them."""

    bearing_span: units.Length
    """Distance of the bearings [m]."""
    bearing_offset: units.Offset = 0.0
    """Middle of the bearings from the line of centres [m], positive to the thrust side."""

    def __post_init__(self) -> None:
        half = self.bearing_span / 2
        if abs(self.bearing_offset) >= half:
            raise ValueError(
                f"bearing_offset is {self.bearing_offset * 1e3:.4g} mm; it must be less than half of "
                f"bearing_span, {half * 1e3:.4g} mm, so that the mesh lies between the bearings; overhung "
                "shafts are not computed"
            )


@dataclass(frozen=True)
class BearingForce:
    """Load of a bearing."""

    radial: float
    """Radial load [N]."""
    thrust: float
    """Thrust of the shaft [N], which this bearing takes if it is the locating one."""


@dataclass(frozen=True)
class ShaftForce:
    """The mesh's forces on one shaft, in its axes."""

    shaft: str
    """Shaft, by the name of its body."""
    radial: float
    """Force towards the mating axis, negative where it separates the shafts [N]."""
    tangential: float
    """Force across the line of centres and the axis [N]."""
    axial: float
    """Force along the axis [N]."""
    moment: tuple[float, float, float]
    """Moment about the point of the axis on the line of centres, by the same axes; the last is the torque of
    the mesh [N m]."""

    @property
    def torque(self) -> float:
        """Torque of the mesh about the shaft's axis [N m]."""
        return self.moment[2]

    @property
    def reversed(self) -> "ShaftForce":
        """The force as the drive runs the other way, on its other flanks: half a turn about the radius."""
        radial, tangential, axial = self.moment
        return replace(
            self,
            tangential=-self.tangential,
            axial=-self.axial,
            moment=(radial, -tangential, -axial),
        )

    def bearings(self, supports: Supports) -> dict[Side, BearingForce]:
        """Loads of both bearings of the shaft."""
        before = supports.bearing_span / 2 - supports.bearing_offset
        beyond = supports.bearing_span - before
        planes = (
            support_forces(self.radial, self.moment[1], before, beyond),
            support_forces(self.tangential, -self.moment[0], before, beyond),
        )
        opposite, thrust = (hypot(*forces) for forces in zip(*planes, strict=True))
        along = abs(self.axial)
        return {
            "thrust": BearingForce(thrust, along),
            "opposite": BearingForce(opposite, along),
        }

    def summary(self) -> dict[str, Any]:
        """Components and torque, units in the keys."""
        return {
            "tangential_N": self.tangential,
            "axial_N": self.axial,
            "radial_N": self.radial,
            "torque_N_m": self.torque,
        }


@dataclass(frozen=True)
class MeshForces:
    """Forces of the mesh on both shafts, equal and opposite."""

    driver: str
    """Driving shaft."""
    friction: float
    """Coefficient of friction [-]."""
    shafts: tuple[ShaftForce, ShaftForce]
    """Force on the shaft of body 1 and of body 2."""

    def on(self, shaft: str) -> ShaftForce:
        """The force on a shaft; ValueError with the shafts that there are."""
        for force in self.shafts:
            if force.shaft == shaft:
                return force
        known = ", ".join(force.shaft for force in self.shafts)
        raise ValueError(f'shaft is "{shaft}"; it must be one of {known}')

    def summary(self) -> dict[str, Any]:
        """Forces of both shafts as an object for JSON."""
        return {
            "driver": self.driver,
            "friction": self.friction,
            **{force.shaft: force.summary() for force in self.shafts},
        }


@dataclass(frozen=True)
class ShaftAxes:
    """A shaft and its axes in those of the drive."""

    shaft: str
    """Shaft, by the name of its body."""
    origin: Array
    """Point of its axis on the line of centres, (3,) [m]."""
    towards: Array
    """Unit vector to the mating axis, (3,)."""
    axis: Array
    """Unit vector along its axis to its thrust side, (3,)."""

    def force(self, points: Array, forces: Array) -> ShaftForce:
        """The force on the shaft of forces (3, n) [N] at points (3, n) [m]."""
        rows = np.stack([self.towards, np.cross(self.axis, self.towards), self.axis])
        turning = np.cross(points - self.origin[:, None], forces, axis=0)
        radial, tangential, axial = (float(part) for part in rows @ forces.sum(axis=1))
        about = rows @ turning.sum(axis=1)
        moment = float(about[0]), float(about[1]), float(about[2])
        return ShaftForce(self.shaft, radial, tangential, axial, moment)
