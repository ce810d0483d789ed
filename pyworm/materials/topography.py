"""Heights of a surface over an area of it, measured or generated."""

from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256

import numpy as np

from pyworm.formulas.arrays import Array, Flags

BISECTIONS = 50
"""Bisections for the height at which summits are worn off."""


@dataclass(frozen=True, eq=False)
class Topography:
    """Heights over a rectangle; two of the same heights are equal."""

    height: Array
    """Heights [m], outwards of the body, of mean zero, shape (nx, ny)."""
    spacing: tuple[float, float]
    """Distance of points along x and y [m]."""
    periodic: bool = False
    """Whether the heights repeat themselves beyond the rectangle."""
    x_direction: float = 0.0
    """Angle of the x axis from the surface's own motion through the contact [rad]."""
    measured: Flags | None = None
    """True where a height was measured, false where one was filled in between those around it, which no
    figure counts; None where all were measured or generated."""
    samples: tuple["Topography", ...] = ()
    """Surfaces by parts of what was measured, whose averages scatter as those of other places would; none of
    generated surfaces."""

    @property
    def extent(self) -> tuple[float, float]:
        """Length of the sides along x and y [m]."""
        return tuple(n * step for n, step in zip(self.height.shape, self.spacing, strict=True))

    @property
    def rms(self) -> float:
        """Root mean square height Rq of the measured points [m]."""
        return float(self.measured_heights.std())

    @property
    def known(self) -> Flags:
        """Where heights were measured, as an array of truths."""
        return np.ones(self.height.shape, bool) if self.measured is None else self.measured

    @property
    def measured_heights(self) -> Array:
        """Heights of the measured points [m], in a row."""
        return self.height.ravel() if self.measured is None else self.height[self.measured]

    def turned(self, x_direction: float) -> "Topography":
        """The heights with their x axis at an angle from the surface's own motion [rad]."""
        samples = tuple(sample.turned(x_direction) for sample in self.samples)
        return replace(self, x_direction=x_direction, samples=samples)

    @property
    def quarters(self) -> "tuple[Topography, ...]":
        """Its four quarters, each of which leaves the other three out."""
        middle = [n // 2 for n in self.height.shape]
        halves = [(slice(0, n), slice(n, None)) for n in middle]
        places = [(first, second) for first in halves[0] for second in halves[1]]
        return tuple(
            replace(
                self,
                height=self.height[place] - self.height[place].mean(),
                periodic=False,
                measured=None if self.measured is None else self.measured[place],
            )
            for place in places
        )

    def run_in(self, ratio: float) -> "Topography":
        """The heights with summits worn off so far that Rq falls to a ratio of what it was (`wear_law`).

        Heights z become min(z, t), whose mean is zero again; t by bisection between both ends.
        """
        low, high = float(self.height.min()), float(self.height.max())
        for _ in range(BISECTIONS):
            level = (low + high) / 2
            left = float(np.minimum(self.measured_heights, level).std())
            low, high = (level, high) if left < ratio * self.rms else (low, level)
        height = np.minimum(self.height, high)
        return replace(
            self,
            height=height - height.mean(),
            samples=tuple(sample.run_in(ratio) for sample in self.samples),
        )

    @property
    def mirrored(self) -> "Topography":
        """The mirror image of the heights and of the motion, in the plane of the motion."""
        return replace(
            self,
            height=self.height[:, ::-1],
            x_direction=-self.x_direction,
            measured=None if self.measured is None else self.measured[:, ::-1],
            samples=tuple(sample.mirrored for sample in self.samples),
        )

    @cached_property
    def digest(self) -> str:
        """Digest of the heights and where they are."""
        place = repr((self.height.shape, self.spacing, self.periodic, self.x_direction))
        digest = sha256(place.encode() + np.ascontiguousarray(self.height).tobytes())
        if self.measured is not None:
            digest.update(np.packbits(self.measured).tobytes())
        for sample in self.samples:
            digest.update(sample.digest.encode())
        return digest.hexdigest()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Topography) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)
