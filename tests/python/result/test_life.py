"""Lives of contacts in results: curves, extremes, work of friction, tables, pictures and animations."""

import json
from csv import DictReader
from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from lives import DURATION, life_dataset
from PIL import Image
from swept_cycle import PHASES, cycle_result

import pyworm
from pyworm.batch.case_run import run
from pyworm.batch.task import Task
from pyworm.cli.main import main
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.plots.draw import draw
from pyworm.plots.life_animation import WRITERS
from pyworm.result.life import as_csv, lives
from pyworm.result.result import open_result

FEW = PHASES[2:-2:4]


def film(phases):
    return 1e-6 * (1 + (phases - 0.3) ** 2)


def lively(of=FEW):
    """A cycle whose solutions hold the stretch of the life before each."""
    result = cycle_result(of)
    ends = np.array_split(np.linspace(0, 1, 101), len(of))
    return replace(
        result,
        solutions=tuple(
            replace(
                one, life=life_dataset(at, 400 * np.ones(len(at)), 8e3 * np.ones(len(at)), film(at))
            )
            for one, at in zip(result.solutions, ends, strict=True)
        ),
    )


def test_stretches_make_one_life():
    (life,) = lives(lively())
    assert life.phases == pytest.approx(np.linspace(0, 1, 101))
    assert life.work() == (pytest.approx(400 * DURATION), pytest.approx(4 * DURATION))
    value, error, seconds = life.extreme("film_min")
    assert (value, error, seconds) == pytest.approx((1e-6, 1e-8, 0.3 * DURATION))
    assert life.entrainment == pytest.approx(np.hypot(1, 0.5))
    assert not len(life.gaps)
    summary = life.summary()
    assert summary["instants"] == 101 and summary["friction_work_J"] == pytest.approx(8.0)


def test_a_phase_that_was_not_solved_leaves_a_gap():
    result = lively()
    some = replace(result, solutions=(result.solutions[0], *result.solutions[2:]))
    (life,) = lives(some)
    (gap,) = life.gaps
    assert life.phases[gap] - life.phases[gap - 1] > 0.1


def test_a_result_without_transient_solutions_has_no_life(tmp_path):
    result = cycle_result(FEW)
    assert not lives(result)
    file = result.save(tmp_path / "result.nc")
    assert main(["plot", str(file), "--animate"]) == 2


def test_the_table_has_all_instants():
    rows = list(DictReader(StringIO(as_csv(lives(lively())))))
    assert len(rows) == 101
    assert float(rows[30]["film_min"]) == pytest.approx(1e-6)
    assert float(rows[30]["film_min_error"]) == pytest.approx(1e-8)
    assert float(rows[30]["seconds"]) == pytest.approx(0.3 * DURATION)


@pytest.mark.long
def test_a_life_is_drawn_and_animated_from_its_file(tmp_path):
    file = lively().save(tmp_path / "result.nc")
    assert lives(open_result(file))[0].figures["film_min"] == pytest.approx(
        film(np.linspace(0, 1, 101))
    )
    names = {path.name for path in draw(file, tmp_path, key_only=True)}
    assert "life.png" in names
    assert main(["plot", str(file), "--animate"]) == 0
    with Image.open(tmp_path / "life.gif") as animation:
        assert animation.n_frames == 3 * len(FEW)
    if not WRITERS["mp4"].isAvailable():
        assert main(["plot", str(file), "--animate", "mp4"]) == 2
        assert not list(tmp_path.glob("*.mp4"))


def test_a_contact_with_a_past_tells_its_figures_over_time(tmp_path, capsys):
    assert main(["run", "cases/reversal_line.toml", "--json", "--out", str(tmp_path)]) in (0, 3)
    told = json.loads(capsys.readouterr().out)
    (life,) = told["lives"]
    assert life["to_s"] == pytest.approx(0.007)
    # the film is thinnest after the surfaces stood still, at 4 ms
    assert 0.004 < life["film_min_m"]["seconds"] < 0.0062
    (of,) = lives(open_result(tmp_path / "result.nc"))
    assert of.entrainment[0] < 0 < of.entrainment[-1]
    assert (tmp_path / "life.csv").read_text().startswith("seconds,phase,load,entrainment,film_min")
    present = told["scenes"][0]
    bar = of.errors["film_min"][-1] + present["film_min_error"] * present["film_min_m"]
    assert abs(of.figures["film_min"][-1] - present["film_min_m"]) <= bar


def test_phases_of_one_life_hold_it_together(tmp_path, monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    case = pyworm.load("cases/spur_pair.toml")
    tasks = [
        Task(case, place, 0.2, ("isothermal", "squeeze"), ("film",))
        for place in case.places(phase=[0.6, 0.65])
    ]
    (life,) = lives(run(case, tasks, tmp_path))
    assert len(life.seconds) == sum(len(one.life["life_seconds"]) for one in life.solutions)
    assert life.phases[-1] > 0.6 and not len(life.gaps)
    assert len(life.frames) > 0.4 * len(life.seconds)
    assert np.isfinite(life.errors["film_min"]).all()
