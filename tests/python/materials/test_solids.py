"""Materials of bodies by name."""

import tomllib
from pathlib import Path

import pytest
from folders import CASES
from zi_drives import coarse_springs

from pyworm.case.case import case_again, case_of
from pyworm.io.input_error import CaseError
from pyworm.materials import solids
from pyworm.materials.body import Body, reduced_modulus

CASE = (CASES / "worm_drawing.toml").read_text()


def bodies(worm='material = "16MnCr5"', wheel='material = "CuSn12Ni2-C-GZ"'):
    text = CASE[: CASE.index("[bodies.worm]")]
    text += f"[bodies.worm]\n{worm}\n[bodies.wheel]\n{wheel}\n" + CASE[CASE.index("[oil]") :]
    text = text.replace("phases = [0.1, 0.3, 0.5, 0.7, 0.9]", "phases = [0.5]")
    return case_of(tomllib.loads(text), "by_name", Path())


@pytest.mark.parametrize(
    ("name", "standard"),
    [
        ("CuSn12", 140144),
        ("CuSn12Ni2", 150622),
        ("CuAl10Fe5Ni5", 174053),
        ("GJS", 209790),
        ("GJL", 146955),
    ],
)
def test_reduced_moduli_with_a_steel_worm_are_those_of_the_standard(name, standard):
    """E_red of DIN 3996 [MPa]."""
    pair = [solids.SolidTable.model_validate(_as_written(of)) for of in ("16MnCr5", name)]
    worm, wheel = (Body(of.youngs_modulus, of.poisson_ratio) for of in pair)
    assert reduced_modulus(worm, wheel) / 1e6 == pytest.approx(standard, rel=1e-4)


def test_boundary_friction_of_wheels_stands_to_each_other_as_friction_at_rest(monkeypatch):
    """0.13, 0.15 and 0.18 (DIN 3996, as others copied it), of which none is in the fit."""
    coarse_springs(monkeypatch)
    tin, aluminium, iron = (
        bodies(wheel=f'material = "{name}"').scene(phase=0.5).boundary_friction
        for name in ("CuSn12Ni2", "CuAl10Fe5Ni5", "GJS")
    )
    assert tin < aluminium < iron
    assert aluminium / tin == pytest.approx(0.15 / 0.13, rel=0.15)
    assert iron / tin == pytest.approx(0.18 / 0.13, rel=0.15)


@pytest.mark.parametrize("alloy", ["CuSn12", "CuSn12Ni2", "CuAl10Fe5Ni5"])
def test_boundary_friction_is_the_alloy_s_however_it_is_cast(alloy):
    poured = {Body.from_name(f"{alloy}-C-{way}").boundary_friction_factor for way in ("GZ", "GC")}
    assert len(poured) == 1


def _as_written(name):
    name = solids.named_material(name)
    table = solids.constants(name) | {"aliases": [], "source": solids.source(name)}
    if "modulus_by_temperature" in table:
        del table["youngs_modulus"]
    return table


@pytest.mark.parametrize(
    "text", ["CuSn12Ni2-C-GZ", "CuSn12Ni2-GZ", "cusn12ni2-gz", "CC484K", " CuSn12Ni2"]
)
def test_a_bronze_has_many_names(text):
    assert solids.named_material(text) == "CuSn12Ni2-C-GZ"


def test_every_material_is_sensible_and_has_a_source():
    assert len(solids.materials()) >= 6
    for name in solids.materials():
        table = solids.SolidTable.model_validate(_as_written(name))
        assert table.source
        diffusivity = table.conductivity / table.density / table.specific_heat
        if table.modulus_by_temperature:
            assert 0.1e-6 < diffusivity < 0.2e-6 and 0.1e9 < table.hardness < 0.3e9
            assert 350 < table.temperature_limit < 550
        else:
            assert 0.5e9 < table.hardness < 0.05 * table.youngs_modulus
            assert 5e-6 < diffusivity < 25e-6  # m2/s


def test_a_named_material_gives_what_is_not_given_beside_it():
    case = bodies(wheel='material = "CuSn12-GZ"\nhardness = "1.1 GPa"\nconductivity = "60 W/(m K)"')
    worm, wheel = case.drive.bodies
    assert worm.youngs_modulus == pytest.approx(210e9) and worm.hardness > 5e9
    assert wheel.youngs_modulus == pytest.approx(88.3e9)
    assert (wheel.hardness, wheel.conductivity) == pytest.approx((1.1e9, 60))
    assert case.tables.bodies.wheel.material == "CuSn12-C-GZ"


def test_a_finish_is_a_usual_roughness():
    case = bodies(
        worm='material = "16MnCr5"\nfinish = "ground"', wheel='material = "GJS"\nfinish = "hobbed"'
    )
    worm, wheel = case.drive.bodies
    assert wheel.roughness == pytest.approx(2 * worm.roughness)
    assert worm.roughness == pytest.approx(1.2533 * 0.4e-6, rel=1e-4)


def test_what_stands_behind_names_is_among_the_assumptions():
    case = bodies(worm='material = "16MnCr5"\nfinish = "ground"')
    assert "case-hardened" in case.tables.assumed["bodies.worm.material"]
    assert "Ra 0.4 um" in case.tables.assumed["bodies.worm.finish"]
    assert "bodies.wheel.finish" not in case.tables.assumed


def test_results_store_the_constants_and_not_the_name_alone():
    case = bodies()
    again = case_again(case.resolved)
    assert again.tables.bodies.wheel.youngs_modulus == pytest.approx(98.1e9)
    assert again.tables.assumed == case.tables.assumed


@pytest.mark.parametrize(
    ("worm", "says"),
    [
        ('material = "16MnCr"', 'bodies.worm.material = "16MnCr": must be one of 16MnCr5'),
        ('material = "16MnCr"', 'did you mean "16MnCr5"?'),
        ("material = 5", "bodies.worm.material = 5: must be a text"),
        (
            'material = "16MnCr5"\nfinish = "lapped"',
            'bodies.worm.finish = "lapped": must be one of',
        ),
        (
            'material = "16MnCr5"\nfinish = "ground"\nroughness = "1 um"',
            "give either finish or roughness",
        ),
        ('finish = "ground"', "bodies.worm.youngs_modulus is missing"),
    ],
)
def test_wrong_names_are_refused(worm, says):
    with pytest.raises(CaseError) as refused:
        bodies(worm=worm)
    assert says in str(refused.value)
