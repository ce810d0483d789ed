"""What the gap of a worm drive's flanks costs on 257 x 257 nodes, by profile.

    python benchmarks/cost/worm_gaps.py

Processor time of `ToothGap` over the tangent plane in mid-mesh of the drive of
`benchmarks/validation/worm_profiles.py` (a = 100 mm, 2/39), heights of both flanks and tooth boundaries
included, in two windows: one within the teeth, and one of which a part lies beyond the ends of the flanks.
Profiles take turns; the least of `TURNS` counts. Beside it the ratio to ZI, whose flanks are closed forms,
and the part of the nodes that both teeth cover.
"""

from math import pi
from time import process_time

import numpy as np

from pyworm.drives.zi_worm.drawing import completed
from pyworm.drives.zi_worm.gears import ZiWormGears
from pyworm.drives.zi_worm.hob_setting import drawn_gears, with_swivel
from pyworm.formulas.worm_profiles import PROFILES

NODES, TURNS = 257, 7

WINDOWS = {"12 x 2 mm": (6e-3, 1e-3), "36 x 10 mm": (18e-3, 5e-3)}
"""Name of a window -> its half sides [m]."""


def gears(profile: str) -> ZiWormGears:
    """The drive with flanks of a profile, its hob set up as usual."""
    of, _ = completed(
        {
            "centre_distance": 0.1,
            "threads": 2,
            "teeth": 39,
            "module": 4e-3,
            "diameter_factor": 9.5,
            "pressure_angle": pi / 9,
            "face_width": 30e-3,
            "hob_oversize": 1.6e-3,
        },
        profile,
    )
    return drawn_gears(with_swivel(of)[0])


def seconds(of: ZiWormGears, half: tuple[float, float]) -> tuple[float, float]:
    """Processor time of one gap [s] and the part of its nodes that is covered."""
    x, y = np.meshgrid(*(np.linspace(-side, side, NODES) for side in half), indexing="ij")
    contact = of.cycle.contact(0.5)
    start = process_time()
    _, covered = of.gap(contact)(x, y)
    return process_time() - start, float(covered.mean())


def main() -> None:
    drives = {profile: gears(profile) for profile in PROFILES}
    for name, half in WINDOWS.items():
        print(f"| {name} | s | over ZI | covered |\n|---|---|---|---|")
        runs = [
            {profile: seconds(of, half) for profile, of in drives.items()} for _ in range(TURNS)
        ]
        least = {profile: min(run[profile] for run in runs) for profile in drives}
        for profile, (time, covered) in least.items():
            print(f"| {profile} | {time:.3f} | {time / least['ZI'][0]:.1f} | {covered:.2f} |")


if __name__ == "__main__":
    main()
