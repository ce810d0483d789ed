"""Worm and wheel of a ZI drive as cut and assembled: flanks, tooth boundaries, mesh cycle.

Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from functools import cached_property
from math import pi

from pyworm.drives.zi_worm.checks import check_gears
from pyworm.drives.zi_worm.design import AS_DESIGNED, Assembly, Hob, Wheel, Worm
from pyworm.drives.zi_worm.gap import ToothGap, surface_points
from pyworm.drives.zi_worm.helicoid import Array, Helicoid
from pyworm.drives.zi_worm.mesh_cycle import MeshCycle, ToothContact, find_mesh_cycle
from pyworm.drives.zi_worm.meshing import WheelFlank
from pyworm.drives.zi_worm.tooth import WheelTooth, WormTooth, wheel_radius

PITCH_WARNED = 5e-6
"""Difference of normal base pitches [m] that gives a warning; tables of four digits leave up to 3 um."""


@dataclass(frozen=True, kw_only=True)
class ZiWormGears:
    """A ZI worm and its wheel.

    Attributes
    ----------
    worm, wheel, hob : Worm, Wheel, Hob
        The design table.
    centre_distance : float
        Distance of worm and wheel axes [m].
    assembly : Assembly
        Errors of the assembly.

    Raises
    ------
    ValueError
        If they do not mesh; the message begins with the key that is wrong.
    """

    worm: Worm
    wheel: Wheel
    hob: Hob
    centre_distance: float
    assembly: Assembly = AS_DESIGNED

    def __post_init__(self) -> None:
        check_gears(self)
        self.cycle  # noqa: B018  gears whose teeth do not touch are refused here

    @property
    def base_pitches(self) -> tuple[float, float]:
        """Normal base pitches of the worm and of the hob, which is the wheel's [m]."""
        screws = self.worm_flank, self.wheel_flank.hob
        worm, hob = (2 * pi * screw.base_travel / self.worm.threads for screw in screws)
        return worm, hob

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the drive, a sentence each: a hob of another base pitch than the worm's."""
        worm, hob = self.base_pitches
        apart = hob - worm
        if abs(apart) <= PITCH_WARNED:
            return ()
        return (
            f"hob.lead and hob.base_radius give a normal base pitch of {hob * 1e3:.4f} mm, "
            f"{abs(apart) * 1e6:.1f} um {'more' if apart > 0 else 'less'} than the worm's "
            f"{worm * 1e3:.4f} mm: each tooth pair meets that far off its neighbours and carries most of the "
            "load at one end of its mesh; equal base pitches, lead x cos(base_lead_angle), share it evenly",
        )

    @property
    def ratio(self) -> float:
        """Mean speed of the wheel by that of the worm, threads / teeth."""
        return self.worm.threads / self.wheel.teeth

    @property
    def pitch(self) -> float:
        """Difference in phase of neighbouring tooth pairs; its inverse is the contact ratio."""
        return 2 * pi / self.worm.threads / abs(self.cycle.worm_rotation)

    @property
    def axes_distance(self) -> float:
        """Distance of worm and wheel axes as assembled [m]."""
        return self.centre_distance + self.assembly.centre_distance

    @cached_property
    def worm_flank(self) -> Helicoid:
        """The worm's helicoid as assembled."""
        errors = self.assembly
        seat = self.axes_distance, errors.shaft_angle, errors.axial_shift
        return Helicoid(self.worm.base_radius, self.worm.lead, *seat)

    @cached_property
    def wheel_flank(self) -> WheelFlank:
        """The flank that the hob cuts."""
        hob = self.hob
        seat = hob.centre_distance, hob.swivel, hob.axial_shift
        return WheelFlank(Helicoid(hob.base_radius, hob.lead, *seat), self.ratio)

    @cached_property
    def worm_tooth(self) -> WormTooth:
        """Boundaries of the worm's thread."""
        worm = self.worm
        return WormTooth(self.worm_flank, worm.root_radius, worm.tip_radius, worm.tip_relief)

    @cached_property
    def wheel_tooth(self) -> WheelTooth:
        """Boundaries of the wheel's tooth."""
        wheel = self.wheel
        size = wheel.face_width, wheel.tip_radius, wheel.throat_radius
        return WheelTooth(self.wheel_flank.hob, *size, self.hob.tip_radius, wheel.tip_relief)

    @cached_property
    def cycle(self) -> MeshCycle:
        """The mesh cycle of one tooth pair."""
        return find_mesh_cycle(self.worm_flank, self.wheel_flank, self.worm_tooth, self.wheel_tooth)

    def gap(self, contact: ToothContact) -> ToothGap:
        """Undeformed gap over the contact's tangent plane."""
        return ToothGap(contact, self.worm_tooth, self.wheel_tooth)

    def flank_place(self, contact: ToothContact, x: Array, y: Array) -> tuple[Array, Array]:
        """Place on the wheel's flank over points of a tangent plane, the same at all wheel angles.

        Returns
        -------
        tuple of ndarray
            Along the face from its middle, and distance from the wheel's axis [m].
        """
        point = surface_points(contact, x, y, contact.wheel_height.solve(x, y)[0])
        return point[1], wheel_radius(point)
