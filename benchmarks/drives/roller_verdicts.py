"""A verdict on every cell of the roller drive's source, and what its film formula hides, factor by factor.

python benchmarks/drives/roller_verdicts.py        # two minutes; docs/pictures/roller_verdicts.png, too
python benchmarks/drives/roller_verdicts.py picture

Films of a cell, each with one more thing put right: the source's formula with its own load and rollers that
do not turn; without its second 0.75, which is Dowson and Higginson's minimum film; with rollers that turn
freely; with the load of the rollers in mesh; the line contact solved, isothermal; with heat, shear-thinning
and roughness as they are given.
"""

import sys
from dataclasses import replace
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib import pyplot as plt
from roller_tables import CASE, ENDS, SOURCE, by_source

import pyworm
from pyworm.formulas.lubrication import BOUNDARY, FULL_FILM
from pyworm.formulas.regimes import REGIMES
from pyworm.formulas.roller_enveloping import MINIMUM_FRACTION
from pyworm.formulas.thermal_reduction import thermal_loading
from pyworm.formulas.wear_distress import regime
from pyworm.materials.body import composite_roughness, reduced_modulus

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_data import ROOT, read
from evidence_record import record

AGREES = 0.25
"""Relative difference up to which a printed film counts as that of its formula: sizes are assumed."""

STEPS = (
    "its formula / um",
    "minimum once / um",
    "rollers turn / um",
    "load of the mesh / um",
    "solved, isothermal / um",
    "solved, with heat and roughness / um",
)

COLUMNS = (
    "table", "cell", "published / um", *STEPS, "uncertainty / %", "lambda", "lubrication", "verdict",
)  # fmt: skip


def main():
    if sys.argv[1:] != ["picture"]:
        judge()
    draw()


def judge():
    drive = pyworm.load(CASE).drive
    rows = [*inputs(drive), *overall(cells(drive))]
    for name, table in SOURCE.items():
        found = {value: cells(drive.varied(name, value)) for value in table}
        for number, (section, _, end) in enumerate(ENDS):
            printed = [films[number] for films in table.values()]
            computed = [row[number] for row in found.values()]
            for value, film, steps in zip(table, printed, computed, strict=True):
                size = f"R = {value * 1e3:g} mm" if name == "roller_radius" else f"k = {value:g}"
                rows.append(
                    film_row(f"{name.replace('_', ' ')}", f"{section} {end}, {size}", film, steps)
                )
            rows.append(trend_row(name, f"{section} {end}, trend", printed, computed))
    record("roller_verdicts", COLUMNS, rows)


def cells(drive):
    """Steps of the films at the ends of both sections [m], uncertainty and lambda."""
    found = []
    for section, phase, _ in ENDS:
        locked = replace(drive, rolling="locked")
        first = by_source(locked, section, phase)
        turning = by_source(drive, section, phase) / MINIMUM_FRACTION
        loaded = float(drive.state(section, phase, [0.5]).films.minimum[0])
        scene = drive.scene(section, phase, 0.5)
        plain = pyworm.solve(scene, pyworm.plan(scene, 0.02, "isothermal")).figures.film_min
        whole = pyworm.solve(scene, pyworm.plan(scene, 0.05, "auto"))
        film = whole.figures.film_min
        ratio = film.value / composite_roughness(*drive.bodies)
        steps = first, first / MINIMUM_FRACTION, turning, loaded, plain.value, film.value
        found.append((steps, film.error if whole.converged else np.nan, ratio))
    return found


def film_row(table, cell, printed, computed):
    steps, error, ratio = computed
    microns = [step * 1e6 for step in steps]
    off = printed / microns[0] - 1
    agrees = "its formula gives it" if abs(off) <= AGREES else "not its formula's"
    verdict = (
        f"{agrees} ({off:+.0%}); the solved film is {microns[-1] / printed:.1f} times as thick"
    )
    kind = regime(ratio)
    return (
        table, cell, f"{printed:.3f}", *(f"{step:.3f}" for step in microns), f"{100 * error:.1f}",
        f"{ratio:.1f}", kind, verdict,
    )  # fmt: skip


def trend_row(name, cell, printed, computed):
    """Change over the table, printed, by its formula, and solved."""
    of_table = printed[-1] / printed[0] - 1
    changes = [computed[-1][0][step] / computed[0][0][step] - 1 for step in range(len(STEPS))]
    same = np.sign(of_table) == np.sign(changes[0])
    solved = np.sign(of_table) == np.sign(changes[-1])
    verdict = (
        f"sign {'as' if same else 'against'} its formula, {'as' if solved else 'against'} solved"
    )
    return (
        name.replace("_", " "), cell, f"{of_table:+.0%}", *(f"{change:+.0%}" for change in changes),
        "", "", "", verdict,
    )  # fmt: skip


def inputs(drive):
    """Statements of the source in numbers that its own table of sizes decides."""
    modulus = reduced_modulus(*drive.bodies)
    state = drive.state("left", 0.5, [0.5])
    contact = 1 / float(state.contact.curvature[0]), float(state.load[0])
    printed = float(state.films.printed_g_v[0]), float(state.films.printed_g_e[0])
    right = float(state.films.g_v[0]), float(state.films.g_e[0])
    heat = drive.oil.heat
    loading = thermal_loading(
        drive.oil.viscosity.eta0,
        drive.oil.beta,
        float(state.motion.entrainment[0]),
        heat.conductivity,
    )
    blank = ("",) * (len(STEPS) + 3)
    return [
        ("statements", "E'", "formula garbled", *blank, f"{modulus * 1e-9:.1f} GPa by its moduli"),
        ("statements", "g_V, g_E at mid-mesh", "without roots", *blank,
         f"{printed[0]:.3g} and {printed[1]:.3g} as printed, {right[0]:.3g} and {right[1]:.3g} by Johnson"),
        ("statements", "entry R-V, middle E-V, exit E-I", "", *blank, regimes(drive)),
        ("statements", "load of a roller", "cos(lambda) for sin(lambda)", *blank,
         f"{state.force:.0f} N on {contact[1] * 1e-3:.0f} kN/m, R = {contact[0] * 1e3:.2f} mm at mid-mesh"),
        ("statements", "h ~ 1/w^0.13, weak in load", "", *blank, load_exponent(drive)),
        ("statements", "thermal effects neglected", "", *blank,
         f"thermal loading {loading:.2f} at mid-mesh; Wilson and Sheu leave "
         f"{float(state.films.heated_share[0]):.2f} of the film"),
        ("statements", f"full film above {FULL_FILM:g}, boundary below {BOUNDARY:g}", "mixed likely",
         *blank, "the bounds used here, too; the rows below have lambda"),
    ]  # fmt: skip


def overall(found):
    """Statements on the films at the ends of both sections, beside the film solved with heat."""
    first, last = ([steps[place] * 1e6 for steps, _, _ in found] for place in (0, -1))
    blank = ("",) * (len(STEPS) + 3)

    def times(films):
        return f"{films[1] / films[0]:.1f} and {films[2] / films[3]:.1f} times"

    return [
        ("statements", "left rises from entry to exit, right falls", "2.5 and 2.3 times", *blank,
         f"{times(first)} by its formula, {times(last)} solved"),
        ("statements", "left thicker than right", "at its exit", *blank,
         f"mirror images by its formula ({first[1]:.2f}, {first[2]:.2f} um); solved the idling right is "
         f"thicker, {last[2]:.2f} to {last[1]:.2f} um"),
        ("statements", "films from 0.4 to 1.6 um", "", *blank,
         f"{min(first):.2f} to {max(first):.2f} by its formula, {min(last):.2f} to {max(last):.2f} um "
         "solved"),
    ]  # fmt: skip


def regimes(drive):
    found = [
        int(drive.state("left", phase, [0.5]).films.regime[0]) for phase in np.linspace(0, 1, 21)
    ]
    ends = [REGIMES[found[place]] for place in (0, 10, 20)]
    missing = "nowhere" if 2 not in found else "somewhere"
    return f"left section: {', '.join(ends)}; isoviscous-elastic {missing}"


def load_exponent(drive):
    """Exponent of the load in the film solved at mid-mesh, from half to the whole torque."""
    films = []
    for share in (0.5, 1.0):
        part = replace(drive, torque=share * drive.torque)
        scene = part.scene("left", 0.5, 0.5)
        films.append((scene.load, pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal"))))
    (low, thick), (high, thin) = films
    values = [solution.figures.film_min.value for solution in (thick, thin)]
    return f"exponent {np.log(values[1] / values[0]) / np.log(high / low):.3f} solved, isothermal"


def draw():
    """Films of both tables: printed, by the source's formula, and solved with heat and roughness."""
    mpl.use("Agg")
    figure, panels = plt.subplots(2, 4, figsize=(11, 5), sharey=True, layout="constrained")
    for row, name in zip(panels, SOURCE, strict=True):
        for axes, (section, _, end) in zip(row, ENDS, strict=True):
            compare(axes, name.replace("_", " "), f"{section} {end}")
    for axes in panels[:, 0]:
        axes.set_ylabel("minimum film\nthickness / µm")
    panels[0, 0].set_ylim(bottom=0)
    lines = panels[0, 0].get_lines()
    names = [line.get_label() for line in lines]
    figure.legend(lines, names, ncols=4, loc="outside lower center", frameon=False)
    figure.savefig(ROOT / "docs" / "pictures" / "roller_verdicts.png", dpi=110)


def compare(axes, table, place):
    """A row of the source's table."""
    data = read("roller_verdicts")
    rows = [dict(zip(data.columns, row, strict=True)) for row in data.rows]
    here = [row for row in rows if row["table"] == table and row["cell"].startswith(f"{place}, ")]
    here = [row for row in here if not row["cell"].endswith("trend")]
    sizes = [float(row["cell"].split("= ")[1].split()[0]) for row in here]
    looks = (
        ("published / um", "ko-", "printed"),
        (STEPS[0], "s--", "its formula"),
        (STEPS[3], "^:", "its formula put right"),
        (STEPS[5], "D-", "solved, with heat and roughness"),
    )
    for column, look, label in looks:
        films = [float(row[column]) for row in here]
        axes.plot(sizes, films, look, ms=4, lw=1.2, label=label)
    axes.set_title(place, fontsize=9)
    axes.set_xlabel(
        "roller radius R / mm" if "radius" in table else "throat coefficient k", fontsize=9
    )
    axes.grid(color="0.9")


if __name__ == "__main__":
    main()
