"""What few levels across the film cost in accuracy: figures against those with 13, on one and the same grid.

3 levels are the mean-film model, a parabola. The grid is the one at which 3 % are reached; Newton and heat go
on until they leave less than the levels do. Relative errors, those of temperatures over the rise above the
inlet's; `planning.model.LEVEL_ERRORS` is the worst of each number of levels. Run from the repository's root
(it takes minutes):

    python benchmarks/accuracy/levels.py
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.planning.model import Model
from pyworm.scene.line import LineScene
from pyworm.scene.point import RigidMotion, Scene
from pyworm.solver.solution import Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

LEVELS = (3, 5, 7, 9, 11)
REFERENCE = 13
FIGURES = (
    "film_central",
    "film_min",
    "friction_coefficient",
    "temperature_max_body_1",
    "temperature_max_body_2",
    "temperature_max_film",
)
CASES = ("zi_paraboloid", "zi_drive", "spur_pair", "ball_pag_460", "errichello_optimised_addenda")
VERGE = ((1, 41.33, 2.2, 2.4), (1.5, 139.5, 2.5, 2.9), (2, 330.6, 2.9, 1.5), (1, 41.33, 3.5, 1.2))
"""Largest pressure [GPa], load [N], mean speed [m/s] and slide-roll ratio of steel about the verge of the
films that are calm enough for five levels (`planning.model.CALM_GRAETZ`), the last beyond it."""
UNFINISHED = 1e-5
"""Residual, and error of the films by unfinished algebra, at which a solve ends."""


def scenes() -> Iterator[tuple[str, Scene | LineScene]]:
    """The worm at mid-mesh, other cases, and steel on steel: sliding, on a disc at rest, against it, fast."""
    yield "worm, phase 0.5", pyworm.load(Path("cases/zi_sharif_2001.toml")).scene(phase=0.5)
    for case in CASES:
        yield case, pyworm.load(Path(f"cases/{case}.toml")).scene()
    steel = pyworm.load(Path("cases/traction_steel.toml"))
    for pressure, load in ((1, 41.33), (1.5, 139.5)):
        for ratio in (0.5, 2):
            yield (
                f"steel, {pressure} GPa, {ratio}",
                replace(steel.scene(slide_roll_ratio=ratio), load=load),
            )
    yield "steel, 1 GPa, 5", steel.scene(slide_roll_ratio=5)
    for pressure, load, speed, ratio in ((1, 41.33, 5.0, 2.0), *VERGE):
        motions = tuple(RigidMotion(speed * (1 + of * ratio / 2), 0.0) for of in (1, -1))
        yield (
            f"steel, {pressure} GPa, {ratio:g}, {speed:g} m/s",
            replace(steel.scene(slide_roll_ratio=2), load=load, motions=motions),
        )


def solve(scene: Scene | LineScene, levels: int) -> Solution:
    """The scene on the grid of 3 %, with so many levels."""
    plan = pyworm.plan(scene, 0.03, ("all", "-roughness", "-squeeze"))
    return pyworm.solve(
        scene,
        replace(
            plan,
            accuracy=10 * UNFINISHED,
            model=Model(levels, heated=True),
            wider_grids=(),
            largest_grid=plan.grids[-1].finer().nodes,
            tolerance=UNFINISHED,
        ),
    )


def values(solution: Solution) -> dict[str, float]:
    """Figures by name, temperatures above the inlet's."""
    inlet = solution.inlet_temperature
    found = {name: getattr(solution.figures, name).value for name in FIGURES}
    return {
        name: value - inlet if name.startswith("temperature") else value
        for name, value in found.items()
    }


def main() -> None:
    rows = []
    for name, scene in scenes():
        best = values(solve(scene, REFERENCE))
        for levels in LEVELS:
            try:
                solution = solve(scene, levels)
            except KernelError as error:
                print(f"{name:28} {levels:6} {error}", flush=True)
                continue
            errors = [abs(value / best[of] - 1) for of, value in values(solution).items()]
            rows.append((name, levels, f"{max(errors) * 100:.3f} %"))
            print(*rows[-1], f"residual {solution.figures.residual:.1e}", flush=True)
    record("levels", ("contact", "levels", "largest error"), rows)


if __name__ == "__main__":
    main()
