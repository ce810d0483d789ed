"""Shipped cases against what their sources print."""

from pathlib import Path

import numpy as np
import pytest

import pyworm

CASES = Path(__file__).parents[2] / "cases"


def solved(name, accuracy, phase=None):
    scene = pyworm.load(CASES / f"{name}.toml").scene(phase)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy))
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


def test_worm_dry_contact(worm):
    """23.2 by 2.4 mm and 540 MPa (Sharif et al. 2001, section 6); the radii alone are calibrated."""
    dry = worm.figures.dry
    assert dry.length == pytest.approx(23.2e-3, rel=0.01)
    assert dry.width == pytest.approx(2.4e-3, rel=0.04)
    assert dry.pressure_max == pytest.approx(540e6, rel=0.04)


def test_worm_film_is_split_as_the_paper_found(worm):
    """Two unequal side lobes; the thinner band starts above and crosses the contact (paper, Fig. 11)."""
    film, dry = worm.fields.film, worm.fields.dry_pressure.values > 0
    inside = film.where(dry)
    # the ridge of thick film that comes in from the left, and the band that crosses behind it
    across = inside.sel(x=0.0, method="nearest").dropna("y")
    upper, lower = across.sel(y=slice(0, None)).min(), across.sel(y=slice(None, 0)).min()
    assert upper < 0.8 * lower
    along = inside.sel(y=0.0, method="nearest").dropna("x")
    band = float(along.x[np.argmin(along.values)])
    assert 1e-3 < band < 6e-3
    assert float(along.min()) < 0.6 * float(along.sel(x=slice(None, -2e-3)).max())
    assert worm.figures.film_min_at[1] < 0 < band


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
