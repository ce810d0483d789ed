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


def rate_worm(
    gear: WormGear,
    *,
    oil: OilKind,
    viscosity: float,
    worm_speed: float,
    torque: float,
    reduced_modulus: float,
    roughness: float,
    material_factor: float = 1.0,
    pitting_strength: float | None = None,
    life: float | None = None,
    structure_factor: float | None = None,
    pressure_factor: float = 1.0,
    sump_temperature: float | None = None,
    immersion_factor: float = 1.0,
    temperature_limit: float | None = None,
) -> WormRating:
    """Rate a worm gear; a rating whose data are missing is left out.

    Parameters
    ----------
    gear : WormGear
        Geometry.
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

    Raises
    ------
    ValueError
        What lies outside the methods, in one sentence.
    """
    a = gear.centre_distance
    film = minimum_film(
        gear.film_parameter,
        PRESSURE_VISCOSITY[_known(oil)],
        viscosity,
        worm_speed,
        a,
        reduced_modulus,
        torque,
    )
    pressure = mean_pressure(gear.pressure_parameter, torque, reduced_modulus, a)
    sliding = gear.sliding_speed(worm_speed)
    lost = teeth_loss(gear, oil, worm_speed, torque, roughness, material_factor)
    # of a small gear that creeps the running one is larger: teeth at rest rub no less
    at_rest = max(lost.friction, static_friction(a, roughness, material_factor))
    safety = intensity = depth = bulk = None
    if pitting_strength is not None and life is not None:
        safety = pitting_safety(pressure, pitting_strength, life, sliding, a, oil)
    if oil == "mineral" and structure_factor is None:
        structure_factor = 1.0
    if life is not None and structure_factor is not None and oil in WEAR_INTENSITIES:
        intensity = wear_intensity(oil, film, structure_factor, pressure_factor)
        cycles = worm_speed / gear.ratio / (2 * pi) * life * 3600
        depth = wear_depth(intensity, gear.sliding_parameter, pressure, a, reduced_modulus, cycles)
    if sump_temperature is not None:
        area = gear.face_width * gear.teeth * gear.module
        bulk = bulk_temperature(sump_temperature, lost.power, worm_speed, area, immersion_factor)
    return WormRating(
        film_parameter=gear.film_parameter,
        pressure_parameter=gear.pressure_parameter,
        sliding_parameter=gear.sliding_parameter,
        sliding_speed=sliding,
        film=film,
        mean_pressure=pressure,
        friction=lost.friction,
        forward_efficiency=lost.forward_efficiency,
        backward_efficiency=lost.backward_efficiency,
        self_locking_margin=self_locking_margin(gear.tan_lead, lost.friction),
        static_friction=at_rest,
        static_locking_margin=self_locking_margin(gear.tan_lead, at_rest),
        tooth_loss=lost.power,
        bulk_temperature=bulk,
        pitting_safety=safety,
        wear_intensity=intensity,
        wear_depth=depth,
        wear_safety=None if depth is None else gear.wear_limit / depth,
        temperature_safety=(
            None
            if sump_temperature is None or temperature_limit is None
            else temperature_safety(sump_temperature, temperature_limit)
        ),
    )


def _known(oil: OilKind) -> OilKind:
    one_of("oil", oil, OIL_KINDS)
    return oil
