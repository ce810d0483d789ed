"""Picture of a roughness profile: its heights, Abbott curve and spectrum."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.plots.layout import MICRO, new_figure
from pyworm.plots.surface import draw_abbott
from pyworm.surfaces.profile import Profile
from pyworm.surfaces.profile_parameters import ProfileFigures
from pyworm.surfaces.spectrum import spectrum


def draw_profile(name: str, profile: Profile, figures: ProfileFigures) -> Figure:
    """Heights over the length, the Abbott curve with its core, and the power spectral density."""
    heading = (
        f"Profile {name}  ·  Rq {figures.rq * MICRO:.3g} µm, Rz {figures.rz * MICRO:.3g} µm, "
        f"Rdq {figures.slope:.3g}"
    )
    figure = new_figure(11, 6.5, heading)
    grid = figure.add_gridspec(2, 2)
    heights, curve, density = (
        figure.add_subplot(place) for place in (grid[0, :], grid[1, 0], grid[1, 1])
    )
    _draw_heights(heights, profile)
    draw_abbott(curve, profile.height[profile.measured], figures.mr1, figures.rk, "Rk")
    _draw_spectrum(density, profile)
    return figure


def _draw_heights(axes: Axes, profile: Profile) -> None:
    place = np.arange(len(profile.height)) * profile.spacing
    height = np.where(profile.measured, profile.height, np.nan)
    axes.plot(place * 1e3, height * MICRO, lw=0.7)
    axes.axhline(0.0, color="0.5", lw=0.7)
    axes.set_xlim(0, profile.length * 1e3)
    axes.set_xlabel("x / mm")
    axes.set_ylabel("height / µm")
    axes.set_title("roughness profile", fontsize="medium")


def _draw_spectrum(axes: Axes, profile: Profile) -> None:
    wavenumber, density = spectrum(profile)
    axes.loglog(2 * np.pi / wavenumber * MICRO, density * MICRO**3, lw=1)
    axes.invert_xaxis()
    axes.set_xlabel("wavelength / µm")
    axes.set_ylabel("power spectral density / µm³")
    axes.set_title("spectrum", fontsize="medium")
    axes.grid(True, color="0.9")
