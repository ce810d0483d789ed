"""Sheared and heated point contacts: limits, balances and symmetries."""

import re
from dataclasses import replace

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.materials.flow_laws import NEWTONIAN, FlowLaw
from pyworm.planning.model import Model
from pyworm.scene.point import RigidMotion
from pyworm.solver.newton import iterate
from pyworm.solver.point.contact import PointContactSolver

COARSE = 0.05


def ball(slide_roll_ratio=1.0, turn=0.0, **changes):
    """The traction case at one slide-roll ratio, its motion turned by an angle [rad]."""
    scene = pyworm.load(CASES / "traction_steel.toml").scene()
    along = np.array([np.cos(turn), np.sin(turn)])
    motions = tuple(
        RigidMotion(*(float(speed) for speed in 2.0 * (1 + sign * slide_roll_ratio / 2) * along))
        for sign in (1, -1)
    )
    oil = replace(scene.oil, **changes) if changes else scene.oil
    return replace(scene, motions=motions, oil=oil)


def solved(scene, accuracy=COARSE, effects="all"):
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    assert solution.converged, solution.stop_reason
    return solution


@pytest.fixture(scope="module")
def hot():
    return solved(ball())


def settled(scene, levels):
    """The film of one temperature on the first grid of the figures, to a residual far below any wanted."""
    plan = replace(pyworm.plan(scene, COARSE, "isothermal"), model=Model(levels))
    level, _ = PointContactSolver(scene, plan).begin(plan.grids)
    iterate(level, 1e-9)
    return level.film


def test_a_newtonian_oil_of_one_temperature_has_the_isothermal_film():
    """The sheared film's scheme in Newton's limit is that of the plain one, to the iteration's tolerance."""
    scene = ball(flow=NEWTONIAN)
    plain, sheared = settled(scene, 0), settled(scene, 7)
    scale = plain.pressure.max()
    assert np.abs(sheared.pressure - plain.pressure).max() < 1e-6 * scale
    assert np.allclose(sheared.thickness(), plain.thickness(), rtol=1e-6)


def test_an_oil_whose_viscosity_stays_has_the_sheared_film():
    """Heat that changes neither viscosity nor density changes no film."""
    scene = ball()
    heat = replace(scene.oil.heat, viscosity_exponent=0.0, expansivity=0.0)
    scene = replace(scene, oil=replace(scene.oil, heat=heat))
    sheared = solved(scene, effects=("all", "-film-heating")).figures
    heated = solved(scene, effects="all").figures
    assert heated.film_central.value == pytest.approx(sheared.film_central.value, rel=2e-3)
    assert heated.film_min.value == pytest.approx(sheared.film_min.value, rel=2e-3)
    assert heated.temperature_max_film.value > scene.oil.heat.inlet_temperature + 5


def test_a_ruptured_node_between_pressures_is_not_heated_by_their_difference():
    """Reynolds' condition: pressure and gradient vanish there, and 50 K of a sweep with them."""
    scene = ball(slide_roll_ratio=0.0)
    plan = pyworm.plan(scene, COARSE, "all")
    level, _ = PointContactSolver(scene, plan).begin(plan.grids)
    before, pressure = level.film.rise().max(), level.film.pressure.copy(order="F")
    i, j = np.unravel_index(pressure.argmax(), pressure.shape)
    pressure[i, j] = pressure[i + 1, j] = 0.0
    state = level.state()
    level.film.start(pressure, state.rigid_film)
    level.film.warm()
    assert level.film.rise()[i : i + 2, j].max() < before + 1


def test_friction_heat_goes_where_it_must(hot):
    """Into both bodies and away with the oil; its work is sliding against stress."""
    assert abs(hot.figures.heat_balance) < 1e-3
    fields = hot.fields
    cell = float(fields.x[1] - fields.x[0]) * float(fields.y[1] - fields.y[0])
    sliding = -(fields.sliding_x * fields.shear_stress_x + fields.sliding_y * fields.shear_stress_y)
    contact = fields.pressure > 0.1 * fields.pressure.max()
    # the work of the pressure on the flow adds little where the film is thin
    work = float((sliding.where(contact)).sum()) * cell
    heat = float(fields.friction_power.where(contact).sum()) * cell
    assert work < heat < 1.04 * work


def test_heat_into_the_bodies_is_the_work_of_friction():
    """Of the contact's friction all but what the oil carries out goes into the bodies: to 1 %."""
    scene = ball()
    plan = pyworm.plan(scene, COARSE)
    solver = PointContactSolver(scene, plan)
    level, _ = solver.begin(plan.grids)
    iterate(level, 1e-4)
    heat = level.film.heat_fields()
    contact = level.film.pressure > 0.01 * level.film.pressure.max()
    into_bodies = heat.flux.sum(axis=2)[contact].sum()
    friction = level.film.present_shear().friction
    assert into_bodies == pytest.approx(friction[contact].sum(), rel=0.01)


def test_friction_against_load_is_what_the_stress_adds_up_to(hot):
    figures = hot.figures
    work = figures.friction_coefficient.value * hot.load * 2.0  # m/s of sliding, at a ratio of 1
    assert work < figures.power_loss.value < 1.08 * work


def test_a_rotated_contact_has_the_rotated_film(hot):
    """Turned by 30 degrees it has the same film, friction and temperatures within its error bars."""
    turned = solved(ball(turn=np.pi / 6)).figures
    inlet = 273.15 + 60
    for name in ("film_central", "film_min", "friction_coefficient", "temperature_max_film"):
        one, other = (getattr(figures, name) for figures in (hot.figures, turned))
        zero = inlet if name.startswith("temperature") else 0.0
        assert abs(one.value - other.value) < one.error * (one.value - zero) + other.error * (
            other.value - zero
        )


def test_bodies_exchanged_give_the_film_mirrored_across(hot):
    other = solved(ball(slide_roll_ratio=-1.0)).figures
    figures = hot.figures
    assert other.film_central.value == pytest.approx(figures.film_central.value, rel=1e-3)
    assert other.temperature_max_body_1.value == pytest.approx(
        figures.temperature_max_body_2.value, abs=0.1
    )
    assert other.friction_coefficient.value == pytest.approx(
        figures.friction_coefficient.value, rel=2e-3
    )


def test_a_parabola_of_temperature_is_near_the_full_model(hot):
    cheap = solved(ball(), effects=("all", "-viscosity-across")).figures
    assert cheap.film_central.value == pytest.approx(hot.figures.film_central.value, rel=0.05)
    assert cheap.friction_coefficient.value == pytest.approx(
        hot.figures.friction_coefficient.value, rel=0.1
    )


@pytest.mark.parametrize(
    ("law", "newtonian"),
    [
        (FlowLaw("eyring", stress=4e6), lambda tau: 4e6 * np.sinh(tau / 4e6)),
        (FlowLaw("bair-winer", limit=1e8), lambda tau: -1e8 * np.log(1 - tau / 1e8)),
        (
            FlowLaw("eyring-limited", stress=4e6, limit=2e7),
            lambda tau: 4e6 * np.sinh(tau / 4e6) / (1 - (tau / 2e7) ** 2),
        ),
        (
            FlowLaw("carreau", stress=6e6, exponent=0.42),
            lambda tau: tau * (1 + (tau / 6e6) ** 2) ** ((1 / 0.42 - 1) / 2),
        ),
    ],
    ids=["eyring", "bair-winer", "eyring-limited", "carreau"],
)
def test_friction_is_that_of_the_flow_law_over_the_contact(law, newtonian):
    """eta sliding over film is the published function of the stress; eta at a parabola's mean temperature."""
    scene = ball(slide_roll_ratio=0.3, flow=law)
    solution = solved(scene)
    fields = solution.fields
    walls = (fields.temperature_body_1 + fields.temperature_body_2) / 2
    rise = (2 * fields.temperature_middle + walls) / 3 - scene.oil.heat.inlet_temperature
    eta = np.vectorize(scene.oil.eta)(fields.pressure.values, rise.values)
    wanted = eta * np.hypot(fields.sliding_x, fields.sliding_y).values / fields.film.values
    low, high = np.zeros_like(wanted), np.minimum(wanted, 0.995 * (law.limit or np.inf))
    for _ in range(60):
        middle = (low + high) / 2
        high = np.where(newtonian(middle) > wanted, middle, high)
        low = np.where(newtonian(middle) > wanted, low, middle)
    node = float(fields.x.diff("x").mean() * fields.y.diff("y").mean())
    friction = low.sum() * node / solution.load
    assert solution.figures.friction_coefficient.value == pytest.approx(friction, rel=0.03)


def test_bulk_temperatures_apart(hot):
    """A body 40 K hotter warms the film and thins it; the other stays colder at its surface."""
    scene = ball()
    warm = replace(scene.bodies[0], bulk_temperature=273.15 + 100)
    figures = solved(replace(scene, bodies=(warm, scene.bodies[1]))).figures
    assert figures.temperature_max_body_1.value > 273.15 + 100
    assert figures.film_central.value < hot.figures.film_central.value


@pytest.mark.long
def test_opposite_sliding_has_a_film_by_heat_alone():
    """Mirrored bodies, no entrainment: two side lobes, both surfaces equally hot (Guo, Yang and Qu 2001)."""
    solution = solved(pyworm.load(CASES / "opposite_sliding.toml").scene(), accuracy=0.2)
    figures, film = solution.figures, solution.fields.film
    assert figures.film_min.value > 20e-9
    assert figures.temperature_max_body_1.value == pytest.approx(
        figures.temperature_max_body_2.value, abs=0.05
    )
    mirrored = film.values[:, ::-1]
    inside = solution.fields.dry_pressure.values > 0
    assert np.abs(film.values - mirrored)[inside].max() < 0.01 * figures.film_central.value


def test_opposite_sliding_without_heat_is_refused():
    scene = pyworm.load(CASES / "opposite_sliding.toml").scene()
    with pytest.raises(ValueError, match="entrain no oil"):
        pyworm.plan(scene, effects="isothermal")


@pytest.mark.parametrize(
    ("oil", "effects", "said"),
    [
        ({"flow": None, "heat": None}, "shear-thinning", "no flow law is given"),
        ({"heat": None}, ("all", "film-heating"), "[oil.heat] is not given"),
    ],
)
def test_effects_that_an_oil_is_not_known_well_enough_for(oil, effects, said):
    with pytest.raises(ValueError, match=re.escape(said)):
        pyworm.plan(ball(**oil), effects=effects)


def hard(slide_roll_ratio, speed, load):
    """The traction case at another mean speed [m/s] and so many times its load."""
    scene = ball(slide_roll_ratio)
    motions = tuple(RigidMotion(speed * (1 + of * slide_roll_ratio / 2), 0.0) for of in (1, -1))
    return replace(scene, motions=motions, load=load * scene.load)


@pytest.mark.parametrize(
    ("slide_roll_ratio", "speed", "load"),
    [(10.0, 2.0, 1.0), (0.5, 10.0, 8.0), (1.9, 2.0, 3.375), (2.1, 2.0, 3.375), (2.0, 6.0, 1.0)],
    ids=["ratio 10", "10 m/s at 2 GPa", "disc nearly at rest", "and turning back", "at rest"],
)
def test_hot_contacts_converge(slide_roll_ratio, speed, load):
    figures = solved(hard(slide_roll_ratio, speed, load)).figures
    rise = figures.temperature_max_film.value - (273.15 + 60)
    assert 50 < rise < 150
    assert abs(figures.heat_balance) < 0.02


def test_films_far_softer_than_the_newtonian_ones_they_start_from():
    """The Newtonian film has stresses many times an Eyring stress of 0.1 MPa, or beyond a limit all over."""
    soft = solved(ball(0.5, flow=FlowLaw("eyring", stress=1e5))).figures
    assert 0 < soft.friction_coefficient.value < 0.003
    limited = solved(hard(0.1, 10.0, 1.0)).figures
    assert 0.005 < limited.friction_coefficient.value < 0.035


def test_an_oil_that_slips_all_over_rubs_by_its_limit():
    """Bair and Winer's law where the limit is reached all over the contact: friction is the limit over it."""
    flow = FlowLaw("bair-winer", limit=4.2e6, limit_pressure=0.035)
    slipping = solved(ball(0.5, flow=flow))
    pressure = slipping.fields.pressure
    assert (slipping.fields.slip.where(pressure > pressure.max() / 10, 1) > 0).mean() > 0.5
    node = float(pressure.x.diff("x").mean() * pressure.y.diff("y").mean())
    most = 0.035 + 4.2e6 * node * float((pressure > pressure.max() / 100).sum()) / slipping.load
    assert 0.7 * most < slipping.figures.friction_coefficient.value < most


def test_a_film_whose_heat_is_not_found_is_marked_not_raised():
    flow = FlowLaw("bair-winer", limit=4.2e6, limit_pressure=0.01)
    scene = ball(0.5, flow=flow)
    plan = replace(pyworm.plan(scene, COARSE), wider_grids=(), largest_grid=1)
    solution = pyworm.solve(scene, plan)
    assert not solution.converged
    assert np.isinf(solution.figures.film_min.error)
