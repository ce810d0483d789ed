"""Variants of the roller drive, `cases/rollers`: what they give, and `docs/pictures/roller_variants.png`.

python benchmarks/drives/roller_variants.py        # two minutes
python benchmarks/drives/roller_variants.py picture
"""

import sys
import time
import tomllib
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib import pyplot as plt

import pyworm
from pyworm.drives.roller_worm.indices import lubrication_angle, self_rotation_angle
from pyworm.plots.drives.roller_worm_drive import SECTION_COLOURS

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ROOT = Path(__file__).parents[2]

CONE = ROOT / "cases" / "rollers" / "cone.toml"

TITLES = {
    "cone": "tapered rollers",
    "ball": "balls",
    "face": "rollers on a disc",
    "double": "double row, no backlash",
    "internal": "internal worm, rollers in a ring",
    "barrel": "barrels, a given profile",
}
"""Case -> what it is, in the order of the table."""

COLUMNS = (
    "case",
    "rollers of a flank in mesh",
    "relative radius / mm",
    "entrainment / m/s",
    "sliding along the line / m/s",
    "maximum pressure / MPa",
    "minimum film thickness, driving / um",
    "uncertainty / %",
    "lubrication angle / deg",
    "self-rotation angle / deg",
    "pin, radial load / N",
    "friction coefficient",
    "loss of the films, simulated, and of pins / W",
    "loss of sliding along the rollers, closed form / W",
    "contacts converged",
    "time / s",
)


def main():
    if sys.argv[1:] != ["picture"]:
        rows = [row(f"{name}: {title}", load(name)) for name, title in TITLES.items()]
        tables = tomllib.loads(CONE.read_text(encoding="utf-8"))
        tables["drive"]["rollers"]["half_angle"] = "6 deg"
        rows.insert(1, row("cone, thicker at the outer end", pyworm.load(tables)))
        record("roller_variants", COLUMNS, rows)
    draw()


def load(name):
    return pyworm.load(ROOT / "cases" / "rollers" / f"{name}.toml")


def row(title, case):
    """What `pyworm run` of a variant gives, over all solved contacts of the driving flank."""
    start = time.perf_counter()
    result = pyworm.run(case)
    seconds = time.perf_counter() - start
    drive, solved = case.drive, result.solutions
    driving = [solution for solution in solved if solution.section == "left"]
    states = [
        drive.state("left", phase, [0.02, 0.5, 0.98]) for phase in np.linspace(0.05, 0.95, 13)
    ]
    thinnest = min(driving, key=lambda solution: solution.figures.film_min.value)
    section, bearing = drive.sections["left"], drive.element_bearing()
    part = section.envelope
    return (
        title,
        f"{(section.last - section.first) / section.pitch:.2f}",
        span([1e3 / state.contact.curvature for state in states], ".2f"),
        span([state.motion.entrainment for state in states], ".1f"),
        span([np.abs(state.motion.sliding[1]) for state in states], ".1f"),
        f"{max(solution.figures.pressure_max.value for solution in driving) * 1e-6:.0f}",
        f"{thinnest.figures.film_min.value * 1e6:.2f}",
        f"{100 * thinnest.figures.film_min.error:.1f}",
        span([np.degrees(lubrication_angle(part, state.contact)) for state in states], ".0f"),
        span([np.degrees(self_rotation_angle(part, state.contact)) for state in states], ".0f"),
        f"{bearing.radial_max:.0f}",
        f"{result.mesh_loss.friction:.4f}",
        f"{result.mesh_loss.loss:.0f}",
        f"{bearing.losses['sliding along the rollers']:.0f}",
        f"{sum(solution.converged for solution in solved)} of {len(solved)}",
        f"{seconds:.0f}",
    )


def span(values, style):
    return f"{np.min(values):{style}} to {np.max(values):{style}}"


def draw():
    """Rollers, both flanks of the thread and lines of contact of every variant."""
    mpl.use("Agg")
    figure = plt.figure(figsize=(11, 5.6))
    for number, (name, title) in enumerate(TITLES.items()):
        axes = figure.add_subplot(2, 3, number + 1, projection="3d")
        variant(axes, load(name).drive)
        axes.set_title(title, fontsize=10, y=0.98)
    handles = [plt.Line2D([], [], color=colour, lw=5) for colour in SECTION_COLOURS.values()]
    handles += [plt.Line2D([], [], color="tab:red", lw=2)]
    figure.legend(
        handles, ["idling flank", "driving flank", "line of contact"], ncols=3, loc="lower center",
        frameon=False,
    )  # fmt: skip
    figure.subplots_adjust(0, 0.05, 1, 0.97, 0, 0.04)
    figure.savefig(ROOT / "docs" / "pictures" / "roller_variants.png", dpi=110)


def variant(axes, drive):
    axes.set_proj_type("ortho")
    for section in drive.sections.values():
        places = np.linspace(section.lowest, section.highest, 5)[:, None]
        flank = section.envelope.worm_point(places, np.linspace(section.first, section.last, 360))
        axes.plot_surface(
            *(flank * 1e3),
            color=SECTION_COLOURS[section.name],
            alpha=0.6,
            rcount=5,
            ccount=360,
            lw=0,
        )
        angles = section.in_mesh(0.0)
        lines = section.line(angles, np.linspace(0, 1, 5)[:, None]).point * 1e3
        for line in np.moveaxis(lines, 2, 0):
            axes.plot(*line, color="tab:red", lw=2.2, zorder=20)
    for row in drive.rows:
        reach = round(section.last / row.pitch)
        for angle in row.pitch * np.arange(-reach, reach + 1):
            roller(axes, drive.rollers.profile, row.envelope.axes(angle))
    sizes = [np.diff(limits())[0] for limits in (axes.get_xlim, axes.get_ylim, axes.get_zlim)]
    axes.set_box_aspect(sizes, zoom=1.38)
    axes.view_init(28, -70)
    axes.set_axis_off()


def roller(axes, profile, seat):
    """One roller as a surface of revolution, with both ends."""
    going, side, axis, middle = (vector[:, None, None] for vector in seat)
    along = np.linspace(-0.5, 0.5, 11) * profile.length
    radius = np.concatenate([[0.0], profile(along)[0], [0.0]])[:, None]
    along = along[[0, *range(11), -1]][:, None]
    round_ = np.linspace(0, 2 * np.pi, 25)
    surface = middle + along * axis + radius * (np.cos(round_) * going + np.sin(round_) * side)
    axes.plot_surface(*(surface * 1e3), color="0.75", alpha=1.0, lw=0, rcount=13, ccount=25)


if __name__ == "__main__":
    main()
