"""A copy of the sources in which files are added or changed, and which is then what runs."""

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from pyworm.kernel.core import EXTENSION

ROOT = Path(__file__).parents[2]

WITHOUT_EDITABLE_INSTALL = """
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "editable" not in type(finder).__module__]
"""
"""Run by Python as it starts, so that pyworm is the copy, in processes that it starts too."""


COPIED = ("pyworm", "fortran", "cases")
"""Folders that are copied."""


@dataclass(frozen=True)
class Folder:
    """A folder whose Python modules are imported before others."""

    root: Path

    def write(self, name: str, content: str) -> None:
        """Write a file."""
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(content)

    def python(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Python in the copy."""
        paths = os.pathsep.join([str(self.root / "start"), str(self.root)])
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=self.root,
            env=os.environ | {"PYTHONPATH": paths, "OMP_NUM_THREADS": "1"},
            capture_output=True,
            text=True,
            check=False,
        )

    def pyworm(self, *arguments: str) -> str:
        """What a command prints, which has to succeed."""
        ended = self.python("-m", "pyworm.cli", *arguments)
        assert ended.returncode == 0, ended.stderr
        return ended.stdout


@dataclass(frozen=True)
class SourceCopy(Folder):
    """A copy of the package, of the kernel's sources and of the cases."""

    @classmethod
    def in_folder(cls, root: Path) -> "SourceCopy":
        """The copy, with the installed kernel."""
        for name in COPIED:
            without = shutil.ignore_patterns("__pycache__", "*.so")
            shutil.copytree(ROOT / name, root / name, ignore=without)
        shutil.copy(EXTENSION, root / "pyworm")
        (root / "start").mkdir()
        (root / "start" / "sitecustomize.py").write_text(WITHOUT_EDITABLE_INSTALL)
        return cls(root)

    def insert(self, name: str, before: str, text: str) -> None:
        """Insert text into a file before a line that is there once."""
        content = (self.root / name).read_text()
        assert content.count(before) == 1, (name, before)
        self.write(name, content.replace(before, text + before))

    def changed(self) -> set[str]:
        """Files of the package and of the kernel that are not as in the sources."""
        return {
            path.relative_to(self.root).as_posix()
            for name in ("pyworm", "fortran")
            for path in (self.root / name).rglob("*")
            if path.is_file() and "__pycache__" not in path.parts and path.suffix != ".so"
            if not (here := ROOT / path.relative_to(self.root)).is_file()
            or here.read_bytes() != path.read_bytes()
        }

    def build(self) -> None:
        """Build the kernel of the copy, with few optimisations."""
        for name in ("meson.build", "meson_options.txt"):
            shutil.copy(ROOT / name, self.root)
        shutil.copytree(ROOT / "tests" / "fortran", self.root / "tests" / "fortran")
        setup = "meson", "setup", "build", "--buildtype=plain", "-Dfortran_args=-O1"
        for command in (setup, ("ninja", "-C", "build", f"fortran/{EXTENSION.name}")):
            ended = subprocess.run(
                command, cwd=self.root, capture_output=True, text=True, check=False
            )
            assert ended.returncode == 0, ended.stdout[-2000:] + ended.stderr[-2000:]
        shutil.copy(self.root / "build" / "fortran" / EXTENSION.name, self.root / "pyworm")
