"""`[cooling]`: the thermal balance of a worm drive."""

from pyworm.case.table import Table
from pyworm.drives.worm.loads.temperatures import Housing
from pyworm.formulas.worm_losses import Bearings
from pyworm.io import units


class CoolingTable(Table, Housing):
    """`[cooling]`: data of the thermal balance that finds the temperatures of oil and bodies.

    `conductance` is the heat that the housing gives to its surroundings for each kelvin of the oil above
    them, `other_loss` that of bearings, seals and churning, `immersion` the standards' c_k of the wheel.
    Left out, `other_loss` is that of the worm standard, for `bearings` of the worm. `worm_excess` is the
    excess of the worm's bulk temperature over the wheel's. `tooth_loss` is the loss between the teeth for
    which all this is struck; left out, it is found.
    """

    other_loss: units.PowerOrZero | None = None
    bearings: Bearings = "adjusted"
    tooth_loss: units.Power | None = None
