"""The rate of change of a film's oil, tied to the oil that the transient solve has in the film itself.

A film with a given rate of change sums up along the flow what that is off by. Where oil takes most of a life
to pass, that is far more than what the solve's own film is off: by three solves of phase 0.5 of drive 0 of
seed 99020 of `tests/hard` the central film is 0.35, 0.37 and 0.37 um, with the last two of their rates on the
grid of the figures 0.30 and 0.23 um. With

    d(rho h)/dt = R + k (rho h - rho h of the solve)                                                     (1)

what R is off by is summed up over 1/k alone. What the spacing of the solve leaves in its own film is left
then, which is more where teeth are short or run off an edge (`rated_films`).
"""

from collections.abc import Sequence
from dataclasses import dataclass

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.prediction import predicted
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.transient.moving_grid import at_places
from pyworm.solver.transient.time_integration import RateOfChange

TIES = 8.0
"""k times the passage of oil: with 8 two solves of that phase leave 5 % in the central film, with none 90."""


@dataclass(frozen=True)
class TiedRate:
    """Equation 1 with the rate and the oil of a transient solve; a `level.TransientTerm`."""

    scene: AnyContact
    """The contact at present, whose gap the oil fills beyond the grid of the solve."""
    rate: RateOfChange
    """Rate of change of the solve."""
    content: Array
    """Its oil, rho h over the density at the inlet [m], at nodes of its grid."""

    @property
    def grid(self) -> Grid | LineGrid:
        """The grid on which the rate was found."""
        return self.rate.grid

    @property
    def limited(self) -> bool:
        """Whether the rate is limited anywhere in the contact."""
        return self.rate.limited

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid.

        Beyond that of the solve its film differs from the gap by as much as on its edge.
        """
        tie = TIES / predicted(self.scene).transit
        gap, other_gap = (self.scene.gap(*on.mesh())[0] for on in (self.grid, grid))
        content = other_gap + at_places(self.grid, self.content - gap, grid)
        _, rate = self.rate.on(grid)
        return tie, rate - tie * content

    def remembered(self, grid: Grid | LineGrid) -> Array | None:
        """What both surfaces are warmer by at nodes of a grid [K]."""
        return self.rate.remembered(grid)

    def stored(self, grid: Grid | LineGrid) -> kernel.HeatStorage | None:
        """Rates of change of the oil's temperature and pressure at nodes of a grid."""
        return self.rate.stored(grid)


def tied(scene: AnyContact, rates: Sequence[RateOfChange]) -> tuple[TiedRate, ...]:
    """Some rates, each tied to the oil of its solve; none where that of one is not known."""
    known = tuple(TiedRate(scene, rate, rate.content) for rate in rates if rate.content is not None)
    return known if len(known) == len(rates) else ()
