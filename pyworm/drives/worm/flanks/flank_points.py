"""Flanks of any profile as points (`fortran/flanks/flank_points.f90`)."""

from dataclasses import dataclass
from functools import cached_property

from pyworm.drives.worm.flanks.flank_surface import FlankSurface
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import SweptWheel
from pyworm.kernel.flank_height import FlankKind, FlankNumbers


@dataclass(frozen=True)
class WormPoints(FlankSurface):
    """The worm's flank; the parameters are u and the turn of its curve."""

    worm: SweptHelicoid
    """The worm."""
    angle: float
    """Its rotation angle [rad]."""

    @cached_property
    def numbers(self) -> FlankNumbers:
        """Those of the worm."""
        worm = self.worm
        form = worm.screw, worm.size
        seat, curve = worm.seat(self.angle), worm.generator.swept
        return FlankNumbers(FlankKind.WORM_POINTS, 2, seat, form, curve, worm.bounds)


@dataclass(frozen=True)
class WheelPoints(FlankSurface):
    """The wheel's flank; the parameters are u and turn of the hob's curve and the lag, roll - angle."""

    flank: SweptWheel
    """The wheel flank."""
    angle: float
    """Its rotation angle [rad]."""

    @cached_property
    def numbers(self) -> FlankNumbers:
        """Those of the hob, and the ratio."""
        hob = self.flank.hob
        form = hob.screw, hob.size, self.flank.ratio
        seat, curve = hob.seat(self.angle), hob.generator.swept
        return FlankNumbers(FlankKind.WHEEL_POINTS, 3, seat, form, curve, hob.bounds)
