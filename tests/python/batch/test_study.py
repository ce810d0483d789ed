"""Studies from Python: a table of scenes, kept, resumed, by several processes, identified by content."""

import json
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from contacts import ball

import pyworm
from pyworm.batch.scene_task import SceneTask, content_digest
from pyworm.materials.body import Body
from pyworm.result.labelled_sweep import labelled

STEEL = Body.from_name("16MnCr5")


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
    labelled = study.dataset
    assert labelled.film_central.dims == ("load", "speed")
    assert labelled.film_central.sel(load=40, speed=0.5) == films[2]
    assert labelled.film_central.attrs == {"units": "m", "long_name": "central film thickness"}
    assert labelled["load"].attrs["units"] == "N" and not study.solutions
    errors = study.table["film_central_error"].values * films
    assert labelled.film_central_error.values.ravel() == pytest.approx(errors)
    assert labelled.accurate.dtype == bool and labelled.accurate.all()
    assert set(labelled.status.values.ravel()) == {"accurate"}


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
    assert isinstance(curve, pyworm.SweepResult)
    assert curve.dataset.slide_roll_ratio.values.tolist() == [0.02, 0.1]
    low, high = (one.figures.friction_coefficient for one in curve.solutions)
    assert [one.slide_roll_ratio for one in curve.solutions] == [0.02, 0.1]
    assert high > low
    assert pyworm.plots.draw_traction(curve.result).axes
    centre = (
        one.fields["entrainment_x"].sel(x=0, y=0, method="nearest") for one in curve.solutions
    )
    assert [float(of) for of in centre] == [1.0, 1.0]


def table_of(**columns):
    rows = {
        "converged": [1.0, 1.0, 0.0],
        "accurate": [1.0, 0.0, 0.0],
        "kind": ["point", "point", ""],
    }
    made = {name: ("scene", np.array(values, dtype=object if name in TEXTS else float))
            for name, values in (rows | columns).items()}  # fmt: skip
    return xr.Dataset(made)


TEXTS = "kind", "stop_reason"


def test_failed_and_missing_points_are_nan_with_a_status():
    """Of two phases at two loads one did not converge, and one carries no load."""
    table = table_of(
        load=[1, 1, 2], phase=[0.1, 0.5, 0.5], film_min_m=[3.0, 4.0, 5.0],
        film_min_error=[0.1, 0.1, 0.1], temperature_max_C_film=[60.0, 70.0, 80.0],
        temperature_max_error_K_film=[1.0, 2.0, 3.0], stop_reason=["", "", "lost"],
    )  # fmt: skip
    table["load"].attrs["units"] = "kN"
    found = labelled(table, [["load"]])
    assert found.film_min.dims == ("load", "phase")
    nan = float("nan")
    assert found.film_min.values == pytest.approx(np.array([[3, 4], [nan, nan]]), nan_ok=True)
    assert found.film_min_error.values[0].tolist() == pytest.approx([0.3, 0.4])
    assert found.temperature_max_film.values[0].tolist() == pytest.approx([333.15, 343.15])
    assert found.temperature_max_film_error.values[0].tolist() == [1.0, 2.0]
    status = [["accurate", "converged"], ["not in the sweep", "no solution"]]
    assert found.status.values.tolist() == status
    assert found.stop_reason.values.tolist() == [["", ""], ["", "lost"]]
    assert found.converged.values.tolist() == [[True, True], [False, False]]
    assert found["load"].attrs["units"] == "kN"


def test_names_that_vary_together_stand_along_one_dimension():
    table = table_of(load=[1, 2, 2], speed=[1, 2, 3])
    found = labelled(table, [["load", "speed"]])
    assert found.sizes == {"point": 3} and found.speed.dims == ("point",)
    crossed = labelled(table, [["load"], ["speed"]])
    assert crossed.sizes == {"load": 2, "speed": 3}


def test_designs_fill_their_ranges():
    ends = {"load": (10, 80), "speed": ("0.5 m/s", "2 m/s")}
    for method in ("sobol", "latin-hypercube"):
        drawn = pyworm.draw(method, 8, seed=3, logarithmic=("load",), **ends)
        assert drawn == pyworm.draw(method, 8, seed=3, logarithmic=("load",), **ends)
        octaves = np.floor(8 * np.log(np.array(drawn["load"]) / 10) / np.log(8))
        assert sorted(octaves) == list(range(8))
        speeds = np.array([float(speed.removesuffix(" m/s")) for speed in drawn["speed"]])
        assert sorted(np.floor((speeds - 0.5) / 1.5 * 8)) == list(range(8))
    study = pyworm.sweep(contact, together={"load": drawn["load"][:2], "speed": (0.5, 1)}, **HOW)
    assert study.axes == [["load", "speed"]] and study.dataset.film_min.dims == ("point",)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: pyworm.draw("sobol", 6, load=(1, 2)), "must be a power of two .*such as 8"),
        (lambda: pyworm.draw("random", 8, load=(1, 2)), "must be one of sobol, latin-hypercube"),
        (lambda: pyworm.draw("sobol", 8), "give the ranges of names"),
        (lambda: pyworm.draw("sobol", 8, load=(2, 1)), "must be two ends that rise"),
        (lambda: pyworm.draw("sobol", 8, load=(0, 1), logarithmic=["load"]), "rise and above zero"),
        (lambda: pyworm.draw("sobol", 8, load=("1 N", "2 m")), "the least and the largest"),
        (lambda: pyworm.draw("sobol", 8, load=3), "the least and the largest value"),
        (lambda: pyworm.sweep(contact, together={"load": (1, 2), "speed": (1,)}, **HOW),
         "together: load has 2 values, speed has 1 values"),
    ],
)  # fmt: skip
def test_what_is_no_design_is_refused(call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call()
