"""`[past]` of contacts written directly."""

import pickle
from pathlib import Path

import pytest
from refusals import changed, refusal

import pyworm

CASES = Path(__file__).parents[3] / "cases"
LINE = (CASES / "reversal_line.toml").read_text()
BALL = (CASES / "impact_ball.toml").read_text()


def test_loads_and_speeds_are_straight_between_the_times():
    line = pickle.loads(pickle.dumps(pyworm.load(CASES / "reversal_line.toml").scene()))
    assert line.past.seconds == line.past.life.duration == pytest.approx(7e-3)
    for seconds, factor in ((0, -0.6667), (2e-3, -0.6667), (4.5e-3, 0.16665), (7e-3, 1)):
        then = line.past.life.at(seconds)
        assert then.velocities == pytest.approx([factor * of for of in line.velocities])
        assert then.load == line.load
    ball = pyworm.load(CASES / "impact_ball.toml").scene()
    for seconds, factor in ((0.5e-3, 1), (1.25e-3, 5.5), (1.5e-3, 10), (2.1e-3, 1)):
        then = ball.past.life.at(seconds)
        assert then.load == pytest.approx(factor * ball.load)
        assert then.motions == ball.motions


def test_a_film_grows_after_a_reversal_and_its_oil_came_in_slower():
    """The inlet that was an exit has the thin film of the slow oil that has come in since."""
    scene = pyworm.load(CASES / "reversal_line.toml").scene()
    moving, still = (
        pyworm.solve(scene, pyworm.plan(scene, 0.05, effects)).figures
        for effects in ("auto", "auto,-squeeze")
    )
    for name in ("film_central", "film_min"):
        assert 0.7 < getattr(moving, name).value / getattr(still, name).value < 0.95


@pytest.mark.parametrize(
    ("text", "old", "new", "sentence"),
    [
        (LINE, '"0 ms", ', '"1 ms", ', 'past: times begin at "0 s" and rise'),
        (LINE, '"2 ms", "7 ms"', '"7 ms", "2 ms"', 'past: times begin at "0 s" and rise'),
        (LINE, "speed = [-0.6667, -0.6667, 1]", "", "past: give the factors of load, of speed, or"),
        (LINE, "-0.6667, 1]", "1]", "past: speed has 2 factors and times 3; each time wants one"),
        (
            LINE,
            "-0.6667, 1]",
            "-0.6667, 2]",
            "past: speed ends with 2; the last time is the present",
        ),
        (BALL, "10, 1, 1]", "-1, 1, 1]", "past: load has a factor of -1; a contact does not pull"),
        (BALL, '"2.2 ms"', '"2.2"', 'past.times[4] = "2.2": must be a time with its unit'),
        (BALL, "load = [1, 1", "lode = [1, 1", "past.lode: no such key; did you mean load?"),
    ],
)
def test_pasts_that_make_no_sense_are_refused(text, old, new, sentence, tmp_path, capsys):
    case = tmp_path / "case.toml"
    case.write_text(changed(text, (old, new)))
    assert sentence in refusal(["run", str(case)], tmp_path, capsys)
