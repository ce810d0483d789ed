"""Shipped cases against what their sources print."""

import numpy as np
import pytest
from folders import CASES

import pyworm


def solved(name, accuracy, phase=None, effects=("all", "-roughness", "-squeeze")):
    scene = pyworm.load(CASES / f"{name}.toml").scene(phase)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    assert solution.converged
    return solution


def test_mourier_ball_on_disc():
    """Mourier et al. (2006), digitised to about 1 %; the side lobes are a third thinner."""
    figures = solved("mourier_2006", 0.01).figures
    assert figures.film_central.value == pytest.approx(209.3e-9, rel=0.03)
    assert figures.film_exit_min == pytest.approx(175.3e-9, rel=0.03)
    assert figures.film_exit_min_at == pytest.approx(126e-6, rel=0.04)
    assert figures.film_min.value == pytest.approx(119e-9, rel=0.02)
    assert figures.film_min_kind == "side lobe"
    assert abs(figures.film_min_at[1]) == pytest.approx(0.84 * 136.5e-6, rel=0.03)


@pytest.fixture(scope="module")
def worm():
    return solved("zi_sharif_2001", 0.03, phase=0.5)


@pytest.fixture(scope="module")
def cold_worm():
    return solved("zi_sharif_2001", 0.03, phase=0.5, effects="isothermal")


def test_worm_dry_contact(worm):
    """23.2 by 2.4 mm and 540 MPa (Sharif et al. 2001, section 6); the radii alone are calibrated."""
    dry = worm.figures.dry
    assert dry.length == pytest.approx(23.2e-3, rel=0.01)
    assert dry.width == pytest.approx(2.4e-3, rel=0.04)
    assert dry.pressure_max == pytest.approx(540e6, rel=0.04)


@pytest.mark.parametrize(("name", "unequal"), [("worm", 0.95), ("cold_worm", 0.8)])
def test_worm_film_is_split_as_the_paper_found(name, unequal, request):
    """Two unequal side lobes; the thinner band starts above and crosses the contact (paper, Fig. 11)."""
    worm = request.getfixturevalue(name)
    film, dry = worm.fields.film, worm.fields.dry_pressure.values > 0
    inside = film.where(dry)
    # the ridge of thick film that comes in from the left, and the band that crosses behind it
    across = inside.sel(x=0.0, method="nearest").dropna("y")
    upper, lower = across.sel(y=slice(0, None)).min(), across.sel(y=slice(None, 0)).min()
    assert upper < unequal * lower
    along = inside.sel(y=0.0, method="nearest").dropna("x")
    band = float(along.x[np.argmin(along.values)])
    assert 1e-3 < band < 6e-3
    assert float(along.min()) < 0.6 * float(along.sel(x=slice(None, -2e-3)).max())
    assert worm.figures.film_min_at[1] < 0 < band


def test_worm_is_as_hot_as_the_paper_has_it(worm):
    """108, 106 and 117 degC, a rise of 57 K (Sharif et al. 2001, section 6 and Fig. 13)."""
    inlet = 273.15 + 60
    for name, degrees in (
        ("temperature_max_body_1", 108),
        ("temperature_max_body_2", 106),
        ("temperature_max_film", 117),
    ):
        rise = getattr(worm.figures, name).value - inlet
        assert rise == pytest.approx(degrees - 60, rel=0.06)
    # heat builds up towards the exit on the worm, downwards on the wheel
    fields = worm.fields
    hottest = [fields[f"temperature_body_{body}"].argmax(dim=("x", "y")) for body in (1, 2)]
    assert float(fields.x[hottest[0]["x"]]) > 3e-3
    assert float(fields.y[hottest[1]["y"]]) < -0.2e-3
    assert abs(worm.figures.heat_balance) < 0.01


def test_worm_pressure_has_a_shoulder_over_the_thin_band(worm):
    """A rise and fall that the dry contact has not (paper, Fig. 9)."""
    pressure = worm.fields.pressure.sel(y=0.0, method="nearest")
    dry = worm.fields.dry_pressure.sel(y=0.0, method="nearest")
    middle = slice(-5e-3, 8e-3)
    assert np.diff(dry.sel(x=middle), 2).max() < 0.1 * abs(np.diff(dry.sel(x=middle), 2)).max()
    assert (
        np.diff(pressure.sel(x=middle), 2).max()
        > 0.1 * abs(np.diff(pressure.sel(x=middle), 2)).max()
    )
