"""Batches on the workers of a dask.distributed scheduler, here or on many machines.

Workers need the same build of pyworm and the same directory, by a shared file system; one thread each
(`dask worker --nthreads 1`). Solutions do not travel: workers keep them, and only say so. What a worker that
died was at is solved by another.
"""

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager

from pyworm.case_error import CaseError

PATIENCE = 30
"""How long to wait for a scheduler's answer [s]."""


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The workers of a scheduler as an executor.

    Parameters
    ----------
    address : str
        Of the scheduler, such as "tcp://10.0.0.1:8786".

    Raises
    ------
    CaseError
        No dask.distributed is installed, or no scheduler answers.
    """
    try:
        from distributed import Client
    except ImportError:
        raise CaseError(
            "--scheduler: needs dask.distributed, install pyworm with its extra: pyworm[cluster]"
        ) from None
    try:
        client = Client(address, timeout=PATIENCE)
    except (OSError, ValueError):
        raise CaseError(
            f'--scheduler {address}: no scheduler answers there, give one such as "tcp://10.0.0.1:8786"'
        ) from None
    with client:
        yield client.get_executor()
