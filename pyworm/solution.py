"""What a solve leaves behind: fields, figures with error bars, and how they were come by."""

from dataclasses import asdict, dataclass

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
        Where the minimum film is, (x, y) [m].
    film_exit_min, film_exit_min_at : float
        Minimum film on the entrainment line through the contact point [m] and how far along it [m].
    dry : DryFigures
        The dry contact.
    moes_m, moes_l : float
        Moes' load and lubricant parameters along the entrainment.
    load_error, mass_error : float
        Relative load imbalance; net over gross mass flow through the outline of the contact.
    residual : float
        Summed Reynolds residual over the summed wedge flow, at the end.
    """

    film_min: Estimate
    film_central: Estimate
    pressure_max: Estimate
    film_min_at: tuple[float, float]
    film_exit_min: float
    film_exit_min_at: float
    dry: DryFigures
    moes_m: float
    moes_l: float
    load_error: float
    mass_error: float
    residual: float


@dataclass(frozen=True)
class Cost:
    """What the solve took.

    Attributes
    ----------
    seconds : float
        Elapsed time of the film solve, all grids [s].
    convolutions : float
        The same in padded FFT convolutions on the finest grid.
    """

    seconds: float
    convolutions: float


@dataclass(frozen=True)
class Solution:
    """One solved scene.

    Attributes
    ----------
    name : str
        The scene's name.
    phase : float or None
        Place in the mesh cycle.
    load : float
        Normal load [N].
    converged : bool
        Whether the figures may be trusted within their error bars.
    stop_reason : str
        Why the solver stopped.
    figures : Figures
        Scalars.
    fields : xarray.Dataset
        Fields over (y, x) in SI with units: gap, covered, dry_pressure, pressure, film,
        entrainment_x, entrainment_y, sliding_x, sliding_y.
    history : xarray.Dataset
        Over iteration: points_x, points_y, residual, load_error, krylov.
    cost : Cost
        Time taken.
    """

    name: str
    phase: float | None
    load: float
    converged: bool
    stop_reason: str
    figures: Figures
    fields: xr.Dataset
    history: xr.Dataset
    cost: Cost

    def summary(self) -> dict:
        """The scalars of this solution as one flat object, units in the keys."""
        figures = self.figures
        return {
            "name": self.name,
            "phase": self.phase,
            "load_N": self.load,
            "converged": self.converged,
            "stop_reason": self.stop_reason,
            "film_min_m": figures.film_min.value,
            "film_min_error": figures.film_min.error,
            **_parts("film_min", figures.film_min),
            "film_min_at_m": list(figures.film_min_at),
            "film_central_m": figures.film_central.value,
            "film_central_error": figures.film_central.error,
            **_parts("film_central", figures.film_central),
            "film_exit_min_m": figures.film_exit_min,
            "film_exit_min_at_m": figures.film_exit_min_at,
            "pressure_max_Pa": figures.pressure_max.value,
            "pressure_max_error": figures.pressure_max.error,
            **_parts("pressure_max", figures.pressure_max),
            "dry_pressure_max_Pa": figures.dry.pressure_max,
            "dry_length_m": figures.dry.length,
            "dry_width_m": figures.dry.width,
            "dry_approach_m": figures.dry.approach,
            "moes_M": figures.moes_m,
            "moes_L": figures.moes_l,
            "grid": [self.fields.sizes["x"], self.fields.sizes["y"]],
            "residual": figures.residual,
            "load_error": figures.load_error,
            "mass_error": figures.mass_error,
            **asdict(self.cost),
        }


def _parts(name: str, estimate: Estimate) -> dict[str, float]:
    """The parts of an error bar under flat names."""
    return {
        f"{name}_error_{part}": getattr(estimate, part) for part in ("grid", "domain", "algebra")
    }
