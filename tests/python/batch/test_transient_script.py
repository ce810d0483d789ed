"""Transient contacts from Python: load, motion and radii over time."""

from dataclasses import replace

import numpy as np
import pytest
from contacts import ball, roller
from folders import CASES

import pyworm
from pyworm.batch.scene_task import SceneTask
from pyworm.batch.transient import _history, _times

HOW = {"accuracy": 0.2, "effects": "isothermal", "quantities": ("film",)}
TIMES = (0.0, 1e-3, 2e-3, 3e-3)


@pytest.fixture(scope="module")
def stop():
    """A ball that stops under a load that has risen, on a cam that flattens."""
    return pyworm.transient(
        ball(), TIMES, speed=(0.5, 1, 1, 0), load=("20 N", 30, 30, 30),
        radii=(lambda seconds: 0.01 + seconds, "10 mm"), **HOW,
    )  # fmt: skip


def test_films_over_time_have_names_units_and_uncertainties(stop):
    films = stop.dataset
    assert stop.converged and films.time.values[0] == 0
    assert films.time.values[-1] == pytest.approx(3e-3)
    assert films.film_min.attrs == {"units": "m", "long_name": "minimum film thickness"}
    assert films.film_min_error.attrs["units"] == "m" and films.time.attrs["units"] == "s"
    assert (films.film_min_error > 0).all()
    assert films["load"].values[0] == pytest.approx(20, rel=0.01)
    assert films.entrainment.sel(time=1.5e-3, method="nearest") == pytest.approx(1.0)
    # a film that is left by a stop stays for a while
    assert films.film_min.values[-1] > 0.3 * films.film_min.values.max()
    assert films.entrainment.values[-1] == pytest.approx(1e-3, rel=0.1)
    assert stop.solution.name == "ball" and "TransientResult ball: status" in repr(stop)


STARTED = {0.728: (70.7, 167.1), 0.8: (115.4, 190.5), 0.9: (133.5, 219.5), 1.1: (162.8, 267.2)}
"""Time [ms] -> minimum and central film thickness [nm] of the ball that starts, by the third transient solve
of an accuracy of 2 %: a quarter of the spacing and of the time step."""


@pytest.fixture(scope="module")
def start():
    """A ball that starts from near rest."""
    return pyworm.transient(ball(), (0, "1 ms", "2 ms"), speed=(1e-3, 1, 1), **HOW)


def test_films_that_the_grid_does_not_resolve_are_no_results(start):
    films = start.dataset
    lost = np.isnan(films.film_min.values)
    assert lost[0] and lost.sum() > 5 and not lost[-20:].any()
    for name in ("film_min", "film_central"):
        assert (np.isnan(films[name].values) == lost).all()
        assert (np.isnan(films[f"{name}_error"].values) == lost).all()
        assert (films[name].values[~lost] > 0).all()
    assert np.isfinite(films.pressure_max.values).all()
    (value, error, _) = start.over_time.extreme("film_min")
    assert 0 < value < error
    assert all((frame.film >= 0).all() for frame in start.over_time.frames)


def test_films_next_to_these_are_as_uncertain_as_finer_time_steps_show(start):
    films = start.dataset[["film_min", "film_central", "film_min_error", "film_central_error"]]
    for milliseconds, known in STARTED.items():
        then = films.interp(time=milliseconds * 1e-3)
        for name, value in zip(("film_min", "film_central"), known, strict=True):
            assert abs(then[name] - value * 1e-9) < then[f"{name}_error"]


def test_films_without_any_that_is_resolved_have_no_extreme(start):
    life = start.over_time
    none = replace(life, figures={"film_min": np.full(life.seconds.size, np.nan)})
    assert np.isnan(none.extreme("film_min")[0])


def test_the_present_is_the_last_time_at_which_the_surfaces_move(stop):
    figures = stop.solution.figures
    then = stop.dataset.sel(time=2e-3, method="nearest")
    assert float(then.film_central) == pytest.approx(float(figures.film_central), rel=0.1)


def test_it_is_kept_drawn_and_animated(stop, tmp_path, monkeypatch):
    again = pyworm.open_result(stop.save(tmp_path / "stop.nc"))
    assert pyworm.TransientResult(again).dataset.film_min.equals(stop.dataset.film_min)
    assert (
        stop.plot.history(tmp_path / "stop.png").axes
        and (tmp_path / "stop.png").stat().st_size > 10_000
    )
    animated = []
    monkeypatch.setattr("pyworm.plots.of_transient.animate", lambda *given: animated.append(given))
    stop.animate(tmp_path / "stop.gif")
    (_, life, path) = animated[0]
    assert len(life.frames) > 10 and path.name == "stop.gif"


def test_an_animation_of_another_kind_is_refused(stop, tmp_path):
    with pytest.raises(ValueError, match=r"ends with \.gif or \.mp4"):
        stop.animate(tmp_path / "stop.avi")


@pytest.mark.parametrize("name", ["reversal_line", "impact_ball"])
def test_contacts_are_those_of_the_history_of_a_case_file(name):
    scene = pyworm.load(CASES / f"{name}.toml").scene()
    written = scene.past.life.at
    laws = {"load": written.load, "speed": None, "sliding": None, "separation": None}
    if written.speed is not None:
        scaled = [written.speed(seconds) * 0.46227 for seconds in written.times]
        laws["speed"] = scaled
    history = _history(scene, _times(written.times), laws, None)
    for seconds in (0.0, 0.7e-3, 1.4e-3, 2.2e-3):
        mine, its = history(seconds), written(seconds)
        assert mine.load == its.load
        origin = (0.0,) * len(scene.radii_along)
        assert np.allclose(mine.velocities_at(*origin), its.velocities_at(*origin), rtol=1e-9)
        assert np.allclose(mine.travelled, its.travelled, rtol=1e-2, atol=1e-7)


def test_sliding_and_radii_vary_apart_from_the_entrainment():
    laws = {
        "load": None,
        "speed": [1, 2],
        "sliding": lambda seconds: 4 * seconds,
        "separation": None,
    }
    history = _history(ball(), (0.0, 1.0), laws, ([0.01, 0.03], 0.02))
    then = history(0.5)
    assert then.entrainment(0.0, 0.0)[0] == pytest.approx(1.5)
    assert then.sliding(0.0, 0.0)[0] == pytest.approx(2.0)
    assert then.radii == then.gap.radii == pytest.approx((0.02, 0.02))
    line = _history(roller(), (0.0, 1.0), laws, ([0.01, 0.03],))(0.5)
    assert line.velocities == pytest.approx((2.5, 0.5)) and line.radius == pytest.approx(0.02)
    assert history(1.0).travelled == ((0.0, 0.0), (0.0, 0.0))
    first, second = history(0.5).travelled
    assert first[0] == pytest.approx(-(0.875 + 0.75)) and second[0] == pytest.approx(
        -(0.875 - 0.75)
    )


def test_scenes_of_one_history_share_its_time_grid():
    scene = pyworm.load(CASES / "impact_ball.toml").scene()
    assert SceneTask(scene, 0.2).time_grid.life is scene.past.life


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({}, "nothing varies"),
        ({"load": (1, 2, 3)}, "load has 3 values and times 4"),
        ({"load": (1, 2, 3, -1)}, "load has a value of -1"),
        ({"speed": (1, 2, 3, np.inf)}, "speed: must be finite"),
        ({"speed": 0}, "its surfaces never move under load"),
        ({"load": 0}, "its surfaces never move under load"),
        ({"load": lambda seconds: np.nan}, r"load\(0.001 s\) = nan: must be finite"),
        ({"radii": 0.01}, "radii: must be 2 in a row"),
        ({"radii": (0.01, "1 kg")}, r"radii\[1\]"),
        ({"speed": 1, "effects": ("auto", "-squeeze")}, "without squeeze no film is transient"),
        ({"speed": 1, "times": (1.0, 2.0)}, "must be two or more that begin with 0 and rise"),
        ({"speed": 1, "times": (0.0, 2.0, 1.0)}, "must be two or more that begin with 0 and rise"),
    ],
)
def test_what_is_no_history_is_refused(given, sentence):
    with pytest.raises(ValueError, match=sentence):
        pyworm.transient(ball(), **{**HOW, "times": TIMES, **given})


def test_contacts_whose_motion_or_gap_cannot_vary_are_refused():
    still = ball(motions=(pyworm.RigidMotion(1, 0), pyworm.RigidMotion(-1, 0)))
    with pytest.raises(ValueError, match="have no direction"):
        pyworm.transient(still, TIMES, speed=1, **HOW)
    own = ball(motions=(lambda x, y: (x, y), lambda x, y: (x, y)))
    with pytest.raises(ValueError, match="are no RigidMotion"):
        pyworm.transient(own, TIMES, speed=1, **HOW)
    barrel = ball(gap=lambda x, y: (x**2 + y**2, x < 1), radii=(0.5, 0.5))
    with pytest.raises(ValueError, match="radii vary those of a Paraboloid"):
        pyworm.transient(barrel, TIMES, radii=(1, 1), **HOW)


def test_a_film_that_is_not_found_is_an_error(monkeypatch):
    monkeypatch.setattr("pyworm.solver.transient.transient.integrate_in_time", _no_film)
    with pytest.raises(ValueError, match=r"no transient film \(not found: none at 1 ms\)"):
        pyworm.transient(ball(), TIMES, speed=(0.5, 1, 1, 1), accuracy=0.2, quantities=("film",))


def _no_film(*given):
    raise ValueError("none at 1 ms")
