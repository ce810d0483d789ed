"""The command line: arguments, messages, exit codes.

Exit codes: 0 every result converged; 1 something outside the input failed (no compiled kernel, a full disk);
2 bad input, one sentence on standard error, nothing written; 3 a result did not converge (written, and
marked); 130 and 143 stopped by Ctrl-C and by SIGTERM.
"""

import argparse
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from typing import Any, NoReturn

from pyworm.batch.cluster import RESUME_HINT
from pyworm.batch.workers import WorkerDiedError
from pyworm.cli.examples import EXAMPLES, add_examples
from pyworm.cli.shared import BAD_INPUT, FAILED, end_with
from pyworm.cli.stopping import exit_code
from pyworm.io.input_error import CaseError
from pyworm.io.stage import long_stages_said
from pyworm.io.terminal import flush, prepare, print_message, print_result, silence


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one sentence, as for cases."""

    def error(self, message: str) -> NoReturn:
        print_message(message)
        self.exit(BAD_INPUT)

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print a help text, longer maybe than a stream's buffer; who does not listen is no error."""
        stream = file or sys.stderr
        try:
            stream.write(message)
        except BrokenPipeError:
            silence(stream)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, by default with the arguments of the process; returns the exit code."""
    prepare()
    try:
        options = _parser().parse_args(arguments)
    finally:
        flush()  # of --help
    try:
        with long_stages_said():
            code: int = options.command(options)
        flush()
        return code
    except CaseError as error:
        return end_with(f"{error}", BAD_INPUT)
    except ImportError as error:
        return end_with(f"{error}; pyworm doctor shows what is missing", FAILED)
    except (OSError, WorkerDiedError) as error:
        with suppress(OSError):
            flush()  # what cannot be written is not tried again by the interpreter
        return end_with(f"{error}", FAILED)
    except KeyboardInterrupt as stop:
        return end_with(_stopped(options), exit_code(stop))


def _stopped(options: argparse.Namespace) -> str:
    if "jobs" in options:
        return f"stopped; {RESUME_HINT}"
    return "stopped, nothing written"


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="pyworm", description="Elastohydrodynamic lubrication of gear contacts")
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for name in EXAMPLES:
        if " " not in name:  # the others are commands below one
            import_module(f"pyworm.cli.{name}").add(commands)
    add_examples(parser)
    return parser


class _Version(argparse.Action):
    """Print the version; looked up only when asked for."""

    def __init__(self, option_strings: Sequence[str], dest: str) -> None:
        super().__init__(option_strings, dest, nargs=0, help="print the version")

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: object,
        option_string: str | None = None,
    ) -> None:
        import pyworm

        print_result(f"pyworm {pyworm.__version__}")
        parser.exit()
