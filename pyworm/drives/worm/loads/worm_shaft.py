"""The worm's shaft between its bearings: how the forces of the mesh bend it, and what that does to the mesh.

All teeth in mesh act as one force in mid-mesh, whose direction hardly changes over a mesh cycle: the torque
over its arm along the common normal, and friction along the sliding. The shaft is round and uniform, its
bearings are simple supports (`pyworm.formulas.beam`). At the mesh it moves away from the wheel, along the
wheel's axis, and tilts: errors of the assembly under load. A tilt towards the wheel turns the wheel and has
no other influence of first order.
"""

from dataclasses import dataclass, replace
from math import hypot, inf, sqrt

from pyworm.drives.worm.drawing.design import Assembly, Worm
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.formulas.beam import bending, second_moment
from pyworm.io import units

MAX_DEFLECTION = 0.1
"""Deflection over the module above which worm and wheel no longer mesh as designed."""


@dataclass(frozen=True)
class WormShaft:
    """The worm's shaft and its bearings; ValueError if the mesh does not lie between the bearings."""

    bearing_span: units.Length
    """Distance of the bearings [m]."""
    bearing_offset: units.Offset = 0.0
    """Middle of the bearings from the line of centres [m], positive to where the worm's thrust acts."""
    diameter: units.Length | None = None
    """Diameter of a uniform shaft that bends as much [m]; None for the worm's root diameter."""
    bearing_stiffness: units.Stiffness = inf
    """Radial stiffness of each bearing with its seat [N/m]; infinite if rigid."""

    def __post_init__(self) -> None:
        half = self.bearing_span / 2
        if abs(self.bearing_offset) >= half:
            raise ValueError(
                f"shaft.bearing_offset is {self.bearing_offset * 1e3:.4g} mm; it must be less than half of "
                f"bearing_span, {half * 1e3:.4g} mm, so that the mesh lies between the bearings; overhung "
                "worms are not computed"
            )

    @property
    def turned(self) -> "WormShaft":
        """The shaft turned by half a turn about the line of centres."""
        return WormShaft(
            self.bearing_span, -self.bearing_offset, self.diameter, self.bearing_stiffness
        )


@dataclass(frozen=True)
class BentShaft:
    """The worm's shaft under load."""

    force: Array
    """Force of the wheel's teeth on the worm in the drive frame, (3,) [N]."""
    away: float
    """Deflection at the mesh away from the wheel [m]."""
    along: float
    """Deflection at the mesh along the wheel's axis to the leaving side [m]."""
    tilt: float
    """Turn of the worm's axis about the line of centres, as `Assembly.shaft_angle` [rad]."""
    reactions: tuple[float, float]
    """Radial force of each bearing [N], first the one that the driving worm's thrust leads away from."""

    @property
    def deflection(self) -> float:
        """Deflection at the mesh in its own direction [m]."""
        return hypot(self.away, self.along)

    def assembly(self, before: Assembly) -> Assembly:
        """Errors of the assembly with those of the bent shaft."""
        return Assembly(
            before.centre_distance + self.away,
            before.axial_shift + self.along,
            before.shaft_angle + self.tilt,
        )


@dataclass(frozen=True)
class MeshForce:
    """The mean force of the teeth in mesh."""

    point: Array
    """Where it acts on the worm in the drive frame, (3,) [m]."""
    force: Array
    """The force, (3,) [N]."""


def bent_shaft(
    shaft: WormShaft, gears: WormGears, mean: MeshForce, youngs_modulus: float
) -> BentShaft:
    """The shaft under the mean force of the wheel's teeth on the worm, which meshes as on a rigid shaft.

    ValueError if a bearing lies where the wheel is, or the shaft bends by more than a tenth of the module.
    """
    _check_bearings(gears, shaft)
    diameter = _diameter(shaft, gears.worm)
    force = mean.force
    arm = mean.point - gears.worm_flank.axis_point
    before = shaft.bearing_span / 2 - shaft.bearing_offset + arm[2]
    beyond = shaft.bearing_span - before
    rigidity = youngs_modulus * second_moment(diameter)
    radial, lateral = (
        bending(
            force[side], -arm[side] * force[2], before, beyond, rigidity, shaft.bearing_stiffness
        )
        for side in (0, 1)
    )
    bent = BentShaft(
        force=force,
        away=float(-radial.deflection),
        # the shift of the worm is that of its axis in the line of centres
        along=float(lateral.deflection - lateral.slope * arm[2]),
        tilt=float(-lateral.slope),
        reactions=(
            hypot(radial.reactions[0], lateral.reactions[0]),
            hypot(radial.reactions[1], lateral.reactions[1]),
        ),
    )
    if bent.deflection > MAX_DEFLECTION * gears.module:
        by_shaft = bent.deflection
        if shaft.bearing_stiffness < inf:
            stiff = replace(shaft, bearing_stiffness=inf)
            by_shaft = bent_shaft(stiff, gears, mean, youngs_modulus).deflection
        raise ValueError(_too_soft(gears, shaft, diameter, (bent.deflection, by_shaft)))
    return bent


def _diameter(shaft: WormShaft, worm: Worm) -> float:
    """Diameter of a shaft [m], if it is not given the worm's root diameter; one above the tip is refused."""
    diameter = 2 * worm.root_radius if shaft.diameter is None else shaft.diameter
    if diameter > 2 * worm.tip_radius:
        raise ValueError(
            f"shaft.diameter is {diameter * 1e3:.4g} mm, thicker than the worm's tip, "
            f"{2e3 * worm.tip_radius:.4g} mm; that of a uniform shaft which bends as much is required, "
            f"as a rule near the worm's root diameter, {2e3 * worm.root_radius:.4g} mm"
        )
    return diameter


def _too_soft(
    gears: WormGears, shaft: WormShaft, diameter: float, deflections: tuple[float, float]
) -> str:
    """Message about a shaft whose mesh deflects too much [m], or the part of that which bending makes."""
    deflection, by_shaft = deflections
    most = f"worms of this module may move {MAX_DEFLECTION * gears.module * 1e3:.2g} mm at most"
    if shaft.bearing_stiffness < inf:
        return (
            f"shaft.bearing_stiffness is {shaft.bearing_stiffness * 1e-6:.3g} N/um, with which the mesh "
            f"moves {deflection * 1e3:.3g} mm under the load, {by_shaft * 1e3:.2g} mm of it by the shaft "
            f"itself; {most}"
        )
    return (
        f"shaft.bearing_span is {shaft.bearing_span * 1e3:.4g} mm and shaft.diameter {diameter * 1e3:.4g} "
        f"mm, which bends {deflection * 1e3:.2g} mm under the load; a shorter or thicker shaft is needed, "
        f"{most}"
    )


def _check_bearings(gears: WormGears, shaft: WormShaft) -> None:
    """Refuse bearings within the part of the worm that the wheel's teeth reach into."""
    nearest = shaft.bearing_span / 2 - abs(shaft.bearing_offset)
    below = max(gears.centre_distance - gears.worm.tip_radius, 0.0)
    reach = sqrt(max(gears.wheel.throat_radius**2 - below**2, 0.0))
    if nearest < reach:
        raise ValueError(
            f"shaft.bearing_span is {shaft.bearing_span * 1e3:.4g} mm, which leaves {nearest * 1e3:.4g} mm "
            "from the line of centres to a bearing; the wheel's teeth are between the threads up to "
            f"{reach * 1e3:.4g} mm from there, and the bearings lie beyond, {2 * reach * 1e3:.4g} mm apart "
            "or more; is it half of the span?"
        )
