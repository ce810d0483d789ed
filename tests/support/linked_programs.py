"""Programs linked with the library of the package's own build, by the compilers and without Python."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from folders import ROOT

from pyworm.kernel.core import EXTENSION

EXAMPLES = ROOT / "examples/fortran"
LIBRARY = EXTENSION.parent / "libworm.a"
"""The kernel beside the extension of an editable installation."""

FLAGS = ["-lfftw3", "-lfftw3f", "-lopenblas", "-fopenmp", "-lm"]
ONE_THREAD = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run(*command: object, **how: object) -> str:
    """What a command prints; it must not fail."""
    done = {"capture_output": True, "text": True, "check": True, "env": ONE_THREAD, **how}
    return subprocess.run(list(map(str, command)), **done).stdout


@dataclass(frozen=True)
class Linker:
    """Compiles programs in a folder and runs them."""

    folder: Path
    """Where programs and module files lie."""

    def __call__(self, source: Path, *arguments: object, parts: tuple[Path, ...] = ()) -> str:
        """What a program prints, of its source file and parts that are compiled before it."""
        built = self.folder / source.stem
        compiler = "gfortran" if source.suffix == ".f90" else "gcc"
        runtime = [] if compiler == "gfortran" else ["-lgfortran"]
        include = [f"-I{LIBRARY}.p", f"-I{ROOT / 'fortran/library'}"]
        folders = run("pkg-config", "--libs-only-L", "fftw3", "openblas").split()
        given = [*parts, source, *include, LIBRARY, *folders, *FLAGS, *runtime]
        run(compiler, "-O2", "-Wall", "-Werror", *given, "-o", built, cwd=self.folder)
        return run(built, *arguments)


@dataclass(frozen=True)
class Printed:
    """In place of a `Linker`, what programs printed on another machine (`tools/bare_library.sh`)."""

    folder: Path
    """Where it lies, a file for each program."""

    def __call__(self, source: Path, *_: object, **__: object) -> str:
        """What the program of a source file printed."""
        return (self.folder / f"{source.stem}.meson").read_text()
