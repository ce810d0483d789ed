"""Line contacts in place of ellipses of the same largest pressure, entrained across their long axis.

What `planning.effects.geometry` knows of the influence of the second dimension. Films on one grid of each, so
that a few tenths of a percent are the grids'. Run from the repository's root:

    python benchmarks/accuracy/line_for_point.py
"""

from plan_scenes import STEEL, mineral, point
from plans import on_one_grid

import pyworm
from pyworm.planning.prediction import predicted

RATIOS = (3, 10, 30, 100, 1000)
THICK, THIN = mineral(0.1, 2e-8), mineral(0.04, 2e-8)
ROLLING, SLIDING = ((0.3, 0.0), (0.3, 0.0)), ((1.1, 0.0), (0.9, 0.0))
CONTACTS = (("rolling", 17.0, THICK, ROLLING), ("sliding, hot", 100.0, THIN, SLIDING))


def main() -> None:
    print(
        f"{'':14} {'Ry/Rx':>6} {'b/a':>6} {'GPa':>5} {'minimum':>8} {'central':>8} friction, temperatures"
    )
    for name, load, oil, velocities in CONTACTS:
        effects = "all" if name != "rolling" else "isothermal"
        for ratio in RATIOS:
            scene = point(
                name, (0.01, 0.01 * ratio), load * ratio**0.5, velocities, (STEEL,) * 2, oil
            )
            whole, line = (
                on_one_grid(scene, pyworm.plan(scene, 0.02, effects + less))
                for less in ("", ",-second-dimension")
            )
            size = predicted(scene)
            apart = [b / a - 1 for a, b in zip(whole.film, line.film, strict=True)]
            if whole.rises:
                apart.append(line.friction / whole.friction - 1)
                apart += [b / a - 1 for a, b in zip(whole.rises, line.rises, strict=True)]
            print(
                f"{name:14} {ratio:6} {size.half_width / size.half_length:6.3f} "
                f"{size.pressure_max / 1e9:5.2f} " + " ".join(f"{change:8.2%}" for change in apart),
                flush=True,
            )


if __name__ == "__main__":
    main()
