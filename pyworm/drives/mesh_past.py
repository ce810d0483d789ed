"""The past of a contact as its drive turns."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import atan2

import numpy as np

from pyworm.scene.contact import Array
from pyworm.scene.line import LineScene
from pyworm.scene.past import Earlier, Past
from pyworm.scene.point import Scene


def unturned(phase: float) -> Array:
    """Axes of contacts whose axes do not rotate."""
    return np.eye(3)


@dataclass(frozen=True)
class Passing:
    """A contact of a mesh as a function of the time before the present [s].

    Attributes
    ----------
    scene_at : callable
        Phase -> scene; ValueError where there is none.
    phase : float
        Place in the mesh cycle at present, 0 to 1.
    phases_per_second : float
        Rate of change of the phase [1/s], negative where the drive runs backwards.
    axes_at : callable
        Phase -> x, y and normal of the tangent plane, as rows in the frame of the velocities.
    """

    scene_at: Callable[[float], Scene | LineScene]
    phase: float
    phases_per_second: float
    axes_at: Callable[[float], Array] = unturned

    def __call__(self, seconds: float) -> Earlier:
        """The contact at that time; ValueError where there was none."""
        then = self.phase - seconds * self.phases_per_second
        then = min(max(then, 0.0), 1.0)  # rounding aside
        x, y, _ = self.axes_at(self.phase)
        x_then = self.axes_at(then)[0]
        return Earlier(seconds, self.scene_at(then), atan2(float(x_then @ y), float(x_then @ x)))

    def scene(self) -> Scene | LineScene:
        """The present scene with its past."""
        passed = self.phase if self.phases_per_second > 0 else 1 - self.phase
        past = Past(passed / abs(self.phases_per_second), self)
        return replace(self.scene_at(self.phase), past=past)
