"""A duty of a gear unit as tables, sentences and comma-separated values."""

import csv
import io
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from pyworm.batch.duty_run import ENERGY, CaseDuty
from pyworm.drives.gear_unit import DAY, HOUR
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.report.table import Table

KWH = 3.6e6
"""A kilowatt-hour [J]."""

MAX_ROWS = 24
"""Largest number of blocks in the table; more are in the file alone."""


def blocks_table(found: CaseDuty) -> Table:
    """Load, temperatures, loss and film of the blocks."""
    friction, film = QUANTITIES["friction_coefficient"], QUANTITIES["film_min"]
    head = (
        *("Block", "h", "rpm", "N m", "Oil\n°C", "Max.\n°C", "Teeth\nW", "Lost\nkWh"),
        *(friction.column, film.column, QUANTITIES["asperity_load_fraction"].column),
    )
    rows = []
    for block in found.blocks[:MAX_ROWS]:
        turning = (
            ("", "", "")
            if block.film_min is None
            else (
                f"{block.friction:.4f}",
                f"{film.number(block.film_min):.3g}",
                f"{100 * (block.asperity_load_fraction or 0.0):.3g}",
            )
        )
        rows.append(
            (
                *(block.name, f"{block.duration / HOUR:.4g}", f"{block.speed * RPM:.4g}"),
                *(f"{block.torque:.4g}", f"{block.temperatures['oil'] - ZERO_CELSIUS:.1f}"),
                *(f"{block.oil_max - ZERO_CELSIUS:.1f}", f"{block.tooth_loss:.4g}"),
                f"{block.energy_lost / KWH:.3g}",
                *turning,
            )
        )
    return Table(head, tuple(rows), found.heading, narrow=True)


def damage_table(found: CaseDuty) -> Table:
    """What each kind of damage comes to, and by which block."""
    shares, lives, decisive = found.shares, found.lives_h, found.decisive
    rows = [
        (
            name,
            f"{part:.3g}",
            f"{lives[name]:.4g}" if name in lives else "unlimited",
            _by(name, decisive, shares),
        )
        for name, part in found.damage.items()
    ]
    energy = f"{found.energy_lost / KWH:.3g} kWh"
    rows.append(("energy lost", energy, "", _by(ENERGY, decisive, shares)))
    return Table(
        ("", "Miner sum\nof the duty", "Life\nh", "Most by"), tuple(rows), "Damage", narrow=True
    )


def _by(name: str, decisive: dict[str, str], shares: dict[str, tuple[float, ...]]) -> str:
    if name not in decisive:
        return ""
    return f"{decisive[name]} ({100 * max(shares[name]):.0f} %)"


def words(found: CaseDuty) -> Iterator[str]:
    """Energy a day and a year, wear, and what is not rated."""
    times, energy, out = found.periods_per_year, found.energy_lost, found.energy_out
    efficiency = 100 * out / (out + energy)
    yield f"Energy: {energy / KWH:.4g} kWh lost, {out / KWH:.4g} kWh given on, efficiency {efficiency:.1f} %."
    if times is not None:
        a_day = energy * DAY / found.model.cycle.duration / KWH
        yield f"Lost in a day {a_day:.4g} kWh, in a year {energy * times / KWH:.4g} kWh."
    for name, depth in found.wear.items():
        a_year = "" if times is None else f", {1e6 * depth * times:.3g} µm in a year"
        yield f"Wear of the {name}: {1e6 * depth:.3g} µm in the duty{a_year}."
    yield f"Heat balance closed to {found.imbalance:.1g} of the energy lost."
    for sentence in found.not_rated:
        yield f"Not rated: {sentence}."


def blocks_csv(found: CaseDuty) -> str:
    """A row for each block."""
    blocks = found.summary()["blocks"]
    return as_csv(list(map(_flat, blocks)))


def temperatures_csv(found: CaseDuty) -> str:
    """Temperatures of all nodes [degC] and the energy lost [J] over time [h]."""
    history = found.model.history
    nodes = {
        f"{node.replace(' ', '_')}_temperature_C": values - ZERO_CELSIUS
        for node, values in history.temperatures.items()
    }
    columns = {"time_h": history.time / HOUR, **nodes, "energy_lost_J": history.dissipated}
    rows = zip(*columns.values(), strict=True)
    return as_csv([dict(zip(columns, row, strict=True)) for row in rows])


def _flat(block: dict[str, Any]) -> dict[str, Any]:
    """A block with wear and damage as columns."""
    rest = {key: value for key, value in block.items() if key not in ("wear_m", "damage")}
    wear = {f"wear_{name}_m": value for name, value in (block["wear_m"] or {}).items()}
    damage = {
        f"damage_{name.replace(' ', '_')}": value for name, value in (block["damage"] or {}).items()
    }
    return rest | wear | damage


def as_csv(rows: Sequence[dict[str, Any]]) -> str:
    """Rows by name as comma-separated values; cells that a row lacks are empty."""
    text = io.StringIO()
    names: Iterable[str] = dict.fromkeys(name for row in rows for name in row)
    writer = csv.DictWriter(text, list(names), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({name: _cell(value) for name, value in row.items()})
    return text.getvalue()


def _cell(value: Any) -> str:
    return "" if value is None else value if isinstance(value, str) else f"{value:.9g}"
