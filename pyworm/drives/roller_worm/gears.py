"""Worm and rollers as cut and assembled: the sections of the worm, whose flanks the rollers envelop.

Rollers stand round a wheel and turn freely on their own axes; the worm is an hourglass in two sections
parted at the throat, its thread the envelope of the rollers. Rollers travel through the right section from
its outer end to the throat, touched from the front by its flank, which idles and takes up the backlash; then
through the left section from the throat to its outer end, pushed from behind: that one drives.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

from pyworm.drives.roller_worm.design import Rollers, RollerWorm
from pyworm.drives.roller_worm.envelope import Flank, RollerEnvelope
from pyworm.drives.roller_worm.section import WormSection


@dataclass(frozen=True)
class RollerGears:
    """A roller enveloping worm and its wheel of rollers."""

    worm: RollerWorm
    """Design table of the worm."""
    rollers: Rollers
    """Design table of the rollers."""
    centre_distance: float
    """Distance of worm and wheel axes [m]."""

    @property
    def ratio(self) -> float:
        """i, rollers over threads [-]."""
        return self.rollers.count / self.worm.threads

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
                hand=worm.turn,
            )
            bearing = -worm.addendum, worm.dedendum
            return WormSection(name, envelope, first, last, *bearing, rollers.count)

        return {
            "right": section("right", "idle", -worm.outer_angle, -worm.throat_angle),
            "left": section("left", "driving", worm.throat_angle, worm.outer_angle),
        }

    def varied(self, name: str, value: float) -> Self:
        """Gears or drive of another "roller_radius" [m], "throat_coefficient" [-] or "tilt" [rad].

        ValueError from a drive if the flank is undercut, or the rollers leave no thread between them.
        """
        if name == "throat_coefficient":
            return replace(self, worm=replace(self.worm, throat_coefficient=value))
        if name == "tilt":
            return replace(self, rollers=replace(self.rollers, tilt=value))
        profile = replace(self.rollers.profile, radius=value)
        return replace(self, rollers=replace(self.rollers, profile=profile))
