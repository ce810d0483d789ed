"""A Stribeck curve: friction with its parts, asperities' share and specific films over speed, with both bars.

Run from the repository's root (the sweep takes two to seven minutes):

    pyworm sweep cases/sweeps/stribeck_zi.toml
    python benchmarks/validation/stribeck.py results/stribeck_zi/sweep.nc docs/pictures/stribeck_zi.png
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from pyworm.plots.layout import new_figure
from pyworm.result.sweep_result import SweepResult, open_sweep

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

SPEED, LAMBDAS = "operation.worm_speed", ("lambda_central", "lambda_min")


COLUMNS = (
    "worm speed / rpm",
    "friction",
    "numerical uncertainty",
    "model uncertainty",
    "friction of asperities",
    "friction of oil",
    "asperity load ratio",
    "model uncertainty of it",
    "lambda central",
    "lambda minimum",
    "stop reason",
)


def rows_of(result: SweepResult) -> list[tuple[str, ...]]:
    """Speeds with friction, its parts and uncertainties, asperity load ratio and specific films."""
    rows = []
    for _, row in result.table.to_dataframe().sort_values(SPEED).iterrows():
        friction, share = row["friction_coefficient"], row["asperity_load_fraction"]
        cells = (
            f"{row[SPEED]:g}",
            f"{friction:.4f}",
            f"{friction * row['friction_coefficient_error']:.4f}",
            f"{friction * row['friction_coefficient_model_error']:.4f}",
            f"{row['friction_boundary']:.4f}",
            f"{row['friction_fluid']:.4f}",
            f"{share * 100:.1f} %",
            f"{share * row['asperity_load_fraction_model_error'] * 100:.1f} %",
            *("" if np.isnan(row[name]) else f"{row[name]:.2f}" for name in LAMBDAS),
            "" if row["converged"] == 1 else str(row["stop_reason"]),
        )
        rows.append(cells)
    return rows


def draw(result: SweepResult) -> Figure:
    """Friction, share and specific films over speed."""
    order = np.argsort(result.table[SPEED].values)
    columns = {str(name): column.values[order] for name, column in result.table.items()}
    speed, good = columns[SPEED], columns["converged"] == 1
    figure = new_figure(8, 8.5, result.title)
    friction, share, film = figure.subplots(3, sharex=True, height_ratios=(3, 2, 2))
    _with_bars(friction, speed, columns, "friction_coefficient", "tab:purple", "friction")
    friction.plot(
        speed, columns["friction_boundary"], "--", color="tab:red", label="part of asperities"
    )
    friction.plot(speed, columns["friction_fluid"], "--", color="tab:blue", label="part of the oil")
    friction.set_ylabel("friction coefficient")
    _with_bars(share, speed, columns, "asperity_load_fraction", "tab:red", "asperity load ratio")
    share.set_ylabel("asperity load ratio")
    for name, label in zip(
        LAMBDAS, ("central film thickness", "minimum film thickness"), strict=True
    ):
        film.plot(speed[good], columns[name][good], "o-", markersize=4, label=label)
    film.set_ylabel("specific film thickness")
    for axes, name in ((friction, "friction_coefficient"), (share, "asperity_load_fraction")):
        less = {"color": "white", "markeredgecolor": "black", "markersize": 5, "zorder": 5}
        if not good.all():
            axes.plot(
                speed[~good],
                columns[name][~good],
                "o",
                label="less accurate than requested",
                **less,
            )
    for axes in (friction, share, film):
        axes.set_ylim(bottom=0)
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.grid(True, color="0.9")
        axes.legend(frameon=False)
    film.set_xlabel("worm speed / rpm")
    return figure


def _with_bars(
    axes: Axes,
    speed: np.ndarray,
    columns: dict[str, np.ndarray],
    name: str,
    colour: str,
    label: str,
) -> None:
    """A figure with its bar of the model, thin and wide, and its numerical one, thick."""
    value = columns[name]
    model, error = value * columns[f"{name}_model_error"], value * columns[f"{name}_error"]
    axes.errorbar(
        speed,
        value,
        model,
        fmt="o-",
        color=colour,
        capsize=5,
        elinewidth=0.8,
        markersize=4,
        label=f"{label}, model uncertainty",
    )
    numerical = "numerical uncertainty"
    axes.errorbar(
        speed, value, error, fmt="none", ecolor="black", elinewidth=3, zorder=4, label=numerical
    )


def main() -> None:
    result = open_sweep(sys.argv[1])
    sweep = "pyworm sweep cases/sweeps/stribeck_zi.toml"
    record("stribeck", COLUMNS, rows_of(result), first=sweep)
    draw(result).savefig(Path(sys.argv[2]), dpi=120)


if __name__ == "__main__":
    main()
