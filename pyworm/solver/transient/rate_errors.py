"""Errors of figures by the grids and time steps of the transient solves behind a film's rate of change."""

from collections.abc import Sequence
from dataclasses import dataclass

from pyworm.planning.expected_work import Kind
from pyworm.planning.target import AccuracyTarget
from pyworm.solver.error_estimate import SAFETY, Reading, change, changes, largest_of_films

ERROR_SHARE: dict[Kind, float] = {"point": 0.5, "line": 1.0}
"""Error of the figures by the last rate of change, over the largest of what they and the films change with it
from the one before. At second order a third of that is left; where a kink of the load or an edge passes, the
order is lower, and where the load of a gear pair jumps, or the entrainment has turned round
(`SLOW_ERROR_SHARE`), it is one or less: what is left of the film of that time is a dip as narrow as the
grid."""

SLOW_ERROR_SHARE: dict[Kind, float] = {"point": 1.5, "line": 1.0}
"""Error of the figures over their last change, as `ERROR_SHARE`, where the entrainment has turned round
(`transient._turned_round`), or the end of a contact moves over the grid and rates are limited
(`backward_term`): of 14 random balls after two solves two minimum or central films of 28 differ by 1.2 and
1.5 times the last change from those of three."""

MAX_CHANGE_RATIO = 0.5
"""Largest ratio of successive changes at which films settle whose rate is not extrapolated; else the error is
the sum of both."""

LEAST_FALL = 0.25
"""Least ratio of successive changes that is credible: that of second order."""


@dataclass(frozen=True)
class Least:
    """Least error of the figures by a number of transient solves.

    The last two of them may agree by chance.
    """

    share: float
    """Share of what transient films differ from steady ones."""
    most: float
    """The largest that counts, of films that are not far from steady ones."""

    def of(self, difference: float, far: bool = False) -> float:
        """The least error for a difference from steady films, which may be far from these."""
        least = self.share * difference
        return max(least if far else min(least, self.most), MIN_TRANSIENT_ERROR)


MIN_TRANSIENT_ERROR = 5e-4
"""Smallest error by transient solves: where motion hardly changes a film, a steady beginning two or more
transits ago and Newton's iteration leave up to 0.04 %."""

MAX_STEADY_DIFFERENCE = 0.5
"""Difference from steady films, over those in motion, from which on a first solve errs by a share of it,
without bound; so it does where films settle slowly (`transient._settles_slowly`)."""

MIN_ERRORS: dict[Kind, tuple[Least, ...]] = {
    "point": (Least(0.6, 0.06), Least(0.15, 0.015), Least(0.08, 0.0075)),
    "line": (Least(0.7, 0.06), Least(0.08, 0.005), Least(0.02, 0.003)),
}
"""After one transient solve, two and three or more, against a finer one.

After one: chosen on random pasts of balls and rollers (`benchmarks/accuracy/random_pasts.py`, seeds 1 to 3),
of which 41 of 42 bars of points and 76 of 76 of lines hold. Of seeds 4 to 6, which the choice had not seen,
38 of 42 and 78 of 78 hold. The bound is that of the thirteen phases of `cases/zi_drive.toml`, whose films are
up to 6 % off."""


def rate_errors(
    readings: Sequence[Reading],
    extrapolated: Reading | None,
    extrapolation: float,
    kind: Kind,
    slow: bool,
    target: AccuracyTarget,
) -> dict[str, float]:
    """Relative errors of the figures by the rates of change. None is less than that of the films.

    Args:
        readings: Figures of the steady film and with the rate of each transient solve.
        extrapolated: Those with the extrapolated rate; None where it is that of the last solve.
        extrapolation: Share of the last change of the rate by which it is extrapolated.
        slow: Whether films settle slowly.
    """
    _, *moving = readings
    least = least_error(readings, kind, slow)
    if len(moving) == 1:
        return dict.fromkeys(moving[-1].figures, least)
    share = error_share(kind, slow)
    left = _left(moving, share, 0.0 if extrapolated is None else extrapolation)
    if extrapolated is not None:
        moved = change(moving[-1], extrapolated)
        left = {
            name: max(error, share / extrapolation * moved[name]) for name, error in left.items()
        }
    films = target.films().worst(left, moving[-1].figures)
    return {name: max(error, films, least) for name, error in left.items()}


def error_share(kind: Kind, slow: bool) -> float:
    """Error by the last rate over the last change (`ERROR_SHARE`, `SLOW_ERROR_SHARE`)."""
    return (SLOW_ERROR_SHARE if slow else ERROR_SHARE)[kind]


def least_error(readings: Sequence[Reading], kind: Kind, slow: bool) -> float:
    """Least relative error of the figures, from readings of the steady film and with each rate."""
    steady, *moving = readings
    difference = largest_of_films(change(steady, moving[-1]))
    far = len(moving) == 1 and (slow or difference > MAX_STEADY_DIFFERENCE)
    number = min(len(moving), len(MIN_ERRORS[kind]))
    return MIN_ERRORS[kind][number - 1].of(difference, far)


def _left(readings: Sequence[Reading], share: float, extrapolation: float) -> dict[str, float]:
    """What the last of some readings leaves of error, by its change from those before."""
    last = changes(*readings[-2:])
    if len(readings) == 2:
        return {name: share * abs(relative) for name, relative in last.items()}
    before = changes(*readings[-3:-1])
    return {
        name: abs(relative) * _share_of_last(relative, before[name], share, extrapolation)
        for name, relative in last.items()
    }


def _share_of_last(last: float, before: float, share: float, extrapolation: float) -> float:
    """Error over the last of two changes: what a geometric series of them leaves after the extrapolation.

    Where none was made, or this figure's changes do not fall, it is the sum of both, unless they settle. If
    the last falls and has the other sign the limit is between the last two: the error is that change at most.
    """
    if last == 0 or (not extrapolation and abs(last) <= MAX_CHANGE_RATIO * abs(before)):
        return share
    both = 1 + abs(before / last)
    if abs(last) >= abs(before):
        return both
    fall = last / before
    if not extrapolation:
        return max(share, 1.0) if fall < 0 else both
    if fall > 0:
        fall = max(fall, LEAST_FALL)
    return max(share, min(both, SAFETY * abs(fall / (1 - fall) - extrapolation)))
