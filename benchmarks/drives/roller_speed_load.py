"""Extremes of films, temperatures and asperity contact of the roller drive over speed and load, solved.

python benchmarks/drives/roller_speed_load.py  # two minutes
"""

import sys
from pathlib import Path

import pyworm

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_data import ROOT
from evidence_record import record

SPEED, POWER = "operation.worm_speed", "operation.power"

COLUMNS = (
    "worm speed / rpm", "power / kW", "contacts", "with heat",
    "minimum film thickness / um", "uncertainty / %", "specific film thickness",
    "maximum film temperature / degC", "maximum surface temperature / degC",
    "maximum asperity load ratio / %",
)  # fmt: skip


def main() -> None:
    """Extremes at each operating point, of films and temperatures where heat is simulated."""
    table = pyworm.sweep(ROOT / "cases" / "sweeps" / "roller_speed_load.toml").table.to_dataframe()
    points = table.groupby([SPEED, POWER])
    record("roller_speed_load", COLUMNS, [extremes(point, some) for point, some in points])


def extremes(point, contacts):
    """A row of the table, of the contacts of one speed and power."""
    heated = contacts[contacts.effects.str.contains("film-heating")]
    thinnest = heated.loc[heated.film_min_m.idxmin()]
    surfaces = heated[["temperature_max_C_body_1", "temperature_max_C_body_2"]]
    return (
        *(f"{value:g}" for value in point), len(contacts), len(heated), f"{thinnest.film_min_m * 1e6:.3f}",
        f"{100 * thinnest.film_min_error:.1f}", f"{thinnest.lambda_min:.2f}",
        f"{heated.temperature_max_C_film.max():.0f}", f"{surfaces.max(axis=None):.1f}",
        f"{100 * heated.asperity_load_fraction.max():.2f}",
    )  # fmt: skip


if __name__ == "__main__":
    main()
