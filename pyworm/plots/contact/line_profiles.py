"""Pressure and film of a line contact across the line."""

import numpy as np
from matplotlib.figure import Figure

from pyworm.formulas.hertz import HertzLine, hertz_line
from pyworm.io.plain_dataset import AnyDataset
from pyworm.plots.contact.film import thickest_shown
from pyworm.plots.contact.profiles import draw_profile
from pyworm.plots.layout import MICRO, MILLI, heading, placed_panels
from pyworm.solver.solution import Solution

SHOWN = 0.01
"""Pressure, over the largest, down to which the inlet is shown."""

MARGIN = 0.1
"""What is shown beyond the contact and the pressure, as a fraction of their width."""


def draw_line_profiles(case_name: str, solution: Solution) -> Figure:
    """Film pressure, Hertz pressure (dashed) and film."""
    fields = solution.fields
    contact = hertz_of(fields)
    room = (0.75, 0.75, 0.85, 0.1)
    figure, axes = placed_panels((9, 4.8), heading(case_name, solution), room)
    handles = draw_profile(axes, fields, "x", contact.pressure, thickest_shown(solution) * MICRO)
    axes.set_xlim(*shown(fields))
    axes.set_xlabel("x / mm")
    figure.legend(handles=handles, loc="lower center", ncols=4, frameon=False)
    return figure


def hertz_of(fields: AnyDataset) -> HertzLine:
    """The Hertz contact of the line contact that the fields belong to."""
    scene = fields.attrs
    return hertz_line(scene["radius_m"], scene["load_per_length_N_m"], scene["reduced_modulus_Pa"])


def shown(fields: AnyDataset) -> tuple[float, float]:
    """Ends of pictures [mm]: the dry contact and all but the faintest pressure, within the grid."""
    x, pressure = fields["x"].values, fields["pressure"].values
    half_width = hertz_of(fields).half_width
    loaded = np.append(x[pressure > SHOWN * pressure.max()], [-half_width, half_width])
    margin = MARGIN * np.ptp(loaded)
    return (
        max(x[0], loaded.min() - margin) * MILLI,
        min(x[-1], loaded.max() + margin) * MILLI,
    )
