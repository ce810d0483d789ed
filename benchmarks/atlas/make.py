"""Solve the contacts of the atlas that its table does not have yet, to certified films.

    python benchmarks/atlas/make.py atlas/films.csv STORE [--upto 4000] [--largest-grid 1000000] [--again]
    python benchmarks/atlas/make.py atlas/thermal.csv STORE --thermal --upto 1500 --largest-grid 100000

Each part of the sequence is a sweep, whose solved scenes are kept in STORE, and is added to the table as soon
as it is solved; the same command continues where it was stopped. `--again` solves those that are not
certified once more, on the larger grids given. A contact without a film has a row that says why.
"""

import argparse
import math
import sys
import time
import warnings
from collections.abc import Sequence
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.contacts import contact, order, sequence
from atlas.table import read, write
from atlas.thermal_contacts import BETA, INLET, heats, thermal_contact, thermal_order

import pyworm
from pyworm.formulas.hertz import hertz
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

ACCURACY, THERMAL_ACCURACY = 0.005, 0.05
"""Relative error of central and least film at which contacts are certified [-]: isothermal, and thermal."""

PART = 25
"""Contacts solved in one sweep, and added to the table together."""


def solved(numbers: Sequence[int], store: Path, largest_grid: int, thermal: bool) -> list[dict]:
    """Rows of the table for some contacts; those without a solution have a reason and no films."""
    make = thermal_contact if thermal else contact
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore", pyworm.UnusualWarning
        )  # realisations of groups, no machines
        result = pyworm.sweep(
            make,
            out=store,
            accuracy=THERMAL_ACCURACY if thermal else ACCURACY,
            effects="all" if thermal else "isothermal",
            quantities=("film",),
            progress=False,
            largest_grid=largest_grid,
            number=numbers,
        )
        rows = result.table.to_dataframe().to_dict("records")
        return [
            row(number, of, make(number), heat_columns(number, of) if thermal else {})
            for number, of in zip(numbers, rows, strict=True)
        ]


def heat_columns(number: int, of: dict) -> dict:
    """Groups of heat, friction and largest rise of the film's temperature of a thermal contact."""
    rise = _figure(of, "temperature_max_C_film") + ZERO_CELSIUS - INLET
    return {
        **vars(heats()[number]),
        "friction": _figure(of, "friction_coefficient"),
        "friction_error": _figure(of, "friction_coefficient_error"),
        "warming": BETA * rise,
        "warming_error": _figure(of, "temperature_max_error_K_film", rise),
    }


def _figure(of: dict, key: str, over: float = 1.0) -> float:
    value = of.get(key)
    return float(value) / over if value is not None and over else math.nan


def row(number: int, of: dict, scene: Scene, heat: dict[str, float]) -> dict:
    """One contact's groups, its films in Moes' unit with their bars, and how they were found."""
    groups = sequence()[number]
    dry = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    unit = scales(scene).groups.moes_film
    figure = partial(_figure, of)
    return {
        "number": number,
        **{name: float(value) for name, value in vars(groups).items()},
        "alpha": groups.alpha,
        "alpha_pressure": groups.pressure,
        **heat,
        "film_central": figure("film_central_m", unit),
        "film_central_error": figure("film_central_error"),
        "film_min": figure("film_min_m", unit),
        "film_min_error": figure("film_min_error"),
        "film_min_x": figure("film_min_at_m_x", dry.semi_axis_x),
        "film_min_y": figure("film_min_at_m_y", dry.semi_axis_y),
        "film_min_kind": of.get("film_min_kind") or "",
        "film_exit_min": figure("film_exit_min_m", unit),
        "film_lift": figure("film_lift_m", unit),
        "pressure_max": figure("pressure_max_Pa", dry.pressure_max),
        "pressure_max_error": figure("pressure_max_error"),
        "certified": int(bool(of["accurate"] == 1.0)),
        "status": of["stop_reason"],
        "grid_x": figure("grid_x"),
        "grid_y": figure("grid_y"),
        "convolutions": figure("convolutions"),
        "seconds": figure("seconds"),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("store", type=Path)
    parser.add_argument("--upto", type=int, default=4000)
    parser.add_argument("--largest-grid", type=int, default=1_000_000)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--thermal", action="store_true")
    given = parser.parse_args()
    rows = read(given.table)
    wanted = [
        number
        for number in (thermal_order() if given.thermal else order())[: given.upto]
        if number not in rows or (given.again and rows[number]["certified"] == "0")
    ]
    for first in range(0, len(wanted), PART):
        numbers = wanted[first : first + PART]
        before = time.process_time()
        new = solved(numbers, given.store, given.largest_grid, given.thermal)
        rows |= {one["number"]: one for one in new}
        write(given.table, rows)
        certified = sum(one["certified"] for one in new)
        print(
            f"{len(rows)} contacts; {certified} of the last {len(new)} certified, "
            f"{time.process_time() - before:.1f} s of processor",
            flush=True,
        )


if __name__ == "__main__":
    main()
