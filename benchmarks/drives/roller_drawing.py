"""How the words of the roller enveloping drive's source were read: `docs/pictures/roller_reading.png`.

python benchmarks/drives/roller_drawing.py
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, FancyArrowPatch, Rectangle
from matplotlib.transforms import Affine2D

import pyworm

ROOT = Path(__file__).parents[2]
COLOURS = {"right": "tab:orange", "left": "tab:blue"}


def main():
    drive = pyworm.load(ROOT / "cases" / "roller_ref.toml").drive
    figure, (plan, roller) = plt.subplots(
        1, 2, figsize=(12, 6.2), width_ratios=(1.7, 1), layout="constrained"
    )
    draw_plan(plan, drive)
    draw_roller(roller)
    figure.savefig(ROOT / "docs" / "pictures" / "roller_reading.png", dpi=110)


def draw_plan(axes, drive):
    """Wheel, rollers and both sections seen along the wheel's axis, in mm."""
    a, throat = drive.centre_distance * 1e3, drive.throat_radius * 1e3
    middle = a - throat
    radius, length = drive.rollers.profile.radius * 1e3, drive.rollers.profile.length * 1e3
    axes.add_patch(Circle((0, 0), middle - length / 2 - 4, fc="0.93", ec="0.5"))
    for number in range(drive.rollers.count):
        angle = 2 * np.pi * number / drive.rollers.count
        box = Rectangle((-radius, middle - length / 2), 2 * radius, length, fc="0.75", ec="0.3")
        box.set_transform(Affine2D().rotate(-angle) + axes.transData)
        axes.add_patch(box)
    for name, section in drive.sections.items():
        angle = np.linspace(section.first, section.last, 100)
        tip, root = (middle + end * 1e3 for end in (section.lowest, section.highest))
        inner = np.array([tip * np.sin(angle), tip * np.cos(angle)])
        edge = np.array([inner[0], 2 * a - inner[1]])
        for lower, upper, alpha in ((inner[1], edge[1], 0.15),):
            axes.fill_between(inner[0], lower, upper, color=COLOURS[name], alpha=alpha, lw=0)
        axes.plot(*inner, color=COLOURS[name])
        axes.plot(*edge, color=COLOURS[name])
        core = root * np.sin(angle), root * np.cos(angle)
        axes.plot(*core, color=COLOURS[name], ls=":")
        side = "idles, from the front" if name == "right" else "drives, from behind"
        axes.text(
            inner[0].mean(),
            a + 9,
            f"{name} section\n{side}",
            color=COLOURS[name],
            ha="center",
        )
        line = section.line(section.in_mesh(0.0), np.linspace(0, 1, 3)[:, None]).point * 1e3
        axes.plot(line[0], line[1], color="tab:red", lw=2.5)
    axes.axhline(a, color="0.4", lw=0.8, ls="-.")
    axes.text(-150, a + 2, "worm axis", size=8, color="0.4")
    axes.annotate("", (0, 0), (0, a), arrowprops={"arrowstyle": "<->", "lw": 0.8, "color": "0.3"})
    axes.text(3, a / 3, "a", color="0.3")
    axes.annotate(
        "", (0, middle), (0, 2 * a - middle), arrowprops={"arrowstyle": "<->", "color": "black"}
    )
    axes.text(0, 2 * a - middle + 16, r"$d_t = k\,a$", size=9, ha="center")
    arc = np.linspace(0, np.radians(40), 40)
    axes.plot(70 * np.sin(arc), 70 * np.cos(arc), color="0.3", lw=0.8)
    axes.plot([0, 112 * np.sin(arc[-1])], [0, 112 * np.cos(arc[-1])], color="0.3", lw=0.8)
    axes.text(18, 70, r"$\varphi$")
    axes.add_patch(
        FancyArrowPatch(
            (-70, 60),
            (70, 60),
            connectionstyle="arc3,rad=-0.35",
            arrowstyle="-|>",
            mutation_scale=16,
        )
    )
    axes.text(-8, 66, "motion of rollers", ha="right", size=9)
    axes.plot([], [], color="tab:red", lw=2.5, label="contact lines at one instant")
    axes.plot([], [], color="0.4", label="thread's tip")
    axes.plot([], [], color="0.4", ls=":", label="thread's root, where rollers end")
    axes.legend(loc="lower center", frameon=False, fontsize=8)
    axes.set_aspect("equal")
    axes.set(xlim=(-155, 155), ylim=(-70, 265), xlabel="x / mm", ylabel="y / mm")
    axes.set_title("View along the wheel axis (worm below the wheel: turned by 180°)", fontsize=10)


def draw_roller(axes):
    """One roller with its axis radial, tilted and axial, across the wheel's rim."""
    axes.plot([0, 0], [-1.5, 3.2], color="0.4", lw=0.8, ls="-.")
    axes.text(0.05, -1.45, "wheel's mid-plane", size=8, color="0.4", rotation=90)
    for tilt, style, name in (
        (0, "-", "radial, tilt 0"),
        (45, "--", "tilt 45°"),
        (90, ":", "axial, end face, tilt 90°"),
    ):
        box = Rectangle((-0.5, -0.55), 1.0, 1.1, fc="none", ec="black", ls=style, label=name)
        box.set_transform(Affine2D().rotate_deg(-tilt).translate(0, 1.0) + axes.transData)
        axes.add_patch(box)
        turn = np.radians(tilt)
        axes.annotate(
            "",
            (1.1 * np.sin(turn), 1 + 1.1 * np.cos(turn)),
            (0, 1),
            arrowprops={"arrowstyle": "-|>", "ls": style, "color": "tab:green"},
        )
    axes.plot(0, 1, "ko", ms=4)
    axes.text(-0.1, 2.15, "d", color="tab:green", ha="right")
    axes.annotate(
        "height of\nroller centre",
        (0.0, 0.2),
        (0.9, 0.2),
        arrowprops={"arrowstyle": "<->"},
        va="center",
    )
    axes.text(-1.4, -1.2, "wheel", color="0.4")
    axes.fill_between([-1.6, 1.6], -1.5, 0.0, color="0.93", zorder=0)
    axes.set_aspect("equal")
    axes.set(
        xlim=(-1.6, 1.8),
        ylim=(-1.5, 3.2),
        xlabel="direction of the wheel axis",
        ylabel="radial direction of the wheel",
    )
    axes.set_xticks([])
    axes.set_yticks([])
    axes.legend(loc="upper left", frameon=False, fontsize=8)
    axes.set_title("Orientations of a roller axis d at the rim of the wheel", fontsize=10)


if __name__ == "__main__":
    main()
