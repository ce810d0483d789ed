"""Solve a case from Python, as `pyworm run` solves it."""

from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal, Unpack
from warnings import warn

from pyworm.batch.drive_iteration import run_balanced
from pyworm.batch.in_python import CaseLike, as_case, executor, messages, progress_of
from pyworm.batch.request import Request, requested, takes_request
from pyworm.batch.uncertain_run import require_uncertain, with_input_uncertainty
from pyworm.formulas.ranges import one_of
from pyworm.io.progress import Progress
from pyworm.result.result import Result
from pyworm.scene.plausibility import UnusualWarning


@takes_request
def run(
    case: CaseLike,
    *,
    out: str | Path | None = None,
    fields: Literal["rounded", "full"] = "rounded",
    inputs_uncertain: bool = False,
    processes: int = 1,
    scheduler: str | None = None,
    progress: bool | Progress = True,
    **request: Unpack[Request],
) -> Result:
    """Solve a case: load sharing with film-induced separation, films, friction, thermal balance.

    The results are those of the command `pyworm run`.

    Args:
        case: A gear set (`WormDrive`, `GearPair`, `RollerWorm`), what `pyworm.load` made, or a case file.
        out: Directory of the result file, in which solved contacts are found again; by default none is kept.
        fields: "rounded" to a tenth of their numerical uncertainty, or "full", all digits.
        inputs_uncertain: Whether inputs such as "0.4 um +- 0.1 um" give `Result.input_uncertainty`.
        processes: Processes that solve; more than one need a script with `if __name__ == "__main__":`.
        scheduler: Address of a dask.distributed scheduler whose workers solve instead.
        progress: Whether a bar shows the progress, or what is called instead.
        accuracy, effects, quantities: As of `pyworm.plan`; by default the case's.
        phases, sections, stations, slide_roll_ratios: Which contacts; by default the case's.
        **request: These.

    Returns:
        The solutions in order, `cycle` with the extremes of the mesh cycle, `mesh_loss` with loss and
        efficiency. A contact that cannot be solved is among `without_solution`, with the reason.

    Raises:
        CaseError: Invalid input, or a contact that cannot be planned.
        NothingSolvedError, NotSolvedError: No contact has a solution, or one with a moved input has none.
    """
    one_of("fields", fields, ("rounded", "full"))
    case = as_case(case)
    if inputs_uncertain:
        require_uncertain(case)
    tasks = requested(case, request)
    refused = {task.plan.refusal: task.scene.name for task in tasks}
    refused.pop(None, None)
    for reason, name in refused.items():
        sentence = f"{name}: will not reach the requested accuracy: {reason}"
        warn(sentence, UnusualWarning, stacklevel=2)
    with ExitStack() as stack:
        kept = stack.enter_context(TemporaryDirectory()) if out is None else out
        workers = stack.enter_context(executor(processes, scheduler))
        bar = stack.enter_context(progress_of(progress))
        how = workers, bar, messages(progress), fields == "full"
        result, solved = run_balanced(case, tasks, Path(kept), *how)
        if inputs_uncertain:
            result = with_input_uncertainty(result, solved, Path(kept), workers, bar)
    return result
