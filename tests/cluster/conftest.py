"""Sweeps for jobs, a Slurm for all tests, and the table of a run without either."""

import os
import sys
import tempfile
from pathlib import Path

import pytest
from slurm import running_slurm, why_not

from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.result.sweep_result import open_sweep

ROOT = Path(__file__).parents[2]

SWEEP = f"""
title = "Friction of a ball on a disc"
case = "{ROOT}/cases/traction_steel.toml"
effects = "isothermal"
fixed = {{ accuracy = "10 %" }}
vary = [{{ "contact.load" = ["20 N", "30 N", "40 N"] }}]
"""

TIMED = ["seconds", "convolutions"]
"""Columns of a table that differ from run to run."""


@pytest.fixture
def study(tmp_path):
    """A directory with a sweep, the current one; jobs find pyworm and what tests use."""
    (tmp_path / "study.toml").write_text(SWEEP)
    before = Path.cwd()
    os.chdir(tmp_path)
    yield tmp_path
    os.chdir(before)


@pytest.fixture(scope="session")
def alone(tmp_path_factory):
    """The table of the sweep, solved by this process."""
    folder = tmp_path_factory.mktemp("alone")
    (folder / "study.toml").write_text(SWEEP)
    assert main(["sweep", str(folder / "study.toml"), "--out", str(folder / "out")]) == CONVERGED
    return table(folder / "out")


def table(out):
    """The table of a sweep without what differs from run to run."""
    return open_sweep(out / "sweep.nc").table.drop_vars(TIMED)


@pytest.fixture(scope="session")
def slurm():
    """Environment of a Slurm of one node with two processors."""
    if reason := why_not():
        pytest.skip(reason)
    with tempfile.TemporaryDirectory(prefix="slurm") as folder:
        programs = Path(sys.executable).parent
        with running_slurm(Path(folder), 2) as environment:
            yield environment | {"PATH": f"{programs}:{environment['PATH']}"}
