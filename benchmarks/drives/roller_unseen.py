"""Contacts of roller drives of drawn sizes, loads, speeds and oils, of every variant: whether they converge.

python benchmarks/drives/roller_unseen.py          # three minutes
python benchmarks/drives/roller_unseen.py dynamic  # rollers by their equation of motion, both directions
"""

import sys
import time
import tomllib
from pathlib import Path

import numpy as np

import pyworm

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_data import ROOT
from evidence_record import record

CONTACTS, SEED = 48, 2027

DYNAMIC_CONTACTS, DYNAMIC_SEED = 40, 5501

COLUMNS = (
    "variant", "sizes", "contact", "maximum pressure / MPa", "minimum film thickness / um",
    "uncertainty / %", "converged", "time / s",
)  # fmt: skip


def main():
    dynamic = "dynamic" in sys.argv
    contacts, seed = (DYNAMIC_CONTACTS, DYNAMIC_SEED) if dynamic else (CONTACTS, SEED)
    rng = np.random.default_rng(seed)
    names = sorted(path.stem for path in (ROOT / "cases" / "rollers").glob("*.toml"))
    rows, refused = [], 0
    while len(rows) < contacts:
        name = names[len(rows) % len(names)]
        tables, words = drawn(rng, name)
        if dynamic:
            driving = str(rng.choice(["left", "right"]))
            tables["operation"] |= {"rolling": "dynamic", "driving": driving}
            words += f", {driving} drives"
        section, phase, station = str(rng.choice(["left", "right"])), rng.uniform(), rng.uniform()
        try:
            scene = pyworm.load(tables).scene(
                section=section, phase=round(phase, 3), station=round(station, 3)
            )
        except ValueError:  # undercut, no thread left, or a station without load
            refused += 1
            continue
        start = time.perf_counter()
        solution = pyworm.solve(scene, pyworm.plan(scene, 0.1, "auto"))
        figures = solution.figures
        rows.append(
            (name, words, scene.name, f"{figures.pressure_max.value * 1e-6:.0f}",
             f"{figures.film_min.value * 1e6:.3f}", f"{100 * figures.film_min.error:.1f}",
             "yes" if solution.converged else solution.stop_reason,
             f"{time.perf_counter() - start:.1f}")
        )  # fmt: skip
    record("roller_unseen_dynamic" if dynamic else "roller_unseen", COLUMNS, rows)
    print(
        f"{sum(row[-2] == 'yes' for row in rows)} of {contacts} converged; {refused} drives refused"
    )


def drawn(rng, name):
    """Tables of a variant with drawn values, and these in words."""
    tables = tomllib.loads((ROOT / "cases" / "rollers" / f"{name}.toml").read_text())
    scale, throat = rng.uniform(0.5, 2), round(rng.uniform(0.3, 0.6), 3)
    drive, worm, rollers = tables["drive"], tables["drive"]["worm"], tables["drive"]["rollers"]
    factors = {"radius": rng.uniform(0.7, 1.2), "length": rng.uniform(1.0, 1.2)}
    for table, keys in (
        (worm, ("addendum", "dedendum")),
        (rollers, ("radius", "length", "height")),
    ):
        for key in keys:
            if key in table:
                value = float(table[key].split()[0]) * scale * factors.get(key, 1.0)
                table[key] = f"{value:.4f} mm"
    drive["centre_distance"] = f"{160 * scale:.3f} mm"
    worm["throat_coefficient"] = throat
    worm["hand"] = str(rng.choice(["left", "right"]))
    if name == "face":
        rollers["height"] = f"{-80 * throat * scale:.4f} mm"
    if name == "barrel":
        radius = 0.06 * scale * rng.uniform(0.5, 3)
        rollers["meridian"]["formula"] = f"sqrt({radius:.5f}^2 - s^2) - {radius:.5f}"
    speed = float(np.exp(rng.uniform(np.log(100), np.log(3000))))
    power = 5e3 * scale**3 * speed / 1500 * float(np.exp(rng.uniform(np.log(0.2), np.log(1.5))))
    tables["operation"] |= {"worm_speed": f"{speed:.0f} rpm", "power": f"{power:.0f} W"}
    tables["operation"]["preload"] = f"{110 * scale**3 * rng.uniform(0.3, 3):.1f} N m"
    eta = round(float(np.exp(rng.uniform(np.log(0.01), np.log(0.3)))), 4)
    tables["oil"]["viscosity"]["eta0"] = f"{eta} Pa s"
    words = f"{drive['centre_distance']}, k {throat}, {speed:.0f} rpm, {power:.0f} W, {eta} Pa s"
    return tables, words


if __name__ == "__main__":
    main()
