"""Cost of a solve, and the processor time of one FFT convolution, its unit."""

from collections.abc import Callable
from statistics import median
from time import perf_counter, process_time

from pyworm.kernel.line_film import LineFilm
from pyworm.kernel.point_film import PointFilm
from pyworm.solver.solution import Cost

TIMED_CONVOLUTIONS = 10
"""Convolutions timed for the unit of cost, which is their median."""


class Stopwatch:
    """Elapsed and processor time since it was made."""

    def __init__(self) -> None:
        self._seconds, self._work = perf_counter(), process_time()

    def cost(self, film: PointFilm | LineFilm) -> Cost:
        """Cost so far, in convolutions on a film's grid."""
        seconds, work = perf_counter() - self._seconds, process_time() - self._work
        unit = convolution_seconds(film)
        return Cost(seconds, work / unit, unit)


def convolution_seconds(film: PointFilm | LineFilm) -> float:
    """Processor time of one convolution on a film's grid, the unit of cost [s].

    Elapsed time would include other load of the machine. It is used where the processor's clock has a
    resolution of milliseconds only, as under a limit on processor time (`ulimit -t`, batch systems).
    """
    return _median_convolution(film, process_time) or _median_convolution(film, perf_counter)


def _median_convolution(film: PointFilm | LineFilm, clock: Callable[[], float]) -> float:
    times = []
    for _ in range(TIMED_CONVOLUTIONS):
        started = clock()
        film.convolve()
        times.append(clock() - started)
    return median(times)
