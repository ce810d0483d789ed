"""Inputs with their uncertainty, and files of fitted values, in a case."""

import pytest
from folders import ROOT

import pyworm
from pyworm.case.uncertain_inputs import best_estimates

RIG = (ROOT / "cases/film_rig.toml").read_text()


def rig(tmp_path, **replaced):
    """The rig with some texts replaced: old -> new."""
    text = RIG
    for old, new in replaced.values():
        assert old in text
        text = text.replace(old, new, 1)
    (tmp_path / "rig.toml").write_text(text)
    return tmp_path / "rig.toml"


def test_best_estimates_are_used_and_uncertainties_kept(tmp_path):
    case = pyworm.load(
        rig(
            tmp_path,
            load=('load = "20 N"', 'load = "20 N +- 5 %"'),
            z=("z = 0.35", 'z = "0.35 ± 0.02"'),
            warm=('"60 degC"', '"60 degC +- 2 K"'),
        )
    )
    exact = pyworm.load(ROOT / "cases/film_rig.toml")
    assert case.physics == exact.physics and not exact.uncertain.values
    found = case.uncertain.values
    assert found["contact.load"].standard == pytest.approx(1.0)
    assert found["oil.viscosity.z"].standard == pytest.approx(0.02)
    moved = case.uncertain.moved(case.content, "oil.heat.inlet_temperature", -1)
    assert moved["oil"]["heat"]["inlet_temperature"] == "58 degC"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("20 N +- 1 s", 'must be in a unit of the same kind as "N"'),
        ("20 N +- -1 N", "must be zero or more"),
        ("20 N +- much", '"much": must be a quantity'),
    ],
)
def test_an_uncertainty_of_another_kind_is_refused(tmp_path, text, sentence):
    path = rig(tmp_path, load=('load = "20 N"', f'load = "{text}"'))
    with pytest.raises(pyworm.CaseError) as refused:
        pyworm.load(path)
    assert f'contact.load = "{text}"' in str(refused.value) and sentence in str(refused.value)


def test_texts_are_no_inputs():
    content = {"title": "5 +- 1 balls", "published": {"film": "1 um +- 0.1 um"}}
    data, uncertain = best_estimates(content)
    assert data == content and not uncertain.values


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "source is missing"),
        ('source = "a fit"', "values is missing"),
        ('source = "a fit"\n[values]', "values"),
        ('source = "a fit"\n[values]\n"oil.zz" = 1', "oil.zz: no such key"),
        (
            'source = "a fit"\ncorrelation = [[1.0]]\n[values]\n"oil.viscosity.z" = 0.2\n'
            '"contact.load" = "20 N"',
            "must be a table of 2 rows and columns",
        ),
        (
            'source = "a fit"\ncorrelation = [[1, 0.9], [-0.9, 1]]\n[values]\n"oil.viscosity.z" = 0.2\n'
            '"contact.load" = "20 N"',
            "correlation: must be symmetric",
        ),
    ],
)
def test_a_bad_file_of_fitted_values_is_refused(tmp_path, text, sentence):
    (tmp_path / "fit.toml").write_text(text)
    path = rig(tmp_path, title=('title = "', 'fitted = "fit.toml"\ntitle = "'))
    with pytest.raises(pyworm.CaseError) as refused:
        pyworm.load(path)
    print(refused.value)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_fitted_names_a_file(tmp_path):
    for name, sentence in (("3", "must be the name of a file"), ('"none.toml"', "no such file")):
        path = rig(tmp_path, title=('title = "', f'fitted = {name}\ntitle = "'))
        with pytest.raises(pyworm.CaseError, match=sentence):
            pyworm.load(path)
