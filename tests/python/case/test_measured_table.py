"""Attacks on a CSV of measurements and on what is fitted: each is one sentence that says what is right."""

import pytest
from folders import ROOT

import pyworm
from pyworm.batch.calibrate import bench_of
from pyworm.batch.operating_points import Solving
from pyworm.case.measured_table import read_measured
from pyworm.case.parameters import parameters

HEAD = "contact.load [N], film_central [nm], u(film_central) [nm]"


@pytest.fixture(scope="module")
def case():
    return pyworm.load(ROOT / "cases/film_rig.toml")


def written(path, *lines):
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_rows_are_read_in_si(tmp_path):
    file = written(
        tmp_path / "bench.csv",
        "# a comment",
        "motion.velocity_1[0] [m/s], oil.name, phase, temperature_max_film [degC], "
        "u(temperature_max_film) [K], efficiency [%], u(efficiency) [%]",
        "1.5, PAO VG 220, 0.5, 60, 2, 80, 1",
        "2, PAO VG 220, 0.5, , , 81, 1",
    )
    hot, first, second = read_measured(file)
    assert (hot.value, hot.standard) == (pytest.approx(333.15), pytest.approx(2.0))
    assert hot.conditions == {"motion.velocity_1[0]": "1.5 m/s", "oil.name": "PAO VG 220"}
    assert hot.place == {"phase": 0.5} and hot.line == 3
    assert (first.value, second.value) == (pytest.approx(0.8), pytest.approx(0.81))


def test_a_zero_in_degrees_celsius_is_none_in_kelvin(tmp_path):
    head = "contact.load [N], {0} [{1}], u({0}) [{2}]"
    cold = head.format("sump_temperature", "degC", "K")
    (found,) = read_measured(written(tmp_path / "cold.csv", cold, "20, 0, 1"))
    assert found.value == pytest.approx(273.15)
    locked = head.format("efficiency", "%", "%")
    (found,) = read_measured(written(tmp_path / "locked.csv", locked, "20, 0, 1"))
    assert found.value == 0.0


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        ([HEAD], "holds no measurements"),
        (["contact.load [N], film_central [nm]", "20, 100"], "column u(film_central) is missing"),
        (["contact.load [N], u(film_min) [nm]", "20, 3"], "column film_min is missing"),
        (["contact.load [N]", "20"], "no column of a measured quantity"),
        ([HEAD.replace("film_central [nm]", "film_centre [nm]"), "20, 1, 1"], "film_central?"),
        ([HEAD.replace("(film_central)", "(films)"), "20, 1, 1"], "column u(films): no such quantity"),
        ([HEAD.replace("[nm]", "[s]"), "20, 100, 3"], "line 2: film_central = 100 s: must be a film"),
        ([HEAD.replace("[N]", "[N"), "20, 100, 3"], 'heading "contact.load [N"'),
        ([HEAD, "20, nan, 3"], "line 2: film_central = nan: must be a number"),
        ([HEAD, "nan, 100, 3"], "line 2: contact.load = nan: must be a number"),
        ([HEAD, "20, thick, 3"], "line 2: film_central = thick: must be a number"),
        ([HEAD, "20, 100, 0"], "line 2: u(film_central) = 0: must be a standard uncertainty above"),
        ([HEAD, "20, 100, -3"], "must be a film greater than zero"),
        ([HEAD, "20, 100, "], "line 2: u(film_central) = : must be a number"),
        ([HEAD, "20, 100"], "line 2: has 2 cells, the heading has 3"),
        ([HEAD, "20, , 3"], "all cells of measured quantities are empty"),
        ([HEAD, "20, 0, 3"], "line 2: film_central = 0 nm: must be a film greater than zero"),
        ([HEAD, "20, 0,1, 3"], "has 4 cells, the heading has 3; decimals follow a point, not a comma"),
        ([HEAD.replace(",", ";"), "20; 100; 3"], "columns are separated by commas, not by semicolons"),
        ([HEAD, '"20', '", 100, 3'], "line 2: has 1 cells"),
        ([HEAD, "20, 100, 3" + 200_000 * "x"], "field larger than field limit"),
        ([f"{HEAD}, phase, phase", "20, 100, 3, 1, 1"], "column phase is there twice"),
    ],
)  # fmt: skip
def test_a_bad_table_is_refused_in_one_sentence(tmp_path, lines, sentence):
    file = written(tmp_path / "bench.csv", *lines)
    with pytest.raises(pyworm.CaseError) as refused:
        read_measured(file)
    text = str(refused.value)
    print(text)
    assert text.startswith(f"{file}: ") and sentence in text and "\n" not in text


def test_a_file_that_is_none_is_refused(tmp_path):
    with pytest.raises(pyworm.CaseError, match="no such file"):
        read_measured(tmp_path / "bench.csv")
    (tmp_path / "latin.csv").write_bytes(HEAD.encode() + b"\n\xb5\n")
    with pytest.raises(pyworm.CaseError, match="is not in UTF-8"):
        read_measured(tmp_path / "latin.csv")


@pytest.mark.parametrize(
    ("fit", "sentence"),
    [
        ([], "nothing to fit"),
        (["zz"], "zz: the case has no zz; its oil has oil.boundary_friction, oil.density.rho0"),
        (["alpha"], "alpha: the case gives no number for oil.viscosity.alpha"),
        (["limiting_stress"], "limiting_stress: the case has no oil.shear.limit_pressure"),
        (["z", "oil.viscosity.z"], "oil.viscosity.z is to be fitted twice"),
        (["z = 0.2"], 'must be two bounds, such as "z = LOW to HIGH"'),
        (["z = low to high"], "must be numbers without unit"),
        (["z = 0.5 to 0.2"], "must be from a smaller to a larger value above zero"),
        (["z = 0.1 to 0.2"], "must hold the value of the case, 0.35"),
        (["oil.viscosity.eta0 = 1 s to 2 s"], "must be a dynamic viscosity with its unit"),
        (["oil.name"], "oil.name: the case gives no number for oil.name"),
    ],
)  # fmt: skip
def test_what_cannot_be_fitted_is_refused_in_one_sentence(case, fit, sentence):
    with pytest.raises(pyworm.CaseError) as refused:
        parameters(case, fit)
    print(refused.value)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_parameters_have_the_start_and_unit_of_the_case(case):
    modulus, slope = parameters(
        case, ["bodies.body_1.youngs_modulus = 180 GPa to 230 GPa", "roughness_slope"]
    )
    assert modulus.low == pytest.approx(180e9) and modulus.unit == "GPa"
    assert modulus.values(2e11) == {"bodies.body_1.youngs_modulus": "200000000000.0 Pa"}
    assert slope.keys == tuple(f"bodies.body_{n}.roughness_slope" for n in (1, 2))
    assert (slope.start, slope.low, slope.high) == pytest.approx((0.008, 0.0016, 0.04))


@pytest.mark.parametrize(
    ("lines", "fit", "sentence"),
    [
        ([HEAD, "20, 100, 3"], ["z"], "1 measured values cannot fix 1 parameters"),
        ([HEAD, "20, 1, 3", "30, 1, 3"], ["contact.load"], "is to be fitted and given as a condition"),
        ([HEAD.replace("contact.load", "contact.lode"), "20, 100, 3", "30, 100, 3"], ["z"],
         "line 2: contact.lode: no such key; did you mean"),
        ([HEAD.replace("contact.load [N]", "contact.load [s]"), "20, 100, 3", "30, 100, 3"], ["z"],
         'line 2: contact.load = "20 s": must be a force'),
    ],
)  # fmt: skip
def test_measurements_that_do_not_fit_the_case_are_refused(tmp_path, case, lines, fit, sentence):
    file = written(tmp_path / "bench.csv", *lines)
    with pytest.raises(pyworm.CaseError) as refused:
        bench_of(case, file, fit, Solving(tmp_path, 0.05, ("auto",))).expected_seconds  # noqa: B018
    print(refused.value)
    assert sentence in str(refused.value)
