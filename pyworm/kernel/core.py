"""The compiled extension, imported here only: status numbers to exceptions, arrays to Fortran order."""

from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.kernel.levels import loaded, taken

LEVEL, _file = taken()
if _file is None:
    from pyworm import _core as _compiled  # type: ignore[attr-defined]  # compiled: in no stub
else:
    _compiled = loaded(_file)
_core: ModuleType = _compiled

bindings: Any = _core.bindings
"""The kernel's procedures (`bindings.f90`)."""

bindings.watch_signals()

EXTENSION = Path(str(_core.__file__))
"""File of the compiled extension; `LEVEL` is the level of x86-64 of a wheel that it is for."""

NO_SENSE = 1
NOT_FINITE = 2
NOT_CONVERGED = 4
NO_DESCENT = 5
NO_MEMORY = 6


class KernelError(RuntimeError):
    """A kernel procedure failed."""

    def __init__(self, status: int):
        super().__init__(bindings.status_text(status).decode().strip())
        self.status = status
        """The kernel's status number (`fortran/base/status.f90`)."""


def check_status(status: int) -> None:
    """Raise a KernelError unless a status number is that of success."""
    if status:
        raise KernelError(status)


def fortran_array(values: npt.ArrayLike) -> Array:
    """Values in double precision and Fortran order, copied if necessary."""
    return np.asfortranarray(values, dtype=np.float64)


def compiled_with() -> tuple[str, str]:
    """The compiler and its options, without paths and features of the processor that -march implies."""
    compiler, options = (text.decode().strip() for text in bindings.compiled_with())
    given = [
        option
        for option in options.split()
        if option.startswith("-") and "/" not in option and not option.startswith(_NOT_GIVEN)
        if not option.startswith("-m") or option.startswith(("-march", "-mtune"))
    ]
    return compiler, " ".join(dict.fromkeys(given))


_NOT_GIVEN = ("-I", "-J", "-o", "-c", "--param", "-fdiagnostics")
"""Prefixes of options without effect on the generated code."""
