"""Time integration of wear: exact where it is known, steps by their error, stopped and gone on with."""

import subprocess
import sys
import time

import numpy as np
import pytest

from pyworm.batch.wear_integration import UnsolvedError, Worn, first_step, integrate_wear

SLOW = np.array([[1.0, 0.5], [0.2, 0.0]]) * 1e-6
"""Rate of a flank as cut [m/h]."""


def rates(depth):
    """Rate that falls as the flank conforms: r0 exp(-d/5 um), d = 5 um ln(1 + r0 t/5 um)."""
    return SLOW * np.exp(-depth / 5e-6)


def worn_exactly(hours):
    return 5e-6 * np.log1p(SLOW * hours / 5e-6)


def begun(tolerance):
    return Worn(0.0, np.zeros((2, 2)), SLOW, first_step(SLOW, tolerance))


def test_a_rate_that_stays_is_worn_exactly():
    found = integrate_wear(begun(1e-7), 100.0, lambda depth: SLOW, 1e-7)
    assert found.hours == 100
    assert found.depth == pytest.approx(SLOW * 100, rel=1e-12)


@pytest.mark.parametrize("tolerance", [1e-7, 0.5e-7])
def test_depth_follows_the_closed_form(tolerance):
    found = integrate_wear(begun(tolerance), 200.0, rates, tolerance)
    assert found.depth == pytest.approx(worn_exactly(200.0), rel=0.03)


def test_half_the_steps_change_the_depth_by_less_than_3_percent():
    """A quarter of the tolerance halves the steps of a rule of second order."""
    counts, depths = [], []
    for tolerance in (1e-7, 0.25e-7):
        ends = []
        found = integrate_wear(
            begun(tolerance), 200.0, rates, tolerance, lambda w, e, ends=ends: ends.append(w)
        )
        counts.append(len(ends))
        depths.append(found.depth)
    assert 1.6 * counts[0] < counts[1] < 3 * counts[0]
    assert depths[1].max() == pytest.approx(depths[0].max(), rel=0.03)


def test_steps_keep_their_tolerance():
    errors = []
    integrate_wear(begun(1e-7), 200.0, rates, 1e-7, lambda worn, error: errors.append(error))
    assert max(errors) <= 1e-7
    assert len(errors) > 5


def test_a_part_of_the_depth_may_be_allowed_beside_the_tolerance():
    """Steps grow with the depth, and the whole stays by the closed form."""
    steps = {0.0: [], 0.02: []}
    for relative, ends in steps.items():
        found = integrate_wear(
            begun(0.25e-7), 400.0, rates, 0.25e-7, lambda w, e, to=ends: to.append((w, e)),
            relative=relative,
        )  # fmt: skip
        assert found.depth == pytest.approx(worn_exactly(400.0), rel=0.02)
    assert len(steps[0.02]) < 0.7 * len(steps[0.0])
    assert max(error for _, error in steps[0.02]) > 0.25e-7
    assert all(error <= 0.25e-7 + 0.02 * worn.depth.max() for worn, error in steps[0.02])


def test_an_integration_goes_on_as_if_it_had_not_been_stopped():
    ends = []
    whole = integrate_wear(begun(1e-7), 50.0, rates, 1e-7, lambda worn, error: ends.append(worn))
    again = integrate_wear(ends[2], 50.0, rates, 1e-7)
    assert again.depth == pytest.approx(whole.depth, rel=1e-12)


STOPPED = """
import sys, time
import numpy as np
from pathlib import Path
from pyworm.batch.wear_integration import Worn, integrate_wear
from pyworm.io.atomic import whole_file

file = Path(sys.argv[1])
rate = np.full((3, 3), 1e-6)

def keep(worn, error):
    with whole_file(file) as aside, aside.open("wb") as out:
        np.savez(out, hours=worn.hours, depth=worn.depth, rate=worn.rate, step=worn.step)
    print(worn.hours, flush=True)

def rates(depth):
    time.sleep(0.1)
    return rate * np.exp(-depth / 5e-6)

integrate_wear(Worn(0.0, np.zeros((3, 3)), rate, 0.2), 1e6, rates, 1e-7, keep)
"""


def test_killing_an_integration_loses_one_step_at_most(tmp_path):
    file = tmp_path / "wear.npz"
    with subprocess.Popen(
        [sys.executable, "-c", STOPPED, str(file)], stdout=subprocess.PIPE, text=True
    ) as process:
        told = [float(process.stdout.readline()) for _ in range(4)]
        time.sleep(0.03)
        process.kill()
        told += [float(line) for line in process.stdout.read().split()]
    with np.load(file) as held:
        # the file is written before it is told; a step may be kept that was not
        assert float(held["hours"]) >= told[-1]
        begin = Worn(float(held["hours"]), held["depth"], held["rate"], float(held["step"]))
    found = integrate_wear(
        begin, begin.hours + 5, lambda depth: np.full((3, 3), 1e-6) * np.exp(-depth / 5e-6), 1e-7
    )
    assert found.depth.max() == pytest.approx(5e-6 * np.log1p(found.hours / 5), rel=0.03)


def test_a_rate_that_is_not_known_is_no_step():
    """Comparisons with NaN are false, so that its error would pass as small enough."""
    kept = []

    def rates(depth):
        return np.where(depth > 5e-6, np.nan, 1e-7)

    start = Worn(0.0, np.array([0.0, 1e-6, 0.0]), np.full(3, 1e-7), 40.0)
    with pytest.raises(UnsolvedError, match="not known in 1 of 3 cells"):
        integrate_wear(start, 100.0, rates, 1e-6, lambda worn, error: kept.append(worn))
    assert 4e-6 < kept[-1].depth.max() <= 5e-6
    assert np.isfinite(kept[-1].depth).all()
    with pytest.raises(UnsolvedError, match="not known in 2 of 3 cells"):
        integrate_wear(
            Worn(0.0, np.zeros(3), np.array([1.0, np.nan, np.inf]), 1.0), 1.0, rates, 1e-6
        )


def test_a_step_whose_contacts_cannot_be_solved_is_tried_shorter():
    """A flank that is solved up to a depth: steps shorten up to it, then the reason is told."""
    kept = []

    def rates(depth):
        if depth.max() > 5e-6:
            raise UnsolvedError("phase 0.8 did not converge")
        return np.full(3, 1e-7)

    with pytest.raises(UnsolvedError, match=r"phase 0\.8"):
        start = Worn(0.0, np.zeros(3), np.full(3, 1e-7), 40.0)
        integrate_wear(start, 100.0, rates, 1e-6, lambda worn, error: kept.append(worn))
    assert 4e-6 < kept[-1].depth.max() <= 5e-6
