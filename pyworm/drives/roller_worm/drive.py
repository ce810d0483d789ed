"""The roller enveloping worm drive: what it answers of its mesh."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import sin

from pyworm.drives.answers import ElementBearing, FigureTable, Space
from pyworm.drives.drive import Drive
from pyworm.drives.forces import MeshForces, Supports
from pyworm.drives.loaded_root import LoadedRoot
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.roller_worm.checks import check_gears
from pyworm.drives.roller_worm.dataset import roller_cycle_data
from pyworm.drives.roller_worm.geometry_table import SHEET, described_rollers
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.mesh_loss import roller_mesh_loss
from pyworm.drives.roller_worm.pins import pin_bearing
from pyworm.drives.roller_worm.roots import roller_roots
from pyworm.drives.roller_worm.rotation_figures import rotates_freely, rotation_figures
from pyworm.drives.roller_worm.shaft_forces import roller_forces
from pyworm.drives.roller_worm.shapes import in_space
from pyworm.drives.rotor import Rotor
from pyworm.drives.tooth_life import ToothLife
from pyworm.formulas.ranges import one_of
from pyworm.io.on_demand import xarray as xr
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class RollerWormDrive(RollerMesh, Drive):
    """A roller enveloping worm drive; ValueError, which begins with a key, if worm and rollers do not fit."""

    body_names = "worm", "roller"
    cycle_seconds = (
        9.0  # rotation 4 s, other data 3 s, and 2 s more of pictures than a gear pair has
    )
    sheet = SHEET
    possible_drivers = ("worm",)

    def __post_init__(self) -> None:
        check_gears(self)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The rule of load sharing, in words."""
        return (f"The load is shared as operation.sharing = {self.sharing} says.",)

    def scene(self, section: str, phase: float, station: float | None = None) -> LineScene | Scene:
        """The lubricated contact of a roller: body 1 is the worm, body 2 the roller.

        At a phase of the roller in the section "right" or "left", at a station, a fraction of the contact
        line, by default the whole line with its ends. ValueError if the roller carries no load there.
        """
        part = self.sections[section]
        scene_at = partial(self.scene_at, section, station=station)
        before, after = self.partly_touched(section) if self.rolling == "dynamic" else (0.0, 0.0)
        return ToothLife(
            scene_at, self.turning / (part.last - part.first), before=before, after=after
        ).at(phase)

    def in_space(self, places: Sequence[ContactIndex]) -> Space:
        """Both flanks of the worm and the rollers about it."""
        return in_space(self, places)

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss of all rollers in mesh; None for too few phases of a section that carries load."""
        return roller_mesh_loss(self, contacts)

    def element_bearing(self) -> ElementBearing:
        """The rollers on their pins."""
        return pin_bearing(self)

    def roots(self) -> tuple[LoadedRoot, ...]:
        """Roots of the thread and of the pins, where their radius is given."""
        return roller_roots(self)

    def at_load(self, speed: float, torque: float) -> "RollerWormDrive":
        """The rollers at another speed of the worm [rad/s] and torque of the wheel without friction [N m]."""
        return replace(self, speed=speed, torque=torque * self.wheel_speed / self.speed)

    def motion_figures(self) -> FigureTable | None:
        """Rotation of the rollers about their axes; None where their friction is not known, or locks them."""
        return rotation_figures(self) if rotates_freely(self) else None

    def geometry_table(self) -> dict[str, float | str]:
        """Worm and rollers with their mesh."""
        return described_rollers(self)

    def mesh_forces(self, friction: float | None = None, driver: str | None = None) -> MeshForces:
        """Mean forces of all rollers without friction; ValueError unless the worm drives."""
        one_of("driver", driver or "worm", self.possible_drivers)
        return roller_forces(self)

    @property
    def supports(self) -> dict[str, Supports]:
        """Bearings of both shafts, where they are given."""
        both = {"worm": self.shaft, "wheel": self.wheel_shaft}
        return {name: supports for name, supports in both.items() if supports is not None}

    @property
    def shaft_speeds(self) -> dict[str, float]:
        """Speeds of both shafts [rad/s]."""
        return {"worm": self.speed, "wheel": self.wheel_speed}

    def cycle_data(self) -> "xr.Dataset":
        """The mesh cycle of both sections for the result."""
        return roller_cycle_data(self)

    @property
    def rotors(self) -> tuple[Rotor, Rotor]:
        """The worm as a cylinder as thick as its throat, and the wheel as a disc as thick as its rollers."""
        spans = {name: bearings.bearing_span for name, bearings in self.supports.items()}
        worm = Rotor(
            name="worm",
            diameter=2 * self.throat_radius,
            width=2 * self.pitch_radius * sin(self.worm.outer_angle),
            speed=self.speed,
            torque=self.torque,
            body=self.bodies[0],
            bearing_span=spans.get("worm"),
        )
        wheel = Rotor(
            name="wheel",
            diameter=2 * self.pitch_radius,
            width=2 * self.rollers.profile.radius,
            speed=self.wheel_speed,
            torque=self.torque * self.ratio,
            body=self.bodies[1],
            bearing_span=spans.get("wheel"),
        )
        return worm, wheel
