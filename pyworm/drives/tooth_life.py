"""The life of a contact as its drive turns."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pyworm.scene.life import Life, Past, unturned
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class ToothLife:
    """A contact of a mesh from phase 0 to phase 1, or from 1 to 0 where the drive runs backwards.

    Attributes
    ----------
    scene_at : callable
        Phase -> scene; ValueError where there is none.
    phases_per_second : float
        Rate of change of the phase [1/s], negative where the drive runs backwards.
    axes_at : callable
        Phase -> x, y and normal of the tangent plane, as rows in the frame of the velocities.
    """

    scene_at: Callable[[float], Scene | LineScene]
    phases_per_second: float
    axes_at: Callable[[float], np.ndarray] = unturned

    def at(self, phase: float) -> Scene | LineScene:
        """The scene at a phase with its past."""
        rate = self.phases_per_second
        passed = phase if rate > 0 else 1 - phase
        life = Life(1 / abs(rate), self._scene_then, self._axes_then)
        return replace(self.scene_at(phase), past=Past(life, passed / abs(rate)))

    def _scene_then(self, seconds: float) -> Scene | LineScene:
        """The scene at a time since the first touch [s]."""
        return self.scene_at(self._phase(seconds))

    def _axes_then(self, seconds: float) -> np.ndarray:
        """Its axes then."""
        return self.axes_at(self._phase(seconds))

    def _phase(self, seconds: float) -> float:
        passed = min(max(seconds * abs(self.phases_per_second), 0.0), 1.0)  # rounding aside
        return passed if self.phases_per_second > 0 else 1 - passed
