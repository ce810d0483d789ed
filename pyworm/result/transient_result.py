"""The result of `pyworm.transient`: a contact's films over time."""

import os
from dataclasses import dataclass
from functools import cached_property
from math import isfinite
from pathlib import Path

from pyworm.io.on_demand import lazy_property
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import attributes
from pyworm.io.shown import Shown
from pyworm.result.life import ContactLife, lives
from pyworm.result.result import Result
from pyworm.solver.solution import Solution


@dataclass(frozen=True, repr=False)
class TransientResult(Shown):
    """Films, friction and temperatures of a contact over time."""

    result: Result
    """The solution at the present, whose `life` holds all times, as files keep it."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the films over time in words."""
        film, error, seconds = self.over_time.extreme("film_min")
        thinnest = f"{film * 1e6:.4g} ± {error * 1e6:.2g} µm" if isfinite(film) else "not resolved"
        return f"TransientResult {self.solution.name}", {
            "status": self.solution.shown()[1]["status"],
            "times": f"{self.over_time.seconds.size} to {self.over_time.seconds[-1] * 1e3:.4g} ms",
            "film_min": f"{thinnest} at {seconds * 1e3:.4g} ms",
        }

    @property
    def solution(self) -> Solution:
        """The film at the present, the last time at which the surfaces move, on finer grids."""
        return self.result.solutions[0]

    @property
    def converged(self) -> bool:
        """Whether that film may be trusted within its uncertainties."""
        return self.solution.converged

    @property
    def accurate(self) -> bool:
        """Whether that film has the requested accuracy."""
        return self.solution.accurate

    @cached_property
    def dataset(self) -> "xr.Dataset":
        """Results over `time` [s], the time steps of the finest transient solve.

        `load`, `entrainment` and, as far as simulated, film_min, film_central, pressure_max,
        friction_coefficient, friction_boundary, asperity_load_fraction, power_loss, shear_rate_max and the
        maximum temperatures, each with its numerical uncertainty in the same unit, `film_min_error`. Films
        are NaN where they are thinner than the grid of that solve shows, as at a start from rest.
        """
        life = self.over_time
        variables = {
            name: ("time", values, attributes(f"life_{name}"))
            for figure in life.figures
            for name, values in (
                (figure, life.figures[figure]),
                (f"{figure}_error", life.errors[figure]),
            )
        }
        load = attributes("life_load")
        if life.kind == "line":
            load["units"] = "N/m"
        motion = {
            "load": ("time", life.load, load),
            "entrainment": ("time", life.entrainment, attributes("life_entrainment_x")),
        }
        return xr.Dataset(
            motion | variables,
            {"time": ("time", life.seconds, attributes("life_seconds"))},
            {"name": self.solution.name, "accuracy": self.solution.accuracy},
        )

    plot = lazy_property(
        "pyworm.plots.of_transient",
        "TransientPictures",
        "Its pictures: `plot.history()` over time, `plot.animation(path)` of pressure and film thickness.",
    )

    def animate(self, path: str | os.PathLike) -> Path:
        """Write an animation of pressure and film thickness over time.

        Args:
            path: The file, .gif or .mp4 (needs ffmpeg).

        Raises:
            ValueError: Another ending, or no program that writes such a file here.
        """
        written: Path = self.plot.animation(path)
        return written

    def save(self, path: str | os.PathLike) -> Path:
        """Write one NetCDF file, which `pyworm.open_result` and `pyworm explore` read."""
        return self.result.save(path)

    @cached_property
    def over_time(self) -> ContactLife:
        """All times, of which `dataset` is the labelled form."""
        (life,) = lives(self.result)
        return life
