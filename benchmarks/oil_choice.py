"""The choice of oil for two drives, page by page: the ZI worm and Errichello's speed increaser.

python benchmarks/oil_choice.py
"""

from math import pi

from pyworm.formulas.gear_oil import FOOT_PER_MINUTE, INCH, agma_parallel, agma_worm, worm_table
from pyworm.formulas.wear_distress import composite_roughness
from pyworm.formulas.worm_standard import WormGear
from pyworm.oil_choice import Duty, choose_oil, line_film, page, worm_film

CELSIUS = 273.15


def fahrenheit(degrees: float) -> float:
    """A temperature [K] from degrees Fahrenheit."""
    return (degrees - 32) / 1.8 + CELSIUS


ZI_SPEED = 1500 * pi / 30

ZI_GEAR = WormGear(
    centre_distance=0.3048,
    starts=3,
    teeth=59,
    module=28.73e-3 / pi,
    diameter_factor=7.66,  # makes the centre distance
    face_width=60.33e-3,
)

ZI_WORM = Duty(
    name="the ZI worm drive of Sharif et al. (2001)",
    base="PAG",
    film=worm_film(ZI_GEAR, ZI_SPEED, torque=10e3, reduced_modulus=170.81e9),
    # Assumed: flanks of 0.3 and 0.5 um rms, a third of the heat from churning, teeth 15 K above the oil.
    roughness=composite_roughness(0.3e-6, 0.5e-6),
    specific_film=1.5,
    ambient_temperature=20 + CELSIUS,
    sump_temperature=60 + CELSIUS,
    sump_grade=460,
    bulk_excess=15.0,
    churning_share=1 / 3,
    sump_limit=90 + CELSIUS,
    tables=(
        agma_worm(0.3048, ZI_SPEED, 20 + CELSIUS),
        worm_table(0.3048, ZI_SPEED, 60 + CELSIUS, synthetic=True),
    ),
)

ERRICHELLO = Duty(
    name="Errichello's speed increaser",
    base="mineral",
    # The geometry is not given. At the pitch point of 104 and 709 mm pitch diameters (from centre distance
    # and speeds), with a pressure angle of 20 deg and the load of 346 hp on one tooth of 8 in, both assumed.
    film=line_film(radius=15.5e-3, load_per_length=6.6e5, reduced_modulus=228e9, speed=0.70),
    roughness=composite_roughness(20e-6 * INCH, 20e-6 * INCH),
    specific_film=1.0,
    ambient_temperature=fahrenheit(70),
    sump_temperature=fahrenheit(200),
    sump_grade=100,
    bulk_excess=30 / 1.8,
    churning_share=0.1,
    sump_limit=fahrenheit(225),
    pitch_line_velocity=400 * FOOT_PER_MINUTE,
    tables=(agma_parallel(16 * INCH, fahrenheit(70)),),
    contact_temperature=fahrenheit(439),
    coldest_start=fahrenheit(50),
)


def main() -> None:
    for duty in (ZI_WORM, ERRICHELLO):
        print(page(choose_oil(duty)))


if __name__ == "__main__":
    main()
