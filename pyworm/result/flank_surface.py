"""Fields of results at points of a wheel's flank in space."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import scipy

from pyworm.io.kept_arrays import kept
from pyworm.result.flank_map import flank_map
from pyworm.result.result import Result

Array = np.ndarray


def on_flank(points: Array, result: Result) -> dict[str, Array] | None:
    """Extremes over the mesh cycle, as of `flank_map`, at points (rows, columns, 3) [m] by name.

    NaN where no contact passes; the pressure is zero there. None without enough phases.
    """
    found = flank_map(result)
    if found is None:
        return None
    fields = {
        str(name): _at(points, found["radius"].values, found["face"].values, found[name].values)
        for name in found.data_vars
    }
    return {**fields, "pressure": np.nan_to_num(fields["pressure"])}


@dataclass(frozen=True)
class WornFlank:
    """What is worn off a wheel's flank."""

    radius: Array
    """Distances from the wheel's axis, rising [m]."""
    face: Array
    """Places along the face from its middle, rising [m]."""
    depth: Array
    """Depth worn off there, (radius, face) [m]."""

    def depth_at(self, points: Array) -> Array:
        """Depth at points (rows, columns, 3) [m]; zero beyond the places known."""
        return np.nan_to_num(_at(points, self.radius, self.face, self.depth))


def worn_flank(path: Path) -> WornFlank:
    """The flank at the end of the last step that `pyworm wear` has kept.

    FileNotFoundError without such a file, DamagedError of another one.
    """
    return kept(path, lambda held: WornFlank(held["radius"], held["face"], held["depths"][-1]))


def _at(points: Array, radius: Array, face: Array, field: Array) -> Array:
    """A field over (radius, face) at points, linear between its cells; NaN beyond them."""
    distance = np.hypot(points[..., 0], points[..., 2])
    places = np.stack([distance, points[..., 1]], axis=-1)
    return np.asarray(
        scipy.interpolate.interpn(
            (radius, face), field, places, bounds_error=False, fill_value=np.nan
        )
    )
