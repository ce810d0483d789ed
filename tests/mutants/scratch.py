"""A copy of the tree in which mutations are made, built and tested; the working tree stays as it is."""

import os
import re
import resource
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from rules import ROOT, Mutation

PROCESSOR_SECONDS = 300
"""Processor time that a program, or all tests in Python of a mutation, may take: it ends endless loops."""

WITHOUT_EDITABLE_INSTALL = """
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "editable" not in type(finder).__module__]
"""
"""Run by Python as it starts, so that pyworm is the copy, in processes that tests start too."""

KERNEL = f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"


@dataclass(frozen=True)
class Scratch:
    """The copy."""

    directory: Path
    """Where it is; `tree` in it is the copy, `build` a debug build of that."""

    @property
    def tree(self) -> Path:
        """The copy of the tree."""
        return self.directory / "tree"

    @property
    def build(self) -> Path:
        """Its debug build."""
        return self.directory / "build"

    def refresh(self) -> None:
        """Bring the copy up to date; files that are the same keep their times, so that builds go on."""
        listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
        names = subprocess.run(listed, cwd=ROOT, check=True, capture_output=True).stdout
        wanted = {name for name in names.decode().split("\0") if name and (ROOT / name).is_file()}
        for path in [path for path in self.tree.rglob("*") if path.is_file()]:
            if path.relative_to(self.tree).as_posix() not in wanted:
                path.unlink()
        for name in wanted:
            here, there = ROOT / name, self.tree / name
            if not there.is_file() or there.read_bytes() != here.read_bytes():
                there.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(here, there)
        site = self.directory / "site"
        site.mkdir(exist_ok=True)
        (site / "sitecustomize.py").write_text(WITHOUT_EDITABLE_INSTALL)
        if not (self.build / "build.ninja").is_file():
            self._run("meson", "setup", str(self.build), "--buildtype=debug").check_returncode()

    @contextmanager
    def mutated(self, mutation: Mutation) -> Iterator[None]:
        """The copy with a mutation, which is taken back."""
        path = self.tree / mutation.file
        before = path.read_text(encoding="utf-8")
        path.write_text(mutation.applied(self.tree), encoding="utf-8")
        try:
            yield
        finally:
            path.write_text(before, encoding="utf-8")

    def failure(self, mutation: Mutation) -> str | None:
        """What of a mutation's tests fails as the copy stands; None if nothing does."""
        for program in mutation.programs:
            if failed := self.program_failure(program):
                return failed
        if not mutation.python_tests:
            return None
        if mutation.in_kernel and not self._built(f"fortran/{KERNEL}"):
            return "does not compile"
        kernel = self.build / "fortran" / KERNEL if mutation.in_kernel else _installed_kernel()
        failed = self.python_failures(mutation.python_tests, kernel, "-x")
        return failed[0] if failed else None

    def program_failure(self, name: str) -> str | None:
        """What of a Fortran program's checks fails; None if nothing does."""
        if not self._built(f"tests/fortran/test_{name}"):
            return f"{name}: does not compile"
        ended = self._run(str(self.build / "tests" / "fortran" / f"test_{name}"))
        wrong = re.search(r"^not ok\s*\d+ - (.*)$", ended.stdout, re.MULTILINE)
        if wrong is not None:
            return f"{name}: {wrong[1]}"
        whole = ended.returncode == 0 and re.search(r"^1\.\.\d+$", ended.stdout, re.MULTILINE)
        return None if whole else f"{name}: ends before its end"

    def python_failures(
        self, tests: Sequence[str], kernel: Path | None = None, *options: str
    ) -> list[str]:
        """Names of the tests in Python that fail, with a kernel or the installed program's."""
        shutil.copy(kernel or _installed_kernel(), self.tree / "pyworm")
        quiet = ("-q", "--no-header", "--tb=no", "-p", "no:cacheprovider")
        ended = self._run(sys.executable, "-m", "pytest", *quiet, *options, *tests)
        failed = re.findall(
            r"^(?:FAILED|ERROR) (?:tests/python/)?(\S+)", ended.stdout, re.MULTILINE
        )
        return failed or ([] if ended.returncode == 0 else [f"pytest ends with {ended.returncode}"])

    def _built(self, target: str) -> bool:
        return self._run("ninja", "-C", str(self.build), target).returncode == 0

    def _run(self, *command: str) -> subprocess.CompletedProcess[str]:
        """A command in the copy, on one thread and within its time."""
        return subprocess.run(
            command,
            cwd=self.tree,
            env=_environment(self),
            capture_output=True,
            text=True,
            check=False,
            preexec_fn=_limit_time,
        )


def _environment(scratch: Scratch) -> dict[str, str]:
    paths = f"{scratch.directory / 'site'}{os.pathsep}{scratch.tree}"
    return os.environ | {"PYTHONPATH": paths, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def _limit_time() -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS + 5))


@cache
def _installed_kernel() -> Path:
    """The kernel of the installed program, which its import builds anew if need be."""
    found = "from pyworm import _core; print(_core.__file__)"
    command = [sys.executable, "-c", found]
    return Path(subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip())
