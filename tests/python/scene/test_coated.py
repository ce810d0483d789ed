"""Reduced modulus of coated bodies: thin, thick and equal layers, and films on them."""

from dataclasses import replace

import pytest

import pyworm
from pyworm.formulas.layered_half_space import Layer


def test_compliance_between_those_of_layer_and_body():
    for thickness, expected in ((1e-3, 0.91 / 200e9), (1e3, 0.96 / 400e9)):
        layer = Layer(thickness, (400e9, 200e9), (0.2, 0.3))
        assert layer.contact_compliance(1.0) == pytest.approx(expected, rel=0.02, abs=0)
    middle = Layer(0.5, (400e9, 200e9), (0.2, 0.3)).contact_compliance(1.0)
    assert 0.96 / 400e9 < middle < 0.91 / 200e9


def test_contacts_feel_a_coating_by_its_thickness():
    scene = pyworm.load("cases/line_m20_l10.toml").scene()
    bare = scene.reduced_modulus

    def coated(thickness, modulus):
        first, second = scene.bodies
        layer = pyworm.Coating(thickness, modulus, first.poisson_ratio)
        return replace(scene, bodies=(replace(first, coating=layer), second)).reduced_modulus

    same = scene.bodies[0].youngs_modulus
    assert coated(1e-5, same) == pytest.approx(bare, rel=1e-6)
    thin, thick = coated(2e-6, 2 * same), coated(20e-6, 2 * same)
    assert bare < thin < thick < 4 / 3 * bare
