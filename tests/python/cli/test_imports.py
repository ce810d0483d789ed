"""Commands load what they use: modules that take long to load cost those that need them only."""

import json
import subprocess
import sys

from folders import CASES

WORM = ("pyworm.drives.worm.drive", "pyworm.drives.worm.teeth")
"""The worm drive; the names of its profiles, which `pyworm new` asks for, are in a room below these."""

SLOW = ("dask", "matplotlib", "pandas", *WORM, "scipy.optimize", "xarray")

PROGRAM = """
import json, sys
from pyworm.cli.main import main
for command in json.loads(sys.argv[2]):
    try:
        main(command)
    except SystemExit:
        pass
    print(*(name for name in sys.argv[1].split(",") if name in sys.modules), file=sys.stderr)
"""


def test_commands_load_what_they_use(tmp_path):
    """No results, pictures or drives of other kinds; SciPy finds shares of loads among rollers."""
    point = str(CASES / "point_m20_l10.toml")
    solved = ("run", point, "--accuracy", "20%", "--out", str(tmp_path / "out"), "--pictures")
    drawn = ("run", point, "--accuracy", "20%", "--out", str(tmp_path / "drawn"))
    expected = {
        ("--help",): [],
        ("check", point): [],
        (*solved, "none"): [],
        ("check", str(CASES / "roller_ref.toml")): ["scipy.optimize"],
        drawn: ["matplotlib", "scipy.optimize"],
    }
    program = [sys.executable, "-c", PROGRAM, ",".join(SLOW), json.dumps(list(expected))]
    run = subprocess.run(program, capture_output=True, text=True, check=True)
    loaded = [line.split() for line in run.stderr.splitlines() if not line.startswith("pyworm:")]
    assert dict(zip(expected, loaded, strict=True)) == expected
