"""A batch that is killed twenty times, wherever it is, and resumed, ends with the bits of one left alone."""

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pyworm.result.result import open_result

CASES = Path(__file__).parents[2] / "cases"

RUN = (
    sys.executable, "-m", "pyworm.cli", "run", str(CASES / "traction_steel.toml"), "--accuracy", "30%",
    "--effects", "isothermal", "--pictures", "none", "-j", "2",
)  # fmt: skip
"""A traction curve, whose contacts take a fraction of a second each."""

TIMES = 20
"""How often it is killed."""


def killed_and_resumed(tell: Callable[[str], None], directory: Path) -> list[str]:
    """Kill a batch after random times and let it end; what differs from one that was left alone."""
    begun = time.monotonic()
    _process(directory / "whole").wait()
    taken = time.monotonic() - begun
    rng = random.Random(7)
    ended = sum(
        _killed_after(directory / "killed", rng.uniform(0.1, 0.6) * taken) for _ in range(TIMES)
    )
    _process(directory / "killed").wait()
    flaws = list(_differences(directory / "whole", directory / "killed"))
    tell(
        f"a batch of {taken:.1f} s killed {TIMES - ended} times, {ended} times it had ended before: "
        f"{len(flaws)} differences"
    )
    return flaws


def _process(out: Path) -> subprocess.Popen:
    """The batch in a session of its own, so that its workers are killed with it."""
    return subprocess.Popen(
        [*RUN, "--out", str(out)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def _killed_after(out: Path, seconds: float) -> bool:
    """Kill the batch after a time; True if it had ended by itself."""
    process = _process(out)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return False
    return True


def _differences(one: Path, other: Path) -> list[str]:
    results = [open_result(directory / "result.nc") for directory in (one, other)]
    flaws = [f"killed: left {path.name} behind" for path in other.rglob("*.part")]
    counts = [len(result.solutions) for result in results]
    if counts[0] != counts[1]:
        return [*flaws, f"killed: {counts[1]} contacts in place of {counts[0]}"]
    for a, b in zip(*(result.solutions for result in results), strict=True):
        if a.figures != b.figures:
            flaws.append(f"killed: the figures of {a.name} differ")
        flaws += [
            f"killed: {name} of {a.name} differs"
            for name in a.fields.data_vars
            if not np.array_equal(a.fields[name], b.fields[name], equal_nan=True)
        ]
    return flaws
