"""`[cooling]` of a worm drive."""

from collections.abc import Iterator

from pyworm.case.cooling import HousingTable, MeasuredPointTable, second_conductance
from pyworm.case.table import Table
from pyworm.drives.worm.loads.temperatures import WormSurroundings
from pyworm.formulas.worm_losses import Bearings
from pyworm.io import units


class WormCoolingTable(Table, WormSurroundings):
    """`[cooling]`: data of the thermal balance that finds the temperatures of oil and bodies.

    Keys are those of `CoolingTable`. Left out, `other_loss` is that of the worm standard, for `bearings` of
    the worm; `immersion` is the standards' c_k of the wheel. `worm_excess` is the excess of the worm's bulk
    temperature over the wheel's.
    """

    housing: HousingTable | None = None
    measured: MeasuredPointTable | None = None
    other_loss: units.PowerOrZero | None = None
    bearings: Bearings = "adjusted"
    tooth_loss: units.Power | None = None

    def flaws(self) -> Iterator[str]:
        """As of `CoolingTable`, or an excess of the worm that the network finds."""
        yield from second_conductance(self)
        if self.housing is not None and self.worm_excess:
            yield "worm_excess has no effect with housing, whose thermal network finds the worm's temperature"
