"""Wear of the wheel of a worm gear set over its service life: what is assumed, and what it gives."""

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from math import isfinite
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pyworm.batch.in_python import CaseLike, as_case, executor, messages, progress_of
from pyworm.batch.request import requested
from pyworm.batch.wear_run import STATE, WearFigures, WearPlan, WearRun, worm_duty
from pyworm.case.case import Case
from pyworm.drives.duty import WormDuty
from pyworm.formulas.ranges import scalar
from pyworm.formulas.unknown import Unknown, attempt, known
from pyworm.formulas.wear_law import (
    WEAR_ACCURACY,
    WEAR_COEFFICIENT,
    WEAR_SPREAD,
    WEAR_TOLERANCE,
    WHEEL_HARDNESS,
    WORM_HARDNESS,
    energy_coefficient,
    harder_ratio,
)
from pyworm.io import units
from pyworm.io.given import WithUnit, kind_of, number
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.progress import Progress
from pyworm.io.shown import Shown
from pyworm.ratings.worm_loads import RatedWormGear


@dataclass(frozen=True)
class WearInput:
    """What determines how fast the flanks wear; at most one of the first three is given."""

    coefficient: float | None = None
    """k of Archard's law [m2/N]."""
    energy: float | None = None
    """Friction energy per worn volume [J/m3]."""
    calibrate: bool = False
    """Whether k is fitted to the wear rate of the run-in flank by the standard."""
    worm_ratio: float | None = None
    """k of the worm over that of the wheel [-]; by their hardnesses if not given."""
    prefix: str = ""
    """What stands before these names in messages."""

    def plan(self, case: Case, hours: float, tolerance: float) -> tuple[WearPlan, str, str]:
        """How a case is worn for some hours, and in words where k and that of the worm come from.

        CaseError of what cannot be calibrated, or of a wheel whose k is not known.
        """
        found, by = self._coefficient(case)
        ratio, on_worm = self._worm_ratio(case)
        plan = WearPlan(hours, tolerance=tolerance, worm_ratio=ratio, **found)
        return plan, by, on_worm

    def _coefficient(self, case: Case) -> tuple[dict[str, float], str]:
        if self.energy is not None:
            friction = present(case.drive, "drive").oil.boundary_friction
            by = f"{friction:g}/{self.energy:g} J/m3 by the energy form"
            return {"coefficient": energy_coefficient(self.energy, friction)}, by
        if self.coefficient is not None:
            return {"coefficient": self.coefficient}, "as given"
        if self.calibrate:
            return self._calibrated(case)
        if present(case.drive, "drive").bodies[1].temperature_limit is not None:
            raise CaseError(
                f"{self.prefix}coefficient is missing: none is known of wheels with a temperature limit, "
                "such as plastics"
            )
        return {"coefficient": WEAR_COEFFICIENT}, f"known to a factor of {WEAR_SPREAD:g}"

    def _calibrated(self, case: Case) -> tuple[dict[str, float], str]:
        key = f"{self.prefix}calibrate"
        if getattr(case.tables, "worm_rating", None) is None:
            raise CaseError(f"{key}: needs [worm_rating] with wheel_material and life")
        table, duty = case.tables.rating_as_run(), case.tables.rated_duty(case.drive)
        loads = RatedWormGear(table, duty, case.directory).loads
        if len(loads) != 1:
            raise CaseError(f"{key}: needs [worm_rating] with one life, and it gives a spectrum")
        (load,) = loads
        rate = attempt(lambda: load.rated.wear.depth / known(load.hours))
        if isinstance(rate, Unknown):
            raise CaseError(f"{key}: the standard has no wear of this gear: {rate.why}")
        return {"calibrated_to": rate}, (
            f"by which the run-in flank wears {rate * 1e9:.3g} nm/h in the mean, as by the standard"
        )

    def _worm_ratio(self, case: Case) -> tuple[float, str]:
        if self.worm_ratio is not None:
            words = f"the worm's k is {self.worm_ratio:g} of the wheel's, as given"
            return self.worm_ratio, words
        usual = WORM_HARDNESS, WHEEL_HARDNESS
        bodies = present(case.drive, "drive").bodies
        worm, wheel = (body.hardness or hard for body, hard in zip(bodies, usual, strict=True))
        ratio, linear = (harder_ratio(max(worm, wheel), wheel, power) for power in (2.0, 1.0))
        return ratio, (
            f"the worm's k is {ratio:.2g} of the wheel's, the square of their hardnesses "
            f"{wheel * 1e-9:.3g} and {worm * 1e-9:.3g} GPa (Rabinowicz; {linear:.2g} by hardness alone)"
        )


@dataclass(frozen=True, repr=False)
class CaseWear(Shown):
    """Wear of the flanks of a worm gear set over its service life."""

    name: str
    """Name of the case."""
    run: WearRun
    """The time integration: `steps`, `depths` over `grid`, `worm_depth` over `thread`."""
    limit: float
    """Depth that the standard allows [m]."""
    assumed: str
    """What was assumed, in words."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows in words."""
        last = self.steps[-1]
        return f"Wear of {self.name}", {
            "hours": f"{last.hours:.4g}",
            "maximum depth": f"{last.depth_max_m * 1e6:.3g} µm of {self.limit * 1e6:.3g} µm allowed",
            "hours allowed": f"{self.hours_allowed:.4g}",
        }

    @property
    def steps(self) -> tuple[WearFigures, ...]:
        """Figures at the end of each time step."""
        return tuple(self.run.steps)

    @property
    def within_limit(self) -> bool:
        """Whether the depth stays within the limit for all hours."""
        return self.steps[-1].hours >= self.run.plan.hours * (1 - 1e-9)

    @property
    def hours_allowed(self) -> float:
        """Hours after which the depth reaches the limit, at the last rate [h]."""
        return self.run.hours_allowed

    def summary(self) -> dict[str, Any]:
        """All of it as one object, as `pyworm wear --json` prints it."""
        return {
            "case": self.name,
            "steps": [asdict(step) for step in self.steps],
            "wear_limit_m": self.limit,
            "within_limit": self.within_limit,
            "hours_allowed": self.hours_allowed,
            "coefficient_m2_N": self.run.coefficient,
            "worm_ratio": self.run.plan.worm_ratio,
            "assumed": self.assumed,
            "state": str(self.run.directory / STATE),
        }


def wear(
    case: CaseLike,
    hours: float,
    *,
    coefficient: float | None = None,
    energy: float | None = None,
    calibrate: bool = False,
    worm_ratio: float | None = None,
    tolerance: WithUnit = WEAR_TOLERANCE,
    accuracy: WithUnit = WEAR_ACCURACY,
    phases: Sequence[float] | None = None,
    out: str | Path | None = None,
    processes: int = 1,
    scheduler: str | None = None,
    progress: bool | Progress = True,
) -> CaseWear:
    """Wear of the wheel of a worm gear set over its service life, as the command `pyworm wear`.

    Args:
        case: A worm gear set, its file or its tables; both bodies have a roughness.
        hours: Operating hours to simulate.
        coefficient: k of Archard's law in m2/N; by default that of steel on tin bronze, which is known to a
            factor of 3. At most one of it, `energy` and `calibrate` is given.
        energy: Friction energy per worn volume in J/m3, instead of k.
        calibrate: Whether k is fitted to the wear rate of the run-in flank by the standard.
        worm_ratio: k of the worm over that of the wheel [-]; by default by their hardnesses.
        tolerance: Maximum error of the depth in a step [m], in addition to 2 % of the maximum depth.
        accuracy, phases, out, processes, scheduler, progress: As of `pyworm.run`.

    Raises:
        CaseError: Invalid input, gears that are no worm gear set, or a contact that cannot be planned.
        NothingSolvedError: No contact has a solution.
    """
    checked_case = as_case(case)
    require_worm(checked_case, checked_case.name)
    if sum((coefficient is not None, energy is not None, calibrate)) > 1:
        raise CaseError("give one of coefficient, energy and calibrate")
    sizes = {"hours": hours, "coefficient": coefficient, "energy": energy, "worm_ratio": worm_ratio}
    require_above_zero(sizes)
    given = WearInput(coefficient, energy, calibrate, worm_ratio)
    depth = number("tolerance", tolerance, kind_of(units.Film))
    tasks = requested(checked_case, {"accuracy": accuracy, "phases": phases})
    plan, by, on_worm = given.plan(checked_case, hours, depth)
    with ExitStack() as stack:
        kept = Path(stack.enter_context(TemporaryDirectory()) if out is None else out)
        workers = stack.enter_context(executor(processes, scheduler))
        bar = stack.enter_context(progress_of(progress))
        how = {"executor": workers, "progress": bar}
        try:
            run = WearRun(checked_case, tasks, plan, kept, messages(progress), **how)
            return worn(run, by, on_worm)
        except ValueError as error:
            raise CaseError(f"{checked_case.name}: {error}") from None


def require_above_zero(sizes: dict[str, float | None], prefix: str = "") -> None:
    """Refuse numbers that are not above zero; CaseError with their names."""
    for name, value in sizes.items():
        if value is None:
            continue
        if not (isfinite(value := scalar(f"{prefix}{name}", value)) and value > 0):
            raise CaseError(f"{prefix}{name} = {value:g}: must be above zero")


def require_worm(case: Case, name: object) -> None:
    """Refuse other gears than worm gear sets; CaseError with the name of the case."""
    if case.drive is None or case.drive.rated_as is not WormDuty:
        raise CaseError(f"{name}: wear is simulated of worm drives only")


def worn(run: WearRun, by: str, on_worm: str) -> CaseWear:
    """The wear by a time integration, made or continued; ValueError of what it cannot start from.

    Args:
        by: Where k comes from.
        on_worm: Where k of the worm comes from.
    """
    run.run()
    assumed = (
        f"k = {run.coefficient:.3g} m2/N, {by}; roughness of both falls to {run.plan.run_in:g} of that as "
        f"cut; before the first and after the last phase of the case their contacts go on; {on_worm}"
    )
    return CaseWear(run.case.name, run, worm_duty(run.case).gear.wear_limit, assumed)
