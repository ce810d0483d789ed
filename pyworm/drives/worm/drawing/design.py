"""Design data of a worm drive: worm, wheel, hob and their assembly."""

from dataclasses import dataclass, replace
from math import pi
from typing import Literal

import numpy as np

from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.screw_generator import ScrewGenerator
from pyworm.drives.worm.flanks.worm_profiles import Profile
from pyworm.io import units
from pyworm.materials.body import Body
from pyworm.materials.long_waves import LongWaves

Hand = Literal["right", "left"]


@dataclass(frozen=True)
class ParabolicRelief:
    """Tip relief that grows as a parabola and begins without a kink."""

    amount: float = 0.0
    """Relief at the tip [m]."""
    length: float = 0.0
    """Radial distance from the tip at which it begins [m]."""

    def __call__(self, below_tip: Array) -> Array:
        """What is taken off [m] at a distance below the tip [m]; beyond the tip it continues."""
        return self.amount * np.maximum(1 - below_tip / self.length, 0.0) ** 2


NO_RELIEF = ParabolicRelief()


@dataclass(frozen=True)
class Worm:
    """The worm's design table."""

    threads: int
    """Number of threads."""
    tip_radius: float
    """Radius of the tip cylinder [m]."""
    root_radius: float
    """Radius of the root cylinder [m]."""
    base_radius: float | None
    """Radius of the base cylinder [m]; None of other profiles than ZI, which have none."""
    axial_pitch: float
    """Distance of neighbouring threads along the axis [m]."""
    lead: float
    """Advance in one turn [m]."""
    base_lead_angle: float | None
    """Lead angle on the base cylinder [rad]; None likewise."""
    tip_relief: ParabolicRelief = NO_RELIEF
    """What is taken off the flank towards its tip."""
    reference_radius: float | None = None
    """Radius of the reference cylinder [m], where it is known."""
    thickness: float | None = None
    """Axial thickness of the thread at the reference cylinder [m], where it is known."""
    generator: ScrewGenerator | None = None
    """What sweeps the flank of any other profile than ZI."""
    profile: Profile = "ZI"
    """Form of the flank (`pyworm.drives.worm.flanks.worm_profiles`)."""
    deviations: FlankDeviations | None = None
    """Deviations of the flanks that drive the wheel from the helicoid; None where none are known."""
    fillet_radius: float = 0.0
    """Radius of the fillet at the root in the axial section [m]."""


@dataclass(frozen=True)
class Wheel:
    """The wheel's design table; its flank is cut by the hob."""

    teeth: int
    """Number of teeth."""
    face_width: float
    """Width along the axis [m]."""
    tip_radius: float
    """Radius of the tip cylinder [m]."""
    throat_radius: float
    """Tip radius in the mid-plane [m]."""
    tip_relief: ParabolicRelief = NO_RELIEF
    """What is taken off the flank towards tip and throat."""
    groove_radius: float | None = None
    """Radius of the throat's profile [m]; None where it is concentric with the hob."""
    backlash: float | None = None
    """Circumferential backlash on the reference circle [m], where it is known."""
    deviations: FlankDeviations | None = None
    """Deviations of the driven flank from the one that the hob cuts; None where none are known."""
    fillet_radius: float = 0.0
    """Radius [m] of the rounded edge of the hob's tip, axially, which leaves the wheel's fillet."""


@dataclass(frozen=True)
class Hob:
    """The hob's design table and its set-up."""

    tip_radius: float
    """Radius of the tip cylinder [m]."""
    root_radius: float
    """Radius of the root cylinder [m]."""
    base_radius: float | None
    """Radius of the base cylinder [m]; None of other profiles than ZI, which have none."""
    lead: float
    """Advance in one turn [m]."""
    axial_pitch: float
    """Distance of neighbouring threads along the axis [m]."""
    base_lead_angle: float | None
    """Lead angle on the base cylinder [rad]; None likewise."""
    centre_distance: float
    """Distance of hob and wheel axes [m]."""
    swivel: float
    """Turn of the hob's axis about the common perpendicular, out of the direction of the worm's axis [rad];
    positive adds to the lead angle that the wheel sees."""
    axial_shift: float
    """Shift of the hob along the wheel's axis from the middle of the face [m], positive to the side where the
    worm's threads leave. A shift along the hob's own axis only turns the wheel."""
    generator: ScrewGenerator | None = None
    """What sweeps the flank of any other profile than ZI."""


@dataclass(frozen=True)
class Assembly:
    """Errors of the assembly of worm and wheel, as differences from the design."""

    centre_distance: units.Offset = 0.0
    """Distance of the axes beyond the design's [m]."""
    axial_shift: units.Offset = 0.0
    """Shift of the worm along the wheel's axis [m], positive to the side where the worm's threads leave."""
    shaft_angle: units.Tilt = 0.0
    """Turn of the worm's axis about the line of centres [rad], positive as the hob's swivel."""


AS_DESIGNED = Assembly()


@dataclass(frozen=True)
class Design:
    """Worm, wheel and hob of a drive, and how far they are the user's own."""

    worm: Worm
    """Design table of the worm."""
    wheel: Wheel
    """Design table of the wheel."""
    hob: Hob
    """Design table of the hob."""
    centre_distance: float
    """Distance of worm and wheel axes [m]."""
    hand: Hand = "right"
    """Hand of the threads. All is computed for right-hand ones: a left-hand drive is its mirror image."""
    assumed: tuple[str, ...] = ()
    """Usual values that were taken where none was given, a sentence each that begins with the key."""

    def seen(self, bodies: tuple[Body, Body]) -> tuple[Body, Body]:
        """Worm and wheel with their roughness as in the mirror image, where that is computed."""
        if self.hand == "right":
            return bodies
        worm, wheel = (_mirrored(body) for body in bodies)
        return worm, wheel


def _mirrored(body: Body) -> Body:
    heights, waves = body.topography, body.long_waves
    return replace(
        body,
        lay=-body.lay % pi,
        topography=None if heights is None else heights.mirrored,
        long_waves=None if waves is None else LongWaves(waves.surface.mirrored),
    )
