"""Charts of the atlas for its page, and where classical formulas fail.

python benchmarks/atlas/charts.py atlas/films.csv [DIR, default docs/pictures]
"""

import argparse
import sys
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.table import groups, known

from pyworm.formulas import film
from pyworm.formulas.film_atlas import AtlasGroups, films, regime_measures
from pyworm.formulas.regimes import PIEZOVISCOUS_ELASTIC, REGIMES, regime_number

BAR = 0.02
"""Bar of the contacts drawn, at most [-]."""

ALPHA_MODULUS = 4500.0
"""G at which formulas that are no functions of M and L alone are compared."""

FORMULAS = {
    "Hamrock-Dowson": film.hamrock_dowson,
    "Chittenden": film.chittenden,
    "Masjedi-Khonsari": film.masjedi_khonsari,
    "Nijenbanning-Venner-Moes": film.nijenbanning_venner_moes,
}

REGIONS = {
    "long axis across, up to 30 deg": (0, 30),
    "30 to 60 deg": (30, 60),
    "60 to 80 deg": (60, 80),
    "long axis along, from 80 deg": (80, 90.1),
}
"""Angles of slender contacts; all of them are of radii 3 to 60."""


def classical(of: AtlasGroups) -> dict[str, film.Film]:
    """Films by published formulas in Moes' unit, by the groups along the entrainment."""
    speed = (of.moes_l / ALPHA_MODULUS) ** 4 / 2
    across = np.sin(of.angle) ** 2 + np.cos(of.angle) ** 2 / of.ratio
    along = np.cos(of.angle) ** 2 + np.sin(of.angle) ** 2 / of.ratio
    one = film.PointGroups(
        1.0, across / along, speed, of.moes_m * (2 * speed) ** 0.75, ALPHA_MODULUS
    )
    return {name: _over(formula(one), one.moes_film) for name, formula in FORMULAS.items()}


def _regime_numbers(of: AtlasGroups) -> np.ndarray:
    """Places of contacts in `REGIMES`."""
    return regime_number(*regime_measures(of, films(of).minimum))


def _over(found: film.Film, unit) -> film.Film:
    return film.Film(found.central / unit, None if found.minimum is None else found.minimum / unit)


def table(of: AtlasGroups, data: dict) -> None:
    """Print the ratio of classical formulas to the atlas, by region: median and both tenths."""
    found = classical(of)
    degrees = np.degrees(of.angle)
    rows = {"radii up to 3": of.ratio <= 3} | {
        name: (of.ratio > 3) & (degrees >= low) & (degrees < high)
        for name, (low, high) in REGIONS.items()
    }
    elastic = _regime_numbers(of) == REGIMES.index(PIEZOVISCOUS_ELASTIC)
    for name, which in rows.items():
        for formula, one in found.items():
            cells = []
            for told, stored in (
                (one.central, data["film_central"]),
                (one.minimum, data["film_min"]),
            ):
                if told is None:
                    cells.append("")
                    continue
                low, middle, high = np.percentile((told / stored)[which], [10, 50, 90])
                cells.append(f"{middle:.2f} ({low:.2f} to {high:.2f})")
            print(f"| {name} ({which.sum()}) | {formula} | {' | '.join(cells)} |")
    print(f"{elastic.sum()} piezoviscous-elastic of {len(elastic)}")


def ratios(of: AtlasGroups, data: dict, target: Path) -> None:
    """Ratios of formulas to the atlas over M, coloured by angle."""
    found = classical(of)
    figure, axes = plt.subplots(2, 3, figsize=(11, 6), sharey=True, layout="constrained")
    shown = (
        ("central", ("Hamrock-Dowson", "Chittenden", "Nijenbanning-Venner-Moes")),
        ("minimum", ("Hamrock-Dowson", "Chittenden", "Masjedi-Khonsari")),
    )
    outside = 0
    for row, (word, names) in zip(axes, shown, strict=True):
        stored = data[{"central": "film_central", "minimum": "film_min"}[word]]
        for axis, name in zip(row, names, strict=True):
            one = found[name]
            ratio = (one.central if word == "central" else one.minimum) / stored
            outside += np.sum((ratio < SHOWN[0]) | (ratio > SHOWN[1]))
            dots = axis.scatter(of.moes_m, ratio, c=np.degrees(of.angle), s=3, cmap="viridis")
            axis.set(xscale="log", yscale="log", ylim=SHOWN, xlabel="M")
            axis.set_title(f"{name}, {word}", fontsize=10)
            axis.set_yticks(RATIOS, [f"{tick:g}" for tick in RATIOS])
            axis.minorticks_off()
            axis.axhline(1, color="k", lw=0.7)
        row[0].set_ylabel("film thickness, formula over atlas")
    figure.colorbar(dots, ax=axes, label="angle of entrainment / °")
    figure.savefig(target, dpi=110)
    print(f"{outside} of {6 * len(data['number'])} points beyond the axes")


SHOWN, RATIOS = (0.2, 8.0), (0.2, 0.5, 1, 2, 5)
"""Ends of the axis of ratios, and its ticks."""


def over_load(target: Path) -> None:
    """Films over M for some L, by the formula: across, circular and along."""
    m = np.geomspace(3, 3000, 120)
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.8), sharey=True, layout="constrained")
    for axis, (title, ratio, angle) in zip(
        axes,
        (
            ("radii 1 : 10, across", 10, 0),
            ("circular", 1, 0),
            ("radii 1 : 10, along", 10, np.pi / 2),
        ),
        strict=True,
    ):
        for colour, el in zip(
            plt.cm.viridis(np.linspace(0, 0.9, 5)), (0.5, 2, 5, 10, 20), strict=True
        ):
            found = films(AtlasGroups(m, el, float(ratio), angle, 0.0, 0.93, 0.15))
            for style, told in (("-", found.central), ("--", found.minimum)):
                axis.plot(m, np.where(found.inside, told, np.nan), style, color=colour)
                axis.plot(m, np.where(found.inside, np.nan, told), style, color=colour, alpha=0.2)
            axis.plot([], [], color=colour, label=f"L = {el:g}")
        axis.set(xscale="log", yscale="log", xlabel="M", title=title)
    axes[0].set_ylabel("H: central (full), minimum (dashed)")
    axes[0].legend(fontsize=8)
    figure.savefig(target, dpi=110)


def regime_maps(target: Path) -> None:
    """Regimes over M and L for ellipses across, round and along."""
    m, el = np.meshgrid(np.geomspace(0.1, 3000, 500), np.geomspace(0.1, 30, 400))
    figure, axes = plt.subplots(1, 5, figsize=(12.5, 3.2), sharey=True, layout="constrained")
    cases = ((30, 0), (5, 0), (1, 0), (5, 90), (30, 90))
    for axis, (ratio, angle) in zip(axes, cases, strict=True):
        of = AtlasGroups(m, el, float(ratio), np.radians(angle))
        found = _regime_numbers(of)
        axis.pcolormesh(
            m, el, found, cmap=plt.get_cmap("viridis", 4), vmin=-0.5, vmax=3.5, rasterized=True
        )
        where = {0: ", across", 90: ", along"}[angle] if ratio > 1 else ", circular"
        axis.set(
            xscale="log",
            yscale="log",
            xlabel="M",
            title=f"D = {'1/' if angle == 0 and ratio > 1 else ''}{ratio}{where}",
        )
    axes[0].set_ylabel("L")
    bar = figure.colorbar(axes[0].collections[0], ax=axes, ticks=range(4))
    bar.ax.set_yticklabels(REGIMES, fontsize=8)
    figure.savefig(target, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("directory", type=Path, nargs="?", default=Path("docs/pictures"))
    given = parser.parse_args()
    data = known(given.table, BAR)
    of = groups(data)
    table(of, data)
    ratios(of, data, given.directory / "atlas_formulas.png")
    over_load(given.directory / "atlas_films.png")
    regime_maps(given.directory / "atlas_regimes.png")


if __name__ == "__main__":
    main()
