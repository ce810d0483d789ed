"""Batches on the workers of a dask.distributed scheduler, here or on many machines.

Workers need the same build of pyworm and the same directory, by a shared file system; one thread each
(`dask worker --nthreads 1`). Solutions do not travel: workers keep them, and only say so. What a worker that
died was at is solved by another. If the scheduler is lost, so are the calls at hand, and nothing else.
"""

import logging
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Executor
from contextlib import contextmanager
from threading import Event, Thread
from typing import TYPE_CHECKING

from pyworm.io.input_error import CaseError
from pyworm.io.on_demand import allow

if TYPE_CHECKING:
    from distributed import Client


PATIENCE = 30
"""How long to wait for a scheduler's answer [s]."""

LOOK = 2
"""How often to look whether there are workers [s]."""

RESUME_HINT = "contacts already solved are kept, the same command continues from there"


@contextmanager
def cluster(address: str, print_message: Callable[[str], None]) -> Iterator[Executor]:
    """The workers of a scheduler, by its address such as "tcp://10.0.0.1:8786", as an executor.

    A message says if no worker is left or none has come yet. CaseError without dask.distributed or if no
    scheduler answers; ConnectionError if the scheduler was lost on the way.
    """
    allow("dask")
    try:
        from distributed import Client
        from distributed.versions import VersionMismatchWarning
    except ImportError:
        raise CaseError(
            "--scheduler: needs dask.distributed, install pyworm with its extra: pyworm[cluster]"
        ) from None
    # What matters of all that it would log is told here, and by the reasons of scenes that fail.
    logging.disable(logging.CRITICAL)
    warnings.simplefilter("ignore", VersionMismatchWarning)
    try:
        client = Client(address, timeout=PATIENCE)
    except (OSError, ValueError):
        raise CaseError(
            f'--scheduler {address}: no scheduler answers there, give one such as "tcp://10.0.0.1:8786"'
        ) from None
    ended = Event()
    watch = Thread(target=_watch, args=(client, address, print_message, ended), daemon=True)
    with client:
        watch.start()
        try:
            yield client.get_executor()
        except CancelledError:  # of calls that nobody here has cancelled
            raise ConnectionError(f"--scheduler {address}: was lost; {RESUME_HINT}") from None
        finally:
            ended.set()


def _watch(
    client: "Client", address: str, print_message: Callable[[str], None], ended: Event
) -> None:
    """Report, once each time, that there are no workers."""
    told = False
    while not ended.wait(LOOK):
        try:
            workers = len(client.scheduler_info()["workers"])
        except Exception:  # the scheduler is gone, which its calls tell
            return
        if workers == 0 and not told:
            print_message(f"--scheduler {address}: has no workers, waiting for some; {RESUME_HINT}")
        told = workers == 0
