"""Scuffing of worms and rollers: simulated contact temperatures over the engagement, beside Blok's.

The limit is the oil's scuffing temperature, given or by its load stage in the FZG test of steel gears.
"""

from dataclasses import replace

import numpy as np

from pyworm.case.ratings import ScuffingTable
from pyworm.drives.drive import Drive
from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.formulas.scuffing import flash_temperature
from pyworm.materials.base_stock import Base
from pyworm.materials.body import Body, reduced_modulus
from pyworm.ratings.flank_damage import Limit, Spot, scuffing, scuffing_limit, simulated_spots
from pyworm.ratings.flank_table import ClosedForms, flank_table
from pyworm.ratings.rating import Rating, Safety
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.solution import Solution

NOT_STEEL = (
    "The oil's scuffing temperature is of steel on steel; bronze and iron seize otherwise: X_W or a "
    "temperature of their own tests (scuffing.temperature) decides."
)

MIN_SPEED = 1e-6
"""Least speed of a surface across the contact [m/s], and least relative difference of both."""

MODULUS_OF_STEEL = 195e9
"""Young's modulus above which a body counts as steel [Pa]."""


def rate_scuffing(drive: Drive, table: ScuffingTable, base: Base | None, result: Result) -> Rating:
    """Contact temperatures of all solved contacts, and S_B of the hottest one."""
    heat = drive.oil_supplied.heat
    oil = None if heat is None else heat.inlet_temperature
    limit = _limit(drive, table, base)
    spots = simulated_spots(result.solutions)
    hot = max(spots, key=lambda spot: spot.temperature or 0.0)
    rating = flank_table(
        spots,
        (limit, Limit(None)),
        oil,
        None,
        of_all(result.solutions),
        _closed_forms(drive, result.solutions, spots),
        title="Scuffing at each solved contact",
        source="simulation; Blok 1937, ISO/TS 6336-20",
    )
    return replace(rating, key="scuffing", safeties=(_safety(drive, table, limit, hot, oil),))


def _limit(drive: Drive, table: ScuffingTable, base: Base | None) -> Limit:
    if table.temperature is not None:
        return Limit(table.temperature, by="as given")
    return scuffing_limit(table, drive.oil_supplied, base)


def _safety(
    drive: Drive, table: ScuffingTable, limit: Limit, hot: Spot, oil: float | None
) -> Safety:
    found = scuffing(hot.temperature, oil, limit, table.required_scuffing, hot.name, hot.bars[0])
    steel = all(body.youngs_modulus > MODULUS_OF_STEEL for body in drive.bodies)
    doubts = () if steel or table.temperature is not None else (NOT_STEEL,)
    return replace(found, doubts=doubts)


def _closed_forms(
    drive: Drive, solutions: tuple[Solution, ...], spots: tuple[Spot, ...]
) -> ClosedForms | None:
    """Blok's flash temperatures over friction at the solved phases; None where one is not known."""
    if any(spot.phase is None for spot in spots) or None in (
        body.specific_heat for body in drive.bodies
    ):
        return None
    scenes = [drive.scene(**ContactIndex.of(solution).given) for solution in solutions]
    phases = np.array([solution.phase for solution in solutions], dtype=float)
    order = np.argsort(phases)
    flash = np.array([flash_over_friction(scene) for scene in scenes])[order]
    bulk = float(np.mean([body.bulk_temperature for scene in scenes for body in scene.bodies]))
    return ClosedForms(phases[order], None, None, flash, bulk)


def flash_over_friction(scene: Scene | LineScene) -> float:
    """Blok's flash temperature over the coefficient of friction [K] of Hertz's contact, at its middle.

    Bodies carry heat away by their velocities across the contact's short axis; the sliding heats in all
    directions.
    """
    modulus = reduced_modulus(*scene.bodies)
    if isinstance(scene, LineScene):
        load, half_width, short = (
            scene.load,
            hertz_line(scene.radius, scene.load, modulus).half_width,
            0,
        )
    else:
        contact = hertz(*scene.radii, scene.load, modulus)
        axes = contact.semi_axis_x, contact.semi_axis_y
        short = int(axes[1] < axes[0])
        half_width = axes[short]
        load = np.pi / 2 * contact.pressure_max * half_width
    middle = np.zeros(1)
    places = (middle,) if isinstance(scene, LineScene) else (middle, middle)
    bodies = [np.array([float(part[0]) for part in body]) for body in scene.velocities_at(*places)]
    across = [max(abs(float(body[short])), MIN_SPEED) for body in bodies]
    if across[0] == across[1]:
        across[1] *= 1 - MIN_SPEED
    drains = [_effusivity(body) for body in scene.bodies]
    flash = flash_temperature(1.0, load, across[0], across[1], drains[0], drains[1], half_width)
    # that formula takes the sliding as the difference of both speeds
    return float(flash / abs(across[0] - across[1]) * np.linalg.norm(bodies[0] - bodies[1]))


def _effusivity(body: Body) -> float:
    return float(np.sqrt(body.thermal_inertia))
