"""One regime of a contact everywhere, which agrees with the influences in its plan."""

import json
from dataclasses import replace
from math import pi

import numpy as np
import pytest

import pyworm
from pyworm.cli.main import main
from pyworm.formulas.hertz import hertz
from pyworm.planning.effects.geometry import DEFLECTION_FACTOR
from pyworm.planning.effects.rheology import THICKENING_FACTOR
from pyworm.planning.prediction import predicted
from pyworm.result.formula_summary import formula_summary
from pyworm.scene.formula_film import film_of

ELASTIC = [
    ("point_m20_l10", {}),
    ("mourier_2006", {}),
    ("ball_pag_460", {}),
    ("ellipse10_across", {}),
    ("ellipse10_along", {}),
    ("ellipse10_oblique", {}),
    ("zi_sharif_2001", {"phase": 0.5}),
]
"""Shipped contacts of 0.38 to 1 GPa with films of less than their deflection."""


def scene_of(case, place):
    return pyworm.load(f"cases/{case}.toml").scene(**place)


def influences(plan):
    return {effect.name: effect.influence["film"] for effect in plan.effects if effect.influence}


@pytest.mark.parametrize(("case", "place"), ELASTIC)
def test_pressed_contacts_of_steel_and_bronze_are_piezoviscous_elastic(case, place):
    scene = scene_of(case, place)
    assert pyworm.plan(scene).regime.name == "piezoviscous-elastic"


def test_a_ball_hardly_pressed_is_rigid_and_its_deflection_without_influence_on_the_regime():
    """The flattening is a^2/2R of a circle; at a hundredth of the load the bodies are rigid."""
    scene = scene_of("ball_pag_460", {})
    plan = pyworm.plan(scene)
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    flat = contact.semi_axis_x**2 / 2 / scene.radii[0]
    assert plan.regime.deflection == pytest.approx(flat / float(film_of(scene).minimum), rel=1e-4)
    light = replace(scene, load=scene.load / 100)
    assert pyworm.plan(light).regime.name == "isoviscous-rigid"


@pytest.mark.parametrize(("case", "place"), [*ELASTIC, ("line_m20_l10", {}), ("spin_zi_like", {})])
def test_the_regime_is_one_everywhere(case, place):
    scene = scene_of(case, place)
    plan = pyworm.plan(scene)
    regime = predicted(scene).regime
    assert plan.regime == regime
    summary = regime.summary()
    assert formula_summary(scene, plan).items() >= summary.items()
    if isinstance(scene, pyworm.Scene):
        found = film_of(scene)
        assert str(found.regime) == regime.name
        assert found.single_regime() == regime
    judged = {effect.name: effect.indicator for effect in plan.effects}
    if scene.rough_pair is None:  # roughness holds films open, which the regime is not about
        assert judged["elastic-deflection"] == pytest.approx(regime.deflection, rel=1e-4)
    assert judged["pressure-viscosity"] == pytest.approx(regime.thickening, rel=1e-12)


def test_influences_and_regimes_agree_over_loads_speeds_and_shapes():
    base = scene_of("mourier_2006", {})
    names = set()
    for ratio, angle in ((1.0, 0.0), (20.0, 0.3), (20.0, pi / 2)):
        for load in (1e-3, 1e-1, 10.0, 1e3):
            for speed in (1e-5, 0.1, 30.0):
                motion = pyworm.RigidMotion(speed * np.cos(angle), speed * np.sin(angle))
                gap = pyworm.Paraboloid(0.01, 0.01 * ratio)
                scene = replace(base, gap=gap, radii=None, load=load, motions=(motion, motion))
                try:
                    plan = pyworm.plan(scene)
                except ValueError:  # out of all proportion
                    continue
                regime, film = plan.regime, influences(plan)
                names.add(regime.name)
                viscous, elastic = regime.name.split("-")
                assert (elastic == "elastic") == (film["elastic-deflection"] > DEFLECTION_FACTOR)
                hertz_change = scene.oil.eta(predicted(scene).pressure_max) / scene.oil.eta(0.0) - 1
                bound = min(THICKENING_FACTOR * (1 + 1e-9), hertz_change)
                assert (viscous == "piezoviscous") == (film["pressure-viscosity"] > bound)
    assert len(names) == 4


def test_check_film_and_json_have_the_numbers_of_the_regime(capsys):
    assert main(["check", "cases/ball_pag_460.toml"]) == 0
    shown = capsys.readouterr().out
    assert "piezoviscous-elastic" in shown
    assert "deflection over film" in shown and "(elastic above 1)" in shown
    assert main(["film", "cases/ball_pag_460.toml", "--json"]) == 0
    row = json.loads(capsys.readouterr().out)["scenes"][0]
    regime = pyworm.plan(scene_of("ball_pag_460", {})).regime
    assert {key: row[key] for key in regime.summary()} == regime.summary()
