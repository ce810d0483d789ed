"""Commands load what they use: modules that take long to load cost those that need them only."""

import subprocess
import sys

import pytest
from folders import CASES

WORM = ("pyworm.drives.worm.drive", "pyworm.drives.worm.teeth")
"""The worm drive; the names of its profiles, which `pyworm new` asks for, are in a room below these."""

SLOW = ("dask", "matplotlib", "pandas", *WORM, "scipy.optimize", "xarray")

PROGRAM = """
import sys
from pyworm.cli.main import main
try:
    main(sys.argv[2:])
except SystemExit:
    pass
print(*(name for name in sys.argv[1].split(",") if name in sys.modules), file=sys.stderr)
"""


def loaded(*command):
    """Which of the slow modules a command loads."""
    program = [sys.executable, "-c", PROGRAM, ",".join(SLOW), *command]
    run = subprocess.run(program, capture_output=True, text=True, check=True)
    return run.stderr.split("\n")[-2].split()


def test_help_loads_none():
    assert loaded("--help") == []


@pytest.mark.parametrize(
    ("name", "slow"), [("point_m20_l10", []), ("roller_ref", ["scipy.optimize"])]
)
def test_a_check_loads_neither_results_nor_pictures(name, slow):
    """Nor drives of other kinds. Shares of loads among rollers are roots that SciPy finds."""
    assert loaded("check", str(CASES / f"{name}.toml")) == slow


@pytest.mark.parametrize(("pictures", "slow"), [("none", []), ("key", ["matplotlib"])])
def test_a_contact_is_solved_written_and_drawn_without_xarray(tmp_path, pictures, slow):
    case, options = CASES / "point_m20_l10.toml", ("--accuracy", "20%", "--pictures", pictures)
    assert loaded("run", str(case), *options, "--out", str(tmp_path)) == slow
