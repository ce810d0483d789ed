"""Gear drives of the suite, run as a user does: by the command line, a process for each command.

A command may succeed, refuse in one sentence, or write a result that is marked as not converged. All else is
a fault: a traceback, a line that is no message of the program, another exit code, no end in sight. What a
command came to is kept in a file for each, so that the suite resumes; it holds for one state of the program.
"""

import json
import os
import re
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from math import ceil
from pathlib import Path
from shutil import rmtree
from time import monotonic
from typing import Any

from case_text import case_text
from draws import Drawn

from pyworm.batch.provenance import program_digest
from pyworm.cli.shared import BAD_INPUT, CONVERGED, FAILED, NOT_CONVERGED
from pyworm.io.atomic import whole_file
from pyworm.io.stage import STILL_WORKING

ACCURACIES = ("5 %", "10 %")
"""Accuracies at which drives are run."""

LONGEST = 3600.0
"""Time after which a command is stopped and is out of time [s]."""

PROGRAM_ERROR = re.compile(
    r"\b(?:Name|UnboundLocal|Type|Attribute|Key|Index|Assertion|Import|Recursion|ZeroDivision|Overflow)Error\b.*"
)
"""What no reason of a contact says: an exception that a batch has caught in place of a traceback."""

PROGRAM = (sys.executable, "-m", "pyworm.cli")


@dataclass(frozen=True)
class Called:
    """What a command came to."""

    command: str
    """Its words, the case file and directories left out."""
    code: int
    """Exit code; negative where a signal ended it."""
    wall: float
    """Time that passed [s]."""
    processor: float
    """Time of its processes [s]."""
    said: str
    """The end of what it said on standard error."""
    flaws: tuple[str, ...] = ()
    """What no command may do."""
    figures: dict[str, Any] = field(default_factory=dict)
    """What its JSON says of interest (`_figures`)."""

    @property
    def outcome(self) -> str:
        """One of "done", "not converged", "refused", "out of time" and "broken"."""
        if self.code == -signal.SIGKILL:
            return "out of time"
        if self.flaws:
            return "broken"
        names = {CONVERGED: "done", BAD_INPUT: "refused"}
        return names.get(self.code, "not converged")


@dataclass(frozen=True)
class DriveTrial:
    """A drive of the suite with the directory of all that is kept of it."""

    name: str
    drawn: Drawn
    directory: Path

    @property
    def out(self) -> Path:
        """Where its commands write."""
        return self.directory / "out"

    @property
    def result(self) -> Path:
        """Result that `run` leaves, and others read."""
        return self.out / "result.nc"

    def known(self, *words: str, limit: float = LONGEST) -> Called | None:
        """What a command came to with the same program, case and bound; None if it was not run."""
        kept = self._kept(words, limit)
        if not kept.is_file():
            return None
        known = json.loads(kept.read_text())
        return Called(**known | {"flaws": tuple(known["flaws"])})

    def called(self, *words: str, limit: float = LONGEST) -> Called:
        """Run a command within a processor time [s].

        Among its words `CASE` stands for the case file and `OUT` for where it may write.
        """
        self.directory.mkdir(parents=True, exist_ok=True)
        case = self.directory / "case.toml"
        case.write_text(case_text(self.drawn.tables))
        done = _called(words, case, self.out, limit)
        with whole_file(self._kept(words, limit)) as partial:
            partial.write_text(json.dumps(asdict(done), indent=1))
        return done

    def _kept(self, words: Sequence[str], limit: float) -> Path:
        text = case_text(self.drawn.tables)
        inputs_of = (program_digest(), text, *words, f"{limit:g} s")
        key = sha256("\n".join(inputs_of).encode()).hexdigest()[:24]
        return self.directory / f"{words[0]}-{key}.json"


def _called(words: Sequence[str], case: Path, out: Path, limit: float) -> Called:
    given = [str(case) if word == "CASE" else word.replace("OUT", str(out)) for word in words]
    told, said = case.parent / "stdout", case.parent / "stderr"
    begun = monotonic()
    with told.open("w") as stdout, said.open("w") as stderr:
        process = subprocess.Popen(
            [*PROGRAM, *given], stdout=stdout, stderr=stderr, start_new_session=True
        )
        resource.prlimit(process.pid, resource.RLIMIT_CPU, 2 * (ceil(limit),))
        code, processor = _waited(process, begun + LONGEST)
    wall = monotonic() - begun
    lines = said.read_text(errors="replace").splitlines(keepends=True)
    error = "".join(line for line in lines if not line.startswith(f"pyworm: {STILL_WORKING} "))
    flaws = list(_flaws(code, error, limit))
    figures = {}
    if not flaws and "--json" in words and code in (CONVERGED, NOT_CONVERGED):
        try:
            figures = _figures(json.loads(told.read_text()))
        except ValueError as wrong:
            flaws.append(f"no JSON on standard output: {wrong}")
    return Called(" ".join(words), code, wall, processor, error[-2000:], tuple(flaws), figures)


def _waited(process: subprocess.Popen, until: float) -> tuple[int, float]:
    """Exit code of a process and CPU time of it and its own processes [s]; stopped at a time."""
    previous = signal.signal(signal.SIGALRM, lambda number, frame: os.killpg(process.pid, 9))
    signal.setitimer(signal.ITIMER_REAL, max(until - monotonic(), 1e-3))
    try:
        _, status, usage = os.wait4(process.pid, 0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def _flaws(code: int, error: str, limit: float) -> Iterator[str]:
    if code == -signal.SIGKILL:
        yield f"was stopped: it did not end within {limit:g} s of processor time and {LONGEST:g} s in all"
    elif code not in (CONVERGED, FAILED, BAD_INPUT, NOT_CONVERGED):
        yield f"exit code {code}"
    lines = error.splitlines()
    if any(line.startswith("Traceback") for line in lines):
        yield f"a traceback: {lines[-1]:.200}"
    elif slip := PROGRAM_ERROR.search(error):
        yield f"an error of the program as a reason: {slip[0]:.200}"
    elif strange := [line for line in lines if line and not line.startswith("pyworm: ")]:
        yield f"a line that is no message: {strange[0]:.200}"
    if code in (FAILED, NOT_CONVERGED) and not lines:
        yield f"exit code {code} without a reason"


def _figures(content: dict[str, Any]) -> dict[str, Any]:
    """What the suite counts, of the JSON of `check` and of `run`."""
    found = {
        name: content[name]
        for name in ("expected_seconds", "expected_seconds_of_search")
        if name in content
    }
    if "failed" in content:
        scenes = content["scenes"]
        found |= {
            "phases": len(scenes) + len(content["failed"]),
            "converged": sum(scene["accurate"] for scene in scenes),
            "usable": sum(scene["converged"] for scene in scenes),
            "reasons": {
                scene["name"]: scene["stop_reason"] for scene in scenes if not scene["accurate"]
            }
            | content["failed"],
            "mesh_loss": content.get("mesh_loss"),
        }
    return found


@dataclass(frozen=True)
class DriveVerdict:
    """What a drive of the suite came to at an accuracy."""

    name: str
    """The drive."""
    kind: str
    """What it is."""
    accuracy: str
    """The accuracy asked for."""
    outcome: str
    """Outcome: "complete", all phases converged; "incomplete"; "refused" in a sentence; "out of time"; or
    "broken"."""
    phases: int = 0
    """Phases that were asked for."""
    converged: int = 0
    """Phases that converged."""
    wall: float = 0.0
    """Time that passed [s]."""
    processor: float = 0.0
    """Processor time taken [s]."""
    expected: float = 0.0
    """Processor time announced by `check` [s]."""
    reason: str = ""
    """Why it is not complete."""

    @property
    def line(self) -> str:
        """A row of the table."""
        why = f"  {self.outcome}: {self.reason}" if self.reason else ""
        return (
            f"{self.name:12} {self.kind:8} {self.accuracy:>5} {self.converged:3d}/{self.phases:<3d}"
            f"{self.wall:9.1f}{self.processor:9.1f}{self.expected:9.1f}{why}"
        )


DRIVE_HEADING = (
    f"{'drive':12} {'kind':8} {'':>5} {'phases':7}{'wall':>9}{'cpu':>9}{'expected':>9}  s"
)


def drive_verdict(trial: DriveTrial, accuracy: str) -> DriveVerdict:
    """Check and run a drive at an accuracy, with default effects and all its phases."""
    about = (trial.name, str(trial.drawn.traits["kind"]), accuracy)
    check = ("check", "CASE", "--json", "--accuracy", accuracy)
    checked = trial.known(*check) or trial.called(*check)
    if checked.outcome != "done":
        reason = "; ".join(checked.flaws) or checked.said.strip()
        return DriveVerdict(*about, checked.outcome, reason=f"check: {reason}")
    expected = sum(checked.figures.values())
    words = ("run", "CASE", "--json", "--accuracy", accuracy, "--out", "OUT")
    run = trial.known(*words) or trial.called(*words)
    rmtree(trial.out, ignore_errors=True)
    times = {"wall": run.wall, "processor": run.processor, "expected": expected}
    phases = run.figures.get("phases", len(trial.drawn.tables["operation"]["phases"]))
    converged = run.figures.get("converged", 0)
    if run.outcome in ("broken", "refused", "out of time"):
        reason = "; ".join(run.flaws) or run.said.strip()
        return DriveVerdict(*about, run.outcome, phases, reason=f"run: {reason}", **times)
    reasons = run.figures.get("reasons") or ({} if converged else {"all": run.said.strip()})
    return DriveVerdict(
        *about,
        "complete" if run.figures.get("usable", 0) == phases else "incomplete",
        phases,
        converged,
        reason="; ".join(f"{name}: {reason}" for name, reason in reasons.items()),
        **times,
    )


QUICK = ("--accuracy", "20%", "--effects", "isothermal", "--phase", "0.3", "0.5", "0.7")

COMMANDS: dict[str, tuple[str, ...]] = {
    "check": ("check", "CASE", "--json"),
    "rate": ("rate", "CASE", "--json"),
    "film": ("film", "CASE", "--json"),
    "setup": ("setup", "CASE", "--json"),
    "shim": ("setup", "CASE", "--shim", "--json"),
    "run": ("run", "CASE", "--json", *QUICK, "--pictures", "none", "--out", "OUT"),
    "report": ("report", "OUT/result.nc", "--case", "CASE", "--out", "OUT/report.html"),
    "explore": ("explore", "OUT/result.nc", "--out", "OUT/explore.html"),
    "wear": ("wear", "CASE", "--json", "--hours", "1", "--tolerance", "50",
             "--phase", "0.4", "0.5", "0.6", "--out", "OUT/wear"),
}  # fmt: skip
"""Commands that each drive is walked through, in this order; the later ones take what `run` leaves."""

BOUNDS = {"check": 120.0, "rate": 120.0, "film": 120.0, "setup": 300.0, "shim": 300.0}
"""Processor time that these commands may take with a drive [s]."""

WALK_BOUND = 600.0
"""Processor time that the others may take, which solve films or draw them [s]."""


ON_RESULTS = ("report", "explore")
"""Commands on a result."""


def walked(trial: DriveTrial, names: Sequence[str]) -> Iterator[Called]:
    """What some of the commands come to with a drive, each within its bound of time.

    Those on a result are only run where `run` leaves one.
    """
    for name in names:
        words, limit = COMMANDS[name], BOUNDS.get(name, WALK_BOUND)
        done = trial.known(*words, limit=limit)
        if done is None and name in ON_RESULTS and not trial.result.is_file():
            trial.called(*COMMANDS["run"], limit=WALK_BOUND)
            if not trial.result.is_file():
                continue
        yield done or trial.called(*words, limit=limit)
    rmtree(trial.out, ignore_errors=True)
