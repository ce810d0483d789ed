"""Case files become cases and cases become scenes."""

import json
import re

import numpy as np
import pytest
import xarray as xr
from folders import ROOT

from pyworm.case.case import load
from pyworm.formulas.hertz import hertz
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Roelands
from pyworm.planning.plan import plan
from pyworm.ratings.rated_case import load_rating_request, ratings
from pyworm.scene.gap_file import read_gap
from pyworm.scene.line import LineScene
from pyworm.scene.sampled_gap import SampledGap
from pyworm.scene.scales import line_scales

CASES = ROOT / "cases"
FILES = sorted(CASES.glob("*.toml"))
RATINGS = [path for path in FILES if not re.search(r"(?m)^\[(drive|contact)\]", path.read_text())]
SHIPPED = [path for path in FILES if path not in RATINGS]
CONTACTS = [path for path in SHIPPED if "[drive]" not in path.read_text()]
LINES = [path for path in CONTACTS if 'kind = "line-contact"' in path.read_text()]
POINTS = [path for path in CONTACTS if path not in LINES]


def moes(scene):
    """Moes' M and L along x, by the definitions."""
    viscosity = scene.oil.viscosity
    (u,), _ = scene.entrainment(np.zeros(1), np.zeros(1))
    speed = viscosity.eta0 * u / (scene.reduced_modulus * scene.radii[0])
    load = scene.load / (scene.reduced_modulus * scene.radii[0] ** 2)
    return (
        load * (2 * speed) ** -0.75,
        viscosity.alpha * scene.reduced_modulus * (2 * speed) ** 0.25,
    )


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_every_shipped_case_is_right(path):
    case = load(path)
    assert case.name == path.stem
    assert case.title and case.source
    assert json.loads(json.dumps(case.resolved)) == case.resolved


@pytest.mark.parametrize("path", RATINGS, ids=lambda path: path.stem)
def test_every_shipped_file_of_ratings_is_rated(path):
    asked = load_rating_request(path)
    assert asked.name == path.stem
    assert asked.tables.title and asked.tables.source
    assert ratings(asked)


SWEPT = ("traction_steel", "film_rig")
"""Contacts at slide-roll ratios, of the latter at one."""

SINGLE = [path for path in CONTACTS if path.stem not in SWEPT]


@pytest.mark.parametrize("path", SINGLE, ids=lambda path: path.stem)
def test_every_shipped_contact_makes_one_scene(path):
    (scene,) = load(path).scenes()
    assert scene.phase is None and scene.slide_roll_ratio is None
    assert scene.name == path.stem


@pytest.mark.parametrize("path", CONTACTS, ids=lambda path: path.stem)
def test_every_shipped_contact_can_be_planned(path):
    assert plan(load(path).scene()).grids


@pytest.mark.parametrize("path", POINTS, ids=lambda path: path.stem)
def test_the_surfaces_touch_at_the_contact_point(path):
    gap, covered = load(path).scene().gap(np.zeros((1, 1)), np.zeros((1, 1)))
    assert covered.all()
    assert abs(gap.item()) < 1e-9


@pytest.mark.parametrize(("m", "el"), [(20, 10), (100, 10), (200, 10), (1000, 10), (200, 20)])
def test_model_contacts_have_the_parameters_in_their_name(m, el):
    scene = load(CASES / f"point_m{m}_l{el}.toml").scene()
    assert moes(scene) == pytest.approx((m, el), rel=1e-4)


@pytest.mark.parametrize("m", [20, 200])
def test_model_line_contacts_have_the_parameters_in_their_name(m):
    scene = load(CASES / f"line_m{m}_l10.toml").scene()
    assert isinstance(scene, LineScene)
    groups = line_scales(scene).groups
    assert (groups.moes_m, groups.moes_l) == pytest.approx((m, 10), rel=1e-4)
    assert scene.sliding == 0


def test_mourier_has_the_published_parameters():
    scene = load(CASES / "mourier_2006.toml").scene()
    assert scene.reduced_modulus == pytest.approx(110e9)
    assert moes(scene) == pytest.approx((63.78, 5.788), rel=1e-3)


def test_spin_like_the_worms_is_that_of_the_mean_velocity():
    scene = load(CASES / "spin_zi_like.toml").scene()
    semi_axis = 10.781e-3
    u, v = scene.entrainment(np.array([0.0, semi_axis]), np.array([semi_axis, 0.0]))
    assert u == pytest.approx([0, 2.75], abs=2e-4)
    assert v == pytest.approx([0, 2.75], abs=2e-4)


def test_sharif_case_holds_the_tables_of_the_paper():
    case = load(CASES / "zi_sharif_2001.toml")
    tables = case.tables
    assert 0.5 in case.mesh_places["phase"]
    assert tables.drive.threads == 3
    assert tables.drive.teeth == 59
    assert tables.drive.hob.centre_distance == pytest.approx(305.62e-3)
    assert tables.operation.worm_speed == pytest.approx(50 * np.pi)
    assert tables.oil.heat.inlet_temperature == pytest.approx(333.15)
    assert case.published["dry_pressure_max"].value == pytest.approx(540e6)
    # The paper's equivalent coefficient follows from z and eta0: a check of both and of the pole.
    assert tables.oil.oil().viscosity.alpha == pytest.approx(9.5e-9, rel=5e-3)


def test_sharif_oil_shears_and_takes_heat_as_the_paper_has_it():
    scene = load(CASES / "zi_sharif_2001.toml").scene()
    assert scene.oil.flow == FlowLaw("eyring-limited", stress=3e6, limit=100e6, exponent=1)
    heat = scene.oil.heat
    assert heat.inlet_temperature == pytest.approx(333.15)
    assert heat.viscosity_exponent == 0.782
    assert (heat.conductivity, heat.specific_heat) == (0.148, 1844)
    assert (heat.expansivity, heat.expansivity_decay) == pytest.approx((7.1e-4, 1.5e-9))
    assert (heat.conductivity_c1, heat.conductivity_c2) == pytest.approx((1.56e-9, 0.61e-9))
    assert heat.heat_capacity_b0 == pytest.approx(3.4e-4)
    assert heat.heat_capacity_b1 == pytest.approx(3.3e-9)
    assert heat.heat_capacity_b2 == pytest.approx(-2.3e-18)
    assert (heat.heat_capacity_k1, heat.heat_capacity_k2) == pytest.approx((0.5e-9, 0.51e-9))
    for body, conductivity in zip(scene.bodies, (47, 52), strict=True):
        assert body.conductivity == conductivity
        assert body.bulk_temperature == heat.inlet_temperature


PAO_B = {"traction_steel": 60, "opposite_sliding": 40}


@pytest.mark.parametrize(("name", "celsius"), PAO_B.items())
def test_the_polyalphaolefin_has_its_published_viscosity(name, celsius):
    oil = load(CASES / f"{name}.toml").scene().oil
    warmth = 1 + celsius / 135
    assert oil.viscosity.eta0 == pytest.approx(10 ** (-4.2 + 4.57 * warmth**-1.25), rel=1e-3)
    assert oil.viscosity.z == pytest.approx(0.5 - 0.071 * np.log10(warmth), rel=1e-3)
    assert oil.heat.inlet_temperature == pytest.approx(celsius + 273.15)
    assert oil.heat.viscosity_exponent == 1.25
    assert oil.flow.stress == pytest.approx(2 * 0.035 / oil.viscosity.alpha, rel=0.01)


def test_traction_is_asked_at_one_gigapascal_from_rolling_to_beyond_a_disc_at_rest():
    case = load(CASES / "traction_steel.toml")
    scenes = list(case.scenes())
    assert len(scenes) == len(case.slide_roll_ratios) >= 10
    assert min(case.slide_roll_ratios) == 0 and max(case.slide_roll_ratios) > 2
    for scene, ratio in zip(scenes, case.slide_roll_ratios, strict=True):
        contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
        assert contact.pressure_max == pytest.approx(1e9, rel=1e-3)
        (entrainment, _), (sliding, _) = scene.entrainment(0.0, 0.0), scene.sliding(0.0, 0.0)
        assert entrainment == 2.0
        assert sliding == pytest.approx(2 * ratio, abs=1e-15)
        assert scene.slide_roll_ratio == ratio
        assert scene.name == f"slide-roll ratio {ratio:g}"
        assert scene.phase is None


def test_a_traction_curve_may_be_looked_at_elsewhere():
    case = load(CASES / "traction_steel.toml")
    assert case.scene().slide_roll_ratio == case.slide_roll_ratios[0]
    backwards, far = case.scenes(slide_roll_ratio=(-1.0, 6.0))
    assert [motion.u for motion in backwards.motions] == [1, 3]
    assert [motion.u for motion in far.motions] == [8, -4]


def test_sliding_is_along_the_mean_velocity_and_spins_stay(tmp_path):
    text = (CASES / "traction_steel.toml").read_text()
    old = 'mean_velocity = ["2 m/s", "0 m/s"]'
    assert old in text
    path = tmp_path / "oblique.toml"
    path.write_text(text.replace(old, 'mean_velocity = ["3 m/s", "-4 m/s"]\nspin_2 = "5 rad/s"'))
    scene = load(path).scene(slide_roll_ratio=0.5)
    assert [(of.u, of.v, of.spin) for of in scene.motions] == [(3.75, -5, 0), (2.25, -3, 5)]


def test_opposite_sliding_entrains_nothing():
    scene = load(CASES / "opposite_sliding.toml").scene()
    assert scene.entrainment(0.0, 0.0) == (0, 0)
    assert scene.sliding(0.0, 0.0) == (6, 0)
    assert scene.bodies[0] == scene.bodies[1]


def heated(tmp_path, viscosity, heat, wall=""):
    """The scene of a small contact between warm walls of one material, with this oil."""
    body = """
        youngs_modulus = "206 GPa"
        poisson_ratio = 0.3
        density = "7850 kg/m^3"
        conductivity = "47 W/(m K)"
        specific_heat = "450 J/(kg K)"
        """
    path = tmp_path / "case.toml"
    path.write_text(f"""
        title = "t"
        source = "s"
        [contact]
        kind = "line-contact"
        radius = "10 mm"
        load = "100 kN/m"
        [motion]
        velocity_1 = "1 m/s"
        velocity_2 = "2 m/s"
        [bodies.body_1]{body}{wall}
        [bodies.body_2]{body}
        [oil]
        name = "simple"
        viscosity = {viscosity}
        density = {{law = "incompressible", rho0 = "850 kg/m^3"}}
        heat = {heat}
        """)
    return load(path).scene()


SIMPLE = (
    'inlet_temperature = "40 degC", conductivity = "0.14 W/(m K)", specific_heat = "2 kJ/(kg K)"'
)


def test_a_simple_oil_needs_four_numbers_for_heat(tmp_path):
    barus = '{law = "barus", eta0 = "0.05 Pa s", alpha = "20 1/GPa"}'
    scene = heated(tmp_path, barus, f'{{{SIMPLE}, beta = "0.04 1/K"}}')
    assert scene.oil.heat == OilHeat(313.15, 0.04, conductivity=0.14, specific_heat=2000)
    assert scene.oil.flow is None


def test_the_slope_of_roelands_law_in_temperature_becomes_its_exponent(tmp_path):
    roelands = '{law = "roelands", eta0 = "0.05 Pa s", z = 0.6}'
    scene = heated(tmp_path, roelands, f'{{{SIMPLE}, beta = "0.04 1/K"}}')
    oil, step = scene.oil, 1e-3

    def log_viscosity(temperature):  # equation 20 of Sharif et al. at ambient pressure
        warmth = (temperature - 138) / (oil.heat.inlet_temperature - 138)
        return (np.log(0.05) + 9.67) * (warmth**-oil.heat.viscosity_exponent - 1)

    slope = (log_viscosity(313.15 + step) - log_viscosity(313.15 - step)) / (2 * step)
    assert slope == pytest.approx(-0.04, rel=1e-6)


def test_a_body_may_have_a_bulk_temperature_of_its_own(tmp_path):
    barus = '{law = "barus", eta0 = "0.05 Pa s", alpha = "20 1/GPa"}'
    heat = f'{{{SIMPLE}, beta = "0.04 1/K"}}'
    scene = heated(tmp_path, barus, heat, wall='bulk_temperature = "55 degC"')
    assert [body.bulk_temperature for body in scene.bodies] == pytest.approx([328.15, 313.15])


def test_a_case_without_heat_has_no_temperatures():
    scene = load(CASES / "point_m20_l10.toml").scene()
    assert scene.oil.heat is None
    assert [body.bulk_temperature for body in scene.bodies] == [None, None]


def test_the_case_of_the_reference_page_is_right(tmp_path):
    page = (ROOT / "docs/reference/case-files.md").read_text()
    blocks = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert len(blocks) == 1
    path = tmp_path / "page.toml"
    path.write_text(blocks[0])
    assert load(path).scene().load == pytest.approx(20.0)


def test_both_published_forms_of_the_pole_are_taken(tmp_path):
    text = (CASES / "point_m20_l10.toml").read_text()
    path = tmp_path / "case.toml"
    path.write_text(text.replace('pole_pressure = "196 MPa"', 'pole_coefficient = "5.1 1/GPa"'))
    viscosity = load(path).scene().oil.viscosity
    assert isinstance(viscosity, Roelands)
    assert viscosity.p0 == pytest.approx(1 / 5.1e-9)
    assert viscosity.alpha == pytest.approx(22e-9)


# ------------------------------------------------------------------------------------ sampled gaps


def crowned(count_x=41, count_y=61):
    """A crowned roller of radii 10 mm and 2 m, with coordinates."""
    x = np.linspace(-0.5e-3, 0.5e-3, count_x)
    y = np.linspace(-3e-3, 3e-3, count_y)
    return x, y, x[None, :] ** 2 / 0.02 + y[:, None] ** 2 / 4


def test_a_sampled_paraboloid_is_the_paraboloid_between_and_beyond_its_samples():
    gap = SampledGap(*crowned())
    assert gap.radii == pytest.approx((0.01, 2.0))
    x, y = np.meshgrid(np.linspace(-1e-3, 1e-3, 33), np.linspace(-4e-3, 4e-3, 35))
    values, covered = gap(x, y)
    assert np.abs(values - (x**2 / 0.02 + y**2 / 4)).max() < 1e-15
    assert np.array_equal(covered, (np.abs(x) <= 0.5e-3) & (np.abs(y) <= 3e-3))


def test_a_missing_body_is_continued_smoothly_and_not_covered():
    x, y, values = crowned()
    torn = values.copy()
    torn[y > 2e-3] = np.nan
    gap = SampledGap(x, y, torn)
    filled, covered = gap(x[None, :], y[:, None])
    assert np.abs(filled - values).max() < 1e-12
    assert not covered[y > 2e-3].any()
    assert covered[y < 1.9e-3].all()


def test_a_straight_roller_has_radii_of_finite_size():
    x, y, values = crowned()
    flat = np.broadcast_to(x**2 / 0.02, values.shape).copy()
    assert SampledGap(x, y, flat).radii == pytest.approx((0.01, 10.0), rel=1e-6)


def test_npz_and_netcdf_hold_the_same_gap(tmp_path):
    x, y, values = crowned()
    np.savez(tmp_path / "a.npz", gap=values, dx=x[1] - x[0], dy=y[1] - y[0], x0=x[0], y0=y[0])
    np.savez(tmp_path / "b.npz", gap=values, dx=x[1] - x[0], dy=y[1] - y[0])
    dataset = xr.Dataset({"gap": (("x", "y"), values.T)}, coords={"x": x, "y": y})
    dataset.to_netcdf(tmp_path / "c.nc", engine="netcdf4")
    for name in ("a.npz", "b.npz", "c.nc"):
        gap = read_gap(tmp_path / name)
        assert gap.x == pytest.approx(x)
        assert gap.y == pytest.approx(y)
        assert np.array_equal(gap.gap, values)


def save(path, **arrays):
    np.savez(path, **arrays)
    return path


@pytest.mark.parametrize(
    ("arrays", "message"),
    [
        ({"gap": np.zeros((9, 9, 2)), "dx": 1e-5, "dy": 1e-5}, "two dimensions"),
        ({"gap": np.zeros(9), "dx": 1e-5, "dy": 1e-5}, "two dimensions"),
        ({"gap": np.zeros((3, 9)), "dx": 1e-5, "dy": 1e-5}, "at least 5 samples"),
        ({"gap": np.zeros((9, 9)), "dy": 1e-5}, "dx is missing"),
        ({"gap": np.zeros((9, 9)), "dx": 1e-5, "dy": 0.0}, "dy must be one length"),
        ({"gap": np.zeros((9, 9)), "dx": [1e-5, 1e-5], "dy": 1e-5}, "dx must be one length"),
        ({"dx": 1e-5, "dy": 1e-5}, "gap is missing"),
        ({"gap": np.full((9, 9), np.nan), "dx": 1e-5, "dy": 1e-5}, "at the contact point"),
        ({"gap": np.full((9, 9), np.inf), "dx": 1e-5, "dy": 1e-5}, "finite"),
        ({"gap": np.zeros((9, 9)), "dx": 1e-5, "dy": 1e-5, "x0": 0.0}, "contact point"),
        ({"gap": np.array([["a"]]), "dx": 1e-5, "dy": 1e-5}, "npz file of numbers"),
    ],
)
def test_what_is_no_gap_is_refused(tmp_path, arrays, message):
    with pytest.raises(ValueError, match=message):
        read_gap(save(tmp_path / "gap.npz", **arrays))


def test_a_gap_that_does_not_open_is_refused():
    x, y, values = crowned()
    with pytest.raises(ValueError, match="must open"):
        _ = SampledGap(x, y, -values).radii


def test_a_netcdf_gap_needs_its_coordinates(tmp_path):
    xr.Dataset({"gap": (("y", "x"), crowned()[2])}).to_netcdf(tmp_path / "gap.nc", engine="netcdf4")
    with pytest.raises(ValueError, match="x is missing"):
        read_gap(tmp_path / "gap.nc")
