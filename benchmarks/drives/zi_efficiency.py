"""Loss and efficiency of the ZI drive beside the standards' (docs/evidence/validation.md).

Run from the repository's root:

    pyworm run cases/zi_drive.toml --accuracy 2% --effects auto,-squeeze
    python benchmarks/drives/zi_efficiency.py results/zi_drive/result.nc
"""

import sys
from math import pi
from pathlib import Path

from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormConditions, WormRating
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import open_result

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

GEAR = WormGear(
    centre_distance=0.3048,
    starts=3,
    teeth=59,
    module=28.73e-3 / pi,
    diameter_factor=8.5,  # the reference cylinder one module below the tip
    face_width=60.33e-3,
    profile_shift=-0.42,  # makes the centre distance
)

FIRST = "pyworm run cases/zi_drive.toml --accuracy 2% --effects auto,-squeeze"
"""Command that writes the result."""

ROUGHNESS = (0.1e-6, 0.3e-6, 0.5e-6)
"""Ra of the worm's flanks for which the standards are asked [m]; the least they know is 0.1 um or so."""


def main() -> None:
    result = open_result(sys.argv[1])
    loss = drive_cycle(result).loss
    rows = [
        (
            "simulated, smooth surfaces",
            f"{loss.power:.0f} ± {loss.error:.0f}",
            f"{loss.friction:.4f}",
            f"{loss.efficiency * 100:.2f} ± {loss.efficiency_error * 100:.2f} %",
            f"{loss.reverse_efficiency * 100:.2f} %",
            "",
        )
    ]
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
        rows.append(
            (
                f"standard, Ra {roughness * 1e6:.1f} um",
                f"{rated.tooth_loss:.0f}",
                f"{rated.friction:.4f}",
                f"{rated.forward_efficiency * 100:.2f} %",
                f"{rated.backward_efficiency * 100:.2f} %",
                f"{rated.film * 1e6:.2f}",
            )
        )
    efficiencies = "efficiency with the worm driving", "efficiency with the wheel driving"
    columns = ("", "power loss of the teeth / W", "mean friction", *efficiencies, "mean film / um")
    record("zi_efficiency", columns, rows, first=FIRST)


if __name__ == "__main__":
    main()
