"""The life of a contact as its drive turns."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf

import numpy as np

from pyworm.scene.life import Life, Past, unturned
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class ToothLife:
    """A contact of a mesh from phase 0 to phase 1, or from 1 to 0 where the drive runs backwards."""

    scene_at: Callable[[float], Scene | LineScene]
    """Phase -> scene; ValueError where there is none."""
    phases_per_second: float
    """Rate of change of the phase [1/s], negative where the drive runs backwards."""
    axes_at: Callable[[float], np.ndarray] = unturned
    """Phase -> x, y and normal of the tangent plane, as rows in the frame of the velocities."""
    before: float = 0.0
    """Phases before the first one, in the sense in which the drive turns, in which the pair has a scene, too:
    of flanks that come together, and of edges under load."""
    after: float = 0.0
    """Phases after the last one, likewise."""
    touch: float = inf
    """Load from which on flanks that come together carry that of the scene (`scene.life.Life`) [N]."""

    def at(self, phase: float) -> Scene | LineScene:
        """The scene at a phase with its past."""
        return replace(self.scene_at(phase), past=self.past(phase))

    def past(self, phase: float) -> Past:
        """The past of the contact at a phase."""
        rate = abs(self.phases_per_second)
        passed = phase if self.phases_per_second > 0 else 1 - phase
        life = Life(
            (self.before + 1 + self.after) / rate,
            self._scene_then,
            self._axes_then,
            touch=self.touch,
            touched=max(self.before, 0.0) / rate,
        )
        return Past(life, (self.before + passed) / rate)

    def _scene_then(self, seconds: float) -> Scene | LineScene:
        return self.scene_at(self._phase(seconds))

    def _axes_then(self, seconds: float) -> np.ndarray:
        return self.axes_at(self._phase(seconds))

    def _phase(self, seconds: float) -> float:
        passed = seconds * abs(self.phases_per_second) - self.before
        passed = min(max(passed, -self.before), 1 + self.after)  # rounding aside
        return passed if self.phases_per_second > 0 else 1 - passed
