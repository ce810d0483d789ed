"""Processor time of one FFT convolution, the unit of cost."""

from collections.abc import Callable
from statistics import median
from time import perf_counter, process_time

from pyworm.kernel.line_film import LineFilm
from pyworm.kernel.point_film import PointFilm

TIMED_CONVOLUTIONS = 10
"""Convolutions timed for the unit of cost, which is their median."""


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
