"""Errors that grid refinement does not reduce: by domain, levels across the film, conduction and time."""

from collections.abc import Mapping
from dataclasses import replace
from math import inf

from pyworm.io.quantity_text import percent
from pyworm.planning.target import AccuracyTarget
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.estimate import Estimate

TIME = "transient solution"
"""Name of the source that one more transient solution reduces."""

TOLD_SHARE = 0.1
"""Share of the error from which a source is told."""

TIME_ERROR_FALL = 4.0
"""Fall of the error of the time integration that one more transient solution, of second order, promises."""


def beyond_refinement(
    estimates: Mapping[str, Estimate],
    sources: Mapping[str, Mapping[str, float]],
    figures: Mapping[str, float],
    target: AccuracyTarget,
    accuracy: float,
) -> Stop | None:
    """The end that tells what finer grids do not reduce; None where they may bring the accuracy.

    `sources` are the relative errors of each figure by each of them, infinite of one that is not known yet.
    Where the grid itself leaves more than the accuracy the others are not known well.
    """
    grids = {name: estimate.grid for name, estimate in estimates.items()}
    left = _left(sources, figures)
    known = target.worst(left, figures) < inf
    if not (known and target.worst(grids, figures) <= accuracy < target.worst(left, figures)):
        return None
    worst = max(
        target.figures, key=lambda name: replace(target, figures=(name,)).worst(left, figures)
    )
    told = sorted(
        ((errors.get(worst, 0.0), source) for source, errors in sources.items()), reverse=True
    )
    return Ending.BEYOND_REFINEMENT.stop(
        error=percent(target.worst(left, figures)),
        sources=", ".join(
            f"{source} {percent(error)}"
            for error, source in told
            if error > TOLD_SHARE * left[worst]
        ),
    )


def time_would_do(
    sources: Mapping[str, Mapping[str, float]],
    figures: Mapping[str, float],
    target: AccuracyTarget,
    accuracy: float,
) -> bool:
    """Whether one more transient solution may bring the accuracy that finer grids do not."""
    time = {name: error / TIME_ERROR_FALL for name, error in sources[TIME].items()}
    return target.worst(_left({**sources, TIME: time}, figures), figures) <= accuracy


def _left(
    sources: Mapping[str, Mapping[str, float]], figures: Mapping[str, float]
) -> dict[str, float]:
    """Relative error of each figure by all sources."""
    return {name: sum(errors.get(name, 0.0) for errors in sources.values()) for name in figures}
