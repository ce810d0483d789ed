"""The drive of a pair of involute gears: what it answers of its mesh."""

from collections.abc import Sequence
from dataclasses import dataclass

from pyworm.drives.answers import Misalignment, Space
from pyworm.drives.drive import Drive
from pyworm.drives.duty import GearPairDuty
from pyworm.drives.gear_pair.checks import check_gears, check_mesh
from pyworm.drives.gear_pair.dataset import line_of_action_data, with_friction
from pyworm.drives.gear_pair.duty import gear_pair_duty
from pyworm.drives.gear_pair.mesh import GearPairMesh
from pyworm.drives.gear_pair.mesh_loss import gear_mesh_loss
from pyworm.drives.gear_pair.misalignment import gear_misalignment
from pyworm.drives.gear_pair.shapes import in_space
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.tooth_life import ToothLife
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class GearPairDrive(GearPairMesh, Drive):
    """A pair of gears at one operating point; ValueError, which begins with a key, if it cannot run."""

    body_names = "pinion", "gear"
    rated_as = GearPairDuty

    def __post_init__(self) -> None:
        check_gears(self.teeth)
        check_mesh(self)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The rule of load sharing, and rigid teeth and shafts."""
        return (
            f"Load sharing by the rule '{self.load_sharing}'; load factor {self.load_factor:g}.",
            "Shafts and teeth do not deform except in the contact; no dynamic loads but by the load "
            "factor.",
        )

    def scene(self, phase: float) -> LineScene | Scene:
        """The contact at a phase, of a line in mid-face; body 1: pinion, x to its tip, y along the line."""
        base_speed = self.pinion_speed * self.teeth.cylinders[0].base
        return ToothLife(self.scene_at, base_speed / self.teeth.path_length).at(phase)

    def in_space(self, places: Sequence[ContactIndex]) -> Space:
        """Some teeth of both gears."""
        return in_space(
            self.teeth,
            [float(self.contacts(present(place.phase, "phase")).pinion_length) for place in places],
        )

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss by the loss factor and the mean friction; None for fewer than two phases."""
        return gear_mesh_loss(self, contacts)

    def misalignment(self, contacts: Sequence[LineScene | Scene]) -> Misalignment:
        """Line contacts under the uneven load of flanks that are not parallel."""
        return gear_misalignment(self, contacts)

    def duty(self) -> GearPairDuty:
        """The gears as input of ratings by standards."""
        return gear_pair_duty(self)

    def cycle_data(self) -> "xr.Dataset":
        """The line of action with its closed forms, for the result."""
        contacts = self.contacts(self.cycle_phases())
        teeth = self.teeth
        marks = {
            "SAP": 0.0,
            "LPSTC": self.phase_of(teeth.lowest_single),
            "P": self.phase_of(teeth.pitch_point),
            "HPSTC": self.phase_of(teeth.highest_single),
            "EAP": 1.0,
        }
        data = line_of_action_data(contacts, self.rating(contacts), marks, self.driver)
        data = data.assign_attrs(loss_factor=self.loss_factor)
        if self.surfaces is None:
            return data
        friction = self.surfaces.friction_coefficient
        return with_friction(data, friction, self.friction_load_factor(contacts, friction))
