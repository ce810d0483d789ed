"""Print the interpreters of this machine for which a wheel can be built, one for each version of Python.

They are those of the search path, the one that runs this first, and those of pyenv, if it is there. What is
left out, and why, goes to standard error. Usage: tools/pythons.py
"""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path

PROJECT = Path(__file__).parents[1] / "pyproject.toml"

ASK = """
import importlib.util, pathlib, sys, sysconfig
lacks = [name for name in ("ensurepip", "venv") if importlib.util.find_spec(name) is None]
if not pathlib.Path(sysconfig.get_path("include"), "Python.h").is_file():
    lacks.append("Python.h")
if sysconfig.get_config_var("Py_GIL_DISABLED"):
    lacks.append("the global interpreter lock")
if sys.version_info.releaselevel != "final":
    lacks.append("a final release")
print(sys.implementation.name, sys.version_info[0], sys.version_info[1], *lacks, sep="|")
"""
"""What an interpreter says of itself: implementation, version, and what it lacks to build a wheel."""


def oldest() -> tuple[int, int]:
    """The oldest version that the project allows."""
    asked = tomllib.loads(PROJECT.read_text())["project"]["requires-python"]
    major, minor = re.fullmatch(r">=(\d+)\.(\d+)", asked).groups()
    return int(major), int(minor)


def candidates() -> Iterator[Path]:
    """Files that may be interpreters, in the order in which they are preferred."""
    yield Path(sys.executable)
    for folder in os.get_exec_path():
        found = (
            of for of in Path(folder).glob("python3.*") if re.fullmatch(r"python3\.\d+", of.name)
        )
        yield from sorted(found)
    if pyenv := shutil.which("pyenv"):
        root = subprocess.run([pyenv, "root"], capture_output=True, text=True).stdout.strip()
        yield from sorted(Path(root, "versions").glob("*/bin/python3"), reverse=True)


def usable(files: Iterable[Path]) -> dict[tuple[int, int], Path]:
    """Version -> the first interpreter of it that can build a wheel."""
    found: dict[tuple[int, int], Path] = {}
    for file in files:
        said = subprocess.run([file, "-c", ASK], capture_output=True, text=True)
        if said.returncode:
            continue  # pyenv has such files for versions that it does not run here
        name, major, minor, *lacks = said.stdout.strip().split("|")
        version = int(major), int(minor)
        if name != "cpython" or version < oldest() or version in found:
            continue
        if lacks:
            print(f"pyworm: no wheel for {file}: it has no {', no '.join(lacks)}", file=sys.stderr)
            continue
        found[version] = file
    return found


if __name__ == "__main__":
    print(*(file for _, file in sorted(usable(candidates()).items())))
