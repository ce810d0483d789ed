"""The cell solver on generated surfaces, means of eight: against Patir and Cheng, Tripp, and Persson.

Flow between Gaussian surfaces that overlap where they would touch, as Patir and Cheng had it; both directions
of isotropic ones, gamma and 1/gamma of ridges. First surfaces as theirs, of a linear autocorrelation and few
nodes in a correlation length; then smooth ones, of a Gaussian autocorrelation. Then the contact of elastic
self-affine surfaces: the factor and the length of its exponential law, and its area slope, between H = 0.6
and 1.8. Run from the repository's root:

    python benchmarks/validation/rough_cells.py
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import scipy

from pyworm.formulas.flow_factors import pressure_flow_factor, shear_flow_factor
from pyworm.kernel.rough_cell import conduct, press
from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import gaussian, self_affine
from pyworm.surfaces.parameters import slopes

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

SURFACES = 8
GAPS = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0)
ASPECTS = (1.0, 3.0)
LINEAR = (256, 6), (256, 12), (512, 24)
"""Nodes a side and in the length over which the autocorrelation falls to zero."""
WIDE = (4.0, 6.0, 8.0, 12.0)
"""Gaps for the approach to Tripp's asymptotes, which have an error of the order H^-2."""

FLOOR = 1e-2
"""Gap over the roughness that remains where surfaces overlap."""

MODULUS = 2.0
"""E' = 2 E*: pressures are over E*."""


FACTORS = (
    "gamma",
    "H",
    "phi",
    "phi deviation",
    "phi Patir and Cheng",
    "difference of phi",
    "phi Tripp",
    "difference of phi from Tripp",
    "Phi_s",
    "Phi_s deviation",
    "Phi_s Patir and Cheng",
    "difference of Phi_s",
    "Phi_s Tripp",
    "difference of Phi_s from Tripp",
)
"""Columns of flow factors: means, standard deviations from surface to surface, theories and differences."""


def main():
    rows = []
    for nodes, length in LINEAR:
        surfaces = [linear(nodes, length, seed) for seed in range(SURFACES)]
        for gap in GAPS[:-1]:
            for gamma, (flow, shear) in factors(surfaces, gap, 1.0).items():
                rows.append((nodes, length, *row(gamma, gap, flow, shear)))
    record("rough_cells_linear", ("nodes", "nodes in a length", *FACTORS), rows)
    rows = []
    for aspect in ASPECTS:
        surfaces = [gaussian(1e-6, 20e-6, aspect, seed) for seed in range(SURFACES)]
        for gap in GAPS:
            rows += [row(gamma, gap, *of) for gamma, of in factors(surfaces, gap, aspect).items()]
    record("rough_cells_gaussian", FACTORS, rows)
    approach()
    rows = []
    for hurst in (0.5, 0.8):
        found = np.array([contact(hurst, seed) for seed in range(SURFACES)])
        mean, spread = found.mean(axis=0), found.std(axis=0)
        rows.append((hurst, *(f"{m:.3f} ± {s:.3f}" for m, s in zip(mean, spread, strict=True))))
    lengths = "e-folding length / Rq", "area slope A_r E* h'rms/p_a"
    record("elastic_cells", ("Hurst exponent", "p_a/(E* h'rms) at H = 0", *lengths), rows)


def approach():
    """Shear flow above Tripp's asymptote between isotropic Gaussian surfaces, and its part beyond H^-2.

    Each surface counts with its negative, so that skewness by chance falls out.
    """
    above = []
    for gap in WIDE:
        found = []
        for seed in range(SURFACES):
            surface = gaussian(1e-6, 20e-6, seed=seed)
            both = surface, replace(surface, height=-surface.height)
            (_, shear) = factors(both, gap, 1.0)[1.0]
            found.append(shear.mean() * gap / 1.5 - 1)
        above.append((np.mean(found), np.std(found) / SURFACES**0.5))
    rows = [
        (f"{gap:g}", f"{mean:.2%} ± {error:.2%}")
        for gap, (mean, error) in zip(WIDE, above, strict=True)
    ]
    record("shear_flow_asymptote", ("H", "Phi_s above Tripp's 1.5/H"), rows)
    squares = np.array(WIDE[1:]) ** -2.0
    order, left = np.polyfit(squares, [mean for mean, _ in above[1:]], 1)
    print(f"\nfrom {WIDE[1]:g} on {order:.2f}/H^2, and {left:.2%} by the grid that stay")


def linear(nodes, length, seed):
    """A surface of normal heights whose autocorrelation falls linearly along both sides (moving averages).

    N. Patir, Wear 47 (1978) 263, had such surfaces.
    """
    noise = np.random.default_rng(seed).standard_normal((nodes, nodes))
    height = scipy.ndimage.uniform_filter(noise, length, mode="wrap")
    height -= height.mean()
    return Topography(1e-6 * height / height.std(), (1e-6, 1e-6), periodic=True)


def factors(surfaces, gap, aspect):
    """Pressure and shear flow factors of each surface, by the Peklenik number along the flow."""
    found = []
    for surface in surfaces:
        rms = surface.rms
        local = np.maximum(gap * rms - surface.height, FLOOR * rms)
        conducted, carried = conduct(local, surface.spacing)
        found.append((conducted[:2] / (gap * rms) ** 3, (local.mean() - carried[:2]) / rms))
    flow, shear = (np.array([one[k] for one in found]) for k in (0, 1))
    if aspect == 1:
        return {1.0: (flow.mean(axis=1), shear.mean(axis=1))}
    return {aspect: (flow[:, 0], shear[:, 0]), 1 / aspect: (flow[:, 1], shear[:, 1])}


def row(gamma, gap, flow, shear):
    """Texts under `FACTORS`."""
    tripp = 1 + 3 * (1 - 3 / (1 + gamma)) / gap**2, 3 / ((1 + gamma) * gap)
    fits = (
        (pressure_flow_factor(gap, gamma), shear_flow_factor(gap, gamma))
        if gap <= 4
        else (np.nan, np.nan)
    )
    cells = [f"{gamma:.3g}", f"{gap:g}"]
    for values, fit, second in zip((flow, shear), fits, tripp, strict=True):
        own = values.mean()
        cells += [f"{own:.3f}", f"{values.std():.3f}"]
        for theory, holds in ((fit, gap <= 4), (second, gap >= 2)):
            cells += [f"{theory:.3f}", f"{(own / theory - 1) * 100:+.1f} %"] if holds else ["", ""]
    return cells


def contact(hurst, seed):
    """Factor and length of the exponential law, and area slope, of one elastic surface."""
    surface = self_affine(1e-6, hurst, 50e-6, 4e-6, seed=seed)
    rms, slope = surface.rms, np.hypot(*slopes(surface))
    gaps = np.linspace(0.6, 1.8, 7)
    pressure, area = [], []
    for gap in gaps:
        p, _ = press(surface.height, surface.spacing, MODULUS, gap * rms, 1e9, 1e-5 * rms)
        pressure.append(p.mean() / slope)
        area.append((p > 0).mean())
    fall, factor = np.polyfit(gaps, np.log(pressure), 1)
    return np.exp(factor), -1 / fall, np.mean(np.array(area) / pressure)


if __name__ == "__main__":
    main()
