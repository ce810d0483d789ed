"""Films that need no solve: where the formula of the atlas is as accurate as a plan asks for."""

from dataclasses import replace

import numpy as np
import pytest
from contacts import ball, motions

import pyworm
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.planning.by_formula import films_by_formula
from pyworm.result.sweep_result import open_sweep
from pyworm.scene.scales import scales

FILM = ("film",)


def by_formula(scene, accuracy=0.15, effects="auto", quantities=FILM):
    return films_by_formula(scene, pyworm.plan(scene, accuracy, effects, quantities))


def rolling(spin=0.0):
    motion = pyworm.RigidMotion(0.2, 0.0, spin)
    return ball(load=20.0, motions=(motion, motion))


def test_a_film_is_by_formula_where_its_bar_and_what_it_leaves_out_are_within_the_accuracy():
    scene = rolling()
    found = by_formula(scene)
    left = sum(
        of.influence["film"]
        for of in pyworm.plan(scene, 0.15, "auto", FILM).effects
        if of.name in ("shear-thinning", "limiting-stress", "film-heating") and of.influence
    )
    enough = max(found.central_error, found.minimum_error) + left
    assert by_formula(scene, 1.02 * enough) is not None
    assert by_formula(scene, 0.98 * enough) is None
    solved = pyworm.solve(scene, pyworm.plan(scene, 0.02, "auto", FILM)).figures
    assert float(found.central) == pytest.approx(solved.film_central.value, rel=enough)
    assert float(found.minimum) == pytest.approx(solved.film_min.value, rel=enough)


def test_what_a_formula_cannot_give_is_solved():
    scene = rolling()
    assert by_formula(scene) is not None
    rough = tuple(replace(body, roughness=0.2e-6) for body in scene.bodies)
    slips = replace(scene, motions=motions(sliding=1.0, speed=20.0))
    assert by_formula(replace(scene, bodies=rough)) is None
    assert by_formula(slips) is None
    assert by_formula(replace(scene, oil=replace(scene.oil, supply=1e-9))) is None
    assert by_formula(scene, effects="isothermal") is None  # whose numbers are then the user's
    assert by_formula(slips, quantities=("film", "friction")) is None
    assert by_formula(replace(scene, separation=1e-7)) is None


def test_a_sweep_for_films_solves_only_what_the_formula_cannot_give(tmp_path):
    how = {"accuracy": 0.15, "quantities": FILM, "progress": False}
    study = pyworm.sweep(rolling, spin=(0.0, 800.0), **how)
    table = study.table
    assert study.converged.all()
    assert table["formula"].values.tolist() == ["atlas", ""]
    found = pyworm.film_of(rolling())
    assert table["film_central_m"][0] == float(found.central)
    assert table["film_min_error"][0] == float(found.minimum_error)
    assert np.isnan(table["pressure_max_Pa"].values).tolist() == [True, False]
    assert open_sweep(study.save(tmp_path / "sweep.nc")).converged.all()
    whole = pyworm.sweep(rolling, spin=(0.0,), fields=True, **how)
    assert table["film_central_m"][0] != whole.table["film_central_m"][0]
    assert "formula" not in whole.table


def test_expected_films_are_those_of_the_atlas_but_of_contacts_at_rest_and_of_the_most_slender():
    scene = rolling()
    found = pyworm.film_of(scene)
    assert scales(scene).film == float(found.central)
    assert scales(scene).least == float(found.minimum / found.central)
    spin = pyworm.RigidMotion(0.0, 0.0, 20.0)
    needle = replace(scene, gap=pyworm.Paraboloid(0.01, 20.0), radii=(0.01, 20.0))
    for other in (replace(scene, motions=(spin, spin)), needle):
        size = scales(other)
        assert size.film == float(nijenbanning_venner_moes(size.groups).central)
