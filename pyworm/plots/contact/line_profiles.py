"""Pressure, film, temperature and friction of a line contact across the line."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.hertz import HertzLine, hertz_line
from pyworm.io.plain_dataset import AnyDataset
from pyworm.io.present import present
from pyworm.io.quantities import BODIES, QUANTITIES
from pyworm.plots.contact.film import thickest_shown
from pyworm.plots.contact.profiles import draw_profile
from pyworm.plots.error_bars import BODY_COLOURS
from pyworm.plots.layout import MICRO, MILLI, add_grids, heading, placed_panels
from pyworm.solver.solution import Solution

SHOWN_PRESSURE_RATIO = 0.01
"""Pressure, over the largest, down to which the inlet is shown."""

MARGIN_FRACTION = 0.1
"""What is shown beyond the contact and the pressure, as a fraction of their width."""


def draw_line_profiles(case_name: str, solution: Solution) -> Figure:
    """Film pressure, Hertz pressure (dashed) and film."""
    fields = solution.fields
    contact = hertz_of(fields)
    figure, axes = _panel(case_name, solution, (0.75, 0.75, 0.85, 0.1))
    handles = draw_profile(axes, fields, "x", contact.pressure, thickest_shown(solution) * MICRO)
    figure.legend(handles=handles, loc="lower center", ncols=4, frameon=False)
    return figure


def _panel(
    case_name: str, solution: Solution, room: tuple[float, float, float, float]
) -> tuple[Figure, Axes]:
    """A figure and its panel, across the line."""
    figure, (axes,) = placed_panels((9, 4.8), heading(case_name, solution), room)
    axes.set_xlim(*shown(solution.fields))
    axes.set_xlabel("x / mm")
    return figure, axes


def hertz_of(fields: AnyDataset) -> HertzLine:
    """The Hertz contact of the line contact that the fields belong to."""
    scene = fields.attrs
    return hertz_line(scene["radius_m"], scene["load_per_length_N_m"], scene["reduced_modulus_Pa"])


def shown(fields: AnyDataset) -> tuple[float, float]:
    """Ends of pictures [mm]: the dry contact and all but the faintest pressure, within the grid."""
    x, pressure = fields["x"].values, fields["pressure"].values
    half_width = hertz_of(fields).half_width
    pressed = x[pressure > SHOWN_PRESSURE_RATIO * pressure.max()]
    loaded = np.append(pressed, [-half_width, half_width])
    margin = MARGIN_FRACTION * np.ptp(loaded)
    low, high = max(x[0], loaded.min() - margin), min(x[-1], loaded.max() + margin)
    return low * MILLI, high * MILLI


STRESS_COLOUR, POWER_COLOUR = "tab:purple", "tab:red"

_PLACES = "body_1", "body_2", "middle"
"""Where temperatures are shown: at both surfaces, and between them."""


def draw_line_temperature(
    case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES
) -> Figure:
    """Temperature of both surfaces and of the middle of the film."""
    fields = solution.fields
    figure, axes = _panel(case_name, solution, (0.75, 0.1, 0.85, 0.1))
    maximum = QUANTITIES["temperature_max"]
    labels = (*(f"surface of {body}" for body in bodies), "middle of the film")
    for place, label, colour in zip(_PLACES, labels, BODY_COLOURS, strict=True):
        temperature = maximum.number(fields[f"temperature_{place}"])
        axes.plot(fields["x"] * MILLI, temperature, color=colour, label=label)
    inlet = maximum.number(present(solution.inlet_temperature, "inlet_temperature"))
    axes.axhline(inlet, color="0.4", linestyle="--", label="inlet")
    axes.set_ylabel(maximum.axis("temperature"))
    add_grids([axes])
    figure.legend(loc="lower center", ncols=4, frameon=False)
    return figure


def draw_line_friction(case_name: str, solution: Solution) -> Figure:
    """Shear stress in the middle of the film, and friction power."""
    fields = solution.fields
    figure, axes = _panel(case_name, solution, (0.75, 0.75, 0.55, 0.35))
    place = fields["x"] * MILLI
    stress, power = QUANTITIES["shear_stress"], QUANTITIES["friction_power"]
    axes.plot(place, stress.number(fields["shear_stress_x"]), color=STRESS_COLOUR)
    axes.axhline(0, color="0.7", linewidth=0.8)
    axes.set_ylabel(stress.axis(), color=STRESS_COLOUR)
    title = solution.neglected_effects.qualified(QUANTITIES["friction_coefficient"].words())
    friction = present(solution.figures.friction_coefficient, "friction_coefficient").value
    axes.set_title(f"{title}: {friction:.3g}", fontsize="medium", y=1)
    power_axes = axes.twinx()
    power_axes.plot(place, power.number(fields["friction_power"]), color=POWER_COLOUR)
    power_axes.set_ylim(bottom=0)
    power_axes.set_ylabel(power.axis(), color=POWER_COLOUR)
    return figure
