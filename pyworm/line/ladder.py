"""A line contact as the solver sees it."""

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
import xarray as xr

from pyworm.accuracy import Convergence
from pyworm.effects import Plan
from pyworm.ladder import Outcome, Stride, settle
from pyworm.line.climb import LineRung, first_rung, next_rung, supplied
from pyworm.line.grid import LineGrid
from pyworm.line.scales import line_scales
from pyworm.line.scene import LineScene
from pyworm.variables import describe

FIRST_TOLERANCE = 1e-4
"""Residual to which a film is solved that only says what oil comes to its inlet."""

SUPPLIES = 2
"""Times that the oil before the inlet is found from a film on the first grid.

After one its error hid what the window changes; a third changed nothing that is seen."""

LIFTS = (1.0, 1.5, 2.25)
"""Films to start from, over the expected one, one after another until Newton's iteration settles.

From the first it did not in 1 of 400 random scenes (M 0.01 to 3000, L 0 to 25); from the second it did."""


class LineLadder:
    """The climb of a line contact.

    Parameters
    ----------
    scene : LineScene
        The contact.
    plan : Plan
        What of it is simulated: so far an isothermal Newtonian film.
    """

    kind: ClassVar[str] = "line"
    # The scheme's order is 2. The smallest film lies behind the pressure spike, and as long as the grid does
    # not resolve that, its observed order is 1.2 to 1.8. The largest pressure may be the spike's own tip.
    # A window's error falls with the square of its reach. In 400 random scenes it was 1.1 to 1.7 times what
    # doubling that changes, and 0.1 to 0.4 of it was left (90 % of them; 1 / (1 - 2^-2) = 1.33 and 0.25).
    convergence: ClassVar[Convergence] = Convergence(
        orders={"film_central": 2.0, "film_min": 1.25, "pressure_max": 1.0},
        window_limit=1.7,
        wider_share=0.4,
    )

    def __init__(self, scene: LineScene, plan: Plan):
        self._scene = scene
        self.origins = {}
        self._size = line_scales(scene)

    def enter(self, grids: Sequence[LineGrid]) -> tuple[LineRung, list[Stride]]:
        """The first grid. What lies before its inlet follows from a film, and that from it."""
        (grid,) = grids
        for lift in LIFTS:
            rung = first_rung(self._scene, self._size, grid, lift * self._size.film)
            strides = list(settle(rung, FIRST_TOLERANCE).strides)
            if rung.film.balance.worst <= FIRST_TOLERANCE:
                break
        for _ in range(SUPPLIES - 1):
            rung = supplied(self._scene, self._size, rung)
            strides += settle(rung, FIRST_TOLERANCE).strides
        return supplied(self._scene, self._size, rung), strides

    def higher(self, rung: LineRung) -> LineRung:
        """Half the spacing."""
        return next_rung(self._scene, self._size, rung)

    def outcome(self, rung: LineRung) -> Outcome:
        """Groups, the mass balance and the fields."""
        figures: dict[str, Any] = {
            "moes_m": self._size.groups.moes_m,
            "moes_l": self._size.groups.moes_l,
            "mass_error": self._mass_error(rung),
        }
        return Outcome(figures, self._fields(rung))

    def _mass_error(self, rung: LineRung) -> float:
        """Net outflow of the pressurised film over the flow past its end, where pressure and slope vanish."""
        film, density, imbalance = rung.film.fields()
        inside = np.flatnonzero(rung.film.pressure > 0)
        end = inside[-1 if self._scene.entrainment > 0 else 0]
        through = abs(self._scene.entrainment) * density[end] * film[end]
        return float(abs(imbalance[inside].sum()) * rung.grid.dx / through)

    def _fields(self, rung: LineRung) -> xr.Dataset:
        variables = {
            "gap": rung.gap,
            "covered": rung.covered.astype(np.int8),
            "pressure": rung.film.pressure,
            "film": rung.film.fields()[0],
            "entrainment_x": np.full(rung.grid.nodes, self._scene.entrainment),
            "sliding_x": np.full(rung.grid.nodes, self._scene.sliding),
        }
        return describe(
            xr.Dataset(
                {name: ("x", values) for name, values in variables.items()},
                coords={"x": rung.grid.x},
                attrs={
                    "radius_m": self._scene.radius,
                    "load_per_length_N_m": self._scene.load,
                    "reduced_modulus_Pa": self._scene.reduced_modulus,
                },
            )
        )
