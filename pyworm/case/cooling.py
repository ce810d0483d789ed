"""`[cooling]`: the thermal balance of a gear unit."""

from collections.abc import Iterator

from pyworm.case.table import Table
from pyworm.drives.cooling import HousingSizes, MeasuredPoint, Surroundings
from pyworm.io import units


class HousingTable(Table, HousingSizes):
    """`[cooling.housing]`: sizes of a box-shaped housing, whose conductance follows."""


class MeasuredPointTable(Table, MeasuredPoint):
    """`[cooling.measured]`: a steady sump temperature at a known loss, to which a housing is fitted."""


class CoolingTable(Table, Surroundings):
    """`[cooling]` of a gear pair or a roller worm: data of the thermal balance of oil and bodies.

    `conductance` is the heat that the housing gives to its surroundings for each kelvin of the oil above
    them; `housing` has its sizes instead. `other_loss` is that of bearings, seals and churning; left out, it
    follows from closed forms. `tooth_loss`
    is the loss between the teeth for which all this is struck; left out, it is found.
    """

    housing: HousingTable | None = None
    measured: MeasuredPointTable | None = None
    other_loss: units.PowerOrZero | None = None
    tooth_loss: units.Power | None = None

    def flaws(self) -> Iterator[str]:
        """Two conductances or none, or a measured point of a given one."""
        yield from second_conductance(self)


def second_conductance(table: Table) -> Iterator[str]:
    """Sentences on two conductances of a housing or none, and on a measured point of a given one."""
    yield from table.unless_either("conductance", "housing")
    if table.given("measured") and not table.given("housing"):
        yield "measured has no effect with conductance; give housing, whose conductance it fits"
