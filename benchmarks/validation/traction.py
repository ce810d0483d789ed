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

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

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


COLUMNS = (
    "Hertz pressure / GPa",
    "slide-roll ratio",
    "friction",
    "uncertainty",
    "h_c / nm",
    "h_min / nm",
    "T_max of body 1 / degC",
    "T_max of body 2 / degC",
    "T_max of the film / degC",
    "heat balance / %",
    "stop reason",
)


def row(pressure: float, solution: Solution) -> tuple[str, ...]:
    """A row of the table, under `COLUMNS`."""
    figures = solution.figures
    friction = figures.friction_coefficient
    heat = (rise(solution, place) for place in ("body_1", "body_2", "film"))
    return (
        f"{pressure:g}",
        f"{solution.slide_roll_ratio:g}",
        f"{friction.value:.4f}",
        f"{friction.error * 100:.2f} %",
        f"{figures.film_central.value * 1e9:.1f}",
        f"{figures.film_min.value * 1e9:.1f}",
        *(f"{value:.1f} ± {error:.2f}" for value, error in heat),
        f"{figures.heat_balance * 100:.3f}",
        "" if solution.converged else str(solution.stop_reason),
    )


CHECKS = (
    "Hertz pressure / GPa",
    "friction of rolling",
    "largest friction",
    "at slide-roll ratio",
    "rises before it",
    "falls from there to ratio 2",
    "asymmetry",
)


def checks(
    pressure: float, curve: Sequence[Solution], mirrored: Sequence[Solution]
) -> tuple[str, ...]:
    """What a traction curve must show, under `CHECKS`."""
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
        f"{pressure:g}",
        f"{abs(forces[0]):.1e}",
        f"{friction[peak]:.4f}",
        f"{to_rest[peak].slide_roll_ratio:g}",
        "yes" if rising else "no",
        f"{(1 - friction[-1] / friction[peak]) * 100:.1f} %" if falling else "no",
        f"{asymmetry:.1e}",
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
    lower.set_ylabel("maximum film temperature / °C")
    lower.set_xlabel("slide-roll ratio (the disc rests at 2)")
    return figure


def main() -> None:
    picture = sys.argv[1] if len(sys.argv) > 1 else "docs/pictures/traction.png"
    curves, rows, verdicts = {}, [], []
    for pressure, load in LOADS.items():
        curves[pressure] = []
        for ratio in RATIOS:
            solution = solve(load, ratio)
            if solution is not None:
                curves[pressure].append(solution)
                rows.append(row(pressure, solution))
                print(*rows[-1], flush=True)
        mirrored = [back for back in (solve(load, -ratio) for ratio in MIRRORED) if back]
        verdicts.append(checks(pressure, curves[pressure], mirrored))
    record("traction", COLUMNS, rows)
    record("traction_checks", CHECKS, verdicts)
    draw(curves).savefig(picture, dpi=120)


if __name__ == "__main__":
    main()
