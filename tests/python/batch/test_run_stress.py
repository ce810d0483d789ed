"""Stress below the surfaces of the contacts of a run."""

from dataclasses import replace

from synthetic_solution import make_solution

import pyworm
from pyworm.batch.run_stress import stressed_run


def test_a_film_that_did_not_converge_has_no_stress(tmp_path):
    solution = replace(make_solution(points=(33, 33)), converged=False)
    result = pyworm.Result("ball", {}, (solution,), None, {})
    found = stressed_run(result, [], tmp_path)
    assert found.solutions[0].figures.stress is None
    assert (tmp_path / "result.nc").is_file()
