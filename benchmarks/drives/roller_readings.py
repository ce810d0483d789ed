"""Which reading of the roller drive comes nearest its source's table of k, by the source's formula.

python benchmarks/drives/roller_readings.py        # half a minute
"""

from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
from roller_tables import ENDS, SOURCE

import pyworm
from pyworm.drives.roller_worm.motion import line_motion
from pyworm.formulas.roller_enveloping import printed_minimum
from pyworm.materials.body import reduced_modulus

CASE = Path(__file__).parents[2] / "cases" / "roller_ref.toml"
TILTS, HEIGHTS, OUTER = (0, 30, 60, 90), (-20, -10, 0, 10, 20), (50, 60, 70)
LOAD = 83.4e3
"""The source's normal force on 12 mm [N/m]."""


def main():
    drive = pyworm.load(CASE).drive
    table = SOURCE["throat_coefficient"]
    found, undercut = [], 0
    for tilt, height, outer, rolling in product(TILTS, HEIGHTS, OUTER, ("locked", "rolling")):
        films = [film(drive, k, tilt, height, outer, rolling) for k in table]
        if any(one is None for one in films):
            undercut += 1
            continue
        off = np.log(np.array(films) / np.array(list(table.values())))
        found.append((np.sqrt(np.mean(off**2)), tilt, height, outer, rolling, films))
    print(f"{undercut} readings are undercut\n")
    print(
        "| tilt | height mm | to | rollers | rms off | k = 0.4: left entry, exit, right entry, exit |"
    )
    print("|---|---|---|---|---|---|")
    found.sort(key=lambda one: one[0])
    plain = [one for one in found if one[1:3] == (0, 0) and one[3] == 60]
    for off, tilt, height, outer, rolling, films in [*found[:8], *plain]:
        shown = ", ".join(f"{one:.3f}" for one in films[1])
        print(f"| {tilt} | {height} | {outer} | {rolling} | {off:.0%} | {shown} |")


def film(drive, throat, tilt, height, outer, rolling):
    """The source's minimum films [um] in the middle of the line, by `ENDS`; None where undercut."""
    films = []
    for section, phase, _ in ENDS:
        flank = replace(
            drive.sections[section].envelope,
            tilt=np.radians(tilt),
            height=height * 1e-3,
            pitch_radius=drive.centre_distance * (1 - throat / 2),
        )
        side = 1 if section == "left" else -1
        at_throat = (phase == 0.0) == (section == "left")
        contact = flank.contact(
            np.linspace(-6e-3, 6e-3, 7), side * np.radians(5 if at_throat else outer)
        )
        if not (contact.limit > 0).all():
            return None
        motion = line_motion(flank, contact, drive.wheel_speed, 0.0)
        if rolling == "rolling":
            speed = np.mean((motion.round_worm - motion.round_roller) / contact.radius)
            motion = line_motion(flank, contact, drive.wheel_speed, speed)
        films.append(
            1e6
            * printed_minimum(
                1 / contact.curvature[3],
                LOAD,
                reduced_modulus(*drive.bodies),
                motion.entrainment[3],
                drive.oil.viscosity.eta0,
                drive.oil.viscosity.alpha,
            )
        )
    return films


if __name__ == "__main__":
    main()
