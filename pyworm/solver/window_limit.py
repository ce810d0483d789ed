"""Figures in the limit of endless windows, and their window errors."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from pyworm.planning.target import HEAT_FIGURES
from pyworm.solver.error_estimate import Convergence, Reading, changes


@dataclass(frozen=True)
class WindowLimit:
    """What an endless window adds to a figure."""

    rest: float
    """Relative change from this window to an endless one [-]; 0 where it is not extrapolated."""
    error: float
    """Relative error by the window that is left [-]."""


def in_this_window(
    this: Reading, wider: Reading, convergence: Convergence, algebra: Mapping[str, float]
) -> dict[str, WindowLimit]:
    """What an endless window adds to each figure in a window, from one of twice the reach, on one spacing.

    `algebra` is the relative algebraic error of both windows, which may hide a change as large.
    """
    return _limits(changes(this, wider), convergence, algebra, seen=0.0)


def in_wider_window(
    this: Reading,
    wider: Reading,
    convergence: Convergence,
    algebra: Mapping[str, float],
    cut_off: Mapping[str, float],
) -> dict[str, WindowLimit]:
    """What an endless window adds to each figure in the wider of two windows, as `in_this_window`.

    `cut_off` is the part of some figures, relative, by which the narrower window cuts the contact off and the
    wider one does not: that is no sign of more to come.
    """
    change = {
        name: relative - cut_off.get(name, 0.0) for name, relative in changes(this, wider).items()
    }
    return _limits(change, convergence, algebra, seen=1.0)


MAX_CHANGE_RATIO = 0.85
"""Largest ratio of changes from window to window that is believed to go on: later ones fall faster."""


def with_falls(convergence: Convergence, falls: Mapping[str, float]) -> Convergence:
    """The convergence with what an endless window adds to some figures by how their changes fall.

    Bodies of different temperatures that exchange heat through a thin film warm slowly: from one window to
    one of twice the reach their temperatures may change by 0.9 of what they changed by before, where 0.6
    would be left of a rise by the oil's own heat. `falls` are such ratios of some figures; its own larger
    ones stand.
    """
    window = dict(convergence.window)
    for name, fall in falls.items():
        least, most = window[name]
        window[name] = least, max(most, 1 / (1 - min(fall, MAX_CHANGE_RATIO)))
    return replace(convergence, window=window)


def by_warmth(
    limits: Mapping[str, WindowLimit], wider: Reading, beta: float
) -> dict[str, WindowLimit]:
    """Those limits, where the window holds all oil that bears pressure.

    What else changes with the window is the temperature, and figures by the viscosity there, of which `beta`
    is the relative fall [1/K]. By more they may differ on coarse grids, on which the oil's front is off by
    more in the wider window: that error is the grid's, and falls with it.
    """
    warmer = max(
        (abs(limits[name].rest) + limits[name].error) * abs(value)
        for name, value in wider.figures.items()
        if name in HEAT_FIGURES
    )
    others = WindowLimit(0.0, beta * warmer)
    return {name: limit if name in HEAT_FIGURES else others for name, limit in limits.items()}


MAX_EXTRAPOLATED_CHANGE = 0.5
"""Largest relative change of a figure from one window to the other that tells of a limit: a larger one is of
another film, as a first grid too coarse may have in one of them."""


def _limits(
    changed: Mapping[str, float],
    convergence: Convergence,
    algebra: Mapping[str, float],
    seen: float,
) -> dict[str, WindowLimit]:
    """The limits, where a part of the change from one window to the other is `seen` in the figure."""
    limits = {}
    for name, change in changed.items():
        least, most = convergence.window[name]
        if name in convergence.left and abs(change) <= MAX_EXTRAPOLATED_CHANGE:
            middle, half = (least + most) / 2, (most - least) / 2
            error = half * abs(change) + most * algebra[name]
            limits[name] = WindowLimit((middle - seen) * change, error)
        else:
            limits[name] = WindowLimit(0.0, (most - seen) * abs(change) + algebra[name])
    return limits
