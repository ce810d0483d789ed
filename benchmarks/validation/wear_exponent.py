"""Exponent of simulated wear over the film, beside the worm standard's -3.1 +- 0.8 (docs/theory/wear.md).

Run from the repository's root:

    python benchmarks/validation/wear_exponent.py

A rolling line contact of 0.4 GPa with a roughness that stays; its speed makes the film. Archard's wear at one
load goes with the asperities' share of it, the standard's base wear with a power of the film.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

import pyworm
from pyworm.formulas.worm_curves import wear_exponent
from pyworm.scene.scales import line_scales

CASE = Path("cases/line_thermal.toml")

PRESSURE = 0.4e9
"""Largest Hertz pressure [Pa]."""

LAMBDAS = (0.5, 0.7, 1.0, 1.2, 1.45, 1.7, 2.0)
"""Smooth central film over composite roughness, nearly."""


def solved(scene, effects: str | tuple[str, ...]):
    """The scene solved to 2 %."""
    return pyworm.solve(scene, pyworm.plan(scene, 0.02, effects)).figures


def main() -> None:
    heavy = pyworm.load(CASE).scene()
    load = heavy.load * (PRESSURE / line_scales(heavy).hertz.pressure_max) ** 2
    speed = heavy.entrainment
    base = replace(heavy, load=load, velocities=(speed,) * 2)
    film = solved(base, "isothermal").film_central.value
    height = film / np.sqrt(2)  # of each body: lambda is 1 at the case's own speed
    rough = tuple(replace(body, roughness=height) for body in base.bodies)
    films, shares = [], []
    print("| lambda | share of asperities | exponent |\n|---|---|---|")
    for ratio in LAMBDAS:
        faster = speed * ratio ** (1 / 0.7)  # the film goes with the speed to 0.7, nearly
        scene = replace(base, velocities=(faster,) * 2)
        films.append(solved(scene, "isothermal").film_central.value / film)
        figures = solved(replace(scene, bodies=rough), ("isothermal", "roughness"))
        shares.append(figures.asperity_load_fraction.value)
        local = ""
        if len(films) > 1:
            local = f"{np.diff(np.log(shares[-2:]))[0] / np.diff(np.log(films[-2:]))[0]:.2f}"
        print(f"| {films[-1]:.2f} | {shares[-1]:.4f} | {local} |", flush=True)
    within = [1 <= ratio + 0.01 and ratio <= 1.71 for ratio in films]
    fit = np.polyfit(np.log(np.array(films)[within]), np.log(np.array(shares)[within]), 1)[0]
    ends = ", ".join(f"{name} {wear_exponent('mineral', name)}" for name in ("injection", "bath"))
    print(f"\nfitted from 1 to 1.7: {fit:.2f}; standard, mineral oil: {ends}")


if __name__ == "__main__":
    main()
