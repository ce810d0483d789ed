"""`[past]` of contacts written directly."""

import pickle

import pytest
from folders import CASES
from refusals import changed, refusal

import pyworm

LINE = (CASES / "reversal_line.toml").read_text()
BALL = (CASES / "impact_ball.toml").read_text()

DROP = BALL.replace(
    'times = ["0 ms", "1 ms", "1.5 ms", "2 ms", "2.2 ms"]\nload = [1, 1, 10, 1, 1]',
    'times = ["0 ms", "0.2 ms", "0.4 ms"]\nload = [0, 0, 1]\nseparation = ["20 um", "1 um", "1 um"]',
)


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
        for effects in ("auto", ("auto", "-squeeze"))
    )
    for name in ("film_central", "film_min"):
        assert 0.7 < getattr(moving, name).value / getattr(still, name).value < 0.95


@pytest.mark.long
def test_surfaces_come_from_apart_where_their_separation_is_given(tmp_path):
    case = tmp_path / "drop.toml"
    case.write_text(DROP)
    scene = pyworm.load(case).scene()
    then = scene.past.life.at(1e-4)
    assert then.separation == pytest.approx(10.5e-6) and then.load == scene.load
    assert scene.past.life.at(0.3e-3).separation is None
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05))
    assert solution.converged and "squeeze" in {one.name for one in solution.effects if one.on}
    life = solution.life
    apart = life["life_seconds"].values <= 0.2e-3
    assert life["life_film_min"].values[apart] == pytest.approx(
        20e-6 - 95e-3 * life["life_seconds"].values[apart], rel=0.3
    )
    # what a ball presses with as it comes down, whose oil is not viscous enough yet to deform it
    assert (abs(life["life_load"].values[apart][1:]) > life["life_load"].values[apart][:-1]).all()


@pytest.mark.parametrize(
    ("text", "old", "new", "sentence"),
    [
        (LINE, '"0 ms", ', '"1 ms", ', 'past: times begin at "0 s" and rise'),
        (LINE, '"2 ms", "7 ms"', '"7 ms", "2 ms"', 'past: times begin at "0 s" and rise'),
        (LINE, "speed = [-0.6667, -0.6667, 1]", "", "past: give the factors of load, of speed, or"),
        (
            LINE,
            "-0.6667, 1]",
            "1]",
            "past: speed has 2 factors and times 3; one factor per time required",
        ),
        (
            LINE,
            "-0.6667, 1]",
            "-0.6667, 2]",
            "past: speed ends with 2; the last time is the present",
        ),
        (
            BALL,
            "10, 1, 1]",
            "-1, 1, 1]",
            "past: load has a factor of -1; load must not be negative",
        ),
        (BALL, '"2.2 ms"', '"2.2"', 'past.times[4] = "2.2": must be a time with its unit'),
        (BALL, "load = [1, 1", "lode = [1, 1", "past.lode: no such key; did you mean load?"),
        (
            DROP,
            '"1 um"]',
            "]",
            "past: separation has 2 lengths and times 3; one factor per time required",
        ),
        (DROP, "[0, 0, 1]", "[1, 1, 1]", "past: separation holds where the factor of load is 0"),
        (
            DROP,
            '"1 um", "1 um"',
            '"0 um", "1 um"',
            "past: separation is 0 m where the load is zero",
        ),
    ],
)
def test_pasts_that_make_no_sense_are_refused(text, old, new, sentence, tmp_path, capsys):
    case = tmp_path / "case.toml"
    case.write_text(changed(text, (old, new)))
    assert sentence in refusal(["run", str(case)], tmp_path, capsys)
