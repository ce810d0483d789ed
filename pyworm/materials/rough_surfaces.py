"""Two rough surfaces in contact: averages over their roughness, by the gap between their mean planes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import cos, hypot, sin
from typing import Self

import numpy as np
import numpy.typing as npt
import scipy

from pyworm.formulas.arrays import Array
from pyworm.formulas.flow_factors import pressure_flow_factor, shear_flow_factor
from pyworm.formulas.rough_contact import greenwood_tripp, open_gap, self_affine
from pyworm.io.present import present
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.roughness import ASPERITY_DENSITY

MIN_GAP_RATIO = 0.05
"""Mean thickness of the gap between surfaces pressed together, over their roughness: oil is left in the
valleys, and its equations stay regular."""

TABLE_ROWS, MIN_TABLE_GAP, MAX_TABLE_GAP = 500, -6.0, 1e4
"""Rows of the tables, and their least and largest gap over the composite roughness."""

LEAST_LOGARITHM = -600.0
"""Logarithm of the least pressure of asperities [Pa], which is none."""

LEAST_AREA = 1e-30
"""Real area of contact over the nominal one that is none."""


@dataclass(frozen=True)
class RoughSurface:
    """Roughness of one surface."""

    height: float
    """Root mean square height Rq [m]."""
    slope: float
    """Root mean square slope [-]."""
    aspect: float = 1.0
    """Correlation length along the lay over that across it [-]."""
    lay: float = 0.0
    """Angle of the lay from the x axis [rad]."""
    hardness: float | None = None
    """Indentation hardness [Pa]; None of a surface that does not yield."""
    sharpness: float | None = None
    """Composite roughness over the radius of asperities of one radius [-]; None if rough on all scales."""
    density: float = ASPERITY_DENSITY
    """Such asperities for each area times radius times composite roughness [-]."""


@dataclass(frozen=True)
class GapCurves:
    """Averages of two rough surfaces over the gap between their mean planes, as the kernel takes them."""

    scale: float
    """Scale of the gap [m]."""
    first: float
    """asinh(gap/scale) of the first row."""
    spacing: float
    """Difference of asinh(gap/scale) between rows."""
    values: Array
    """Curves (`fortran/film/rough_surfaces.f90`), (9, rows)."""
    slopes: Array
    """Derivatives of the curves by the rows' coordinate, (9, rows)."""

    @classmethod
    def through(cls, scale: float, first: float, spacing: float, values: Array) -> Self:
        """Monotone curves through the values of all rows."""
        row = first + spacing * np.arange(values.shape[1])
        slopes = scipy.interpolate.PchipInterpolator(row, values, axis=1).derivative()(row)
        return cls(scale, first, spacing, values, slopes)

    @property
    def gaps(self) -> Array:
        """Gap between mean planes of each row [m]."""
        gaps: Array = self.scale * np.sinh(
            self.first + self.spacing * np.arange(self.values.shape[1])
        )
        return gaps

    @property
    def thicknesses(self) -> Array:
        """Mean thickness of the gap of each row [m]."""
        thicknesses: Array = self.gaps + self.values[1]
        return thicknesses

    def gap_under(self, pressure: float) -> float:
        """Gap between mean planes [m] at which asperities alone bear a pressure [Pa]."""
        return float(np.interp(-np.log(pressure), -self.values[0], self.gaps))

    def at_thickness(self, thickness: float) -> Array:
        """All curves where the gap has a mean thickness [m], (9,)."""
        return np.array([np.interp(thickness, self.thicknesses, row) for row in self.values])

    def scaled(self, factor: float) -> "GapCurves":
        """Those of surfaces with all lengths times a factor, which bear as much at a gap as much wider."""
        lengths = np.array([1.0, factor, 1.0, 1.0, 1.0, 1.0, factor, factor, factor])[:, None]
        return replace(
            self,
            scale=factor * self.scale,
            values=lengths * self.values,
            slopes=lengths * self.slopes,
        )


@dataclass(frozen=True)
class RoughPair:
    """Two rough surfaces in contact."""

    surfaces: tuple[RoughSurface, RoughSurface]
    """Surfaces of body 1 and body 2."""
    modulus: float
    """E* = E'/2 [Pa]."""

    @property
    def height(self) -> float:
        """Composite root mean square height [m]."""
        return hypot(*(surface.height for surface in self.surfaces))

    def contact(self, gap: npt.ArrayLike) -> tuple[Array, Array]:
        """Pressure of the asperities [Pa] and real area over the nominal one, by the gap over the roughness.

        Asperities of one radius, of the rougher surface that has some, stand for both surfaces. Elastic
        pressure and that of the softer body's hardness over the area of overlap join as the root of the sum
        of their inverse squares.
        """
        gap = np.asarray(gap, dtype=float)
        pressure, area = self._elastic_contact(gap)
        yielding = [surface.hardness for surface in self.surfaces if surface.hardness is not None]
        if not yielding:
            return pressure, area
        overlap = scipy.special.ndtr(-gap)
        share = 1 / np.hypot(1.0, pressure / (min(yielding) * np.maximum(overlap, 1e-300)))
        return pressure * share, np.maximum(area * share, overlap * np.sqrt(1 - share**2))

    def _elastic_contact(self, gap: Array) -> tuple[Array, Array]:
        """`contact` of surfaces that do not yield."""
        summits = [
            (surface.height, surface.density, surface.sharpness)
            for surface in self.surfaces
            if surface.sharpness is not None
        ]
        if not summits:
            return self_affine(
                gap, hypot(*(surface.slope for surface in self.surfaces)), self.modulus
            )
        _, density, sharpness = max(summits, key=lambda summit: summit[0])
        return greenwood_tripp(gap, density, sharpness, self.modulus)

    def mean_thickness(self, gap: npt.ArrayLike) -> Array:
        """Mean thickness of the gap where surfaces overlap nowhere, over the composite roughness [-]."""
        return (open_gap(gap) ** 4 + MIN_GAP_RATIO**4) ** 0.25

    def flow_factors(self, gap: npt.ArrayLike) -> tuple[Array, Array]:
        """Pressure flow factors of the gap's cube [-] and shear flow factors [-]: tensors xx, yy, xy.

        Those of two surfaces add with their shares of the variance, as exact theory of second order has it.
        """
        (pressure, shear), (other_pressure, other_shear) = (
            self._flow_factors(surface, gap) for surface in self.surfaces
        )
        return pressure + other_pressure, shear - other_shear

    def _flow_factors(self, surface: RoughSurface, gap: npt.ArrayLike) -> tuple[Array, Array]:
        """Parts of the pressure and shear flow factors by one surface, as if it were the first."""
        pressure = np.zeros((3, *np.shape(gap)))
        shear = np.zeros_like(pressure)
        share = (surface.height / self.height) ** 2
        for aspect, turn in ((surface.aspect, 0.0), (1 / surface.aspect, np.pi / 2)):
            along = cos(surface.lay + turn), sin(surface.lay + turn)
            tensor = np.array([along[0] ** 2, along[1] ** 2, along[0] * along[1]])[:, None]
            pressure += share * tensor * pressure_flow_factor(gap, aspect)
            shear += share * tensor * shear_flow_factor(gap, aspect)
        return pressure, shear

    def elastic(self) -> "RoughPair | None":
        """The surfaces as if they did not yield; None where neither does."""
        if all(surface.hardness is None for surface in self.surfaces):
            return None
        return self._with(lambda surface: replace(surface, hardness=None))

    def sampled(self) -> None:
        """None: nothing was measured in parts."""

    def steeper(self, factor: float) -> "RoughPair":
        """Surfaces whose slopes are larger by a factor, asperities of one radius as much sharper."""
        return self._with(
            lambda surface: replace(
                surface,
                slope=factor * surface.slope,
                sharpness=None if surface.sharpness is None else factor**2 * surface.sharpness,
            )
        )

    def drawn_out(self, factor: float) -> "RoughPair":
        """Surfaces longer along their lay by a factor, as against across."""
        return self._with(lambda surface: replace(surface, aspect=factor * surface.aspect))

    def _with(self, change: Callable[[RoughSurface], RoughSurface]) -> "RoughPair":
        first, second = (change(surface) for surface in self.surfaces)
        return replace(self, surfaces=(first, second))

    def curves(self) -> GapCurves:
        """All averages as tables for the kernel."""
        return _curves(self)


# the contacts of one life ask for the same ones hundreds of times, sensitivities for some thirty on two grids
@lru_cache(maxsize=64)
def _curves(pair: RoughPair) -> GapCurves:
    row, gap = gap_rows()
    thickness = pair.mean_thickness(gap)
    pressure, area = pair.contact(gap)
    flow, shear = pair.flow_factors(gap)
    cube = np.maximum(gap, 0.0) ** 3
    isotropic = np.array([1.0, 1.0, 0.0])[:, None]
    return tabulated(
        row,
        pair.height,
        pressure=pressure,
        area=area,
        surplus=(thickness - gap) * pair.height,
        flow=(flow * cube + MIN_GAP_RATIO**3 * isotropic) / thickness**3,
        shear=shear * pair.height,
    )


def gap_rows() -> tuple[Array, Array]:
    """Rows of the tables for the kernel, and their gap over the composite roughness [-]."""
    row = np.linspace(np.arcsinh(MIN_TABLE_GAP), np.arcsinh(MAX_TABLE_GAP), TABLE_ROWS)
    return row, np.sinh(row)


def tabulated(
    row: Array,
    height: float,
    *,
    pressure: Array,
    area: Array,
    surplus: Array,
    flow: Array,
    shear: Array,
) -> GapCurves:
    """Averages at the rows of `gap_rows` as a table for the kernel.

    By composite height [m], pressure of the asperities [Pa], real area over the nominal one, mean thickness
    less the gap between mean planes [m], flow factors of its cube [-] and shear flow factors times the
    roughness [m], both tensors xx, yy, xy, (3, rows).
    """
    values = np.vstack(
        [
            np.log(np.maximum(pressure, np.exp(LEAST_LOGARITHM))),
            surplus,
            np.where(area > LEAST_AREA, area, 0.0),
            flow,
            shear,
        ]
    )
    return GapCurves.through(height, float(row[0]), float(row[1] - row[0]), values)


def rough_pair(bodies: tuple[Body, Body], directions: Sequence[float]) -> RoughPair:
    """Both bodies' surfaces, of known roughness, moving in directions from the x axis [rad], of their lay."""
    first, second = (
        RoughSurface(
            present(body.roughness, "roughness"),
            body.roughness_slope,
            body.roughness_aspect,
            direction + body.lay,
            body.hardness,
            body.asperity_sharpness,
            body.asperity_density,
        )
        for body, direction in zip(bodies, directions, strict=True)
    )
    return RoughPair((first, second), reduced_modulus(*bodies) / 2)
