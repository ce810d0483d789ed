"""Rating of a worm gear by the worm-gear standard under one load, each figure by itself."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi
from typing import Literal

from pyworm.formulas.ranges import one_of
from pyworm.formulas.unknown import Unknown, known
from pyworm.formulas.worm_curves import OIL_KINDS, SLIDING_RANGE, Lubrication, OilKind
from pyworm.formulas.worm_deflection import shaft_deflection
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_losses import Bearings, OtherLosses, other_losses
from pyworm.formulas.worm_root import FULL_RIM, root_shear
from pyworm.formulas.worm_standard import (
    PRESSURE_VISCOSITY,
    SOURCE,
    TeethLoss,
    backward_efficiency,
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

Driver = Literal["worm", "wheel"]

NOT_GIVEN = Unknown("it is not given")


@dataclass(frozen=True)
class WormConditions:
    """Conditions that a worm gear is rated for; a figure whose data are `Unknown` has none."""

    oil: OilKind | Unknown
    """Kind of oil: "mineral", "PAO" or "PAG"."""
    viscosity: float | Unknown
    """Dynamic viscosity at the wheel's bulk temperature [Pa s]."""
    worm_speed: float
    """Speed of the worm [rad/s]."""
    torque: float
    """T2 on the wheel, with its application factor [N m]."""
    reduced_modulus: float
    """Reduced modulus E_red [Pa]."""
    roughness: float | Unknown
    """Ra of the worm's flanks [m]."""
    lubrication: Lubrication = "injection"
    """Lubrication: "injection" or "bath"."""
    material: WheelMaterial | Unknown = NOT_GIVEN
    """Material of the wheel; where it is not known, friction is that of tin bronze."""
    material_factor: float | None = None
    """Y_W [-]; that of the material if not given."""
    life: float | Unknown = NOT_GIVEN
    """Wanted life [h]."""
    structure_factor: float | None = None
    """W_S of the wear [-]; the standard's if not given."""
    pressure_factor: float | None = None
    """W_H of the wear [-]; the standard's if not given."""
    starts_per_hour: float = 0.0
    """Starts of the drive [1/h]."""
    sump_temperature: float | Unknown = NOT_GIVEN
    """Temperature of the oil in the sump, or injected [K]."""
    wheel_temperature: float | None = None
    """Bulk temperature of the wheel [K] where it is given; else the standard's."""
    supplied_viscosity: float | Unknown = NOT_GIVEN
    """Kinematic viscosity at the sump's temperature [m2/s]; for injected oil."""
    immersion_factor: float = 1.0
    """c_k of `bulk_temperature` [-]."""
    rim: float = FULL_RIM
    """Thickness of the wheel's rim over the module [-]."""
    bearings: Bearings = "adjusted"
    """How the worm is held (`pyworm.formulas.worm_losses.BEARINGS`)."""
    other_loss: float | None = None
    """Losses besides the teeth [W] where they are given; else the standard's."""
    driver: Driver = "worm"
    """Driving member: "worm" or "wheel"."""

    @property
    def family(self) -> Family:
        """Group of the wheel's material; tin bronze without one."""
        return "tin bronze" if isinstance(self.material, Unknown) else known(self.material.family)

    @property
    def friction_is_known(self) -> bool:
        """Whether the wheel's material is given, and the standard knows how it rubs."""
        return not (isinstance(self.material, Unknown) or isinstance(self.material.family, Unknown))

    @property
    def rubbing(self) -> float:
        """Y_W [-]."""
        if self.material_factor is not None:
            return self.material_factor
        if isinstance(self.material, Unknown):
            return 1.0
        return known(self.material.friction_factor)


@dataclass(frozen=True)
class WormWear:
    """Wear of the wheel's flanks by the standard."""

    structure_factor: float
    """Structure factor W_S [-]."""
    pressure_factor: float
    """Pressure factor W_H [-]."""
    parameter: float
    """Parameter K_W [um]."""
    base: float
    """Base wear intensity J_0T [-]."""
    intensity: float
    """Wear intensity J_W [-]."""
    depth: float
    """Worn in the life [m]."""


@dataclass(frozen=True)
class WormRating:
    """Figures of a worm gear by the standards under one load, each computed on demand.

    ValueError names the reason, and the key of a case that would give what is missing. Safeties need limits,
    too.
    """

    gear: WormGear
    """Geometry."""
    under: WormConditions
    """What it is rated for."""
    source = SOURCE

    @cached_property
    def oil(self) -> OilKind:
        """Kind of the oil."""
        oil = known(self.under.oil)
        one_of("oil", oil, OIL_KINDS)
        return next(kind for kind in OIL_KINDS if kind == oil)

    @cached_property
    def sliding_speed(self) -> float:
        """Sliding speed v_g at the worm's reference cylinder [m/s]."""
        return self.gear.sliding_speed(self.under.worm_speed)

    @cached_property
    def film(self) -> float:
        """Mean minimum film thickness h_min,m [m]."""
        return minimum_film(
            self.gear.film_parameter,
            PRESSURE_VISCOSITY[self.oil],
            known(self.under.viscosity),
            self.under.worm_speed,
            self.gear.centre_distance,
            self.under.reduced_modulus,
            self.under.torque,
        )

    @cached_property
    def mean_pressure(self) -> float:
        """Mean contact stress sigma_Hm [Pa]."""
        gear, under = self.gear, self.under
        return mean_pressure(
            gear.pressure_parameter, under.torque, under.reduced_modulus, gear.centre_distance
        )

    def _lost_at(self, sliding_speed: float | None = None) -> TeethLoss:
        under = self.under
        return teeth_loss(
            self.gear,
            self.oil,
            under.worm_speed,
            under.torque,
            known(under.roughness),
            under.rubbing,
            under.lubrication,
            under.family,
            sliding_speed,
        )

    @cached_property
    def teeth_loss(self) -> TeethLoss:
        """Friction, efficiency and loss of the teeth."""
        return self._lost_at()

    @property
    def friction(self) -> float:
        """Mean coefficient of tooth friction mu_zm [-]."""
        return self.teeth_loss.friction

    @property
    def forward_efficiency(self) -> float:
        """Efficiency of the teeth, worm driving [-]."""
        return self.teeth_loss.forward_efficiency

    @property
    def backward_efficiency(self) -> float:
        """Efficiency of the teeth, wheel driving [-]; zero or less where the wheel cannot drive."""
        return self.teeth_loss.backward_efficiency

    @property
    def self_locking_margin(self) -> float:
        """mu/tan gamma [-], running."""
        return self_locking_margin(self.gear.tan_lead, self.friction)

    @property
    def within_friction(self) -> bool:
        """True if the teeth slide at a speed of which the friction is known."""
        slowest, fastest = SLIDING_RANGE
        return slowest <= self.sliding_speed <= fastest

    @cached_property
    def nearest_loss(self) -> TeethLoss:
        """Loss of the teeth, beyond the speeds of known friction with that of the nearest one.

        An upper bound above these speeds, where friction falls, and close to one below them, where it is
        bounded and the power lost vanishes with the speed.
        """
        slowest, fastest = SLIDING_RANGE
        return self._lost_at(min(max(self.sliding_speed, slowest), fastest))

    @property
    def as_if_bronze(self) -> "WormRating":
        """The gear with the friction of tin bronze where that of its wheel's material is not known.

        For what depends on friction a little: the wheel's temperature and the deflection of the shaft.
        """
        under = self.under
        if under.friction_is_known:
            return self
        return WormRating(self.gear, replace(under, material=NOT_GIVEN))

    @cached_property
    def static_friction(self) -> float:
        """Coefficient of tooth friction at rest [-]; no less than that of creeping teeth."""
        under = self.under
        at_rest = static_friction(
            self.gear.centre_distance, known(under.roughness), under.rubbing, under.family
        )
        return max(self.nearest_loss.friction, at_rest)

    @property
    def static_locking_margin(self) -> float:
        """mu/tan gamma [-], at rest."""
        return self_locking_margin(self.gear.tan_lead, self.static_friction)

    @cached_property
    def static_backward_efficiency(self) -> float:
        """Efficiency of the teeth with the wheel about to drive from rest [-]; as `backward_efficiency`."""
        return backward_efficiency(self.gear.tan_lead, self.static_friction)

    @property
    def output(self) -> float:
        """Power at the wheel [W]."""
        return self.under.torque * self.under.worm_speed / self.gear.ratio

    @property
    def tooth_loss(self) -> float:
        """Power lost between the teeth as the drive runs [W]."""
        return self.teeth_loss.driven_by(self.under.driver)

    @cached_property
    def standard_losses(self) -> OtherLosses:
        """Losses besides the teeth by the standard."""
        under = self.under
        return other_losses(self.gear, under.worm_speed, under.torque, under.bearings)

    @property
    def other_power(self) -> float:
        """Losses besides the teeth, as given or by the standard [W]."""
        given = self.under.other_loss
        return self.standard_losses.power if given is None else given

    @property
    def loss(self) -> float:
        """Whole loss of the gearbox as the drive runs [W]."""
        return self.tooth_loss + self.other_power

    @property
    def gearbox_efficiency(self) -> float:
        """Power at the wheel over power at the worm, which drives, with all losses [-]."""
        return self.output / (self.output + self.teeth_loss.power + self.other_power)

    @property
    def gearbox_efficiency_back(self) -> float:
        """Power at the worm over power at the wheel, which drives, with all losses [-].

        Zero or less where the wheel cannot keep the gearbox running.
        """
        return self.backward_efficiency - self.other_power / self.output

    @property
    def static_gearbox_efficiency_back(self) -> float:
        """Share of the wheel's torque that comes to the worm at rest [-]; at zero or less the gearbox locks.

        Teeth rub as at rest. Of the other losses those remain whose torque does not vanish with the speed:
        bearings under load and seals, as they run, which is no more than they resist at rest. Oil does not
        resist at rest.
        """
        losses = self.standard_losses
        lasting = losses.bearings + losses.seals
        return self.static_backward_efficiency - lasting / self.output

    @cached_property
    def bulk_temperature(self) -> float:
        """Bulk temperature of the wheel [K]; by `as_if_bronze` where friction is not known."""
        gear, under = self.gear, self.under
        if under.wheel_temperature is not None:
            return under.wheel_temperature
        sump = known(under.sump_temperature)
        loss = self.as_if_bronze.nearest_loss.driven_by(under.driver)
        if under.lubrication == "injection":
            thick = known(under.supplied_viscosity)
            return injected_bulk_temperature(sump, loss, under.worm_speed, gear, thick)
        area = gear.face_width * gear.mean_wheel_diameter
        return bulk_temperature(sump, loss, under.worm_speed, area, under.immersion_factor)

    @cached_property
    def pitting_safety(self) -> float:
        """S_H [-]."""
        gear, under = self.gear, self.under
        return pitting_safety(
            self.mean_pressure,
            known(known(under.material).pitting_strength),
            known(under.life),
            self.sliding_speed,
            gear.centre_distance,
            self.oil,
            gear.ratio,
        )

    @cached_property
    def wear(self) -> WormWear:
        """Wear of the wheel's flanks."""
        gear, under = self.gear, self.under
        material, life = known(under.material), known(under.life)
        of_material = known(material.wear_factors)[self.oil]
        structure, weight = under.structure_factor, under.pressure_factor
        if structure is None:
            structure = structure_factor(self.oil, known(under.viscosity), under.family)
        if weight is None:
            weight = pressure_factor(self.mean_pressure, under.family)
        base = wear_intensity(
            self.oil, self.film, structure, weight, under.lubrication, under.family
        )
        intensity = base * start_factor(under.starts_per_hour) * of_material
        depth = wear_depth(
            intensity,
            gear.sliding_parameter,
            self.mean_pressure,
            gear.centre_distance,
            under.reduced_modulus,
            under.worm_speed / gear.ratio / (2 * pi) * life * 3600,
        )
        parameter = self.film * 1e6 * structure * weight
        return WormWear(structure, weight, parameter, base, intensity, depth)

    @cached_property
    def root_shear(self) -> float:
        """tau_F of teeth that are not worn [Pa]."""
        return root_shear(self.gear, self.under.torque, rim=self.under.rim)

    @cached_property
    def shaft_deflection(self) -> float:
        """Deflection of the worm's shaft between bearings at the usual places [m].

        Friction adds to the force along the wheel's circumference where the worm drives, and takes from it
        where the wheel does.
        """
        friction = self.as_if_bronze.nearest_loss.friction
        against = friction if self.under.driver == "worm" else -friction
        return shaft_deflection(self.gear, self.under.torque, against)
