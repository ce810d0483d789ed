"""The film solver against published and independently recomputed solutions."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from circular_contact import OIL, RADIUS, circular
from convergence import films

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.grid import Grid, nest
from pyworm.planning.window import OUTERMOST_REACH, Reach, near_reach, windows
from pyworm.scene.point import Paraboloid, RigidMotion
from pyworm.scene.sampled_gap import SampledGap
from pyworm.scene.scales import scales
from pyworm.solver.point.far_field import far_field


@pytest.mark.parametrize(
    ("m", "box", "central", "minimum"),
    [
        (20, (-4.5, 1.5, 3.0), 4.208, 2.856),
        (100, (-3.0, 1.5, 2.25), 3.843 * 1.0084, 2.056 * 1.0061),
        (200, (-2.5, 1.5, 2.0), 3.690, 1.739),
    ],
)
def test_circular_films_of_an_independent_solver(m, box, central, minimum):
    """Dense Newton solutions of the same equations, extrapolated and corrected to a large domain.

    Compressible Roelands oil (docs/evidence/validation.md); at M = 100 with the domain factors of Barus oil.
    Their own uncertainty is 0.01 to 0.2 % (central) and 0.8 to 3 % (minimum).
    """
    coarse, middle, fine = films(circular(m, 10), box)
    order = np.log2((middle[0] - coarse[0]) / (fine[0] - middle[0]))
    assert order == pytest.approx(2.0, abs=0.15)
    extrapolated = fine + (fine - middle) / 3
    assert extrapolated[0] == pytest.approx(central, rel=0.006)
    assert extrapolated[1] == pytest.approx(minimum, rel=0.015)


@pytest.mark.parametrize(
    ("m", "lubricant", "central", "minimum"),
    [(20, 10, 4.208, 2.856), (200, 10, 3.690, 1.739)],
)
def test_films_with_the_oil_supply_not_cut_off(m, lubricant, central, minimum):
    """The same solver's values corrected to a large domain: what a plan of our own must come to."""
    scene = circular(m, lubricant)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.01))
    unit = scales(scene).groups.moes_film
    assert solution.converged
    assert solution.figures.film_central.value / unit == pytest.approx(central, rel=0.012)
    assert solution.figures.film_min.value / unit == pytest.approx(minimum, rel=0.02)


@pytest.mark.parametrize(
    ("m", "lubricant"), [(100, 10), pytest.param(2, 2, marks=pytest.mark.long), (140, 4.3)]
)
def test_error_bar_holds_against_a_much_finer_grid(m, lubricant):
    scene = circular(m, lubricant)
    rough = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.03)).figures
    fine = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.002)).figures
    for name in ("film_central", "film_min"):
        estimate, truth = getattr(rough, name), getattr(fine, name)
        assert estimate.error <= 0.03
        assert abs(estimate.value / truth.value - 1) <= estimate.error + truth.error


def test_a_film_too_thin_for_the_first_grid_is_no_reason_to_give_up():
    """(M, L) = (1000, 0): the first grid has films below zero, and windows are compared on a later one."""
    like = circular(1000, 5)
    scene = replace(like, oil=Oil(Barus(0.04, 0.0), Density.incompressible(870.0)))
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.03))
    unit = scales(scene).groups.moes_film
    assert solution.converged
    assert solution.figures.film_min.value / unit == pytest.approx(0.464, rel=0.03)


@pytest.mark.parametrize("degrees", [30, 45, 90, 180, -120])
def test_turning_the_entrainment_of_a_circular_contact_changes_nothing(degrees):
    straight, turned = (
        pyworm.solve(scene, pyworm.plan(scene, accuracy=0.02)).figures
        for scene in (circular(50, 10), circular(50, 10, radians(degrees)))
    )
    for name in ("film_central", "film_min"):
        first, second = getattr(straight, name), getattr(turned, name)
        assert second.value == pytest.approx(first.value, rel=first.error + second.error)
    assert turned.film_exit_min == pytest.approx(straight.film_exit_min, rel=0.02)
    assert turned.film_exit_min_at == pytest.approx(straight.film_exit_min_at, rel=0.03)


def test_spin_turns_the_film_and_its_mirror_image_the_other_way():
    plain = circular(50, 10)
    speed, a = plain.motions[0].u, scales(plain).hertz.semi_axis_x
    left, right = (
        pyworm.solve(scene, pyworm.plan(scene, accuracy=0.02))
        for scene in (circular(50, 10, spin=speed / a), circular(50, 10, spin=-speed / a))
    )
    assert left.converged and right.converged
    film = left.fields.film.values
    assert np.allclose(right.fields.film.values[::-1], film, rtol=1e-3)
    contact = left.fields.dry_pressure.values > 0
    lopsided = abs(film - film[::-1])[contact].max() / left.figures.film_central.value
    assert lopsided > 0.2


def pure_spin(reach):
    """An elliptic contact whose surfaces only spin, and end at a distance in half-widths."""
    like = circular(5, 2)
    a = scales(like).hertz.semi_axis_x
    turning = RigidMotion(0.0, 0.0, like.motions[0].u / a)
    whole = Paraboloid(2 * RADIUS, RADIUS)

    def ends(x, y):
        return whole(x, y)[0], x**2 + y**2 < (reach * a) ** 2

    return replace(
        like, gap=ends, radii=(whole.radius_x, whole.radius_y), motions=(turning, turning)
    )


def test_pure_spin_of_an_elliptic_contact_forms_a_film():
    scene = pure_spin(6.0)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.05))
    assert solution.converged
    film = solution.fields.film
    assert solution.figures.film_min.value > 0
    # half a turn about the contact point maps the scene onto itself
    assert np.allclose(film.values[::-1, ::-1], film.values, rtol=2e-2)


def test_a_film_that_depends_on_surfaces_far_out_is_marked():
    """Pressure by spin falls with the square of the distance only: its load has no bound on a plane."""
    scene = pure_spin(1e6)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.05))
    assert not solution.accurate
    assert solution.figures.film_central.error > 0.05
    assert "domain truncation error of the film" in solution.stop_reason


def test_rigid_isoviscous_sphere():
    """Brewe, Hamrock and Taylor's film of a rigid sphere, 128 lambda^2 (...)^2 U^2/W^2.

    A fit to solutions of Reynolds' equation with its rupture condition; pressure reaches far out, so that it
    shows whether the window does.
    """
    scene = circular(0.5, 0.5)
    groups = scales(scene).groups
    fit = 128 * 0.6**2 * (0.131 * np.arctan(0.5) + 1.683) ** 2 * (groups.speed / groups.load) ** 2
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.01))
    assert solution.converged
    assert solution.figures.film_central.value / RADIUS == pytest.approx(fit, rel=0.03)
    assert solution.figures.film_min_kind == "middle"


@pytest.mark.parametrize(
    ("m", "lubricant"), [(0.5, 0.5), pytest.param(2, 2, marks=pytest.mark.long)]
)
def test_the_error_by_the_window_of_light_contacts_holds_against_a_much_larger_one(m, lubricant):
    """Of a thick film much of the load lies far out, and what lies beyond the windows is a closed form."""
    scene = circular(m, lubricant)
    size = scales(scene)
    plan = replace(pyworm.plan(scene, accuracy=0.01), largest_grid=1)
    near, far = (Reach.around(4 * reach.inlet) for reach in (near_reach(size), OUTERMOST_REACH))
    inner, outer = windows(scene, size, near, far)
    wide = replace(plan, grids=nest(inner, outer, *plan.grids[-1].spacing), wider_grids=())
    figures, truth = (pyworm.solve(scene, of).figures for of in (plan, wide))
    for name in ("film_central", "film_min"):
        estimate = getattr(figures, name)
        error = abs(estimate.value / getattr(truth, name).value - 1)
        assert error <= 1.1 * estimate.domain < 4e-3


def test_the_load_beyond_a_window_is_that_of_the_exact_field():
    """p r^3 depends on the direction only far out: its integral over all directions in which oil comes in."""
    half_x, half_y, angle, aspect = 4e-3, 3e-3, 0.7, 2.0
    like = circular(0.5, 0.5, angle)
    gap = Paraboloid(aspect * RADIUS, RADIUS)
    scene = replace(like, gap=gap, radii=(aspect * RADIUS, RADIUS))
    grid = Grid(-half_x, -half_y, half_x / 128, half_y / 128, 257, 257)
    film, covered = gap(*grid.mesh())
    beyond = far_field(scene, grid, film, covered)

    turn = np.linspace(0, 2 * np.pi, 20001)
    x, y = np.cos(turn), np.sin(turn)
    u, v = (scene.motions[0].u, scene.motions[0].v)
    wedge = u * x / (1 + 2 * aspect / 3) + v * y / (1 + 2 / (3 * aspect))
    shape = x**2 / (2 * aspect * RADIUS) + y**2 / (2 * RADIUS)
    cubed = np.maximum(-4 * OIL.viscosity.eta0 * wedge / shape**2, 0)
    reach = 1 / np.maximum(abs(x) / half_x, abs(y) / half_y)
    assert beyond.load == pytest.approx(np.trapezoid(cubed / reach, turn), rel=2e-3)
    corner = beyond.pressure[0, 0] * np.hypot(half_x, half_y) ** 3
    assert corner == pytest.approx(np.interp(np.pi + np.arctan(0.75), turn, cubed), rel=1e-6)


def test_isoviscous_incompressible_film():
    """(M, L) = (20, 0) on a large domain: the independent solver of docs/evidence/validation.md."""
    soft = Oil(Barus(0.04, 0.0), Density.incompressible(870.0))
    like = circular(20, 5)
    scene = replace(like, oil=soft)
    unit = scales(scene).groups.moes_film
    figures = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.005)).figures
    assert figures.film_central.value / unit == pytest.approx(1.429, rel=0.01)
    assert figures.film_min.value / unit == pytest.approx(1.058, rel=0.01)


@pytest.mark.parametrize("offset", [1e-3, -1e-3])
def test_a_constant_added_to_a_sampled_gap_changes_nothing(offset):
    scene = circular(30, 6)
    x = np.linspace(-1.2e-3, 1.2e-3, 121)
    gap = scene.gap(x[None, :], x[:, None])[0]
    plain, shifted = (
        pyworm.solve(of, pyworm.plan(of, 0.05)).figures
        for of in (replace(scene, gap=SampledGap(x, x, gap + shift)) for shift in (0.0, offset))
    )
    assert shifted.film_central.value == pytest.approx(plain.film_central.value, rel=1e-6)
    assert shifted.film_min.value == pytest.approx(plain.film_min.value, rel=1e-6)


def test_a_tooth_edge_carries_no_pressure_beyond_it():
    whole = Paraboloid(RADIUS, RADIUS)
    edge = 4e-5

    def ends(x, y):
        gap, _ = whole(x, y)
        return gap, y < edge

    scene = circular(50, 10, gap=ends)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy=0.1))
    beyond = solution.fields.y.values >= edge
    assert solution.fields.pressure.values[beyond].max() == 0
    assert solution.fields.pressure.values[~beyond].max() > 1.1 * scales(scene).hertz.pressure_max
    assert abs(solution.figures.load_error) < 1e-3


def test_a_film_that_the_largest_grid_does_not_settle_is_marked():
    scene = circular(1000, 10)
    plan = replace(pyworm.plan(scene, accuracy=0.001), largest_grid=20_000)
    solution = pyworm.solve(scene, plan)
    assert not solution.accurate
    assert "largest grid allowed" in solution.stop_reason


def test_surfaces_that_entrain_nothing_are_refused():
    still = RigidMotion(1.0, 0.0)
    scene = replace(circular(50, 10), motions=(still, RigidMotion(-1.0, 0.0)))
    with pytest.raises(ValueError, match="entrain no oil"):
        pyworm.plan(scene)


def test_a_gap_that_is_not_a_number_is_refused():
    """Beside the contact point, where planning does not look, by the kernel."""

    def broken(x, y):
        return np.where(x > 2e-3 * whole.radii[0], np.nan, x**2), np.ones(x.shape, bool)

    whole = circular(50, 10)
    scene = replace(whole, gap=broken)
    with pytest.raises(KernelError):
        pyworm.solve(scene, pyworm.plan(scene))


def test_progress_is_reported_and_rises():
    shares = []
    scene = circular(20, 10)
    pyworm.solve(
        scene, pyworm.plan(scene, 0.1), progress=lambda message, share: shares.append(share)
    )
    assert shares == sorted(shares)
    assert 0 <= shares[0] and shares[-1] <= 1


def test_a_solve_is_the_same_to_the_last_bit_again():
    scene = circular(50, 10)
    first, second = (pyworm.solve(scene, pyworm.plan(scene, 0.1)) for _ in range(2))
    assert np.array_equal(first.fields.pressure.values, second.fields.pressure.values)


def test_the_certificate_balances_mass_over_the_outline_of_the_pressure():
    scene = circular(50, 10)
    figures = pyworm.solve(scene, pyworm.plan(scene, 0.01)).figures
    assert figures.mass_error < 1e-3
    assert abs(figures.load_error) < 1e-4
    assert figures.dry.length == pytest.approx(2 * scales(scene).hertz.semi_axis_x, rel=0.01)
    assert figures.dry.pressure_max == pytest.approx(scales(scene).hertz.pressure_max, rel=0.01)
    assert figures.film_exit_min > figures.film_min.value
