"""Studies from Python: a table of scenes, kept, resumed, by several processes, identified by content."""

import json
from dataclasses import replace

import numpy as np
import pytest
from contacts import ball

import pyworm
from pyworm.batch.scene_task import SceneTask, content_digest
from pyworm.materials.body import named_body

STEEL = named_body("16MnCr5")


def contact(load, speed=1.0):
    return ball(
        load=load,
        motions=(pyworm.RigidMotion(1.1 * speed, 0.0), pyworm.RigidMotion(0.9 * speed, 0.0)),
    )


HOW = {"accuracy": 0.2, "effects": "isothermal", "quantities": ("film",), "progress": False}


def test_a_study_is_a_table_of_its_values_crossed():
    study = pyworm.sweep(contact, load=(20.0, 40.0), speed=(0.5, 1.0), **HOW)
    assert study.table["load"].values.tolist() == [20.0, 20.0, 40.0, 40.0]
    assert study.table["speed"].values.tolist() == [0.5, 1.0, 0.5, 1.0]
    assert study.converged.all()
    films = study.table["film_central_m"].values
    alone = pyworm.solve(
        contact(20.0, 0.5), pyworm.plan(contact(20.0, 0.5), 0.2, "isothermal", "film")
    )
    assert films[0] == alone.figures.film_central.value
    assert np.all(films[1::2] > films[::2])
    assert len(study.table.to_dataframe()) == 4


def test_solved_scenes_are_found_again(tmp_path, monkeypatch):
    first = pyworm.sweep(contact, load=(20.0, 40.0), out=tmp_path, **HOW)
    monkeypatch.setattr(SceneTask, "solved", None)  # nothing is to be solved any more
    again = pyworm.sweep(contact, load=(20.0, 40.0), out=tmp_path, **HOW)
    assert again.table.identical(first.table)


def test_lambdas_are_found_again_by_what_they_do(tmp_path):
    for factor in (1.0, 2.0, 1.0):
        pyworm.sweep(
            lambda load, factor=factor: ball(load=load, gap=gap(factor), radii=(0.01, 0.01)),
            load=(20.0,),
            out=tmp_path,
            **HOW,
        )
    assert len(list(tmp_path.rglob("*.json"))) == 2


def gap(factor):
    return lambda x, y: (50 * (x**2 + y**2) + 1e4 * factor * (x**4 + y**4), x == x)


def on_solid(body):
    """A gap that holds a solid as a default, whose line at the prompt leaves digits out."""
    return lambda x, y, body=body: (body.poisson_ratio * (x**2 + y**2), x == x)


def test_content_tells_functions_by_their_code_and_what_they_hold():
    same = content_digest(gap(1.0)), content_digest(gap(1.0))
    assert same[0] == same[1]
    assert content_digest(gap(1.0)) != content_digest(gap(2.0))
    assert content_digest(on_solid(STEEL)) == content_digest(on_solid(STEEL))
    other = replace(STEEL, youngs_modulus=STEEL.youngs_modulus * (1 + 1e-9))
    assert repr(other) == repr(STEEL)
    assert content_digest(on_solid(STEEL)) != content_digest(on_solid(other))
    assert content_digest(ball()) == content_digest(ball())
    assert content_digest(ball()) != content_digest(ball(load=31.0))


def test_two_processes_give_the_same_table(tmp_path):
    alone = pyworm.sweep(contact, load=(20.0, 40.0), **HOW)
    together = pyworm.sweep(contact, load=(20.0, 40.0), processes=2, **HOW)
    assert np.array_equal(alone.table["film_min_m"], together.table["film_min_m"])
    assert alone.table["key"].values.tolist() == together.table["key"].values.tolist()


def test_progress_rises_to_one():
    seen = []
    how = HOW | {"progress": lambda message, share: seen.append(share)}
    pyworm.sweep(contact, load=(20.0, 40.0), **how)
    assert seen == sorted(seen)
    assert seen[-1] > 0.5


def test_a_sweep_file_is_solved_likewise(tmp_path):
    case = "../cases/point_m20_l10.toml"
    (tmp_path / "cases").symlink_to(__file__.split("/tests/")[0] + "/cases")
    file = tmp_path / "loads.toml"
    vary = json.dumps(["20 N", "30 N"])
    file.write_text(
        f'title = "loads"\ncase = "{case[3:]}"\neffects = "isothermal"\n[fixed]\naccuracy = "20 %"\n'
        f'[[vary]]\n"contact.load" = {vary}\n'
    )
    study = pyworm.sweep(file, progress=False)
    assert study.table.sizes["scene"] == 2
    with pytest.raises(ValueError, match="a sweep file says itself what varies"):
        pyworm.sweep(file, load=(1, 2))


def test_a_traction_curve_keeps_the_entrainment(tmp_path):
    curve = pyworm.traction_curve(ball(), (0.02, 0.1), accuracy=0.2, progress=False, out=tmp_path)
    low, high = (one.figures.friction_coefficient for one in curve.solutions)
    assert [one.slide_roll_ratio for one in curve.solutions] == [0.02, 0.1]
    assert high > low
    assert pyworm.plots.draw_traction(curve).axes
    centre = (
        one.fields["entrainment_x"].sel(x=0, y=0, method="nearest") for one in curve.solutions
    )
    assert [float(of) for of in centre] == [1.0, 1.0]
