"""The rate of change of a film's oil by backward differences at nodes that move with the contact.

Where the end of a contact moves over a node the gap there falls by many films in a few time steps, and then
stays as the film that has formed. A difference of higher order still sees the fall: it feeds or presses out
oil that is not there. Beside the chord to the last film it is limited there, as fluxes beside a shock are
(Sweby 1984, SIAM Journal on Numerical Analysis 21, 995).
"""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.transient.differences import backward_weights
from pyworm.solver.transient.time_level import TimeLevel

MAX_TURN, LEAST_TURN = 0.5, 0.4
"""Most by which a rate of change differs from the slope of the chord to the last film, over that slope, and
the change in a time step, over the oil there, up to which it may differ in any case.

Where the exit of a worm gear's contact moves over the grid (drive 0 of seed 95001 of `tests/hard`, phase
0.3 at 5 %) the minimum film by two transient solves is 0.28 um without limit, 0.51 um with it, 0.47 um with
four times the steps; with turns of 1 and 0.75 films follow the moving exit for a transit after a steady
beginning, with 0.5 for a third of one. With a least turn of 0.02 films of `cases/zi_drive.toml` by the first
solve change by 4 %; with 0.2 and 0.4 they stay, and where films form on an edge (a = 100 mm) the central film
by it is 34 and 14 % too thick."""


class BackwardTerm:
    """d(rho h)/dt on the moving grid's own nodes, a `solver.level.TransientTerm`."""

    def __init__(
        self,
        seconds: float,
        before: Sequence[TimeLevel],
        divergence: float,
        rise: Array | None,
    ) -> None:
        """The term at a time [s], by the films before, the latest first, not limited yet.

        `divergence` is that of the grid's motion [1/s], `rise` what both surfaces are warmer by than in
        steady conduction [K].
        """
        coefficient, *earlier = backward_weights([seconds, *(film.seconds for film in before)])
        parts = zip(earlier, before, strict=True)
        self._differences = sum(weight * film.content for weight, film in parts)
        self._coefficient = coefficient
        self._last, self._step = before[0].content, seconds - before[0].seconds
        self._turns = len(before) > 1
        self._rise = rise
        self.implicit = coefficient + divergence
        """Coefficient of the oil at present [1/s]."""
        self.explicit = self._differences
        """Part by the films before [m/s]."""
        self.limited = np.zeros(self._last.shape, dtype=bool)
        """Where it is limited."""

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s]."""
        return self.implicit, self.explicit

    def remembered(self, grid: Grid | LineGrid) -> Array | None:
        """What both surfaces are warmer by [K]."""
        return self._rise

    def stored(self, grid: Grid | LineGrid) -> None:
        """The oil's heat is steady."""
        return None

    def limit(self, content: Array) -> bool:
        """Limit the rate of change of oil [m]; whether the explicit part changes."""
        if not self._turns:
            return False
        chord = (content - self._last) / self._step
        turn = self._coefficient * content + self._differences - chord
        most = np.maximum(MAX_TURN * np.abs(chord), LEAST_TURN * np.abs(content) / self._step)
        explicit = self._differences + np.clip(turn, -most, most) - turn
        changed = not np.array_equal(explicit, self.explicit)
        self.limited, self.explicit = np.abs(turn) > most, explicit
        return changed
