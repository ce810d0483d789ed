"""Thermal networks against analytic solutions of one and two nodes, and their balance."""

from types import SimpleNamespace

import numpy as np
import pytest

from pyworm.drives.heat_network import HeatPath, ThermalNetwork, ThermalStep

HOUR = 3600.0


def one_node(conductance=40.0):
    return ThermalNetwork(
        {"oil": 2e4},
        {"ambient": 293.15},
        [HeatPath("air", "oil", "ambient", conductance)],
        {"oil": 1600.0},
    )


def two_nodes():
    paths = [
        HeatPath("splash", "oil", "housing", 80.0),
        HeatPath("air", "housing", "ambient", 20.0),
    ]
    return ThermalNetwork(
        {"oil": 1.5e4, "housing": 6e4}, {"ambient": 300.0}, paths, {"oil": 900.0, "housing": 100.0}
    )


def test_one_node_is_loss_over_conductance_and_warms_by_its_time_constant():
    network = one_node()
    state = network.steady()
    assert state.temperatures["oil"] == pytest.approx(293.15 + 40, abs=1e-9)
    assert abs(state.imbalance) < 1e-9
    history = network.history([ThermalStep(1000.0), ThermalStep(500.0, running=False)], 293.15)
    # 40 K (1 - exp(-t/500 s)), then it cools by the same time constant
    warming = history.time <= 1000
    expected = 40 * (1 - np.exp(-history.time / 500))
    top = 40 * (1 - np.exp(-2))
    expected[~warming] = top * np.exp(-(history.time[~warming] - 1000) / 500)
    np.testing.assert_allclose(history.temperatures["oil"] - 293.15, expected, atol=2e-4)
    assert history.stored == pytest.approx(history.supplied, rel=1e-6)


def test_two_nodes_are_those_of_the_matrix_exponential():
    network = two_nodes()
    state = network.steady()
    # 1000 W over 20 W/K above 300 K; 900 W over 80 W/K above that
    assert state.temperatures == pytest.approx({"housing": 350, "oil": 361.25, "ambient": 300})
    assert [flow for _, flow in state.flows] == pytest.approx([900, 1000])
    matrix = np.array([[-80 / 1.5e4, 80 / 1.5e4], [80 / 6e4, -100 / 6e4]])
    rates, modes = np.linalg.eig(matrix)
    steady = np.array([361.25, 350])
    amplitudes = np.linalg.solve(modes, 300 - steady)
    history = network.history([ThermalStep(HOUR)], 300.0, points=30)
    expected = steady[:, None] + modes @ (
        amplitudes[:, None] * np.exp(rates[:, None] * history.time)
    )
    found = np.array([history.temperatures["oil"], history.temperatures["housing"]])
    np.testing.assert_allclose(found, expected, atol=2e-4)


def test_the_limit_of_time_is_the_steady_state_where_conductances_depend_on_temperature():
    """Heat by a power of 5/4 of the excess, as of free convection: excess (P/c)^(4/5)."""
    network = one_node(lambda hot, cold: 12.0 * max(hot - cold, 0.0) ** 0.25)
    rise = (1600 / 12.0) ** 0.8
    state = network.steady()
    assert state.temperatures["oil"] - 293.15 == pytest.approx(rise, rel=1e-9)
    assert abs(state.imbalance) < 1e-6
    history = network.history([ThermalStep(10 * HOUR)], 293.15)
    assert history.temperatures["oil"][-1] == pytest.approx(state.temperatures["oil"], abs=1e-3)
    assert history.stored == pytest.approx(history.supplied, rel=1e-5)


def test_a_day_s_ambient_is_followed_with_its_amplitude_and_lag():
    """First-order answer to a sine: 10 K/(1 + (w tau)^2)^(1/2), later by atan(w tau)."""
    turn = 2 * np.pi / (24 * HOUR)
    network = ThermalNetwork(
        {"oil": 5e5}, {"ambient": 290.0}, [HeatPath("air", "oil", "ambient", 25.0)], {"oil": 0.0}
    )
    swing = {"ambient": lambda time: 290 + 10 * np.sin(turn * time)}
    history = network.history([ThermalStep(96 * HOUR)], 290.0, swing, points=400)
    late = history.time > 72 * HOUR
    lag = turn * 5e5 / 25
    followed = 290 + 10 / np.hypot(1, lag) * np.sin(turn * history.time - np.arctan(lag))
    np.testing.assert_allclose(history.temperatures["oil"][late], followed[late], atol=5e-3)


def test_a_node_without_a_way_out_and_a_balance_that_does_not_close_are_refused():
    with pytest.raises(ValueError, match="oil: has no path"):
        ThermalNetwork({"oil": 1.0}, {"ambient": 300.0}, [], {"oil": 1.0})
    with pytest.raises(ValueError, match="seal: is no node"):
        ThermalNetwork({}, {"ambient": 300.0}, [], {"seal": 1.0})
    with pytest.raises(ValueError, match="does not close"):
        one_node(lambda hot, cold: 0.0).steady()


def test_a_source_that_falls_with_temperature_is_a_stronger_path():
    """P0 - c (T - T0) over G is P0 over G + c; the heat set free is that of the path outside."""
    network = ThermalNetwork(
        {"oil": 2e4},
        {"ambient": 300.0},
        [HeatPath("air", "oil", "ambient", 30.0)],
        {"oil": lambda known: 1600.0 - 10.0 * (known["oil"] - 300.0)},
    )
    state = network.steady()
    assert state.temperatures["oil"] == pytest.approx(340, abs=1e-6)
    assert state.power == pytest.approx(1200)
    history = network.history([ThermalStep(1000.0)], 300.0)
    rise = 40 * (1 - np.exp(-history.time * 40 / 2e4))
    np.testing.assert_allclose(history.temperatures["oil"] - 300, rise, atol=2e-4)
    lost = 1600 * history.time - 10 * 40 * (history.time - 500 * (1 - np.exp(-history.time / 500)))
    np.testing.assert_allclose(history.dissipated, lost, rtol=1e-6, atol=1e-2)


@pytest.mark.parametrize("seconds", [100.0, 5000.0])
def test_repeated_steps_begin_where_the_series_of_all_before_ends(seconds):
    """On and off for equal times: the least excess is 40 K x/(1 + x), x = exp(-t/tau)."""
    network, steps = one_node(), [ThermalStep(seconds), ThermalStep(seconds, running=False)]
    start = network.periodic_start(steps, 293.15)
    decay = np.exp(-seconds / 500)
    assert start["oil"] - 293.15 == pytest.approx(40 * decay / (1 + decay), abs=2e-3)


def test_steps_have_networks_and_surroundings_of_their_own():
    colder = ThermalNetwork(
        {"oil": 2e4},
        {"ambient": 283.15},
        [HeatPath("fan", "oil", "ambient", 80.0)],
        {"oil": 1600.0},
    )
    network = one_node()
    history = network.history(
        [ThermalStep(1e5), ThermalStep(1e5, network=colder, swings={})],
        293.15,
        {"ambient": lambda time: 303.15},
    )
    oil, ambient = (history.temperatures[node] for node in ("oil", "ambient"))
    assert oil[[199, -1]] == pytest.approx([343.15, 303.15], abs=1e-3)
    assert ambient[[0, 199, -1]] == pytest.approx([303.15, 303.15, 283.15])


def test_temperatures_that_never_come_back_are_refused(monkeypatch):
    """Each period ends anywhere."""
    ends = np.random.default_rng(1)

    def history(self, *given, **points):
        return SimpleNamespace(temperatures={"oil": [ends.uniform(300, 400)]})

    monkeypatch.setattr(ThermalNetwork, "history", history)
    with pytest.raises(ValueError, match="come back after a period"):
        one_node().periodic_start([ThermalStep(10.0)], 293.15)
