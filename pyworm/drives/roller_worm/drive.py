"""The roller enveloping worm drive: from the design table to contact lines and their scenes.

Rollers stand round a wheel and turn freely on their own axes; the worm is an hourglass in two sections
parted at the throat, its thread the envelope of the rollers. Rollers travel through the right section from
its outer end to the throat, touched from the front by its flank, which idles and takes up the backlash; then
through the left section from the throat to its outer end, pushed from behind: that one drives.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from math import pi

import numpy as np

from pyworm.drives.drive import Drive
from pyworm.drives.lubrication import Bath, Jets, OiledBody, OiledTeeth
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.remembered import remembered
from pyworm.drives.roller_worm.checks import check_drive
from pyworm.drives.roller_worm.dataset import roller_cycle_data
from pyworm.drives.roller_worm.design import Rollers, RollerWorm
from pyworm.drives.roller_worm.envelope import Array, Flank, LineContact, RollerEnvelope
from pyworm.drives.roller_worm.film_formulas import ClosedFilms, closed_films
from pyworm.drives.roller_worm.gap import ContactFrame, RollerGap, RollerMotion
from pyworm.drives.roller_worm.load_sharing import Compliance, SharedLoad, share, slices
from pyworm.drives.roller_worm.mesh_loss import roller_mesh_loss
from pyworm.drives.roller_worm.motion import (
    FilmTraction,
    LineMotion,
    Spinning,
    line_motion,
    roller_speed,
)
from pyworm.drives.roller_worm.section import WormSection
from pyworm.drives.roller_worm.shapes import in_space
from pyworm.drives.shape import Space
from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.torque_sharing import Sharing
from pyworm.io.on_demand import xarray as xr
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.scene.index import Place
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class LineState:
    """One roller at one instant: contacts along its line, with load, motion and closed-form films.

    Attributes
    ----------
    section : WormSection
        The worm's section.
    shared : SharedLoad
        The load of all rollers at that instant.
    force : float
        The roller's normal load [N].
    length : float
        Length of its contact line [m].
    contact : LineContact
        Contacts at the stations asked for, (stations,).
    load : ndarray
        Load for each length [N/m].
    motion : LineMotion
        Velocities.
    films : ClosedFilms
        Films by formulas.
    """

    section: WormSection
    shared: SharedLoad
    force: float
    length: float
    contact: LineContact
    load: Array
    motion: LineMotion
    films: ClosedFilms


@dataclass(frozen=True)
class RollerWormDrive(Drive):
    """A roller enveloping worm drive at one operating point.

    Attributes
    ----------
    worm : RollerWorm
        Design table of the worm.
    rollers : Rollers
        Design table of the rollers.
    centre_distance : float
        Distance of worm and wheel axes [m].
    speed : float
        Speed of the worm [rad/s].
    torque : float
        Torque of the worm [N m].
    preload : float
        Torque about the wheel's axis by which the sections are braced against each other, the only torque
        of the idling one [N m]; 0 where that one touches without load.
    sharing : str
        "elastic" or "equal" (`pyworm.drives.roller_worm.load_sharing`).
    rolling : str
        "free", "locked" or "rolling" (`pyworm.drives.roller_worm.motion`).
    bodies : tuple of Body
        Worm and rollers.
    oil : Oil
        The oil.
    lubrication : Bath, Jets or None
        How oil comes to its rollers; None where there is assumed to be enough.
    """

    body_names = "worm", "roller"

    worm: RollerWorm
    rollers: Rollers
    centre_distance: float
    speed: float
    torque: float
    preload: float
    sharing: Sharing
    rolling: Spinning
    bodies: tuple[Body, Body]
    oil: Oil
    lubrication: Bath | Jets | None = None

    def __post_init__(self) -> None:
        check_drive(self)
        for section in self.sections.values():
            section.check()

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The rule of load sharing, in words."""
        return (f"The load is shared as operation.sharing = {self.sharing} says.",)

    @property
    def ratio(self) -> float:
        """i, rollers over threads [-]."""
        return self.rollers.count / self.worm.threads

    @property
    def wheel_speed(self) -> float:
        """Speed of the wheel [rad/s]."""
        return self.speed / self.ratio

    @property
    def throat_radius(self) -> float:
        """Radius of the worm at its throat where the rollers' middles pass [m]."""
        return self.worm.throat_coefficient * self.centre_distance / 2

    @cached_property
    def sections(self) -> dict[str, WormSection]:
        """The worm's sections by name, in the order of the rollers' travel."""
        worm, rollers = self.worm, self.rollers
        middles = self.centre_distance - self.throat_radius

        def section(name: str, flank: Flank, first: float, last: float) -> WormSection:
            envelope = RollerEnvelope(
                profile=rollers.profile,
                ratio=self.ratio,
                centre_distance=self.centre_distance,
                pitch_radius=middles,
                tilt=rollers.tilt,
                height=rollers.height,
                flank=flank,
                hand=worm.hand,
            )
            bearing = -worm.addendum, worm.dedendum
            return WormSection(name, envelope, first, last, *bearing, rollers.count)

        return {
            "right": section("right", "idle", -worm.outer_angle, -worm.throat_angle),
            "left": section("left", "driving", worm.throat_angle, worm.outer_angle),
        }

    @property
    def compliance(self) -> Compliance:
        """Compliance of rollers, pins and thread."""
        return Compliance(self.bodies, self.rollers.stiffness)

    def wheel_torque(self, section: str) -> float:
        """Torque between a section and the wheel [N m], about the wheel's axis.

        The idling section carries the preload; the driving one that and, without friction, the worm's torque
        times the ratio.
        """
        return self.preload + (self.ratio * self.torque if section == "left" else 0.0)

    def varied(self, name: str, value: float) -> "RollerWormDrive":
        """The drive with another "roller_radius" [m], "throat_coefficient" [-] or "tilt" [rad].

        Raises
        ------
        ValueError
            If the flank is undercut, or the rollers leave no thread between them.
        """
        if name == "throat_coefficient":
            return replace(self, worm=replace(self.worm, throat_coefficient=value))
        if name == "tilt":
            return replace(self, rollers=replace(self.rollers, tilt=value))
        profile = replace(self.rollers.profile, radius=value)
        return replace(self, rollers=replace(self.rollers, profile=profile))

    @remembered
    def shared(self, section: str, wheel_angle: float) -> SharedLoad:
        """Loads of a section's rollers while one of them is at a wheel angle [rad]."""
        part = self.sections[section]
        torque = self.wheel_torque(section)
        return share(part, self.compliance, wheel_angle, torque, self.sharing)

    def state(self, section: str, phase: float, stations: Sequence[float]) -> LineState:
        """State of a roller at a phase of a section, at fractions of its contact line from 0 to 1."""
        return self._state(section, phase, tuple(stations))

    @remembered
    def _state(self, section: str, phase: float, stations: tuple[float, ...]) -> LineState:
        part = self.sections[section]
        angle = float(part.wheel_angle(phase))
        shared = self.shared(section, angle)
        roller = shared.roller(angle)
        contact = part.line(np.array(angle), np.array(stations))
        load = shared.load(contact, roller)
        motion = line_motion(
            part.envelope, contact, self.wheel_speed, self._turning(section, angle)
        )
        return LineState(
            section=part,
            shared=shared,
            force=float(shared.forces[roller]),
            length=float(shared.lengths[roller]),
            contact=contact,
            load=load,
            motion=motion,
            films=closed_films(contact.curvature, load, motion, self.bodies, self.oil),
        )

    @remembered
    def _turning(self, section: str, wheel_angle: float) -> float:
        """Speed of a roller about its own axis [rad/s]."""
        part, shared = self.sections[section], self.shared(section, wheel_angle)
        line, lengths = slices(part, np.array(wheel_angle))
        return roller_speed(
            part.envelope,
            line,
            lengths,
            shared.load(line, shared.roller(wheel_angle)),
            self.wheel_speed,
            self.rolling,
            FilmTraction(self.oil, self.bodies),
            self.rollers.pin,
        )

    def scene(self, section: str, phase: float, station: float | None = None) -> LineScene | Scene:
        """The lubricated contact of a roller: body 1 is the worm, body 2 the roller.

        Parameters
        ----------
        section : str
            "right" or "left".
        phase : float
            Phase of the roller in the section, 0 to 1.
        station : float, optional
            Fraction of the contact line, for the line contact there; by default the whole line with its ends.

        Raises
        ------
        ValueError
            If the roller carries no load there.
        """
        part = self.sections[section]
        at = (
            partial(self._whole, section)
            if station is None
            else partial(self._station, section, station=station)
        )
        return ToothLife(at, self.wheel_speed / (part.last - part.first)).at(phase)

    def _station(self, section: str, phase: float, station: float) -> LineScene:
        """The line contact at a fraction of a contact line."""
        state = self.state(section, phase, [station])
        load = float(state.load[0])
        if not load > 0:
            raise ValueError(f"station {station:g} of the contact line carries no load")
        radius = 1 / float(state.contact.curvature[0])
        return LineScene(
            name=f"{section}, phase {phase:.3g}, station {station:.3g}",
            gap=Parabola(radius),
            radius=radius,
            velocities=(float(state.motion.worm[0, 0]), float(state.motion.roller[0, 0])),
            load=load,
            bodies=self.bodies,
            oil=self.oil_supplied,
            phase=phase,
            section=section,
            station=station,
        )

    def _whole(self, section: str, phase: float) -> Scene:
        """The scene of a contact line with its ends, about its point of least crown relief."""
        crown = self.rollers.profile.crown
        if crown is None:
            raise ValueError("a contact line with its ends needs rollers with a crown")
        part = self.sections[section]
        low, high = part.span(np.array(part.wheel_angle(phase)))
        station = float(np.clip(-low / (high - low), 0.0, 1.0))
        state = self.state(section, phase, [station])
        contact, motion = _only(state.contact), state.motion
        frame = ContactFrame(part, contact, motion.x_axis[:, 0], motion.y_axis[:, 0])
        wheel = np.array([0.0, 0.0, -self.wheel_speed])
        _, _, axis, _ = part.envelope.axes(contact.wheel_angle)
        turns = (
            part.envelope.worm_turn * self.wheel_speed,
            wheel + float(motion.roller_speed[0]) * axis,
        )
        of_worm, of_roller = (
            RollerMotion(frame, u * frame.x_axis + v * frame.y_axis, turn)
            for (u, v), turn in zip((motion.worm[:, 0], motion.roller[:, 0]), turns, strict=True)
        )
        # along the line: the parabola that falls as far as the crown at the ends of the bearing length
        end = max(part.highest, -part.lowest)
        along = end**2 / (2 * float(crown(np.array(end))))
        return Scene(
            name=f"{section}, phase {phase:.3g}",
            gap=RollerGap(frame),
            radii=(1 / float(contact.curvature), along),
            motions=(of_worm, of_roller),
            load=state.force,
            bodies=self.bodies,
            oil=self.oil_supplied,
            phase=phase,
            section=section,
        )

    def oiled_teeth(self) -> OiledTeeth:
        """Worm and rollers as they carry oil; the rollers stand out from their wheel by the worm's depth."""
        worm, length = self.worm, self.rollers.profile.length
        depth = worm.addendum + worm.dedendum
        middles = self.centre_distance - self.throat_radius
        return OiledTeeth(
            bodies={
                "worm": OiledBody(self.throat_radius + worm.addendum, depth, self.speed),
                "rollers": OiledBody(middles + worm.dedendum, depth, self.wheel_speed),
            },
            face_width=length,
            rate=self.speed * worm.threads / (2 * pi),
            power=self.speed * self.torque,
        )

    def in_space(self, places: Sequence[Place]) -> Space:
        """Both flanks of the worm and the rollers about it."""
        return in_space(self, places)

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss of all rollers in mesh; None for too few phases of a section that carries load."""
        return roller_mesh_loss(self, contacts)

    def cycle_data(self) -> "xr.Dataset":
        """The mesh cycle of both sections for the result."""
        return roller_cycle_data(self)


def _only(contact: LineContact) -> LineContact:
    """The single contact of an array of one."""
    return LineContact(**{name: part[..., 0] for name, part in vars(contact).items()})
