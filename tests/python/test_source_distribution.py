"""The source distribution is enough: for pip in an empty environment, and for the Fortran library."""

import os
import subprocess
import sys
import tarfile
from pathlib import Path

import mesonpy
import pytest
from folders import ROOT

import pyworm

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(not (ROOT / ".git").exists(), reason="made of what git knows"),
]

SOLVE = """
import pyworm
assert "site-packages" in pyworm.__file__
case = pyworm.load("cases/line_m20_l10.toml")
solution = pyworm.solve(case.scene(), pyworm.plan(case.scene(), 0.05, "isothermal"))
assert solution.converged
print(solution.figures.film_central.value)
"""

ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name not in ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV", "PKG_CONFIG_PATH")
}


def run(*command, **how):
    ended = subprocess.run(
        list(map(str, command)),
        capture_output=True,
        text=True,
        env=ENVIRONMENT | how.pop("env", {}),
        **how,
    )
    assert ended.returncode == 0, ended.stdout[-2000:] + ended.stderr[-2000:]
    return ended.stdout


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    """The distribution as its file."""
    folder = tmp_path_factory.mktemp("made")
    before = Path.cwd()
    os.chdir(ROOT)
    try:
        return folder / mesonpy.build_sdist(folder)
    finally:
        os.chdir(before)


@pytest.fixture(scope="module")
def unpacked(archive, tmp_path_factory):
    """The distribution as a folder."""
    folder = tmp_path_factory.mktemp("unpacked")
    with tarfile.open(archive) as file:
        file.extractall(folder, filter="data")
    (top,) = folder.iterdir()
    return top


def test_pip_installs_it_into_an_empty_environment(archive, unpacked, tmp_path):
    run(sys.executable, "-m", "venv", tmp_path / "empty")
    python = tmp_path / "empty/bin/python"
    run(python, "-m", "pip", "install", "-q", archive)
    there = float(run(python, "-c", SOLVE, cwd=unpacked, env={"PYTHONSAFEPATH": "1"}))
    scene = pyworm.load(ROOT / "cases/line_m20_l10.toml").scene()
    here = pyworm.solve(scene, pyworm.plan(scene, 0.05, "isothermal"))
    assert there == pytest.approx(here.figures.film_central.value, rel=1e-9)


def test_it_builds_the_fortran_library(unpacked, tmp_path):
    prefix = tmp_path / "prefix"
    run("make", "fortran-library", f"PREFIX={prefix}", cwd=unpacked)
    found = {"PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}
    flags = run("pkg-config", "--cflags", "--libs", "pyworm", env=found).split()
    example = unpacked / "examples/fortran/dry_hertz.f90"
    run("gfortran", example, *flags, f"-Wl,-rpath,{prefix / 'lib'}", "-o", tmp_path / "dry")
    assert "nan" not in run(tmp_path / "dry").lower()
