"""The axial section of a thread: its thickness and pressure angle, and where a fillet ends its flank."""

from math import atan, cos, sin, tan

import scipy

from pyworm.drives.worm.flanks.surfaces import WormSurface


def thread_thickness(flank: WormSurface, radius: float, reference: float, there: float) -> float:
    """Axial thickness on a cylinder [m] of a thread with a thickness on another one, `there` [m].

    Below the beginning of the flank it is that at the beginning.
    """
    grown, at_reference = (
        flank.axial_profile(max(r, flank.start_radius)) for r in (radius, reference)
    )
    return there - 2 * (grown - at_reference)


def form_radius(flank: WormSurface, end: float, fillet: float, other_end: float) -> float:
    """Radius of the cylinder on which a flank turns into an arc that ends it [m].

    The arc's centre is `fillet` from the cylinder that ends the thread and from the flank: r = end +- fillet
    (1 - sin alpha_x(r)), + at a root and - at a tip (closed for the straight flanks of ZA). Without a fillet
    the flank goes on to the end; ValueError if the arc leaves none up to the other end.
    """
    if fillet == 0:
        return end
    side = 1.0 if other_end > end else -1.0

    def beyond(radius: float) -> float:
        return side * (radius - end) - fillet * (1 - sin(axial_angle(flank, radius)))

    start = max(flank.start_radius, min(end, other_end))
    near, far = (start, other_end) if side > 0 else (end, start)
    if beyond(near) >= 0:  # the arc meets what is below the base cylinder, where no flank is
        return near
    if beyond(far) <= 0:
        raise ValueError("it leaves no flank")
    return float(scipy.optimize.brentq(beyond, near, far, xtol=1e-15))


def axial_angle(flank: WormSurface, radius: float) -> float:
    """Pressure angle in the axial section [rad] on a cylinder [m]."""
    return atan(tan(flank.pressure_angle(radius)) / cos(atan(flank.screw / radius)))
