"""Memory is estimated before it is asked for: what will not fit is refused, what was reached is kept."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from folders import CASES

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import FAILED, NOT_CONVERGED
from pyworm.kernel.core import KernelError
from pyworm.planning.model import Model
from pyworm.solver import memory

CASE = CASES / "point_m20_l10.toml"

MEASURE = """
import sys
from pathlib import Path
import pyworm
from pyworm.planning.grid import Grid
from pyworm.solver.point import level
from pyworm.solver.newton import newton_step
from pyworm.planning.model import Model
from pyworm.solver.point.contact import PointContactSolver
from pyworm.scene.scales import scales
from dataclasses import replace

def peak():
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith("VmHWM"))

def solved(nodes):
    base = plan.grids[-1]
    grid = Grid(base.west, base.south, *(base.dx * 64 / (nodes - 1),) * 2, nodes, nodes)
    solver = PointContactSolver(scene, plan)
    first = level.first_level(scene, scene, scales(scene), grid)
    solver._shear_and_warm(first, first.state())
    newton_step(first), newton_step(first)
    solver.outcome(first)

scene = pyworm.load(sys.argv[1]).scene(slide_roll_ratio=0.5)
plan = replace(pyworm.plan(scene, 0.05, "all"), model=Model(int(sys.argv[2]), sys.argv[3] == "heated"))
solved(65)
before = peak()
solved(321)
print(peak() - before)
"""
"""What a film takes, of a fresh process and beyond all that a small one took."""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="needs Linux's /proc")
@pytest.mark.parametrize(("levels", "heated"), [(0, False), (5, False), (7, True)])
def test_the_estimate_is_what_a_film_takes(levels, heated):
    case = CASE.with_name("traction_steel.toml")
    arguments = [str(case), str(levels), "heated" if heated else "cold"]
    ended = subprocess.run(
        [sys.executable, "-c", MEASURE, *arguments], capture_output=True, text=True, check=True
    )
    assert int(ended.stdout) == pytest.approx(memory.needed(321**2, Model(levels, heated)), rel=0.3)


def test_oil_that_stores_heat_takes_two_arrays_a_level_more():
    model = Model(7, True)
    more = memory.needed(100, model, stores=True) - memory.needed(100, model)
    assert more == pytest.approx(
        memory.MEMORY_SAFETY_FACTOR * memory.NUMBER_BYTES * 2 * (7 + 1) * 100
    )
    assert memory.needed(100, Model(7, False), stores=True) == memory.needed(100, Model(7, False))


def test_a_finer_grid_beyond_memory_ends_the_grid_sequence(monkeypatch):
    scene = pyworm.load(CASE).scene()
    plan = replace(pyworm.plan(scene, 1e-4, "isothermal"), wider_grids=())
    enough = memory.needed(3 * plan.grids[-1].finer().nodes, plan.model)
    monkeypatch.setattr(memory, "available", lambda: enough)
    solution = pyworm.solve(scene, plan)
    assert solution.converged and not solution.accurate
    assert solution.figures.film_min.value > 0
    reached = solution.fields.sizes
    finer = f"{2 * reached['x'] - 1} x {2 * reached['y'] - 1} nodes take "
    assert f": {finer}" in solution.stop_reason
    fits = [int(word) for word in solution.stop_reason.rpartition(" has ")[2].split(" x ")]
    assert memory.needed(fits[0] * fits[1], plan.model) <= enough
    assert fits[0] > reached["x"] and fits[1] > reached["y"]


def test_a_wider_window_beyond_memory_ends_the_grid_sequence(monkeypatch):
    scene = pyworm.load(CASE).scene()
    plan = pyworm.plan(scene, 0.001, "isothermal")
    *_, wider = plan.wider_grids
    # at first there is enough: others take the memory while the narrow window is solved
    free = iter([memory.needed(2 * wider.nodes, plan.model)])
    scarce = memory.needed(wider.nodes // 2, plan.model)
    monkeypatch.setattr(memory, "available", lambda: next(free, scarce))
    solution = pyworm.solve(scene, plan)
    assert not solution.converged
    size = " x ".join(map(str, wider.shape))
    assert solution.stop_reason.startswith(f"{size} nodes take")
    assert "GB of memory" in solution.stop_reason


def test_first_grids_beyond_memory_are_refused(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(memory, "available", lambda: 1e6)
    scene = pyworm.load(CASE).scene()
    with pytest.raises(
        KernelError, match=r"0\.001 GB are free; the largest such grid that fits has"
    ):
        pyworm.solve(scene, pyworm.plan(scene, 0.01))
    assert main(["run", str(CASE), "--out", str(tmp_path / "out")]) == FAILED
    assert "GB of memory" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_scene_without_memory_costs_no_other(tmp_path, monkeypatch, capsys):
    asked = []

    def only_at_first():
        asked.append(1)
        return 1e6 if len(asked) == 1 else float("inf")

    monkeypatch.setattr(memory, "available", only_at_first)
    monkeypatch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
    command = ["run", str(CASE.with_name("traction_steel.toml")), "--accuracy", "30%"]
    command += ["--effects", "isothermal", "--slide-roll-ratio", "0", "1"]
    assert main([*command, "--out", str(tmp_path / "out")]) == NOT_CONVERGED
    assert "could not be solved" in capsys.readouterr().out


def test_free_memory_is_estimated():
    assert memory.available() > 1e6
