"""Rating of a worm gear by the worm-gear standard under one load: all its figures in one call."""

from dataclasses import dataclass
from math import pi

from pyworm.formulas.ranges import one_of
from pyworm.formulas.worm_curves import OIL_KINDS, Lubrication, OilKind
from pyworm.formulas.worm_deflection import shaft_deflection
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_losses import Bearings, OtherLosses, other_losses
from pyworm.formulas.worm_root import FULL_RIM, root_shear
from pyworm.formulas.worm_standard import (
    PRESSURE_VISCOSITY,
    SOURCE,
    TeethLoss,
    bulk_temperature,
    injected_bulk_temperature,
    mean_pressure,
    minimum_film,
    pitting_safety,
    self_locking_margin,
    static_friction,
    teeth_loss,
)
from pyworm.formulas.worm_wear import (
    pressure_factor,
    start_factor,
    structure_factor,
    wear_depth,
    wear_intensity,
)
from pyworm.formulas.worm_wheel_material import Family, WheelMaterial


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
        T2 on the wheel, with its application factor [N m].
    reduced_modulus : float
        E_red [Pa].
    roughness : float
        Ra of the worm's flanks [m].
    lubrication : str
        "injection" or "bath".
    material : WheelMaterial, optional
        Of the wheel; friction without it is that of tin bronze.
    material_factor : float, optional
        Y_W [-]; that of the material if not given, 1 without a material.
    life : float, optional
        Wanted life [h].
    structure_factor, pressure_factor : float, optional
        W_S and W_H of the wear [-]; the standard's if not given.
    starts_per_hour : float
        [1/h].
    sump_temperature : float, optional
        Temperature of the oil in the sump, or injected [K].
    supplied_viscosity : float, optional
        Kinematic viscosity at that temperature [m2/s]; for injected oil.
    immersion_factor : float
        c_k of `bulk_temperature` [-].
    rim : float
        Thickness of the wheel's rim over the module [-].
    bearings : str
        How the worm is held (`pyworm.formulas.worm_losses.BEARINGS`).
    """

    oil: OilKind
    viscosity: float
    worm_speed: float
    torque: float
    reduced_modulus: float
    roughness: float
    lubrication: Lubrication = "injection"
    material: WheelMaterial | None = None
    material_factor: float | None = None
    life: float | None = None
    structure_factor: float | None = None
    pressure_factor: float | None = None
    starts_per_hour: float = 0.0
    sump_temperature: float | None = None
    supplied_viscosity: float | None = None
    immersion_factor: float = 1.0
    rim: float = FULL_RIM
    bearings: Bearings = "adjusted"

    @property
    def family(self) -> Family:
        """Group of the wheel's material; tin bronze without one."""
        return "tin bronze" if self.material is None else self.material.family

    @property
    def rubbing(self) -> float:
        """Y_W [-]."""
        if self.material_factor is not None:
            return self.material_factor
        return 1.0 if self.material is None else self.material.friction_factor


@dataclass(frozen=True)
class WormWear:
    """Wear of the wheel's flanks by the standard.

    Attributes
    ----------
    structure_factor, pressure_factor : float
        W_S and W_H [-].
    parameter : float
        K_W [um].
    base, intensity : float
        J_0T and J_W [-].
    depth : float
        Worn in the life [m].
    """

    structure_factor: float
    pressure_factor: float
    parameter: float
    base: float
    intensity: float
    depth: float


@dataclass(frozen=True)
class WormRating:
    """Figures of a worm gear by the standards under one load; the safeties need their limits besides.

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
    output : float
        Power at the wheel [W].
    tooth_loss : float
        Power lost between the teeth, worm driving [W].
    other : OtherLosses
        Losses besides.
    bulk_temperature : float or None
        Of the wheel [K]; None without a sump temperature.
    pitting_safety : float or None
        S_H [-]; None without a material and a life.
    wear : WormWear or None
        None likewise.
    root_shear : float
        tau_F of teeth that are not worn [Pa].
    shaft_deflection : float
        Of the worm's shaft between bearings at the usual places [m].
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
    output: float
    tooth_loss: float
    other: OtherLosses
    bulk_temperature: float | None
    pitting_safety: float | None
    wear: WormWear | None
    root_shear: float
    shaft_deflection: float
    source: str = SOURCE

    @property
    def loss(self) -> float:
        """Whole loss of the gearbox, worm driving [W]."""
        return self.tooth_loss + self.other.power

    @property
    def gearbox_efficiency(self) -> float:
        """Power at the wheel over power at the worm, with all losses [-]."""
        return self.output / (self.output + self.loss)

    @property
    def gearbox_efficiency_back(self) -> float:
        """Power at the worm over power at the wheel, which drives, all losses in [-]; it cannot at zero."""
        return self.backward_efficiency - self.other.power / self.output


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
    lost = _teeth_loss(gear, under)
    # of a small gear that creeps the running one is larger: teeth at rest rub no less
    at_rest = max(
        lost.friction,
        static_friction(gear.centre_distance, under.roughness, under.rubbing, under.family),
    )
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
        output=under.torque * under.worm_speed / gear.ratio,
        tooth_loss=lost.power,
        other=other_losses(gear, under.worm_speed, under.torque, under.bearings),
        bulk_temperature=_bulk_temperature(gear, under, lost.power),
        pitting_safety=_pitting_safety(gear, under, pressure),
        wear=_wear(gear, under, film, pressure),
        root_shear=root_shear(gear, under.torque, rim=under.rim),
        shaft_deflection=shaft_deflection(gear, under.torque, lost.friction),
    )


def _teeth_loss(gear: WormGear, under: WormConditions) -> TeethLoss:
    return teeth_loss(
        gear,
        under.oil,
        under.worm_speed,
        under.torque,
        under.roughness,
        under.rubbing,
        under.lubrication,
        under.family,
    )


def _pitting_safety(gear: WormGear, under: WormConditions, pressure: float) -> float | None:
    if under.material is None or under.life is None:
        return None
    return pitting_safety(
        pressure,
        under.material.pitting_strength,
        under.life,
        gear.sliding_speed(under.worm_speed),
        gear.centre_distance,
        under.oil,
        gear.ratio,
    )


def _wear(gear: WormGear, under: WormConditions, film: float, pressure: float) -> WormWear | None:
    if under.life is None or under.material is None:
        return None
    structure, weight = under.structure_factor, under.pressure_factor
    if structure is None:
        structure = structure_factor(under.oil, under.viscosity, under.family)
    if weight is None:
        weight = pressure_factor(pressure, under.family)
    base = wear_intensity(under.oil, film, structure, weight, under.lubrication, under.family)
    of_material = under.material.wear_factors[under.oil]
    intensity = base * start_factor(under.starts_per_hour) * of_material
    cycles = under.worm_speed / gear.ratio / (2 * pi) * under.life * 3600
    depth = wear_depth(
        intensity,
        gear.sliding_parameter,
        pressure,
        gear.centre_distance,
        under.reduced_modulus,
        cycles,
    )
    return WormWear(structure, weight, film * 1e6 * structure * weight, base, intensity, depth)


def _bulk_temperature(gear: WormGear, under: WormConditions, loss: float) -> float | None:
    sump, thick = under.sump_temperature, under.supplied_viscosity
    if sump is None:
        return None
    if under.lubrication == "injection" and thick is not None:
        return injected_bulk_temperature(sump, loss, under.worm_speed, gear, thick)
    area = gear.face_width * gear.mean_wheel_diameter
    return bulk_temperature(sump, loss, under.worm_speed, area, under.immersion_factor)
