"""Bad input: one sentence on standard error, exit code 2, no traceback, no file left behind."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from folders import CASES
from refusals import changed, refusal

from pyworm.cli.shared import BAD_INPUT

DRIVE = (CASES / "zi_sharif_2001.toml").read_text()
CONTACT = (CASES / "point_m20_l10.toml").read_text()
LINE = (CASES / "line_m20_l10.toml").read_text()
TRACTION = (CASES / "traction_steel.toml").read_text()
ROLLERS = (CASES / "roller_ref.toml").read_text()
GAP = (CASES / "gap_example.toml").read_text()


@pytest.fixture
def refuse(tmp_path, monkeypatch, capsys):
    """Run a case text in an empty directory and return the refusal."""
    monkeypatch.chdir(tmp_path)

    def run(text):
        Path("case.toml").write_text(text)
        return refusal(["run", "case.toml"], tmp_path, capsys)

    return run


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        # unknown and missing keys
        ('load = "14 kN"', 'lod = "14 kN"', "operation.lod: no such key; did you mean load?"),
        ("[drive.hob]", "[drive.hub]", "drive.hub: no such key; did you mean hob?"),
        ("[oil.viscosity]", "[oil.viscosity]\nzz = 1", "oil.viscosity.zz: no such key; did you"),
        ("title =", "colour =", "colour: no such key; valid keys are accuracy, assumed, bearings"),
        ('load = "14 kN"', "", "operation: give one of load, worm_torque, wheel_torque, power"),
        ('load = "14 kN"', 'load = "14 kN"\npower = "9 kW"', "power, not load and power"),
        (
            'load = "14 kN"',
            'load = "14 kN"\nfriction = 0.01',
            "friction has no effect with the load",
        ),
        (
            'load = "14 kN"',
            'wheel_torque = "4 kN m"\nsharing = "equal"\nlifts = [[0.5, "1 um"]]',
            "lifts has no effect with sharing = equal",
        ),
        (
            'load = "14 kN"',
            'wheel_torque = "4 kN m"\nlifts = [[0.5, "1 um"], [0.1, "2 um"]]',
            "lifts has the phases 0.5, 0.1; they must rise",
        ),
        # bodies: layers and fatigue limits; scuffing
        (
            "[bodies.wheel]",
            '[bodies.wheel.coating]\nthickness = "3 m"\nyoungs_modulus = "250 GPa"\n'
            "poisson_ratio = 0.2\n[bodies.wheel]",
            "bodies.wheel.coating.thickness",
        ),
        (
            "[bodies.wheel]",
            '[bodies.wheel.fatigue]\nbending_limit = "300 MPa"\ntorsion_limit = "400 MPa"\n'
            "[bodies.wheel]",
            "torsion_limit is 1.33 of bending_limit: must be 0.5 to 1 of it",
        ),
        (
            "[bodies.wheel]",
            '[bodies.wheel.fatigue]\nbending_limit = "500 MPa"\ntorsion_limit = "300 MPa"\n'
            'hardnesses = ["7 GPa"]\n[bodies.wheel]',
            "hardnesses: needs one value for each of the 0 depths",
        ),
        (
            "[bodies.wheel]",
            '[bodies.wheel.fatigue]\nbending_limit = "500 MPa"\ntorsion_limit = "300 MPa"\n'
            'depths = ["0.2 mm", "0.1 mm"]\n[bodies.wheel]',
            "depths: must rise from point to point",
        ),
        (
            "[bodies.wheel]",
            '[scuffing]\ntemperature = "300 degC"\nscuffing_load_stage = 10\n[bodies.wheel]',
            "give one of temperature, scuffing_load_stage, not temperature and scuffing_load_stage",
        ),
        ('"14 kN"', '"14 kN"\nwheel_speed = "9 rpm"', "give either worm_speed or wheel_speed"),
        (
            "[drive.worm]",
            'stiffness = "1 N/um"\n[drive.worm]',
            "drive.stiffness has no effect with",
        ),
        (
            "[bodies.worm]",
            '[cooling]\nambient_temperature = "20 degC"\nconductance = "40 W/K"\n[bodies.worm]',
            "[cooling] asks for [oil.heat] and for a torque or a power in [operation], instead of load",
        ),
        (
            'tip_diameter = "96.02 mm"',
            'tip_diameter = "96.02 mm"\ntip_relief = "20 um"',
            "drive.worm.tip_relief_length is 0 mm; it must lie between 0 and the tooth's height, 18.98 mm",
        ),
        ('kind = "worm"', "", "drive.kind is missing"),
        ('law = "roelands"', "", "oil.viscosity.law is missing"),
        # wrong units, wrong values
        ('"14 kN"', "14", 'operation.load = 14: must be a force with its unit, such as "14 kN"'),
        (
            '"14 kN"',
            '"14e30 kN"',
            'load = "14e30 kN": must be a force between 1e-12 N and 1e12 N, s',
        ),
        ("z = 0.227", "z = 1e7", "oil.viscosity.z = 10000000.0: must be at most 1e+06"),
        ("z = 0.227", "z = 400", "out of all proportion"),
        ('eta0 = "0.227 Pa s"', 'eta0 = "1e-6 Pa s"', "must be above 6.3e-05 Pa s, the pole of Ro"),
        ('"14 kN"', '"14 mm"', 'operation.load = "14 mm": must be a force with its unit'),
        ('"96.02 mm"', '"-96.02 mm"', 'drive.worm.tip_diameter = "-96.02 mm": must be a length gr'),
        ("threads = 3", "threads = 3.5", "drive.threads = 3.5: must be a whole number"),
        ("threads = 3", "threads = 0", "drive.threads = 0: must be greater than 0"),
        ("z = 0.227", 'z = "0.227"', 'oil.viscosity.z = "0.227": must be a number without unit'),
        ("z = 0.227", "z = nan", "oil.viscosity.z = nan: must be finite"),
        ("z = 0.227", "", "oil.viscosity: give either z or alpha, one of the two"),
        ("= 0.35", "= 0.5", "bodies.wheel.poisson_ratio = 0.5: must be less than 0.5"),
        ("[0.1, 0.3, 0.5, 0.7, 0.9]", "[0.5, 1.5]", "operation.phases[1] = 1.5: must be at most 1"),
        (
            "[0.1, 0.3, 0.5, 0.7, 0.9]",
            "[]",
            "operation.phases = []: has too few entries, at least 1 needed",
        ),
        ("[0.1, 0.3, 0.5, 0.7, 0.9]", "0.5", "operation.phases = 0.5: must be a list"),
        ('"worm"', '"zk-worm"', 'drive.kind = "zk-worm": must be "worm", "gear-pair" or '),
        (
            '"worm"',
            '"zi-worm"',
            'drive.kind = "zi-worm": must be "worm", with profile = "ZI", the keys ',
        ),
        ('"ZI"', '"ZK"', 'drive.profile is "ZK"; without module the flanks are those of base cyl'),
        (
            'base_diameter = "52.96 mm"',
            "",
            "drive.hob.base_diameter is missing; without module the",
        ),
        (
            "threads = 3",
            'threads = 3\nbacklash = "1 mm"',
            "drive.backlash has no effect without modu",
        ),
        (
            "threads = 3",
            'threads = 3\nmodule = "9 mm"',
            "drive: diameter_factor is missing (q, ref",
        ),
        ('"roelands"', '"rolands"', 'law = "rolands": must be one of "barus", "roelands"'),
        ('"540 MPa"', '"540 MPx"', 'published.dry_pressure_max = "540 MPx": must be a number'),
        ('"1 %"', '"1 mm"', 'accuracy = "1 mm": must be a share, such as "1 %"'),
        ('"1 %"', '"99 %"', "accuracy = 0.99"),
        (
            '["auto", "-squeeze"]',
            '"auto,-squeeze"',
            'effects = "auto,-squeeze": several names must be texts of their own, "auto", "-squeeze"',
        ),
        ("[drive]", "[drive", "not a TOML file"),
    ],
)
def test_wrong_values_in_a_drive(refuse, old, new, sentence):
    assert sentence in refuse(changed(DRIVE, (old, new)))


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('["10 mm", "10 mm"]', '["10 mm", "-10 mm"]', 'contact.radii[1] = "-10 mm": must be a rad'),
        ('["10 mm", "10 mm"]', '["10 mm"]', "contact.radii[1] is missing"),
        ('"point-contact"', '"pin"', 'must be "point-contact", "line-contact" or "gap"'),
        ('"point-contact"', "[1]", 'must be "point-contact", "line-contact" or "gap"'),
        ('kind = "point-contact"', "", "contact.kind is missing"),
        ('kind = "point-contact"\n', 'kind = "point-contact"\nlod = 1\n', "did you mean load?"),
        ('"0 m/s"', "0", "motion.velocity_1[1] = 0: must be a velocity with its unit"),
        ('alpha = "22 1/GPa"', 'alpha = "22 1/GPa"\nz = 0.6', "give either z or alpha"),
        ('= "196 MPa"', '= "196 MPa"\npole_coefficient = "5.1 1/GPa"', "give either pole_pressure"),
        ('law = "dowson-higginson"', 'law = "general"', "oil.density.d1 is missing"),
        ("[contact]", "[drive]", "drive."),
        ("[contact]", "[touch]", "give either a [drive] or a [contact]"),
        ("[contact]", "[drive]\n[contact]", "give either a [drive] or a [contact]"),
    ],
)
def test_wrong_values_in_a_contact(refuse, old, new, sentence):
    assert sentence in refuse(changed(CONTACT, (old, new)))


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('"182.84 kN/m"', '"182.84 kN"', 'load = "182.84 kN": must be a force per length with its'),
        ('"182.84 kN/m"', '"0 kN/m"', 'such as "100 kN/m"'),
        ('radius = "10 mm"', 'radii = ["10 mm", "10 mm"]', "contact.radii: no such key; did you"),
        ('radius = "10 mm"', "", "contact.radius is missing"),
        (
            '"0.46227 m/s"',
            '["1 m/s", "0 m/s"]',
            'motion.velocity_1 = ["1 m/s", "0 m/s"]: must be a',
        ),
        ("[motion]", '[motion]\nspin_1 = "2 rad/s"', "motion.spin_1: no such key; valid keys are"),
        ('"0.46227 m/s"', '"-0.46227 m/s"', "the surfaces entrain no oil"),
        ('"182.84 kN/m"', '"1e20 kN/m"', "between 1e-3 N/m and 1e6 kN/m"),
    ],
)
def test_wrong_values_in_a_line_contact(refuse, old, new, sentence):
    assert sentence in refuse(changed(LINE, (old, new)))


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        (
            'roughness = "1 um"\nroughness_ra = "1 um"',
            "either roughness (Rq), roughness_ra (Ra) or roughness_rz (Rz)",
        ),
        (
            "roughness_slope = 0.01",
            "roughness_slope needs roughness (Rq) or roughness_ra (Ra) with",
        ),
        ('roughness = "1 um"\nlay = "90 deg"', "lay needs roughness_aspect with it, such as 3"),
        ('roughness = "1 um"\nroughness_aspect = 20', "roughness_aspect = 20"),
        ('hardness = "1 kPa"', "hardness between 1 MPa and 200 GPa"),
        ("asperity_sharpness = 0.01", "asperity_sharpness needs roughness (Rq)"),
        (
            'roughness = "1 um"\nasperity_density = 0.04',
            "asperity_density needs asperity_sharpness with it, such as 0.01",
        ),
        (
            'roughness = "1 um"\nasperity_sharpness = 0.01\nroughness_slope = 0.01',
            "either roughness_slope (rough on all scales) or asperity_sharpness",
        ),
        ('roughness = "1 um"\nasperity_sharpness = 0', "asperity_sharpness = 0"),
    ],
)
def test_wrong_roughness(refuse, keys, sentence):
    assert sentence in refuse(changed(LINE, ("[bodies.body_1]", f"[bodies.body_1]\n{keys}")))


MEAN = 'mean_velocity = ["2 m/s", "0 m/s"]'
RATIOS = next(line for line in TRACTION.splitlines() if line.startswith("slide_roll_ratios"))
FORMS = "motion: give either velocity_1 and velocity_2, or mean_velocity and slide_roll_ratios"


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        (
            'across = ["1 mm", "0 mm"]\nthickness = ["1 um", "1 um"]',
            "oil.supply: across: must increase",
        ),
        (
            'across = ["0 mm"]\nthickness = ["1 um"]',
            "oil.supply: across, thickness: must be two numbers",
        ),
        ('across = ["0 mm", "1 mm"]', "oil.supply.thickness is missing"),
        (
            'across = ["0 mm", "1 N"]\nthickness = ["1 um", "1 um"]',
            'oil.supply.across[1] = "1 N": must be a length',
        ),
    ],
)
def test_wrong_profiles_of_the_oil_supplied(refuse, keys, sentence):
    assert sentence in refuse(f"{CONTACT}\n[oil.supply]\n{keys}\n")


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (RATIOS, "slide_roll_ratios = []", "motion.slide_roll_ratios = []: has too few entries"),
        (RATIOS, "slide_roll_ratios = 0.5", "motion.slide_roll_ratios = 0.5: must be a list"),
        (RATIOS, 'slide_roll_ratios = ["5 %"]', 'motion.slide_roll_ratios[0] = "5 %": must be a n'),
        (RATIOS, "slide_roll_ratios = [0, nan]", "motion.slide_roll_ratios[1] = nan: must be fin"),
        (RATIOS, "slide_roll_ratios = [0.5, 1, 0.5]", "[0.5, 1, 0.5]: must not name a ratio twice"),
        (RATIOS, "slide_roll_ratio = [0]", "motion.slide_roll_ratio: no such key; did you mean sl"),
        (RATIOS, "", FORMS),
        (MEAN, "", FORMS),
        (MEAN, f'{MEAN}\nvelocity_1 = ["2 m/s", "0 m/s"]', FORMS),
        (f"{MEAN}\n{RATIOS}", "", FORMS),
        (f"{MEAN}\n{RATIOS}", 'velocity_2 = ["2 m/s", "0 m/s"]', FORMS),
        (MEAN, 'mean_velocity = ["0 m/s", "0 m/s"]', "must not be zero; give velocity_1 and veloc"),
        (MEAN, 'mean_velocity = "2 m/s"', 'motion.mean_velocity = "2 m/s": must be a list'),
        (MEAN, 'mean_velocity = ["2 m", "0 m/s"]', 'motion.mean_velocity[0] = "2 m": must be a ve'),
    ],
)
def test_wrong_values_in_a_traction_curve(refuse, old, new, sentence):
    assert sentence in refuse(changed(TRACTION, (old, new)))


SHEAR = 'law = "eyring-limited" # equation 6'


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (SHEAR, "", "oil.shear.law is missing"),
        (SHEAR, 'law = "ering"', 'oil.shear.law = "ering": must be one of "newtonian", "eyring"'),
        (SHEAR, 'law = "eyring"', "oil.shear.limit: no such key; valid keys are law, stress"),
        (SHEAR, 'law = "bair-winer"', "oil.shear.stress: no such key; valid keys are law, limit"),
        (SHEAR, 'law = "carreau"', "oil.shear.limit: no such key; valid keys are exponent, law, s"),
        (SHEAR, 'law = "newtonian"', "oil.shear.stress: no such key; valid keys are law\n"),
        ('"3 MPa"', "3", 'oil.shear.stress = 3: must be a stress with its unit, such as "3 MPa"'),
        ('"3 MPa"', '"0 MPa"', 'oil.shear.stress = "0 MPa": must be a stress greater than zero'),
        ('stress = "3 MPa"', "", "oil.shear.stress is missing"),
        (
            '"3 MPa"',
            '"3 MPa"\nstress_pressure = "2 1/K"',
            'oil.shear.stress_pressure = "2 1/K": must be a pressure coefficient with its unit',
        ),
        (
            '"3 MPa"',
            '"3 MPa"\nstress_temperature = 0.01',
            "oil.shear.stress_temperature = 0.01: must be a temperature coefficient with its unit",
        ),
        ('"100 MPa"', '"-1 MPa"', 'oil.shear.limit = "-1 MPa": must be a stress zero or more'),
        ('limit = "100 MPa"', "", 'give limit, such as "100 MPa", or limit_pressure, such as 0.05'),
        (
            'limit = "100 MPa"',
            "limit_pressure = -0.1",
            "oil.shear.limit_pressure = -0.1: must be at least 0",
        ),
        ("exponent = 1", "exponent = 0", "oil.shear.exponent = 0: must be greater than 0"),
    ],
)
def test_wrong_values_of_shear(refuse, old, new, sentence):
    assert sentence in refuse(changed(DRIVE, (old, new)))


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('tilt = "0 deg"', 'inertia = "3 kg mm"', 'drive.rollers.inertia = "3 kg mm"'),
        (
            'tilt = "0 deg"',
            'inertia = "-1 kg mm^2"',
            "must be a moment of inertia greater than zero",
        ),
        ('"free"', '"free"\ndriving = "both"', 'operation.driving = "both"'),
        ('"free"', '"spinning"', 'operation.rolling = "spinning"'),
        ('"110 N m"', '"0 N m"\ndriving = "right"', 'sections has "left", the idling section'),
    ],
)
def test_wrong_values_of_rollers(refuse, old, new, sentence):
    assert sentence in refuse(changed(ROLLERS, (old, new)))


@pytest.mark.parametrize(
    ("exponent", "sentence"),
    [
        ("", "oil.shear.exponent is missing"),
        ("exponent = 0", "oil.shear.exponent = 0: must be greater than 0"),
        ("exponent = 1.5", "oil.shear.exponent = 1.5: must be at most 1"),
    ],
)
def test_wrong_values_of_carreau(refuse, exponent, sentence):
    shear = f'[oil.shear]\nlaw = "carreau"\nstress = "6 MPa"\n{exponent}\n'
    assert sentence in refuse(f"{CONTACT}\n{shear}")


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("[oil.heat]", "[oil.thermal]", "oil.thermal: no such key"),
        ('inlet_temperature = "60 degC"', "", "oil.heat.inlet_temperature is missing"),
        ('"60 degC"', '"60 K"', 'oil.heat.inlet_temperature = "60 K": must be a temperature betw'),
        ('"60 degC"', "60", "oil.heat.inlet_temperature = 60: must be a temperature with its unit"),
        ("s0 = 0.782", "", "heat needs either s0 or beta, one of the two"),
        ("s0 = 0.782", 's0 = 0.782\nbeta = "0.04 1/K"', "heat needs either s0 or beta"),
        ("s0 = 0.782", "s0 = -0.782", "oil.heat.s0 = -0.782: must be greater than 0"),
        ("s0 = 0.782", 'beta = "-0.04 1/K"', "must be a temperature coefficient greater than zero"),
        ("s0 = 0.782", "beta = 0.04", "oil.heat.beta = 0.04: must be a temperature coefficient w"),
        (
            'law = "roelands"\neta0 = "0.227 Pa s"\nz = 0.227\npole_coefficient = "5.1 1/GPa"',
            'law = "barus"\neta0 = "0.227 Pa s"\nalpha = "9.5 1/GPa"',
            "heat needs beta, and no s0, where viscosity.law is barus",
        ),
        ('"0.148 W/(m K)"', '"0 W/(m K)"', "oil.heat.conductivity"),
        ('conductivity = "0.148 W/(m K)"', "", "oil.heat.conductivity is missing"),
        ('specific_heat = "1844 J/(kg K)"', "", "oil.heat.specific_heat is missing"),
        ('"1844 J/(kg K)"', '"1844 J/kg"', "oil.heat.specific_heat"),
        ('"7.1e-4 1/K"', '"-7.1e-4 1/K"', "oil.heat.expansivity"),
        ('expansivity_decay = "1.5', 'expansivity_decay = "-1.5', "oil.heat.expansivity_decay"),
        ('conductivity_c1 = "1.56', 'conductivity_c1 = "-1.56', "oil.heat.conductivity_c1"),
        ('conductivity_c2 = "0.61', 'conductivity_c2 = "-0.61', "oil.heat.conductivity_c2"),
        ('"3.4e-4 1/K"', '"3.4e-4 1/GPa"', "oil.heat.heat_capacity_b0"),
        ('"3.3 1/GPa"', '"3.3 1/K"', "oil.heat.heat_capacity_b1"),
        ('"-2.3 1/GPa^2"', '"-2.3 1/GPa"', "oil.heat.heat_capacity_b2"),
        ('heat_capacity_k1 = "0.5', 'heat_capacity_k1 = "-0.5', "oil.heat.heat_capacity_k1"),
        ('heat_capacity_k2 = "0.51', 'heat_capacity_k2 = "-0.51', "oil.heat.heat_capacity_k2"),
        # what the bodies owe to heat
        ('density = "7900 kg/m^3"', "", "bodies.worm.density is missing; [oil.heat] asks for it"),
        ('conductivity = "52 W/(m K)"', "", "bodies.wheel.conductivity is missing; [oil.heat] ask"),
        ('specific_heat = "420 J/(kg K)"', "", "bodies.wheel.specific_heat is missing; [oil.heat]"),
        (
            "[bodies.wheel]",
            "[bodies.wheel]\nbulk_temperature = 60",
            "bodies.wheel.bulk_temperature = 60: must be a temperature with its unit",
        ),
    ],
)
def test_wrong_values_of_heat(refuse, old, new, sentence):
    assert sentence in refuse(changed(DRIVE, (old, new)))


def test_a_bulk_temperature_without_heat(refuse):
    text = changed(CONTACT, ("[bodies.body_2]", '[bodies.body_2]\nbulk_temperature = "60 degC"'))
    assert "bodies.body_2.bulk_temperature has no effect without [oil.heat]" in refuse(text)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        # too far apart, too close
        ([('centre_distance = "304.8 mm"', 'centre_distance = "330 mm"')], "drive.centre_distance"),
        ([('centre_distance = "304.8 mm"', 'centre_distance = "290 mm"')], "drive.centre_distance"),
        # a table that contradicts itself
        ([("threads = 3", "threads = 2")], "drive.worm.axial_pitch is 28.73 mm"),
        ([('"27.61 deg"', '"10 deg"')], "drive.worm.base_lead_angle is 10.00 deg"),
        ([('"96.02 mm"', '"56 mm"')], "drive.worm.tip_diameter is 56.00 mm"),
        # a worm of half the module
        (
            [
                ('"28.73 mm"', '"14.365 mm"'),
                ('"86.18 mm"', '"43.09 mm"'),
                ('"27.61 deg"', '"14.65 deg"'),
            ],
            "equal to mesh",
        ),
        # a hob set up so that the contact leaves the teeth
        ([('"0.255 deg"', '"1.2 deg"')], "hob.swivel"),
        # a hob smaller than the worm, of the same normal base pitch
        (
            [
                ('tip_diameter = "103.26 mm"', 'tip_diameter = "99 mm"'),
                ('"63.16 mm"', '"58.06 mm"'),
                ('"52.96 mm"', '"51.8 mm"'),
                ('"85.97 mm"', '"86.48 mm"'),
                ('"28.66 mm"', '"28.827 mm"'),
                ('"27.33 deg"', '"27.99 deg"'),
                ('"305.62 mm"', '"304.5 mm"'),
                ('"0.255 deg"', '"0 deg"'),
                ('"-0.519 mm"', '"0 mm"'),
            ],
            "a hob at least as large as the worm",
        ),
    ],
)
def test_parts_that_do_not_mesh(refuse, changes, sentence):
    assert sentence in refuse(changed(DRIVE, *changes))


@pytest.mark.parametrize(
    ("arrays", "sentence"),
    [
        ({"gap": np.zeros((8, 8, 2)), "dx": 1e-5, "dy": 1e-5}, "gap must have two dimensions"),
        ({"gap": np.zeros((3, 8)), "dx": 1e-5, "dy": 1e-5}, "at least 5 samples a side"),
        ({"gap": np.zeros((8, 8))}, "dx is missing; it has gap"),
        ({"height": np.zeros((8, 8)), "dx": 1e-5, "dy": 1e-5}, "gap is missing; it has height"),
        ({"gap": np.zeros((8, 8)), "dx": 1e-5, "dy": 1e-5}, "gap must open away from the contact"),
    ],
)
def test_files_that_hold_no_gap(refuse, tmp_path, arrays, sentence):
    np.savez(tmp_path / "gap_example.npz", **arrays)
    error = refuse(GAP)
    assert 'contact.file = "gap_example.npz": ' in error
    assert sentence in error


def test_a_gap_that_is_least_elsewhere(refuse, tmp_path):
    x = 1e-5 * np.arange(-60, 61)
    gap = (x - 1.5e-4) ** 2 / 0.02 + x[:, None] ** 2 / 0.02
    np.savez(tmp_path / "gap_example.npz", gap=gap, dx=1e-5, dy=1e-5)
    assert "gap is least near x = 0.00015 m, not at the contact point" in refuse(GAP)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('radii = ["10 mm", "10 mm"]', 'radii = ["100 km", "10 mm"]', "within a factor of 1e+06"),
        ('"0.46227 m/s"', '"1e-20 m/s"', "beyond all experience"),
    ],
)
def test_values_out_of_all_proportion(tmp_path, capsys, old, new, sentence):
    text = (CASES / "point_m20_l10.toml").read_text()
    assert old in text
    (tmp_path / "case.toml").write_text(text.replace(old, new))
    assert sentence in refusal(["check", str(tmp_path / "case.toml")], tmp_path, capsys)


def test_a_gap_file_that_is_not_there(refuse):
    assert 'contact.file = "gap_example.npz": no such file' in refuse(GAP)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["run", "none.toml"], "none.toml: no such file"),
        (["run"], "required: CASE.toml"),
        (["walk"], "invalid choice: 'walk'"),
        (
            ["run", "CASE", "--effects", "some"],
            "effects = some: some is none of auto, all, isothermal",
        ),
        (["run", "CASE", "--effects", "film-heating"], "[oil.heat] is not given"),
        (["run", "CASE", "--quantities", "noise"], "quantities: noise is none of film, friction"),
        (
            ["run", "CASE", "--quantities", "film,friction"],
            "friction cannot be found without [oil.sh",
        ),
        (["run", "CASE", "--accuracy", "much"], "--accuracy much: must be a share"),
        (["run", "CASE", "--phase", "0.5"], "it is one contact"),
        (["run", "CASE", "--slide-roll-ratio", "-0.5"], "gives no motion.mean_velocity"),
        (["run", "DRIVE", "--slide-roll-ratio", "1"], "slide-roll ratio 1: zi_sharif_2001 gives"),
        (["run", "TRACTION", "--slide-roll-ratio", "much"], "invalid float value: 'much'"),
        (["run", "TRACTION", "--slide-roll-ratio", "nan"], "slide-roll ratio nan: must be finite"),
        (["run", "TRACTION", "--phase", "0.5"], "has no mesh cycle"),
        (["run", "DRIVE", "--phase", "1.5"], "phase 1.5: must lie between 0 and 1"),
        (["run", "CASE", "--out", "a_file"], "a_file: is a file, results need a directory"),
        (["run", "CASE", "--out", "a_file/b"], "a_file: is a file, results need a directory"),
        (["plot", "none.nc"], "none.nc"),
        (["plot", "a_file"], "a_file is not a pyworm result"),
    ],
)
def test_wrong_commands(tmp_path, monkeypatch, capsys, arguments, sentence):
    monkeypatch.chdir(tmp_path)
    Path("a_file").write_text("not much")
    places = {
        "CASE": str(CASES / "point_m20_l10.toml"),
        "DRIVE": str(CASES / "zi_sharif_2001.toml"),
        "TRACTION": str(CASES / "traction_steel.toml"),
    }
    arguments = [places.get(word, word) for word in arguments]
    assert sentence in refusal(arguments, tmp_path, capsys)


def test_a_process_ends_the_same_way(tmp_path):
    """As `main` is tested above, once through a real command line."""
    (tmp_path / "case.toml").write_text(changed(DRIVE, ('load = "14 kN"', "load = 14")))
    program = "import sys; from pyworm.cli.main import main; sys.exit(main())"
    ended = subprocess.run(
        [sys.executable, "-c", program, "run", "case.toml"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert ended.returncode == BAD_INPUT
    assert ended.stdout == ""
    assert ended.stderr == (
        'pyworm: case.toml: operation.load = 14: must be a force with its unit, such as "14 kN"\n'
    )
    assert [path.name for path in tmp_path.iterdir()] == ["case.toml"]
