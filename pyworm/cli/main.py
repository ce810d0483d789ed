"""The command line: arguments, messages, exit codes.

Exit codes: 0 every result converged; 1 something outside the input failed (no compiled kernel, a full disk);
2 bad input, one sentence on standard error, nothing written; 3 a result did not converge (written, and
marked); 130 and 143 stopped by Ctrl-C and by SIGTERM.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from pyworm.batch.workers import WorkerDiedError
from pyworm.cli.oil import add_oil
from pyworm.cli.rate import add_rate
from pyworm.cli.report import add_report
from pyworm.cli.stopping import exit_code
from pyworm.io.input_error import CaseError
from pyworm.io.terminal import flush, prepare, put, say
from pyworm.result.result_case import add_case

if TYPE_CHECKING:
    pass
from pyworm.cli.check import check_case
from pyworm.cli.plot import plot_result
from pyworm.cli.precision import BUDGET, study_precision
from pyworm.cli.run import run_case
from pyworm.cli.shared import BAD_INPUT, FAILED, end_with, process_count, sweep_part, time_limit
from pyworm.cli.sweep import sweep_case


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one sentence, as for cases."""

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
        return end_with(f"{error}", BAD_INPUT)
    except ImportError as error:
        return end_with(f"{error}; pyworm doctor shows what is missing", FAILED)
    except (OSError, WorkerDiedError) as error:
        return end_with(f"{error}", FAILED)
    except KeyboardInterrupt as stop:
        return end_with(_stopped(options), exit_code(stop))


def _stopped(options: argparse.Namespace) -> str:
    if "jobs" in options:
        return "stopped; scenes already solved are kept, the same command continues from there"
    return "stopped, nothing written"


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
        help="film, friction, temperature, with commas; else the case's, or all that the oil's data allow",
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
    run.set_defaults(command=run_case)

    check = commands.add_parser("check", parents=[case, how], help="check a case and show the plan")
    check.set_defaults(command=check_case)

    precision = commands.add_parser(
        "precision", parents=[case], help="error against time for one contact of a case"
    )
    precision.add_argument(
        "--budget",
        type=time_limit,
        default=BUDGET,
        metavar="SECONDS",
        help="time to spend (default: %(default)g)",
    )
    precision.add_argument("--out", type=Path, help="directory (default: results/ and its name)")
    precision.set_defaults(command=study_precision, accuracy=None, effects=None)

    sweep = commands.add_parser(
        "sweep", help="solve a case over ranges of its values; table, file and picture"
    )
    sweep.add_argument("sweep", type=Path, metavar="SWEEP.toml")
    sweep.add_argument("--out", type=Path, help="directory (default: results/ and its name)")
    sweep.add_argument("--fields", action="store_true", help="store the fields of every scene")
    sweep.add_argument(
        "--share",
        type=sweep_part,
        metavar="I/N",
        help="solve only the I-th of N shares; writes no table",
    )
    sweep.add_argument("--json", action="store_true", help="one JSON object on standard output")
    sweep.set_defaults(command=sweep_case)

    for batch in (run, sweep):
        who = batch.add_mutually_exclusive_group()
        who.add_argument(
            "-j",
            dest="jobs",
            type=process_count,
            default=1,
            metavar="N",
            help="processes (default: 1)",
        )
        who.add_argument(
            "--scheduler",
            metavar="ADDRESS",
            help="solve on the workers of this dask.distributed scheduler",
        )

    plot = commands.add_parser("plot", help="draw the pictures of a results file again")
    plot.add_argument("result", type=Path, metavar="RESULT")
    plot.add_argument("--out", type=Path, help="directory (default: that of the results file)")
    add_case(plot)
    plot.set_defaults(command=plot_result)

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


def _doctor(options: argparse.Namespace) -> int:
    from pyworm.cli.doctor import examine

    return examine()
