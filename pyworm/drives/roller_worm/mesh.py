"""The mesh of rollers and worm: loads, motion and films along contact lines, and their scenes."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from pyworm.drives.cached import cached
from pyworm.drives.forces import Supports
from pyworm.drives.oil_supply import Bath, Jets, Lubricated, LubricatedBody, LubricatedTeeth
from pyworm.drives.roller_worm.envelope import Array, LineContact
from pyworm.drives.roller_worm.film_formulas import ClosedFilms, closed_films
from pyworm.drives.roller_worm.gap import ContactFrame, RollerGap, RollerMotion
from pyworm.drives.roller_worm.gears import RollerGears, SectionName
from pyworm.drives.roller_worm.load_sharing import Compliance, SharedLoad, share, slices
from pyworm.drives.roller_worm.motion import (
    FilmTraction,
    LineMotion,
    Spinning,
    line_motion,
    roller_speed,
)
from pyworm.drives.roller_worm.roller_body import roller_body
from pyworm.drives.roller_worm.roller_path import RollerPath, faces_passed, roller_path
from pyworm.drives.roller_worm.roller_rotation import LoadedPath, RollerRotation, Spun, over_a_turn
from pyworm.drives.roller_worm.section import WormSection
from pyworm.drives.roller_worm.slice_shear import SliceShear
from pyworm.drives.roller_worm.wheel_motion import WheelMotion
from pyworm.drives.torque_sharing import Sharing
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Scene

LEAST_TOUCH = 0.98
"""Part of the way from a section's face to the last touch up to which a roller's contact line is solved."""


@dataclass(frozen=True)
class LineState:
    """One roller at one instant: contacts along its line, with load, motion and closed-form films."""

    section: WormSection
    """The worm's section."""
    shared: SharedLoad
    """The load of all rollers at that instant."""
    force: float
    """The roller's normal load [N]."""
    length: float
    """Length of its contact line [m]."""
    contact: LineContact
    """Contacts at the stations asked for, (stations,)."""
    load: Array
    """Load for each length [N/m]."""
    motion: LineMotion
    """Velocities."""
    films: ClosedFilms
    """Films by formulas."""


@dataclass(frozen=True)
class RollerMesh(RollerGears, Lubricated):
    """Worm and rollers at a speed and a torque."""

    speed: float
    """Speed of the worm [rad/s]."""
    torque: float
    """Torque of the worm [N m]."""
    preload: float
    """Torque about the wheel's axis by which the sections are braced against each other, the only torque of
    the idling one [N m]; 0 where that one touches without load."""
    sharing: Sharing
    """Rule of load sharing: "elastic" or "equal" (`pyworm.drives.roller_worm.load_sharing`)."""
    rolling: Spinning
    """Motion of the rollers: "free", "locked" or "rolling" (`pyworm.drives.roller_worm.motion`)."""
    bodies: tuple[Body, Body]
    """Worm and rollers."""
    oil: Oil
    """The oil."""
    lubrication: Bath | Jets | None = None
    """How oil comes to its rollers; None where there is assumed to be enough."""
    shaft: Supports | None = None
    """Bearings of the worm's shaft; None where they are not given."""
    wheel_shaft: Supports | None = None
    """Bearings of the wheel's shaft, likewise."""
    driving: SectionName = "left"
    """The section that drives: the left one where rollers travel towards it from the right, or the other way
    about."""

    @property
    def wheel_speed(self) -> float:
        """Speed of the wheel [rad/s]."""
        return self.speed / self.ratio

    @property
    def turning(self) -> float:
        """Speed of the wheel about -Z [rad/s], positive where the left section drives."""
        return self.wheel_speed if self.driving == "left" else -self.wheel_speed

    @property
    def _compliance(self) -> Compliance:
        """Compliance of rollers, pins and thread."""
        return Compliance(self.bodies, self.rollers.stiffness)

    def wheel_torque(self, section: str) -> float:
        """Torque about the wheel's axis between it and a section [N m].

        The idling section carries the preload; the driving one that and, without friction, the worm's torque
        times the ratio.
        """
        return self.preload + (self.ratio * self.torque if section == self.driving else 0.0)

    @cached
    def shared(self, section: str, wheel_angle: float) -> SharedLoad:
        """Loads of a section's rollers while one of them is at a wheel angle [rad]."""
        part = self.sections[section]
        torque = self.wheel_torque(section)
        return share(part, self._compliance, wheel_angle, torque, self.sharing)

    def state(self, section: str, phase: float, stations: Sequence[float]) -> LineState:
        """State of a roller at a phase of a section, at fractions of its contact line from 0 to 1."""
        return self._state(section, phase, tuple(stations))

    @cached
    def _state(self, section: str, phase: float, stations: tuple[float, ...]) -> LineState:
        part = self.sections[section]
        angle = float(part.wheel_angle(phase))
        shared = self.shared(section, angle)
        roller = shared.roller(angle)
        contact = part.line(np.array(angle), np.array(stations))
        load = shared.load(contact, roller)
        motion = line_motion(part.envelope, contact, self.turning, self._turning(section, angle))
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

    def passed(self, section: str) -> tuple[str, ...]:
        """Sections that a roller of a section passes, in the order of its travel."""
        if self.worm.arrangement == "double":
            return (section,)
        return (*self.sections,) if self.driving == "left" else (*self.sections,)[::-1]

    def spun(self, section: str, wheel: WheelMotion | None = None, rough: bool = True) -> Spun:
        """A roller of a section with what turns and brakes it, under a motion of the wheel.

        By default that runs steadily from the first touch on. Asperities rub where the roughness is known and
        `rough`.
        """
        names = self.passed(section)
        swaps = wheel is not None and min(wheel.torque) < 0
        paths = {
            name: LoadedPath(
                idle=self._path(name, self.preload) if self.preload > 0 else None,
                driving=self._path(name, self.preload + self.ratio * self.torque)
                if swaps or name == self.driving
                else None,
                sense=1.0 if name == self.driving else -1.0,
            )
            for name in names
        }
        pressed = {name: path for name, path in paths.items() if path.idle or path.driving}
        if wheel is None:
            first = next(iter(pressed.values())).touched
            wheel = WheelMotion(first[0] if self.turning > 0 else first[1], self.turning)
        body = roller_body(self.rollers, self.bodies[1], self.pitch_radius)
        shear = SliceShear.between(FilmTraction(self.oil, self.bodies), rough)
        return Spun(pressed, shear, body, wheel)

    @cached
    def _path(self, section: str, torque: float) -> RollerPath:
        """A roller's path through a section under a torque about the wheel's axis [N m]."""
        part = self.sections[section]

        def loads(wheel_angle: float) -> SharedLoad:
            return share(part, self._compliance, wheel_angle, torque, self.sharing)

        return roller_path(part, loads, self.turning)

    def rotation(self, section: str) -> RollerRotation:
        """Rotation of a roller of a section over a turn of the wheel, by its equation of motion."""
        return self._rotation(self.passed(section)[0])

    @cached
    def _rotation(self, section: str) -> RollerRotation:
        return over_a_turn(self.spun(section))

    @cached
    def partly_touched(self, section: str) -> tuple[float, float]:
        """Phases before the first and after the last one in which a roller touches with a part of its line.

        In the sense in which the wheel turns, but for the last touch at an end of the line.
        """
        part = self.sections[section]
        first, _, _, last = faces_passed(part).tolist()
        ends = (part.first - first, last - part.last)[:: 1 if self.turning > 0 else -1]
        before, after = (LEAST_TOUCH * end / (part.last - part.first) for end in ends)
        return before, after

    @cached
    def _turning(self, section: str, wheel_angle: float) -> float:
        """Speed of a roller about its own axis [rad/s]."""
        if self.rolling == "dynamic":
            return self.rotation(section).at(wheel_angle)
        part, shared = self.sections[section], self.shared(section, wheel_angle)
        line, lengths = slices(part, np.array(wheel_angle))
        return roller_speed(
            part.envelope,
            line,
            lengths,
            shared.load(line, shared.roller(wheel_angle)),
            self.turning,
            self.rolling,
            FilmTraction(self.oil, self.bodies),
            self.rollers.pin,
        )

    def scene_at(self, section: str, phase: float, station: float | None) -> LineScene | Scene:
        """The lubricated contact of a roller, or at a fraction of its contact line, without its past."""
        if station is None:
            return self._whole(section, phase)
        return self._station(section, phase, station)

    def _station(self, section: str, phase: float, station: float) -> LineScene:
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
        wheel = np.array([0.0, 0.0, -self.turning])
        _, _, axis, _ = part.envelope.axes(contact.wheel_angle)
        turns = (
            part.envelope.worm_turn * self.turning,
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

    def lubricated_teeth(self) -> LubricatedTeeth:
        """Worm and rollers as they carry oil; the rollers stand out from their wheel by the worm's depth."""
        worm, length = self.worm, self.rollers.profile.length
        depth = worm.addendum + worm.dedendum
        return LubricatedTeeth(
            bodies={
                "worm": LubricatedBody(self.throat_radius + worm.addendum, depth, self.speed),
                "rollers": LubricatedBody(
                    self.pitch_radius + worm.dedendum, depth, self.wheel_speed
                ),
            },
            face_width=length,
            rate=self.speed * worm.threads / (2 * pi),
            power=self.speed * self.torque,
        )


def _only(contact: LineContact) -> LineContact:
    return LineContact(**{name: part[..., 0] for name, part in vars(contact).items()})
