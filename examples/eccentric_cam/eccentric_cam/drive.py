"""An eccentric cam against a flat tappet."""

from dataclasses import dataclass
from math import cos, pi

import numpy as np
import xarray as xr

from pyworm.drives.drive import Drive
from pyworm.drives.tooth_life import ToothLife
from pyworm.io import units
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.scene.point import Paraboloid, RigidMotion, Scene


@dataclass(frozen=True)
class Cam:
    """A crowned circular cam that turns about a point off its middle."""

    radius: units.Length
    """Its radius [m]."""
    crown: units.Radius
    """Radius of its crown across [m]."""
    eccentricity: units.Length
    """Distance of its middle from its axis [m]."""


@dataclass(frozen=True)
class EccentricCam(Drive):
    """A cam against a flat tappet."""

    body_names = "cam", "tappet"
    assumptions = ("The tappet presses with the same force all the time and does not turn.",)

    cam: Cam
    """The cam."""
    speed: float
    """Speed of its rotation [rad/s]."""
    load: float
    """Force of the tappet on the cam [N]."""
    bodies: tuple[Body, Body]
    """Cam and tappet."""
    oil: Oil
    """The oil."""

    def __post_init__(self) -> None:
        cam = self.cam
        if not cam.eccentricity < cam.radius:
            raise ValueError(
                f"eccentricity is {cam.eccentricity * 1e3:.4g} mm; it must be below drive.radius, "
                f"{cam.radius * 1e3:.4g} mm, for the cam to turn about a point in it"
            )

    def scene(self, phase: float) -> Scene:
        """The contact at a phase of one turn, 0 at the largest lift."""
        return ToothLife(self._contact, self.speed / (2 * pi)).at(phase)

    def _contact(self, phase: float) -> Scene:
        tappet = -self.cam.eccentricity * self.speed * cos(2 * pi * phase)
        return Scene(
            name=f"phase {phase:.3g}",
            gap=Paraboloid(self.cam.radius, self.cam.crown),
            radii=(self.cam.radius, self.cam.crown),
            motions=(RigidMotion(self.speed * self.cam.radius, 0.0), RigidMotion(tappet, 0.0)),
            load=self.load,
            bodies=self.bodies,
            oil=self.oil,
            phase=phase,
        )

    def cycle_data(self) -> xr.Dataset:
        """Entrainment over a turn."""
        phase = np.linspace(0, 1, 101)
        arm = self.cam.radius - self.cam.eccentricity * np.cos(2 * np.pi * phase)
        about = {"units": "m/s", "long_name": "entrainment"}
        return xr.Dataset(
            {"entrainment": ("phase", self.speed * arm / 2, about)},
            coords={"phase": phase},
            attrs={"drive": "eccentric-cam"},
        )
