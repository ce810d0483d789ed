"""What the pictures and tables of a roller enveloping worm drive show beside solutions."""

from typing import Any

import numpy as np
import xarray as xr

from pyworm.drives.roller_worm.film_formulas import REGIMES
from pyworm.drives.roller_worm.load_sharing import lever
from pyworm.io.variables import describe

KIND = "roller-worm"

PHASES = np.linspace(0.0, 1.0, 49)
"""Phases of either section at which the cycle is kept."""

STATIONS = np.linspace(0.02, 0.98, 9)
"""Shares of the contact line at which it is kept; the ends themselves touch with no length."""

SWEEP, ACROSS = 240, 5
"""Points along and across a section's flank in the picture of the drive."""

VARIED = {
    "roller_radius": np.array([0.6, 0.8, 1.0, 1.2, 1.4]),
    "throat_coefficient": np.array([0.6, 0.8, 1.0, 1.2, 1.4]),
}
"""Design values and the factors by which the sensitivity of the film to them is looked at."""

TILTS = np.radians([0.0, 15.0, 30.0, 45.0, 60.0])
"""Tilts of the rollers' axes at which it is."""


def roller_cycle_data(drive: Any) -> xr.Dataset:
    """The mesh cycle of both sections.

    Parameters
    ----------
    drive : RollerWormDrive
        The drive.
    """
    states = [
        [drive.state(name, float(phase), STATIONS) for phase in PHASES] for name in drive.sections
    ]
    place = "section", "phase", "station"

    def instant(read) -> tuple:
        return place[:2], np.array([[read(state) for state in row] for row in states], float)

    def point(read) -> tuple:
        return place, np.array([[read(state) for state in row] for row in states], float)

    def regime(read) -> tuple:
        values = np.array([[read(state) for state in row] for row in states], float)
        return ("section", "phase", "regime", "station"), values

    return describe(
        xr.Dataset(
            {
                "wheel_angle": instant(lambda s: s.contact.wheel_angle[0]),
                "roller_force": instant(lambda s: s.force),
                "line_length": instant(lambda s: s.length),
                "roller_speed": instant(lambda s: s.motion.roller_speed[0]),
                "rollers_in_mesh": instant(lambda s: len(s.shared.forces)),
                "wheel_turn": instant(lambda s: s.shared.turn),
                "contact_radius": point(lambda s: 1 / s.contact.curvature),
                "load_per_length": point(lambda s: s.load),
                "worm_velocity": point(lambda s: s.motion.worm[0]),
                "roller_velocity": point(lambda s: s.motion.roller[0]),
                "sliding_along": point(lambda s: s.motion.sliding[1]),
                "relative_spin": point(lambda s: s.motion.spin[0] - s.motion.spin[1]),
                "lever": point(lambda s: lever(s.contact)),
                "viscosity_parameter": point(lambda s: s.films.g_v),
                "elasticity_parameter": point(lambda s: s.films.g_e),
                "regime_number": point(lambda s: s.films.regime),
                "formula_film_min": point(lambda s: s.films.minimum),
                "formula_film_central": point(lambda s: s.films.central),
                "printed_film_min": point(lambda s: s.films.printed_minimum),
                "heated_share": point(lambda s: s.films.heated_share),
                "specific_film": point(lambda s: s.films.specific_film),
                "film_by_regime": regime(lambda s: s.films.by_regime),
                "printed_film_by_regime": regime(lambda s: s.films.printed),
                **_flanks(drive),
                **_lines_in_mesh(drive),
                **_sensitivity(drive),
            },
            coords={
                "section": list(drive.sections),
                "phase": PHASES,
                "station": STATIONS,
                "regime": list(REGIMES),
                "axis": ["x", "y", "z"],
                "end": ["entry", "exit"],
            },
            attrs={
                "drive": KIND,
                "roller_pitch": float(2 * np.pi / drive.rollers.count),
                "rollers": drive.rollers.count,
            },
        )
    )


def _flanks(drive: Any) -> dict[str, tuple]:
    """Both sections' flanks in the worm's frame, and rollers at the instant the worm stands there."""
    flanks, rollers = [], []
    for section in drive.sections.values():
        angles = np.linspace(section.first, section.last, SWEEP)
        places = np.linspace(section.lowest, section.highest, ACROSS)[:, None]
        flanks.append(np.moveaxis(section.envelope.worm_point(places, angles + 0 * places), 0, -1))
    envelope, profile = section.envelope, drive.rollers.profile
    along = np.linspace(-profile.length / 2, profile.length / 2, ACROSS)
    round_ = np.linspace(0, 2 * np.pi, 25)
    radius = profile(along)[0] - profile.relief(along)
    for angle in 2 * np.pi / drive.rollers.count * np.arange(drive.rollers.count):
        going, side, axis, middle = (vector[:, None, None] for vector in envelope.axes(angle))
        out = np.cos(round_) * going + np.sin(round_) * side
        surface = middle + along[:, None] * axis + radius[:, None] * out
        rollers.append(np.moveaxis(surface, 0, -1))
    return {
        "flank": (("section", "across", "sweep", "axis"), np.array(flanks)),
        "roller_surface": (("roller", "across", "round", "axis"), np.array(rollers)),
    }


def _lines_in_mesh(drive: Any) -> dict[str, tuple]:
    """Contact lines of all rollers in mesh while the worm stands as in `_flanks`."""
    lines, names, forces = [], [], []
    share = np.linspace(0, 1, ACROSS)[:, None]
    for name in drive.sections:
        shared = drive.shared(name, 0.0)
        contact = shared.section.line(shared.wheel_angles, share)
        lines += list(np.moveaxis(contact.point, 0, -1).transpose(1, 0, 2))
        names += [list(drive.sections).index(name)] * len(shared.forces)
        forces += list(shared.forces)
    return {
        "contact_line": (("line", "across", "axis"), np.array(lines)),
        "line_section": ("line", np.array(names)),
        "line_force": ("line", np.array(forces)),
    }


def _sensitivity(drive: Any) -> dict[str, tuple]:
    """Least closed-form film of entry and exit under changed design values; NaN where there is no drive."""
    varied = [
        *(
            [(name, value * factor) for factor in factors]
            for (name, factors), value in zip(
                VARIED.items(),
                (drive.rollers.profile.radius, drive.worm.throat_coefficient),
                strict=True,
            )
        ),
        [("tilt", tilt) for tilt in TILTS],
    ]
    films = np.full((len(varied), len(TILTS), len(drive.sections), 2), np.nan)
    for number, row in enumerate(varied):
        for step, (name, value) in enumerate(row):
            try:
                other = drive.varied(name, value)
            except ValueError:  # undercut, or rollers too thick
                continue
            for place, section in enumerate(drive.sections):
                for end, phase in enumerate((0.0, 1.0)):
                    films[number, step, place, end] = np.min(
                        other.state(section, phase, STATIONS).films.minimum
                    )
    values = np.array([[value for _, value in row] for row in varied])
    return {
        "varied_value": (("parameter", "step"), values),
        "varied_film": (("parameter", "step", "section", "end"), films),
    }
