"""Cases of gear sets whose losses warm them, but for worms, whose standard has more."""

from collections.abc import Iterator
from dataclasses import replace
from typing import ClassVar

from pyworm.case.bodies import Bodies
from pyworm.case.cooling import CoolingTable
from pyworm.case.oil import OilTable
from pyworm.case.ratings import RatedCase
from pyworm.case.table import plain
from pyworm.drives.cooling import Cooling, DriveTemperatures, Surroundings
from pyworm.drives.drive import Drive
from pyworm.drives.gear_unit import GearUnit
from pyworm.drives.oil_supply import Bath
from pyworm.drives.other_losses import NonMeshLosses
from pyworm.drives.rotor import Rotor
from pyworm.io.present import present

USUAL_DIP = 0.15
"""Depth to which the larger gear body dips into oil over its diameter, where no bath gives it [-]."""


def given_temperatures(oil: OilTable, bodies: Bodies) -> Iterator[str]:
    """Sentences on cooling of an oil without heat, and of bodies whose temperature is given."""
    if oil.heat is None:
        yield "[cooling] asks for [oil.heat]"
    for name, body in bodies:
        if body.bulk_temperature is not None:
            yield f"bodies.{name}.bulk_temperature has no effect with [cooling]"


class CooledCase(RatedCase):
    """A case file with `[cooling]` that holds for any gear set."""

    first_loss: ClassVar[float] = 0.01
    """Fraction of the power that is lost between the teeth before it is known."""
    bodies: Bodies
    cooling: CoolingTable | None = None

    def flaws(self) -> Iterator[str]:
        """Cooling of what does not warm."""
        yield from super().flaws()
        if self.cooling is not None:
            yield from given_temperatures(self.oil, self.bodies)

    @property
    def left_open(self) -> dict[str, tuple[str, ...]]:
        """The loss that warms the drive."""
        if self.cooling is None or self.cooling.tooth_loss is not None:
            return {}
        return {"cooling": ("tooth_loss",)}

    def unit_of(self, drive: Drive, tooth_loss: float | None = None) -> GearUnit:
        """The thermal network of the drive for a loss between its teeth [W], by default that assumed."""
        table, rotors = present(self.cooling, "cooling"), present(drive.rotors, "rotors")
        other = NonMeshLosses(given=table.other_loss or 0.0)
        cooling = Cooling(other=other, **vars(plain(table, Surroundings)))
        loss = table.tooth_loss if tooth_loss is None else tooth_loss
        if loss is None:
            loss = self.first_loss * rotors[0].torque * rotors[0].speed
        if table.other_loss is not None:
            return GearUnit(rotors, drive.oil, cooling, loss)
        unit = GearUnit(rotors, drive.oil, cooling, loss, dips=self._dips(drive, rotors))
        balanced = unit.other_at(unit.temperatures.sump)
        return replace(unit, cooling=replace(cooling, other=NonMeshLosses(standard=balanced)))

    def _dips(self, drive: Drive, rotors: tuple[Rotor, Rotor]) -> tuple[float, float]:
        """How deep both gear bodies dip into the oil [m]: that of a bath, else usual for the larger one."""
        bath, depths = self.brought_by, [0.0, 0.0]
        if isinstance(bath, Bath):
            depths[drive.body_names.index(bath.body)] = bath.depth
        elif bath is None:
            larger = int(rotors[1].diameter >= rotors[0].diameter)
            depths[larger] = USUAL_DIP * rotors[larger].diameter
        return depths[0], depths[1]

    def temperatures_of(self, drive: Drive) -> DriveTemperatures | None:
        """Temperatures of oil and bodies by the losses of the drive; None without `[cooling]`."""
        return None if self.cooling is None else self.unit_of(drive).temperatures
