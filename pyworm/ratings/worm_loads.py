"""A worm gear rated by the standards under each load of its life."""

from dataclasses import dataclass
from pathlib import Path

from pyworm.case.ratings import CompletedRating
from pyworm.case.worm_conditions import conditions, standard_oil
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unknown import Unknown
from pyworm.formulas.worm_rating import WormConditions, WormRating

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


def rated_loads(table: CompletedRating, duty: WormDuty, directory: Path) -> tuple[RatedLoad, ...]:
    """The worm gear under its load spectrum or the drive's load; CaseError for an unknown oil."""
    oil = standard_oil(table, directory)
    steps: list[tuple[float, float, float | Unknown]]
    if table.spectrum:
        steps = [
            (step.wheel_torque, step.worm_speed, step.duration / HOUR) for step in table.spectrum
        ]
    else:
        life = Unknown("worm_rating.life is missing") if table.life is None else table.life / HOUR
        steps = [(duty.torque, duty.worm_speed, life)]
    loads = []
    for torque, speed, hours in steps:
        under = conditions(table, duty, oil, torque, speed, hours)
        loads.append(RatedLoad(under.torque, speed, hours, under, WormRating(duty.gear, under)))
    return tuple(loads)


def hardest(loads: tuple[RatedLoad, ...]) -> RatedLoad:
    """The load with the largest torque."""
    return max(loads, key=lambda load: load.torque)
