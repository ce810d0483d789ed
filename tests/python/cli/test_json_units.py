"""Every number that commands print as JSON is in the unit that its key says.

Each key has to be known here, with the range of its numbers for the machines of the shipped cases: kelvin for
Celsius, millimetres for metres or megapascal for pascal fall out of it.
"""

import json
import re

import pytest
from folders import CASES
from swept_cycle import PHASES, cycle_result
from synthetic_solution import line_with_heat, make_hot_worm, make_line_solution

from pyworm.cli.main import main
from pyworm.io.json import as_json
from pyworm.result.mesh_cycle import drive_cycle

RATED = "bearing_nu2210", "oil_zi", "zi_sharif_2001", "errichello_speed_increaser"

RANGES = {
    # errors first: those of a figure, relative; those of the cycle, in the unit of the figure beside
    r"^film_min\.error": (1e-12, 1e-6),
    r"^pressure_max\.error": (1e3, 1e9),
    r"^temperature_max\..*\.error|_error_K\b": (1e-3, 20),
    r"^lambda_(min|central)\.error": (1e-4, 1),
    r"_error(_\w+)?_W$": (0, 1e4),
    r"_error(_grid|_domain|_algebra|_approximation)?$": (0, 0.5),
    # surfaces, their heights and lengths
    r"^(rq|ra|rz|rk|rpk|rvk|long_waves_rq)_m$": (0, 1e-4),
    r"^(spacing|length_across|length_along|shortest_length)_m$": (1e-7, 1e-2),
    r"^(skewness|lay_rad)$": (-3.2, 3.2),
    r"^(mr1|mr2|slope\w*|filled_fraction|texture_ratio)$": (0, 1),
    r"^outliers$": (0, 1e7),
    r"^(kurtosis|aspect|points)$": (1, 1e5),
    # films and heights of surfaces; lengths of contacts, of gears, places on a flank
    r"film\w*_at_m$": (-0.1, 0.1),
    r"(film\w*|roughness|approach|wear_depth|^film_min\.value)_m$": (1e-9, 1e-4),
    r"(dowson|chittenden|moes|khonsari|toyoda|higginson)_m$": (1e-9, 1e-4),
    r"(length|width|jet_diameter)_m$": (1e-4, 0.1),
    r"wear_limit_m$": (1e-4, 1e-2),
    r"\.minimum$": (1, 2),
    r"^S_\w+\.value$": (0, 1e3),
    r"^S_\w+\.inputs\..*_um$": (1e-3, 1e4),
    r"^S_\w+\.inputs\..*_MPa$": (1, 2e3),
    r"^S_\w+\.inputs\..*_kN$": (1e-2, 1e3),
    r"^S_\w+\.inputs\.(W_S|W_H|s\*|p_m\*|rim_over_module)$": (1e-2, 1e3),
    r"^S_\w+\.inputs\.J_": (1e-13, 1e-5),
    r"^S_\w+\.inputs\.L_h$": (1, 1e6),
    r"face_m$": (-0.1, 0.1),
    r"(radius_m|radii_m|radius_\w+_m)$": (1e-3, 10),
    # temperatures: no kelvin of a machine that stands in a room is below 250
    r"^start_temperature_C$": (-50, 50),
    r"_C\b": (-5, 250),
    r"temperature_K$": (1, 200),
    r"^S_\w+\.inputs\.margin_K$": (-250, 250),
    r"grades\.(sump|bulk)_temperature$": (280, 400),
    # forces, moments, powers
    r"^(breakaway|cold\w*|warm|holding)_torque_N_m$": (0.1, 1e4),
    r"(torque_N_m|torque_Nm)$": (50, 1e4),
    r"load_N$": (1, 1e5),
    r"_(tangential|axial|radial|thrust)_N$": (0, 1e6),
    r"per_length_N_m$": (1e4, 1e7),
    r"per_length_W_m$": (1e2, 1e6),
    r"_W$": (100, 1e5),
    r"modulus_Pa$": (1e10, 1e12),
    r"pressure_viscosity_1_Pa$": (5e-9, 5e-8),
    r"_Pa$|^pressure_max\.value_Pa$": (1e8, 1e10),
    # motion
    r"(_m_s|_m_per_s)$": (0, 50),
    r"_1_s$": (1e4, 1e9),
    # oils
    r"_Pa_s$": (1e-3, 10),
    r"_m2_s$": (1e-6, 1e-2),
    r"_kg_m3$": (700, 1200),
    r"_J_kgK$": (1000, 3000),
    r"_m3_s$": (1e-6, 1e-3),
    r"grades\.viscosity$": (1e-5, 1e-1),
    r"grades\.loss$": (100, 1e5),
    r"grades\.energy_cost$": (100, 1e5),
    r"grades\.start_torque$": (1, 1e3),
    r"grades\.oil_life$": (1e3, 1e6),
    r"^(breakaway_friction)$": (1e-2, 0.3),
    r"^(start_margin|warming_time_h)$": (0.1, 100),
    r"grades\.film$": (1e-8, 1e-4),
    # lives
    r"_life_h$": (1e3, 1e6),
    r"_life_rev$": (1e7, 1e11),
    # without unit
    r"(phase|phases)$": (0, 1),
    r"(efficiency|efficiency_back|probability|contamination|reliability_factor)$": (0, 1),
    r"efficiency_gearbox(_back)?$": (0, 1),
    r"(friction|friction_coefficient|friction_rest|loss_factor|film_parameter)$": (1e-3, 0.3),
    r"(specific_film|lambda_(min|central)\.value|modification|kappa|safety)$": (0, 100),
    r"(locking|locking_rest|locking_creeping|heat)$": (0, 100),
    r"^left_out\.": (0, 1e3),
    r"(moes_M|moes_L|viscosity_index)$": (1, 1e3),
    r"^accuracy$": (1e-5, 0.5),
    r"(deflection_over_film|inlet_thickening)(_error)?$": (1e-2, 1e3),
    r"(grade|nearest_grade|jets|grid|convolutions|expected_convolutions)$": (1, 1e5),
    r"(residual|load_error|mass_error|heat_balance)$": (0, 0.1),
    r"(seconds|expected_seconds)$": (0, 1e4),
}  # fmt: skip


def numbers(content, path=()):
    """Each number of an object and where it is, by its keys."""
    if isinstance(content, dict):
        for key, value in content.items():
            yield from numbers(value, (*path, key))
    elif isinstance(content, list):
        for value in content:
            yield from numbers(value, path)
    elif isinstance(content, int | float) and not isinstance(content, bool):
        yield ".".join(path), content


def agree_with_their_keys(content):
    found = list(numbers(content))
    assert found
    for key, value in found:
        known = [bounds for pattern, bounds in RANGES.items() if re.search(pattern, key)]
        assert known, f"{key}: not known here"
        low, high = known[0]
        assert low <= value <= high, f"{key} = {value:g} is not between {low:g} and {high:g}"


def test_json_has_null_where_a_number_is_none():
    content = {"error": float("inf"), "films": [float("nan"), -float("inf"), 1.5], "at": (None, 2)}
    assert json.loads(as_json(content)) == {
        "error": None,
        "films": [None, None, 1.5],
        "at": [None, 2],
    }
    assert "NaN" not in as_json(content) and "Infinity" not in as_json(content)


def said(capsys, *command):
    assert main([*map(str, command), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(
    "solution", [make_hot_worm(), line_with_heat(make_line_solution())], ids=["point", "line"]
)
def test_a_scene_has_its_units_in_the_keys(solution):
    agree_with_their_keys(solution.summary())


def test_a_cycle_has_its_units_in_the_keys():
    agree_with_their_keys(drive_cycle(cycle_result(PHASES)).summary())


@pytest.mark.parametrize("name", RATED)
def test_ratings_have_their_units_in_the_keys(capsys, name):
    for rating in said(capsys, "rate", CASES / f"{name}.toml")["ratings"]:
        for column in rating.values():
            if isinstance(column, dict):
                agree_with_their_keys(column)


def test_oils_have_their_units_in_the_keys(capsys):
    for oil in said(capsys, "oil", "show", "PAG VG 460", "mineral VG 220", "PAO VG 46")["oils"]:
        agree_with_their_keys(oil)
    agree_with_their_keys(said(capsys, "oil", "choose", CASES / "oil_zi.toml"))


def test_surfaces_have_their_units_in_the_keys(capsys):
    for surface in said(capsys, "surface", CASES / "surfaces/ground.toml")["surfaces"]:
        agree_with_their_keys(surface)


@pytest.mark.parametrize("name", ["mourier_2006", "line_m20_l10"])
def test_a_plan_has_its_units_in_the_keys(capsys, name):
    for scene in said(capsys, "check", CASES / f"{name}.toml")["scenes"]:
        inner = ("plan", "effects")  # the planner's own objects, in SI without units in their keys
        agree_with_their_keys({key: of for key, of in scene.items() if key not in inner})
