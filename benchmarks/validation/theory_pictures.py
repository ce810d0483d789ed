"""Pictures of the theory pages that no command draws: films, contacts, effects, wear, loads, flanks.

Run from the repository's root (half a minute):

    python benchmarks/validation/theory_pictures.py [DIR, default docs/pictures]
"""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import get_args

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure

import pyworm
from pyworm.drives.gear_pair.load_sharing import LoadSharing, SharingRule
from pyworm.formulas.arrays import Array
from pyworm.formulas.wear_law import RUN_IN, truncated_roughness
from pyworm.scene.scales import scales
from pyworm.solver.point.dry import DryPressure

MILLI, MICRO, KILO, MEGA = 1e3, 1e6, 1e-3, 1e-6

NODES = 385
"""Nodes a side of the dry contacts."""

ACCURACY = 0.05
"""Accuracy of the plans [-]."""

LEAST, MOST = 1e-5, 10.0
"""Influences that are shown [-]."""

CUT = 0.8
"""Height, over the roughness, above which summits are removed."""

ENGAGEMENT = 0.02, 0.18, 0.34, 0.5, 0.66, 0.82, 0.98
"""Mesh phases of the contacts on a flank."""

PHASES = ("0.5", "0.02")
"""Mesh phases of the dry contacts: in mid-mesh, and where the teeth begin to engage."""


def film_profile() -> Figure:
    """Pressure and film thickness of a ball on a disc through the contact point, along the entrainment."""
    scene = pyworm.load("cases/mourier_2006.toml").scene()
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.001, effects="isothermal"))
    fields = solution.fields.sel(y=0.0, method="nearest")
    hertz = scales(scene).hertz
    x = fields["x"].to_numpy() / hertz.semi_axis_x
    shown = (x > -2.2) & (x < 1.5)
    within = np.linspace(-1, 1, 201)

    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    axes.plot(
        x[shown], MEGA * fields["pressure"].to_numpy()[shown], color="C0", label="pressure $p$"
    )
    ellipse = hertz.pressure_max * np.sqrt(1 - within**2)
    axes.plot(within, MEGA * ellipse, "--", color="C0", lw=1, label="Hertzian pressure")
    axes.set(
        xlabel="position along the entrainment $x/a$ (1)",
        ylabel="pressure $p$ / MPa",
        ylim=(0, 480),
    )
    thickness = axes.twinx()
    thickness.plot(
        x[shown], MICRO * fields["film"].to_numpy()[shown], color="C1", label="film thickness $h$"
    )
    thickness.set(ylabel="film thickness $h$ / µm", ylim=(0, 1.6))
    _note_regions(thickness)
    lines = [*axes.get_lines(), *thickness.get_lines()]
    axes.legend(
        lines, [line.get_label() for line in lines], loc="upper center", ncols=3, fontsize=9
    )
    axes.margins(x=0)
    return figure


def _note_regions(axes: Axes) -> None:
    """Names of the parts of a film, beside its thickness."""
    for place, height, name in (
        (-1.75, 0.75, "inlet:\nthe film forms"),
        (-0.1, 0.28, "contact: film of even thickness"),
    ):
        axes.text(place, height, name, ha="center", fontsize=9, color="0.3")
    arrow = {"arrowstyle": "->", "color": "0.3"}
    axes.annotate(
        "exit\nconstriction",
        (0.95, 0.17),
        (1.24, 0.07),
        ha="center",
        fontsize=9,
        color="0.3",
        arrowprops=arrow,
    )


def dry_contacts() -> Figure:
    """Dry contacts of a worm gear set in mid-mesh and where its teeth begin to engage."""
    case = pyworm.load("cases/zi_drive.toml")
    scenes = [case.scene(phase=float(phase)) for phase in PHASES]
    found = [pyworm.dry_contact(scene, NODES) for scene in scenes]
    highest = max(contact.pressure.max() for contact in found)
    figure, panels = plt.subplots(2, figsize=(8, 3.8), sharex=True, layout="constrained")
    for panel, scene, contact, phase in zip(panels, scenes, found, PHASES, strict=True):
        image = _pressure_map(panel, contact, highest)
        hertz = scales(scene).hertz
        turn = np.linspace(0, 2 * np.pi, 361)
        x, y = hertz.semi_axis_x * np.cos(turn), hertz.semi_axis_y * np.sin(turn)
        panel.plot(MILLI * x, MILLI * y, "k--", lw=1)
        panel.set_title(
            f"mesh phase {phase}: maximum pressure {MEGA * contact.pressure_max:.0f} MPa, "
            f"by Hertz {MEGA * hertz.pressure_max:.0f} MPa",
            fontsize=10,
        )
    panels[-1].set_xlabel("$x$ / mm")
    figure.colorbar(image, ax=panels, label="dry contact\npressure $p$ / MPa")
    return figure


def _pressure_map(panel: Axes, contact: DryPressure, highest: float) -> ScalarMappable:
    """Pressure over the tangent plane, white where surfaces do not touch."""
    x, y = MILLI * contact.x, MILLI * contact.y
    pressure: Array = np.where(contact.pressure > 0, MEGA * contact.pressure, np.nan)
    image = panel.pcolormesh(
        x, y, pressure.T, vmin=0, vmax=MEGA * highest, shading="nearest", rasterized=True
    )
    panel.set(ylabel="$y$ / mm", aspect="equal", xlim=(-12, 16), ylim=(-2, 2))
    return image


def effects() -> Figure:
    """Influence of each effect on the film thickness of two contacts, as their plans estimate it."""
    contacts = {
        "worm gear contact": pyworm.load("cases/zi_sharif_2001.toml").scene(phase=0.5),
        "spur gear contact": pyworm.load("cases/spur_pair.toml").scene(phase=0.45),
    }
    figure, panels = plt.subplots(1, 2, figsize=(8, 4.2), sharey=True, layout="constrained")
    for panel, (name, scene) in zip(panels, contacts.items(), strict=True):
        judgements = pyworm.plan(scene, accuracy=ACCURACY).effects
        for row, judgement in enumerate(judgements):
            if judgement.influence:
                influence = float(np.clip(judgement.influence["film"], LEAST, MOST))
                fill = {} if judgement.on else {"fill": False}
                panel.barh(row, influence, height=0.6, color="C0", edgecolor="C0", **fill)
            else:
                panel.text(
                    1.3 * LEAST,
                    row,
                    "no such effect or no data",
                    va="center",
                    fontsize=8,
                    color="0.4",
                )
        panel.axvline(ACCURACY, color="C3", lw=1)
        panel.text(1.2 * ACCURACY, -0.85, "accuracy", color="C3", fontsize=8, va="center")
        panel.set_yticks(range(len(judgements)), [judgement.name for judgement in judgements])
        panel.set(title=name, xscale="log", xlim=(LEAST, MOST))
        panel.set_xlabel("influence on the film thickness (1)")
    panels[0].set_ylim(len(judgements) - 0.3, -1.4)
    return figure


def running_in() -> Figure:
    """Heights of a surface before and after its summits are removed, and what is left of its roughness."""
    figure, (heights, roughness) = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
    z = np.linspace(-3.5, 3.5, 401)
    density = np.exp(-(z**2) / 2) / np.sqrt(2 * np.pi)
    heights.plot(z, density, "--", color="0.5", label="as manufactured")
    left = z <= CUT
    heights.fill_between(z[left], density[left], alpha=0.3, color="C0")
    heights.plot(z[left], density[left], color="C0", label="run in")
    heights.axvline(CUT, color="C0", lw=1)
    heights.text(CUT + 0.1, 0.36, "$t$", color="C0")
    heights.set(xlabel="height $z/R_{q0}$ (1)", ylabel="density (1)", ylim=(0, 0.46))
    heights.legend(loc="upper left", fontsize=8)
    removed = np.linspace(0.0, 1.0, 201)
    for bound, style in ((0.0, "--"), (RUN_IN, "-")):
        ratio = [truncated_roughness(1e-6, depth * 1e-6, bound) / 1e-6 for depth in removed]
        label = "(5), bounded" if bound else "(5)"
        roughness.plot(removed, ratio, style, color="C0" if bound else "0.5", label=label)
    roughness.set(
        xlabel="mean depth removed $\\bar d/R_{q0}$ (1)",
        ylabel="roughness $R_q/R_{q0}$ (1)",
        ylim=(0, 1.05),
    )
    roughness.legend(fontsize=8)
    return figure


def load_sharing() -> Figure:
    """Load of a tooth pair by each rule, and surface speeds, over the path of contact of a gear pair."""
    mesh = pyworm.load("cases/spur_pair.toml").drive
    phases = np.linspace(0, 1, 2001)
    contacts = mesh.contacts(phases)
    place = MILLI * contacts.pinion_length
    figure, (shares, speeds) = plt.subplots(
        2, figsize=(7, 5), sharex=True, layout="constrained", height_ratios=(3, 2)
    )
    for rule in get_args(SharingRule):
        share = LoadSharing(mesh.teeth, rule).of_line(contacts.pinion_length)
        shares.plot(place, share, label=f"load_sharing = {rule}")
    shares.set(ylabel="share of the normal force\non one tooth pair (1)", ylim=(0, 1.15))
    shares.legend(fontsize=8, loc="lower center")
    speeds.plot(place, contacts.pinion_velocity, label="pinion $u_1$")
    speeds.plot(place, contacts.gear_velocity, label="gear $u_2$")
    speeds.set(xlabel="radius of curvature of the pinion $\\rho_1$ / mm", ylabel="speed / (m/s)")
    speeds.legend(fontsize=8)
    teeth = mesh.teeth
    points = (teeth.start, teeth.lowest_single, teeth.pitch_point, teeth.highest_single, teeth.end)
    for name, point in zip(("SAP", "LPSTC", "P", "HPSTC", "EAP"), points, strict=True):
        for panel in (shares, speeds):
            panel.axvline(MILLI * point, color="0.6", lw=0.8, ls=":")
        shares.text(MILLI * point, 1.17, name, ha="center", va="bottom", fontsize=8)
    speeds.margins(x=0.03)
    return figure


def worm_flank() -> Figure:
    """Dry contacts on a wheel's flank through one engagement, and the load of a tooth pair."""
    case = pyworm.load("cases/zi_drive.toml")
    drive = case.drive
    figure, (flank, load) = plt.subplots(
        1, 2, figsize=(9.5, 3.6), layout="constrained", width_ratios=(2, 1)
    )
    rim = drive.wheel_flank.cut_point(*drive.rim)
    flank.plot(MILLI * rim[1], MILLI * np.hypot(rim[0], rim[2]), color="0.3")
    for phase in ENGAGEMENT:
        found = pyworm.dry_contact(case.scene(phase=phase), NODES // 2)
        x, y = np.meshgrid(found.x, found.y)
        face, radius = drive.flank_place(drive.contact(phase), x, y)
        levels = found.pressure.max() * np.array([0.02, 0.5, 0.8, 1.0])
        flank.contourf(MILLI * face, MILLI * radius, found.pressure.T, levels, cmap="Blues")
    path = np.array([drive.contact(phase).point for phase in np.linspace(0, 1, 51)]).T
    face, radius = MILLI * path[1], MILLI * np.hypot(path[0], path[2])
    flank.plot(face, radius, color="C3")
    for number, phase in ((0, "phase 0"), (25, "0.5"), (50, "1")):
        flank.plot(face[number], radius[number], "o", color="C3", ms=4)
        flank.annotate(
            phase,
            (face[number], radius[number]),
            (6, 5),
            textcoords="offset points",
            bbox={"boxstyle": "round,pad=0.1", "fc": "white", "ec": "none", "alpha": 0.8},
        )
    flank.set(xlabel="coordinate along the face $Y$ / mm", ylabel="radius / mm", aspect="equal")
    phases = np.linspace(0, 1, 101)
    load.plot(phases, [KILO * drive.normal_load(phase) for phase in phases])
    load.set(xlabel="mesh phase (1)", ylabel="normal load $F$ / kN", ylim=(0, None), xlim=(0, 1))
    return figure


PICTURES: dict[str, Callable[[], Figure]] = {
    "film": film_profile,
    "dry": dry_contacts,
    "effects": effects,
    "wear": running_in,
    "gear": load_sharing,
    "worm": worm_flank,
}
"""Name of the file after `theory_`, and what draws it."""


def main() -> None:
    """Draw the pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, nargs="?", default=Path("docs/pictures"))
    directory = parser.parse_args().directory
    for name, picture in PICTURES.items():
        picture().savefig(directory / f"theory_{name}.png", dpi=130)


if __name__ == "__main__":
    main()
