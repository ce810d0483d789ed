"""Files of measurements: what they hold, and what is refused."""

import re
from math import hypot, sqrt

import pytest
from folders import CASES, ROOT

from pyworm.case.dotted_keys import value_at
from pyworm.case.experiment import read_experiment, read_experiments
from pyworm.io.input_error import CaseError
from pyworm.io.toml import read_toml

VALIDATION = ROOT / "validation"

BALL = """
title = "Ball"
case = "ball.toml"
[source]
author = "N. N."
year = 2001
title = "Films"
bibliography = "nn-2001"
licence = "numbers only"
[reading]
how = "table"
standard = "1 %"
basis = "digits"
[measurement]
half_width = "3 %"
basis = "stated"
[[inputs]]
keys = ["contact.load"]
standard = "1 %"
basis = "assumed here"
assumed = true
[[rows]]
label = "centre"
quantity = "film_central"
value = "206 nm to 212 nm"
"""

OIL = BALL.replace('case = "ball.toml"\n', "").replace(
    "[[rows]]",
    '[oils.A]\nbase = "mineral"\ntemperatures = ["40 degC", "100 degC"]\neta = ["0.1 Pa s", "0.01 Pa s"]\n'
    '[[rows]]\noil = "A"\ntemperature = "40 degC"',
)


def read(text, folder):
    path = folder / "ball.toml"
    path.write_text(text)
    return read_experiment(path)


def test_the_uncertainty_of_a_row_joins_measurement_reading_and_scatter(tmp_path):
    experiment = read(BALL, tmp_path)
    found = experiment.measured(experiment.rows[0])
    assert found.value == pytest.approx(209e-9)
    parts = 0.01 * 209e-9, 0.03 * 209e-9 / sqrt(3), 3e-9 / sqrt(3)
    assert found.standard == pytest.approx(hypot(*parts), rel=1e-12)


@pytest.mark.parametrize(
    ("text", "old", "new", "words"),
    [
        (BALL, '"numbers only"', '"all rights"', 'source.licence = "all rights": must be'),
        (BALL, 'standard = "1 %"\nbasis = "digits"', 'basis = "digits"', "either standard or half_width"),
        (BALL, '"1 %"\nbasis = "digits"', '"much"\nbasis = "digits"', "must be a quantity"),
        (BALL, '"1 %"\nbasis = "digits"', '"-1 %"\nbasis = "digits"', "zero or more"),
        (BALL, '"1 %"\nbasis = "digits"', '"1 K"\nbasis = "digits"', "rows[0]: its uncertainty"),
        (BALL, '"206 nm to 212 nm"', '"206 N"', "value: must be in a unit of the same kind"),
        (BALL, '"film_central"', '"height"', 'quantity = "height": must be one of film, film_central'),
        (BALL, '"film_central"', '"film"', 'x belongs to quantity = "film"'),
        (BALL, "label =", 'x = "1 um"\nlabel =', 'x belongs to quantity = "film"'),
        (BALL, "label =", "lable =", "lable: no such key; did you mean label"),
        (BALL, 'case = "ball.toml"\n', "", "give either case or oils"),
        (BALL, "[[rows]]", '[[rows]]\noil = "A"', "no effect without [oils]"),
        (OIL, 'oil = "A"', 'oil = "B"', "rows[0].oil: must be one of A"),
        (OIL, 'temperature = "40 degC"', "", "rows[0].temperature is missing"),
        (OIL, 'oil = "A"', 'oil = "A"\nplace = { phase = 0.5 }', "no effect with [oils]"),
        (OIL, 'eta = ["0.1 Pa s", "0.01 Pa s"]', "", "either eta or nu"),
    ],
)  # fmt: skip
def test_a_file_is_refused_in_one_sentence(tmp_path, text, old, new, words):
    assert old in text
    with pytest.raises(CaseError, match=re.escape(words)) as refused:
        read(text.replace(old, new, 1), tmp_path)
    said = str(refused.value)
    assert "\n" not in said and said.startswith(f"{tmp_path / 'ball.toml'}: ")


def test_a_missing_file_says_its_name_once(tmp_path):
    with pytest.raises(CaseError, match="no such file") as refused:
        read_experiment(tmp_path / "none.toml")
    assert str(refused.value).count("none.toml") == 1


@pytest.mark.parametrize("name", read_experiments(VALIDATION))
def test_every_experiment_names_what_the_bibliography_and_its_case_have(name):
    experiment = read_experiment(VALIDATION / f"{name}.toml")
    bibliography = (ROOT / "docs/reference/bibliography.md").read_text()
    assert f'<a id="{experiment.source.bibliography}"></a>' in bibliography
    if experiment.case is None:
        return
    named = isinstance(experiment.case, str)
    content = read_toml(VALIDATION / experiment.case) if named else experiment.case
    for uncertain in experiment.inputs:
        for key in uncertain.keys:
            value_at(content, key)


def test_a_case_of_the_folder_lies_beside_the_shipped_ones():
    assert (VALIDATION / read_experiment(VALIDATION / "mourier_2006.toml").case).resolve() == (
        CASES / "mourier_2006.toml"
    ).resolve()
