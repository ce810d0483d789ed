"""How rollers share the torque, and how fast they turn: balances, limits, closed forms."""

from dataclasses import replace
from math import pi
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from roller_sections import ROLLERS, section

from pyworm.drives.roller_worm.load_sharing import Compliance, lever, share, slices, worm_lever
from pyworm.drives.roller_worm.motion import (
    FilmTraction,
    Pin,
    flow_stress,
    line_motion,
    roller_speed,
)
from pyworm.drives.roller_worm.profile import Crown
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands

BODIES = Body(210e9, 0.26), Body(207e9, 0.29)
OIL = Oil(
    Roelands.from_alpha(0.08, 2.2e-8),
    Density.dowson_higginson(870.0),
    FlowLaw("eyring-limited", stress=5e6, limit=5e6, limit_pressure=0.05),
)
TORQUE = 1114.0
WHEEL_SPEED = 157.08 / ROLLERS


def loads(shared):
    """Slices of all rollers, their lengths and loads."""
    contact, lengths = slices(shared.section, shared.wheel_angles)
    of = [
        shared.load(shared.section.line(angle, np.linspace(0, 1, 3)), number)
        for number, angle in enumerate(shared.wheel_angles)
    ]
    return contact, lengths, of


@settings(deadline=None, max_examples=25)
@given(
    phase=st.floats(0, 1),
    stiffness=st.sampled_from([np.inf, 1e9, 5e7]),
    crown=st.sampled_from([None, Crown(0.5, 8e-3), Crown(2.0)]),
    sharing=st.sampled_from(["elastic", "equal"]),
    name=st.sampled_from(["left", "right"]),
)
def test_moments_about_both_axes_balance(phase, stiffness, crown, sharing, name):
    part = section(name, crown=crown)
    compliance = Compliance(BODIES, stiffness)
    shared = share(part, compliance, float(part.wheel_angle(phase)), TORQUE, sharing)
    wheel = worm = 0.0
    for number, angle in enumerate(shared.wheel_angles):
        contact, lengths = slices(part, np.array(angle))
        force = shared.load(contact, number) * lengths
        wheel += np.sum(force * lever(contact))
        worm += np.sum(force * worm_lever(part, contact))
        assert np.sum(force) == pytest.approx(shared.forces[number], rel=1e-9, abs=1e-6)
    # what idles resists
    assert wheel == pytest.approx(TORQUE if name == "left" else -TORQUE, rel=1e-8)
    # the worm's power is the wheel's
    assert worm * ROLLERS * WHEEL_SPEED == pytest.approx(wheel * WHEEL_SPEED, rel=1e-8)


@settings(deadline=None, max_examples=50)
@given(load=st.floats(1.0, 1e6), curvature=st.floats(50, 500), length=st.floats(1e-3, 0.03))
def test_approach_and_load_of_a_slice_are_each_other_s_inverse(load, curvature, length):
    compliance = Compliance(BODIES)
    approach = compliance.approach(np.array(load), curvature, 6.5e-3, length)
    assert compliance.load(approach, curvature, 6.5e-3, length) == pytest.approx(load, rel=1e-9)


def test_the_approach_of_a_cylinder_is_johnson_s():
    """A rigid thread: what a cylinder yields between contact and axis, by quadrature of the stress there.

    Johnson (1985), chapter 5.6: stresses of the Hertz pressure less the uniform stress of the free
    boundary, integrated along the line of action in plane strain.
    """
    rigid, steel = SimpleNamespace(youngs_modulus=1e30, poisson_ratio=0.3), Body(207e9, 0.29)
    compliance = Compliance((rigid, steel))
    load, radius = 150e3, 6.5e-3
    curvature = 1 / radius
    approach = compliance.approach(np.array(load), curvature, radius, 12e-3)
    b = np.sqrt(8 * load / (pi * reduced_modulus(rigid, steel) * curvature))
    z, weights = np.polynomial.legendre.leggauss(400)
    t = (z + 1) / 2  # z = R t^3: most happens near the contact
    depth, measure = radius * t**3, weights / 2 * 3 * radius * t**2
    peak = 2 * load / (pi * b)
    root = np.sqrt(b**2 + depth**2)
    along = -peak * b / root
    across = -peak / b * ((b**2 + 2 * depth**2) / root - 2 * depth)
    # the opposite load and the uniform tension that together free the rim
    far = 2 * radius - depth
    along = along - 2 * load / pi / far + load / (pi * radius)
    across = across + load / (pi * radius)
    nu, modulus = steel.poisson_ratio, steel.youngs_modulus
    strain = (1 - nu**2) / modulus * (along - nu / (1 - nu) * across)
    assert approach == pytest.approx(-np.sum(strain * measure), rel=2e-3)


def test_a_softer_pin_shares_more_evenly():
    part = section("left", crown=Crown(2.0))
    spread = []
    for stiffness in (np.inf, 1e8, 1e7):
        forces = share(part, Compliance(BODIES, stiffness), part.first, TORQUE).forces
        spread.append(forces.max() / forces.min())
    assert spread[0] > spread[1] > spread[2]


def test_equal_shares_are_equal():
    part = section("left")
    shared = share(part, Compliance(BODIES), float(part.wheel_angle(0.3)), TORQUE, "equal")
    assert shared.forces / shared.lengths == pytest.approx(
        np.full(len(shared.forces), shared.uniform)
    )


def test_a_crown_moves_the_load_to_the_middle():
    plain, crowned = section("left"), section("left", crown=Crown(2.0))
    middle = []
    for part in (plain, crowned):
        angle = float(part.wheel_angle(0.4))
        shared = share(part, Compliance(BODIES), angle, TORQUE)
        line = part.line(np.array(angle), np.array([0.02, 0.5]))
        ends, centre = shared.load(line, shared.roller(angle))
        middle.append((ends, centre))
    assert middle[1][1] > 1.3 * middle[0][1]
    assert middle[1][0] < 0.5 * middle[0][0]


def turning(part, phase, spinning, pin=None):
    """A roller's speed, its slices and their motion."""
    angle = float(part.wheel_angle(phase))
    shared = share(part, Compliance(BODIES), angle, TORQUE)
    contact, lengths = slices(part, np.array(angle))
    load = shared.load(contact, shared.roller(angle))
    traction = FilmTraction(OIL, BODIES)
    extra = {} if pin is None else {"pin": pin}
    speed = roller_speed(
        part.envelope, contact, lengths, load, WHEEL_SPEED, spinning, traction, **extra
    )
    return speed, contact, line_motion(part.envelope, contact, WHEEL_SPEED, speed)


def test_velocities_are_those_of_points_of_the_bodies():
    """Differences of positions over a short time, with the contact line followed at fixed s."""
    part = section("left")
    flank, angle, place = part.envelope, 0.5, 3e-3
    contact = flank.contact(place, angle)
    motion = line_motion(flank, contact, WHEEL_SPEED, 40.0)
    dt = 1e-7
    later = angle + WHEEL_SPEED * dt
    moved = flank.point(place, later) - contact.point
    worm = flank.from_worm(flank.into_worm(contact.point, contact.wheel_angle), later)
    worm_velocity = (worm - contact.point - moved) / dt
    going, side, axis, middle = flank.axes(later)
    theta = contact.theta + 40.0 * dt
    roller = middle + place * axis + contact.radius * (np.cos(theta) * going + np.sin(theta) * side)
    roller_velocity = (roller - contact.point - moved) / dt
    for found, wanted in ((motion.worm, worm_velocity), (motion.roller, roller_velocity)):
        assert found[0] == pytest.approx(wanted @ motion.x_axis, abs=2e-4)
        assert found[1] == pytest.approx(wanted @ motion.y_axis, abs=2e-4)
    # the surfaces do not move through each other or through the line
    assert abs((worm_velocity - roller_velocity) @ contact.normal) < 2e-4


def test_the_contact_frame_is_right_handed_with_the_roller_above():
    part = section("right")
    _, contact, motion = turning(part, 0.4, "locked")
    z = np.cross(motion.x_axis, motion.y_axis, axis=0)
    assert np.allclose(z, -contact.normal, atol=1e-12)
    assert (motion.worm[0] > 0).all()


def test_locked_rollers_stand_and_rolling_ones_do_not_slide_in_the_mean():
    part = section("left")
    speed, _, motion = turning(part, 0.5, "locked")
    assert speed == 0
    # a locked roller's surface goes with the line: it is slow, the worm fast
    assert np.abs(motion.roller[0]).max() < 0.02 * motion.worm[0].min()
    _, _, motion = turning(part, 0.5, "rolling")
    assert np.mean(motion.round_worm - motion.round_roller) == pytest.approx(0, abs=0.05)
    assert (
        (motion.round_worm - motion.round_roller).min()
        < 0
        < (motion.round_worm - motion.round_roller).max()
    )


def test_a_free_roller_nearly_rolls_and_a_braked_one_lags():
    part = section("left")
    rolling, *_ = turning(part, 0.5, "rolling")
    free, *_ = turning(part, 0.5, "free")
    braked, *_ = turning(part, 0.5, "free", Pin(3e-3, 0.05))
    stuck, *_ = turning(part, 0.5, "free", Pin(3e-3, 10.0))
    assert free == pytest.approx(rolling, rel=0.01)
    assert 0 < braked < free
    assert stuck == 0


def test_both_sections_turn_a_roller_opposite_ways():
    left, *_ = turning(section("left"), 0.5, "rolling")
    right, *_ = turning(section("right"), 0.5, "rolling")
    assert left * right < 0


@pytest.mark.parametrize(
    "flow",
    [
        FlowLaw("newtonian"),
        FlowLaw("eyring", stress=5e6),
        FlowLaw("bair-winer", limit=20e6, limit_pressure=0.04),
        FlowLaw("eyring-limited", stress=5e6, limit=20e6, limit_pressure=0.04),
        FlowLaw("carreau", stress=6e6, exponent=0.5),
    ],
)
def test_stress_by_a_flow_law_inverts_its_rate(flow):
    """The rates in the table of `FlowLaw`."""
    viscosity, pressure = 3.0, 0.4e9
    limit = flow.limit + flow.limit_pressure * pressure
    for rate in (1e3, 1e6, 1e8):
        tau = float(flow_stress(flow, np.array(viscosity), np.array(pressure), np.array(rate)))
        if flow.law == "newtonian":
            back = tau / viscosity
        elif flow.law == "eyring":
            back = flow.stress / viscosity * np.sinh(tau / flow.stress)
        elif flow.law == "bair-winer":
            back = -limit / viscosity * np.log1p(-tau / limit)
        elif flow.law == "carreau":
            shape = (1 + (viscosity * rate / flow.stress) ** 2) ** ((flow.exponent - 1) / 2)
            back = tau / viscosity / shape
        else:
            share_left = 1 - (tau / limit) ** (2 * flow.exponent)
            back = flow.stress / viscosity * np.sinh(tau / flow.stress) / share_left
        assert flow.stress_at(viscosity * rate, pressure) == pytest.approx(tau, rel=1e-6)
        # at the limit itself a rate cannot be told from the stress
        assert back == pytest.approx(rate, rel=1e-6) or tau == pytest.approx(limit, rel=1e-9)


def test_hands_are_mirrored():
    right, left = section("left", hand=-1), section("left", hand=1)
    one, *_ = turning(right, 0.3, "rolling")
    other, *_ = turning(left, 0.3, "rolling")
    assert one == pytest.approx(-other, rel=1e-9)
    assert replace(right, envelope=left.envelope) == left
