"""Traction curves of steel on steel at three Hertz pressures, rolling to opposite sliding, with their checks.

The contact is that of cases/traction_steel.toml under three loads. Run from the repository's root (it takes
two to four minutes):

    python benchmarks/validation/traction.py [PICTURE.png]
"""

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import pyworm
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.kernel.core import KernelError
from pyworm.solver.solution import Solution

LOADS = {0.7: 14.18, 1.0: 41.33, 1.5: 139.5}
"""Load [N] for each Hertz pressure [GPa]."""

RATIOS = (0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 1.5, 1.9, 2, 2.1, 2.5, 3, 4)
MIRRORED = (0.02, 0.5, 3)
"""Ratios that are solved with the bodies exchanged too."""

ACCURACY = 0.03


def solve(load: float, ratio: float) -> Solution | None:
    """The contact under a load [N] at a slide-roll ratio; None, and told so, if the kernel gives up."""
    case = pyworm.load(Path("cases/traction_steel.toml"))
    scene = replace(case.scene(slide_roll_ratio=ratio), load=load)
    try:
        return pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "all"))
    except KernelError as error:
        print(f"{load:g} N, {scene.name}: {error}")
        return None


def traction(solution: Solution) -> float:
    """Force on body 1 along the mean velocity over the load."""
    fields = solution.fields
    cell = float(np.diff(fields.x)[0] * np.diff(fields.y)[0])
    return float(fields.shear_stress_x.where(fields.pressure > 0, 0).sum()) * cell / solution.load


def rise(solution: Solution, place: str) -> tuple[float, float]:
    """A largest temperature [degC] and its error [K]."""
    estimate = getattr(solution.figures, f"temperature_max_{place}")
    above = estimate.value - solution.inlet_temperature
    return estimate.value - ZERO_CELSIUS, abs(above) * estimate.error


def row(pressure: float, solution: Solution) -> str:
    """A line of the table."""
    figures = solution.figures
    friction = figures.friction_coefficient
    heat = " ".join(
        f"{value:7.1f} ± {error:4.2f}"
        for value, error in (rise(solution, place) for place in ("body_1", "body_2", "film"))
    )
    return (
        f"{pressure:4.1f} {solution.slide_roll_ratio:6.3f}"
        f" {friction.value:9.5f} ± {friction.error * 100:4.2f} %"
        f" {figures.film_central.value * 1e9:8.1f} {figures.film_min.value * 1e9:7.1f}  {heat}"
        f" {figures.heat_balance * 100:7.3f} {'' if solution.converged else solution.stop_reason}"
    )


def checks(curve: Sequence[Solution], mirrored: Sequence[Solution]) -> str:
    """What a traction curve must show."""
    to_rest = [solution for solution in curve if solution.slide_roll_ratio <= 2]
    friction = np.array([solution.figures.friction_coefficient.value for solution in to_rest])
    peak = int(np.argmax(friction))
    rising = bool(np.all(np.diff(friction[: peak + 1]) > 0))
    falling = bool(np.all(np.diff(friction[peak:]) < 0))
    forces = {solution.slide_roll_ratio: traction(solution) for solution in curve}
    asymmetry = max(
        abs(1 + traction(back) / forces[-back.slide_roll_ratio])
        for back in mirrored
        if -back.slide_roll_ratio in forces
    )
    return (
        f"rolling {abs(forces[0]):.1e}; "
        f"peak {friction[peak]:.4f} at {to_rest[peak].slide_roll_ratio:g}, "
        f"{'rising' if rising else 'NOT RISING'} before it, "
        f"{'falling' if falling else 'NOT FALLING'} from there to {to_rest[-1].slide_roll_ratio:g} "
        f"by {1 - friction[-1] / friction[peak]:.1%}; asymmetry {asymmetry:.1e}"
    )


def draw(curves: dict[float, Sequence[Solution]]) -> Figure:
    """Friction and largest film temperature of all curves, with error bars."""
    figure = Figure(figsize=(8, 7), layout="constrained")
    upper, lower = figure.subplots(2, sharex=True)
    for (pressure, curve), colour in zip(
        curves.items(), ("tab:blue", "tab:green", "tab:red"), strict=True
    ):
        style = {"fmt": "o-", "color": colour, "capsize": 3, "markersize": 4}
        ratios = [solution.slide_roll_ratio for solution in curve]
        friction = [solution.figures.friction_coefficient for solution in curve]
        error = [estimate.value * estimate.error for estimate in friction]
        values = [estimate.value for estimate in friction]
        upper.errorbar(ratios, values, error, label=f"{pressure:g} GPa", **style)
        values, error = zip(*(rise(solution, "film") for solution in curve), strict=True)
        lower.errorbar(ratios, values, error, **style)
    for axes in (upper, lower):
        axes.grid(True, color="0.9")
    upper.set_ylabel("friction coefficient")
    upper.set_ylim(bottom=0)
    upper.legend(frameon=False, title="Hertz pressure")
    lower.set_ylabel("largest temperature of the film / °C")
    lower.set_xlabel("slide-roll ratio (the disc rests at 2)")
    return figure


def main() -> None:
    picture = sys.argv[1] if len(sys.argv) > 1 else "docs/pictures/traction.png"
    print(
        " GPa  ratio  friction             central minimum nm   body 1        body 2         film degC"
        "      heat balance %"
    )
    curves, verdicts = {}, []
    for pressure, load in LOADS.items():
        curves[pressure] = []
        for ratio in RATIOS:
            solution = solve(load, ratio)
            if solution is not None:
                curves[pressure].append(solution)
                print(row(pressure, solution), flush=True)
        mirrored = [back for back in (solve(load, -ratio) for ratio in MIRRORED) if back]
        verdicts.append(f"{pressure:g} GPa: {checks(curves[pressure], mirrored)}")
    print("\n".join(verdicts))
    draw(curves).savefig(picture, dpi=120)


if __name__ == "__main__":
    main()
