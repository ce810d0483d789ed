"""Floating-point traps about every kernel call: what is invalid, divides by zero or overflows ends the run.

Only a Fortran main program sets the traps that gfortran's -ffpe-trap asks for. In Python they are set here,
for the kernel's own work alone. They mean something for a debug build only: vectorised code computes what it
then throws away.
"""

import ctypes
from collections.abc import Callable
from typing import Any

from pyworm.kernel import core

INVALID, DIVIDED_BY_ZERO, OVERFLOW = 1, 4, 8
"""Flags of <fenv.h> on x86."""


class _Trapped:
    """Bindings whose calls are trapped."""

    def __init__(self, bindings: Any):
        self._bindings = bindings
        self._library = ctypes.CDLL("libm.so.6")

    def __getattr__(self, name: str) -> Callable:
        binding = getattr(self._bindings, name)

        def trapped(*arguments: Any) -> Any:
            self._library.feclearexcept(INVALID | DIVIDED_BY_ZERO | OVERFLOW)
            self._library.feenableexcept(INVALID | DIVIDED_BY_ZERO | OVERFLOW)
            try:
                return binding(*arguments)
            finally:
                self._library.fedisableexcept(INVALID | DIVIDED_BY_ZERO | OVERFLOW)

        return trapped


def set_traps() -> None:
    """From now on every call of the kernel is trapped."""
    core.bindings = _Trapped(core.bindings)
