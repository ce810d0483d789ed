"""Invariants of stress tensors against eigenvalues by LAPACK and against simple states."""

import numpy as np
import pytest

from pyworm.formulas.stress_invariants import (
    max_shear_stress,
    principal_stresses,
    tresca,
    von_mises,
)


def tensors(stress):
    """Components along the first axis as matrices."""
    xx, yy, zz, xy, xz, yz = stress
    return np.moveaxis(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), (0, 1), (-2, -1))


def test_principal_stresses_are_eigenvalues():
    stress = np.random.default_rng(1).normal(size=(6, 200))
    exact = np.linalg.eigvalsh(tensors(stress))[:, ::-1].T
    assert principal_stresses(stress) == pytest.approx(exact, abs=1e-12)
    first, second, third = exact
    assert tresca(stress) == pytest.approx(first - third, abs=1e-12)
    assert max_shear_stress(stress) == pytest.approx((first - third) / 2, abs=1e-12)
    size = np.sqrt(((first - second) ** 2 + (second - third) ** 2 + (third - first) ** 2) / 2)
    assert von_mises(stress) == pytest.approx(size, abs=1e-12)


@pytest.mark.parametrize(
    ("stress", "equivalent", "shear"),
    [
        ((-3, 0, 0, 0, 0, 0), 3, 1.5),
        ((0, 0, 0, 0, 2, 0), 2 * 3**0.5, 2),
        ((-5, -5, -5, 0, 0, 0), 0, 0),
        ((0, 0, 0, 0, 0, 0), 0, 0),
    ],
    ids=["tension", "shear", "hydrostatic", "none"],
)
def test_simple_states(stress, equivalent, shear):
    stress = np.array(stress, dtype=float)
    assert float(von_mises(stress)) == pytest.approx(equivalent)
    assert float(max_shear_stress(stress)) == pytest.approx(shear)
