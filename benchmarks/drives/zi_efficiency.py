"""Loss and efficiency of the ZI drive beside the standards' (docs/evidence/validation.md).

Run from the repository's root:

    pyworm run cases/zi_drive.toml -j 2 --accuracy 2% --effects auto,-squeeze
    python benchmarks/drives/zi_efficiency.py results/zi_drive/result.nc
"""

import sys
from math import pi

from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormConditions, WormRating
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import open_result

GEAR = WormGear(
    centre_distance=0.3048,
    starts=3,
    teeth=59,
    module=28.73e-3 / pi,
    diameter_factor=8.5,  # the reference cylinder one module below the tip
    face_width=60.33e-3,
    profile_shift=-0.42,  # makes the centre distance
)

ROUGHNESS = (0.1e-6, 0.3e-6, 0.5e-6)
"""Ra of the worm's flanks for which the standards are asked [m]; the least they know is 0.1 um or so."""


def main() -> None:
    result = open_result(sys.argv[1])
    loss = drive_cycle(result).loss
    print(
        f"simulated, smooth: {loss.power:.0f} +- {loss.error:.0f} W, friction {loss.friction:.4f}, "
        f"{loss.efficiency:.2%} +- {loss.efficiency_error:.2%}, other way {loss.reverse_efficiency:.2%}"
    )
    for roughness in ROUGHNESS:
        conditions = WormConditions(
            oil="PAG",
            viscosity=0.227,
            worm_speed=1500 * pi / 30,
            torque=loss.wheel_torque,
            reduced_modulus=170.81e9,
            roughness=roughness,
        )
        rated = WormRating(GEAR, conditions)
        print(
            f"standard, Ra {roughness * 1e6:.1f} um: {rated.tooth_loss:.0f} W, friction "
            f"{rated.friction:.4f}, {rated.forward_efficiency:.2%}, other way "
            f"{rated.backward_efficiency:.2%}, film {rated.film * 1e6:.2f} um"
        )


if __name__ == "__main__":
    main()
