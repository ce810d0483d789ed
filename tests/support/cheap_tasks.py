"""Tasks that take little, and one that kills its process."""

import os
import signal
from pathlib import Path

from pyworm.batch.task import Task
from pyworm.case.case import load

TRACTION = Path(__file__).parents[2] / "cases" / "traction_steel.toml"
CHEAP = {"accuracy": 0.3, "effects": "isothermal"}


class Deadly(Task):
    """A task that kills its process, as the kernel's of the system does when memory runs out."""

    def __reduce__(self):
        return Deadly, super().__reduce__()[1]

    def solved(self, *how):
        os.kill(os.getpid(), signal.SIGKILL)


def some_tasks(count=4):
    """Tasks of one cheap contact at several slide-roll ratios."""
    case = load(TRACTION)
    return [Task(case, place, **CHEAP) for place in case.places()[:count]]
