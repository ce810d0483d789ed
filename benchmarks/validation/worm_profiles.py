"""One worm drive with flanks of each profile: pattern, radii, films, friction and loss side by side.

Run from the repository's root (some two minutes):

    python benchmarks/validation/worm_profiles.py docs/pictures/worm_profiles.png

Sizes, torque, oil and accuracy are the same for all. Films are thermal, steady and of smooth flanks, as each
profile's geometry makes them; the standard's ratio of its film parameters h* is beside them.
"""

import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import pyworm
from pyworm.case.case import case_of
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.drives.worm.drive import WormDrive
from pyworm.plots.layout import new_figure
from pyworm.result.contact_loss import contact_losses
from pyworm.solver.solution import Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

PROFILES = {"ZA": "C0", "ZN": "C1", "ZI": "C2", "ZK": "C4", "ZC": "C3", "ZC2": "C5"}
"""Profile -> its colour."""

PHASES = 0.1, 0.3, 0.5, 0.7, 0.9

ACCURACY, EFFECTS = 0.1, ("auto", "-roughness", "-squeeze")

STANDARD = 0.0900 / 0.0693
"""h* of ZH over that of ZI of the standard's reference gears (DIN 3996), as handed on in public papers."""

CASE = """
title = "One worm drive of every profile"
source = "An example"
accuracy = "10 %"
[drive]
kind = "worm"
profile = "{profile}"
centre_distance = "100 mm"
threads = 2
teeth = 39
module = "4 mm"
diameter_factor = 9.5
pressure_angle = "20 deg"
face_width = "30 mm"
[drive.hob]
oversize = "1.6 mm"
[operation]
worm_speed = "1500 1/min"
wheel_torque = "300 Nm"
friction = 0.03
phases = [{phases}]
[bodies.worm]
material = "16MnCr5"
finish = "ground"
[bodies.wheel]
material = "CuSn12Ni2-C-GZ"
finish = "run-in"
[oil]
name = "PAG VG 460"
temperature = "60 degC"
"""


@dataclass(frozen=True)
class Mesh:
    """A drive and its solved contacts."""

    drive: WormDrive
    """The drive."""
    solutions: tuple[Solution, ...]
    """One for each of `PHASES`."""
    loss: MeshLoss
    """Of all teeth."""


def solved(profile: str) -> Mesh:
    """The mesh of one profile."""
    text = CASE.format(profile=profile, phases=", ".join(map(str, PHASES)))
    case = case_of(tomllib.loads(text), profile, Path())
    solutions = []
    for phase in PHASES:
        scene = case.scene(phase=phase)
        solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=ACCURACY, effects=EFFECTS))
        print(
            profile,
            phase,
            f"{scene.load:.0f} N",
            solution.converged,
            f"{solution.cost.seconds:.0f} s",
        )
        solutions.append(solution)
    return Mesh(case.drive, tuple(solutions), case.drive.mesh_loss(contact_losses(solutions)))


COLUMNS = (
    "profile",
    "contact ratio",
    "transmission error / urad",
    "radii in mid-mesh / mm",
    "largest load / kN",
    "h_min / um",
    "mean h_min / um",
    "mean h_c / um",
    "p_max / MPa",
    "friction",
    "power loss / W",
)


def rows_of(meshes: dict[str, Mesh]) -> list[tuple[str, ...]]:
    """A row for each profile, under `COLUMNS`."""
    rows = []
    for name, mesh in meshes.items():
        drive, figures = mesh.drive, [one.figures for one in mesh.solutions]
        films = np.array([one.film_min.value for one in figures]) * 1e6
        error = drive.cycle.transmission_error(np.linspace(0, 1, 21)) * 1e6
        long, short = np.array(drive.contact(0.5).radii) * 1e3
        row = (
            name,
            f"{1 / drive.pitch:.2f}",
            f"{np.ptp(error):.0f}",
            f"{long:.0f} and {short:.1f}",
            f"{max(one.load for one in mesh.solutions) / 1e3:.2f}",
            f"{films.min():.3f}",
            f"{films.mean():.3f}",
            f"{np.mean([one.film_central.value for one in figures]) * 1e6:.3f}",
            f"{max(one.pressure_max.value for one in figures) / 1e6:.0f}",
            f"{mesh.loss.friction:.4f} ± {mesh.loss.error * mesh.loss.friction:.4f}",
            f"{mesh.loss.loss:.0f}",
        )
        rows.append(row)
    return rows


def draw(meshes: dict[str, Mesh]) -> Figure:
    """Patterns on the wheel's flank, above radii, loads and films over the phase."""
    figure = new_figure(12, 11, "One worm gear set with every profile, a = 100 mm, 2/39, x = 0.75")
    rows = figure.subfigures(2, height_ratios=(3, 4))
    rows[0].supylabel("radius / mm", fontsize="medium")
    rows[0].supxlabel(
        "face width coordinate / mm, the worm's threads leave on the right; colours: pressure at the "
        "five phases; line: path of contact, from the tip to the root",
        fontsize="medium",
    )
    panels = rows[0].subplots(2, -(-len(meshes) // 2), sharex=True, sharey=True).ravel()
    for axes, (name, mesh) in zip(panels[: len(meshes)], meshes.items(), strict=True):
        _draw_pattern(axes, mesh)
        axes.set_title(name, color=PROFILES[name])
    below = rows[1].subplots(2, 2, sharex=True).ravel()
    labels = (
        "larger radius of curvature / m",
        "smaller radius of curvature / mm",
        "normal load / kN",
        "minimum film thickness / µm",
    )
    for name, mesh in meshes.items():
        radii = np.array([mesh.drive.contact(phase).radii for phase in PHASES])
        loads = [one.load / 1e3 for one in mesh.solutions]
        films = [one.figures.film_min.value * 1e6 for one in mesh.solutions]
        for axes, values in zip(below, (radii[:, 0], radii[:, 1] * 1e3, loads, films), strict=True):
            axes.plot(PHASES, values, "o-", markersize=4, color=PROFILES[name], label=name)
    for axes, label in zip(below, labels, strict=True):
        axes.set_ylabel(label)
        axes.set_ylim(bottom=0)
        axes.grid(True, color="0.9")
    for axes in below[2:]:
        axes.set_xlabel("mesh phase")
    below[1].legend(frameon=False, ncols=3)
    return figure


def _draw_pattern(axes: Axes, mesh: Mesh) -> None:
    """The wheel's flank from the leaving side: what is pressed at each phase, and the path of contact."""
    drive = mesh.drive
    rim = drive.wheel_flank.cut_point(*drive.rim)
    axes.plot(rim[1] * 1e3, np.hypot(rim[0], rim[2]) * 1e3, color="0.3")
    places = []
    for solution in mesh.solutions:
        contact, fields = drive.contact(solution.phase), solution.fields
        x, y = np.meshgrid(fields["x"].values, fields["y"].values)
        face, radius = drive.flank_place(contact, x, y)
        axes.contourf(
            face * 1e3,
            radius * 1e3,
            fields["pressure"].values / 1e6,
            [50, 200, 400, 600, 900],
            cmap="YlOrRd",
        )
        places.append(contact.point)
    face, radius = np.transpose([(at[1], np.hypot(at[0], at[2])) for at in places]) * 1e3
    axes.plot(face, radius, "k.-", linewidth=0.8, markersize=3)
    axes.set_aspect("equal")


def main() -> None:
    meshes = {profile: solved(profile) for profile in sys.argv[2:] or PROFILES}
    record("worm_profiles", COLUMNS, rows_of(meshes), key=("profile",))
    if {"ZI", "ZC"} <= meshes.keys():
        films = {
            name: np.mean([one.figures.film_min.value for one in mesh.solutions])
            for name, mesh in meshes.items()
        }
        print(f"ZC over ZI: mean h_min {films['ZC'] / films['ZI']:.2f}, standard {STANDARD:.2f}")
    draw(meshes).savefig(sys.argv[1], dpi=120)


if __name__ == "__main__":
    main()
