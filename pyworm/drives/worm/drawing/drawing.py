"""A worm gear as its drawing has it, and the design table of worm, wheel and hob that follows.

Names as in DIN 3975 and ISO 1122-2. What a drawing leaves out has a usual value (`usual_values`).
"""

from dataclasses import dataclass
from math import atan, cos, pi

from pyworm.drives.worm.drawing.design import Hob, ParabolicRelief, Wheel, Worm
from pyworm.drives.worm.flanks import involute_helicoid as helicoid
from pyworm.drives.worm.flanks.worm_profiles import (
    Profile,
    Thread,
    generator_of,
    hob_generator,
    normal_pressure_angle,
)

CLEARANCE = 0.2
"""Usual clearance between tip and root over the axial module."""


@dataclass(frozen=True, kw_only=True)
class Drawing:
    """The numbers of a drawing, complete."""

    centre_distance: float
    """Centre distance a [m]."""
    threads: int
    """Threads of the worm, z1."""
    teeth: int
    """Teeth of the wheel, z2."""
    module: float
    """Axial module m_x [m]."""
    diameter_factor: float
    """q, reference diameter of the worm over the module [-]."""
    pressure_angle: float
    """alpha_n at the worm's reference cylinder [rad]; axial of ZA, of ZN the blade's, ZK, ZC the disc's."""
    worm_tip_diameter: float
    """Tip diameter of the worm, d_a1 [m]."""
    worm_root_diameter: float
    """Root diameter of the worm, d_f1 [m]."""
    worm_thickness: float
    """Axial thickness of the thread on the reference cylinder [m]."""
    wheel_throat_diameter: float
    """Throat diameter of the wheel, d_a2 [m]."""
    wheel_outside_diameter: float
    """Outside diameter of the wheel, d_e2 [m]."""
    wheel_root_diameter: float
    """Root diameter of the wheel, d_f2 [m]."""
    wheel_groove_radius: float
    """Radius r_k of the throat's groove [m]."""
    face_width: float
    """b_2H of the wheel [m]."""
    backlash: float
    """Circumferential backlash on the wheel's reference circle [m]."""
    worm_fillet_radius: float
    """Radius of the worm's fillet at its root, in its axial section [m]."""
    wheel_fillet_radius: float
    """Radius [m] of the rounded edge of the hob's tip, axially, which leaves the wheel's fillet."""
    worm_tip_relief: float
    """What is taken off the worm's flank at its tip [m]."""
    worm_tip_relief_length: float
    """Where below the worm's tip that begins [m]."""
    wheel_tip_relief: float
    """What is taken off the wheel's flank at its tip [m]."""
    wheel_tip_relief_length: float
    """Where below the wheel's tip that begins [m]."""
    hob_oversize: float
    """Reference diameter of the hob beyond the worm's [m]."""
    hob_axial_shift: float
    """Shift of the hob along the wheel's axis [m]."""
    hob_centre_distance: float | None = None
    """Distance of hob and wheel axes [m]; None: so that both have the same pitch point."""
    hob_swivel: float | None = None
    """Turn of the hob's axis [rad]; None: so that hob and worm have the same normal in the pitch point."""
    profile: Profile = "ZI"
    """Form of the flanks."""
    worm_disc_diameter: float | None = None
    """Diameter of the disc that grinds worm and hob (ZK, ZC), where it touches the reference cylinder [m]."""
    worm_arc_radius: float | None = None
    """Radius of the convex profile of that disc (ZC) [m]."""

    @property
    def reference_diameter(self) -> float:
        """Reference diameter of the worm d_m1 [m]."""
        return self.diameter_factor * self.module

    @property
    def wheel_reference_diameter(self) -> float:
        """Reference diameter of the wheel d_2 [m]."""
        return self.teeth * self.module

    @property
    def profile_shift(self) -> float:
        """x_2 of the wheel [-]."""
        return self.centre_distance / self.module - (self.diameter_factor + self.teeth) / 2

    @property
    def lead(self) -> float:
        """Advance of the worm's threads in one turn [m]."""
        return pi * self.module * self.threads

    @property
    def lead_angle(self) -> float:
        """Lead angle gamma on the worm's reference cylinder [rad]."""
        return atan(self.threads / self.diameter_factor)

    @property
    def normal_pressure_angle(self) -> float:
        """alpha_n at the worm's reference cylinder [rad]."""
        return normal_pressure_angle(self.profile, self.pressure_angle, self.lead_angle)

    @property
    def base_lead_angle(self) -> float:
        """Lead angle on the worm's base cylinder, that of the ZI worm of the same numbers [rad]."""
        return helicoid.base_lead_angle(self.lead_angle, self.normal_pressure_angle)

    @property
    def base_radius(self) -> float:
        """Radius of the worm's base cylinder, likewise [m]."""
        return helicoid.base_radius(self.lead, self.base_lead_angle)

    @property
    def normal_module(self) -> float:
        """Module of the section normal to the threads m_n [m]."""
        return helicoid.normal_module(self.module, self.lead_angle)

    @property
    def hob_lead_angle(self) -> float:
        """Lead angle on the reference cylinder of the hob, which has the worm's normal module [rad]."""
        diameter = self.reference_diameter + self.hob_oversize
        return helicoid.lead_angle_of(self.threads, self.normal_module, diameter)

    @property
    def normal_swivel(self) -> float:
        """Swivel by which hob and worm have the same normal in the pitch point [rad]."""
        return self.lead_angle - self.hob_lead_angle

    @property
    def worm(self) -> Worm:
        """The worm's design table."""
        return Worm(
            threads=self.threads,
            tip_radius=self.worm_tip_diameter / 2,
            root_radius=self.worm_root_diameter / 2,
            base_radius=self._of_involutes(self.base_radius),
            axial_pitch=pi * self.module,
            lead=self.lead,
            base_lead_angle=self._of_involutes(self.base_lead_angle),
            tip_relief=ParabolicRelief(self.worm_tip_relief, self.worm_tip_relief_length),
            reference_radius=self.reference_diameter / 2,
            thickness=self.worm_thickness,
            generator=generator_of(self.profile, self._worm_thread),
            profile=self.profile,
            fillet_radius=self.worm_fillet_radius,
        )

    @property
    def wheel(self) -> Wheel:
        """The wheel's design table."""
        return Wheel(
            teeth=self.teeth,
            face_width=self.face_width,
            tip_radius=self.wheel_outside_diameter / 2,
            throat_radius=self.wheel_throat_diameter / 2,
            tip_relief=ParabolicRelief(self.wheel_tip_relief, self.wheel_tip_relief_length),
            groove_radius=self.wheel_groove_radius,
            backlash=self.backlash,
            fillet_radius=self.wheel_fillet_radius,
        )

    @property
    def hob(self) -> Hob:
        """The hob: the worm's normal module and pressure angle, so its base pitch, on a larger cylinder."""
        diameter = self.reference_diameter + self.hob_oversize
        distance = self.hob_centre_distance or self.centre_distance + self.hob_oversize / 2
        lead_angle = self.hob_lead_angle
        base_angle = helicoid.base_lead_angle(lead_angle, self.normal_pressure_angle)
        # z m_n = z m_x cos(gamma) is the same of both
        lead = self.lead * cos(self.lead_angle) / cos(lead_angle)
        root = diameter / 2 - (1 + CLEARANCE) * self.module
        root = min(root, distance - self.wheel_throat_diameter / 2)
        tip = distance - self.wheel_root_diameter / 2
        return Hob(
            tip_radius=tip,
            root_radius=root,
            base_radius=self._of_involutes(helicoid.base_radius(lead, base_angle)),
            lead=lead,
            axial_pitch=lead / self.threads,
            base_lead_angle=self._of_involutes(base_angle),
            centre_distance=distance,
            swivel=self.normal_swivel if self.hob_swivel is None else self.hob_swivel,
            axial_shift=self.hob_axial_shift,
            generator=hob_generator(
                self.profile,
                self._thread(lead, lead_angle, diameter / 2, (root, tip)),
                self._worm_thread,
            ),
        )

    def _of_involutes(self, value: float) -> float | None:
        """A number that only ZI flanks have."""
        return value if self.profile == "ZI" else None

    @property
    def _worm_thread(self) -> Thread:
        """What forms the worm's flank."""
        radii = self.worm_root_diameter / 2, self.worm_tip_diameter / 2
        return self._thread(self.lead, self.lead_angle, self.reference_diameter / 2, radii)

    def _thread(
        self, lead: float, lead_angle: float, reference: float, radii: tuple[float, float]
    ) -> Thread:
        """What forms the flank of worm or hob, which have one normal width of the space and one disc."""
        space = (pi * self.module - self.worm_thickness) * cos(self.lead_angle)
        return Thread(
            module=self.module,
            lead=lead,
            lead_angle=lead_angle,
            pressure_angle=self.normal_pressure_angle,
            reference_radius=reference,
            root_radius=radii[0],
            tip_radius=radii[1],
            space=space,
            disc_diameter=self.worm_disc_diameter,
            arc_radius=self.worm_arc_radius,
        )


def key_of(name: str) -> str:
    """The key of `[drive]` of a number: "hob.oversize" of "hob_oversize"."""
    part, _, rest = name.partition("_")
    return f"{part}.{rest}" if part in ("worm", "wheel", "hob") else name
