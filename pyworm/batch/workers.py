"""Worker processes of one thread each; the death of one fails only its own call."""

import ctypes
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from multiprocessing import get_context, parent_process, resource_tracker
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from queue import SimpleQueue
from typing import Any

from pyworm.batch.cluster import cluster
from pyworm.io.terminal import print_message

_SPAWN = get_context("spawn")  # a fork after an OpenMP region hangs

_ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
"""Environment of the workers: as many threads as processes would fight for the cores."""


class WorkerDiedError(RuntimeError):
    """A process ended in the middle of a call; the message says how."""


def executor_of(processes: int, scheduler: str | None) -> AbstractContextManager[Executor | None]:
    """What solves: the workers of a scheduler, or some processes; None where this one does."""
    if scheduler is not None:
        return cluster(scheduler, print_message)
    return nullcontext() if processes == 1 else WorkerPool(processes)


class WorkerPool(Executor):
    """Processes that take calls, as `concurrent.futures` has them.

    A process pool of the standard library breaks as a whole when one of its processes dies. Here each process
    has a thread of this one that waits for it, and is made anew at the next call. Leaving the pool by an
    exception, such as a keyboard interrupt, ends the processes at once; if this process is killed they end
    with it on Linux, elsewhere with the call at hand. Functions, arguments, answers and exceptions are
    pickled.
    """

    def __init__(self, count: int) -> None:
        """A pool of some processes; they start with the first calls."""
        self._workers = [_Worker() for _ in range(count)]
        self._idle: SimpleQueue[_Worker] = SimpleQueue()
        for worker in self._workers:
            self._idle.put(worker)
        self._threads = ThreadPoolExecutor(count)

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **named: Any) -> Future[Any]:
        """Call a function in one of the processes; the future may raise WorkerDiedError."""
        return self._threads.submit(self._call, partial(function, **named), arguments)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Accept no more calls; end the processes once the pending ones are done."""
        self._threads.shutdown(wait=wait, cancel_futures=cancel_futures)
        for worker in self._workers:
            worker.stop()

    def __exit__(self, kind: type | None, *exception: Any) -> None:
        """Shut down, at once if by an exception."""
        if kind is not None:
            self._threads.shutdown(wait=False, cancel_futures=True)
            for worker in self._workers:
                worker.terminate()
        self.shutdown()

    def _call(self, function: Callable, arguments: tuple) -> Any:
        worker = self._idle.get()
        try:
            return worker.call(function, arguments)
        finally:
            self._idle.put(worker)


class _Worker:
    """One process, started when first needed."""

    _starting = threading.Lock()  # the environment is that of this whole process

    def __init__(self) -> None:
        self._ended = False
        self._running: tuple[SpawnProcess, Connection] | None = None

    def call(self, function: Callable, arguments: tuple) -> Any:
        if self._running is None or not self._running[0].is_alive():
            self._running = self._started()
        process, connection = self._running
        try:
            connection.send((function, arguments))
            answer, error = connection.recv()
        except (EOFError, OSError):  # the process is gone, and its end of the pipe with it
            process.join()
            self._running = None
            connection.close()
            raise WorkerDiedError(_ending(process.exitcode)) from None
        if error is not None:
            raise error
        return answer

    def stop(self) -> None:
        if self._running is not None:
            process, connection = self._running
            connection.close()
            process.join()

    def terminate(self) -> None:
        with self._starting:
            self._ended = True
        if self._running is not None:
            self._running[0].terminate()

    def _started(self) -> tuple[SpawnProcess, Connection]:
        connection, other_end = _SPAWN.Pipe()
        process = _SPAWN.Process(target=_serve, args=(other_end,), daemon=True)
        with self._starting:
            if self._ended:
                raise WorkerDiedError("the pool has ended")
            before = {name: os.environ.get(name) for name in _ONE_THREAD}
            os.environ.update(_ONE_THREAD)
            # The keyboard's interrupt is for the process that waits, from the first moment of this one. The
            # library starts a helper with the first process, which would clear the mask: it comes before.
            resource_tracker.ensure_running()
            mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
            try:
                process.start()
            finally:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
                for name, value in before.items():
                    if value is None:
                        del os.environ[name]
                    else:
                        os.environ[name] = value
        other_end.close()
        return process, connection


def _serve(connection: Connection) -> None:
    """Answer calls until the connection closes."""
    _end_with_parent()
    if os.getppid() != getattr(parent_process(), "pid", None):  # it was killed before
        return
    while True:
        try:
            function, arguments = connection.recv()
        except (EOFError, OSError):
            return
        outcome: tuple[Any, Exception | None]
        try:
            outcome = function(*arguments), None
        except Exception as error:
            outcome = None, error
        try:
            connection.send(outcome)
        except OSError:
            return


_PR_SET_PDEATHSIG = 1
"""Of Linux's prctl(2): a signal to this process when the thread that started it ends."""


def _end_with_parent() -> None:
    """Have the system end this process, in whatever call it is, when its parent is killed; on Linux."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)


def _ending(exit_code: int | None) -> str:
    """How a process ended, in words."""
    if exit_code is None or exit_code >= 0:
        return f"its process ended with exit code {exit_code}"
    name = signal.Signals(-exit_code).name
    hint = ", as when memory runs out" if name == "SIGKILL" else ""
    return f"its process was ended by {name}{hint}"
