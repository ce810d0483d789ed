"""How tooth pairs of the ZI drive share a torque."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from zi_drives import sharif

from pyworm.drives.worm.loads import mesh, tooth_compliance
from pyworm.drives.worm.loads.load_sharing import Arms, Transmission, share
from pyworm.drives.worm.loads.tooth_compliance import ToothSprings, mesh_springs, tooth_springs
from pyworm.formulas.hertz import hertz
from pyworm.scene.point import Paraboloid

TORQUE = 6.7e3
RADII = 3.0, 0.095
MODULUS = 170e9


def loaded(**changes):
    """The drive of Sharif et al. (2001) with a torque on its wheel."""
    torque = Transmission(**({"torque": TORQUE, "shaft": "wheel"} | changes))
    return sharif(tooth_load=None, transmission=torque)


@pytest.fixture(scope="module")
def drive():
    return loaded()


@pytest.fixture(scope="module")
def paraboloids():
    """Springs of paraboloids a micrometre apart, the same at all phases."""

    def gap(x, y):
        height, covered = Paraboloid(*RADII)(x, y)
        return height + 1e-6, covered

    return tooth_springs(lambda phase: gap, lambda phase: RADII, MODULUS, 28e3, 2e9, 0.06)


@pytest.mark.parametrize("load", (60.0, 500.0, 5e3, 27e3, 40e3))
def test_a_spring_is_that_of_hertz(paraboloids, load):
    approach = 1e-6 + hertz(*RADII, load, MODULUS).approach + load / 2e9
    assert paraboloids.at(0.3).load(approach) == pytest.approx(load, rel=0.02)
    assert paraboloids.at(0.3).load(0.9e-6) == 0
    assert paraboloids.at(2.0).load(approach) == 0


@settings(max_examples=30, deadline=None)
@given(
    phase=st.floats(0, 1),
    friction=st.floats(0, 0.1),
    driver=st.sampled_from(["worm", "wheel"]),
    shaft=st.sampled_from(["worm", "wheel"]),
)
def test_moments_and_powers_balance(drive, phase, friction, driver, shaft):
    torque = 300.0 if shaft == "worm" else TORQUE
    load = Transmission(torque, shaft, "equal", friction)
    turned = replace(drive, transmission=load, driver=driver)
    shared = turned.shared(phase)
    arms = turned.arms(shared.phases)
    torques = {of: float(arms.of(of, friction) @ shared.forces) for of in ("worm", "wheel")}
    assert torques[shaft] == pytest.approx(torque, rel=1e-12)
    sliding = np.linalg.norm(turned.sliding(shared.phases), axis=0)
    loss = float(friction * shared.forces @ sliding)
    wheel_speed = turned.cycle.speed_ratio * turned.rotation
    into = torques["worm"] * turned.rotation - torques["wheel"] * wheel_speed
    assert into == pytest.approx(loss, abs=1e-9 * TORQUE * abs(wheel_speed))
    assert (torques["worm"] > torques["wheel"] * turned.cycle.speed_ratio) == (
        driver == "worm" and loss > 0
    ) or loss < 1e-9


@pytest.mark.parametrize("phase", (0.0, 0.03, 0.25, 0.47, 0.5))
def test_pairs_agree_on_the_turn_of_the_wheel(drive, phase):
    shared = drive.shared(phase)
    assert shared.forces @ drive.arms(shared.phases).wheel_normal == pytest.approx(TORQUE, rel=1e-9)
    # seen from any of the pairs it is the same instant
    for other in shared.phases[(shared.phases >= 0) & (shared.phases <= 1)]:
        again = drive.shared(float(other))
        loaded_ones = again.forces[again.forces > 0]
        np.testing.assert_allclose(loaded_ones, shared.forces[shared.forces > 0], rtol=1e-6)
        assert again.turn == pytest.approx(shared.turn, rel=1e-6)


def test_teeth_share_evenly_in_the_middle_and_edges_carry_at_the_ends(drive):
    whole = TORQUE / drive.wheel_flank.lever
    middle = drive.shared(0.25)
    np.testing.assert_allclose(middle.forces, whole / 2, rtol=0.02)
    # with one point of contact on the teeth, their neighbours' edges carry as well
    alone = drive.shared(0.5)
    assert alone.forces[np.argmin(np.abs(alone.phases - 0.5))] < 0.45 * whole
    assert np.all(alone.forces > 0.2 * whole)


def test_pairs_that_lag_carry_less_and_soft_teeth_share_more_evenly():
    loads, rigid = np.array([1e2, 1e3, 1e4]), np.array([1e-6, 4e-6, 16e-6])

    def springs(stiffness):
        rows = np.tile(rigid + loads / stiffness, (2, 1))
        return ToothSprings(np.array([-1.0, 2.0]), loads, np.zeros(2), rows)

    phases, arms, ahead = np.array([0.2, 0.7]), np.full(2, 0.24), np.array([1e-5, -1e-5])
    parts = []
    for stiffness in (np.inf, 5e8):
        shared = share(
            Transmission(1e3, "wheel"), phases, arms, 0.24, ahead, springs(stiffness)
        ).forces
        assert arms @ shared == pytest.approx(1e3)
        parts.append(shared[1] / shared[0])
    assert parts[0] < parts[1] < 1


APART = np.array([0.2, 0.7])
"""Phases of two tooth pairs."""


def shares(springs, lifts, ahead=(0.0, 0.0)):
    """How two pairs share 14 kN at a lever of 0.24 m, their films lifting them."""
    load = Transmission(0.24 * 14e3, "wheel", lifts=tuple(zip(APART, lifts, strict=True)))
    return share(load, APART, np.full(2, 0.24), 0.24, np.array(ahead), springs)


def test_approaches_and_lifts_of_pairs_agree(paraboloids):
    lifts, ahead = np.array([2e-6, 0.5e-6]), np.array([-5e-6, 3e-6])
    shared = shares(paraboloids, lifts, ahead)
    assert np.all(shared.forces > 1e3)
    dry = [1e-6 + hertz(*RADII, load, MODULUS).approach + load / 2e9 for load in shared.forces]
    np.testing.assert_allclose(dry - lifts, 0.24 * (shared.turn + ahead), rtol=0.01)


@given(first=st.floats(0, 3e-6), second=st.floats(0, 3e-6))
def test_the_pair_with_the_thicker_film_carries_more(paraboloids, first, second):
    even = shares(paraboloids, (0.0, 0.0))
    lifted = shares(paraboloids, (first, second))
    np.testing.assert_allclose(even.forces, 7e3)
    assert lifted.forces.sum() == pytest.approx(14e3)
    assert np.sign(np.diff(lifted.forces).round(6)) == np.sign(
        round(second - first, 15)
    ) or lifted.forces == pytest.approx(even.forces)
    # equal lifts turn the wheel back and move no load
    level = shares(paraboloids, (second, second))
    np.testing.assert_allclose(level.forces, even.forces)
    assert level.turn == pytest.approx(even.turn - second / 0.24, abs=1e-12)


def test_a_pair_that_only_its_film_reaches_carries(paraboloids):
    """Apart by a micrometre more than the other is pressed in, behind a film of three."""
    pressed = hertz(*RADII, 14e3, MODULUS).approach + 14e3 / 2e9
    ahead = 0.0, -(pressed + 1e-6) / 0.24
    assert shares(paraboloids, (0.0, 0.0), ahead).forces[1] == 0
    assert shares(paraboloids, (0.0, 3e-6), ahead).forces[1] > 50


def test_lifts_are_constant_beyond_the_phases_given():
    load = Transmission(TORQUE, "wheel", lifts=((0.1, 2e-6), (0.5, 3e-6), (0.9, 1e-6)))
    np.testing.assert_allclose(
        load.lift(np.array([-0.2, 0.1, 0.5, 0.9, 1.2])), [2e-6, 2e-6, 3e-6, 1e-6, 1e-6]
    )
    assert load.lift(np.array([0.3])) < 3e-6
    np.testing.assert_array_equal(Transmission(TORQUE, "wheel").lift(np.zeros(2)), 0)


def test_equal_shares(drive):
    shared = replace(drive, transmission=Transmission(TORQUE, "wheel", "equal")).shared(0.2)
    whole = TORQUE / drive.wheel_flank.lever
    np.testing.assert_allclose(shared.forces[shared.forces > 0], whole / 2)
    assert sum(shared.forces > 0) == 2


def test_the_load_of_one_tooth_is_that_of_all_on_the_teeth():
    shared = sharif().shared(0.2)
    assert sharif().scene(0.2).load == 14e3
    np.testing.assert_array_equal(shared.forces > 0, (shared.phases >= 0) & (shared.phases <= 1))


def test_friction_of_a_worm_asks_for_more_torque_than_of_a_wheel(drive):
    forward, back = (
        replace(drive, driver=driver).arms(np.array([0.5])) for driver in ("worm", "wheel")
    )
    assert forward.of("worm", 0.05) > forward.of("worm", 0.0) > back.of("worm", 0.05)
    assert forward.of("wheel", 0.05) < forward.of("wheel", 0.0) < back.of("wheel", 0.05)
    assert isinstance(forward, Arms)


def test_a_driven_worm_has_the_motions_reversed(drive):
    driven = replace(drive, driver="wheel")
    forward, back = drive.scene(0.4), driven.scene(0.4)
    for one, other in zip(forward.motions, back.motions, strict=True):
        np.testing.assert_allclose(np.array(one(2e-3, 1e-3)), -np.array(other(2e-3, 1e-3)))
    assert forward.past.before(1e-3).phase < 0.4 < back.past.before(1e-3).phase
    for scene, of, passed in ((forward, drive, 0.4), (back, driven, 0.6)):
        assert scene.past.seconds == pytest.approx(
            (of.life.before + passed) / drive.phases_per_second
        )


def test_the_x_axis_of_an_earlier_contact_is_turned_by_the_turning_since(drive):
    past = drive.scene(0.4).past
    seconds = 1e-3
    x, y, _ = drive.contact(0.4).axes
    x_then = drive.contact(past.before(seconds).phase).axes[0]
    angle = -seconds * past.life.turning(past.seconds - seconds / 2)
    assert 0.01 < abs(angle) < 0.1
    assert x_then @ (np.cos(angle) * x + np.sin(angle) * y) > 1 - 1e-4


def test_dry_contacts_are_solved_once_for_equal_teeth(monkeypatch):
    """Whatever friction, lifts and driver are; drives take them along to processes that know nothing."""
    calls = []
    solve = tooth_compliance.kernel.dry_contact
    monkeypatch.setattr(mesh, "mesh_springs", mesh_springs)  # with its own cache
    monkeypatch.setattr(tooth_compliance, "SPRING_PHASES", np.array([0.0, 0.5, 1.0]))
    monkeypatch.setattr(
        tooth_compliance.kernel, "dry_contact", lambda *given: calls.append(1) or solve(*given)
    )
    for change in ({}, {"friction": 0.03, "lifts": ((0.5, 1e-6),)}):
        drive = loaded(torque=1.01 * TORQUE, **change)
        springs = replace(drive, driver="wheel").springs, drive.springs
        assert springs[0] is springs[1]
    mesh_springs.cache_clear()
    _ = pickle.loads(pickle.dumps(drive)).springs
    assert len(calls) == 3 * len(tooth_compliance.LOAD_SHARES)
