"""Film formulas against published and independently computed films, and their exact limits."""

from math import cos, isclose, pi, sin

import numpy as np
import pytest
from folders import DATA
from hypothesis import given
from hypothesis import strategies as st

from pyworm.formulas.film import (
    LineGroups,
    PointGroups,
    chittenden,
    dowson_higginson,
    dowson_toyoda,
    hamrock_dowson,
    line_asymptotes,
    line_groups,
    masjedi_khonsari,
    moes_circular,
    moes_line,
    nijenbanning_venner_moes,
    point_asymptotes,
    point_groups,
    radii_at_angle,
)


def read(name):
    """Rows of a table as dictionaries."""
    lines = (DATA / name).read_text().splitlines()
    rows = [line for line in lines if not line.startswith("#")]
    table = np.genfromtxt(rows, delimiter=",", names=True)
    return [dict(zip(table.dtype.names, map(float, row), strict=True)) for row in table]


def point(m, el, ratio=1.0, material=4500.0):
    """Groups of a point contact from Moes' parameters, R = 1 m."""
    speed = (el / material) ** 4 / 2
    return PointGroups(1.0, ratio, speed, m * (2 * speed) ** 0.75, material)


def line(m, el, material=4500.0):
    """Groups of a line contact from Moes' parameters, R = 1 m."""
    speed = (el / material) ** 4 / 2
    return LineGroups(1.0, speed, m * (2 * speed) ** 0.5, material)


def isoviscous(m, ratio=1.0):
    """Groups of a point contact with L = 0."""
    speed = 1e-11
    return PointGroups(1.0, ratio, speed, m * (2 * speed) ** 0.75, 0.0)


def in_moes_units(groups, film):
    return None if film is None else film / groups.moes_film


@pytest.mark.parametrize("row", read("point_film_formulas.csv"), ids=str)
def test_point_formulas(row):
    groups = point(row["M"], row["L"])
    for formula, central, minimum in [
        (hamrock_dowson, "hd_central", "hd_minimum"),
        (chittenden, "chittenden_central", "chittenden_minimum"),
        (masjedi_khonsari, "mk_central", "mk_minimum"),
        (moes_circular, "moes", None),
        (nijenbanning_venner_moes, "nvm", None),
    ]:
        film = formula(groups)
        assert in_moes_units(groups, film.central) == pytest.approx(row[central], abs=1.1e-3)
        if minimum is None:
            assert film.minimum is None
        else:
            assert in_moes_units(groups, film.minimum) == pytest.approx(row[minimum], abs=1.1e-3)


@pytest.mark.parametrize("row", read("elliptic_films.csv"), ids=str)
def test_elliptic_contacts(row):
    groups = point(200, 10, row["D"])
    central = in_moes_units(groups, nijenbanning_venner_moes(groups).central)
    assert central == pytest.approx(row["nvm"], abs=6e-4)
    assert central == pytest.approx(row["computed"], rel=0.105)


def test_measured_contact_of_mourier_2006():
    """Published simulation 209.3 nm; Hamrock-Dowson gives 222.9 nm, Nijenbanning 213.3 nm."""
    groups = point_groups(12.5e-3, 12.5e-3, 15, 110e9, 0.09, 0.25, 22e-9)
    assert groups.moes_m == pytest.approx(63.78, abs=0.005)
    assert groups.moes_l == pytest.approx(5.788, abs=5e-4)
    assert hamrock_dowson(groups).central == pytest.approx(222.9e-9, abs=0.05e-9)
    central = nijenbanning_venner_moes(groups).central
    assert central == pytest.approx(213.3e-9, abs=0.05e-9)
    assert central == pytest.approx(209.3e-9, rel=0.03)


def test_ball_on_disc_of_gao_2026():
    """Nijenbanning's formula against films evaluated elsewhere for 0.1 to 0.3 m/s."""
    speed = np.array([0.10, 0.15, 0.20, 0.30])
    film = nijenbanning_venner_moes(point_groups(9.53e-3, 9.53e-3, 20, 117e9, speed, 0.38, 30e-9))
    assert film.central * 1e9 == pytest.approx([329, 433, 526, 692], rel=2.5e-3)


def test_worm_contact_of_sharif_2001():
    groups = point_groups(0.0954, 3.046, 14e3, 170.81e9, np.array([0.3, 1.0, 3.0]), 0.227, 9.48e-9)
    assert groups.moes_m[1] == pytest.approx(743, abs=0.5)
    assert groups.moes_l[1] == pytest.approx(3.72, abs=5e-3)
    film = nijenbanning_venner_moes(groups).central
    assert film * 1e6 == pytest.approx([0.64, 1.46, 3.10], abs=6e-3)


@pytest.mark.parametrize("row", read("line_films_moes.csv"), ids=str)
def test_moes_line(row):
    groups = line(row["M"], row["L"])
    film = moes_line(groups)
    central, minimum = film.central / groups.moes_film, film.minimum / groups.moes_film
    assert central == pytest.approx(row["central"], abs=1.1e-3)
    assert minimum == pytest.approx(row["minimum"], abs=1.1e-3)
    assert central == pytest.approx(row["incompressible_central"], rel=0.045)
    assert minimum == pytest.approx(row["compressible_minimum"], rel=0.045)


@pytest.mark.parametrize(
    ("load", "m", "higginson", "moes"),
    [(1e5, 4.62, 0.631, 0.630), (9e5, 41.5, 0.474, 0.511)],
)
def test_roller_drive_line_contact(load, m, higginson, moes):
    """R = 6.5 mm, 2 m/s, eta0 = 0.08, alpha = 22 /GPa: films [um] evaluated independently."""
    groups = line_groups(6.5e-3, load, 225.6e9, 2.0, 0.08, 2.2e-8)
    assert groups.moes_m == pytest.approx(m, rel=1.5e-3)
    assert groups.moes_l == pytest.approx(19.08, abs=5e-3)
    assert dowson_higginson(groups).minimum * 1e6 == pytest.approx(higginson, abs=6e-4)
    assert moes_line(groups).minimum * 1e6 == pytest.approx(moes, abs=6e-4)


def test_dowson_toyoda_by_hand():
    film = dowson_toyoda(LineGroups(2.0, 1e-10, 1e-4, 1e3)).central
    assert isclose(film, 2 * 3.06 * 10 ** (-6.9 + 0.4 + 1.68), rel_tol=1e-13)


def test_groups_by_hand():
    groups = point_groups(0.02, 0.05, 40.0, 2e11, 1.5, 0.04, 2e-8)
    assert groups.ratio == pytest.approx(0.4, rel=1e-15)
    assert groups.speed == pytest.approx(1.5e-11, rel=1e-14)
    assert groups.load == pytest.approx(5e-7, rel=1e-14)
    assert groups.material == pytest.approx(4e3, rel=1e-14)
    assert groups.moes_m == pytest.approx(5e-7 * 3e-11**-0.75, rel=1e-14)
    assert groups.moes_l == pytest.approx(4e3 * 3e-11**0.25, rel=1e-14)
    flat = line_groups(0.02, 1e5, 2e11, 1.5, 0.04, 2e-8)
    assert flat.moes_m == pytest.approx(2.5e-5 * 3e-11**-0.5, rel=1e-14)


def test_isoviscous_limit_is_reached_and_exact():
    """As L falls the film becomes that of L = 0, computed as 1.423 to 1.429 at M = 20."""
    groups = isoviscous(20)
    limit = nijenbanning_venner_moes(groups).central / groups.moes_film
    assert limit == pytest.approx(1.448, abs=5e-4)
    assert limit == pytest.approx(1.429, rel=0.015)
    elastic = 3.18 * 1.63 ** (-14 / 25) * 20 ** (-2 / 15)
    rigid = 145 * 1.796 ** (-15 / 7) / 400
    crowned = (elastic**-4 + 1.8**-4) ** -0.25
    assert isclose(limit, (rigid**1.5 + crowned**1.5) ** (2 / 3), rel_tol=1e-13)
    nearly = point(20, 1e-4)
    assert nijenbanning_venner_moes(nearly).central / nearly.moes_film == pytest.approx(
        limit, rel=1e-3
    )


def test_line_isoviscous_limit_is_martin():
    """A rigid isoviscous cylinder: H = 3/M exactly where the pressure is largest."""
    speed = 1e-11
    for m in (1e-3, 1e-2):
        groups = LineGroups(1.0, speed, m * (2 * speed) ** 0.5, 0.0)
        assert moes_line(groups).central / groups.moes_film == pytest.approx(3 / m, rel=1e-2)


def test_point_limits():
    """Far into a regime the joined film is that regime's asymptote."""
    h = point_asymptotes(1e-4, 1e-3, 1.0)
    groups = point(1e-4, 1e-3)
    film = nijenbanning_venner_moes(groups).central / groups.moes_film
    assert film == pytest.approx(h.rigid_isoviscous, rel=1e-4)
    h = point_asymptotes(1e9, 30.0, 0.1)
    groups = point(1e9, 30.0, 0.1)
    film = nijenbanning_venner_moes(groups).central / groups.moes_film
    assert film == pytest.approx(h.elastic_piezoviscous, rel=0.02)


def test_radii_at_angle():
    assert radii_at_angle(0.01, 0.3, 0.0) == (0.01, 0.3)
    along, across = radii_at_angle(0.01, 0.3, pi / 2)
    assert along == pytest.approx(0.3, rel=1e-13)
    assert across == pytest.approx(0.01, rel=1e-13)
    along, across = radii_at_angle(0.01, 0.3, 0.7)
    assert 1 / along == pytest.approx(cos(0.7) ** 2 / 0.01 + sin(0.7) ** 2 / 0.3, rel=1e-14)
    assert 1 / along + 1 / across == pytest.approx(1 / 0.01 + 1 / 0.3, rel=1e-14)


@pytest.mark.parametrize(
    "formula",
    [
        hamrock_dowson,
        chittenden,
        nijenbanning_venner_moes,
        moes_circular,
        masjedi_khonsari,
    ],
)
@given(
    log_m=st.floats(0, 4),
    log_l=st.floats(-2, 1.5),
    log_d=st.floats(-2.5, 0.5),
    lift=st.floats(1, 3),
)
def test_point_films_are_finite_and_grow_with_speed(formula, log_m, log_l, log_d, lift):
    slow = point(10**log_m, 10**log_l, 10**log_d)
    fast = PointGroups(slow.radius, slow.ratio, lift * slow.speed, slow.load, slow.material)
    thin, thick = formula(slow), formula(fast)
    assert 0 < thin.central <= thick.central < np.inf
    if thin.minimum is not None:
        assert 0 < thin.minimum <= thick.minimum < np.inf


def test_isoviscous_oils_raise_no_warnings():
    with np.errstate(all="raise"):
        for formula in (
            hamrock_dowson,
            chittenden,
            nijenbanning_venner_moes,
            moes_circular,
        ):
            assert np.isfinite(formula(isoviscous(20)).central)
        assert np.isfinite(moes_line(LineGroups(1.0, 1e-11, 1e-4, 0.0)).minimum)


def test_arrays_give_the_same_as_numbers():
    m, ratio = np.array([10.0, 100.0]), np.array([0.1, 1.0])
    many = point(m, 10.0, ratio)
    for formula in (
        hamrock_dowson,
        chittenden,
        nijenbanning_venner_moes,
        masjedi_khonsari,
    ):
        each = [formula(point(a, 10.0, b)).central for a, b in zip(m, ratio, strict=True)]
        assert formula(many).central == pytest.approx(each, rel=1e-14)
    h = line_asymptotes(m, 10.0)
    assert h.rigid_isoviscous == pytest.approx(3 / m, rel=1e-14)
