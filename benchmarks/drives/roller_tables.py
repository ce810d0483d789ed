"""The tables of the roller drive's source beside computed values, as in `docs/evidence/validation.md`.

python benchmarks/drives/roller_tables.py          # closed forms, and line contacts solved: a minute
"""

import sys
from dataclasses import replace
from math import atan, cos, degrees, sin
from pathlib import Path

import numpy as np

import pyworm
from pyworm.formulas.roller_enveloping import normal_force, printed_minimum, printed_normal_force
from pyworm.materials.body import reduced_modulus

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

CASE = Path(__file__).parents[2] / "cases" / "roller_ref.toml"

ENDS = (
    ("left", 0.0, "entry"),
    ("left", 1.0, "exit"),
    ("right", 0.0, "entry"),
    ("right", 1.0, "exit"),
)

SOURCE = {
    "roller_radius": {
        4.5e-3: (0.532, 1.452, 1.385, 0.562),
        6.5e-3: (0.486, 1.210, 1.128, 0.501),
        8.5e-3: (0.350, 0.950, 0.880, 0.410),
    },
    "throat_coefficient": {
        0.3: (0.450, 1.225, 1.180, 0.485),
        0.4: (0.486, 1.210, 1.128, 0.501),
        0.5: (0.528, 1.192, 1.095, 0.520),
    },
}
"""The source's minimum films [um] in the order of `ENDS`."""


def main():
    drive = pyworm.load(CASE).drive
    forces(drive)
    rows = []
    for name, table in SOURCE.items():
        for value, films in table.items():
            other = drive.varied(name, value)
            for (section, phase, end), film in zip(ENDS, films, strict=True):
                ours = [
                    by_source(replace(other, rolling="locked"), section, phase),
                    by_source(other, section, phase),
                    float(other.state(section, phase, [0.5]).films.minimum[0]),
                    solved(other, section, phase),
                ]
                label = f"R = {value * 1e3:g} mm" if value < 0.1 else f"k = {value:g}"
                shown = [f"{one * 1e6:.3f}" for one in (film * 1e-6, *ours)]
                rows.append((label, section, end, *shown))
    record("roller_films", COLUMNS, rows)


COLUMNS = (
    "size",
    "section",
    "end",
    "published / um",
    "its formula with locked rollers / um",
    "its formula with free rollers / um",
    "Dowson-Higginson / um",
    "solved / um",
)
"""Its formula is the source's, with its load; the last two have the load of the rollers in mesh."""


def forces(drive):
    """The source's normal force and the right one, beside that of the load sharing."""
    throat = drive.throat_radius
    lead = atan((drive.centre_distance - throat) / (drive.ratio * throat))
    print(f"lead angle at the throat {degrees(lead):.2f} deg")
    print(f"printed normal force {printed_normal_force(drive.torque, 2 * throat, 0, lead):.0f} N")
    print(f"with the sine        {normal_force(drive.torque, 2 * throat, 0, lead):.0f} N")
    shared = drive.shared("left", float(drive.sections["left"].wheel_angle(0.5)))
    print(f"shared by the driving section's rollers: {np.round(shared.forces)} N")
    print(
        f"entering the moment: {shared.forces.sum():.0f} N, cos/sin = {cos(lead) / sin(lead):.2f}"
    )


def by_source(drive, section, phase):
    """The source's formula with its own load: the cosine's force on the bearing length."""
    throat = drive.throat_radius
    lead = atan((drive.centre_distance - throat) / (drive.ratio * throat))
    force = printed_normal_force(drive.torque, 2 * throat, 0.0, lead)
    state = drive.state(section, phase, [0.5])
    oil = drive.oil.viscosity
    return printed_minimum(
        1 / float(state.contact.curvature[0]),
        force / (drive.worm.addendum + drive.worm.dedendum),
        reduced_modulus(*drive.bodies),
        float(state.motion.entrainment[0]),
        oil.eta0,
        oil.alpha,
    )


def solved(drive, section, phase):
    """Isothermal line contact."""
    scene = drive.scene(section, phase, 0.5)
    return pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal")).figures.film_min.value


if __name__ == "__main__":
    main()
