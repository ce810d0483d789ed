"""Axes, rotations and velocities of every kind of drive: `docs/pictures/coordinates.png`.

python benchmarks/drives/coordinates.py

Everything drawn is the program's own geometry: surfaces of `Drive.in_space`, axes, velocities and gap of a
contact.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

import pyworm
from pyworm.drives.answers import Shape, Space
from pyworm.formulas.hertz import hertz
from pyworm.scene.index import ContactIndex

ROOT = Path(__file__).parents[2]
PICTURE = ROOT / "docs/pictures/coordinates.png"
BODY_COLOURS = {1: "tab:blue", 2: "tab:orange"}
MILLIMETRE = 1e3


def main() -> None:
    """Draw all four."""
    drives = {
        name: pyworm.load(ROOT / "cases" / f"{name}.toml").drive
        for name in ("zi_drive", "roller_ref", "spur_pair")
    }
    figure, panels = plt.subplots(2, 2, figsize=(11, 10), layout="constrained")
    draw_worm(panels[0, 0], drives["zi_drive"])
    draw_contact(panels[0, 1])
    draw_gears(panels[1, 0], drives["spur_pair"])
    draw_rollers(panels[1, 1], drives["roller_ref"])
    figure.savefig(PICTURE, dpi=110)


def turned(shape: Shape, turn: float) -> np.ndarray:
    """Points of a surface turned about its axis, (rows, columns, 3) [m]."""
    arm = shape.surface - shape.axis_point
    along = (arm @ shape.axis)[..., None] * shape.axis
    across = np.cross(shape.axis, arm)
    return shape.axis_point + np.cos(turn) * (arm - along) + along + np.sin(turn) * across


def draw_space(axes: Axes, space: Space, outlines: bool = False, mesh: bool = False) -> None:
    """Lines of all surfaces as they are seen [mm], the contact line in red.

    `outlines`: the middle row of a surface alone; `mesh`: rows and columns of body 2.
    """
    right, up, _ = space.view
    for shape in space.shapes:
        colour, lines = BODY_COLOURS[shape.body], []
        for copy in (0.0, *shape.copies):
            points = MILLIMETRE * turned(shape, shape.turns[0] + copy)
            seen = np.stack([points @ right, points @ up], axis=-1)
            rows = [seen[len(seen) // 2]] if outlines else [*seen]
            if mesh and shape.body == 2:
                rows += [*np.swapaxes(seen, 0, 1)]
            lines += [row[np.isfinite(row[:, 0])] for row in rows]
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=0.7))
    for line in space.lines:
        axes.plot(MILLIMETRE * line @ right, MILLIMETRE * line @ up, color="tab:red", lw=2.5)


def arrow(axes: Axes, start, step, text: str = "", colour: str = "black", shift=(0, 0)) -> None:
    """A straight arrow with its name at its tip."""
    start, step = np.asarray(start, float), np.asarray(step, float)
    style = {"arrowstyle": "-|>", "color": colour, "lw": 1.6, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", start + step, start, arrowprops=style)
    axes.annotate(
        text, start + step, shift, textcoords="offset points", color=colour, ha="center", va="center",
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.8},
    )  # fmt: skip


def rotation(axes: Axes, centre, radius: float, angles, text: str, colour: str) -> None:
    """An arc with a tip, from the first angle to the second [degrees]."""
    angle = np.radians(np.linspace(*angles, 40))
    points = np.asarray(centre)[:, None] + radius * np.array([np.cos(angle), np.sin(angle)])
    axes.plot(*points[:, :-1], color=colour, lw=1.6)
    style = {"arrowstyle": "-|>", "color": colour, "lw": 1.6, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", points[:, -1], points[:, -2], arrowprops=style)
    middle = points[:, 20]
    axes.text(*middle, text, color=colour, ha="center", va="center", backgroundcolor="white")


def triad(axes: Axes, origin, length: float, names, depth: str, towards: bool) -> None:
    """Axes of a drive: to the right or left, up or down, and along the line of sight."""
    for step, name in names.items():
        arrow(axes, origin, length * np.array(step), name, shift=8 * np.array(step))
    axes.plot(*origin, "o", mfc="white", mec="black", ms=11, zorder=5)
    axes.plot(*origin, "o" if towards else "x", color="black", ms=4 if towards else 7, zorder=6)
    axes.annotate(depth, origin, (14, -12), textcoords="offset points", ha="center", va="center")


def framed(axes: Axes, title: str) -> None:
    """Equal scales, no ticks."""
    axes.set_aspect("equal")
    axes.set(title=title, xticks=[], yticks=[])


def draw_worm(axes: Axes, drive) -> None:
    """Worm above the wheel, seen along the wheel's axis."""
    space = drive.in_space([ContactIndex(phase=0.5)])
    draw_space(axes, space)
    a = MILLIMETRE * drive.centre_distance
    point = MILLIMETRE * drive.contact(0.5).point
    at = np.array([space.view[0] @ point, space.view[1] @ point])
    axes.plot(*at, "o", color="tab:red", ms=6, zorder=6)
    triad(axes, (0, 0), 0.3 * a, {(1, 0): "Z", (0, -1): "X"}, "Y", towards=False)
    axes.plot([-0.55 * a, 0.55 * a], [a, a], "-.", color="0.4", lw=0.9)
    arrow(axes, (-0.5 * a, a), (0.14 * a, 0), r"$\omega_1$", BODY_COLOURS[1], (0, 12))
    rotation(axes, (0, 0), 0.5 * a, (60, 120), r"$\omega_2$", BODY_COLOURS[2])
    arrow(axes, (-0.42 * a, 0), (0, a), "", "0.4")
    arrow(axes, (-0.42 * a, a), (0, -a), "", "0.4")
    axes.text(-0.42 * a, 0.35 * a, "$a$", backgroundcolor="white", ha="center")
    axes.set(xlim=(-0.62 * a, 0.62 * a), ylim=(-0.42 * a, 1.3 * a))
    framed(axes, "Worm gear set, seen along Y (right-hand worm)")


def draw_contact(axes: Axes) -> None:
    """The tangent plane of the worm contact with its velocities."""
    contact = pyworm.load(ROOT / "cases/zi_sharif_2001.toml").scene(phase=0.5)
    size = hertz(*contact.radii, contact.load, contact.reduced_modulus)
    span = 1.5 * MILLIMETRE * size.semi_axis_x
    x, y = np.meshgrid(*2 * (np.linspace(-span, span, 241),))
    covered = contact.gap(x / MILLIMETRE, y / MILLIMETRE)[1]
    axes.contourf(x, y, covered, levels=[-0.5, 0.5], colors="0.85")
    angle = np.linspace(0, 2 * np.pi, 200)
    ellipse = size.semi_axis_x * np.cos(angle), size.semi_axis_y * np.sin(angle)
    axes.fill(*(MILLIMETRE * np.array(ellipse)), color="tab:red", alpha=0.6)
    zero = np.zeros(1)
    velocities = [np.ravel(motion(zero, zero)) for motion in contact.motions]
    scale = 0.75 * span / max(np.hypot(*velocity) for velocity in velocities)
    first, second = (scale * velocity for velocity in velocities)
    arrow(axes, (0, 0), first, r"$\mathbf{u}_1$", BODY_COLOURS[1], (0, 11))
    arrow(axes, (0, 0), second, r"$\mathbf{u}_2$", BODY_COLOURS[2], (-14, -8))
    arrow(axes, (0, 0), (first + second) / 2, r"$\mathbf{u}_m$", "black", (16, -4))
    arrow(axes, second, first - second, r"$\mathbf{u}_s$", "tab:green", (4, -16))
    corner = np.array([-0.85 * span, -0.85 * span])
    triad(axes, corner, 0.35 * span, {(1, 0): "x", (0, 1): "y"}, "z", towards=True)
    axes.text(-0.95 * span, 0.88 * span, "z: from body 1 (worm) to body 2 (wheel)", size=9)
    axes.set(xlim=(-span, span), ylim=(-span, span))
    framed(axes, "Tangent plane of a contact; red: Hertz contact, grey: no surface")


def draw_gears(axes: Axes, drive) -> None:
    """Teeth in mesh with the line of action, and the axes of the contact."""
    phase = 0.75
    draw_space(axes, drive.in_space([ContactIndex(phase=phase)]), outlines=True)
    teeth = drive.teeth
    angle = teeth.pressure_angle
    touched = teeth.cylinders[0].base * np.array([np.cos(angle), np.sin(angle)])
    action = np.array([np.sin(angle), -np.cos(angle)])
    start, end, met = (
        MILLIMETRE * (touched + length * action)
        for length in (teeth.start, teeth.end, float(drive.contacts(phase).pinion_length))
    )
    axes.plot(*np.array([start, end]).T, "o-", color="tab:red", ms=5, lw=1.5)
    module = MILLIMETRE * teeth.system.module
    axes.annotate("phase 0", start, (-34, 6), textcoords="offset points", color="tab:red")
    axes.annotate("phase 1", end, (8, -10), textcoords="offset points", color="tab:red")
    to_tip = np.array([np.cos(angle), np.sin(angle)])
    arrow(axes, met, 2.2 * module * to_tip, "x", shift=(8, 4))
    arrow(axes, met, 2.2 * module * action, "z", shift=(10, -4))
    middle = np.array([MILLIMETRE * teeth.cylinders[0].pitch, 0.0])
    reach = 5.2 * module
    for body, side in ((1, -0.72), (2, 0.72)):
        place = middle + reach * np.array([side, 0.75])
        arrow(axes, place, (0, -0.35 * reach), f"body {body}", BODY_COLOURS[body], (0, -10))
    axes.set(xlim=middle[0] + reach * np.array([-1, 1]), ylim=reach * np.array([-1, 1]))
    framed(axes, "Gear pair; body 1: pinion (left); y towards the viewer")


def draw_rollers(axes: Axes, drive) -> None:
    """Worm above the wheel with its rollers, seen along the wheel's axis."""
    index = ContactIndex(section="left", phase=0.5)
    draw_space(axes, drive.in_space([index]), mesh=True)
    a = MILLIMETRE * drive.centre_distance
    triad(axes, (0, 0), 0.3 * a, {(1, 0): "X", (0, 1): "Y"}, "Z", towards=True)
    axes.plot([-1.25 * a, 1.25 * a], [a, a], "-.", color="0.4", lw=0.9)
    rotation(axes, (0, 0), 0.5 * a, (120, 60), r"$\omega_2$", BODY_COLOURS[2])
    way = -drive.worm.turn
    arrow(axes, (1.2 * a * way, a), (-0.22 * a * way, 0), r"$\omega_1$", BODY_COLOURS[1], (0, 14))
    axes.set(xlim=(-1.35 * a, 1.35 * a), ylim=(-0.5 * a, 2.0 * a))
    for side, words in ((-0.75, "right section, idle"), (0.75, "left section, drives")):
        axes.text(side * a, 1.75 * a, words, color=BODY_COLOURS[1], ha="center")
    framed(axes, "Roller worm, seen against Z (right-hand worm)")


if __name__ == "__main__":
    main()
