"""Design data of a ZI worm drive: worm, wheel, hob and their assembly."""

from dataclasses import dataclass

from pyworm.drives.zi_worm.tooth import NO_RELIEF, ParabolicRelief


@dataclass(frozen=True)
class Worm:
    """The worm's design table.

    Attributes
    ----------
    threads : int
        Number of threads.
    tip_radius, root_radius, base_radius : float
        Radii of the tip, root and base cylinders [m].
    axial_pitch, lead : float
        Distance of neighbouring threads along the axis, and advance in one turn [m].
    base_lead_angle : float
        Lead angle on the base cylinder [rad].
    tip_relief : ParabolicRelief
        What is taken off the flank towards its tip.
    """

    threads: int
    tip_radius: float
    root_radius: float
    base_radius: float
    axial_pitch: float
    lead: float
    base_lead_angle: float
    tip_relief: ParabolicRelief = NO_RELIEF


@dataclass(frozen=True)
class Wheel:
    """The wheel's design table; its flank is cut by the hob.

    Attributes
    ----------
    teeth : int
        Number of teeth.
    face_width, tip_radius, throat_radius : float
        Width along the axis, radius of the tip cylinder, tip radius in the mid-plane [m].
    tip_relief : ParabolicRelief
        What is taken off the flank towards tip and throat.
    """

    teeth: int
    face_width: float
    tip_radius: float
    throat_radius: float
    tip_relief: ParabolicRelief = NO_RELIEF


@dataclass(frozen=True)
class Hob:
    """The hob's design table and its set-up.

    Attributes
    ----------
    tip_radius, root_radius, base_radius : float
        Radii of the tip, root and base cylinders [m].
    lead, axial_pitch : float
        Advance in one turn, and distance of neighbouring threads along the axis [m].
    base_lead_angle : float
        Lead angle on the base cylinder [rad].
    centre_distance : float
        Distance of hob and wheel axes [m].
    swivel : float
        Turn of the hob's axis about the common perpendicular, out of the direction of the worm's axis
        [rad]; positive adds to the lead angle that the wheel sees.
    axial_shift : float
        Shift of the hob along the wheel's axis from the middle of the face [m], positive to the side
        where the worm's threads leave.  (A shift along the hob's own axis only turns the wheel.)
    """

    tip_radius: float
    root_radius: float
    base_radius: float
    lead: float
    axial_pitch: float
    base_lead_angle: float
    centre_distance: float
    swivel: float
    axial_shift: float


@dataclass(frozen=True)
class Assembly:
    """Errors of the assembly of worm and wheel, as differences from the design.

    Attributes
    ----------
    centre_distance : float
        Distance of the axes beyond the design's [m].
    axial_shift : float
        Shift of the worm along the wheel's axis [m], positive to the side where the worm's threads leave.
    shaft_angle : float
        Turn of the worm's axis about the line of centres [rad], positive as the hob's swivel.
    """

    centre_distance: float = 0.0
    axial_shift: float = 0.0
    shaft_angle: float = 0.0


AS_DESIGNED = Assembly()
