"""Dataset of a roller enveloping worm drive for pictures and tables."""

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np

from pyworm.drives.roller_worm.indices import lubrication_angle, self_rotation_angle
from pyworm.drives.roller_worm.load_sharing import lever
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.pins import pin_load
from pyworm.drives.roller_worm.rotation_data import rotation_data
from pyworm.formulas.film_atlas import reciprocal_alpha
from pyworm.formulas.regimes import REGIMES
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import describe

KIND = "roller-worm"

PHASES = np.linspace(0.0, 1.0, 49)
"""Phases of either section at which the cycle is sampled."""

STATIONS = np.linspace(0.02, 0.98, 9)
"""Fractions of the contact line at which it is sampled; at its ends the contact line has no length."""

SWEEP, ACROSS = 240, 5
"""Points along and across a section's flank in the picture of the mesh."""

VARIED = {
    "roller_radius": np.array([0.6, 0.8, 1.0, 1.2, 1.4]),
    "throat_coefficient": np.array([0.6, 0.8, 1.0, 1.2, 1.4]),
}
"""Design values and their factors in the sensitivity of the film."""

TILTS = np.radians([0.0, 15.0, 30.0, 45.0, 60.0])
"""Tilts of the rollers' axes in the sensitivity of the film [rad]."""


def roller_cycle_data(mesh: RollerMesh) -> "xr.Dataset":
    """The mesh cycle of both sections."""
    return describe(
        xr.Dataset(
            {
                **_contact_lines(mesh),
                **_flanks(mesh),
                **_lines_in_mesh(mesh),
                **_sensitivity(mesh),
                **rotation_data(mesh),
            },
            coords={
                "section": list(mesh.sections),
                "phase": PHASES,
                "station": STATIONS,
                "regime": list(REGIMES),
                "axis": ["x", "y", "z"],
                "end": ["entry", "exit"],
            },
            attrs={
                "drive": KIND,
                "driving": mesh.driving,
                "roller_pitch": float(2 * np.pi / mesh.rollers.count),
                "rollers": mesh.rollers.count,
                "alpha_ratio": reciprocal_alpha(mesh.oil.viscosity, mesh.oil.viscosity.alpha),
            },
        )
    )


_OF_A_LINE = {
    "wheel_angle": lambda s: s.contact.wheel_angle[0],
    "roller_force": lambda s: s.force,
    "line_length": lambda s: s.length,
    "roller_speed": lambda s: s.motion.roller_speed[0],
    "rollers_in_mesh": lambda s: len(s.shared.forces),
    "wheel_turn": lambda s: s.shared.turn,
}
"""Name -> a scalar of a contact line's state."""

_ALONG_A_LINE = {
    "contact_radius": lambda s: 1 / s.contact.curvature,
    "load_per_length": lambda s: s.load,
    "worm_velocity": lambda s: s.motion.worm[0],
    "roller_velocity": lambda s: s.motion.roller[0],
    "sliding_along": lambda s: s.motion.sliding[1],
    "lubrication_angle": lambda s: lubrication_angle(s.section.envelope, s.contact),
    "self_rotation_angle": lambda s: self_rotation_angle(s.section.envelope, s.contact),
    "induced_curvature": lambda s: s.contact.curvature,
    "relative_spin": lambda s: s.motion.spin[0] - s.motion.spin[1],
    "lever": lambda s: lever(s.contact),
    "viscosity_parameter": lambda s: s.films.g_v,
    "elasticity_parameter": lambda s: s.films.g_e,
    "regime_number": lambda s: s.films.regime,
    "formula_film_min": lambda s: s.films.minimum,
    "formula_film_central": lambda s: s.films.central,
    "printed_film_min": lambda s: s.films.printed_minimum,
    "heated_share": lambda s: s.films.heated_share,
    "specific_film": lambda s: s.films.specific_film,
}
"""Name -> values at the stations of a contact line."""

_BY_REGIME = {
    "film_by_regime": lambda s: s.films.by_regime,
    "printed_film_by_regime": lambda s: s.films.printed,
}
"""Name -> films by the formula of each regime at the stations of a contact line."""


def _contact_lines(mesh: RollerMesh) -> dict[str, tuple]:
    """Variables of a roller's contact line over both sections."""
    states = [
        [mesh.state(name, float(phase), STATIONS.tolist()) for phase in PHASES]
        for name in mesh.sections
    ]
    tables: tuple[tuple[dict[str, Callable[[Any], Any]], tuple[str, ...]], ...] = (
        (_OF_A_LINE, ("section", "phase")),
        (_ALONG_A_LINE, ("section", "phase", "station")),
        (_BY_REGIME, ("section", "phase", "regime", "station")),
    )
    pins = [[pin_load(mesh, name, float(phase)) for phase in PHASES] for name in mesh.sections]
    return {
        "pin_radial": (
            ("section", "phase"),
            np.array([[pin.radial for pin in row] for row in pins]),
        ),
        "pin_axial": (("section", "phase"), np.array([[pin.axial for pin in row] for row in pins])),
    } | {
        name: (axes, np.array([[read(state) for state in row] for row in states], float))
        for table, axes in tables
        for name, read in table.items()
    }


def _flanks(mesh: RollerMesh) -> dict[str, tuple]:
    """Both sections' flanks in the worm's frame, and the rollers at that position of the worm."""
    flanks, rollers = [], []
    for section in mesh.sections.values():
        angles = np.linspace(section.first, section.last, SWEEP)
        places = np.linspace(section.lowest, section.highest, ACROSS)[:, None]
        flanks.append(np.moveaxis(section.envelope.worm_point(places, angles + 0 * places), 0, -1))
    profile = mesh.rollers.profile
    along = np.linspace(-profile.length / 2, profile.length / 2, ACROSS)
    round_ = np.linspace(0, 2 * np.pi, 25)
    radius = profile(along)[0] - profile.relief(along)
    steps = range(mesh.rollers.count)
    for row, angle in product(mesh.rows, [2 * np.pi / mesh.rollers.count * step for step in steps]):
        going, side, axis, middle = (
            vector[:, None, None] for vector in row.envelope.axes(np.array(angle))
        )
        out = np.cos(round_) * going + np.sin(round_) * side
        surface = middle + along[:, None] * axis + radius[:, None] * out
        rollers.append(np.moveaxis(surface, 0, -1))
    return {
        "flank": (("section", "across", "sweep", "axis"), np.array(flanks)),
        "roller_surface": (("roller", "across", "round", "axis"), np.array(rollers)),
    }


def _lines_in_mesh(mesh: RollerMesh) -> dict[str, tuple]:
    """Contact lines of all rollers in mesh at the position of the worm in `_flanks`."""
    lines, names, forces = [], [], []
    fraction = np.linspace(0, 1, ACROSS)[:, None]
    for name in mesh.sections:
        shared = mesh.shared(name, 0.0)
        contact = shared.section.line(shared.wheel_angles, fraction)
        lines += list(np.moveaxis(contact.point, 0, -1).transpose(1, 0, 2))
        names += [list(mesh.sections).index(name)] * len(shared.forces)
        forces += list(shared.forces)
    return {
        "contact_line": (("line", "across", "axis"), np.array(lines)),
        "line_section": ("line", np.array(names)),
        "line_force": ("line", np.array(forces)),
    }


def _sensitivity(mesh: RollerMesh) -> dict[str, tuple]:
    """Least closed-form film of entry and exit under changed design values; NaN where there is no mesh."""
    varied = [
        *(
            [(name, value * factor) for factor in factors]
            for (name, factors), value in zip(
                VARIED.items(),
                (mesh.rollers.profile.radius, mesh.worm.throat_coefficient),
                strict=True,
            )
        ),
        [("tilt", tilt) for tilt in TILTS],
    ]
    films = np.full((len(varied), len(TILTS), len(mesh.sections), 2), np.nan)
    for number, row in enumerate(varied):
        for step, (name, value) in enumerate(row):
            try:
                other = mesh.varied(name, value)
            except ValueError:  # undercut, or rollers too thick
                continue
            for place, section in enumerate(mesh.sections):
                for end, phase in enumerate((0.0, 1.0)):
                    films[number, step, place, end] = np.min(
                        other.state(section, phase, STATIONS.tolist()).films.minimum
                    )
    values = np.array([[value for _, value in row] for row in varied])
    return {
        "varied_value": (("parameter", "step"), values),
        "varied_film": (("parameter", "step", "section", "end"), films),
    }
