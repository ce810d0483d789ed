"""Fields in results files have the accuracy of their figures, and no more digits than that."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED
from pyworm.result.result import open_result
from pyworm.result.rounded_fields import (
    MAX_RELATIVE_ROUNDING,
    OF_ERROR_BAR,
    OF_GIVEN,
    is_rounded,
    rounded,
    to_digits,
)

CASE = """
title = "Ball on a disc"
source = "none"
accuracy = "10 %"
contact = { kind = "point-contact", radii = ["10 mm", "10 mm"], load = "20 N" }
motion = { velocity_1 = ["1.2 m/s", "0 m/s"], velocity_2 = ["0.8 m/s", "0 m/s"] }
bodies.body_1 = { youngs_modulus = "207 GPa", poisson_ratio = 0.3 }
bodies.body_2 = { youngs_modulus = "120 GPa", poisson_ratio = 0.35 }
oil.name = "VG 100"
oil.viscosity = { law = "roelands", eta0 = "0.09 Pa s", alpha = "20 1/GPa" }
oil.density = { law = "dowson-higginson", rho0 = "870 kg/m^3" }
"""


@given(arrays(np.float32, 9, elements=st.floats(width=32)), st.integers(1, 22))
def test_rounding_is_to_the_nearest_number_of_so_many_digits(values, digits):
    found = to_digits(values, digits)
    kept = np.isfinite(values) & (np.abs(values) >= np.finfo(np.float32).tiny)
    exponent = np.floor(np.log2(np.abs(values[kept], dtype=float)))
    spacing = 2.0 ** (exponent - digits)
    largest = 2.0**128 - 2.0 ** (127 - digits)
    inside = np.abs(values[kept]) < largest  # beyond it there is no number to go to
    off = np.abs(found[kept].astype(float) - values[kept])
    assert (off[inside] <= spacing[inside] / 2).all()
    steps = found[kept][inside] / spacing[inside]
    assert (steps == np.round(steps)).all()
    assert np.array_equal(to_digits(found, digits), found, equal_nan=True)


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """A run with all digits, and its directory."""
    directory = tmp_path_factory.mktemp("full")
    (directory / "ball.toml").write_text(CASE)
    words = ["run", str(directory / "ball.toml"), "--out", str(directory / "out")]
    assert main([*words, "--fields", "full", "--pictures", "none"]) == CONVERGED
    return words, open_result(directory / "out" / "result.nc")


def test_fields_change_by_a_tenth_of_the_error_bar_at_most(solved):
    (solution,) = solved[1].solutions
    assert not is_rounded(solution)
    found = rounded(solution)
    figures = solution.figures
    allowed = {
        "pressure": figures.pressure_max.error,
        "film": figures.film_min.error,
        "gap": OF_GIVEN / OF_ERROR_BAR,
    }
    for name, error in allowed.items():
        exact, stored = (of.fields[name].values.astype(float) for of in (solution, found))
        change = np.abs(stored - exact)[exact > 0] / exact[exact > 0]
        limit = min(OF_ERROR_BAR * error, MAX_RELATIVE_ROUNDING)
        assert limit / 5 < change.max() <= limit
    heated = {"temperature_middle": figures.temperature_max_film}
    for name, figure in heated.items() if figures.temperature_max_film else ():
        change = np.abs(found.fields[name] - solution.fields[name]).max()
        assert float(change) <= OF_ERROR_BAR * figure.bar
    assert found.fields["x"].identical(solution.fields["x"])
    assert found.figures == solution.figures
    assert rounded(found) == found


def test_a_solution_that_did_not_converge_keeps_all_digits(solved):
    lost = replace(solved[1].solutions[0], converged=False)
    assert rounded(lost) == lost


def test_a_run_rounds_and_all_digits_are_solved_for_again(solved, tmp_path, capsys):
    words, full = solved
    words = [*words[:-1], str(tmp_path), "--pictures", "none"]
    assert main(words) == CONVERGED
    file = tmp_path / "result.nc"
    assert (
        open_result(file)
        .solutions[0]
        .fields["film"]
        .identical(rounded(full.solutions[0]).fields["film"])
    )
    small = file.stat().st_size
    capsys.readouterr()
    assert main(words) == CONVERGED
    assert "1 of 1 contacts were solved before" in capsys.readouterr().err
    assert main([*words, "--fields", "full"]) == CONVERGED
    assert "solved before" not in capsys.readouterr().err
    assert not is_rounded(open_result(file).solutions[0])
    assert small < file.stat().st_size / 2
    # what has more digits than wanted serves
    assert main(words) == CONVERGED
    assert "1 of 1 contacts were solved before" in capsys.readouterr().err


def test_pictures_are_drawn_by_name_and_an_unknown_one_is_refused(solved, tmp_path, capsys):
    file = solved[1].save(tmp_path / "result.nc")
    assert main(["plot", str(file), "--pictures", "film,regimes"]) == CONVERGED
    assert {path.name for path in tmp_path.glob("*.png")} == {"scene_000_film.png", "regimes.png"}
    assert main(["plot", str(file), "--pictures", "film,foam"]) == BAD_INPUT
    assert "has no picture 'foam', it has key, all, gap, pressure, film" in capsys.readouterr().err
    assert main(["plot", str(file)]) == CONVERGED
    assert not (tmp_path / "scene_000_pressure.png").exists()


def test_scenes_of_a_sweep_with_fields_are_rounded(tmp_path):
    (tmp_path / "ball.toml").write_text(CASE)
    (tmp_path / "sweep.toml").write_text(
        'title = "t"\ncase = "ball.toml"\neffects = "isothermal"\nvary = [{ "contact.load" = ["20 N"] }]\n'
    )
    out = tmp_path / "out"
    assert main(["sweep", str(tmp_path / "sweep.toml"), "--fields", "--out", str(out)]) == CONVERGED
    (file,) = (out / "scenes").glob("*.nc")
    assert is_rounded(open_result(file).solutions[0])


def test_the_case_of_this_test_is_one_of_a_film_with_an_error_bar(solved):
    summary = json.loads(json.dumps(solved[1].solutions[0].summary()))
    assert 0 < summary["film_min_error"] < 0.1
    assert pyworm.__version__
