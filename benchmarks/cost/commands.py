"""Processor time of whole commands, and that of another installation of pyworm in the same run.

From the repository's root, with the Python of the installation to compare with (none: this one alone):

    python benchmarks/cost/commands.py [PYTHON [NAME ...]]

Each command is run by both in turn, `REPEATS` times the short one; the least time counts. Only times of one
run may be compared.
"""

import sys
from dataclasses import dataclass
from math import inf
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from subprocess import DEVNULL, run
from tempfile import TemporaryDirectory

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

REPEATS = 3


@dataclass(frozen=True)
class Command:
    """Arguments of `pyworm`, and how often it is run."""

    arguments: str
    repeats: int = 1


COMMANDS = {
    "point": Command("run cases/point_m20_l10.toml --accuracy 1%", REPEATS),
    "roller": Command("run cases/roller_ref.toml", 1),
    "contact": Command("run cases/zi_sharif_2001.toml --phase 0.5 --accuracy 1%"),
    "traction": Command("run cases/traction_steel.toml"),
    "drive": Command("run cases/zi_drive.toml --accuracy 2% --effects auto,-squeeze"),
}


def processor_time(python: str, command: Command) -> float:
    """Seconds of processor of one run by an interpreter, its workers included."""
    before = getrusage(RUSAGE_CHILDREN)
    with TemporaryDirectory() as directory:
        run(
            [python, "-P", "-m", "pyworm.cli", *command.arguments.split(), "--out", directory],
            stdout=DEVNULL,
            stderr=DEVNULL,
            check=False,
        )
    after = getrusage(RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    other, *names = sys.argv[1:] or (sys.executable,)
    pythons = dict.fromkeys((other, sys.executable))
    print(f"{'':10}" + "".join(f"{word:>10}" for word in ("before", "now", "ratio")))
    rows = []
    for name in names or COMMANDS:
        command = COMMANDS[name]
        least = dict.fromkeys(pythons, inf)
        for _ in range(command.repeats):
            for python in pythons:
                least[python] = min(least[python], processor_time(python, command))
        before, now = least[other], least[sys.executable]
        print(f"{name:10}{before:10.1f}{now:10.1f}{now / before:10.2f}", flush=True)
        rows.append((f"pyworm {command.arguments}", f"{now:.1f}"))
    record("whole_commands", ("command", "CPU time / s"), rows, key=("command",))


if __name__ == "__main__":
    main()
