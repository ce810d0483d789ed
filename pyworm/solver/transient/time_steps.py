"""The time steps of a transient solve, each on a grid of its time grid."""

from dataclasses import dataclass

from pyworm.solver.transient.time_grid import TimeGrid

COARSE, COARSE_FROM = 1.0, 2
"""Transits after a steady beginning whose films are solved on the grid before, with its time step, and
halvings from which on they are: what the first solve is off would leave 0.5 % in a film a transit later, what
the second is off leaves 0.13 % where two solves leave 12."""

COARSE_WAY = 0.75
"""Share of the way to the first touch of surfaces that come together whose films are solved so as well,
from the second solve on. Films are thick there, and windows wide. In the least film of phases 0.02 and
0.1, 0.4 and 1.7 transits after the touch, it leaves 0.6 and 0.2 % of `cases/zi_drive.toml`, 0.8 and
0.03 % of `cases/worm_drawing.toml`; half of the way 0.4, 0.0, 0.4 and 0.02, nine tenths 0.2, 0.3, 2.7
and 0.1 (`benchmarks/accuracy/stretch_length.py`)."""

STRETCH = 1.25
"""Passages of oil before a wanted time through which a solve goes that begins from films of the one before:
by then oil has left the contact that these films have brought there.

Of what the first solve is off in the least film at phases 0.3 to 0.9, 16 to 25 % of
`cases/zi_drive.toml` and 3 to 10 % of `cases/worm_drawing.toml`, it leaves 0.1 to 0.3 % of the film and
at most 0.03; one transit leaves 0.4 to 1.7 and at most 0.14, one and a half at most 0.08 and 0.02
(`benchmarks/accuracy/stretch_length.py`)."""


FIRST_TRANSITS = 1.0
"""Transits after the beginning of a life under load whose time steps are half as long: there the film of the
first contact is carried through, and the error of the minimum film thickness falls slowly with the step."""


@dataclass(frozen=True)
class Step:
    """A film of a transient solve that is to be found."""

    seconds: float
    """Its time [s]."""
    refinement: int
    """Halvings of the grid on which it is."""


def steps_of(time_grid: TimeGrid, refinement: int, begin: float, last: float) -> list[Step]:
    """Steps of the time integration, up to the first after the last time that is wanted."""
    return [
        Step(time_grid.time_at(place), on)
        for on, place in places_of(time_grid, refinement, begin, time_grid.transits(last))
    ]


def in_stretches(time_grid: TimeGrid) -> bool:
    """Whether finer solves go through stretches of a life: lines cost little, a written course may jump."""
    return time_grid.plan.work.kind == "point" and not time_grid.life.kinks


def restart_place(time_grid: TimeGrid, seconds: float, solves: int) -> float | None:
    """Where the next solve begins from films of the present one for a wanted time [transits].

    None where it begins with the life.

    Args:
        seconds: The wanted time [s].
        solves: Number of solves after the present one; each begins a stretch before the next.
    """
    if not in_stretches(time_grid):
        return None
    place = time_grid.place_before(time_grid.place(seconds), STRETCH * solves)
    if time_grid.approach is None:
        return place if place >= FIRST_TRANSITS else None
    touched = time_grid.place(time_grid.life.touched)
    if place >= touched + FIRST_TRANSITS:
        return place
    # films that have just come together remember how
    return touched * (1 - (1 - COARSE_WAY) * solves) if time_grid.place(seconds) > touched else None


def steps_on(
    time_grid: TimeGrid, refinement: int, begin: float, place: float, last: float
) -> list[Step]:
    """Steps on one grid from a place of the solve before, up to the first after a time [s].

    Place and begin of that solve [transits] are those of steps of it: both share their times.
    """
    first = 2 * round((place - begin) / time_grid.step(refinement - 1))
    places = _on_one_grid(time_grid, refinement, begin, time_grid.transits(last), first)
    return [Step(time_grid.time_at(place), on) for on, place in places]


def places_of(
    time_grid: TimeGrid, refinement: int, begin: float, last: float
) -> list[tuple[int, float]]:
    """Refinement and place [transits] of each step, up to a place.

    What a film is off at the beginning is forgotten on the grid before, at an eighth of the cost.
    """
    coarse = _begun_coarse(time_grid, refinement, begin)
    if coarse == 0:
        return _on_one_grid(time_grid, refinement, begin, last)
    count = round(coarse / time_grid.step(refinement - 1))
    before = _on_one_grid(time_grid, refinement - 1, begin, begin + coarse)
    return before[:count] + _on_one_grid(time_grid, refinement, begin, last, 2 * count)


def _begun_coarse(time_grid: TimeGrid, refinement: int, begin: float) -> float:
    """Transits after the beginning whose films are solved on the grid before."""
    if begin == 0 and time_grid.approach is not None and refinement > 0:
        return COARSE_WAY * time_grid.place(time_grid.life.touched)
    return COARSE if begin > 0 and refinement >= COARSE_FROM else 0.0


def _on_one_grid(
    time_grid: TimeGrid, refinement: int, begin: float, last: float, first: int = 0
) -> list[tuple[int, float]]:
    """Refinement and place [transits] of steps on one grid, which solves share to the last bit."""
    step = time_grid.step(refinement)
    whole = time_grid.transits(time_grid.end)
    count = int((last - begin) / step) + 1
    places = [begin + step * number for number in range(first, count + 1)]
    if begin == 0 and time_grid.approach is None:
        halves = [place + step / 2 for place in places[:-1] if place < FIRST_TRANSITS]
        places = sorted([*places, *halves])
    kept = [place for place in places if place < whole - step / 2]
    kept += [whole] * (places[-1] >= whole - step / 2)
    return [(refinement, place) for place in kept]
