"""Worm wheels of plastics: stiffness at their temperature, limits, and a rating line by line."""

import json
import tomllib
from pathlib import Path

import pytest
from folders import DATA
from refusals import changed
from zi_drives import coarse_patterns, coarse_springs

import pyworm
from pyworm.case.case import case_again, case_of
from pyworm.cli.main import main
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import not_rated, rating_request, ratings
from pyworm.result.headline import opening
from pyworm.scene.scales import scales
from pyworm.solver.newton import iterate
from pyworm.solver.point import contact

DRIVE = (DATA / "worm_rated.toml").read_text()
BRONZE = 'material = "CuSn12Ni2-C-GZ"'
LIGHT = ('wheel_torque = "300 N m"', 'wheel_torque = "60 N m"')


@pytest.fixture(autouse=True, scope="module")
def coarse():
    """Fewer places, phases and loads for patterns and load sharing."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_patterns(patch)
        coarse_springs(patch)
        yield


def case(wheel, *changes):
    text = changed(DRIVE, (BRONZE, wheel), LIGHT, *changes)
    return case_of(tomllib.loads(text), "plastic", Path())


def hot(temperature):
    return ('temperature = "70 degC"', f'temperature = "{temperature} degC"')


def worm(case):
    asked = rating_request(case)
    built = ratings(asked)
    return built[0], not_rated(asked, built)


def test_a_plastic_wheel_is_as_stiff_as_at_its_own_temperature():
    """Bulk temperatures are those of the balance, and the modulus that at these."""
    cold, warm = (case('material = "POM"', hot(t)).drive for t in (40, 80))
    for drive in (cold, warm):
        wheel = drive.bodies[1]
        assert wheel.bulk_temperature > drive.oil.heat.inlet_temperature
        assert any("Young's modulus" in sentence for sentence in drive.all_assumptions)
        assert any("friction of tin bronze, an estimate" in of for of in drive.all_assumptions)
    assert warm.bodies[1].youngs_modulus < 0.65 * cold.bodies[1].youngs_modulus
    pressures = [scales(drive.scene(0.5)).hertz.pressure_max for drive in (cold, warm)]
    assert pressures[1] < pressures[0]


def test_a_wheel_above_its_limit_is_in_the_headline():
    """Of check, run, rate and report; and in a line of the rating."""
    too_hot = case('material = "PA66"', hot(110))
    (sentence,) = too_hot.beyond_limits
    assert "wheel" in sentence and "above the 99 °C" in sentence
    assert sentence in opening((), "", too_hot.beyond_limits)
    assert rating_request(too_hot).beyond_limits == (sentence,)
    rating, _ = worm(too_hot)
    assert any(of.startswith("S_M = ") for of in rating.failed)
    assert case('material = "PEEK"', hot(110)).beyond_limits == ()


def test_a_plastic_wheel_is_rated_line_by_line():
    rating, left = worm(case('material = "PEEK"', hot(90)))
    built = {of.symbol: of for of in rating.safeties}
    for symbol in ("S_W", "S_H", "S_F"):
        assert built[symbol].value is None and "not covered" in built[symbol].why
    for symbol in ("S_delta", "S_T", "S_M"):
        assert built[symbol].value > 0
    figures = rating.summary()["standard"]
    assert {"mean_pressure_Pa", "bulk_temperature_C", "wheel_modulus_Pa"} <= figures.keys()
    assert not {"film_m", "friction", "efficiency", "wear_depth_m"} & figures.keys()
    assert built["S_M"].value == pytest.approx(250 / figures["bulk_temperature_C"])
    assert any("ISO/TS 14521, DIN 3996" in of for of in left)


def test_a_limit_that_plastics_have_is_nothing_unusual(recwarn):
    """PEEK is used up to 250 degC, more than any oil."""
    built = case('material = "PEEK"')
    assert built.drive.bodies[1].temperature_limit == pytest.approx(523.15)
    pyworm.plan(built.scene(phase=0.5), accuracy=0.2)
    assert not [one for one in recwarn if "temperature_limit" in str(one.message)]


def test_the_rated_material_gives_the_limit_of_constants_without_a_name():
    constants = 'youngs_modulus = "3.6 GPa"\npoisson_ratio = 0.38\ndensity = "1400 kg/m^3"\n'
    constants += 'conductivity = "0.3 W/(m K)"\nspecific_heat = "1500 J/(kg K)"'
    named = ('life = "25000 h"', 'life = "25000 h"\nwheel_material = "PEEK"')
    wheel = case(constants, named).drive.bodies[1]
    assert wheel.temperature_limit == pytest.approx(523.15)
    assert wheel.youngs_modulus == 3.6e9  # as given, whatever its temperature
    with pytest.raises(CaseError, match="one wheel is of one material"):
        case(constants.replace("3.6 GPa", "9 GPa"), named)


def test_a_modulus_by_temperature_may_be_given_and_is_stored():
    by_hand = 'poisson_ratio = 0.38\nmodulus_by_temperature = [["20 degC", "4 GPa"], ["120 degC", "2 GPa"]]'
    given = case(f'material = "PEEK"\n{by_hand}'.replace("poisson_ratio = 0.38\n", ""))
    again = case_again(given.resolved)
    moduli = [of.drive.bodies[1].youngs_modulus for of in (given, again)]
    assert moduli[0] == moduli[1] and 2e9 < moduli[0] < 4e9
    # a modulus beside the name takes the place of the material's curve
    assert case('material = "PEEK"\nyoungs_modulus = "3 GPa"').drive.bodies[1].youngs_modulus == 3e9


def test_no_wear_of_bronze_is_taken_for_a_plastic_wheel(tmp_path, capsys):
    path = tmp_path / "soft.toml"
    path.write_text(changed(DRIVE, (BRONZE, 'material = "PEEK"'), LIGHT))
    words = ["wear", str(path), "--hours", "10", "--out", str(tmp_path / "out")]
    assert main(words) == 2
    assert "--coefficient is missing" in capsys.readouterr().err
    assert main([*words, "--calibrate"]) == 2
    assert "PEEK is not covered by the worm-gear standard" in capsys.readouterr().err


@pytest.fixture(scope="module")
def soft():
    """Contact of a soft wheel at mid-mesh."""
    return case('material = "PEEK"').drive.scene(0.5)


@pytest.fixture
def outermost(soft):
    """The solver of that contact with its grids, and the film on the first of them, not solved."""
    plan = pyworm.plan(soft, 0.2, ("isothermal", "shear-thinning"))
    solver, scene = contact.PointContactSolver(plan.simplified(soft), plan), plan.simplified(soft)
    return solver, plan, contact.first_level(scene, scene, scales(scene), plan.grids[0], None)


def test_a_film_that_a_flank_ends_under_is_found_from_a_thicker_one(outermost, monkeypatch):
    """In few steps: from the expected one, given up here, up to 30 lead to one or none, by rounding."""
    solver, plan, _ = outermost
    attempts = []

    def after_the_first(level, *tolerances, **limits):
        attempts.append(level.grid is plan.grids[0])
        return iterate(level, *tolerances, **limits) if len(attempts) > 1 else []

    monkeypatch.setattr(contact, "iterate", after_the_first)
    level, steps = solver.begin(plan.grids)
    steps += iterate(level, plan.tolerance)
    assert attempts[:3] == [True, True, False]
    assert not level.diverged() and len(steps) < 20
    assert 1e-7 < level.read().figures["film_min"] < 2e-6


def test_where_no_thicker_film_leads_to_one_the_first_attempt_stays(outermost, monkeypatch):
    solver, _, level = outermost
    begun = level.film.pressure.copy(order="F"), level.film.rigid_film
    iterate(level, 1e-4, most=2)
    first, lifted = level.state(), []
    monkeypatch.setattr(
        contact, "iterate", lambda level, _: lifted.append(level.film.rigid_film) or []
    )
    assert solver._lifted_off(level, begun) == []
    assert len(lifted) == len(contact.LIFTS) and begun[1] < lifted[0] < lifted[1]
    assert level.film.rigid_film == first.rigid_film
    assert (level.film.pressure == first.pressure).all()


@pytest.mark.long
def test_a_plastic_wheel_is_solved_through_its_mesh(tmp_path, capsys):
    """Transient films of a soft wheel converge, or steady ones stand for them and it is said."""
    path, directory = tmp_path / "soft.toml", tmp_path / "out"
    path.write_text(
        changed(
            DRIVE,
            (BRONZE, 'material = "PEEK"'),
            LIGHT,
            ("phases = [0.5]", "phases = [0.3, 0.5, 0.7]"),
            ('accuracy = "10 %"', 'accuracy = "20 %"'),
        )
    )
    assert main(["run", str(path), "--out", str(directory), "--json", "--pictures", "none"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["failed"] == {} and found["beyond_limits"] == []
    assert all(scene["converged"] for scene in found["scenes"])
    assert all(0 < scene["film_min_m"] < 1e-5 for scene in found["scenes"])
    assert "not covered" in found["standard_loss"]["reason"]


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (
            'youngs_modulus = "4 GPa"\nmodulus_by_temperature = [["20 degC", "4 GPa"]]',
            "give either",
        ),
        ('modulus_by_temperature = [["20 degC", "1 GPa"], ["9 degC", "1 GPa"]]', "must rise"),
        ('modulus_by_temperature = [["20 degC", "1 GPa"], ["90 degC", "2 GPa"]]', "must not rise"),
        ('modulus_by_temperature = [["20 degC", "1 N"]]', "modulus of elasticity"),
        ('modulus_by_temperature = "4 GPa"', "must be a list"),
        ('temperature_limit = "90 K/s"', "must be a temperature"),
    ],
)
def test_wrong_moduli_are_refused(line, says):
    with pytest.raises(CaseError) as refused:
        case(f'material = "PEEK"\n{line}')
    assert says in str(refused.value) and "bodies.wheel" in str(refused.value)
