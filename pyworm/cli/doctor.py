"""Check of the installation: one line for each test, with a remedy where it fails."""

import argparse
import ctypes
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from pyworm.io.terminal import print_result

PACKAGES = (
    "numpy",
    "scipy",
    "pydantic",
    "xarray",
    "netCDF4",
    "matplotlib",
    "rich",
)

SELF_CHECK_ERROR = 0.01
"""Largest deviation from Hertz that the check on its coarse grid may show."""


class _UnsoundError(Exception):
    """A failed check; the message has the finding and the remedy."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    doctor = commands.add_parser("doctor", help="check the installation")
    doctor.set_defaults(command=_doctor)


def _doctor(options: argparse.Namespace) -> int:
    """Run all checks and print a line for each; 0 if all is well, 1 otherwise."""
    checks: tuple[tuple[str, Callable[[], str]], ...] = (
        ("Python", lambda: f"{platform.python_version()} at {sys.executable}"),
        ("pyworm", lambda: _version("pyworm")),
        ("packages", lambda: ", ".join(f"{package} {_version(package)}" for package in PACKAGES)),
        ("kernel", lambda: str(_core_path())),
        ("processor", _processor),
        ("FFTW", _fftw),
        ("self-check", _self_check),
        ("threads", _threads),
        ("write access", _write_access),
    )
    sound = True
    for name, check in checks:
        try:
            word, message = "ok", check()
        except _UnsoundError as problem:
            word, message, sound = "NO", str(problem), False
        print_result(f"{name:14}{word:4}{message}")
    return 0 if sound else 1


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        raise _UnsoundError(f"{package} is not installed; run make install") from None


def _core_path() -> Path:
    try:
        from pyworm.kernel.core import EXTENSION
    except ImportError as error:
        raise _UnsoundError(f"not built ({error}); run make install") from None
    return EXTENSION


_STEP = """
from pyworm.solver.cost.calibration import calibration
found = calibration()
print(found.cold["point"].steps(1, {nodes}), found.heated["point"][0].steps(1, {nodes}))
"""
"""Prints the processor time of Newton steps, measured once for each kernel and cached."""

_NODES = 30_000
"""Nodes of a usual grid of the figures."""


def _processor() -> str:
    """For what the kernel is compiled, and what that gains; of a build of one's own, its -march."""
    _core_path()
    from pyworm.kernel.core import LEVEL, compiled_with
    from pyworm.kernel.levels import BASE, built

    if LEVEL is None:
        options = compiled_with()[1].split()
        return next((flag for flag in options if flag.startswith("-march")), "compiled for any")
    there = f"kernel for {LEVEL}, of {', '.join((BASE, *built()))}"
    if LEVEL == BASE:
        return there
    cold, heated = (
        base / step_time for base, step_time in zip(_steps_of(BASE), _steps_of(LEVEL), strict=True)
    )
    return f"{there}: {cold:.2f} times as fast as {BASE} in films, {heated:.2f} times with heat"


def _steps_of(level: str) -> list[float]:
    """Processor times of a Newton step at a level [s], isothermal and with heat, in a process of its own."""
    from pyworm.kernel.levels import LEVEL_VARIABLE

    done = subprocess.run(
        [sys.executable, "-c", _STEP.format(nodes=_NODES)],
        env=os.environ
        | {LEVEL_VARIABLE: level, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise _UnsoundError(f"the kernel for {level} fails: {done.stderr.strip().splitlines()[-1]}")
    return [float(word) for word in done.stdout.split()]


def _fftw() -> str:
    # FFTW keeps its version as a C string of its own; the kernel that is linked with it leads there.
    try:
        text = (ctypes.c_char * 64).in_dll(ctypes.CDLL(str(_core_path())), "fftw_version").value
    except ValueError:
        raise _UnsoundError("the kernel is linked without it; run make clean install") from None
    return text.decode()


def _self_check() -> str:
    """Dry contact of a ball against Hertz, through the kernel's convolution."""
    _core_path()
    import numpy as np

    from pyworm.formulas.hertz import hertz
    from pyworm.kernel.dry_contact import dry_contact

    radius, load, modulus = 0.01, 10.0, 226e9
    exact = hertz(radius, radius, load, modulus)
    x = np.linspace(-1.5, 1.5, 65) * exact.semi_axis_x
    gap = (x[:, None] ** 2 + x[None, :] ** 2) / (2 * radius)
    covered = np.ones(gap.shape, dtype=bool)
    start = time.perf_counter()
    contact = dry_contact(
        gap, covered, x[1] - x[0], x[1] - x[0], modulus, load, np.ones(gap.shape), 1e-6
    )
    seconds = time.perf_counter() - start
    error = abs(contact.pressure.max() / exact.pressure_max - 1)
    found = f"a ball's maximum pressure is {error:.1e} off Hertz, {seconds * 1e3:.0f} ms"
    if not error < SELF_CHECK_ERROR:
        raise _UnsoundError(f"{found}; run make clean test and report what fails")
    return found


def _threads() -> str:
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
    settings = ", ".join(f"{name} {os.environ.get(name, 'not set')}" for name in names)
    return f"{os.cpu_count()} processors, {settings}"


def _write_access() -> str:
    here = Path.cwd()
    try:
        with tempfile.TemporaryFile(dir=here):
            return f"{here}"
    except OSError as error:
        raise _UnsoundError(f"{error}; change to a directory of your own or give --out") from None
