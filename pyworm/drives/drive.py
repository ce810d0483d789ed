"""What every drive gives: scenes, and what tables, pictures, ratings and reports say of it beside them."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar

import xarray as xr

from pyworm.drives.duty import Duty
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.misalignment import Misalignment
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


class Drive(ABC):
    """A machine that makes contacts. It never solves them.

    A drive has to give `scene` and `cycle_data`; all else is answered here for one of which no more is known.

    Attributes
    ----------
    body_names : tuple of str
        What body 1 and body 2 of its contacts are called.
    rated_as : type or None
        What the standards rate it as, the type of its `duty`; None where they know no such drive.
    assumptions : tuple of str
        What its loads and its geometry take for granted, a sentence each.
    warnings : tuple of str
        What is unusual in it and changes its contacts, a sentence each, beginning with a key of `[drive]`.
    """

    body_names: ClassVar[tuple[str, str]] = ("body 1", "body 2")
    rated_as: ClassVar[type[Duty] | None] = None
    assumptions: tuple[str, ...] = ("The load of each contact is that of the drive.",)
    warnings: tuple[str, ...] = ()

    @abstractmethod
    def scene(self, phase: float) -> Scene | LineScene:
        """The lubricated contact at a phase of the mesh cycle, 0 to 1.

        A drive whose contacts more than the phase tells apart takes the other names of `Place` that its
        `[operation]` lists (`pyworm.case.case.MESH_PLACES`), too, and names its `sections`.

        Raises
        ------
        ValueError
            There is no contact, or none under load.
        """

    @abstractmethod
    def cycle_data(self) -> xr.Dataset:
        """The unloaded mesh cycle for the result; its attribute `drive` names the kind of drive."""

    def scene_data(self, scene: Scene | LineScene) -> xr.Dataset:
        """What pictures of one scene show beside the solution's own fields; may be empty."""
        return xr.Dataset()

    def normal_load(self, phase: float) -> float:
        """Normal load of the contact at a phase [N], for each length of a line contact [N/m]."""
        return self.scene(phase).load

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss between all teeth, by that of some contacts; None where they do not tell it."""
        return None

    def misalignment(self, contacts: Sequence[Scene | LineScene]) -> Misalignment:
        """What errors of its mounting make of some of its contacts, under the loads that these have."""
        return Misalignment(
            "How misalignment changes the contacts of this drive is not known in closed form."
        )

    def duty(self) -> Duty | None:
        """What the standards see of it, of the type `rated_as`; None where they know no such drive.

        Raises
        ------
        ValueError
            It lies outside their methods, or does not say enough.
        """
        return None
