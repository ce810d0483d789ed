"""Fatigue of the layer below asperities: a wavy surface in closed form, limits, loads."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import pyworm
from pyworm.formulas.layered_half_space import Layer, wave_stress
from pyworm.io.plain_dataset import PlainVariable
from pyworm.materials.topography import Topography
from pyworm.solver.stress.asperities import asperity_fatigue
from pyworm.surfaces.asperity_stress import asperity_layer
from pyworm.surfaces.generated import gaussian

STEEL = pyworm.Body(210e9, 0.3)
STRENGTH = pyworm.FatigueStrength("900 MPa", "520 MPa")
MODULUS = 210e9 / 0.91


def test_a_wave_of_pressure_in_closed_form():
    """sigma_zz = -(1 + k z) p exp(-k z) cos k x, sigma_xz = -k z p exp(-k z) sin k x (Johnson, 13.2)."""
    x = np.linspace(0, 1, 32, endpoint=False)
    wave = np.cos(2 * np.pi * x)[:, None] + np.zeros((1, 8))
    solid = Layer(1.0, (1.0, 1.0), (0.3, 0.3))
    found = wave_stress((5 + wave, 0 * wave, 0 * wave), (1 / 32, 1 / 8), solid, 0.1)
    kz = 2 * np.pi * 0.1
    assert found[2] == pytest.approx(-(1 + kz) * np.exp(-kz) * wave, abs=1e-9)
    sine = np.sin(2 * np.pi * x)[:, None] + np.zeros((1, 8))
    assert found[4] == pytest.approx(-kz * np.exp(-kz) * sine, abs=1e-9)


def test_a_wavy_counterface_in_partial_contact():
    """Westergaard's contact of a sine (Johnson, 13.2): half the pressure of full contact touches by half."""
    x = np.linspace(0, 1e-4, 64, endpoint=False)
    height = 1e-8 * np.cos(2 * np.pi * x / 1e-4)[:, None] + np.zeros((1, 8))
    cell = Topography(height, (1e-4 / 64, 1e-4 / 8), periodic=True)
    full = np.pi * MODULUS * 1e-8 / (2 * 1e-4)
    layer = asperity_layer(cell, full / 2, STEEL, STRENGTH, MODULUS, friction=0.0)
    assert layer.area == pytest.approx(0.5, abs=0.04)
    assert layer.pressure_max == pytest.approx(np.sqrt(2) * full, rel=0.01)
    # between a sine of that pressure in full contact, p/e, and a lone line contact, p/4
    assert 0.15 * layer.pressure_max < layer.ratio.max() * 520e6 < layer.pressure_max / np.e


ROUGH = gaussian(0.3e-6, 20e-6, 1.0, 3)
CELL = Topography(ROUGH.height[:64, :64], ROUGH.spacing, periodic=True)


def test_softer_material_fails_sooner():
    layer = asperity_layer(CELL, 200e6, STEEL, STRENGTH, MODULUS)
    assert 0 < layer.area < 1 and layer.ratio.argmax() < 6
    lower = replace(STRENGTH, bending_limit=450e6, torsion_limit=260e6)
    assert asperity_layer(CELL, 200e6, STEEL, lower, MODULUS).safety < layer.safety
    with pytest.raises(ValueError, match="mean_pressure"):
        asperity_layer(CELL, -1.0, STEEL, STRENGTH, MODULUS)


def test_asperities_of_a_solved_contact():
    bodies = replace(STEEL, fatigue=STRENGTH), replace(STEEL, topography=CELL)
    scene = SimpleNamespace(bodies=bodies, boundary_friction=0.1)
    pressed = PlainVariable(("x",), np.array([0.0, 1e8]), {})
    fields = {"asperity_pressure": pressed}
    solution = SimpleNamespace(name="rough", dataset=lambda part: fields)
    layer = asperity_fatigue(solution, scene, 1)
    assert layer.pressure_max > 1e8 and layer.safety > 0
    with pytest.raises(ValueError, match="has no fatigue limits"):
        asperity_fatigue(solution, scene, 2)
    fields.clear()
    with pytest.raises(ValueError, match="roughness was not simulated"):
        asperity_fatigue(solution, scene, 1)
    scene.bodies = (bodies[0], STEEL)
    with pytest.raises(ValueError, match="has no surface point by point"):
        asperity_fatigue(solution, scene, 1)
