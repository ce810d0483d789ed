"""The command line: what goes in, what is shown, and how it ends.

Exit codes: 0 every result converged; 1 something outside the input failed (no compiled kernel, a full disk);
2 bad input, one sentence on standard error, nothing written; 3 a result did not converge (written, and
marked); 130 and 143 stopped by Ctrl-C and by SIGTERM.
"""

import argparse
import math
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from pyworm.case import Case, load
from pyworm.case_error import CaseError
from pyworm.json_output import as_json, print_json
from pyworm.output import check_writable, whole
from pyworm.place import PLACE_NAMES
from pyworm.ratings.commands import add_oil, add_rate
from pyworm.report.command import add_report
from pyworm.result_case import add_case, case_for
from pyworm.stopping import exit_code
from pyworm.terminal import flush, prepare, put, say
from pyworm.units import SHARE, parse
from pyworm.workers import WorkerDiedError

if TYPE_CHECKING:
    from pyworm.result import Result

CONVERGED = 0
FAILED = 1
BAD_INPUT = 2
NOT_CONVERGED = 3

SWEEP_NAME, TABLE_NAME, SWEEP_PICTURE = "sweep.nc", "sweep.csv", "sweep.png"
BUDGET = 300.0
"""Time that a study of precision may take unless another is given [s]."""

PICTURES = ("scene_*.png", "mesh_cycle*.png", "traction.png")


class _Parser(argparse.ArgumentParser):
    """A parser whose complaints are one sentence, like those about a case."""

    def error(self, message: str) -> NoReturn:
        say(message)
        self.exit(BAD_INPUT)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str, optional
        In place of those of the process.

    Returns
    -------
    int
        The exit code.
    """
    prepare()
    try:
        options = _parser().parse_args(arguments)
    finally:
        flush()  # of --help
    try:
        code = options.command(options)
        flush()
        return code
    except CaseError as error:
        return _end(f"{error}", BAD_INPUT)
    except ImportError as error:
        return _end(f"{error}; pyworm doctor tells what is missing", FAILED)
    except (OSError, WorkerDiedError) as error:
        return _end(f"{error}", FAILED)
    except KeyboardInterrupt as stop:
        return _end(_stopped(options), exit_code(stop))


def _stopped(options: argparse.Namespace) -> str:
    if "jobs" in options:
        return "stopped; scenes already solved are kept, the same command goes on from there"
    return "stopped, nothing written"


def _end(message: str, code: int) -> int:
    say(message)
    return code


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="pyworm", description="What does the oil do between these teeth?")
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    how = argparse.ArgumentParser(add_help=False)
    how.add_argument("--accuracy", help='relative error wanted, such as "1%%"; else the case\'s')
    how.add_argument(
        "--effects",
        help="auto, auto,squeeze, all, isothermal, or names of effects with commas between; else the case's",
    )
    case = argparse.ArgumentParser(add_help=False)
    case.add_argument("case", type=Path, metavar="CASE.toml")
    case.add_argument(
        "--quantities",
        help="film, friction, temperature, with commas; else the case's, or all that can be told",
    )
    case.add_argument(
        "--section", nargs="+", help="sections of a roller worm to solve; else the case's"
    )
    case.add_argument(
        "--station",
        type=float,
        nargs="+",
        help="places along contact lines, 0 to 1, to solve; else the case's",
    )
    case.add_argument(
        "--phase", type=float, nargs="+", help="mesh phases 0 to 1 to solve; else the case's"
    )
    case.add_argument(
        "--slide-roll-ratio",
        type=float,
        nargs="+",
        help="places on a traction curve to solve; else the case's",
    )
    case.add_argument("--json", action="store_true", help="one JSON object on standard output")

    run = commands.add_parser(
        "run", parents=[case, how], help="solve a case; table, file and pictures"
    )
    run.add_argument("--out", type=Path, help="directory (default: results/ and the case's name)")
    run.set_defaults(command=_run)

    check = commands.add_parser("check", parents=[case, how], help="check a case and show the plan")
    check.set_defaults(command=_check)

    precision = commands.add_parser(
        "precision", parents=[case], help="what accuracy costs in time, of one contact of a case"
    )
    precision.add_argument(
        "--budget",
        type=_seconds,
        default=BUDGET,
        metavar="SECONDS",
        help="time to spend (default: %(default)g)",
    )
    precision.add_argument("--out", type=Path, help="directory (default: results/ and its name)")
    precision.set_defaults(command=_precision, accuracy=None, effects=None)

    sweep = commands.add_parser(
        "sweep", help="solve a case over ranges of its values; table, file and picture"
    )
    sweep.add_argument("sweep", type=Path, metavar="SWEEP.toml")
    sweep.add_argument("--out", type=Path, help="directory (default: results/ and its name)")
    sweep.add_argument("--fields", action="store_true", help="keep every scene's result in full")
    sweep.add_argument(
        "--share", type=_share, metavar="I/N", help="keep the I-th of N shares; no table yet"
    )
    sweep.add_argument("--json", action="store_true", help="one JSON object on standard output")
    sweep.set_defaults(command=_sweep)

    for batch in (run, sweep):
        who = batch.add_mutually_exclusive_group()
        who.add_argument(
            "-j", dest="jobs", type=_count, default=1, metavar="N", help="processes (default: 1)"
        )
        who.add_argument(
            "--scheduler", metavar="ADDRESS", help="solve on the workers of dask.distributed there"
        )

    plot = commands.add_parser("plot", help="draw the pictures of a results file again")
    plot.add_argument("result", type=Path, metavar="RESULT")
    plot.add_argument("--out", type=Path, help="directory (default: that of the results file)")
    add_case(plot)
    plot.set_defaults(command=_plot)

    add_report(commands)
    add_rate(commands)
    add_oil(commands)

    doctor = commands.add_parser("doctor", help="check the installation")
    doctor.set_defaults(command=_doctor)
    return parser


class _Version(argparse.Action):
    """Print the version; looked up only when asked for."""

    def __init__(self, option_strings, dest):
        super().__init__(option_strings, dest, nargs=0, help="print the version")

    def __call__(self, parser, namespace, values, option_string=None):
        import pyworm

        put(f"pyworm {pyworm.__version__}")
        parser.exit()


def _run(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name
    check_writable(directory)
    tasks = _tasks(case, options)
    _warn(case)

    from pyworm.balance import run_balanced
    from pyworm.console import progress_bar
    from pyworm.drive_cycle import drive_cycle
    from pyworm.heating import heating_of
    from pyworm.plots import draw
    from pyworm.ratings.standard_loss import standard_loss
    from pyworm.run import RESULT_NAME, NothingSolvedError

    with _executor(options) as executor:
        try:
            with progress_bar() as progress:
                result, tasks = run_balanced(case, tasks, directory, executor, progress, say)
        except NothingSolvedError as error:
            return _end(f"{case.name}: {error}", FAILED)
        for warning in result.provenance["warnings"][len(case.warnings) :]:
            say(f"warning: {warning}")
        if not options.json:
            _show_run(case, tasks, result)
            put(f"Results   {directory / RESULT_NAME}")
        # After the figures, which no picture may cost; and by this machine, since others need not reach
        # this place.
        drawing = partial(draw, result, executor=None if options.scheduler else executor)
        pictures, _ = _pictures(directory, drawing, PICTURES)
    if options.json:
        cycle, standard = drive_cycle(result), standard_loss(case)
        heating = heating_of(tasks[0].case, cycle, standard)
        print_json(
            {
                "case": case.name,
                "scenes": [solution.summary() for solution in result.solutions],
                "failed": result.provenance["failed"],
                "warnings": result.provenance["warnings"],
                **({} if cycle is None else {"cycle": cycle.summary()}),
                **({} if case.drive is None else {"standard_loss": standard.summary()}),
                **({} if heating is None else {"heating_loss": heating.summary()}),
                "results": str(directory / RESULT_NAME),
                "pictures": [str(directory / name) for name in pictures],
            }
        )
    else:
        put(f"Pictures  {directory}/*.png ({len(pictures)})")
    return CONVERGED if result.converged and not result.provenance["failed"] else NOT_CONVERGED


def _show_run(case: Case, tasks: Sequence, result: "Result") -> None:
    """The tables of a run."""
    from pyworm.console import Console
    from pyworm.cycle_tables import CYCLE_TABLES, cycle_table, loss_table
    from pyworm.drive_cycle import drive_cycle
    from pyworm.heating import heating_of
    from pyworm.left_out import opening
    from pyworm.ratings.standard_loss import standard_loss
    from pyworm.tables import effects_table, figures_table, heat_table, published_for, scenes_table

    summaries = [solution.summary() for solution in result.solutions]
    failed = result.provenance["failed"]
    cycle, standard = drive_cycle(result), standard_loss(case)
    console = Console()
    console.print(f"{case.title}\n{case.source}\n")
    for line in opening(result.solutions, standard.words):
        console.print(f"{line}\n")
    scenes = [task.scene for task in tasks if task.scene.name not in failed]
    for scene, summary, solution in zip(scenes, summaries, result.solutions, strict=True):
        published = published_for(summary, case.published)
        if published or len(scenes) == 1:
            console.print(figures_table(scene, summary, published))
            console.print(effects_table(solution.effects, "Effects, judged by the solution"))
    if len(scenes) > 1:
        console.print(scenes_table(scenes, summaries))
        if all("friction_coefficient" in summary for summary in summaries):
            console.print(heat_table(scenes, summaries))
    if result.mesh_cycle is not None and result.mesh_cycle.attrs["drive"] in CYCLE_TABLES:
        console.print(CYCLE_TABLES[result.mesh_cycle.attrs["drive"]](result.mesh_cycle))
    if cycle is not None:
        console.print(cycle_table(cycle))
        if cycle.loss is not None:
            heating = heating_of(tasks[0].case, cycle, standard)
            console.print(loss_table(cycle, standard, heating))
    for summary in summaries:
        if not summary["converged"]:
            console.print(f"{summary['name']} did not converge: {summary['stop_reason']}")
    for name, reason in failed.items():
        console.print(f"{name} could not be solved: {reason}")


def _pictures(
    directory: Path, draw: Callable[[Path], list[Path]], instead_of: Sequence[str] = ()
) -> tuple[list[str], bool]:
    """Have pictures drawn into a directory; one that fails is told and costs nothing else.

    Returns
    -------
    tuple of list of str and bool
        Names of those drawn, and whether these are all.
    """
    from pyworm.plots.attempts import PicturesError

    complete = True
    try:
        with whole(directory, instead_of) as aside:
            try:
                drawn = draw(aside)
            except PicturesError as error:
                say(f"{error}")
                drawn, complete = error.drawn, False
    except OSError as error:
        say(f"no pictures: {error}")
        return [], False
    return [path.name for path in drawn], complete


def _check(options: argparse.Namespace) -> int:
    case = load(options.case)
    tasks = _tasks(case, options)
    _warn(case)

    from pyworm import left_out
    from pyworm.console import Console
    from pyworm.expectation import duration, expectation
    from pyworm.scene_summary import scene_summary
    from pyworm.tables import effects_table, plan_table

    expected = [expectation(task.scene, task.plan) for task in tasks]
    without = [left_out.expected(task.scene, task.plan) for task in tasks]
    if options.json:
        scenes = [
            scene_summary(task.scene)
            | lacking.summary()
            | {
                "plan": asdict(task.plan),
                "effects": [asdict(effect) for effect in task.plan.effects],
                "expected_seconds": of.seconds,
                "expected_convolutions": of.convolutions,
            }
            for task, lacking, of in zip(tasks, without, expected, strict=True)
        ]
        content = {"case": case.name, "resolved": case.resolved, "scenes": scenes}
        print_json(content | {"warnings": case.warnings})
    else:
        console = Console()
        console.print(f"{case.title}\n{case.source}\n")
        if sentence := left_out.worst(without).sentence:
            console.print(f"{sentence} (Films by closed forms.)\n")
        for task, of in zip(tasks, expected, strict=True):
            console.print(plan_table(task.scene, task.plan, of))
            console.print(effects_table(task.plan.effects, "Effects"))
        if len(tasks) > 1:
            seconds = sum(of.seconds for of in expected)
            console.print(f"Expected time of all {len(tasks)}: {duration(seconds)}")
    return CONVERGED


def _precision(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "precision"
    check_writable(directory)
    tasks = _tasks(case, options)
    task = tasks[len(tasks) // 2]  # of a mesh cycle the middle

    from pyworm.console import Console, progress_bar
    from pyworm.expectation import duration
    from pyworm.kernels import KernelError
    from pyworm.plots.precision import draw_precision
    from pyworm.plots.style import write
    from pyworm.precision.report import as_object, cheapest_table, write_csv
    from pyworm.precision.survey import BudgetError, NoReferenceError, expected_seconds, study

    name = ", ".join(part for part in (case.name, str(task.place)) if part)
    expected = expected_seconds(task.scene, task.quantities)
    say(
        f"{name}: some {duration(min(expected, options.budget))}, "
        f"of {duration(expected)} without a budget"
    )
    try:
        with progress_bar() as progress:
            made = study(task.scene, task.quantities, options.budget, progress)
    except BudgetError as error:
        raise CaseError(f"--budget {options.budget:g}: {error}") from None
    except KernelError as error:
        return _end(f"{name}: {error}", FAILED)
    except NoReferenceError as error:
        return _end(f"{name}: {error}", NOT_CONVERGED)
    content = {"case": case.name} | as_object(made)
    with whole(directory, instead_of=("precision.*",)) as aside:
        (aside / "precision.json").write_text(as_json(content))
        write_csv(made, aside / "precision.csv")
        figure = draw_precision(made, name)
        for ending in ("png", "svg"):
            write(figure, aside / f"precision.{ending}")
    if options.json:
        print_json(content)
    else:
        console = Console()
        console.print(cheapest_table(made))
        for line in made.left_out:
            console.print(f"left out: {line}")
        console.print(f"Results  {directory}/precision.*", soft_wrap=True)
    return CONVERGED


def _sweep(options: argparse.Namespace) -> int:
    from pyworm.console import progress_bar
    from pyworm.sweep import load_sweep

    directory = options.out or Path("results") / options.sweep.stem
    check_writable(directory)
    with progress_bar() as progress, _executor(options) as executor:
        share = options.share or (1, 1)
        sweep = load_sweep(options.sweep, share, executor, progress)

        from pyworm.sweep_run import run_sweep, solve_share

        how = (directory, options.fields, executor, progress, say)
        if options.share is not None:
            reasons, _ = solve_share(sweep.tasks, *how)
            for reason in reasons.values():
                say(f"a scene could not be solved: {reason}")
            return NOT_CONVERGED if reasons else CONVERGED
        result = run_sweep(sweep, *how)

    from pyworm.plots.sweep import draw_sweep
    from pyworm.sweep_report import rows, show

    with whole(directory) as aside:
        result.save(aside / SWEEP_NAME)
        result.save_csv(aside / TABLE_NAME)
    if not options.json:
        show(result, directory)
    pictures, _ = _pictures(directory, lambda aside: draw_sweep(result, aside / SWEEP_PICTURE))
    if options.json:
        print_json(
            {
                "sweep": result.name,
                "scenes": rows(result),
                "results": str(directory / SWEEP_NAME),
                "table": str(directory / TABLE_NAME),
                "pictures": [str(directory / name) for name in pictures],
            }
        )
    else:
        for name in pictures:
            put(f"Picture   {directory / name}")
    return CONVERGED if result.converged.all() else NOT_CONVERGED


def _plot(options: argparse.Namespace) -> int:
    from pyworm.plots import draw
    from pyworm.plots.sweep import draw_sweep
    from pyworm.result import open_result
    from pyworm.sweep_table import open_sweep

    directory = options.out or options.result.parent
    check_writable(directory)
    try:
        sweep = open_sweep(options.result)
        result = None if sweep else open_result(options.result)
    except (FileNotFoundError, ValueError) as error:
        raise CaseError(str(error)) from error
    if options.case is not None:
        if result is None:
            raise CaseError(
                f"--case {options.case}: {options.result} is a sweep, which has a case for each"
            )
        _, differ = case_for(options.case, result, options.anyway)
        if differ is not None:
            say(f"warning: {differ}")
    if sweep is not None:
        draw_all, old = (lambda aside: draw_sweep(sweep, aside / SWEEP_PICTURE)), ()
    else:
        draw_all, old = partial(draw, result), PICTURES
    pictures, complete = _pictures(directory, draw_all, old)
    for name in pictures:
        put(f"{directory / name}")
    return CONVERGED if complete else FAILED


def _doctor(options: argparse.Namespace) -> int:
    from pyworm.doctor import examine

    return examine()


def _warn(case: Case) -> None:
    """Say what is unusual in a case."""
    for warning in case.warnings:
        say(f"warning: {warning}")


def _tasks(case: Case, options: argparse.Namespace) -> list:
    """What is to be solved of a case, all of it planned before the first is solved."""
    accuracy = case.accuracy
    if options.accuracy is not None:
        try:
            accuracy = parse(options.accuracy, SHARE)
        except ValueError as error:
            raise CaseError(f"--accuracy {options.accuracy}: {error}") from None

    from pyworm.task import Task

    effects = options.effects or case.effects
    words = options.quantities
    quantities = case.quantities if words is None else tuple(words.split(","))
    places = case.places(**{name: getattr(options, name) for name in PLACE_NAMES})
    tasks = [Task(case, place, accuracy, effects, quantities) for place in places]
    try:
        for task in tasks:
            _ = task.plan
    except ValueError as error:
        raise CaseError(str(error)) from error
    return tasks


def _executor(options: argparse.Namespace) -> AbstractContextManager:
    """What the batch is solved by, to be entered; None where this process does it all."""
    if options.scheduler is not None:
        from pyworm.cluster import cluster

        return cluster(options.scheduler, say)
    if options.jobs == 1:
        return nullcontext()
    from pyworm.workers import WorkerPool

    return WorkerPool(options.jobs)


def _count(text: str) -> int:
    """A number of processes."""
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text}: must be a whole number from 1 on")
    return int(text)


def _seconds(text: str) -> float:
    """A time."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not seconds > 0:
        raise argparse.ArgumentTypeError(f"{text}: must be a number of seconds above 0")
    return seconds


def _share(text: str) -> tuple[int, int]:
    """Which of how many shares of a sweep."""
    first, _, count = text.partition("/")
    if not (first.isdecimal() and count.isdecimal() and 1 <= int(first) <= int(count)):
        raise argparse.ArgumentTypeError(f"{text}: must be a share such as 1/40, 2/40 to 40/40")
    return int(first), int(count)
