"""Ten tasks of a script's author, each as one would write it with public names."""

import numpy as np
import pytest
from contacts import ball, motions

import pyworm

HOW = {"accuracy": 0.2, "effects": "isothermal", "quantities": ("film",), "progress": False}


def test_1_a_contact_in_six_statements():
    body = pyworm.Body.from_name("16MnCr5")
    oil = pyworm.named_oil("PAO VG 220").oil(333.15)
    pair = pyworm.RigidMotion(1.1, 0), pyworm.RigidMotion(0.9, 0)
    gap = pyworm.Paraboloid("10 mm", "10 mm")
    scene = pyworm.Scene(
        name="ball", gap=gap, load="30 N", motions=pair, bodies=(body, body), oil=oil
    )
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy="10 %"))
    assert solution.converged
    assert solution.figures.film_min.value == pytest.approx(1.69e-7, rel=0.05)


def test_2_a_gap_of_ones_own():
    def barrel(x, y):
        return x**2 / 0.02 + y**2 / 0.02 + 1e4 * y**4, abs(y) < 0.5e-3

    scene = ball(gap=barrel, radii=(0.01, 0.01))
    own, round_ = (
        pyworm.solve(one, pyworm.plan(one, 0.1, "isothermal")).figures.film_min
        for one in (scene, ball())
    )
    assert own.value > 0
    assert own.value != round_.value


def test_3_an_oil_of_ones_own():
    def viscosity(pressure, temperature):
        return 0.05 * np.exp(18e-9 * pressure - 0.03 * (temperature - 313.15))

    law = pyworm.TabulatedViscosity.of(viscosity, 313.15)
    oil = pyworm.Oil(law, pyworm.Density.dowson_higginson(860.0))
    barus = pyworm.Oil(pyworm.Barus(0.05, 18e-9), pyworm.Density.dowson_higginson(860.0))
    own, closed = (
        pyworm.solve(one, pyworm.plan(one, 0.1)).figures.film_central
        for one in (ball(oil=oil), ball(oil=barus))
    )
    assert own.value == pytest.approx(closed.value, rel=1e-4)


def test_4_a_study_of_twenty_scenes_as_a_table_in_eight_lines():
    def contact(load, speed):
        return ball(load=load, motions=motions(0.0, speed))

    loads, speeds = np.geomspace(10, 80, 5), (0.3, 0.6, 1.2, 2.4)
    study = pyworm.sweep(contact, load=loads, speed=speeds, **HOW)
    frame = study.table[["load", "speed", "film_min_m"]].to_dataframe()
    assert len(frame) == 20
    assert study.converged.all()
    assert frame.sort_values("film_min_m").iloc[0].tolist()[:2] == pytest.approx([80, 0.3])


def test_5_friction_by_ones_own_sum():
    scene = ball()
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.1))
    fields = solution.fields
    pressure = fields["pressure"].values
    counted = (fields["covered"].values == 1) & (pressure > 0.01 * pressure.max())
    cell = float(fields["x"].diff("x").mean() * fields["y"].diff("y").mean())
    force = fields["shear_stress_x"].values[counted].astype(float).sum() * cell
    figure = solution.figures.friction_coefficient.on_grid
    assert abs(force) / solution.load == pytest.approx(figure, rel=2e-3)


def test_6_a_dry_contact_beside_hertz():
    scene = ball()
    dry = pyworm.dry_contact(scene)
    hertz = pyworm.formulas.hertz.hertz(*scene.radii, scene.load, scene.reduced_modulus)
    assert dry.pressure_max == pytest.approx(hertz.pressure_max, rel=2e-3)


def test_7_two_oils_compared():
    mineral, glycol = (
        ball(oil=pyworm.named_oil(f"{stock} VG 220").oil(333.15)) for stock in ("mineral", "PAG")
    )
    both = pyworm.compare(*(pyworm.solve(one, pyworm.plan(one, 0.1)) for one in (mineral, glycol)))
    assert both.ratios["friction_coefficient"] < 0.7
    assert "friction_coefficient" in both.differ


def test_8_a_result_kept_and_opened_again(tmp_path):
    solution = pyworm.solve(ball(), accuracy=0.2, effects=("isothermal", "-real-gap"))
    file = solution.save(tmp_path / "ball.nc")
    assert pyworm.open_solution(file) == solution
    figures = pyworm.open_result(file).solutions[0].figures
    assert dict(figures)["film_min"] == solution.figures.film_min
    row = figures.to_dict()
    assert row["film_min"] == figures.film_min.value
    assert row["film_min_error"] == figures.film_min.error
    assert row["dry_pressure_max"] == figures.dry.pressure_max
    assert pyworm.write_vtk(solution, tmp_path / "ball.vti").stat().st_size > 10_000


def test_9_a_mistake_is_told_in_a_sentence():
    with pytest.raises(ValueError, match=r'did you mean "207\.0 GPa"') as caught:
        pyworm.Body(207, 0.3)
    assert "\n" not in str(caught.value)


def test_10_a_fortran_program_is_there_to_copy():
    """Built and run in test_fortran_library.py; its contact is this one by closed form."""
    hertz = pyworm.formulas.hertz.hertz(0.01, 0.01, 50.0, 230e9)
    assert hertz.pressure_max == pytest.approx(1085.65e6, rel=1e-4)
