"""Roughness of a surface as one value: height, slope, lay and asperities."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pyworm.formulas.ranges import positive
from pyworm.io import units
from pyworm.io.given import WithUnit, take
from pyworm.io.shown import ShownFields

RUN_IN_SLOPE = 0.008
"""Root mean square slope of a run-in surface, where none is given: with it the asperities' share of the
load is that of the field's measured and computed partial films (`docs/theory/roughness.md`)."""


ASPERITY_DENSITY = 0.04
"""Asperities for each area times their radius times the roughness, where none is given: 0.03 to 0.05 of most
surfaces (Greenwood and Tripp 1970)."""


@dataclass(frozen=True, repr=False)
class Roughness(ShownFields):
    """Averages of a rough surface, `Body(..., roughness=Roughness("0.4 um", slope=0.05))`.

    A body holds them as its own attributes (`roughness`, `roughness_slope`, ...).

    Raises:
        ValueError: Values that no surface has.
    """

    rms: units.Roughness
    """Root mean square height Rq [m]; about 1.25 Ra where heights are spread normally."""
    slope: float = RUN_IN_SLOPE
    """Root mean square slope [-]."""
    aspect: float = 1.0
    """Correlation length along its lay over that across it [-]; 1 where it has no lay."""
    lay: units.Tilt = 0.0
    """Angle of the lay from the surface's own motion through the contact [rad]."""
    sharpness: float | None = None
    """Composite roughness over the radius of the asperities' tips [-], all alike; None of a surface that is
    rough on all scales."""
    density: float = ASPERITY_DENSITY
    """Such asperities for each area times radius times composite roughness [-]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, rms: WithUnit, slope: float = ..., aspect: float = ..., lay: WithUnit = ...,
            sharpness: float | None = ..., density: float = ...
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Read quantities with units; refuse values that no surface has."""
        take(self)
        positive("rms", self.rms, "m")
        positive("slope, aspect, density", (self.slope, self.aspect, self.density), "")

    @property
    def of_body(self) -> dict[str, float | None]:
        """Its values under the names of a `Body`."""
        return {
            "roughness": self.rms,
            "roughness_slope": self.slope,
            "roughness_aspect": self.aspect,
            "lay": self.lay,
            "asperity_sharpness": self.sharpness,
            "asperity_density": self.density,
        }
