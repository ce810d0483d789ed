"""Shares of the asked accuracy that each source of error may take.

The error of a figure is the sum of what its sources leave: the grid, the end of the window, the algebra (what
Newton's iteration leaves), the levels across the film, the integration in time and the conduction in the
bodies. A solve ends where the sum is within the accuracy (`pyworm.solver.stop_reason`). The shares decide on
the way there: how far each source is followed before the next grid, which costs most, is solved. Those of a
steady film leave nearly half to the grid. A source that no finer grid mends, time or conduction, has a limit
of its own beyond which no grid is solved for it; nor is one where all of these exceed the accuracy together
(`pyworm.solver.irreducible`).
"""

RESIDUAL = 0.1
"""Residual of a film. It is no error of a figure itself: its effect is the share of the algebra."""

HEATED_LINE_RESIDUAL = 0.01
"""Residual of a heated line film. Film and temperature are iterated in turn; ten times as much left
temperatures beyond their error bars in half of 40 random scenes."""

ALGEBRA = 0.1
"""Algebraic error of the figures at which a grid is converged: so far below what the grid leaves that changes
from grid to grid are those of the grids."""

WIDER_WINDOW_ALGEBRA = 0.1
"""Algebraic error of the figures in the wider window, over that elsewhere: what the windows differ by may be
a tenth of the accuracy."""

WINDOW = 0.25
"""Error by the end of the window above which the sequence goes on in the wider, dearer one."""

PLANNED_LEVELS = 0.1
"""Error by the levels across the film that are planned, known from other contacts."""

LEVELS = 0.2
"""Error by the levels across a hot film, seen with more of them, at which there are enough: it is measured
on the contact itself and so may be larger than what is planned."""

TIME = 0.78
"""Error by the transient solve, beyond which its rate of change is not to be trusted; the
rest is left to grid, window and algebra."""

CONDUCTION = 0.7
"""Error by the approximation of conduction in the bodies from which on it is what a temperature is left with:
the rest would be no room for grid, window and algebra."""
