"""Builds of the kernel for levels of x86-64, one of which is taken at import by what the processor has.

A build on one's own machine has a single kernel, `pyworm/_core`, for the processor at hand. A wheel has that
for the base level, which every such processor runs, and others under `pyworm/levels/` for the levels of the
x86-64 psABI (https://gitlab.com/x86-psABIs/x86-64-ABI, table 3.1). Their results differ by rounding.
"""

import os
import sys
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

from pyworm.io.present import present

BASE = "x86-64"

CPU_FLAGS = {
    "x86-64-v2": ("cx16", "lahf_lm", "popcnt", "sse4_1", "sse4_2", "ssse3"),
    "x86-64-v3": ("abm", "avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "movbe", "xsave"),
    "x86-64-v4": ("avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"),
}
"""Level -> what it asks of a processor beyond the level before, in the words of Linux."""

LEVEL_VARIABLE = "PYWORM_LEVEL"
"""Environment variable that names a level in place of the processor's highest, for comparisons."""

_FOLDER = Path(__file__).parents[1] / "levels"

_PROCESSOR = Path("/proc/cpuinfo")


def features(text: str) -> set[str]:
    """What the first processor of Linux's list has."""
    lines = (line.partition(":") for line in text.splitlines())
    return next((set(words.split()) for name, _, words in lines if name.strip() == "flags"), set())


def supported(has: set[str]) -> list[str]:
    """Levels that a processor with some features runs, the lowest first."""
    found = [BASE]
    for level, needed in CPU_FLAGS.items():
        if not has.issuperset(needed):
            break
        found.append(level)
    return found


def built(folder: Path = _FOLDER) -> dict[str, Path]:
    """Level -> kernel beside the one for the base level; empty where there is a single kernel."""
    found = (next(iter((folder / level).glob("_core_*.so")), None) for level in CPU_FLAGS)
    return {level: file for level, file in zip(CPU_FLAGS, found, strict=True) if file is not None}


def chosen(others: dict[str, Path], has: set[str], wanted: str | None) -> str:
    """The level wanted, or the highest that is there and runs; ImportError if it is not or cannot."""
    runs = [level for level in supported(has) if level == BASE or level in others]
    if wanted is None:
        return runs[-1]
    if wanted not in runs:
        raise ImportError(
            f"{LEVEL_VARIABLE}={wanted}: this kernel on this processor has {', '.join(runs)}"
        )
    return wanted


def processor() -> set[str]:
    """What this processor has; nothing where the system does not tell."""
    try:
        return features(_PROCESSOR.read_text())
    except OSError:
        return set()


def taken() -> tuple[str | None, Path | None]:
    """The level whose kernel is taken and its file; no level where there is a single kernel.

    There is no file of `pyworm._core` itself, which the single kernel and that of the base level are.
    """
    others = built()
    level = chosen(others, processor(), os.environ.get(LEVEL_VARIABLE)) if others else None
    return level, None if level is None else others.get(level)


def loaded(file: Path) -> ModuleType:
    """The kernel in a file, as `pyworm._core`."""
    name = "pyworm._core"
    loader = ExtensionFileLoader(name, str(file))
    spec = present(spec_from_file_location(name, loader=loader), f"the kernel in {file}")
    module = module_from_spec(spec)
    loader.exec_module(module)
    sys.modules[name] = module
    return module
