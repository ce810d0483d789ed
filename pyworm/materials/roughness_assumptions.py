"""Assumptions of averaged roughness that may as well be others, and by how much.

Every assumption is varied on its own; what it changes is the uncertainty of figures by the model of roughness
(`pyworm.solver.roughness_uncertainty`).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, log
from typing import Protocol

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.rough_contact import overlap_moment
from pyworm.materials.rough_surfaces import GapCurves

HEIGHT_SPREAD = 0.2
"""Relative uncertainty of a composite roughness: measured tracks of one flank differ as much."""

STIFFNESS_FACTOR = 1.5
"""Factor by which the pressure of asperities may be larger or smaller at a gap: shares of the load at one
specific film differ as much between published mixed films (`docs/theory/roughness.md`)."""

SLOPE_FACTOR = 2.0
"""Factor by which slopes may be steeper or flatter: they rise without end the shorter the waves that an
instrument resolves, and those that run in are a tenth of those cut."""

ASPECT_FACTOR = 2.0
"""Factor by which correlation lengths along the lay over those across it may be larger or smaller."""

FLOW_SCATTER, FLOW_FALL = 0.3, 2.5
"""Scatter of flow factors between surfaces of one spectrum at a gap of the roughness and below, relative,
and the power with which it falls beyond."""

BOUNDARY_FRICTION_SPREAD = 0.25
"""Relative uncertainty of a friction coefficient of asperities that is given, whatever the law of contact."""

REFITTED = {"stiffer": 0.743, "one radius": 0.99, "elastic": 0.951}
"""Other law of contact -> factor of a fitted friction coefficient of asperities if it had been fitted by that
law (`benchmarks/validation/boundary_friction.py`): where asperities bear more, they rub less."""

SLOPE_POWER = log(SLOPE_FACTOR) / log(STIFFNESS_FACTOR)
"""Power of the stiffer law's factor that is the factor by steeper slopes: pressures are as the slopes."""


LAYS = ("longer lay", "shorter lay")
"""Assumptions that exclude each other; flow factors over the aspect have a kink where they are tabulated."""

BY_FACTOR = ("contact", "slope", *LAYS, "sample")
"""Assumptions that are known to a factor."""


class RoughSurfaces(Protocol):
    """Two rough surfaces in contact."""

    @property
    def height(self) -> float:
        """Composite root mean square height [m]."""

    def curves(self) -> GapCurves:
        """Averages over the gap."""

    def sampled(self) -> tuple[Array, Array] | None:
        """Uncertainties by the measured place, over the rows [-]; None where parts of it do not show it.

        That of the logarithm of the asperities' pressure, and the relative one of the pressure flow factors.
        """

    def elastic(self) -> "RoughSurfaces | None":
        """The surfaces as if they did not yield; None where neither does."""

    def steeper(self, factor: float) -> "RoughSurfaces | None":
        """Surfaces whose slopes are larger by a factor; None where they are those of heights."""

    def drawn_out(self, factor: float) -> "RoughSurfaces | None":
        """Surfaces longer along their lay by a factor, as against across; None where heights show both."""


@dataclass(frozen=True)
class Variation:
    """Rough surfaces with one assumption changed by a part of its uncertainty."""

    curves: GapCurves
    """Averages over the gap."""
    boundary_friction: float
    """Friction coefficient of asperities in contact [-]."""
    by_factor: bool = False
    """Whether the assumption is known to a factor, so that what it changes compounds."""


def variations(
    pair: RoughSurfaces,
    boundary_friction: float,
    part: float,
    thickness: Array,
    waves: float = 0.0,
    fitted_spread: float | None = None,
) -> Iterator[tuple[str, Variation]]:
    """Names of uncertain assumptions, each with the surfaces in which it is changed.

    All are independent but for `LAYS`. Laws of contact exclude each other: that one counts by which the load
    of the asperities changes most at a given gap. A friction coefficient that was fitted (`fitted_spread`,
    else `BOUNDARY_FRICTION_SPREAD`) by one law is another by another one (`REFITTED`). Assumptions that
    change nothing, as shear flow factors between equal surfaces, are omitted. `part` of the uncertainty is
    changed; `thickness` is the mean one [m] at evenly spaced places; `waves` in the film that the gap does
    not have count as more roughness by their height [m].
    """
    curves = pair.curves()
    higher = hypot(1.0, waves / pair.height) - 1
    law, pressure = _other_law(pair, curves, thickness)
    others = {
        "height": curves.scaled(1 + part * HEIGHT_SPREAD),
        "long waves": curves.scaled(1 + part * higher),
        "contact": pressed(curves, pressure, part),
        "slope": _steeper(pair, curves, part),
        "sample": _sampled(pair, curves, part),
        **{
            lay: _drawn_out(pair, curves, sign * part)
            for lay, sign in zip(LAYS, (1, -1), strict=True)
        },
        "pressure flow": _scattered(curves, slice(3, 6), part),
        "shear flow": _scattered(curves, slice(6, 9), part),
    }
    for name, other in others.items():
        if other.scale != curves.scale or not np.array_equal(other.values, curves.values):
            refitted = {"contact": REFITTED[law], "slope": REFITTED["stiffer"] ** SLOPE_POWER}.get(
                name, 1.0
            )
            factor = 1.0 if fitted_spread is None else refitted**part
            yield name, Variation(other, boundary_friction * factor, name in BY_FACTOR)
    spread = BOUNDARY_FRICTION_SPREAD if fitted_spread is None else fitted_spread
    yield "boundary friction", Variation(curves, boundary_friction * (1 + part * spread))


def flow_scatter(gap: npt.ArrayLike) -> Array:
    """Relative scatter of flow factors by the gap over the roughness [-]."""
    return FLOW_SCATTER * np.maximum(gap, 1.0) ** -FLOW_FALL


def other_laws(pair: RoughSurfaces, curves: GapCurves) -> dict[str, Array]:
    """Other laws of contact, each with the logarithm of the asperities' pressure [ln Pa] over the rows."""
    pressure = curves.values[0]
    # asperities of one radius, as stiff where the mean planes touch
    gap = curves.gaps / curves.scale
    fall = overlap_moment(2.5, gap) / overlap_moment(2.5, 0.0)
    touching = np.interp(0.0, gap, pressure)
    laws = {
        "stiffer": pressure + log(STIFFNESS_FACTOR),
        "one radius": touching + np.log(np.maximum(fall, np.exp(pressure.min() - touching))),
    }
    elastic = pair.elastic()
    return laws if elastic is None else laws | {"elastic": elastic.curves().values[0]}


def _other_law(pair: RoughSurfaces, curves: GapCurves, thickness: Array) -> tuple[str, Array]:
    """The other law of contact by which the load of the asperities changes most at a given gap."""

    def load(pressure: Array) -> float:
        return float(np.exp(np.interp(thickness, curves.thicknesses, pressure)).sum())

    present = load(curves.values[0])
    laws = other_laws(pair, curves).items()
    return max(laws, key=lambda law: abs(load(law[1]) - present))


def pressed(curves: GapCurves, other: Array, part: float) -> GapCurves:
    """Curves with the asperities' logarithm of pressure changed by a part of the way to another law's."""
    pressure = curves.values[0]
    return _with_rows(curves, slice(0, 1), pressure + part * (other - pressure))


def _sampled(pair: RoughSurfaces, curves: GapCurves, part: float) -> GapCurves:
    """Curves with asperity pressure and flow factors larger by a part of what other places would show."""
    errors = pair.sampled()
    if errors is None:
        return curves
    pressure, flow = errors
    rows = slice(3, 6)
    larger = _with_rows(curves, rows, curves.values[rows] * (1 + part * flow))
    return pressed(larger, curves.values[0] + pressure, part)


def _steeper(pair: RoughSurfaces, curves: GapCurves, part: float) -> GapCurves:
    """Curves with the pressure of asperities of other slopes, by a part of their factor's logarithm."""
    other = pair.steeper(SLOPE_FACTOR)
    return curves if other is None else pressed(curves, other.curves().values[0], part)


def _drawn_out(pair: RoughSurfaces, curves: GapCurves, part: float) -> GapCurves:
    """Curves with the flow factors of other aspects, by a part of their factor's logarithm."""
    other, rows = pair.drawn_out(ASPECT_FACTOR**part), slice(3, 9)
    return curves if other is None else _with_rows(curves, rows, other.curves().values[rows])


def _scattered(curves: GapCurves, rows: slice, part: float) -> GapCurves:
    """Curves with flow factors larger by a part of their scatter."""
    larger = 1 + part * flow_scatter(curves.gaps / curves.scale)
    return _with_rows(curves, rows, curves.values[rows] * larger)


def _with_rows(curves: GapCurves, rows: slice, values: Array) -> GapCurves:
    changed = curves.values.copy()
    changed[rows] = values
    return GapCurves.through(curves.scale, curves.first, curves.spacing, changed)
