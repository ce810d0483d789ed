"""Where the flanks end: tip, fillet of the root, face width, throat and hobbed root of the wheel."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.drawing.design import NO_RELIEF, ParabolicRelief
from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.flanks.helicoid import Array, Seated


def wheel_radius(point: Array) -> Array:
    """Distance of points (3, ...) from the wheel's axis [m]."""
    return np.sqrt(point[0] ** 2 + point[2] ** 2)


@dataclass(frozen=True)
class WormTooth:
    """The thread between its root's fillet and its tip cylinder; its length is not limited."""

    worm: Seated
    """The worm flank and its axis."""
    form_radius: float
    """Radius of the cylinder from which it has its flank [m]: the fillet is below."""
    tip_radius: float
    """Radius of the cylinder up to which it has its flank [m]."""
    tip_relief: ParabolicRelief = NO_RELIEF
    """What is taken off towards the tip."""
    deviations: FlankDeviations | None = None
    """Deviations of the flank from the helicoid."""

    @property
    def start_radius(self) -> float:
        """Radius from which the flank exists [m]: that above the fillet, or where the helicoid begins."""
        return max(self.form_radius, self.worm.start_radius)

    def margins(self, point: Array) -> dict[str, Array]:
        """Distance inside each boundary [m] at points (3, ...), negative beyond it.

        The involute starts at the base cylinder, wherever the root lies, other flanks where they exist.
        """
        radius = self.worm.radius(point)
        return {"worm tip": self.tip_radius - radius, "worm root": radius - self.start_radius}

    def removed(self, point: Array) -> Array:
        """What the flank is below the highest place of the helicoid, at its points (3, ...) [m]."""
        radius, off = self.worm.radius(point), np.zeros(point.shape[1:])
        if self.tip_relief != NO_RELIEF:
            off = self.tip_relief(self.tip_radius - radius)
        if self.deviations is None:
            return off
        return off + self.deviations.removed(self.worm.along_axis(point), radius)


@dataclass(frozen=True)
class WheelTooth:
    """The wheel tooth between face ends, tip, throat and root.

    The throat is a torus about the wheel's axis whose inner radius is the throat radius, cut off by the tip
    cylinder. Unless its own radius is given it is read as concentric with the hob in the mid-plane of the
    wheel, so that the tip's profile is the hob's root cylinder (hob centre distance - throat radius = hob
    root radius in the table of Sharif et al. 2001).  The root is the torus that the hob's tip sweeps; the
    hob's swivel, a fraction of a degree, is left out of both (its influence is its square).
    """

    hob: Seated
    """The seated hob."""
    face_width: float
    """Width along the axis [m]."""
    tip_radius: float
    """Radius of the tip cylinder [m]."""
    throat_radius: float
    """Smallest tip radius [m]."""
    hob_tip_radius: float
    """Radius of the hob's tip cylinder [m]."""
    hob_form_radius: float
    """Radius up to which the hob's flank reaches [m]; its rounded tip beyond cuts the fillet."""
    tip_relief: ParabolicRelief = NO_RELIEF
    """What is taken off towards tip and throat."""
    groove_radius: float | None = None
    """Radius of the throat's profile [m]; None where it is concentric with the hob."""
    deviations: FlankDeviations | None = None
    """Deviations of the flank from the one that the hob cuts."""

    def removed(self, point: Array) -> Array:
        """What the flank is below the highest place of the hobbed one, at its points (3, ...) [m]."""
        off = np.zeros(point.shape[1:])
        if self.tip_relief != NO_RELIEF:
            margins = self.margins(point)
            off = self.tip_relief(np.minimum(margins["wheel tip"], margins["wheel throat"]))
        if self.deviations is None:
            return off
        return off + self.deviations.removed(point[1], wheel_radius(point))

    def margins(self, point: Array) -> dict[str, Array]:
        """Distance inside each boundary [m] at points (3, ...), negative beyond it."""
        radius = wheel_radius(point)
        below = self.hob.centre_distance - radius
        to_groove = self._groove_centre - radius
        shifted = point[1] - self.hob.axial_shift
        return {
            "wheel face": self.face_width / 2 - np.abs(point[1]),
            "wheel tip": self.tip_radius - radius,
            "wheel throat": np.sqrt(to_groove**2 + point[1] ** 2) - self._groove,
            "wheel root": self.hob_form_radius - np.sqrt(below**2 + shifted**2),
        }

    @property
    def _groove(self) -> float:
        """Radius of the throat's profile [m]."""
        if self.groove_radius is not None:
            return self.groove_radius
        return self.hob.centre_distance - self.throat_radius

    @property
    def _groove_centre(self) -> float:
        """Distance of the middle of the throat's profile from the wheel's axis [m]."""
        if self.groove_radius is not None:
            return self.throat_radius + self.groove_radius
        return self.hob.centre_distance

    def throat_half_width(self, below_tip: float = 0.0) -> float:
        """Distance from the mid-plane [m] at which the throat ends; infinite if nowhere.

        Below the tip, that at which throat and tip cylinder are equally far.
        """
        to_centre = self._groove_centre - self.tip_radius + below_tip
        square = (self._groove + below_tip) ** 2 - to_centre**2
        return float(np.sqrt(square)) if square > 0 else np.inf

    def below_tip(self, along: Array, distance: float) -> Array:
        """Radius [m] at a distance below tip and throat, at distances along the wheel's axis [m]."""
        profile = np.sqrt(np.maximum((self._groove + distance) ** 2 - along**2, 0.0))
        return np.minimum(self.tip_radius - distance, self._groove_centre - profile)

    def tip(self, along: Array | float) -> Array:
        """Outer radius of the tooth [m] at distances along the wheel's axis [m]."""
        return self.below_tip(np.asarray(along), 0.0)

    def root(self, along: Array | float) -> Array:
        """Radius [m] where the flank meets the hobbed root at distances along the wheel's axis [m]."""
        shifted = along - self.hob.axial_shift
        profile = np.sqrt(np.maximum(self.hob_tip_radius**2 - shifted**2, 0.0))
        return np.minimum(self.hob.centre_distance - profile, self.tip(along))

    def rim(self, count: int) -> tuple[Array, Array]:
        """Closed outline of the tooth: radius and place along the axis [m], 4 count + 1 points."""
        half = self.face_width / 2
        along = np.linspace(-half, half, count + 1)
        part = np.linspace(0.0, 1.0, count + 1)

        def end(place: float) -> Array:
            return self.root(place) + part * (self.tip(place) - self.root(place))

        radius = [self.tip(along)[:-1], end(half)[:0:-1], self.root(along)[:0:-1], end(-half)]
        place = [along[:-1], np.full(count, half), along[:0:-1], np.full(count + 1, -half)]
        return np.concatenate(radius), np.concatenate(place)
