"""Ctrl-C and SIGTERM at any moment: one sentence, the exit code of shells, and no process left."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from folders import CASES

from pyworm.batch.workers import WorkerPool

PATIENCE = 30
"""Seconds within which whatever ends does: far above what a busy machine needs, far below what would hang."""

pytestmark = pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs Linux's /proc")

WAITS = """
import sys
from pyworm.cli import stopping
stopping.GRACE = {grace}
stopping.end_in_order()
try:
    print(flush=True)
    while True:
        pass
except KeyboardInterrupt:
    {then}
"""


def in_group(group):
    """Processes of a process group that have not ended."""
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, its_group = status.read_text().rpartition(")")[2].split()[:3]
        except OSError:
            continue
        if int(its_group) == group and state != "Z":
            found.append(int(status.parent.name))
    return found


def assert_none_left(group):
    """Processes of a group end, soon enough for none to be called hanging."""
    given_up = time.monotonic() + PATIENCE
    while in_group(group):
        assert time.monotonic() < given_up
        time.sleep(0.01)


def started(*command):
    return subprocess.Popen(
        [sys.executable, *command],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def catches(process, number):
    """Whether a process handles a signal itself: bit number - 1 of SigCgt in proc(5)."""
    status = Path(f"/proc/{process.pid}/status").read_text()
    mask = next(line for line in status.splitlines() if line.startswith("SigCgt"))
    return bool(int(mask.split()[1], 16) >> (number - 1) & 1)


@pytest.mark.parametrize(
    ("end", "delay"),
    [(signal.SIGINT, 0.0), (signal.SIGINT, 0.5), (signal.SIGTERM, 1.2), (signal.SIGINT, 3.0)],
)
def test_a_signal_in_the_first_seconds_ends_all_at_once(tmp_path, end, delay):
    """While libraries are imported, the case is checked and workers start; the terminal's is for all."""
    command = ("run", str(CASES / "zi_sharif_2001.toml"), "-j", "2", "--out", str(tmp_path / "out"))
    process = started("-m", "pyworm.cli", *command)
    while not catches(process, signal.SIGTERM):
        assert process.poll() is None
        time.sleep(0.002)
    time.sleep(delay)
    os.killpg(process.pid, end)
    said = process.communicate(timeout=PATIENCE)[1]
    assert process.returncode == 128 + end
    assert said.startswith("pyworm: stopped") and said.count("\n") == 1
    assert_none_left(process.pid)


INTERRUPTED = """
import sys
import pyworm.cli.main as cli
from pyworm.cli.__main__ import main
from pyworm.cli.stopping import Stopped

def interrupted():
    raise Stopped(2)

cli.main = interrupted
sys.exit(main())
"""


def test_a_signal_between_the_imports_and_the_command_is_reported():
    process = started("-c", INTERRUPTED)
    said = process.communicate(timeout=PATIENCE)[1]
    assert (process.returncode, said) == (130, "pyworm: stopped\n")


@pytest.mark.parametrize("then", ["while True: pass", "raise SystemExit(0)"])
def test_a_hanging_process_is_ended_after_a_signal(then):
    process = started("-c", WAITS.format(then=then, grace=1.5))
    process.stdout.readline()
    process.terminate()
    said = process.communicate(timeout=PATIENCE)[1]
    hangs = then.startswith("while")
    assert (process.returncode, said) == ((143, "pyworm: stopped\n") if hangs else (0, ""))


def test_a_second_signal_does_not_wait():
    endless = "print(flush=True)\n    while True: pass"
    process = started("-c", WAITS.format(then=endless, grace=20 * PATIENCE))
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=PATIENCE)[1] == "pyworm: stopped\n"
    assert process.returncode == 130


def test_a_worker_in_a_long_call_ends_with_its_killed_parent():
    program = (
        "import time\nfrom pyworm.batch.workers import WorkerPool\n"
        "with WorkerPool(1) as pool:\n    import os\n"
        "    print(pool.submit(os.getpid).result(), flush=True)\n"
        f"    pool.submit(time.sleep, {20 * PATIENCE}).result()\n"
    )
    process = started("-c", program)
    assert int(process.stdout.readline()) in in_group(process.pid)
    process.kill()
    process.communicate()
    assert_none_left(process.pid)


def test_the_first_worker_of_a_program_has_the_interrupt_blocked():
    """Else the keyboard's would end it with a traceback while it starts."""
    program = (
        "import signal\nfrom pyworm.batch.workers import WorkerPool\n"
        "with WorkerPool(1) as pool:\n"
        "    mask = pool.submit(signal.pthread_sigmask, signal.SIG_BLOCK, []).result()\n"
        "print(signal.SIGINT in mask)\n"
    )
    assert started("-c", program).communicate()[0] == "True\n"


def test_a_pool_that_ends_starts_no_more_processes():
    pool = WorkerPool(1)
    with pytest.raises(KeyboardInterrupt), pool:
        pool.submit(os.getpid).result()
        raise KeyboardInterrupt
    assert pool._workers[0]._ended
