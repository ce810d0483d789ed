"""The time steps of a transient solve, each on a grid of its course."""

from dataclasses import dataclass

from pyworm.solver.transient.course import Course

COARSE, COARSE_FROM = 1.0, 2
"""Transits after a steady beginning whose films are solved on the grid before, with its time step, and
halvings from which on they are: what the first solve is off would leave 0.5 % in a film a transit later, what
the second is off leaves 0.13 % where two solves leave 12."""


@dataclass(frozen=True)
class Step:
    """A film of a transient solve that is to be found.

    Attributes
    ----------
    seconds : float
        Its time [s].
    refinement : int
        Halvings of the grid on which it is.
    """

    seconds: float
    refinement: int


def steps_of(course: Course, refinement: int, begin: float, last: float) -> list[Step]:
    """Steps of the march, up to the first after the last time that is wanted."""
    return [
        Step(course.instant(place), on)
        for on, place in places_of(course, refinement, begin, course.transits(last))
    ]


def places_of(
    course: Course, refinement: int, begin: float, last: float
) -> list[tuple[int, float]]:
    """The same as refinements and places, up to a place [transits].

    What a steady film is off where the life has begun before is forgotten on the grid before, at an eighth of
    the cost.
    """
    if refinement < COARSE_FROM or begin == 0:
        return _on_one_grid(course, refinement, begin, last)
    fine = begin + COARSE
    before = _on_one_grid(course, refinement - 1, begin, fine)
    count = round(COARSE / course.step(refinement - 1))
    return before[:count] + _on_one_grid(course, refinement, fine, last)


def _on_one_grid(
    course: Course, refinement: int, begin: float, last: float
) -> list[tuple[int, float]]:
    """The same from a place on, on one grid."""
    step = course.step(refinement)
    whole = course.transits(course.end)
    count = int((last - begin) / step) + 1
    places = [begin + step * number for number in range(count + 1)]
    kept = [place for place in places if place < whole - step / 2]
    kept += [whole] * (places[-1] >= whole - step / 2)
    return [(refinement, place) for place in kept]
