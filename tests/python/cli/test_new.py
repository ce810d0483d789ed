"""pyworm new: a worm drive's case file from the numbers of its drawing."""

import io
import re
import tomllib

import pytest
from refusals import refusal
from zi_drives import coarse_patterns, coarse_springs, without_allowed_errors

import pyworm
from pyworm.case.new_worm import MIN_LOAD_SHARE, PHASES, loaded_phases
from pyworm.case.shipped import KINDS
from pyworm.cli.main import main
from pyworm.ratings.rated_case import load_rating_request, ratings

UNIT = {
    "--centre-distance": "100 mm",
    "--threads": "2",
    "--teeth": "41",
    "--module": "4 mm",
    "--diameter-factor": "10",
    "--worm-speed": "1500 1/min",
    "--wheel-torque": "300 Nm",
    "--worm-material": "16MnCr5",
    "--wheel-material": "CuSn12Ni2-C-GZ",
    "--oil": "PAG VG 460",
    "--oil-temperature": "60 C",
    "--life": "25000 h",
    "--application-factor": "1.25",
}


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    """Fewer places, phases and loads for patterns and load sharing; no allowed errors."""
    coarse_patterns(monkeypatch)
    without_allowed_errors(monkeypatch)
    coarse_springs(monkeypatch)


def words(path, **changes):
    """The command line of a unit, some of its options changed, or left out where None."""
    given = UNIT | {f"--{key.replace('_', '-')}": value for key, value in changes.items()}
    return [
        *("new", str(path)),
        *(word for pair in given.items() if pair[1] is not None for word in pair),
    ]


def test_options_make_a_case(tmp_path, capsys):
    path = tmp_path / "unit.toml"
    assert main(words(path, hand="left", hob_oversize="1.6 mm", title='Häcksler "3"')) == 0
    assert "pyworm check" in capsys.readouterr().out
    case = pyworm.load(path)
    assert case.title == 'Häcksler "3"'
    assert case.drive.worm.threads == 2 and case.drive.wheel.teeth == 41
    assert case.drive.hand == "left"
    assert case.drive.geometry_table()["hob_oversize_m"] == pytest.approx(1.6e-3)
    assert case.drive.speed == pytest.approx(157.0796, rel=1e-6)
    assert case.tables.operation.wheel_torque == 300


def test_the_written_file_is_rated_for_its_life_with_all_five_safeties(tmp_path):
    path = tmp_path / "unit.toml"
    assert main(words(path, starts_per_hour="2")) == 0
    asked = load_rating_request(path)
    table = asked.worm_rating
    assert (table.life, table.application_factor) == pytest.approx((25000 * 3600, 1.25))
    assert table.starts_per_hour == 2
    built = {of.symbol: of for of in ratings(asked)[0].safeties}
    assert tuple(built) == ("S_W", "S_H", "S_delta", "S_F", "S_T")
    assert all(of.value > 0 for of in built.values())
    shorter = tmp_path / "shorter.toml"
    main(words(shorter, life="2500 h"))
    longer_lasting = {of.symbol: of for of in ratings(load_rating_request(shorter))[0].safeties}
    # wear is proportional to the hours; without starts it is less
    assert longer_lasting["S_W"].value > 10 * built["S_W"].value
    assert longer_lasting["S_F"].value >= built["S_F"].value


def test_phases_are_proposed_where_tooth_pairs_carry_load(tmp_path):
    assert loaded_phases(lambda phase: 1.0) == PHASES
    late = loaded_phases(lambda phase: 0.0 if phase < 0.4 else 1.0)
    assert late == pytest.approx([0.4 + 0.6 * part for part in PHASES])
    assert min(PHASES) >= 0.2 and max(PHASES) < 1
    edges = loaded_phases(lambda phase: 1.0 if 0.2 <= phase <= 0.8 else 0.9 * MIN_LOAD_SHARE)
    assert 0.2 < min(edges) and max(edges) < 0.8
    path = tmp_path / "unit.toml"
    main(words(path))
    case = pyworm.load(path)
    loads = [case.drive.normal_load(phase) for phase in case.tables.operation.phases]
    assert len(loads) == 5 and min(loads) > MIN_LOAD_SHARE * max(loads)
    assert case.warnings == ()


@pytest.mark.long
def test_the_written_file_is_solved_to_its_accuracy(tmp_path, capsys):
    """The tutorial's unit: every phase converges, and the report on it can be signed."""
    path, directory = tmp_path / "unit.toml", tmp_path / "out"
    main(words(path))
    assert main(["run", str(path), "--out", str(directory), "--pictures", "none"]) == 0
    printed = capsys.readouterr().out
    assert "Less accurate" not in printed and "not converge" not in printed
    assert "fficiency" in printed


def test_a_profile_may_be_asked_for(tmp_path, capsys):
    path = tmp_path / "unit.toml"
    assert main(words(path, profile="ZK")) == 0
    text = path.read_text()
    assert 'profile = "ZK" # ground by a cone' in text
    assert '# disc_diameter = "500 mm" # default: as of new grinding wheels' in text
    capsys.readouterr()
    said = refusal(words(tmp_path / "other.toml", profile="ZX"), tmp_path, capsys)
    assert 'drive.profile = "ZX"' in said and '"ZC"' in said


def test_answers_make_the_same_case(tmp_path, capsys, monkeypatch):
    by_options, by_answers = tmp_path / "unit.toml", tmp_path / "asked.toml"
    main(words(by_options))
    capsys.readouterr()
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(UNIT.values()) + "\n"))
    assert main(["new", str(by_answers)]) == 0
    assert 'axial module, such as "4 mm"?' in capsys.readouterr().err
    assert by_answers.read_text() == by_options.read_text()


def test_what_is_taken_as_usual_stands_there_as_a_comment_and_means_what_it_says(tmp_path):
    """With all signs of comments taken away from keys the drive is the same, to the digits written."""
    path = tmp_path / "unit.toml"
    main(words(path))
    text = path.read_text()
    open_text = re.sub(r"^# (\w+ = )", r"\1", text, flags=re.M)
    assert len(tomllib.loads(open_text)["drive"]["worm"]) == 6
    (tmp_path / "open.toml").write_text(open_text)
    usual, written = (pyworm.load(tmp_path / f"{name}.toml").drive for name in ("unit", "open"))
    assert written.assumed == ()
    assert len(usual.assumed) == len(re.findall(r"default: ", text))
    mine, other = usual.geometry_table(), written.geometry_table()
    for key, value in mine.items():
        expected = value if isinstance(value, str) else pytest.approx(value, rel=2e-3, abs=2e-5)
        assert other[key] == expected, key


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"threads": "41", "teeth": "2"}, "drive.threads is 41 with 2 teeth"),
        ({"threads": "two"}, 'drive.threads = "two": must be a whole number'),
        ({"module": "4"}, 'drive.module = "4": must be a length with its unit'),
        ({"wheel_torque": "300 N"}, 'operation.wheel_torque = "300 N": must be a torque'),
        ({"oil": "PAG 460"}, 'oil.name = "PAG 460"'),
        ({"life": "25000"}, 'worm_rating.life = "25000": must be a duration with its unit'),
        ({"application_factor": "-1"}, "worm_rating.application_factor"),
        ({"life": None}, "--life is missing (rated life in operating hours"),
        ({"wheel_material": "bronze"}, 'bodies.wheel.material = "bronze": must be one of 16MnCr5'),
        ({"module": None}, '--module is missing (axial module, such as "4 mm")'),
    ],
)
def test_wrong_numbers_are_refused_and_nothing_is_written(
    changes, says, tmp_path, monkeypatch, capsys
):
    monkeypatch.setattr("sys.stdin", io.StringIO(""))
    path = tmp_path / "unit.toml"
    assert main(words(path, **changes)) == 2
    assert says in capsys.readouterr().err
    assert not path.exists()


def test_a_file_is_not_written_over(tmp_path, capsys):
    path = tmp_path / "unit.toml"
    path.write_text("mine")
    assert "already exists" in refusal(words(path), tmp_path, capsys)
    assert path.read_text() == "mine"


def test_a_case_file_ends_in_toml(tmp_path, capsys):
    assert "must end in .toml" in refusal(words(tmp_path / "unit.txt"), tmp_path, capsys)


@pytest.mark.parametrize("kind", KINDS)
def test_other_kinds_are_written_to_be_filled_in(kind, tmp_path, capsys):
    path = tmp_path / "unit.toml"
    assert main(["new", str(path), "--kind", kind]) == 0
    case = pyworm.load(path)
    assert not case.warnings
    assert case.tables.oil.heat is not None
    capsys.readouterr()
    assert "already exists" in refusal(["new", str(path), "--kind", kind], tmp_path, capsys)


def test_numbers_of_a_drawing_are_those_of_a_worm(tmp_path, capsys):
    words = ["new", str(tmp_path / "unit.toml"), "--kind", "ball", "--module", "4 mm"]
    assert "--module has no effect with --kind ball" in refusal(words, tmp_path, capsys)


def test_examples_are_listed_and_written_with_the_files_that_they_name(tmp_path, capsys):
    assert main(["example"]) == 0
    listed = capsys.readouterr().out
    assert "zi_drive" in listed and "traction_steel" in listed
    assert main(["example", "gap_example", "--out", str(tmp_path)]) == 0
    assert pyworm.load(tmp_path / "gap_example.toml").name == "gap_example"
    capsys.readouterr()
    again = ["example", "gap_example", "--out", str(tmp_path)]
    assert "already exists" in refusal(again, tmp_path, capsys)
    assert "no such example; choose one of" in refusal(["example", "hypoid"], tmp_path, capsys)
