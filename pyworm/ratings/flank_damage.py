"""Scuffing and micropitting: what an oil bears, and what flanks of simulated films and friction come to."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm.case.ratings import DamageLimits, ScuffingTable
from pyworm.formulas.fzg_test_gears import film_at_load_stage
from pyworm.formulas.micropitting import (
    FRICTION_FACTORS,
    GearOil,
    micropitting_safety,
    permissible_specific_film,
)
from pyworm.formulas.scuffing import scuffing_safety, scuffing_temperature_of_stage
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.present import present
from pyworm.materials.oil import Oil
from pyworm.ratings.rating import Safety, Value
from pyworm.scene.index import ContactIndex
from pyworm.solver.solution import Estimate, Solution

CLAUSES = {"S_B": "ISO/TR 13989-1, eq. 100", "S_lambda": "ISO/TR 15144-1, eq. 4"}
"""Symbol of a safety -> where the former edition of its standard has it, by a public program."""

BASIS = (
    "Scuffing: ISO/TS 6336-20:2017, micropitting: ISO/TS 6336-22:2018. Neither text was read: formulas were "
    "held against a public program that gives the equation numbers of their former editions, ISO/TR 13989-1 "
    "and 15144-1 (mekanika.org); X_W, W_W and the factor 1.4 are remembered.",
)
"""Standards of both safeties, and what of them was not read."""

LEAST_SHARE = 0.05
"""Fraction of the load carried by asperities from which a gap between rough flanks is no longer the film that
smooth ones would have, of which limits of specific films are."""


@dataclass(frozen=True)
class Limit:
    """What an oil bears."""

    value: float | None
    """Scuffing temperature [K], or permissible specific film [-]; None where it is not known."""
    why: str = ""
    """Why it is not; empty where it is."""
    by: str = ""
    """What it follows from."""


@dataclass(frozen=True)
class Spot:
    """A simulated contact as scuffing and micropitting see it."""

    name: str
    """Where it is."""
    temperature: float | None
    """Largest of both flanks [K]; None where heat was not simulated."""
    film: float
    """Least film [m]."""
    bars: tuple[tuple[float, float | None], tuple[float, float | None]]
    """Numerical and model bars, relative: of the rise over the oil, and of the film."""
    friction: float | None = None
    """Simulated coefficient of friction [-]; None without."""
    asperities: float = 0.0
    """Fraction of the load that asperities carry [-]; 0 where roughness was not simulated."""
    phase: float | None = None
    """Place in the mesh; None where the case has none."""


def gear_oil(oil: Oil, base: str) -> GearOil:
    """The oil of contacts, by its own laws, for ISO/TS 6336-22; it has heat."""
    inlet = present(oil.heat, "oil.heat").inlet_temperature

    def law(name: str) -> Callable[[np.ndarray], np.ndarray]:
        def of(temperature: np.ndarray) -> np.ndarray:
            return np.vectorize(lambda kelvin: getattr(oil.warmed(kelvin - inlet).viscosity, name))(
                temperature
            )

        return of

    return GearOil(law("eta0"), law("alpha"), FRICTION_FACTORS[base])


def scuffing_limit(table: DamageLimits | ScuffingTable, oil: Oil, base: str | None) -> Limit:
    """The oil's scuffing temperature by its load stage in the FZG test and its viscosity as it is fed [K]."""
    if table.scuffing_load_stage is None:
        return Limit(None, "scuffing_load_stage of the oil (FZG A/8.3/90) is missing")
    if base is None:
        return Limit(None, "base of the oil is missing")
    factor, structure = FRICTION_FACTORS[base], table.scuffing_structure_factor
    stage, viscosity = table.scuffing_load_stage, oil.viscosity.eta0
    kelvin = scuffing_temperature_of_stage(stage, viscosity, factor, structure)
    by = f"load stage {stage}, X_L {factor:g} x {1e3 * viscosity:.3g}^-0.05, X_W {structure:g}"
    return Limit(kelvin, by=by)


def film_limit(table: DamageLimits, oil: Oil, base: str | None) -> Limit:
    """The permissible specific film: given, or by the oil's load stage in the micropitting test [-]."""
    if table.permissible_specific_film is not None:
        return Limit(table.permissible_specific_film, by="given")
    if table.micropitting_load_stage is None:
        return Limit(
            None,
            "micropitting_load_stage of the oil (FVA 54/7) and permissible_specific_film are missing",
        )
    if base is None:
        return Limit(None, "base of the oil is missing")
    if oil.heat is None:
        return Limit(None, "[oil.heat] is missing")
    stage, warm = table.micropitting_load_stage, table.micropitting_test_temperature
    tested = film_at_load_stage(stage, gear_oil(oil, base), warm)
    factor = table.micropitting_material_factor
    by = f"1.4 W_W {factor:g} lambda_GFT {tested:.3g}: load stage {stage} at {warm - ZERO_CELSIUS:g} °C"
    return Limit(permissible_specific_film(tested, factor), by=by)


def simulated_spots(solutions: tuple[Solution, ...]) -> tuple[Spot, ...]:
    """Contacts of a result as scuffing and micropitting see them."""
    return tuple(_spot(solution) for solution in solutions)


def hotter_flank(solution: Solution) -> Estimate | None:
    """Largest temperature of both flanks [K]; None where heat was not simulated."""
    first = solution.figures.temperature_max_body_1
    second = solution.figures.temperature_max_body_2
    if first is None or second is None:
        return None
    return max(first, second, key=lambda flank: flank.value)


def _spot(solution: Solution) -> Spot:
    figures, film = solution.figures, solution.figures.film_min
    hottest: float | None = None
    warm: tuple[float, float | None] = (0.0, None)
    estimate = hotter_flank(solution)
    if estimate is not None:
        hottest, warm = estimate.value, (estimate.error, estimate.model)
    rubbing, touching = figures.friction_coefficient, figures.asperity_load_fraction
    return Spot(
        str(ContactIndex.of(solution)) or solution.name,
        hottest,
        film.value,
        (warm, (film.error, film.model)),
        None if rubbing is None else rubbing.value,
        0.0 if touching is None else touching.value,
        solution.phase,
    )


def scuffing(
    contact: float | None,
    oil_temperature: float | None,
    limit: Limit,
    required: float,
    place: str = "",
    bars: tuple[float, float | None] | None = None,
) -> Safety:
    """S_B of a contact by ISO/TS 6336-20, of oil of a temperature before the mesh [K]; simulated with bars.

    Closed form without error bars of the rise over the oil, numerical and of the model.
    """
    named = _named("S_B", "scuffing", bars, required, "temperature")
    if limit.value is None or limit.why:
        return Safety(**named, why=f"{limit.why}.")
    if contact is None or oil_temperature is None:
        missing = "heat was not simulated" if bars else "[surfaces] or [oil.heat] is missing"
        return Safety(**named, why=f"{missing}.")
    if contact <= oil_temperature:
        return Safety(**named, why="the contact is no hotter than its oil.")
    inputs: dict[str, Value] = {
        "theta_S_C": limit.value - ZERO_CELSIUS,
        "theta_B_C": contact - ZERO_CELSIUS,
        "theta_oil_C": oil_temperature - ZERO_CELSIUS,
        "margin_K": limit.value - contact,
        "theta_S": limit.by,
        "at": place,
    }
    doubts: tuple[str, ...] = ()
    if bars:
        doubts = (
            "theta_S belongs to the standard's friction: its S_B decides, the simulated one shows how "
            "much hotter or cooler these flanks are.",
        )
    value = float(scuffing_safety(contact, oil_temperature, limit.value))
    return _barred(named, value, inputs, doubts, bars)


def micropitting(
    film: float | None,
    roughness: float | None,
    limit: Limit,
    required: float,
    place: str = "",
    bars: tuple[float, float | None] | None = None,
) -> Safety:
    """S_lambda of a contact by ISO/TS 6336-22 of a minimum film [m] on Ra, mean of both flanks [m].

    Closed form without error bars of the film, numerical and of the model.
    """
    named = _named("S_lambda", "micropitting", bars, required, "film")
    if limit.value is None or limit.why:
        return Safety(**named, why=f"{limit.why}.")
    if roughness is None:
        return Safety(**named, why="the roughness of both flanks is missing.")
    if film is None:
        return Safety(**named, why="[oil.heat] or base of the oil is missing.")
    specific = film / roughness
    inputs: dict[str, Value] = {
        "lambda_GF": specific,
        "lambda_GFP": limit.value,
        "film_um": film * 1e6,
        "Ra_um": roughness * 1e6,
        "limit": limit.by,
        "at": place,
    }
    doubts: tuple[str, ...] = ()
    if bars:
        doubts = (
            "lambda_GFP belongs to the standard's film: its S_lambda decides, the simulated one shows "
            "how much thinner or thicker these films are.",
        )
    return _barred(named, float(micropitting_safety(specific, limit.value)), inputs, doubts, bars)


def _named(
    symbol: str, label: str, bars: tuple | None, required: float, what: str
) -> dict[str, Any]:
    given = {"minimum": required, "clause": CLAUSES[symbol]}
    if bars is None:
        return {"symbol": symbol, "label": label, **given}
    return {"symbol": f"{symbol}_simulated", "label": f"{label}, simulated {what}", **given}


def _barred(
    named: dict[str, Any],
    value: float,
    inputs: dict[str, Value],
    doubts: tuple[str, ...],
    bars: tuple[float, float | None] | None,
) -> Safety:
    """A safety with its error bars; where they hold the required value, that is told."""
    error, model = bars or (None, None)
    safety = Safety(**named, value=value, inputs=inputs, doubts=doubts, error=error, model=model)
    if not safety.open:
        return safety
    return replace(safety, doubts=(*doubts, "The verdict would turn within the uncertainty."))


def simulated_safeties(
    places: tuple[Spot, ...],
    limits: tuple[Limit, Limit],
    table: DamageLimits,
    oil_temperature: float | None,
    roughness: float | None,
) -> tuple[Safety, ...]:
    """S_B of the hottest and S_lambda of the thinnest simulated contact, by Ra, mean of both flanks [m]."""
    hot = max(places, key=lambda spot: spot.temperature or 0.0)
    thin, rough = min(places, key=lambda spot: spot.film), max(spot.asperities for spot in places)
    permissible = limits[1]
    if rough > LEAST_SHARE and not permissible.why:
        permissible = replace(
            permissible,
            why=f"the film was simulated between rough flanks, whose asperities carry {rough:.0%} of the "
            "load and hold them apart; lambda_GFP is of smooth films: solve with --effects auto,-roughness",
        )
    return (
        scuffing(
            hot.temperature,
            oil_temperature,
            limits[0],
            table.required_scuffing,
            hot.name,
            hot.bars[0],
        ),
        micropitting(
            thin.film, roughness, permissible, table.required_micropitting, thin.name, thin.bars[1]
        ),
    )
