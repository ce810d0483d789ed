"""Uncertainty of figures by the assumptions of averaged roughness, to first order.

Each assumption is changed by a small part of its uncertainty at the converged film. A Newton step from
there, a linear solve with the film's own Jacobian, shows how every figure follows, of a heated film some more
with its temperature; nothing is solved anew. Assumptions are independent of each other, so that their
changes add by squares; of longer and shorter lays the larger change of each figure counts.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot, inf, pi

from pyworm.formulas.wave_deformation import Groups, left_of_waves
from pyworm.materials.roughness_assumptions import (
    LAYS,
    RoughSurfaces,
    Variation,
    flow_scatter,
    variations,
)
from pyworm.scene.waves import MovingWaves
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.newton import newton_step

VARIED_FRACTION = 0.1
"""Part of an uncertainty by which an assumption is changed."""

FORCING = 1e-2
"""Residual of a linear solve over its right-hand side."""

ENOUGH, WARMED, MOST_STEPS = 5e-4, 2e-3, 12
"""Residual and last change of temperature, over its largest rise, of a film that has followed a change, and
the most Newton steps to it: one to three, more only where asperities carry much of the load."""

WAVE_HEIGHT_RATIO = 2.0
"""Height of the highest of some dozen waves over their root mean square."""

SHEARED = ("friction_coefficient", "power_loss")
"""Figures with the shear of the oil between rough walls, whose own factors are left out."""


@dataclass(frozen=True)
class NeglectedWaves:
    """Long waves of the surfaces that roll through a contact whose gap has them not."""

    film: float = 0.0
    """Root mean square height that is left in the film [m]."""
    pressure: float = 0.0
    """Root mean square pressure that flattens the rest [Pa]."""

    def changes(self, figures: Mapping[str, float]) -> dict[str, float]:
        """Relative changes of figures while they roll through."""
        return {
            "film_min": WAVE_HEIGHT_RATIO * self.film / figures["film_min"],
            "film_central": self.film / figures["film_central"],
            "pressure_max": WAVE_HEIGHT_RATIO * self.pressure / figures["pressure_max"],
        }


def neglected_waves(
    waves: MovingWaves | None, groups: Groups, half_width: float, modulus: float
) -> NeglectedWaves:
    """What moving waves do to film and pressure, by Moes' groups and half-width [m] along the entrainment.

    A wave flattened by A takes a pressure of pi E' A/(2 length) (Johnson 1985, 13.2), E' in Pa.
    """
    if waves is None:
        return NeglectedWaves()
    left = left_of_waves(waves.length / half_width, groups)
    flattened = (1 - left) * waves.height
    return NeglectedWaves(left * waves.height, pi * modulus * flattened / (2 * waves.length))


def roughness_uncertainty(
    level: Level,
    pair: RoughSurfaces,
    boundary_friction: float,
    waves: NeglectedWaves = NeglectedWaves(),
    fitted_spread: float | None = None,
) -> dict[str, float]:
    """Relative uncertainty of each figure [-], of temperatures over their rise above the inlet's.

    Infinite where the film does not follow. The level is left at the film it had, one step further if heated.
    `waves` are long ones that are not in the gap, `fitted_spread` is that of a fitted friction coefficient of
    asperities [-].
    """
    figures, thickness = level.read().figures, level.film.thickness()
    varied = variations(
        pair, boundary_friction, VARIED_FRACTION, thickness, waves.film, fitted_spread
    )
    changes = changes_by(level, pair, boundary_friction, dict(varied))
    lays = [changes.pop(lay) for lay in LAYS if lay in changes]
    others = _of_stress(figures, pair.height), waves.changes(figures)
    return {
        key: hypot(
            *(change[key] for change in changes.values()),
            max((abs(change[key]) for change in lays), default=0.0),
            *(change.get(key, 0.0) for change in others),
        )
        for key in figures
    }


def changes_by(
    level: Level, pair: RoughSurfaces, boundary_friction: float, varied: Mapping[str, Variation]
) -> dict[str, dict[str, float]]:
    """Relative change of each figure [-] by the whole of each assumption, as `roughness_uncertainty`."""
    converged, figures = level.state(), level.read().figures
    changes = {}
    for name, variation in varied.items():
        level.film.roughen(variation.curves, variation.boundary_friction)
        _start(level, converged)
        followed = _follow(level)
        after = level.read().figures
        changes[name] = {
            key: whole_change(value, after[key], variation.by_factor) if followed else inf
            for key, value in figures.items()
        }
    level.film.roughen(pair.curves(), boundary_friction)
    _start(level, converged)
    if level.film.heated:
        newton_step(level)  # its heat flows are those of the last sweep
    return changes


def _follow(level: Level) -> bool:
    """Make Newton steps until the film has followed the change; returns whether it has."""
    for _ in range(MOST_STEPS):
        if newton_step(level, FORCING) is None:
            return False
        if level.film.balance.within(ENOUGH, WARMED):
            return True
    return False


def whole_change(before: float, after: float, by_factor: bool) -> float:
    """Relative change of a figure by a whole uncertainty, from that by a `VARIED_FRACTION`.

    A fall compounds, as of pressures that fall exponentially with the gap: no figure changes its sign. So
    does a rise by what is known to a factor.
    """
    ratio = after / before if before else 1.0
    compounded: float = max(ratio, 0.0) ** (1 / VARIED_FRACTION)
    if ratio <= 1:
        return 1 - compounded
    return compounded - 1 if by_factor else (ratio - 1) / VARIED_FRACTION


def _start(level: Level, guess: InitialGuess) -> None:
    """Start a film, under the equations set before, from a converged one."""
    if guess.rise is not None:
        level.film.set_rise(guess.rise)
    level.film.start(guess.pressure, guess.rigid_film, guess.oil)


def _of_stress(figures: Mapping[str, float], roughness: float) -> dict[str, float]:
    """Uncertainty of friction by the shear stress factors, taken as the scatter of the flow factors."""
    friction = figures.get("friction_coefficient", 0.0)
    if not friction:
        return {}
    fluid = friction - figures["friction_boundary"]
    scatter = float(flow_scatter(figures["film_central"] / roughness))
    return dict.fromkeys(SHEARED, scatter * abs(fluid / friction))
