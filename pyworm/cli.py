"""The command line: what goes in, what is shown, and how it ends.

Exit codes: 0 every result converged; 1 something outside the input failed (no compiled kernel, a full disk);
2 bad input, one sentence on standard error, nothing written; 3 a result did not converge (written, and
marked).
"""

import argparse
import json
import math
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any, NoReturn

from pyworm.case import Case, load
from pyworm.case_error import CaseError
from pyworm.output import check_writable, whole
from pyworm.place import PLACE_NAMES
from pyworm.units import SHARE, parse

CONVERGED = 0
FAILED = 1
BAD_INPUT = 2
NOT_CONVERGED = 3

RESULT_NAME = "result.nc"
PICTURES = ("scene_*.png", "mesh_cycle*.png", "traction.png")


class _Parser(argparse.ArgumentParser):
    """A parser whose complaints are one sentence, like those about a case."""

    def error(self, message: str) -> NoReturn:
        self.exit(BAD_INPUT, f"pyworm: {message}\n")


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
    options = _parser().parse_args(arguments)
    try:
        return options.command(options)
    except CaseError as error:
        return _end(f"{error}", BAD_INPUT)
    except ImportError as error:
        return _end(f"{error}; pyworm doctor tells what is missing", FAILED)
    except OSError as error:
        return _end(f"{error}", FAILED)
    except KeyboardInterrupt:
        return _end("stopped, nothing written", FAILED)


def _end(message: str, code: int) -> int:
    print(f"pyworm: {message}", file=sys.stderr)
    return code


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="pyworm", description="What does the oil do between these teeth?")
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    case = argparse.ArgumentParser(add_help=False)
    case.add_argument("case", type=Path, metavar="CASE.toml")
    case.add_argument("--accuracy", help='relative error wanted, such as "1%%"; else the case\'s')
    case.add_argument("--effects", help="model (default: the case's, or the most that the oil is known for)")
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

    run = commands.add_parser("run", parents=[case], help="solve a case; table, file and pictures")
    run.add_argument("--out", type=Path, help="directory (default: results/ and the case's name)")
    run.set_defaults(command=_run)

    check = commands.add_parser("check", parents=[case], help="check a case and show the plan")
    check.set_defaults(command=_check)

    plot = commands.add_parser("plot", help="draw the pictures of a results file again")
    plot.add_argument("result", type=Path, metavar="RESULT")
    plot.add_argument("--out", type=Path, help="directory (default: that of the results file)")
    plot.set_defaults(command=_plot)

    doctor = commands.add_parser("doctor", help="check the installation")
    doctor.set_defaults(command=_doctor)
    return parser


class _Version(argparse.Action):
    """Print the version; looked up only when asked for."""

    def __init__(self, option_strings, dest):
        super().__init__(option_strings, dest, nargs=0, help="print the version")

    def __call__(self, parser, namespace, values, option_string=None):
        import pyworm

        print(f"pyworm {pyworm.__version__}")
        parser.exit()


def _run(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name
    check_writable(directory)
    work = _planned(case, options)

    from rich.console import Console

    from pyworm.kernels import KernelError
    from pyworm.plots import draw
    from pyworm.run import run
    from pyworm.tables import figures_table, heat_table, published_for, scenes_table

    try:
        with _progress() as progress:
            result = run(case, work, progress)
    except KernelError as error:
        return _end(f"{case.name}: {error}", FAILED)
    with whole(directory) as aside:
        result.save(aside / RESULT_NAME)
    # Apart, so that a picture that cannot be drawn does not cost the solve.
    with whole(directory, instead_of=PICTURES) as aside:
        pictures = [path.name for path in draw(result, aside)]

    summaries = [solution.summary() for solution in result.solutions]
    failed = result.provenance["failed"]
    if options.json:
        _print_json(
            {
                "case": case.name,
                "scenes": summaries,
                "failed": failed,
                "results": str(directory / RESULT_NAME),
                "pictures": [str(directory / name) for name in pictures],
            }
        )
    else:
        console = Console()
        console.print(f"{case.title}\n{case.source}\n", highlight=False)
        scenes = [scene for scene, _ in work if scene.name not in failed]
        for scene, summary in zip(scenes, summaries, strict=True):
            published = published_for(summary, case.published)
            if published or len(scenes) == 1:
                console.print(figures_table(scene, summary, published))
        if len(scenes) > 1:
            console.print(scenes_table(scenes, summaries))
            if all("friction_coefficient" in summary for summary in summaries):
                console.print(heat_table(scenes, summaries))
        for summary in summaries:
            if not summary["converged"]:
                console.print(f"{summary['name']} did not converge: {summary['stop_reason']}")
        for name, reason in failed.items():
            console.print(f"{name} could not be solved: {reason}")
        console.print(f"Results   {directory / RESULT_NAME}", highlight=False, soft_wrap=True)
        console.print(
            f"Pictures  {directory}/*.png ({len(pictures)})", highlight=False, soft_wrap=True
        )
    converged = not failed and all(summary["converged"] for summary in summaries)
    return CONVERGED if converged else NOT_CONVERGED


def _check(options: argparse.Namespace) -> int:
    case = load(options.case)
    work = _planned(case, options)

    from rich.console import Console

    from pyworm.scene_summary import scene_summary
    from pyworm.tables import plan_table

    if options.json:
        scenes = [scene_summary(scene) | {"plan": asdict(plan)} for scene, plan in work]
        _print_json({"case": case.name, "resolved": case.resolved, "scenes": scenes})
    else:
        console = Console()
        console.print(f"{case.title}\n{case.source}\n", highlight=False)
        for scene, plan in work:
            console.print(plan_table(scene, plan))
    return CONVERGED


def _plot(options: argparse.Namespace) -> int:
    from pyworm.plots import draw
    from pyworm.result import open_result

    directory = options.out or options.result.parent
    check_writable(directory)
    try:
        result = open_result(options.result)
    except (FileNotFoundError, ValueError) as error:
        raise CaseError(str(error)) from error
    with whole(directory, instead_of=PICTURES) as aside:
        pictures = [path.name for path in draw(result, aside)]
    for name in pictures:
        print(directory / name)
    return CONVERGED


def _doctor(options: argparse.Namespace) -> int:
    from pyworm.doctor import examine

    return examine()


def _planned(case: Case, options: argparse.Namespace) -> list:
    """Scenes and plans of a case, all of them before the first is solved."""
    accuracy = case.accuracy
    if options.accuracy is not None:
        try:
            accuracy = parse(options.accuracy, SHARE)
        except ValueError as error:
            raise CaseError(f"--accuracy {options.accuracy}: {error}") from None

    from pyworm.effects import plan

    scenes = list(case.scenes(**{name: getattr(options, name) for name in PLACE_NAMES}))
    try:
        return [(scene, plan(scene, accuracy, options.effects or case.effects)) for scene in scenes]
    except ValueError as error:
        raise CaseError(str(error)) from error


@contextmanager
def _progress() -> Iterator[Callable[[str, float], None] | None]:
    """Show a progress bar on standard error if that is a terminal; nothing otherwise."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=1.0)
        yield lambda message, share: bar.update(task, description=message, completed=share)


def _print_json(content: dict[str, Any]) -> None:
    print(json.dumps(_finite(content), indent=2, default=_plain))


def _finite(content: Any) -> Any:
    """Replace NaN and infinity, which JSON has no words for, by null."""
    if isinstance(content, dict):
        return {key: _finite(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [_finite(value) for value in content]
    if isinstance(content, float) and not math.isfinite(content):
        return None
    return content


def _plain(value: Any) -> Any:
    """Turn numpy scalars into numbers."""
    return value.item()
