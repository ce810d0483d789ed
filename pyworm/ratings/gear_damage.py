"""Scuffing and micropitting of a pair of gears by ISO/TS 6336-20 and -22, closed forms and simulated."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.case.ratings import GearRatingTable
from pyworm.case.worm_conditions import MEAN_TO_RMS
from pyworm.drives.duty import GearPairDuty
from pyworm.formulas.micropitting import Flanks, MicropittingFilms, micropitting_films
from pyworm.formulas.scuffing import scuffing_temperature
from pyworm.materials.base_stock import Base
from pyworm.ratings.flank_damage import (
    Limit,
    film_limit,
    gear_oil,
    micropitting,
    scuffing,
    scuffing_limit,
    simulated_safeties,
    simulated_spots,
)
from pyworm.ratings.flank_table import ClosedForms, flank_table
from pyworm.ratings.rating import Rating, Safety
from pyworm.result.headline import of_all
from pyworm.result.result import Result


def mean_scuffing_temperature(duty: GearPairDuty, table: GearRatingTable) -> float | None:
    """Mean scuffing temperature [K]: the case's own, or by the oil's viscosity."""
    if duty.scuffing_temperature is not None or table.viscosity_40 is None:
        return duty.scuffing_temperature
    return float(scuffing_temperature(table.viscosity_40, table.anti_scuff))


def _worst(
    values: np.ndarray | None, phases: np.ndarray, find: Callable[[np.ndarray], np.intp]
) -> tuple[float | None, str]:
    """The worst of values along the line of action, and its phase in words; None, "" without values."""
    if values is None:
        return None, ""
    place = find(values)
    return float(values[place]), f"phase {phases[place]:.3g}"


@dataclass(frozen=True)
class GearDamage:
    """A pair of gears and what its oil bears."""

    duty: GearPairDuty
    """The gears."""
    table: GearRatingTable
    """Tests of the oil, and safeties required."""
    base: Base | None
    """Base stock of the oil."""

    @cached_property
    def limits(self) -> tuple[Limit, Limit]:
        """Scuffing temperature, by load stage or else the mean of AGMA 925, and permissible specific film."""
        of_stage = scuffing_limit(self.table, self.duty.oil, self.base)
        mean = mean_scuffing_temperature(self.duty, self.table)
        if of_stage.value is None and mean is not None:
            given = self.duty.scuffing_temperature is not None
            of_stage = Limit(mean, by="as given" if given else "mean of AGMA 925 by viscosity")
        return of_stage, film_limit(self.table, self.duty.oil, self.base)

    @property
    def oil_temperature(self) -> float | None:
        """Of the oil before the mesh [K]."""
        heat = self.duty.oil.heat
        return None if heat is None else heat.inlet_temperature

    @property
    def roughness(self) -> float | None:
        """Ra, mean of both flanks [m]."""
        rough = self.duty.roughness
        return None if rough is None else MEAN_TO_RMS * float(np.mean(rough))

    @cached_property
    def _films(self) -> MicropittingFilms | None:
        """Films of the standard along the line of action; None where data are missing."""
        duty, line = self.duty, self.duty.line_of_action
        base, roughness, bulk = self.base, self.roughness, duty.bulk_temperature
        if base is None or duty.effusivities is None or bulk is None or roughness is None:
            return None
        if self.oil_temperature is None:
            return None
        flanks = Flanks(
            line.radius,
            line.unit_load,
            line.pinion_velocity,
            line.gear_velocity,
            duty.reduced_modulus,
            duty.effusivities,
            roughness,
        )
        oil = gear_oil(duty.oil, base)
        return micropitting_films(flanks, oil, self.oil_temperature, bulk)

    def safeties(self, result: Result | None) -> tuple[Safety, ...]:
        """S_B and S_lambda at the worst place, by the standards and, with a converged result, simulated."""
        line, films = self.duty.line_of_action, self._films
        hottest, hot = _worst(line.contact_temperature, line.phase, np.argmax)
        thinnest, thin = _worst(None if films is None else films.film, line.phase, np.argmin)
        safeties = (
            scuffing(
                hottest, self.oil_temperature, self.limits[0], self.table.required_scuffing, hot
            ),
            micropitting(
                thinnest, self.roughness, self.limits[1], self.table.required_micropitting, thin
            ),
        )
        if result is None:
            return safeties
        spots = simulated_spots(result.solutions)
        return safeties + simulated_safeties(
            spots, self.limits, self.table, self.oil_temperature, self.roughness
        )

    def at_each(self, result: Result) -> Rating:
        """Closed forms and simulation at every solved contact."""
        line, duty, films = self.duty.line_of_action, self.duty, self._films
        flash = line.flash_temperature
        closed = ClosedForms(
            line.phase,
            line.contact_temperature,
            None if films is None else films.film,
            None if flash is None else flash / duty.friction,
            duty.bulk_temperature,
        )
        return flank_table(
            simulated_spots(result.solutions),
            self.limits,
            self.oil_temperature,
            self.roughness,
            of_all(result.solutions),
            closed,
        )
