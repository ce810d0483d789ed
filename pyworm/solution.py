"""What a solve leaves behind: fields, figures with error bars, and how they were come by."""

from dataclasses import dataclass
from typing import Literal

import xarray as xr


@dataclass(frozen=True)
class Estimate:
    """A figure and its relative error bar, by origin (`pyworm.accuracy`).

    Attributes
    ----------
    value : float
        The figure in SI units.
    grid : float
        Error by the grid, from the climb over grids of halving spacing [-].
    domain : float
        Error by the end of the window, from one of twice the reach [-].
    algebra : float
        Error by stopping the Newton iteration [-].
    """

    value: float
    grid: float
    domain: float = 0.0
    algebra: float = 0.0

    @property
    def error(self) -> float:
        """Relative error, all origins together [-]."""
        return self.grid + self.domain + self.algebra


@dataclass(frozen=True)
class DryFigures:
    """Figures of the dry contact under the same load.

    Attributes
    ----------
    pressure_max : float
        Largest pressure [Pa].
    length, width : float
        Extent of the contact along its long direction and across it [m].
    approach : float
        Rigid approach [m].
    """

    pressure_max: float
    length: float
    width: float
    approach: float


@dataclass(frozen=True)
class Figures:
    """The figures of one lubricated contact.

    Attributes
    ----------
    film_min, film_central, pressure_max : Estimate
        Minimum film [m] (sub-grid), film at the contact point [m] and largest pressure [Pa].
    film_min_at : tuple of float
        Where the minimum film is, along each direction of the grid [m]: (x, y), or (x,) of a line contact.
    moes_m, moes_l : float
        Moes' load and lubricant parameters along the entrainment.
    load_error, mass_error : float
        Relative load imbalance; net over gross mass flow through the outline of the contact.
    residual : float
        Summed Reynolds residual over the summed wedge flow, at the end.
    film_min_kind : str
        Which minimum that is: "side lobe", "exit" or "middle"; of a line contact always "exit".
    film_exit_min, film_exit_min_at : float or None
        Minimum film on the entrainment line through the contact point [m] and how far along it [m]; None for
        a line contact, where it is the minimum film.
    dry : DryFigures or None
        The dry contact; None for a line contact, whose is Hertz's in closed form.
    """

    film_min: Estimate
    film_central: Estimate
    pressure_max: Estimate
    film_min_at: tuple[float, ...]
    moes_m: float
    moes_l: float
    load_error: float
    mass_error: float
    residual: float
    film_min_kind: str = "exit"
    film_exit_min: float | None = None
    film_exit_min_at: float | None = None
    dry: DryFigures | None = None


@dataclass(frozen=True)
class Cost:
    """What the solve took.

    Attributes
    ----------
    seconds : float
        Elapsed time of the film solve, all grids [s].
    convolutions : float
        Processor time of the same, in padded FFT convolutions on the finest grid.
    unit_seconds : float
        Processor time of one of them [s].
    """

    seconds: float
    convolutions: float
    unit_seconds: float = 0.0


@dataclass(frozen=True)
class Solution:
    """One solved scene.

    Attributes
    ----------
    name : str
        The scene's name.
    kind : str
        "point" or "line".
    phase : float or None
        Place in the mesh cycle.
    load : float
        Normal load [N], of a line contact that for each length [N/m].
    converged : bool
        Whether the figures may be trusted within their error bars.
    stop_reason : str
        Why the solver stopped.
    figures : Figures
        Scalars.
    fields : xarray.Dataset
        Fields over (y, x) in SI with units: gap, covered, dry_pressure, pressure, film,
        entrainment_x, entrainment_y, sliding_x, sliding_y. Those of a line contact are over x, and have no
        dry_pressure and nothing along y.
    history : xarray.Dataset
        Over iteration: points_x, points_y (not of a line contact), residual, load_error, krylov; of a point
        contact also the work of each step: convolutions, cycles and processor times by part.
    cost : Cost
        Time taken.
    """

    name: str
    kind: Literal["point", "line"]
    phase: float | None
    load: float
    converged: bool
    stop_reason: str
    figures: Figures
    fields: xr.Dataset
    history: xr.Dataset
    cost: Cost

    def summary(self) -> dict:
        """The scalars of this solution as one flat object, units in the keys.

        Places and grids are lists with an entry for each direction, [x, y] or [x]. What a line contact does
        not have (its own minimum at the exit, a dry contact other than Hertz's) has no key.
        """
        figures = self.figures
        return {
            "name": self.name,
            "kind": self.kind,
            "phase": self.phase,
            LOAD_KEYS[self.kind]: self.load,
            "converged": self.converged,
            "stop_reason": self.stop_reason,
            **_flat("film_min", "m", figures.film_min),
            "film_min_at_m": list(figures.film_min_at),
            "film_min_kind": figures.film_min_kind,
            **_flat("film_central", "m", figures.film_central),
            **_flat("pressure_max", "Pa", figures.pressure_max),
            **self._point_summary(),
            "moes_M": figures.moes_m,
            "moes_L": figures.moes_l,
            "grid": [self.fields.sizes[axis] for axis in ("x", "y") if axis in self.fields.sizes],
            "residual": figures.residual,
            "load_error": figures.load_error,
            "mass_error": figures.mass_error,
            "seconds": self.cost.seconds,
            "convolutions": self.cost.convolutions,
        }

    def _point_summary(self) -> dict[str, float]:
        """The scalars that only a point contact has."""
        figures = self.figures
        if figures.dry is None:
            return {}
        return {
            "film_exit_min_m": figures.film_exit_min,
            "film_exit_min_at_m": figures.film_exit_min_at,
            "dry_pressure_max_Pa": figures.dry.pressure_max,
            "dry_length_m": figures.dry.length,
            "dry_width_m": figures.dry.width,
            "dry_approach_m": figures.dry.approach,
        }


LOAD_KEYS = {"point": "load_N", "line": "load_per_length_N_m"}
"""Kind of contact -> what its load is called in summaries."""


def _flat(name: str, unit: str, estimate: Estimate) -> dict[str, float]:
    """A figure, its error bar and the parts of that under flat names."""
    return {
        f"{name}_{unit}": estimate.value,
        f"{name}_error": estimate.error,
        **{
            f"{name}_error_{part}": getattr(estimate, part)
            for part in ("grid", "domain", "algebra")
        },
    }
