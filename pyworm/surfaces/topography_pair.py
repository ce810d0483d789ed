"""Two surfaces in contact of which at least one is known point by point: averages by the gap."""

from dataclasses import dataclass, replace
from math import hypot

import numpy as np
import scipy

from pyworm.io.present import present
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.rough_surfaces import MIN_GAP_RATIO, GapCurves, gap_rows, tabulated
from pyworm.materials.topography import Topography
from pyworm.surfaces.cell import common_cell, periodic_cell
from pyworm.surfaces.cell_table import CellTable, cell_table
from pyworm.surfaces.scatter import uncertainty_of_whole

Array = np.ndarray

LEAST_TOUCHED = 1e-4
"""Real area of contact below which so few nodes touch that the pressure is that of single summits."""

PRESSURE_FLOW = 3, 6
"""Rows of the pressure flow factors among those of `GapCurves`."""

MOST_SCATTER = 1.0
"""Largest uncertainty of a logarithm that counts: where single summits touch, and bear next to nothing."""


@dataclass(frozen=True)
class TopographyPair:
    """Two rough surfaces in contact, at least one of them a topography.

    The other, of which only the height is known, counts as of the same texture, higher or lower.
    """

    surfaces: tuple[Topography | None, Topography | None]
    """Those of both bodies, x axes from the contact's; None where only the height is known."""
    heights: tuple[float, float]
    """Root mean square heights of both [m]."""
    reduced_modulus: float
    """Reduced modulus E' [Pa]."""
    hardness: float | None
    """Indentation hardness of the softer body [Pa]; None of surfaces that do not yield."""

    @property
    def height(self) -> float:
        """Composite root mean square height [m]."""
        return hypot(*self.heights)

    def contact(self) -> CellTable:
        """The table of both together: heights add, or stand for both where only one is known."""
        known = [surface for surface in self.surfaces if surface is not None]
        cell = common_cell((known[0], known[1])) if len(known) == 2 else periodic_cell(known[0])
        return self._table(cell)

    def flows(self) -> tuple[tuple[float, CellTable], tuple[float, CellTable]]:
        """Of each surface the direction of its x axis [rad] and the table of it alone, as high as both."""
        known = next(surface for surface in self.surfaces if surface is not None)
        both = [surface if surface is not None else known for surface in self.surfaces]
        first, second = (
            (surface.x_direction, self._table(periodic_cell(surface))) for surface in both
        )
        return first, second

    def _table(self, cell: Topography) -> CellTable:
        """Table of a cell, as high as both surfaces together."""
        as_high = replace(cell, height=cell.height * (self.height / cell.rms), x_direction=0.0)
        return cell_table(as_high, self.reduced_modulus, self.hardness)

    def sampled(self) -> tuple[Array, Array] | None:
        """Uncertainty by the measured place over the rows [-], as of `RoughSurfaces.sampled`.

        It is by the surfaces' samples, each as high as the whole, so that their texture alone differs; None
        of surfaces without samples.
        """
        counts = [len(surface.samples) for surface in self.surfaces if surface and surface.samples]
        if not counts:
            return None
        curves = [self._sample(number).curves().values for number in range(min(counts))]
        whole = self.curves().values
        pressure, flow = (
            uncertainty_of_whole([values[rows] for values in curves], whole[rows])
            for rows in (0, slice(*PRESSURE_FLOW))
        )
        present = np.mean([values[slice(*PRESSURE_FLOW)] for values in curves], axis=0)
        return np.minimum(pressure, MOST_SCATTER), (flow[:2] / np.abs(present[:2])).max(axis=0)

    def _sample(self, number: int) -> "TopographyPair":
        """The surfaces by a sample of each that has some."""
        first, second = (
            surface.samples[number] if surface and surface.samples else surface
            for surface in self.surfaces
        )
        return replace(self, surfaces=(first, second))

    def elastic(self) -> "TopographyPair | None":
        """The surfaces as if they did not yield; None where neither does."""
        return None if self.hardness is None else replace(self, hardness=None)

    def steeper(self, factor: float) -> None:
        """None: slopes are those of the heights."""

    def drawn_out(self, factor: float) -> None:
        """None: the heights show their lay."""

    def curves(self) -> GapCurves:
        """All averages as tables for the kernel."""
        row, gap = gap_rows()
        gap = gap * self.height
        contact = self.contact()
        pressure, area = contact_beyond(contact, gap, self.hardness)
        open_gap = gap + _interpolated(contact, contact.thickness - contact.separation, gap)
        least = MIN_GAP_RATIO * self.height
        thickness = (np.maximum(open_gap, 0.0) ** 4 + least**4) ** 0.25
        cube, shear = np.zeros((3, gap.size)), np.zeros((3, gap.size))
        for (direction, table), height, side in zip(
            self.flows(), self.heights, (1, -1), strict=True
        ):
            share = (height / self.height) ** 2
            factors, dragged = flow_beyond(table, gap)
            cube += share * _turned(factors, direction) * np.maximum(open_gap, 0.0) ** 3
            shear += side * share * _turned(dragged, direction) * np.maximum(open_gap, 0.0)
        isotropic = np.array([1.0, 1.0, 0.0])[:, None]
        return tabulated(
            row,
            self.height,
            pressure=pressure,
            area=area,
            surplus=thickness - gap,
            flow=(cube + least**3 * isotropic) / thickness**3,
            shear=shear,
        )


def contact_beyond(table: CellTable, gap: Array, hardness: float | None) -> tuple[Array, Array]:
    """Pressure [Pa] and real area at gaps [m], continued beyond the table.

    There the odds of pressure to hardness, and of real to open area, change exponentially, as those of
    elastic surfaces do: neither comes to its bound.
    """
    touched = table.area >= min(LEAST_TOUCHED, table.area.max())
    place, bound = table.separation[touched], np.inf if hardness is None else hardness
    pressure = np.minimum(table.pressure[touched], (1 - 1e-9) * bound)
    odds = np.log(pressure) - np.log1p(-pressure / bound)
    open_odds = np.log(table.area[touched]) - np.log1p(-table.area[touched])
    odds, open_odds = (_continued(place, values, gap) for values in (odds, open_odds))
    scale = np.exp(np.minimum(odds, 600.0))
    return scale / (1 + scale / bound), scipy.special.expit(open_odds)


def flow_beyond(table: CellTable, gap: Array) -> tuple[Array, Array]:
    """Pressure flow factors of the mean gap's cube, and shear flow times height over mean gap, at gaps [m].

    Beyond the widest separation both approach smooth surfaces with the square of the gap, as exact theory of
    second order has it (J. H. Tripp, J. Lubr. Technol. 105 (1983) 458).
    """
    smooth = np.array([1.0, 1.0, 0.0])[:, None]
    widest = table.separation[0]
    ratio = widest / np.maximum(gap, widest)
    roughening = _interpolated(table, table.conducted / table.flowing**3 - smooth, gap)
    return smooth + roughening * ratio**2, _interpolated(
        table, table.dragged / table.flowing, gap
    ) * ratio**2


def _interpolated(table: CellTable, values: Array, gap: Array) -> Array:
    """Values of a table at gaps [m], constant beyond its ends."""
    curve = scipy.interpolate.PchipInterpolator(table.separation[::-1], values[..., ::-1], axis=-1)
    return curve(np.clip(gap, table.separation[-1], table.separation[0]))


def _continued(place: Array, values: Array, gap: Array) -> Array:
    """Values at gaps, straight on beyond the ends."""
    curve = scipy.interpolate.PchipInterpolator(place[::-1], values[::-1])
    low, high = place[-1], place[0]
    slope = curve.derivative()
    inside = np.clip(gap, low, high)
    return curve(inside) + np.where(
        gap < low, slope(low) * (gap - low), np.where(gap > high, slope(high) * (gap - high), 0.0)
    )


def _turned(tensor: Array, angle: float) -> Array:
    """Tensors xx, yy, xy given in axes turned by an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    xx, yy, xy = tensor
    return np.array(
        [
            c * c * xx + s * s * yy - 2 * c * s * xy,
            s * s * xx + c * c * yy + 2 * c * s * xy,
            c * s * (xx - yy) + (c * c - s * s) * xy,
        ]
    )


def topography_pair(bodies: tuple[Body, Body], directions: tuple[float, float]) -> TopographyPair:
    """The surfaces of two bodies of known roughness, one of a topography, moving from the x axis [rad]."""
    first, second = (
        None
        if body.topography is None
        else body.topography.turned(body.topography.x_direction + direction)
        for body, direction in zip(bodies, directions, strict=True)
    )
    yielding = [body.hardness for body in bodies if body.hardness is not None]
    return TopographyPair(
        (first, second),
        (present(bodies[0].roughness, "roughness"), present(bodies[1].roughness, "roughness")),
        reduced_modulus(*bodies),
        min(yielding) if yielding else None,
    )
