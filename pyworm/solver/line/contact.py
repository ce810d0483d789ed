"""A line contact as the solver sees it."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np
import xarray as xr

from pyworm import kernel
from pyworm.io.variables import describe
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.line import LineScene
from pyworm.scene.scales import line_scales
from pyworm.solver.contact import Outcome
from pyworm.solver.error_estimate import Convergence
from pyworm.solver.level import Storage
from pyworm.solver.line.level import (
    LineRung,
    first_rung,
    next_rung,
    supplied,
    with_heat,
    with_shear,
)
from pyworm.solver.newton import Stride, lead

FIRST_TOLERANCE = 1e-4
"""Residual to which a film is solved that only says what oil comes to its inlet."""

SUPPLIES = 2
"""Times that the oil before the inlet is found from a film on the first grid.

After one its error hid what the window changes; a third changed nothing that is seen."""

SPEEDS = tuple(1.5**-power for power in range(7, -1, -1))
"""Shares of the velocities over which a film is led to them that Newton's iteration and heat did not settle.

Fast films are: at 50 m/s heat takes two thirds of the film, and the cold one's pressure would heat it without
bound. From grid to grid and from speed to speed temperature is carried over."""

LIFTS = (1.0, 1.5, 2.25)
"""Films to start from, over the expected one, one after another until Newton's iteration settles.

From the first it did not in 1 of 400 random scenes (M 0.01 to 3000, L 0 to 25); from the second it did."""


# The scheme's order is 2. The smallest film lies behind the pressure spike, and as long as the grid does not
# resolve that, its observed order is 1.2 to 1.8. The largest pressure may be the spike's own tip.
ORDERS = {
    "film_central": 2.0,
    "film_min": 1.25,
    "pressure_max": 1.0,
    "friction_coefficient": 2.0,
    "power_loss": 2.0,
    "shear_rate_max": 1.25,
    **dict.fromkeys(HEAT_FIGURES, 1.25),
}

# A window's error falls with the square of its reach. In 400 random scenes it was 1.1 to 1.7 times what
# doubling that changes, and 0.1 to 0.4 of it was left (90 % of them; 1 / (1 - 2^-2) = 1.33 and 0.25).
CONVERGENCE = Convergence(ORDERS, dict.fromkeys(ORDERS, 1.7), dict.fromkeys(ORDERS, 0.4))

# That of a film that warms falls with the reach itself, or up to its power 1.4: 1 / (1 - 2^-1) = 2 and 0.5.
HEATED_CONVERGENCE = Convergence(ORDERS, dict.fromkeys(ORDERS, 2.0), dict.fromkeys(ORDERS, 0.5))


class LineLadder:
    """The climb of a line contact.

    Parameters
    ----------
    scene : LineScene
        The contact.
    plan : Plan
        What of it is simulated.
    storage : Storage, optional
        What its film stores as it changes; without it is steady.
    """

    kind: ClassVar[str] = "line"
    rungs: ClassVar[type] = LineRung

    def __init__(self, scene: LineScene, plan: Plan, storage: Storage | None = None):
        self._scene = scene
        self._storage = storage
        self._model = plan.model
        self.convergence = HEATED_CONVERGENCE if plan.model.heated else CONVERGENCE
        self._size = line_scales(scene)
        self.origins = (
            dict.fromkeys(HEAT_FIGURES, scene.oil.heat.inlet_temperature)
            if self._model.heated
            else {}
        )

    def enter(self, grids: Sequence[LineGrid]) -> tuple[LineRung, list[Stride]]:
        """Up the grids. What lies before the first one's inlet follows from a film, and that from it."""
        grid, *finer = grids
        rung, strides = self._warmed(self._scene, grid)
        if self._model.levels and not rung.film.balance.worst <= FIRST_TOLERANCE:
            slowest, *faster = (
                replace(self._scene, velocities=tuple(share * u for u in self._scene.velocities))
                for share in SPEEDS
            )
            rung, further = self._warmed(slowest, grid)
            strides += further
            for scene in faster:
                rung = self._like(rung, supplied(scene, line_scales(scene), rung, self._storage))
                strides += lead(rung, FIRST_TOLERANCE)
        rung = self._supplied(rung)
        for _ in finer:
            strides += lead(rung, FIRST_TOLERANCE)
            rung, _ = self.higher(rung)
        return rung, strides

    def _supplied(self, rung: LineRung) -> LineRung:
        """The contact on the grid of a rung, from its film, shear and heat."""
        return self._like(rung, supplied(self._scene, self._size, rung, self._storage))

    def _warmed(self, scene: LineScene, grid: LineGrid) -> tuple[LineRung, list[Stride]]:
        """A film on the first grid, step by step: of a Newtonian oil of one temperature, sheared, heated.

        In the film of a Newtonian oil stresses may be so far beyond what the oil bears that their heat is
        without bound.
        """
        size = line_scales(scene)
        for lift in LIFTS:
            rung = first_rung(scene, size, grid, lift * size.film, self._storage)
            strides = lead(rung, FIRST_TOLERANCE)
            if rung.film.balance.worst <= FIRST_TOLERANCE:
                break
        for _ in range(SUPPLIES - 1):
            rung = supplied(scene, size, rung, self._storage)
            strides += lead(rung, FIRST_TOLERANCE)
        return rung, strides + self._complete(scene, rung)

    def _complete(self, scene: LineScene, rung: LineRung) -> list[Stride]:
        """Shear, then heat, for a Newtonian film of one temperature."""
        strides: list[Stride] = []
        if self._model.levels:
            with_shear(scene, self._model, rung)
            strides += lead(rung, FIRST_TOLERANCE)
        if self._model.heated:
            with_heat(scene, rung)
            strides += lead(rung, FIRST_TOLERANCE)
        return strides

    def follow(self, earlier: Sequence[LineRung], share: float) -> LineRung:
        """The contact on the grid of its rungs at earlier times, from the latest one's film."""
        return self._supplied(earlier[0])

    def resume(self, rung: LineRung) -> tuple[LineRung, list[Stride]]:
        """The grid of a rung, from its film."""
        again = supplied(self._scene, self._size, rung, self._storage)
        strides = self._complete(self._scene, again)
        return self._supplied(again), strides

    def higher(self, rung: LineRung) -> tuple[LineRung, list[Stride]]:
        """Half the spacing."""
        return self._like(rung, next_rung(self._scene, self._size, rung)), []

    def _like(self, before: LineRung, rung: LineRung) -> LineRung:
        """A rung that was entered from one before, with the shear and the heat that one has."""
        if self._model.levels:
            with_shear(self._scene, self._model, rung)
        if self._model.heated:
            with_heat(self._scene, rung, before)
        return rung

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
        """Across the film where it is hottest in the contact."""
        rise = rung.film.rise()
        node = int(np.argmax(np.where(rung.contact(), rise.max(axis=1), -np.inf)))
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
                coords={"level_position": ("level", kernel.level_positions(rise.shape[1]))},
            )
        )


def _heat_balance(rung: LineRung) -> float:
    """What both bodies take up and oil carries away, less the heat of shearing, over that."""
    flux, carried = rung.film.heat_fields()
    friction = rung.film.shear_fields().friction
    return float((flux.sum() + carried.sum() - friction.sum()) / friction.sum())
