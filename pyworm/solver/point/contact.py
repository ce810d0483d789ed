"""A point contact as the solver sees it."""

from collections.abc import Sequence
from math import nan, sqrt
from typing import Any, ClassVar

import numpy as np
import xarray as xr

from pyworm import kernel
from pyworm.io.variables import describe
from pyworm.kernel.dry_contact import DryContact
from pyworm.planning.grid import Grid
from pyworm.planning.plan import Plan
from pyworm.planning.target import FIGURES, HEAT_FIGURES, SHEAR_FIGURES
from pyworm.scene.entrainment_continuation import TAKEN_BACK, lent
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales
from pyworm.solver import figures
from pyworm.solver.contact import Outcome
from pyworm.solver.error_estimate import Convergence
from pyworm.solver.level import Storage
from pyworm.solver.newton import Stride, lead
from pyworm.solver.point.level import (
    Rung,
    Start,
    anew,
    dry_contact,
    entry,
    first_rung,
    like,
    lost,
    next_rung,
    with_heat,
    with_shear,
)
from pyworm.solver.solution import DryFigures

SHEAR_TOLERANCE = 1e-3
"""Residual of the sheared film from which it is heated."""

FIRMEST = 16.0
"""How many times as large the flow law's stresses are taken at first, where no step leads to it at once."""

SOFTENING, LEAST_SOFTENING = 2.0, 1.02
"""Ratio of the stresses from one film to the next, its root taken where a film is lost, down to the least."""

HEATED_TOLERANCE = 1e-2
"""Residual of a heated film, and change of its temperature, from which its stresses are softened."""

LENT_TOLERANCE = 1e-2
"""Residual at which some more of lent entrainment is taken back."""

SENSELESS = 1.0
"""Residual beyond which a film is no start for a finer grid: its gradients ask for more stress than oil with
a limit bears, and the slip that its law allows then is without bound."""

COARSE_TOLERANCE = 1e-4
"""Residual at which a grid that only leads to a finer window is left."""


ALL = (*FIGURES, *SHEAR_FIGURES, *HEAT_FIGURES)

ORDERS = dict.fromkeys(ALL, 2.0)

# A window's error falls with the power -3/2 of its reach: 1 / (1 - 2^-1.5) = 1.55, and 1.6 to 1.8 were
# measured against a reach 15 times larger; 2^-1.5 is left when the reach is doubled. Oil warms long before
# the contact: of the temperatures' error 0.45 to 0.6 were left then (against a reach 8 times larger), most
# where they rise by little.
CONVERGENCE = Convergence(
    ORDERS,
    window_limits=dict.fromkeys(ALL, 1.7) | dict.fromkeys(HEAT_FIGURES, 2.5),
    wider_shares=dict.fromkeys(ALL, 0.35) | dict.fromkeys(HEAT_FIGURES, 0.6),
)


class PointLadder:
    """The climb of a point contact: a nest of windows, then finer grids in the innermost.

    Parameters
    ----------
    scene : Scene
        The contact.
    plan : Plan
        What of it is simulated.
    storage : Storage, optional
        What its film stores as it changes; without it is steady.
    """

    kind: ClassVar[str] = "point"
    rungs: ClassVar[type] = Rung
    convergence: ClassVar[Convergence] = CONVERGENCE

    def __init__(self, scene: Scene, plan: Plan, storage: Storage | None = None):
        self._scene = scene
        self._storage = storage
        self._model = plan.model
        self._lent = lent(scene) if plan.model.heated else scene
        self._size = scales(self._lent)
        self.origins = (
            dict.fromkeys(HEAT_FIGURES, scene.oil.heat.inlet_temperature)
            if self._model.heated
            else {}
        )

    def enter(self, grids: Sequence[Grid]) -> tuple[Rung, list[Stride]]:
        """Up the nest to the first grid of the figures."""
        strides: list[Stride] = []
        rung = first_rung(self._lent, self._scene, self._size, grids[0], self._storage)
        for grid in grids[1:]:
            strides += lead(rung, COARSE_TOLERANCE)
            before, rung = rung, next_rung(self._scene, self._size, rung, grid, entry(rung, grid))
            if lost(before):
                anew(self._scene, self._size, rung)
        return rung, strides + self._complete(rung)

    def follow(self, earlier: Sequence[Rung], share: float) -> Rung:
        """The contact on the grid of its rungs at earlier times, from where the last two lead."""
        start, *before = (rung.end() for rung in earlier[:2])
        if before:
            start = start.onward(*before, share)
        again = like(self._scene, self._size, earlier[0], self._storage)
        again.film.start(np.where(again.covered, start.pressure, 0.0), start.rigid_film)
        self._as_whole(again, start)
        return again

    def resume(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """The grid of a rung, from its film."""
        again = like(self._lent, self._size, rung, self._storage)
        return again, self._complete(again)

    def _complete(self, rung: Rung) -> list[Stride]:
        """Shear, then heat, for a Newtonian film of one temperature."""
        strides: list[Stride] = []
        firmness = 1.0
        if self._model.levels:
            strides += lead(rung, COARSE_TOLERANCE)
            # that film's pressure could make heat without bound by a law that limits the stress
            sheared, firmness = self._sheared(rung)
            strides += sheared
        if self._model.heated:
            with_heat(self._scene, self._size, rung)
            rung.film.restart()
            strides += self._taken_back(rung)
        if (
            firmness > 1
        ):  # hot oil is thin: its stresses may be borne where those of cold oil are not
            if self._model.heated:
                strides += lead(rung, HEATED_TOLERANCE)
                softened, firmness = self._softened(rung, firmness)
                strides += softened
            if firmness > 1:
                self._flow_by_law(rung, 1.0)
        return strides

    def _sheared(self, rung: Rung) -> tuple[list[Stride], float]:
        """Steps of a film from a Newtonian oil to its own, and how firm that was left.

        Where stresses of the Newtonian film are so far beyond those of the law that steps do not lead there,
        the law is made firm and softened bit by bit.
        """
        pressure, rigid_film = rung.film.pressure, rung.film.rigid_film
        self._flow_by_law(rung, 1.0)
        strides = lead(rung, SHEAR_TOLERANCE)
        if rung.film.balance.worst <= SHEAR_TOLERANCE:
            return strides, 1.0
        rung.film.start(pressure, rigid_film)
        softened, firmness = self._softened(rung, FIRMEST * SOFTENING)
        return [*strides, *softened], firmness

    def _softened(self, rung: Rung, firmness: float) -> tuple[list[Stride], float]:
        """Steps of a film from stresses many times as large as the law's towards these, and how far they led.

        The film left has stresses that many times as large.
        """
        strides: list[Stride] = []
        found, ratio = rung.end(), SOFTENING
        while firmness > 1 and ratio >= LEAST_SOFTENING:
            softer = max(firmness / ratio, 1.0)
            self._flow_by_law(rung, softer, found)
            strides += lead(rung, HEATED_TOLERANCE if rung.film.heated else SHEAR_TOLERANCE)
            if lost(rung):
                ratio = sqrt(ratio)
            else:
                found, firmness = rung.end(), softer
        if lost(rung):
            self._flow_by_law(rung, firmness, found)
        return strides, firmness

    def _flow_by_law(self, rung: Rung, firmness: float, start: Start | None = None) -> None:
        """The present film, or another, under the flow law, its stresses so many times as large."""
        start = start or rung.end()
        heated = rung.film.heated
        with_shear(self._scene, self._model, rung, firmness)
        if heated:
            with_heat(self._scene, self._size, rung, start.rise)
        rung.film.start(start.pressure, start.rigid_film)

    def _taken_back(self, rung: Rung) -> list[Stride]:
        """Steps of a film from the entrainment that was lent to it to its own."""
        strides: list[Stride] = []
        if self._lent is self._scene:
            return strides
        for share in TAKEN_BACK:
            strides += lead(rung, LENT_TOLERANCE)
            rung.film.entrain(lent(self._scene, share).entrainment(*rung.grid.mesh()))
            rung.film.restart()
        return strides

    def higher(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """Half the spacing over the same window."""
        grid = rung.grid.finer()
        if not lost(rung):
            for start in (entry(rung, grid), rung.end().finer()):
                finer = self._entered(rung, grid, start)
                if finer.film.balance.residual <= SENSELESS:
                    return finer, []
        finer = next_rung(self._lent, self._size, rung, grid, rung.end().finer())
        anew(self._lent, self._size, finer)
        return finer, self._complete(finer)

    def _entered(self, rung: Rung, grid: Grid, start: Start) -> Rung:
        """A grid of half the spacing, with shear and heat, from a film that was led there."""
        finer = next_rung(self._scene, self._size, rung, grid, start)
        if self._lent is not self._scene:
            finer.film.entrain(self._scene.entrainment(*finer.grid.mesh()))
        self._as_whole(finer, start)
        return finer

    def _as_whole(self, rung: Rung, start: Start) -> None:
        """Shear and heat at once, for a film that starts from one that has them."""
        if self._model.levels:
            with_shear(self._scene, self._model, rung)
        if self._model.heated:
            with_heat(self._scene, self._size, rung, start.rise)
        if self._model.levels:
            rung.film.restart()

    def outcome(self, rung: Rung) -> Outcome:
        """Figures of the lubricated and of the dry contact, and the fields."""
        dry = dry_contact(self._scene, rung.grid, rung.gap, rung.covered, rung.film.pressure)
        return Outcome(
            self._figures(rung, dry),
            self._fields(rung, dry),
            None if dry.converged else "the dry contact did not converge",
            self._profile(rung) if self._model.heated else None,
        )

    def _figures(self, rung: Rung, dry: DryContact) -> dict[str, Any]:
        film, density, imbalance = rung.film.fields()
        u, v = self._lent.entrainment(*rung.grid.mesh())
        exit_min, exit_min_at = figures.exit_minimum(rung.grid, film, self._size.angle)
        extents = figures.contact_extent(rung.grid, dry.pressure)
        return {
            "moes_m": self._size.groups.moes_m,
            "moes_l": self._size.groups.moes_l,
            "mass_error": figures.outline_imbalance(
                rung.grid,
                (density * film * u, density * film * v),
                imbalance,
                rung.film.pressure > 0,
            ),
            "film_min_kind": figures.minimum_kind(
                rung.read().film_min_at,
                self._size.angle,
                (extents[0] / 2, extents[1] / 2),
            ),
            "film_exit_min": exit_min,
            "film_exit_min_at": exit_min_at,
            "lift": rung.film.rigid_film + dry.approach,
            "dry": DryFigures(
                figures.maximum(dry.pressure, rung.covered),
                max(extents),
                min(extents),
                dry.approach,
            ),
            "heat_balance": _heat_balance(rung) if self._model.heated else None,
        }

    def _fields(self, rung: Rung, dry: DryContact) -> xr.Dataset:
        entrainment = self._scene.entrainment(*rung.grid.mesh())
        sliding = self._scene.sliding(*rung.grid.mesh())
        variables = {
            "gap": rung.gap,
            "covered": rung.covered.astype(np.int8),
            "dry_pressure": dry.pressure,
            "pressure": rung.film.pressure,
            "film": rung.film.thickness(),
            "entrainment_x": entrainment[0],
            "entrainment_y": entrainment[1],
            "sliding_x": sliding[0],
            "sliding_y": sliding[1],
            **self._shear_fields(rung),
            **self._heat_fields(rung),
        }
        return describe(
            xr.Dataset(
                {name: (("y", "x"), values.T) for name, values in variables.items()},
                coords={"x": rung.grid.x, "y": rung.grid.y},
                attrs={
                    "radius_x_m": self._scene.radii[0],
                    "radius_y_m": self._scene.radii[1],
                    "load_N": self._scene.load,
                    "reduced_modulus_Pa": self._scene.reduced_modulus,
                },
            )
        )

    def _shear_fields(self, rung: Rung) -> dict[str, np.ndarray]:
        if not self._model.levels:
            return {}
        shear = rung.film.shear_fields(factors=True)
        return {
            "shear_stress_x": shear.stress_x,
            "shear_stress_y": shear.stress_y,
            "friction_power": shear.friction,
            "shear_rate": shear.rate,
            "slip": shear.slip.astype(np.int8),
            "flow_factor_sliding": shear.along,
            "flow_factor_across": shear.across,
        }

    def _heat_fields(self, rung: Rung) -> dict[str, np.ndarray]:
        if not self._model.heated:
            return {}
        temperature = self._scene.oil.heat.inlet_temperature + rung.film.rise()
        return {
            "temperature_body_1": temperature[:, :, 0],
            "temperature_body_2": temperature[:, :, -1],
            "temperature_middle": temperature[:, :, self._model.levels // 2],
        }

    def _profile(self, rung: Rung) -> xr.Dataset:
        """Across the film where it is hottest in the contact."""
        rise = rung.film.rise()
        hottest = np.where(rung.contact(), rise.max(axis=2), -np.inf)
        node = tuple(int(at) for at in np.unravel_index(np.argmax(hottest), hottest.shape))
        place = np.array(rung.grid.x[node[0]]), np.array(rung.grid.y[node[1]])
        u, v = rung.film.profile(node, [float(of) for of in self._scene.motions[0](*place)])
        return describe(
            xr.Dataset(
                {
                    "profile_temperature": (
                        "level",
                        self._scene.oil.heat.inlet_temperature + rise[node],
                    ),
                    "profile_velocity_x": ("level", u),
                    "profile_velocity_y": ("level", v),
                    "profile_x": rung.grid.x[node[0]],
                    "profile_y": rung.grid.y[node[1]],
                },
                coords={"level_position": ("level", kernel.level_positions(len(u)))},
            )
        )


def _heat_balance(rung: Rung) -> float:
    """What both bodies take up and oil carries away, less the heat of shearing, over that."""
    heat = rung.film.heat_fields()
    friction = heat.friction.sum()
    if not friction > 0:  # of a film that was cooled down, where heat found none
        return nan
    return float((heat.flux.sum() + heat.carried.sum() - friction) / friction)
