"""Flanks of involute helicoids as families of tangent planes (`fortran/flanks/tangent_planes.f90`)."""

from dataclasses import dataclass
from functools import cached_property

from pyworm.drives.worm.flanks.flank_surface import FlankSurface
from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.flanks.wheel_envelope import WheelFlank
from pyworm.kernel.flank_height import FlankKind, FlankNumbers


@dataclass(frozen=True)
class WormPlanes(FlankSurface):
    """Tangent planes of the worm flank; the parameter is theta."""

    worm: Helicoid
    """The worm."""
    angle: float
    """Its rotation angle [rad]."""

    @cached_property
    def numbers(self) -> FlankNumbers:
        """Those of the worm."""
        worm = self.worm
        form = worm.base_lead_angle, worm.base_travel
        return FlankNumbers(FlankKind.WORM_PLANES, 1, worm.seat(self.angle), form)


@dataclass(frozen=True)
class WheelPlanes(FlankSurface):
    """Tangent planes of the wheel flank; the parameters are the hob's theta and the lag, roll - angle."""

    flank: WheelFlank
    """The wheel flank."""
    angle: float
    """Its rotation angle [rad]."""

    @cached_property
    def numbers(self) -> FlankNumbers:
        """Those of the hob, and the lever."""
        hob = self.flank.hob
        form = hob.base_lead_angle, hob.base_travel, self.flank.lever
        return FlankNumbers(FlankKind.WHEEL_PLANES, 2, hob.seat(self.angle), form)
