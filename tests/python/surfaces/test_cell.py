"""The cell solver against theories of rough surfaces, and what becomes of a topography on the way to it."""

import numpy as np
import pytest
from rough_cells import factors, linear

from pyworm.formulas.flow_factors import pressure_flow_factor, shear_flow_factor
from pyworm.formulas.rough_contact import SELF_AFFINE_LENGTH, SELF_AFFINE_PRESSURE
from pyworm.kernel.core import KernelError
from pyworm.kernel.rough_cell import conduct, press
from pyworm.materials.topography import Topography
from pyworm.surfaces.cell import NODES, common_cell, periodic_cell
from pyworm.surfaces.generated import gaussian, self_affine
from pyworm.surfaces.parameters import slopes

E = 2.0
"""E' = 2 E*, so that pressures are over E*."""


def _truncated(surface, h):
    """Flow factors and shear flow factor of surfaces that overlap where they would touch, isotropic."""
    rms = surface.rms
    gap = np.maximum(h * rms - surface.height, 1e-3 * rms)
    conducted, carried = conduct(gap, surface.spacing)
    return conducted[:2] / (h * rms) ** 3, (gap.mean() - carried[:2]) / rms


@pytest.mark.parametrize("gap", [4.0, 6.0])
def test_wide_gaps_have_tripps_asymptotes(gap):
    """Means of both directions of four surfaces with little skewness: 1 - 1.5/H^2 and 1.5/H to 2 %."""
    found = [_truncated(gaussian(1e-6, 20e-6, seed=seed), gap) for seed in range(4)]
    flow, shear = (np.mean([one[k] for one in found]) for k in (0, 1))
    assert flow == pytest.approx(1 - 1.5 / gap**2, rel=0.02)
    assert shear == pytest.approx(1.5 / gap, rel=0.02 if gap > 4 else 0.06)


def test_surfaces_as_patir_and_cheng_had_them_have_their_factors():
    """Of linear autocorrelation, few nodes in a correlation length: to 5 % from 2 to 4, mean of eight."""
    surfaces = [linear(256, 6, seed) for seed in range(8)]
    for gap in (2.0, 3.0, 4.0):
        flow, shear = (of.mean() for of in factors(surfaces, gap, 1.0)[1.0])
        print(f"H {gap}: {flow / pressure_flow_factor(gap, 1.0) - 1:+.1%}", end=" ")
        print(f"{shear / shear_flow_factor(gap, 1.0) - 1:+.1%}")
        assert flow == pytest.approx(pressure_flow_factor(gap, 1.0), rel=0.05)
        assert shear == pytest.approx(shear_flow_factor(gap, 1.0), rel=0.05)


def test_ridges_along_and_across():
    along = gaussian(1e-6, 20e-6, aspect=3.0, seed=1)
    flow, shear = _truncated(along, 4.0)
    for axis, aspect in ((0, 3.0), (1, 1 / 3)):
        assert flow[axis] == pytest.approx(1 + 3 * (1 - 3 / (1 + aspect)) / 16, abs=0.03)
        assert shear[axis] == pytest.approx(shear_flow_factor(4.0, aspect), rel=0.1)


def test_asperities_press_as_surfaces_rough_on_all_scales_do():
    """Pressure falls e-fold in 0.38 to 0.52 of Rq, area is 1.6 to 2.8 p/(E* h'rms) (Persson 2001, 2007).

    By the closed form's own length pressure is its own where mean planes touch, to a quarter.
    """
    surface = self_affine(1e-6, 0.8, 50e-6, 4e-6, seed=3)
    slope = np.hypot(*slopes(surface))
    separations = np.array([0.8, 1.2, 1.6])
    pressure, area = [], []
    for h in separations:
        p, gap = press(surface.height, surface.spacing, E, h * surface.rms, 1e9, 1e-6 * surface.rms)
        assert gap.mean() == pytest.approx(h * surface.rms, rel=1e-3)
        assert gap.min() > -1e-3 * surface.rms
        pressure.append(p.mean() / slope)
        area.append((p > 0).mean())
    lengths = -np.diff(separations) / np.diff(np.log(pressure))
    print("u0/Rq", lengths, "kappa", np.array(area) / pressure)
    assert np.all((lengths > 0.38) & (lengths < 0.52))
    assert np.all((np.array(area) / pressure > 1.6) & (np.array(area) / pressure < 2.8))
    touching = pressure * np.exp(separations / SELF_AFFINE_LENGTH)
    assert touching == pytest.approx(np.full(3, SELF_AFFINE_PRESSURE), rel=0.25)


def test_pressure_stays_below_the_hardness_and_yielding_opens_the_gap():
    surface = self_affine(1e-6, 0.8, 50e-6, 4e-6, seed=3)
    rms, hardness = surface.rms, 0.05
    elastic, _ = press(surface.height, surface.spacing, E, 0.8 * rms, 1e9, 1e-6 * rms)
    capped, gap = press(surface.height, surface.spacing, E, 0.8 * rms, hardness, 1e-6 * rms)
    assert elastic.max() > 2 * hardness
    assert capped.max() == hardness
    assert capped.mean() < elastic.mean()
    assert (capped > 0).mean() > (elastic > 0).mean()
    assert np.maximum(gap, 0).mean() > 1.005 * 0.8 * rms


def test_senseless_cells_are_refused():
    with pytest.raises(KernelError):
        press(np.zeros((8, 8)), (1.0, 1.0), E, 1.0, -1.0, 1e-6)
    with pytest.raises(KernelError):
        conduct(np.zeros((8, 8)), (1.0, 1.0))


def test_a_cell_is_cut_from_a_larger_area_without_a_seam():
    whole = gaussian(1e-6, 5e-6, seed=2)
    measured = Topography(np.tile(whole.height, (2, 2))[:400, :380], whole.spacing)
    cell = periodic_cell(measured)
    assert cell.periodic
    assert max(cell.height.shape) <= NODES
    assert cell.rms == pytest.approx(measured.rms, rel=1e-12)
    for axis in (0, 1):
        seam = np.abs(np.take(cell.height, 0, axis) - np.take(cell.height, -1, axis)).max()
        inside = np.abs(np.diff(cell.height, axis=axis)).max()
        assert seam < 1.5 * inside
    assert np.hypot(*slopes(cell)) == pytest.approx(np.hypot(*slopes(measured)), rel=0.1)


def test_two_surfaces_add_their_variances():
    first, second = gaussian(1e-6, 20e-6, seed=1), gaussian(0.5e-6, 10e-6, seed=2)
    cell = common_cell((first, second))
    assert cell.rms**2 == pytest.approx(first.rms**2 + second.rms**2, rel=0.05)
    assert cell.extent == pytest.approx(second.extent)


def test_fits_of_patir_and_cheng_hold_where_they_are_used():
    """Means of four surfaces at H = 3, both directions; benchmarks/validation/rough_cells.py has more."""
    found = [_truncated(gaussian(1e-6, 20e-6, seed=seed), 3.0) for seed in range(4)]
    flow, shear = (np.mean([one[k] for one in found]) for k in (0, 1))
    assert flow == pytest.approx(pressure_flow_factor(3.0, 1.0), rel=0.05)
    assert shear == pytest.approx(shear_flow_factor(3.0, 1.0), rel=0.10)
