"""A worm gear rated by the standards under each load of its life."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from pyworm.case.ratings import CompletedRating
from pyworm.case.worm_conditions import conditions, standard_oil, sump_by_standard
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unknown import Unknown
from pyworm.formulas.worm_rating import WormConditions, WormRating
from pyworm.materials.library import NamedOil

HOUR = 3600.0
"""[s]."""


@dataclass(frozen=True)
class RatedLoad:
    """A load of a worm gear's life and what the standards make of it."""

    torque: float
    """T2 with its application factor [N m]."""
    worm_speed: float
    """Speed of the worm [rad/s]."""
    hours: float | Unknown
    """How long it lasts [h]."""
    conditions: WormConditions
    """What it is rated for."""
    rated: WormRating
    """Its figures."""

    @property
    def sump(self) -> float | Unknown:
        """Temperature of the oil in the sump, or injected [K]."""
        return self.conditions.sump_temperature


@dataclass(frozen=True)
class RatedWormGear:
    """A worm gear by the standards under the loads of its life."""

    table: CompletedRating
    """What it is rated for, `[worm_rating]`."""
    duty: WormDuty
    """Worm and wheel at the drive's operating point."""
    directory: Path
    """Where the case lies, from which files of oils are named."""

    @cached_property
    def oil(self) -> NamedOil | Unknown:
        """Its oil, if the standards have constants for it; CaseError for an unknown name."""
        return standard_oil(self.table, self.directory)

    @cached_property
    def loads(self) -> tuple[RatedLoad, ...]:
        """Its load spectrum, or the drive's load in the life that is given."""
        table, duty = self.table, self.duty
        steps: list[tuple[float, float, float | Unknown]]
        if table.spectrum:
            steps = [
                (step.wheel_torque, step.worm_speed, step.duration / HOUR)
                for step in table.spectrum
            ]
        else:
            life: float | Unknown = Unknown("worm_rating.life is missing")
            if table.life is not None:
                life = table.life / HOUR
            steps = [(duty.torque, duty.worm_speed, life)]
        loads = []
        for torque, speed, hours in steps:
            under = conditions(table, duty, self.oil, torque, speed, hours)
            loads.append(RatedLoad(under.torque, speed, hours, under, WormRating(duty.gear, under)))
        return tuple(loads)

    @property
    def hardest(self) -> RatedLoad:
        """The load with the largest torque."""
        return max(self.loads, key=lambda load: load.torque)

    @property
    def total_wear(self) -> float:
        """Depth worn off the flanks under all loads [m]; ValueError where it is not rated."""
        return sum(load.rated.wear.depth for load in self.loads)

    def standard_sump(self, load: RatedLoad, fan: bool) -> float:
        """The standard's temperature of the sump under a load [K]; ValueError outside its range."""
        torque = load.torque / self.table.application_factor
        return sump_by_standard(self.table, self.duty, self.oil, torque, load.worm_speed, fan)
