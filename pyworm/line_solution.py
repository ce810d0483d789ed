"""What a line contact's solve leaves behind: figures with error bars, profiles, and how they came about."""

from dataclasses import dataclass

from pyworm.line_scene import Array
from pyworm.solution import Estimate


@dataclass(frozen=True)
class LineReading:
    """Figures on one grid: films [m] and where the smallest is [m], pressure [Pa]."""

    points: int
    film_central: float
    film_min: float
    film_min_at: float
    pressure_max: float


@dataclass(frozen=True)
class LineStride:
    """One Newton step: grid points, balance reached, GMRES iterations."""

    points: int
    residual: float
    load_error: float
    krylov: int


@dataclass(frozen=True)
class LineSolution:
    """A solved line contact.

    Attributes
    ----------
    converged : bool
        Whether the figures may be trusted within their error bars.
    stop_reason : str
        Why the climb ended.
    film_central : Estimate
        Film at x = 0 [m]. Moes' formulas mean the film where the pressure is largest instead.
    film_min : Estimate
        Smallest film [m], of a parabola through the smallest nodal one.
    film_min_at : float
        Where it is [m].
    pressure_max : Estimate
        Largest pressure [Pa], of a parabola likewise.
    residual, load_error : float
        Summed Reynolds residual over the summed wedge flow; missing load over the load.
    x, gap, pressure, film, density : numpy.ndarray
        Nodes [m], undeformed gap [m], pressure [Pa], film [m], density over the ambient one.
    readings : tuple of LineReading
        Figures on every grid, for observed orders.
    strides : tuple of LineStride
        All Newton steps.
    """

    converged: bool
    stop_reason: str
    film_central: Estimate
    film_min: Estimate
    film_min_at: float
    pressure_max: Estimate
    residual: float
    load_error: float
    x: Array
    gap: Array
    pressure: Array
    film: Array
    density: Array
    readings: tuple[LineReading, ...]
    strides: tuple[LineStride, ...]
