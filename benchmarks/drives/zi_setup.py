"""Dry contacts of the worm of Sharif et al. (2001) for other set-ups of the hob (docs/theory/zi-worm.md).

Run from the repository's root: python benchmarks/drives/zi_setup.py
"""

from dataclasses import replace
from math import radians

import pyworm
from pyworm.planning.grid import Grid
from pyworm.scene.scales import scales
from pyworm.solver.figures import contact_extent, maximum
from pyworm.solver.point.level import dry_contact

# Swivel [deg], shift along the wheel's axis [mm], phase at which the pair reproduces the published radii
SET_UPS = (
    (0.255, -0.519, 0.5),
    (0.401, 0.0, 0.5),
    (0.366, -0.216, 0.3),
    (0.302, -0.380, 0.4),
    (0.235, -0.580, 0.55),
    (0.185, -0.731, 0.7),
)
GRID = Grid(west=-18e-3, south=-2.2e-3, dx=36e-3 / 768, dy=4.4e-3 / 256, nx=769, ny=257)


def main() -> None:
    drive = pyworm.load("cases/zi_sharif_2001.toml").drive
    print("swivel deg  shift mm  phase  radii m, mm      dry contact mm   peak MPa")
    for swivel, shift, phase in SET_UPS:
        hob = replace(drive.hob, swivel=radians(swivel), axial_shift=1e-3 * shift)
        scene = replace(drive, hob=hob).scene(phase)
        x, y = GRID.mesh()
        guess = scales(scene).hertz.pressure(x, y)
        dry = dry_contact(scene, GRID, *scene.gap(x, y), guess)
        length, width = contact_extent(GRID, dry.pressure)
        print(
            f"{swivel:10.3f} {shift:9.3f} {phase:6.2f}  {scene.radii[0]:.3f}, {1e3 * scene.radii[1]:.1f}"
            f"      {1e3 * length:.2f} x {1e3 * width:.2f}   {maximum(dry.pressure) / 1e6:6.1f}"
        )


if __name__ == "__main__":
    main()
