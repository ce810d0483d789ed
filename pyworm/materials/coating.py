"""An elastic layer on the surface of a body."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from pyworm.formulas.ranges import positive, scalar
from pyworm.io import units
from pyworm.io.given import WithUnit, take
from pyworm.io.shown import ShownFields


@dataclass(frozen=True, repr=False)
class Coating(ShownFields):
    """A coating, bonded to the body below it.

    Raises:
        ValueError: A thickness or a constant that no layer has.
    """

    thickness: units.CoatingThickness
    """Thickness [m]."""
    youngs_modulus: units.Modulus
    """Young's modulus [Pa]."""
    poisson_ratio: float
    """Poisson's ratio [-]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, thickness: WithUnit, youngs_modulus: WithUnit, poisson_ratio: float
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Read quantities with units; refuse an impossible layer."""
        take(self)
        positive("thickness", self.thickness, "m")
        positive("youngs_modulus", self.youngs_modulus, "Pa")
        if not -1 < scalar("poisson_ratio", self.poisson_ratio) < 0.5:
            raise ValueError(
                f"poisson_ratio = {self.poisson_ratio:g}: must lie above -1 and below 0.5, such as 0.2"
            )
