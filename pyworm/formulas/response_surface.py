"""A model in place of dear solves: each response as a parabola in the logarithm of each unknown.

A response is known at a centre and at one step of each unknown to both sides, one plus twice as many solves
as unknowns. Positive responses that follow power laws, such as films, are taken by their logarithm, in which
they are straight lines. Solves elsewhere shift the surface to meet them (first-order correction of a
surrogate: N. M. Alexandrov, R. M. Lewis, C. R. Gumbert, L. L. Green and P. A. Newman, J. Aircr. 38 (2001)
1093-1101).

Over decades of the unknowns, where a parabola does not hold, responses are interpolated between scattered
solves (thin-plate splines, which are straight where solves say nothing else); the error is that of leaving
out one solve at a time.
"""

from dataclasses import dataclass, replace

import numpy as np
import scipy

from pyworm.formulas.arrays import Array, Flags

STEP = 0.2
"""Step of the logarithm of an unknown: so far that numerical errors of a few per cent matter little."""


@dataclass(frozen=True)
class ResponseSurface:
    """Responses over the logarithms of unknowns over their values at a centre."""

    level: Array
    """Responses at the centre, or their logarithms, (responses)."""
    slope: Array
    """Their change with each logarithm, (responses, unknowns)."""
    curvature: Array
    """Their second differences, (responses, unknowns)."""
    logarithmic: Flags
    """Which responses are taken by their logarithm, (responses)."""

    @staticmethod
    def through(centre: Array, less: Array, more: Array, logarithmic: Flags) -> "ResponseSurface":
        """The surface through solves at a centre (responses), a step down and up (responses, unknowns)."""
        mid = _taken(centre, logarithmic)[:, None]
        low, high = (_taken(side, logarithmic[:, None]) for side in (less, more))
        return ResponseSurface(
            mid[:, 0], (high - low) / (2 * STEP), (high - 2 * mid + low) / STEP**2, logarithmic
        )

    def _at(self, place: Array) -> Array:
        return self.level + self.slope @ place + self.curvature @ np.square(place) / 2

    def responses(self, place: Array) -> Array:
        """Responses at logarithms of the unknowns over the centre, (responses)."""
        found = self._at(place)
        return np.where(self.logarithmic, np.exp(np.where(self.logarithmic, found, 0.0)), found)

    def sensitivity(self, place: Array) -> Array:
        """Change of each response with each logarithm, (responses, unknowns)."""
        slope = self.slope + self.curvature * place
        return slope * np.where(self.logarithmic, self.responses(place), 1.0)[:, None]

    def through_also(self, place: Array, responses: Array) -> "ResponseSurface":
        """The surface shifted to meet solves elsewhere."""
        return replace(
            self, level=self.level + _taken(responses, self.logarithmic) - self._at(place)
        )


@dataclass(frozen=True)
class ScatteredSurface:
    """A positive response between scattered solves, by its logarithm."""

    places: Array
    """Places of the solves, each unknown from 0 to 1 over its range, (solves, unknowns)."""
    responses: Array
    """Responses there, (solves)."""

    def at(self, places: Array) -> Array:
        """Responses at places, (places, unknowns)."""
        if self.places.shape[1] == 0:
            return np.full(len(places), self.responses.mean())
        # few places may lie on a line or in a plane, where no slope across is known
        slopes = np.column_stack([np.ones(len(self.places)), self.places])
        full = np.linalg.matrix_rank(slopes) == slopes.shape[1]
        kernel, degree = ("thin_plate_spline", 1) if full else ("linear", 0)
        spline = scipy.interpolate.RBFInterpolator(
            self.places, np.log(self.responses), kernel=kernel, degree=degree
        )
        found: Array = np.exp(spline(places))
        return found

    def errors(self) -> Array:
        """Relative errors of the surface at each solve if that one is left out, (solves).

        NaN at corners of the range, to which the others do not reach, and where too few others are left.
        """
        count, unknowns = self.places.shape
        inner = np.any((self.places > 0) & (self.places < 1), axis=1)
        errors = np.full(count, np.nan)
        for number in np.flatnonzero(inner) if count > unknowns + 1 else ():
            others = np.arange(count) != number
            rest = ScatteredSurface(self.places[others], self.responses[others])
            found = rest.at(self.places[number : number + 1])[0]
            errors[number] = found / self.responses[number] - 1
        return errors


def _taken(responses: Array, logarithmic: Flags) -> Array:
    chosen = np.broadcast_to(logarithmic, responses.shape)
    return np.where(chosen, np.log(np.where(chosen, responses, 1.0)), responses)
