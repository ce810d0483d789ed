"""Loads of the rollers' pins over the mesh, the bearings on them, and where the rollers' power is lost.

The worm presses a roller by w for each length against the normal and drags it by the film's shear, whose
closed form also turns free rollers (`motion`): Moes' film, Hertz's width and mean pressure. The pin takes the
sum: across its axis as a radial load of its bearing, along it as a thrust. Rollers carry load in both
sections of a divided worm, those of a double row along one flank. The load that wears a bearing as much as
the varying one is the mean of its power 10/3 over the turns under load (ISO 281).
"""

from dataclasses import dataclass
from math import pi

import numpy as np

from pyworm.drives.answers import ElementBearing
from pyworm.drives.cached import cached
from pyworm.drives.roller_worm.envelope import Array, LineContact
from pyworm.drives.roller_worm.load_sharing import slices
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.motion import FilmTraction, LineMotion, flow_stress, line_motion

PHASES = (np.arange(12) + 0.5) / 12
"""Phases of each section over which loads and losses are averaged."""

LIFE_EXPONENT = 10 / 3
"""Exponent of the life of roller bearings [-], ISO 281."""

LOSSES = {
    "turning_loss": "sliding round the rollers",
    "axial_loss": "sliding along the rollers",
    "pin_loss": "pins",
}
"""Part of the loss of a roller -> what it is called."""


@dataclass(frozen=True)
class PinLoad:
    """One roller on its pin at one instant."""

    radial: float
    """Load of its bearing across the axis [N]."""
    axial: float
    """Thrust along the axis, outward on the roller's axis d [N]."""
    speed: float
    """Speed about its own axis [rad/s]."""
    turning_loss: float
    """Power lost in the film by sliding round the roller [W]."""
    axial_loss: float
    """Power lost in the film by sliding along the roller [W]."""
    pin_loss: float
    """Power lost on the pin [W]."""


@cached
def pin_load(mesh: RollerMesh, section: str, phase: float) -> PinLoad:
    """Load of a roller's pin at a phase of a section; without shear where the oil has no flow law."""
    part = mesh.sections[section]
    angle = float(part.wheel_angle(phase))
    speed = float(mesh.state(section, phase, [0.5]).motion.roller_speed[0])
    contact, lengths = slices(part, np.array(angle))
    shared = mesh.shared(section, angle)
    load = shared.load(contact, shared.roller(angle))
    motion = line_motion(part.envelope, contact, mesh.turning, speed)
    shear = _shear(mesh, contact, load, motion)
    slide = motion.sliding[0] * motion.x_axis + motion.sliding[1] * motion.y_axis
    total = np.hypot(*motion.sliding)
    towards = np.divide(slide, total, out=np.zeros_like(slide), where=total > 0)
    force = ((shear * towards - load * contact.normal) * lengths).sum(axis=1)
    _, _, axis, _ = part.envelope.axes(np.array(angle))
    thrust = float(force @ axis)
    # sliding round the roller, and what is left of the whole
    round_ = motion.round_worm - motion.round_roller
    power = shear * lengths * np.array([round_**2, total**2 - round_**2])
    losses = np.divide(power, total, out=np.zeros_like(power), where=total > 0).sum(axis=1)
    drag = mesh.rollers.pin.moment(np.sum(load * lengths))
    return PinLoad(
        radial=float(np.linalg.norm(force - thrust * axis)),
        axial=thrust,
        speed=speed,
        turning_loss=float(losses[0]),
        axial_loss=float(losses[1]),
        pin_loss=float(drag * abs(speed)),
    )


def _shear(mesh: RollerMesh, contact: LineContact, load: Array, motion: LineMotion) -> Array:
    """Shear force of the film for each length of slices [N/m]."""
    flow, traction = mesh.oil.flow, FilmTraction(mesh.oil, mesh.bodies)
    found = np.zeros(load.shape)
    if flow is None or not (load > 0).any():
        return found
    pressed = load > 0
    width, pressure, viscosity = traction.slices(load[pressed], contact.curvature[pressed])
    film = traction.film(load[pressed], contact.curvature[pressed], motion.entrainment[pressed])
    rate = np.hypot(*motion.sliding)[pressed] / film
    found[pressed] = flow_stress(flow, viscosity, pressure, rate) * width
    return found


@cached
def pin_bearing(mesh: RollerMesh) -> ElementBearing:
    """What the bearing of a roller carries, and the power that all rollers lose, by closed forms."""
    passages = {
        name: [pin_load(mesh, name, float(phase)) for phase in PHASES] for name in mesh.sections
    }
    losses = dict.fromkeys(LOSSES.values(), 0.0)
    for name, section in mesh.sections.items():
        in_mesh = (section.last - section.first) / section.pitch
        for part, words in LOSSES.items():
            mean = float(np.mean([getattr(pin, part) for pin in passages[name]]))
            losses[words] += in_mesh * mean
    paths = [_Path(mesh, {name: passages[name] for name in row}) for row in _rows(mesh)]
    hardest = max(paths, key=lambda path: path.equivalent)
    return ElementBearing(
        name="roller",
        radial=hardest.equivalent,
        radial_max=max(pin.radial for pin in hardest.pins),
        axial_max=max(abs(pin.axial) for pin in hardest.pins),
        speed=float(np.sum(hardest.turns)) * mesh.wheel_speed / (2 * pi),
        speed_max=max(abs(pin.speed) for pin in hardest.pins),
        losses=losses,
    )


def _rows(mesh: RollerMesh) -> list[list[str]]:
    """Sections that each row of rollers passes."""
    if mesh.worm.arrangement == "double":
        return [[name] for name in mesh.sections]
    return [list(mesh.sections)]


@dataclass(frozen=True)
class _Path:
    """A roller through the sections that it passes in a turn of the wheel."""

    mesh: RollerMesh
    """The mesh."""
    passages: dict[str, list[PinLoad]]
    """Loads of its pin at `PHASES` of each section."""

    @property
    def pins(self) -> list[PinLoad]:
        """The loads, one after the other."""
        return [pin for passage in self.passages.values() for pin in passage]

    @property
    def turns(self) -> Array:
        """How far the roller turns under each [rad]."""
        steps = []
        for name, passage in self.passages.items():
            section = self.mesh.sections[name]
            time = (section.last - section.first) / self.mesh.wheel_speed / len(passage)
            loaded = self.mesh.wheel_torque(name) > 0
            steps += [abs(pin.speed) * time if loaded else 0.0 for pin in passage]
        return np.array(steps)

    @property
    def equivalent(self) -> float:
        """Constant radial load of the same life [N]; 0 where the roller does not turn under load."""
        turns, radial = self.turns, np.array([pin.radial for pin in self.pins])
        if not turns.any():
            return 0.0
        return float(np.average(radial**LIFE_EXPONENT, weights=turns) ** (1 / LIFE_EXPONENT))
