"""How many contacts of random roller worms converge: shapes, sizes, oils, both directions, turning rollers.

    python benchmarks/drives/roller_contacts.py [--seed N] [--count N] [--accuracy "10 %"]

Each is one line contact at a random place of a random gear set that the checks accept, with its history where
films change while oil passes. One line for each, and how many converged.
"""

import argparse
import csv
from pathlib import Path
from time import process_time

import numpy as np

import pyworm
from pyworm.io.input_error import CaseError

OILS = ("mineral VG 150", "mineral VG 320", "PAO VG 220", "PAG VG 460")
SHAPES = ("cylinder",) * 6 + ("cone", "ball")


def drawn(random: np.random.Generator) -> dict:
    """Tables of a random roller worm; not all can be made."""
    scale = float(np.exp(random.uniform(np.log(0.5), np.log(2.0))))
    shape = SHAPES[random.integers(len(SHAPES))]
    torque = random.uniform(0.1, 1.0) * 1100 * scale**3
    radius = 6.5 * scale * random.uniform(0.8, 1.15)
    rollers = {
        "count": int(random.integers(28, 44)),
        "radius": f"{radius:.4g} mm",
        "length": f"{(14 if shape != 'ball' else 9) * scale:.4g} mm",
        "shape": shape,
        "tilt": f"{random.choice([0.0, 0.0, 15.0, 30.0])} deg",
    }
    if shape == "cone":
        rollers["half_angle"] = f"{random.uniform(-6, 6):.3g} deg"
    if random.random() < 0.5:
        rollers["pin"] = {
            "radius": f"{0.4 * radius:.3g} mm",
            "friction": float(f"{random.uniform(0.001, 0.02):.2g}"),
        }
    depth = (6 if shape != "ball" else 4) * scale
    steel = {"material": "16MnCr5"}
    return {
        "title": "a random roller worm",
        "source": "drawn at random",
        "drive": {
            "kind": "roller-worm",
            "centre_distance": f"{160 * scale:.4g} mm",
            "worm": {
                "threads": int(random.choice([1, 1, 2])),
                "hand": str(random.choice(["right", "left"])),
                "throat_coefficient": float(f"{random.uniform(0.36, 0.5):.3g}"),
                "throat_angle": f"{random.uniform(4, 8):.3g} deg",
                "outer_angle": f"{random.uniform(35, 60):.3g} deg",
                "addendum": f"{depth:.4g} mm",
                "dedendum": f"{depth:.4g} mm",
            },
            "rollers": rollers,
        },
        "operation": {
            "wheel_torque": f"{torque:.4g} N m",
            "worm_speed": f"{np.exp(random.uniform(np.log(60), np.log(3000))):.4g} rpm",
            "preload": f"{0.1 * torque:.4g} N m",
            "rolling": str(random.choice(["dynamic", "free"])),
            "driving": str(random.choice(["left", "right"])),
            "phases": [0.5],
            "stations": [0.5],
        },
        "bodies": {
            "worm": steel | {"roughness": "0.4 um"},
            "rollers": steel | {"roughness": "0.2 um"},
        },
        "oil": {
            "name": str(random.choice(OILS)),
            "temperature": f"{random.uniform(40, 90):.3g} degC",
        },
    }


def main() -> None:
    """Solve the contacts and count."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=55)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--accuracy", default="10 %")
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    rows, number, refused = [], 0, 0
    while len(rows) < options.count:
        random = np.random.default_rng([options.seed, number])
        number += 1
        tables = drawn(random)
        section = str(random.choice(["left", "right"]))
        phase, station = float(random.uniform(0, 1)), float(random.uniform(0.05, 0.95))
        try:
            case = pyworm.load(tables)
        except CaseError:
            refused += 1
            continue
        began = process_time()
        row = {"number": number - 1, "section": section, "phase": f"{phase:.3f}"}
        row |= {name: tables["operation"][name] for name in ("rolling", "driving", "worm_speed")}
        row["shape"] = tables["drive"]["rollers"]["shape"]
        try:
            scene = case.drive.scene(section, phase, station)
            solution = pyworm.solve(scene, pyworm.plan(scene, options.accuracy))
            film = solution.figures.film_min
            row |= {
                "converged": solution.converged,
                "film_min_um": f"{film.value * 1e6:.4g}",
                "transient": solution.held("life") is not None,
                "reason": "" if solution.converged else solution.stop_reason,
            }
        except (ValueError, RuntimeError) as error:
            row |= {"converged": False, "film_min_um": "", "transient": "", "reason": str(error)}
        row["seconds"] = f"{process_time() - began:.1f}"
        rows.append(row)
        print(*row.values(), flush=True)
    good = sum(row["converged"] for row in rows)
    print(f"{good} of {len(rows)} converged; {refused} draws cannot be made")
    if options.out is not None:
        with options.out.open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0])
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
