"""Rating of a worm gear by the worm-gear standard: all its safety factors in one call."""

from dataclasses import dataclass
from math import pi

from pyworm.formulas.ranges import one_of
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_standard import (
    OIL_KINDS,
    PRESSURE_VISCOSITY,
    SOURCE,
    WEAR_INTENSITIES,
    OilKind,
    bulk_temperature,
    mean_pressure,
    minimum_film,
    pitting_safety,
    self_locking_margin,
    static_friction,
    teeth_loss,
    temperature_safety,
    wear_depth,
    wear_intensity,
)


@dataclass(frozen=True)
class WormConditions:
    """Conditions that a worm gear is rated for; ratings whose data are missing are left out.

    Attributes
    ----------
    oil : str
        "mineral", "PAO" or "PAG".
    viscosity : float
        Dynamic viscosity at the wheel's bulk temperature [Pa s].
    worm_speed : float
        [rad/s].
    torque : float
        T2 on the wheel [N m].
    reduced_modulus : float
        E_red [Pa].
    roughness : float
        Ra of the worm's flanks [m].
    material_factor : float
        Y_W [-].
    pitting_strength, life : float, optional
        sigma_HlimT [Pa] and wanted life [h].
    structure_factor, pressure_factor : float
        W_S and W_H of `wear_intensity` [-]; W_S of mineral oil is 1, of PAG it must be given for wear to
        be rated.
    sump_temperature, temperature_limit : float, optional
        Temperature of the oil and the highest allowed [K].
    immersion_factor : float
        c_k of `bulk_temperature` [-].
    """

    oil: OilKind
    viscosity: float
    worm_speed: float
    torque: float
    reduced_modulus: float
    roughness: float
    material_factor: float = 1.0
    pitting_strength: float | None = None
    life: float | None = None
    structure_factor: float | None = None
    pressure_factor: float = 1.0
    sump_temperature: float | None = None
    immersion_factor: float = 1.0
    temperature_limit: float | None = None


@dataclass(frozen=True)
class WormRating:
    """A worm gear by the standards' methods.

    Attributes
    ----------
    film_parameter, pressure_parameter, sliding_parameter : float
        h*, p_m*, s* [-].
    sliding_speed : float
        vg [m/s].
    film : float
        h_min,m [m].
    mean_pressure : float
        sigma_Hm [Pa].
    friction : float
        mu_zm [-].
    forward_efficiency, backward_efficiency : float
        Of the teeth [-]; backward zero or less where the wheel cannot drive.
    self_locking_margin : float
        mu/tan gamma [-], running.
    static_friction, static_locking_margin : float
        mu and mu/tan gamma at rest [-].
    tooth_loss : float
        Power lost between the teeth, worm driving [W].
    bulk_temperature : float or None
        Of the wheel [K]; None without a sump temperature.
    pitting_safety : float or None
        S_H [-]; None without a strength and a life.
    wear_intensity, wear_depth : float or None
        J [-] and depth [m] in the life; None without a life or W_S, and with PAO.
    wear_safety : float or None
        S_W [-], `WormGear.wear_limit` over that depth; None likewise.
    temperature_safety : float or None
        S_T [-]; None without a limit.
    source : str
        The standards.
    """

    film_parameter: float
    pressure_parameter: float
    sliding_parameter: float
    sliding_speed: float
    film: float
    mean_pressure: float
    friction: float
    forward_efficiency: float
    backward_efficiency: float
    self_locking_margin: float
    static_friction: float
    static_locking_margin: float
    tooth_loss: float
    bulk_temperature: float | None
    pitting_safety: float | None
    wear_intensity: float | None
    wear_depth: float | None
    wear_safety: float | None
    temperature_safety: float | None
    source: str = SOURCE


def rate_worm(gear: WormGear, under: WormConditions) -> WormRating:
    """Rate a worm gear under given conditions.

    Raises
    ------
    ValueError
        What lies outside the methods, in one sentence.
    """
    one_of("oil", under.oil, OIL_KINDS)
    film = minimum_film(
        gear.film_parameter,
        PRESSURE_VISCOSITY[under.oil],
        under.viscosity,
        under.worm_speed,
        gear.centre_distance,
        under.reduced_modulus,
        under.torque,
    )
    pressure = mean_pressure(
        gear.pressure_parameter, under.torque, under.reduced_modulus, gear.centre_distance
    )
    lost = teeth_loss(
        gear, under.oil, under.worm_speed, under.torque, under.roughness, under.material_factor
    )
    # of a small gear that creeps the running one is larger: teeth at rest rub no less
    at_rest = max(
        lost.friction,
        static_friction(gear.centre_distance, under.roughness, under.material_factor),
    )
    safety = _pitting_safety(gear, under, pressure)
    intensity, depth = _wear(gear, under, film, pressure)
    return WormRating(
        film_parameter=gear.film_parameter,
        pressure_parameter=gear.pressure_parameter,
        sliding_parameter=gear.sliding_parameter,
        sliding_speed=gear.sliding_speed(under.worm_speed),
        film=film,
        mean_pressure=pressure,
        friction=lost.friction,
        forward_efficiency=lost.forward_efficiency,
        backward_efficiency=lost.backward_efficiency,
        self_locking_margin=self_locking_margin(gear.tan_lead, lost.friction),
        static_friction=at_rest,
        static_locking_margin=self_locking_margin(gear.tan_lead, at_rest),
        tooth_loss=lost.power,
        bulk_temperature=_bulk_temperature(gear, under, lost.power),
        pitting_safety=safety,
        wear_intensity=intensity,
        wear_depth=depth,
        wear_safety=None if depth is None else gear.wear_limit / depth,
        temperature_safety=_temperature_safety(under),
    )


def _pitting_safety(gear: WormGear, under: WormConditions, pressure: float) -> float | None:
    if under.pitting_strength is None or under.life is None:
        return None
    return pitting_safety(
        pressure,
        under.pitting_strength,
        under.life,
        gear.sliding_speed(under.worm_speed),
        gear.centre_distance,
        under.oil,
    )


def _wear(
    gear: WormGear, under: WormConditions, film: float, pressure: float
) -> tuple[float, float] | tuple[None, None]:
    """Intensity [-] and depth [m] of wear in the life."""
    structure = under.structure_factor
    if under.oil == "mineral" and structure is None:
        structure = 1.0
    if under.life is None or structure is None or under.oil not in WEAR_INTENSITIES:
        return None, None
    intensity = wear_intensity(under.oil, film, structure, under.pressure_factor)
    cycles = under.worm_speed / gear.ratio / (2 * pi) * under.life * 3600
    depth = wear_depth(
        intensity,
        gear.sliding_parameter,
        pressure,
        gear.centre_distance,
        under.reduced_modulus,
        cycles,
    )
    return intensity, depth


def _bulk_temperature(gear: WormGear, under: WormConditions, loss: float) -> float | None:
    if under.sump_temperature is None:
        return None
    area = gear.face_width * gear.teeth * gear.module
    return bulk_temperature(
        under.sump_temperature, loss, under.worm_speed, area, under.immersion_factor
    )


def _temperature_safety(under: WormConditions) -> float | None:
    if under.sump_temperature is None or under.temperature_limit is None:
        return None
    return temperature_safety(under.sump_temperature, under.temperature_limit)
