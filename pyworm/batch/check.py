"""Check of a case: its contacts, their plans and the expected time; nothing is solved."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, Unpack

from pyworm.batch.expected_run import expected_run
from pyworm.batch.in_python import CaseLike, as_case
from pyworm.batch.request import Request, requested, takes_request
from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.drives.forces import MeshForces
from pyworm.io.quantity_text import duration
from pyworm.io.shown import Shown
from pyworm.io.stage import stage
from pyworm.planning.plan import Plan
from pyworm.ratings.motion import rate_motion
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.summary import scene_summary
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.neglected_effects import NeglectedEffects, expected


@dataclass(frozen=True, repr=False)
class PlannedContact(Shown):
    """A contact of a case, with its plan."""

    scene: Scene | LineScene
    """The contact."""
    plan: Plan
    """Effects, grids and tolerance."""
    neglected_effects: NeglectedEffects
    """Expected influence of the effects that are neglected, by closed forms."""
    expected: Expectation
    """Expected cost of its solve."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the contact in words."""
        plan = self.plan.shown()[1]
        return f"PlannedContact {self.scene.name}", {
            "regime": plan["regime"],
            "simulated": plan["simulated"],
            "expected time": duration(self.expected.seconds),
        }

    def summary(self) -> dict[str, Any]:
        """The contact and its plan as one object, units in the keys."""
        return (
            scene_summary(self.scene)
            | self.neglected_effects.summary()
            | {
                "plan": asdict(self.plan),
                "effects": [asdict(effect) for effect in self.plan.effects],
                "expected_seconds": self.expected.seconds,
                "expected_convolutions": self.expected.convolutions,
            }
        )


@dataclass(frozen=True, repr=False)
class CheckedCase(Shown):
    """What is known of a case before it is solved."""

    case: Case
    """The case."""
    contacts: tuple[PlannedContact, ...]
    """Its contacts, in the order of the mesh cycle."""
    expected_seconds: float
    """Expected CPU time of a run [s]."""
    search_seconds: float
    """Expected CPU time of the search for loads and temperatures before it [s]."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the case in words."""
        return f"Check of {self.case.name}", {
            "contacts": f"{len(self.contacts)}",
            "expected time": duration(self.expected_seconds + self.search_seconds),
            "warnings": f"{len(self.warnings)}",
        }

    @property
    def geometry(self) -> dict[str, float | str]:
        """Computed drawing and kinematics of a gear set, units in the keys; empty without gears."""
        return {} if self.case.drive is None else self.case.drive.geometry_table()

    @property
    def forces(self) -> tuple[MeshForces, ...]:
        """Mean forces of the mesh with either shaft driving, by the friction of its balance of torques."""
        drive = self.case.drive
        if drive is None:
            return ()
        found = (drive.mesh_forces(driver=driver) for driver in drive.possible_drivers)
        return tuple(forces for forces in found if forces is not None)

    @property
    def motion(self) -> dict[str, Any]:
        """Motion of parts that no shaft drives, as a rating has it; empty without such parts."""
        found = None if self.case.drive is None else self.case.drive.motion_figures()
        return {} if found is None else rate_motion(found).summary()

    @property
    def assumptions(self) -> tuple[str, ...]:
        """Assumptions of loads and geometry of a gear set, a sentence each."""
        return () if self.case.drive is None else self.case.drive.all_assumptions

    @property
    def warnings(self) -> tuple[str, ...]:
        """Unusual values, a sentence each that begins with the key."""
        return self.case.warnings

    @property
    def beyond_limits(self) -> tuple[str, ...]:
        """Bodies that are hotter than their material bears, a sentence each."""
        return self.case.beyond_limits

    def summary(self) -> dict[str, Any]:
        """All of it as one object, as `pyworm check --json` prints it."""
        gears = {
            "drive": self.geometry,
            "forces": [forces.summary() for forces in self.forces],
            "assumptions": self.assumptions,
            **({"motion": self.motion} if self.motion else {}),
        }
        return {
            "case": self.case.name,
            "resolved": self.case.resolved,
            "scenes": [contact.summary() for contact in self.contacts],
            **({} if self.case.drive is None else gears),
            "expected_seconds": self.expected_seconds,
            "expected_seconds_of_search": self.search_seconds,
            "warnings": self.warnings,
            "beyond_limits": self.beyond_limits,
        }


@takes_request
def check(case: CaseLike, **request: Unpack[Request]) -> CheckedCase:
    """Check a case and plan its contacts, as the command `pyworm check`; nothing is solved.

    Args:
        case, accuracy, effects, quantities: As of `pyworm.run`.
        phases, sections, stations, slide_roll_ratios: Likewise.
        **request: These.

    Raises:
        CaseError: Invalid input, or a contact that cannot be planned.
    """
    case = as_case(case)
    return checked_case(case, requested(case, request))


def checked_case(case: Case, tasks: Sequence[Task]) -> CheckedCase:
    """What is known of a case with planned tasks."""
    with stage("estimating times and the influence of neglected effects"):
        cost = expected_run(case, tasks)
        contacts = tuple(
            PlannedContact(task.scene, task.plan, expected(task.scene, task.plan), each)
            for task, each in zip(tasks, cost.each, strict=True)
        )
    return CheckedCase(case, contacts, cost.seconds, cost.search)
