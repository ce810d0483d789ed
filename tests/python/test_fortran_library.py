"""The kernel in Fortran and C programs: the examples, built with the compilers and without Python.

Their films are those of the package within errors; on the same grid to rounding (`test_same_grid.py`).
"""

import re
import shutil
import subprocess
import sys
from functools import cache

import pytest
from folders import ROOT
from linked_programs import EXAMPLES, LIBRARY, ONE_THREAD, run

import pyworm

IN_C = ROOT / "examples/c/point_from_c.c"


def numbers(text):
    return [float(number) for number in re.findall(r"\d+\.\d+", text)]


def test_the_dry_contact_is_hertz(linked):
    pressure, hertz, approach, closed, load = numbers(linked(EXAMPLES / "dry_hertz.f90"))
    assert pressure == pytest.approx(hertz, rel=1e-3)
    assert approach == pytest.approx(closed, rel=1e-3)
    assert load == pytest.approx(50.0, rel=1e-6)


def test_a_thermal_point_contact_is_that_of_python(linked):
    printed = linked(EXAMPLES / "thermal_point.f90")
    film, pressure, friction, rise = map(float, re.findall(r"\d\.\d+E[-+]\d+", printed))
    figures = in_python(sliding=0.2, stress=5e6)
    assert film == pytest.approx(figures.film_min.value, rel=0.05)
    assert pressure == pytest.approx(figures.pressure_max.value, rel=0.05)
    assert friction == pytest.approx(float(figures.friction_coefficient), rel=0.05)
    assert 0 < rise < 1.05 * float(figures.temperature_max_film - 333.15)


def test_a_c_program_solves_the_film_of_python(linked):
    film, pressure, by_grid, by_window = numbers(linked(IN_C))
    figures = in_python(sliding=0.0, stress=None)
    assert film == pytest.approx(figures.film_min.value * 1e9, rel=0.05)
    assert 0 < by_grid + by_window < 10
    assert pressure == pytest.approx(figures.pressure_max.value / 1e6, rel=0.05)


OK, INACCURATE = 0, 8


BALL = ROOT / "tests/fortran/library/ball.f90"


@cache
def ball_in_python(alpha):
    """Films [nm] of the ball of `ball.f90`, M 19, by the package, incompressible."""
    steel = pyworm.Body(230e9 * 0.91, 0.3)
    scene = pyworm.Scene(
        name="ball",
        gap=pyworm.Paraboloid(0.01, 0.01),
        load=6.3,
        motions=(pyworm.RigidMotion(1, 0),) * 2,
        bodies=(steel, steel),
        oil=pyworm.Oil(pyworm.Barus(0.04, alpha), pyworm.Density(850.0, 0.0, 0.0)),
    )
    figures = pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal")).figures
    return figures.film_min.value * 1e9, figures.film_central.value * 1e9


@pytest.mark.parametrize(
    ("nodes", "reach", "alpha", "status", "coarsening"),
    [
        (65, 3.0, 31.5e-9, INACCURATE, 1),  # L 17.6; the window takes 3 %
        (129, 1.8, 31.5e-9, INACCURATE, 1),  # and here 11 %
        (129, 4.2, 31.5e-9, OK, 1),
        (257, 3.0, 31.5e-9, INACCURATE, 1),
        (257, 5.0, 31.5e-9, OK, 1),
        (513, 3.0, 31.5e-9, INACCURATE, 1),
        (257, 4.2, 50e-9, INACCURATE, 2),  # L 28: the spike has no film on the given grid
    ],
)
def test_a_film_comes_with_errors_that_hold_it(linked, nodes, reach, alpha, status, coarsening):
    said = linked(BALL, nodes, reach, 0, alpha)
    got, coarser, least, central, *errors, read_least, load = map(float, said.split())
    assert (got, coarser) == (status, coarsening)
    by_grid, by_window = errors[:2], errors[2]
    for film, error, wanted in zip((least, central), by_grid, ball_in_python(alpha), strict=True):
        off = 100 * abs(film - wanted) / wanted
        assert off < error + by_window + 0.3  # that of the package
        assert error + by_window < 3 * off + 1
    assert read_least == pytest.approx(least, rel=2e-3)  # interpolated from a coarser grid
    assert load == pytest.approx(1.0, rel=1e-3)


def test_the_error_of_a_single_grid_is_not_known(linked):
    got, _, _, _, error, *_ = map(float, linked(BALL, 34, 5, 0.6e-9, 31.5e-9).split())
    assert got == INACCURATE
    assert error > 1e300


def in_python(sliding, stress):
    """Figures of the examples' contact by the package, in a window that ends farther out."""
    density, viscosity = pyworm.Density.dowson_higginson(850.0), pyworm.Roelands(0.04, 0.6)
    heat = pyworm.OilHeat(333.15, 1.1, 0.14, 2000.0, expansivity=7e-4)
    flow = None if stress is None else pyworm.FlowLaw("eyring", stress=stress)
    oil = pyworm.Oil(viscosity, density, flow, None if stress is None else heat)
    # 2/E' = 2 (1 - nu^2)/E
    steel = pyworm.Body(230e9 * 0.91, 0.3, 7850.0, 47.0, 3.7e6 / 7850.0, 333.15)
    scene = pyworm.Scene(
        name="ball",
        gap=pyworm.Paraboloid(0.01, 0.01),
        load=20.0,
        motions=(pyworm.RigidMotion(1 + sliding / 2, 0), pyworm.RigidMotion(1 - sliding / 2, 0)),
        bodies=(steel, steel),
        oil=oil,
    )
    effects = "isothermal" if stress is None else "all"
    return pyworm.solve(scene, pyworm.plan(scene, 0.05, effects)).figures


def test_examples_have_forty_lines_at_most():
    sources = [*EXAMPLES.iterdir(), IN_C]
    assert len(sources) > 8
    for source in sources:
        assert len(source.read_text().splitlines()) <= 40, source.name


def test_uses_and_refusals(linked):
    lines = linked(ROOT / "tests/fortran/library/uses.f90").splitlines()
    assert len(lines) == 15
    assert not [line for line in lines if not line.startswith("ok ")]


def test_oils_by_table_and_function_are_those_by_constants_in_c(linked):
    lines = linked(ROOT / "tests/fortran/library/oils.c").splitlines()
    barus, table, function, later, starved = (float(line.split()[-1]) for line in lines)
    assert table == pytest.approx(barus, rel=1e-5)
    assert function == pytest.approx(barus, rel=1e-5)
    assert later != pytest.approx(barus, rel=1e-3)
    assert starved < 0.9 * barus


def test_the_version_is_the_same_everywhere():
    texts = {
        name: (ROOT / name).read_text()
        for name in ("meson.build", "fpm.toml", "fortran/base/version_number.f90")
    }
    found = {name: re.findall(r"\d+\.\d+\.\d+", text)[0] for name, text in texts.items()}
    assert len(set(found.values())) == 1, found


def test_no_library_object_knows_python():
    if not LIBRARY.is_file():
        pytest.skip("an installed package has no library beside its extension")
    assert not re.findall(r" U (Py\w+)", run("nm", LIBRARY))


def test_modules_have_the_prefix():
    """Module files of other programs are not taken for the kernel's, nor their symbols."""
    for source in (ROOT / "fortran").rglob("*.f90"):
        (name,) = re.findall(r"^module (\w+)\s*$", source.read_text(), re.M)
        assert name == "pyworm_" + source.stem.removeprefix("pyworm_")


def test_without_compilers_it_says_what_to_install(tmp_path):
    """A machine with make and Python alone, and nothing that could install the rest."""
    for name in ("Makefile", "pyproject.toml", "meson.build", "tools/setup.sh"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    tools = tmp_path / "bin"
    tools.mkdir()
    for name in ("sh", "make", "id"):
        (tools / name).symlink_to(shutil.which(name))
    (tools / "python3").symlink_to(sys._base_executable)
    built = subprocess.run(
        [tools / "make", "fortran-library"],
        capture_output=True,
        text=True,
        env={"PATH": str(tools)},
        cwd=tmp_path,
    )
    assert built.returncode == 2
    assert "not found" not in built.stderr
    libraries = "pkg-config libfftw3-dev libopenblas-dev"
    assert f"pyworm: install gfortran gcc libc6-dev {libraries}" in built.stderr
    assert "then run make again" in built.stderr


def documented_lines():
    """The lines that the documentation has a program compiled by."""
    text = (ROOT / "docs/reference/fortran.md").read_text()
    block = text.partition("To compile a program:\n\n")[2].partition("\n\n")[0]
    return [line.removeprefix("    ") for line in block.splitlines()]


@pytest.mark.long
def test_the_library_is_built_from_a_bare_clone(tmp_path):
    """make fortran-library, and a program by the documented lines alone."""
    run("git", "clone", "--quiet", ROOT, tmp_path / "clone")
    # without what a virtual environment has added
    bare = {**ONE_THREAD, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
    bare.pop("LD_LIBRARY_PATH", None)
    installed = tmp_path / "installed"
    built = subprocess.run(
        ["make", "fortran-library", f"PREFIX={installed}"],
        capture_output=True,
        text=True,
        env=bare,
        cwd=tmp_path / "clone",
    )
    assert built.returncode == 0, built.stderr
    assert not re.findall(r" U (Py\w+)", run("nm", "-D", installed / "lib/libpyworm.so"))
    exported = {
        line.split()[-1]
        for line in run("nm", "-D", "--defined-only", installed / "lib/libpyworm.so").splitlines()
    }
    interface = re.compile("pyworm_|__pyworm_contact_(MOD_pyworm_|description_MOD_)")
    assert not [name for name in exported if not interface.match(name)]
    shutil.copy(EXAMPLES / "dry_hertz.f90", tmp_path / "program.f90")
    lines = [line.replace("/opt/pyworm", str(installed)) for line in documented_lines()]
    assert len(lines) == 3
    printed = run("sh", "-euc", "\n".join(lines), env=bare, cwd=tmp_path)
    assert numbers(printed)[0] == pytest.approx(1085.65, rel=1e-3)
