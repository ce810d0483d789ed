"""A line contact as the solver sees it."""

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
import xarray as xr

from pyworm import kernels
from pyworm.accuracy import HEAT_FIGURES, Convergence
from pyworm.effects import Plan
from pyworm.ladder import Outcome, Stride, settle
from pyworm.line.climb import LineRung, first_rung, next_rung, supplied, with_shear
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
        What of it is simulated.
    """

    kind: ClassVar[str] = "line"
    # The scheme's order is 2. The smallest film lies behind the pressure spike, and as long as the grid does
    # not resolve that, its observed order is 1.2 to 1.8. The largest pressure may be the spike's own tip.
    # A window's error falls with the square of its reach. In 400 random scenes it was 1.1 to 1.7 times what
    # doubling that changes, and 0.1 to 0.4 of it was left (90 % of them; 1 / (1 - 2^-2) = 1.33 and 0.25).
    convergence: ClassVar[Convergence] = Convergence(
        orders={
            "film_central": 2.0,
            "film_min": 1.25,
            "pressure_max": 1.0,
            "friction_coefficient": 2.0,
            "power_loss": 2.0,
            "shear_rate_max": 1.25,
            **dict.fromkeys(HEAT_FIGURES, 1.25),
        },
        window_limit=1.7,
        wider_share=0.4,
    )

    def __init__(self, scene: LineScene, plan: Plan):
        self._scene = scene
        self._model = plan.model
        self._size = line_scales(scene)
        self.origins = (
            dict.fromkeys(HEAT_FIGURES, scene.oil.heat.inlet_temperature)
            if self._model.heated
            else {}
        )

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
        rung = supplied(self._scene, self._size, rung)
        if self._model.levels:
            strides += settle(rung, FIRST_TOLERANCE).strides
            rung = with_shear(self._scene, self._model, rung)
            strides += settle(rung, FIRST_TOLERANCE).strides
            rung = self._like(rung, supplied(self._scene, self._size, rung))
        return rung, strides

    def higher(self, rung: LineRung) -> LineRung:
        """Half the spacing."""
        return self._like(rung, next_rung(self._scene, self._size, rung))

    def _like(self, before: LineRung, rung: LineRung) -> LineRung:
        """A rung that was entered from one before, with the shear and the heat that one has."""
        return with_shear(self._scene, self._model, rung, before) if self._model.levels else rung

    def outcome(self, rung: LineRung) -> Outcome:
        """Groups, the mass balance and the fields."""
        figures: dict[str, Any] = {
            "moes_m": self._size.groups.moes_m,
            "moes_l": self._size.groups.moes_l,
            "mass_error": self._mass_error(rung),
            "heat_balance": _heat_balance(rung) if self._model.heated else None,
        }
        return Outcome(
            figures, self._fields(rung), profile=self._profile(rung) if self._model.heated else None
        )

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
            **self._shear_fields(rung),
            **self._heat_fields(rung),
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

    def _shear_fields(self, rung: LineRung) -> dict[str, np.ndarray]:
        if not self._model.levels:
            return {}
        shear = rung.film.shear_fields()
        return {
            "shear_stress_x": shear.stress,
            "friction_power": shear.friction,
            "shear_rate": shear.rate,
            "slip": shear.slip.astype(np.int8),
            "flow_factor_sliding": shear.factor,
        }

    def _heat_fields(self, rung: LineRung) -> dict[str, np.ndarray]:
        if not self._model.heated:
            return {}
        temperature = self._scene.oil.heat.inlet_temperature + rung.film.rise()
        return {
            "temperature_body_1": temperature[:, 0],
            "temperature_body_2": temperature[:, -1],
            "temperature_middle": temperature[:, self._model.levels // 2],
        }

    def _profile(self, rung: LineRung) -> xr.Dataset:
        """Across the film where it is hottest."""
        rise = rung.film.rise()
        node = int(np.argmax(rise[1:-1].max(axis=1))) + 1
        return describe(
            xr.Dataset(
                {
                    "profile_temperature": (
                        "level",
                        self._scene.oil.heat.inlet_temperature + rise[node],
                    ),
                    "profile_velocity_x": (
                        "level",
                        rung.film.profile(node, self._scene.velocities[0]),
                    ),
                    "profile_x": rung.grid.x[node],
                },
                coords={"level_position": ("level", kernels.level_positions(rise.shape[1]))},
            )
        )


def _heat_balance(rung: LineRung) -> float:
    """What both bodies take up and oil carries away, less the heat of shearing, over that."""
    flux, carried = rung.film.heat_fields()
    friction = rung.film.shear_fields().friction
    return float((flux.sum() + carried.sum() - friction.sum()) / friction.sum())
