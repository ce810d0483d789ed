"""What every drive gives: scenes, and what its pictures show beside their solutions."""

from typing import Protocol

import xarray as xr

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


class Drive(Protocol):
    """A machine that makes contacts. It never solves them.

    Attributes
    ----------
    warnings : tuple of str
        What is unusual in it and changes its contacts, a sentence each, beginning with a key of `[drive]`.
    """

    warnings: tuple[str, ...]

    def scene(self, phase: float) -> Scene | LineScene:
        """The lubricated contact at a phase of the mesh cycle, 0 to 1.

        A drive whose contacts more than the phase tells apart takes the other names of `Place` that its
        `[operation]` lists (`pyworm.case.case.MESH_PLACES`), too, and names its `sections`.
        """

    def cycle_data(self) -> xr.Dataset:
        """The unloaded mesh cycle for the result; its attribute `drive` names the kind of drive."""

    def scene_data(self, scene: Scene | LineScene) -> xr.Dataset:
        """What pictures of one scene show beside the solution's own fields; may be empty."""
