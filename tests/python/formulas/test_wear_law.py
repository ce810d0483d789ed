"""Wear laws: both forms, and the roughness that running in leaves."""

import itertools

import numpy as np
import pytest

from pyworm.formulas.wear_law import (
    WHEEL_HARDNESS,
    WORM_HARDNESS,
    archard_depth,
    energy_coefficient,
    harder_ratio,
    truncated_roughness,
)


def test_both_forms_of_the_law_wear_as_much():
    """mu p s/e_R is k p s with k = mu/e_R."""
    pressure, path, friction, energy = 80e6, 2e3, 0.1, 1e13
    k = energy_coefficient(energy, friction)
    assert archard_depth(k, pressure, path) == pytest.approx(friction * pressure * path / energy)
    assert archard_depth(7e-18, 100e6, 1e4) == pytest.approx(7e-6)


def test_summits_that_are_worn_off_leave_what_a_sample_leaves():
    """A million normal heights cut at a level, for three levels."""
    heights = np.random.default_rng(7).normal(0, 0.5e-6, 1_000_000)
    for level in (1.0e-6, 0.3e-6, -0.2e-6):
        cut = np.minimum(heights, level)
        removed = (heights - cut).mean()
        assert truncated_roughness(0.5e-6, removed, 0.0) == pytest.approx(cut.std(), rel=3e-3)


def test_roughness_falls_to_that_of_a_run_in_flank_and_no_further():
    depths = np.linspace(0, 5e-6, 60)
    heights = [truncated_roughness(0.5e-6, depth, 0.6) for depth in depths]
    assert heights[0] == 0.5e-6 and heights[-1] == pytest.approx(0.3e-6)
    assert all(after <= before for before, after in itertools.pairwise(heights))
    assert truncated_roughness(0.5e-6, 1e-3, 0.6) == pytest.approx(0.3e-6)


def test_what_is_no_wear_coefficient_is_refused():
    with pytest.raises(ValueError, match="wear coefficient = 7 m2/N"):
        archard_depth(7.0, 1e8, 1.0)


def test_a_worm_of_hardened_steel_loses_below_a_twentieth_of_its_bronze_wheel():
    """Rabinowicz's square of the hardnesses; by hardness alone it would be more than that."""
    squared = harder_ratio(WORM_HARDNESS, WHEEL_HARDNESS)
    assert squared == pytest.approx((95 / 680) ** 2, rel=0.02)
    assert squared < 0.05 < harder_ratio(WORM_HARDNESS, WHEEL_HARDNESS, 1.0)
    assert harder_ratio(2e9, 2e9) == 1
    with pytest.raises(ValueError, match="harder surface"):
        harder_ratio(1e9, 2e9)
