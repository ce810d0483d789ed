"""Commands load what they use: modules that take long to load cost those that need them only."""

import subprocess
import sys
from pathlib import Path

import pytest

CASES = Path(__file__).parents[3] / "cases"

SLOW = ("dask", "matplotlib", "pandas", "scipy.optimize", "xarray")

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
    return subprocess.run(program, capture_output=True, text=True, check=True).stderr.split()


def test_help_loads_none():
    assert loaded("--help") == []


@pytest.mark.parametrize("name", ["point_m20_l10", "roller_ref"])
def test_a_check_loads_neither_results_nor_pictures(name):
    """Roots of contacts' shapes and shares of loads are SciPy's."""
    assert loaded("check", str(CASES / f"{name}.toml")) == ["scipy.optimize"]
