"""REXS files: written and read again they give the same worm drive; bad ones are refused in a sentence."""

from dataclasses import fields, is_dataclass, replace
from pathlib import Path

import pytest
from refusals import changed, refusal
from swept_cycle import cycle_solution
from synthetic_solution import make_result
from zi_drives import coarse_patterns, coarse_springs, without_allowed_errors

import pyworm
from pyworm.case.from_rexs import rexs_content
from pyworm.case.rexs_slots import PER_SI
from pyworm.case.to_rexs import rexs_model, unwritten_in_rexs
from pyworm.cli.main import main
from pyworm.drives.worm import dataset
from pyworm.io.input_error import CaseError
from pyworm.io.rexs import Model, read_rexs, write_rexs
from pyworm.result.rexs import rexs_of_result
from pyworm.solver.solution import Estimate

CASES = Path(__file__).parents[3] / "cases"
DATE = "2026-01-01T00:00:00+00:00"

ELSEWHERE = """<?xml version="1.0" encoding="UTF-8"?>
<model version="1.4" applicationId="another program" applicationVersion="1" date="2026-01-01">
  <relations>
    <relation id="1" type="stage">
      <ref id="3" role="stage"/><ref id="8" role="gear_1"/><ref id="9" role="gear_2"/>
    </relation>
    <relation id="2" type="assembly"><ref id="4" role="assembly"/><ref id="8" role="part"/></relation>
    <relation id="3" type="assembly"><ref id="6" role="assembly"/><ref id="9" role="part"/></relation>
    <relation id="4" type="assembly"><ref id="6" role="assembly"/><ref id="37" role="part"/></relation>
    <relation id="5" type="reference"><ref id="3" role="origin"/><ref id="38" role="referenced"/></relation>
    <relation id="6" type="reference"><ref id="8" role="origin"/><ref id="50" role="referenced"/></relation>
    <relation id="7" type="reference"><ref id="9" role="origin"/><ref id="51" role="referenced"/></relation>
  </relations>
  <components>
    <component id="3" type="worm_stage" name="stage 1">
      <attribute id="center_distance" unit="mm">100.0</attribute>
      <attribute id="center_distance_offset" unit="mm">0.0</attribute>
      <attribute id="temperature_lubricant" unit="C">73.2</attribute>
    </component>
    <component id="4" type="shaft">
      <attribute id="rotational_speed" unit="1 / min">-1000</attribute>
    </component>
    <component id="6" type="shaft"/>
    <component id="37" type="external_load">
      <attribute id="torque_around_u_axis" unit="N m">250.0</attribute>
    </component>
    <component id="8" type="worm_gear" name="worm">
      <attribute id="axial_module" unit="mm">4.0</attribute>
      <attribute id="flank_form" unit="none">zi</attribute>
      <attribute id="number_of_teeth" unit="none">2</attribute>
      <attribute id="pressure_angle_worm_gear" unit="°">20.0</attribute>
      <attribute id="lead_angle_worm_gear" unit="deg">-11.3099</attribute>
      <attribute id="reference_diameter_worm_gear" unit="mm">40.0</attribute>
    </component>
    <component id="9" type="worm_wheel" name="wheel">
      <attribute id="number_of_teeth" unit="none">41</attribute>
      <attribute id="throat_radius_worm_wheel" unit="mm">0.0</attribute>
      <attribute id="face_width_worm_wheel" unit="mm">30</attribute>
    </component>
    <component id="38" type="lubricant" name="a trade name">
      <attribute id="lubricant_type_iso_6336_2006" unit="none">non_water_soluble_polyglycol</attribute>
      <attribute id="viscosity_at_40_degree_celsius" unit="mm^2 / s">228.0</attribute>
    </component>
    <component id="50" type="material" name="steel">
      <attribute id="elastic_modulus" unit="N / mm^2">206000.0</attribute>
      <attribute id="material_designation" unit="none">16MnCr5</attribute>
    </component>
    <component id="51" type="material" name="bronze">
      <attribute id="elastic_modulus" unit="MPa">90000.0</attribute>
      <attribute id="poisson_ratio" unit="none">0.35</attribute>
      <attribute id="density" unit="kg / dm^3">8.8</attribute>
      <attribute id="thermal_conductivity" unit="W / (m K)">52.0</attribute>
      <attribute id="thermal_capacity" unit="J / (kg K)">380.0</attribute>
    </component>
  </components>
  <load_spectrum id="1">
    <load_case id="1">
      <component id="37" type="external_load">
        <attribute id="torque_around_u_axis" unit="N m">-300.0</attribute>
      </component>
    </load_case>
  </load_spectrum>
</model>
"""


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    """Fewer places, phases and loads for patterns and load sharing; no allowed errors."""
    coarse_patterns(monkeypatch)
    without_allowed_errors(monkeypatch)
    coarse_springs(monkeypatch)


def numbers(value, name=""):
    """All numbers and words of nested dataclasses, by name."""
    if is_dataclass(value):
        for entry in fields(value):
            yield from numbers(getattr(value, entry.name), f"{name}.{entry.name}")
    else:
        yield name, value


def drawn(tmp_path, *changes):
    """The catalogue unit with passages changed, as a case."""
    text = changed((CASES / "worm_drawing.toml").read_text(), *changes)
    path = tmp_path / "unit.toml"
    path.write_text(text)
    return pyworm.load(path)


UNITS = {
    "left-hand cone-ground worm": (
        ('profile = "ZI"', 'profile = "ZK"'),
        ('hand = "right"', 'hand = "left"'),
    ),
    "involute worm that is driven, mounted too far apart": (
        ('worm_speed = "1500 1/min"', 'worm_speed = "1500 1/min"\ndriver = "wheel"'),
        ("[operation]", '[drive.assembly]\ncentre_distance = "0.02 mm"\n\n[operation]'),
    ),
}


@pytest.mark.parametrize("unit", UNITS)
def test_a_drive_written_and_read_again_is_the_same_to_rounding(unit, tmp_path):
    compare(drawn(tmp_path, *UNITS[unit]), {}, tmp_path)


def test_a_drive_of_base_cylinders_is_the_same_to_rounding(tmp_path):
    """Its oil has laws of its own, for which REXS has no attributes."""
    case = pyworm.load(CASES / "zi_sharif_2001.toml")
    compare(case, {"oil.name": "PAG VG 460"}, tmp_path)


def compare(case, instead, tmp_path):
    path = tmp_path / "unit.rexs"
    model = rexs_model(case)
    write_rexs(model, path, "0", DATE)
    assert read_rexs(path).components == model.components
    units = {found.unit for part in model.components.values() for found in part.attributes.values()}
    assert units <= {*PER_SI, "C"}
    _, again = rexs_content(path, instead)
    parts = ("worm", "wheel", "hob", "centre_distance", "speed", "hand", "driver", "assembly")
    for part in (*parts, "tooth_load", "transmission"):
        before, after = (dict(numbers(getattr(of.drive, part))) for of in (case, again))
        for name, value in before.items():
            if isinstance(value, float):
                assert after[name] == pytest.approx(value, rel=1e-12, abs=1e-15), name
            else:
                assert after[name] == value, name
    assert again.drive.bodies[1].youngs_modulus == pytest.approx(
        case.drive.bodies[1].youngs_modulus
    )
    assert again.drive.bodies[0].roughness == pytest.approx(case.drive.bodies[0].roughness)


def test_a_file_of_another_program_is_read(tmp_path):
    """Its zeros stand for what is not known, and its first load case has the torque."""
    path = tmp_path / "unit.rexs"
    path.write_text(ELSEWHERE, encoding="utf-8")
    content, case = rexs_content(path, {})
    assert content["oil"] == {"temperature": "73.2 degC", "name": "PAG VG 220"}
    assert content["operation"]["wheel_torque"] == "300.0 N m"
    drive = case.drive
    assert (drive.hand, drive.worm.threads, drive.wheel.teeth) == ("left", 2, 41)
    assert drive.speed == pytest.approx(104.71975512)
    assert drive.bodies[0].youngs_modulus == 206e9 and drive.bodies[1].youngs_modulus == 90e9
    assert drive.wheel.face_width == pytest.approx(30e-3)
    assert drive.reference_radius == pytest.approx(20e-3)


BAD = {
    "no number": (
        ('"axial_module" unit="mm">4.0', '"axial_module" unit="mm">four'),
        'component 8 (worm_gear "worm"): attribute axial_module = four mm: must be a number',
    ),
    "another unit": (
        ('"axial_module" unit="mm">4.0', '"axial_module" unit="inch">4.0'),
        "attribute axial_module = 4.0 inch: must have the unit mm",
    ),
    "impossible": (
        ('"axial_module" unit="mm">4.0', '"axial_module" unit="mm">-4.0'),
        'component 8 (worm_gear "worm"): attribute axial_module = -4.0 mm: drive.module = "-4.0 mm": ',
    ),
    "half a tooth": (
        ('"number_of_teeth" unit="none">41', '"number_of_teeth" unit="none">41.5'),
        "attribute number_of_teeth = 41.5: must be a whole number from 1",
    ),
    "no such form": ((">zi<", ">zx<"), "attribute flank_form = zx: must be one of za, zn, zi, zk, zc"),
    "missing": (
        ('<attribute id="axial_module" unit="mm">4.0</attribute>', ""),
        "has no attribute axial_module that gives drive.module; add it, or give --module",
    ),
    "no oil": (
        ("<attribute id=\"viscosity_at_40_degree_celsius\" unit=\"mm^2 / s\">228.0</attribute>", ""),
        "has no attribute viscosity_at_40_degree_celsius that gives oil.name; add it, or give --oil",
    ),
    "grease": (
        ('name="a trade name">', 'name="a trade name"><attribute id="kind">grease</attribute>'),
        "attribute kind = grease: must be oil",
    ),
    "no stage": (('type="worm_stage"', 'type="bevel_stage"'), "has no component worm_stage"),
    "no worm": (('type="worm_gear"', 'type="ring_gear"'), "has no gear_1 of the type worm_gear"),
    "two stages": (
        ('<component id="6" type="shaft"/>', '<component id="6" type="worm_stage"/>'),
        "has 2 components worm_stage; must have one",
    ),
    "no truth": (
        ("250.0</attribute>", '250.0</attribute><attribute id="is_driving_gear">perhaps</attribute>'),
        "attribute is_driving_gear = perhaps: must be true or false",
    ),
    "a part that is not there": (
        ('<ref id="37" role="part"/>', '<ref id="77" role="part"/>'),
        "names component 77",
    ),
    "a name for a number": (
        ('<component id="6"', '<component id="six"'),
        'has the id "six": must be a whole number',
    ),
    "no model": (("<model", "<modell"), "is no REXS file in XML"),
    "an entity": (
        ('encoding="UTF-8"?>', 'encoding="UTF-8"?>\n<!DOCTYPE m [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>'),
        "has a document type definition, which a REXS file must not have",
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", BAD)
def test_a_bad_file_is_refused_in_a_sentence(fault, tmp_path, capsys):
    change, message = BAD[fault]
    path = tmp_path / "unit.rexs"
    path.write_text(changed(ELSEWHERE, change), encoding="utf-8")
    said = refusal(["new", str(tmp_path / "unit.toml"), "--from", str(path)], tmp_path, capsys)
    assert said.startswith(f"pyworm: {path}: ") and message in said


def test_what_is_no_file_or_no_model_is_refused(tmp_path):
    with pytest.raises(CaseError, match=r"none.rexs: cannot be read \(No such file"):
        read_rexs(tmp_path / "none.rexs")
    (tmp_path / "page.rexs").write_text("<html/>")
    with pytest.raises(CaseError, match="its root is html, must be model"):
        read_rexs(tmp_path / "page.rexs")


def test_a_file_too_large_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr("pyworm.io.rexs.MAX_FILE_BYTES", 10)
    (tmp_path / "large.rexs").write_text(ELSEWHERE)
    with pytest.raises(CaseError, match="has more than 0 MB"):
        read_rexs(tmp_path / "large.rexs")


def test_arrays_are_written_and_read(tmp_path):
    model = Model("test")
    made = model.add("worm_stage", "stage", {"phases": ((0.25, 0.5), "none"), "on": (True, "none")})
    write_rexs(model, tmp_path / "arrays.rexs", "0", DATE)
    again = read_rexs(tmp_path / "arrays.rexs").components[made.number]
    assert again.attributes["phases"].text == "0.25 0.5" and again.attributes["phases"].array
    assert again.flag("on") is True and again.flag("off") is None


def test_a_result_has_its_contact_analysis(tmp_path, monkeypatch):
    monkeypatch.setattr(dataset, "LOADED_PHASES", 11)
    case = drawn(tmp_path)
    films = {0.3: 0.4e-6, 0.5: 0.5e-6, 0.7: 0.9e-6}
    solutions = tuple(
        replace(solution, figures=replace(solution.figures, film_min=Estimate(film, 0.01)))
        for solution, film in ((cycle_solution(phase), film) for phase, film in films.items())
    )
    cycle = dataset.loaded_cycle_data(case.drive, 0.1)
    made = replace(make_result(), case=case.resolved, solutions=solutions, mesh_cycle=cycle)
    model = rexs_of_result(made)
    (stage,) = model.of_kind("worm_stage")
    film = "minimum_lubricant_film_thickness_ltca_worm_stage"
    assert float(stage.word(f"maximum_value_{film}")) == pytest.approx(0.9)
    assert float(stage.word(f"mean_{film}")) == pytest.approx(0.6)
    stress = float(stage.word("maximum_hertzian_stress_ltca_worm_stage"))
    assert stress == pytest.approx(solutions[0].summary()["dry_pressure_max_Pa"] * 1e-6)
    # the sliding at the reference diameter, by the closed form, is within a tenth of that in mid-mesh
    sliding = float(stage.word("mean_sliding_velocity_ltca_worm_stage"))
    assert sliding == pytest.approx(3.204, rel=0.1)
    assert stage.word("custom_pyworm_phase") == "0.3 0.5 0.7"
    unsound = replace(made, solutions=tuple(replace(one, converged=False) for one in solutions))
    with pytest.raises(CaseError, match="no contact converged"):
        rexs_of_result(unsound)


def test_the_commands_write_and_read(tmp_path, capsys):
    case, rexs, again = tmp_path / "a.toml", tmp_path / "a.rexs", tmp_path / "b.toml"
    case.write_text((CASES / "worm_drawing.toml").read_text())
    assert main(["rexs", str(case)]) == 0
    words = [
        "--oil",
        "PAO VG 220",
        "--wheel-material",
        "CuSn12-C-GZ",
        "--threads",
        "2",
        "--title",
        "B",
    ]
    assert main(["new", str(again), "--from", str(rexs), *words]) == 0
    assert "REXS 2.0, 18 components" in capsys.readouterr().out
    read = pyworm.load(again)
    assert read.title == "B" and read.tables.oil.name == "PAO VG 220"
    assert read.tables.bodies.wheel.material == "CuSn12-C-GZ"
    assert len(read.tables.operation.phases) == 5
    said = refusal(["rexs", str(case), "--out", str(tmp_path / "a.xml")], tmp_path, capsys)
    assert "must end in .rexs" in said
    said = refusal(["rexs", str(CASES / "spur_pair.toml")], tmp_path, capsys)
    assert "REXS is written for worm drives" in said


def test_what_rexs_lacks_is_named(tmp_path):
    cooled = drawn(
        tmp_path,
        ("[oil]", '[lubrication]\nmethod = "bath"\nbody = "wheel"\ndepth = "10 mm"\n\n[oil]'),
    )
    assert unwritten_in_rexs(cooled) == ("lubrication of the teeth",)
