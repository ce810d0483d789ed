"""Oils by data sheet and by measurements, one property changed, bodies by name, roughness objects."""

import numpy as np
import pytest
from contacts import ball

import pyworm
from pyworm.materials.library import named_oil

PAO = named_oil("PAO VG 220")
SHEET = {"nu40": "220 mm^2/s", "nu100": "26 mm^2/s", "base": "PAO"}


def test_a_data_sheet_gives_its_own_values_back():
    oil = pyworm.NamedOil.from_datasheet(
        **SHEET, density15=860, alpha="15 1/GPa", alpha_at="50 degC"
    )
    assert float(oil.kinematic_viscosity("40 degC")) == pytest.approx(220e-6)
    assert float(oil.kinematic_viscosity("100 degC")) == pytest.approx(26e-6)
    assert float(oil.density("15 degC")) == pytest.approx(860)
    assert float(oil.alpha("50 degC")) == pytest.approx(15e-9)
    hot = oil.oil("80 degC")
    # alpha falls with the viscosity as that of its base stock
    fall = float(PAO.alpha("80 degC") / PAO.alpha("50 degC"))
    assert hot.viscosity.alpha == pytest.approx(15e-9 * fall, rel=0.01)
    assert hot.alpha_spread == 0 < PAO.oil("80 degC").alpha_spread


def test_a_viscosity_index_stands_for_the_second_viscosity():
    by_index = pyworm.NamedOil.from_datasheet(nu40=220e-6, viscosity_index=151, base="PAO")
    assert by_index.viscosity_index == pytest.approx(151)


def test_measurements_over_temperature_are_kept_to():
    """A table of a known oil gives that oil, by kinematic and by dynamic viscosity."""
    warmths = np.linspace(293.15, 373.15, 5)
    nu, eta, rho = (
        function(warmths) for function in (PAO.kinematic_viscosity, PAO.viscosity, PAO.density)
    )
    for viscosity in ({"nu": nu}, {"eta": eta}):
        oil = pyworm.NamedOil.from_table(warmths, **viscosity, density=rho, base="PAO")
        ours, its = oil.oil("60 degC"), PAO.oil("60 degC")
        assert ours.viscosity.eta0 == pytest.approx(its.viscosity.eta0, rel=1e-9)
        assert ours.beta == pytest.approx(its.beta, rel=1e-9)
        assert ours.thermal.expansivity == pytest.approx(its.thermal.expansivity, rel=1e-9)
        assert ours.density.rho0 == pytest.approx(its.density.rho0, rel=1e-9)


@pytest.mark.parametrize(
    ("changed", "sentence"),
    [
        ({"nu100": None}, "give either nu100 or viscosity_index"),
        ({"viscosity_index": 150}, "give either nu100 or viscosity_index"),
        ({"nu40": 220}, "did you mean"),
        ({"nu100": "260 mm^2/s"}, "must fall with temperature"),
        ({"base": "water"}, "must be one of mineral, PAO"),
        ({"alpha": "15 GPa"}, "alpha"),
    ],
)
def test_what_is_no_data_sheet_is_refused(changed, sentence):
    with pytest.raises(ValueError, match=sentence):
        pyworm.NamedOil.from_datasheet(**SHEET | changed)


@pytest.mark.parametrize(
    ("temperatures", "given", "sentence"),
    [
        ((300, 350), {"nu": (1e-4,)}, "nu has 1 values and temperatures 2"),
        ((300, 350), {}, "give either nu or eta"),
        ((300, 350), {"nu": (1e-4, 1e-5), "eta": (0.1, 0.01)}, "give either nu or eta"),
        ((300,), {"nu": (1e-4,)}, "give two or more"),
        ((300, 350), {"nu": (1e-5, 1e-4)}, "must fall with temperature"),
        ((300, 325, 350), {"nu": (2e-4, 2e-4, 2e-5)}, "off Walther's law"),
    ],
)
def test_what_is_no_table_is_refused(temperatures, given, sentence):
    with pytest.raises(ValueError, match=sentence):
        pyworm.NamedOil.from_table(temperatures, **given)


def table(pressure, temperature):
    """A viscosity whose logarithm rises with the pressure, less where it is warm."""
    return 0.1 * np.exp(18e-9 * pressure * (330 / temperature) - 0.03 * (temperature - 333.15))


OILS = {
    "Roelands": PAO.oil("60 degC"),
    "Barus": pyworm.Oil(pyworm.Barus(0.1, 2e-8), pyworm.Density(870, 6e-10, 1.7e-9)),
    "table": pyworm.Oil(
        pyworm.TabulatedViscosity.of(table, 333.15),
        pyworm.TabulatedDensity.of(lambda p, t: 870 * (1 + 5e-10 * p), 333.15),
    ),
}


@pytest.mark.parametrize("name", OILS)
def test_one_property_moves_and_the_others_stay(name):
    oil = OILS[name]

    def properties(of):
        beta = of.beta if of.heat else 0.0
        return np.array([of.viscosity.eta0, of.viscosity.alpha, of.density.rho0, beta])

    was = properties(oil)
    for place, (key, value) in enumerate(
        {"eta0": "0.2 Pa s", "alpha": "15 1/GPa", "rho0": 900}.items()
    ):
        now = properties(oil.with_(**{key: value}))
        assert now[place] == pytest.approx((0.2, 15e-9, 900)[place])
        assert np.delete(now, place) == pytest.approx(np.delete(was, place), rel=1e-6)


def test_a_measured_alpha_has_no_spread_and_beta_moves_alone():
    oil = OILS["Roelands"]
    assert oil.with_(alpha=2e-8).alpha_spread == 0
    assert oil.with_() == oil
    steeper = oil.with_(beta="0.05 1/K")
    assert steeper.beta == pytest.approx(0.05) and steeper.viscosity == oil.viscosity


@pytest.mark.parametrize(
    ("oil", "change", "sentence"),
    [
        (
            pyworm.Oil(pyworm.Barus(0.1, 0), pyworm.Density(870, 0, 0)),
            {"alpha": 2e-8},
            "isoviscous",
        ),
        (OILS["Barus"], {"beta": 0.05}, "the oil has no heat"),
        (OILS["Roelands"], {"eta0": "-1 Pa s"}, "eta0"),
    ],
)
def test_what_cannot_move_is_refused(oil, change, sentence):
    with pytest.raises(ValueError, match=sentence):
        oil.with_(**change)


def test_a_body_by_name_takes_a_roughness():
    rough = pyworm.Roughness("0.4 um", slope=0.05, aspect=3, lay="30 deg", sharpness=0.01)
    body = pyworm.Body.from_name("16MnCr5", rough, "60 degC")
    assert body == pyworm.Body.from_name("16MnCr5", rough, "60 degC")
    assert (body.roughness, body.roughness_slope, body.roughness_aspect) == (0.4e-6, 0.05, 3)
    assert body.lay == pytest.approx(np.pi / 6) and body.asperity_sharpness == 0.01
    plain = pyworm.Body("207 GPa", 0.3, roughness=pyworm.Roughness("0.4 um"))
    assert plain == pyworm.Body("207 GPa", 0.3, roughness="0.4 um")
    assert ball(bodies=(body, plain)).composite_roughness == pytest.approx(0.4e-6 * 2**0.5)
    with pytest.raises(ValueError, match="slope, aspect, density"):
        pyworm.Roughness("0.4 um", slope=-1)
