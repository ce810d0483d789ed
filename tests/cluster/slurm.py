"""A Slurm of one node, this machine, from Debian's packages, with its files in a directory."""

import os
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from secrets import token_bytes

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo")

PATIENCE = 60.0
"""How long a daemon may take to answer [s]."""

CONFIGURATION = """
ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=2
SchedulerParameters=batch_sched_delay=0,sched_interval=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} RealMemory={memory} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def why_not() -> str | None:
    """Reason why no Slurm can be started here; None if it can."""
    missing = [name for name in PROGRAMS if _program(name) is None]
    if missing:
        return f"no {', '.join(missing)} here; make test-cluster installs them"
    return None if os.getuid() == 0 else "slurmd needs root"


def _program(name: str) -> str | None:
    return shutil.which(name) or shutil.which(name, path="/usr/sbin:/sbin")


def _free_ports() -> tuple[int, int]:
    with socket.socket() as one, socket.socket() as other:
        for each in (one, other):
            each.bind(("127.0.0.1", 0))
        return one.getsockname()[1], other.getsockname()[1]


@contextmanager
def running_slurm(folder: Path, cores: int) -> Iterator[dict[str, str]]:
    """Start munge, the controller and the node.

    Args:
        folder: Directory for all their files; its path must be short enough for a socket's.
        cores: Processors that the node offers, which need not be there.

    Yields:
        The environment in which sbatch and its likes find it.
    """
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    folder.chmod(0o755)
    key = folder / "munge.key"
    key.write_bytes(token_bytes(1024))
    key.chmod(0o400)
    host = socket.gethostname().partition(".")[0]
    configuration = folder / "slurm.conf"
    configuration.write_text(
        CONFIGURATION.format(
            host=host, ports=_free_ports(), folder=folder, cores=cores, memory=16000
        )
    )
    environment = os.environ | {"SLURM_CONF": str(configuration)}
    with ExitStack() as stack:

        def start(name: str, *arguments: str) -> None:
            log = stack.enter_context((folder / f"{name}.log").open("w"))
            process = subprocess.Popen(
                [_program(name), *arguments], stdout=log, stderr=log, env=environment
            )
            stack.callback(process.wait)
            stack.callback(process.terminate)

        start(
            "munged",
            *("--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket"),
            *(f"--{of}-file={folder}/munged.{of}" for of in ("pid", "log", "seed")),
        )
        _wait(lambda: (folder / "munge.socket").exists(), "munged")
        start("slurmctld", "-D", "-i")
        start("slurmd", "-D", "-N", host)
        _wait(lambda: "idle" in _said(environment, "sinfo", "-h", "-o", "%T"), "the node")
        yield environment


def _said(environment: dict[str, str], *command: str) -> str:
    return subprocess.run(command, env=environment, capture_output=True, text=True).stdout


def _wait(ready, what: str) -> None:
    until = time.monotonic() + PATIENCE
    while not ready():
        if time.monotonic() > until:
            raise TimeoutError(f"{what} does not answer")
        time.sleep(0.1)


def kill_one(environment: dict[str, str]) -> str:
    """Kill the processes of the first job that runs, as when memory runs out; its name in the queue."""
    name, number, _ = _said(environment, "squeue", "-h", "-r", "-t", "R", "-o", "%i %A %T").split()[
        :3
    ]
    mark = f"SLURM_JOB_ID={number}\0".encode()
    for process in Path("/proc").glob("[0-9]*"):
        try:
            inside = mark in (process / "environ").read_bytes()
            program = (process / "cmdline").read_bytes()
        except OSError:  # it has ended, or is another user's
            continue
        if inside and b"python" in program:
            os.kill(int(process.name), signal.SIGKILL)
    return name


def wait_for_all(environment: dict[str, str], patience: float) -> None:
    """Wait until no job is left; TimeoutError after some seconds."""
    until = time.monotonic() + patience
    while jobs := _said(environment, "squeue", "-h", "-r").splitlines():
        if time.monotonic() > until:
            raise TimeoutError(f"still there: {jobs}")
        time.sleep(0.5)
