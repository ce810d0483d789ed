"""Fatigue of worm thread and rollers along the contact lines of both sections."""

import numpy as np
from matplotlib.figure import Figure

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import broken, new_figure, result_heading
from pyworm.result.result import Result
from pyworm.result.roller_risk import roller_risk


def draw_roller_fatigue(result: Result) -> Figure | None:
    """Fatigue ratio and probability of pitting of both bodies over wheel angle and station; None without."""
    field = roller_risk(result)
    if field is None:
        return None
    shown = _rows(field, result.body_names)
    sections = field["section"].values
    heading = result_heading(result, "fatigue along the contact line")
    figure = new_figure(9.5, 1 + 2.2 * len(shown), heading)
    panels = figure.subplots(len(shown), len(sections), squeeze=False, sharex="col", sharey=True)
    for row, (label, values, colours) in zip(panels, shown, strict=True):
        for panel, section in zip(row, sections, strict=True):
            angles = np.degrees(field["wheel_angle"].sel(section=section).values)
            here = values.sel(section=section).transpose("station", "phase")
            mesh = panel.pcolormesh(
                _edges(angles, angles[0], angles[-1]),
                _edges(field["station"].values, 0.0, 1.0),
                here,
                cmap=colours,
                vmin=0.0,
                vmax=float(values.max()),
            )
            most = f"maximum {float(here.max()):.3g}" if here.notnull().any() else "not solved"
            panel.set_title(f"{section} section, {most}", size="medium")
        figure.colorbar(mesh, ax=row, label=broken(label))
        row[0].set_ylabel("place on the line\n(0: nearer wheel axis)")
    for panel in panels[-1]:
        panel.set_xlabel("wheel angle of the roller / °")
    return figure


def _edges(centres: np.ndarray, first: float, last: float) -> np.ndarray:
    """Borders of cells around solved places, the outer ones as given."""
    return np.concatenate([[first], (centres[1:] + centres[:-1]) / 2, [last]])


def _rows(field: "xr.Dataset", bodies: tuple[str, str]) -> list[tuple[str, "xr.DataArray", str]]:
    """Label, values as shown and colours of each row; a probability of pitting only where there is one."""
    rows = []
    for body, name in enumerate(bodies, 1):
        ratio = QUANTITIES[f"fatigue_ratio_body_{body}"]
        if ratio.name not in field:
            continue
        rows.append((ratio.axis(ratio.words(bodies)), field[ratio.name], ratio.colours))
        pitting = QUANTITIES["pitting_probability"]
        probability = field[pitting.name].isel(body=body - 1)
        if probability.max() > 0:
            label = pitting.axis(f"{pitting.words()} ({name})")
            rows.append((label, pitting.number(probability), pitting.colours))
    return rows
