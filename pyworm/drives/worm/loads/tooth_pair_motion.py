"""The life of a tooth pair of a worm drive: from flanks that come together to the last ones under load.

Where teeth share a torque elastically, a pair is brought together by the wheel's turn under the load of the
others. Its flanks are rigidly

    h0 = -lever (Theta + ahead)                                                                          (1)

apart (`load_sharing`, equation 1, without a load). While they come together that is given, and the film
between them carries what it does. From `TOUCH` of the load of all pairs on, the pair carries so much, or its
share where that is more: oil carries load before dry flanks would touch.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy

from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.loads.tooth_compliance import EDGE_CONTACT_PHASES
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact
from pyworm.io.present import present
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

TOUCH = 0.01
"""Load of a pair from which on it is given, over that of all pairs."""

FIRST_SEPARATION = 6.0
"""Least distance of the flanks at which a life begins, over the film expected at `TOUCH`; there they carry
a tenth of that load."""

MAX_PHASE_DELAY = 0.25
"""Phases after the beginning of the mesh cycle, and before its end, within which a pair comes to `TOUCH` and
goes from it."""


def tooth_life(mesh: WormMesh) -> ToothLife:
    """The life of a tooth pair; under a given load, with equal shares or without others it begins under load.

    So it does where the flanks end, in a cusp that the hob leaves, before they would come together.
    """
    given = mesh.transmission
    shared = given is not None and given.sharing == "elastic" and mesh.pitch <= 1
    pair = _Pair(mesh) if shared else None
    if pair is None or not pair.approaches:
        return ToothLife(mesh.scene_at, mesh.phases_per_second, mesh.contact_axes)
    ends = {"before": -pair.begin, "after": pair.parted - 1, "touch": pair.touch}
    return ToothLife(pair.scene, mesh.phases_per_second, mesh.contact_axes, **ends)


@dataclass(frozen=True)
class _Pair:
    """A tooth pair over the part of the mesh cycle that is past, in the sense in which the drive turns."""

    mesh: WormMesh

    @cached_property
    def touch(self) -> float:
        """Load from which on it is given [N]."""
        return TOUCH * float(self.mesh.springs.loads[-1])

    @cached_property
    def engaged(self) -> float | None:
        """Part that is past when the pair reaches the load `touch`; None where it does so far outside."""
        return self._where(self._excess, -EDGE_CONTACT_PHASES, MAX_PHASE_DELAY)

    @property
    def approaches(self) -> bool:
        """True if there are flanks that come together before the pair carries load."""
        return (
            self.engaged is not None and self._touches(self.engaged) and self._touches(self.begin)
        )

    def _touches(self, past: float) -> bool:
        """False where the flanks would cross each other: beyond a cusp of the wheel's flank."""
        return bool(min(self._contact(past).radii) > 0)

    @property
    def _first(self) -> float:
        return present(self.engaged, "the place where the flanks meet")

    @cached_property
    def parted(self) -> float:
        """Part that is past when the pair falls below the load `touch`, at least the whole mesh cycle."""
        found = self._where(self._excess, 1 - MAX_PHASE_DELAY, 1 + EDGE_CONTACT_PHASES)
        return max(found, 1.0) if found is not None and self._touches(found) else 1.0

    @cached_property
    def begin(self) -> float:
        """Part that is past when the approaching flanks are `FIRST_SEPARATION`."""
        first = self.mesh.springs.phases[0 if self._turned(0.0) == 0 else -1]
        film = scales(self.mesh.scene_of(self._contact(self._first), self.touch)).film

        def nearer(past: float) -> float:
            phase = self._turned(past)
            spring = self.mesh.springs.at(phase)
            return spring.separation + self._separation(phase) - FIRST_SEPARATION * film

        earliest = self._turned(float(first))
        return self._where(nearer, earliest, self._first) or earliest

    def scene(self, phase: float) -> Scene:
        """The contact at a phase of its life: its flanks' separation, or its load."""
        if self._turned(phase) >= self._first:
            return self.mesh.scene_at(phase)
        contact = self.mesh.contact_beyond(phase)
        apart = self._separation(phase)
        return replace(self.mesh.scene_of(contact, self.touch), separation=apart)

    def _turned(self, phase: float) -> float:
        """Part of the mesh cycle that is past at a phase, and the phase where a part is past."""
        return phase if self.mesh.phases_per_second > 0 else 1 - phase

    def _contact(self, past: float) -> ToothContact:
        return self.mesh.contact_beyond(self._turned(past))

    def _excess(self, past: float) -> float:
        return self.mesh.normal_load(self._turned(past)) - self.touch

    def _separation(self, phase: float) -> float:
        """Equation 1 [m]."""
        phases = np.array([phase])
        ahead = self.mesh.cycle.transmission_error(phases)[0]
        lever = self.mesh.arms(phases).wheel_normal[0]
        return float(-lever * (self.mesh.shared(phase).turn + ahead))

    @staticmethod
    def _where(function: Callable[[float], float], first: float, last: float) -> float | None:
        """Where a function changes its sign; None where it does not."""
        if function(first) * function(last) >= 0:
            return None
        return float(scipy.optimize.brentq(function, first, last, xtol=1e-5))
