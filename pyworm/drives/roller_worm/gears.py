"""Worm and rollers as cut and assembled: the sections of the worm, whose flanks the rollers envelop.

Rollers stand round a wheel and turn freely on their own axes; the thread of the worm is their envelope. A
divided worm has two sections parted at the throat. Rollers travel through the right section from its outer
end to the throat, touched from the front by its flank, which idles and takes up the backlash; then through
the left section from the throat to its outer end, pushed from behind: that one drives. A worm of a double
row of rollers is not parted: "left" are the rollers of the driving row along the whole worm, "right" those of
the idling row, which is turned against the other until the backlash is gone.

The worm is an hourglass between rollers on a rim, and a barrel within rollers on the inside of a ring.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, hypot, sin, sqrt
from typing import Literal, Self

from pyworm.drives.roller_worm.design import Rollers, RollerWorm
from pyworm.drives.roller_worm.envelope import Flank, RollerEnvelope
from pyworm.drives.roller_worm.section import WormSection

RIGHT_ANGLE = 1e-9
"""Cosine of a tilt that counts as a right angle [-]; that of 90 deg is 6e-17."""

SectionName = Literal["right", "left"]
"""Sections of the worm, in the order in which rollers pass them where the left one drives."""


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

    @property
    def pitch_radius(self) -> float:
        """Radius of the rollers' middles about the wheel's axis [m]: as far from the worm's as the throat.

        They lie between the axes, but beyond the worm's where the rollers point to the wheel's axis.
        """
        across = sqrt(max(self.throat_radius**2 - self.rollers.height**2, 0.0))
        return self.centre_distance - (across if cos(self.rollers.tilt) > -RIGHT_ANGLE else -across)

    def axis_distance(self, place: float) -> float:
        """Distance from the worm's axis of a place along a roller's axis at the throat [m]."""
        tilt, across = self.rollers.tilt, self.centre_distance - self.pitch_radius
        return hypot(across - place * cos(tilt), self.rollers.height + place * sin(tilt))

    @property
    def towards(self) -> float:
        """Place along a roller's axis, from its middle, that is nearest the worm's axis at the throat [m]."""
        tilt, across = self.rollers.tilt, self.centre_distance - self.pitch_radius
        return across * cos(tilt) - self.rollers.height * sin(tilt)

    @cached_property
    def sections(self) -> dict[str, WormSection]:
        """The worm's sections by name, in the order of the rollers' travel."""
        worm, rollers = self.worm, self.rollers

        def section(
            name: str, flank: Flank, first: float, last: float, row: int = 1
        ) -> WormSection:
            envelope = RollerEnvelope(
                profile=rollers.profile,
                ratio=self.ratio,
                centre_distance=self.centre_distance,
                pitch_radius=self.pitch_radius,
                tilt=row * rollers.tilt,
                height=row * rollers.height,
                flank=flank,
                hand=worm.turn,
            )
            bearing = -worm.addendum, worm.dedendum
            return WormSection(name, envelope, first, last, *bearing, rollers.count)

        if worm.arrangement == "double":
            ends = -worm.outer_angle, worm.outer_angle
            return {
                "right": section("right", "idle", *ends, row=-1),
                "left": section("left", "driving", *ends),
            }
        return {
            "right": section("right", "idle", -worm.outer_angle, -worm.throat_angle),
            "left": section("left", "driving", worm.throat_angle, worm.outer_angle),
        }

    @property
    def rows(self) -> tuple[WormSection, ...]:
        """A section for each row of rollers: one of a divided worm, both of a double row."""
        sections = tuple(self.sections.values())
        return sections if self.worm.arrangement == "double" else sections[:1]

    def varied(self, name: str, value: float) -> Self:
        """Gears or drive of another "roller_radius" [m], "throat_coefficient" [-] or "tilt" [rad].

        ValueError from a drive if the flank is undercut, or the rollers leave no thread between them.
        """
        if name == "throat_coefficient":
            worm, rollers = replace(self.worm, throat_coefficient=value), self.rollers
            if (
                self.pitch_radius == self.centre_distance
            ):  # on a disc the rollers stay on the throat
                height = rollers.height * value / self.worm.throat_coefficient
                rollers = replace(rollers, height=height)
            return replace(self, worm=worm, rollers=rollers)
        if name == "tilt":
            return replace(self, rollers=replace(self.rollers, tilt=value))
        profile = replace(self.rollers.profile, radius=value)
        return replace(self, rollers=replace(self.rollers, profile=profile))
