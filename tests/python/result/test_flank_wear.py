"""The work of asperities on a flank: a block on a plate, and nothing lost on the way to the cells."""

from types import SimpleNamespace

import numpy as np
import pytest

from pyworm.formulas.wear_law import archard_depth
from pyworm.result import flank_wear
from pyworm.result.flank_wear import FlankGrid, _whole_mesh
from pyworm.result.life import Fields

PRESSURE, LENGTH, WIDTH, SPEED = 50e6, 8e-3, 6e-3, 2.0
COEFFICIENT = 1e-16


def block_on_plate(nodes=(81, 61), cell=0.5e-3, turn=0.0):
    """A block that moves over a plate at its sliding speed: work on the plate and on the block."""
    grid = FlankGrid(np.arange(-20e-3, 20e-3, cell), np.arange(-10e-3, 10e-3, cell))
    sides = [
        (np.arange(count) + 0.5) / count * length - length / 2
        for count, length in zip(nodes, (LENGTH, WIDTH), strict=True)
    ]
    x, y = np.meshgrid(*sides)
    area = LENGTH * WIDTH / x.size
    start, end, steps = -14e-3, 14e-3, 700
    seconds = (end - start) / SPEED / steps
    work = np.zeros(grid.shape)
    for part in (np.arange(steps) + 0.5) / steps:
        middle = start + part * (end - start)
        at = np.cos(turn) * x - np.sin(turn) * y + middle, np.sin(turn) * x + np.cos(turn) * y
        amount = np.full(x.size, PRESSURE * SPEED * seconds * area)
        work += grid.spread(amount, at[0].ravel(), at[1].ravel())
    return grid, work


def test_a_uniform_block_wears_k_p_s_in_the_middle_of_its_track():
    """Each place is slid over by the block's length."""
    grid, work = block_on_plate()
    middle = work[np.ix_(np.abs(grid.radius) < 2e-3, np.abs(grid.face) < 8e-3)]
    depth = archard_depth(COEFFICIENT, 1.0, middle)
    assert depth == pytest.approx(np.full(depth.shape, COEFFICIENT * PRESSURE * LENGTH), rel=2e-3)


@pytest.mark.parametrize("turn", [0.0, 0.4, 1.2])
def test_the_whole_volume_is_k_f_s(turn):
    grid, work = block_on_plate(turn=turn)
    volume = COEFFICIENT * work.sum() * grid.cell
    force, path = PRESSURE * LENGTH * WIDTH, 28e-3
    assert volume == pytest.approx(COEFFICIENT * force * path, rel=1e-9)


def test_the_cells_do_not_decide():
    """Half the cells, with nodes as many times closer: the middle of the track stays as deep."""
    (coarse_grid, coarse), (fine_grid, fine) = (
        block_on_plate(),
        block_on_plate(nodes=(161, 121), cell=0.25e-3),
    )
    depths = [
        work[np.ix_(np.abs(grid.radius) < 2e-3, np.abs(grid.face) < 8e-3)].mean()
        for grid, work in ((coarse_grid, coarse), (fine_grid, fine))
    ]
    assert depths[1] == pytest.approx(depths[0], rel=2e-3)


def layer(face, radius=0.08, rubbing=2.0):
    places = np.full((3, 4), float(face)), np.full((3, 4), radius)
    fields = {"asperity_rubbing": np.full((3, 4), rubbing), "pressure": np.ones((3, 4))}
    return {"face": places[0], "radius": places[1], **fields}


def test_contacts_go_on_to_both_ends_of_the_mesh():
    """The path of two solved phases, the load of the whole mesh."""
    load = np.array([-0.3, -0.2, 0.0, 0.2, 0.8, 1.0, 1.2]), np.array([0, 0, 2, 4, 4, 2, 0.0])
    stations = _whole_mesh([0.2, 0.8], [layer(0.2e-3), layer(0.8e-3)], load)
    phases = [phase for phase, _ in stations]
    assert phases == sorted(phases) and phases[0] == 0.0 and phases[-1] == 1.0
    for phase, one in stations:
        assert one["face"][0, 0] == pytest.approx(phase * 1e-3)
        assert one["asperity_rubbing"][0, 0] == pytest.approx(2.0 * np.interp(phase, *load) / 4)


def test_a_tip_that_touches_stays_where_it_is():
    load = np.array([-0.4, 0.0, 1.0, 1.4]), np.array([1.0, 4, 4, 1.0])
    stations = _whole_mesh([0.2, 0.8], [layer(0.2e-3), layer(0.8e-3)], load)
    faces = {phase: one["face"][0, 0] for phase, one in stations}
    assert min(faces) == -0.4 and max(faces) == 1.4
    assert faces[-0.4] == pytest.approx(0.0, abs=1e-12) and faces[1.4] == pytest.approx(1e-3)


def test_too_few_phases_for_wear_are_named_with_what_is_needed():
    built = SimpleNamespace(
        solutions=[SimpleNamespace(converged=True, fields={"asperity_pressure"}, phase=0.5)]
    )
    with pytest.raises(ValueError) as refused:
        flank_wear.flank_grid(built)
    assert str(refused.value).startswith("operation.phases: of those solved 1 converged")
    assert "(0.5); wear needs 3 or more" in str(refused.value)


def test_without_a_curve_of_the_load_the_pass_ends_with_the_solved_phases():
    assert [phase for phase, _ in _whole_mesh([0.2, 0.8], [layer(0), layer(1)], None)] == [0.2, 0.8]


def pass_in_motion(monkeypatch, sizes, own):
    """Phases and rubbing between two solved phases, of instants with a size each and the phases' own."""
    x, y = np.linspace(-1e-3, 1e-3, 4), np.linspace(-1e-3, 1e-3, 3)
    even = np.ones((4, 3))
    frames = [
        Fields(phase / 10, 2 * x, 2 * y, 1e8 * even, even, size * even)
        for phase, size in sizes.items()
    ]
    life = SimpleNamespace(
        seconds=np.array([0.0, 0.1]), phases=np.array([0.0, 1.0]), frames=tuple(frames)
    )
    monkeypatch.setattr(flank_wear, "_worm_life", lambda result: life)
    layers = [layer(0.2e-3, rubbing=own[0]), layer(0.8e-3, rubbing=own[1])]
    layers[1]["temperature_body_2"] = 350.0 * np.ones((3, 4))  # of phases with heat alone
    phases, found = flank_wear._with_instants(None, [0.2, 0.8], layers, x, y)
    assert found[0] is layers[0] and found[-1] is layers[1]
    return phases, found


def test_between_solved_phases_asperities_rub_as_at_the_instants_of_transient_films(monkeypatch):
    """On coarse grids they bear half of what they do on finer ones, and three times as much in between."""
    sizes = {0.1: 1.0, 0.2: 1.0, 0.5: 3.0, 0.8: 1.0, 0.9: 1.0}
    phases, found = pass_in_motion(monkeypatch, sizes, (2.0, 2.0))
    assert phases == pytest.approx([0.2, 0.5, 0.8])
    assert found[1]["asperity_rubbing"] == pytest.approx(np.full((3, 4), 6.0))
    assert found[1]["face"] == pytest.approx(np.full((3, 4), 0.5e-3))
    assert found[1]["pressure"] == pytest.approx(np.full((3, 4), 1e8))


def test_a_phase_with_hardly_any_contact_does_not_rule_those_beside_it(monkeypatch):
    sizes = {0.2: 1e-6, 0.5: 1.0, 0.8: 1.0}
    _, found = pass_in_motion(monkeypatch, sizes, (1e-3, 1.0))
    assert found[1]["asperity_rubbing"] == pytest.approx(np.ones((3, 4)), rel=2e-3)


def test_instants_between_phases_without_contact_say_nothing(monkeypatch):
    phases, _ = pass_in_motion(monkeypatch, dict.fromkeys((0.2, 0.5, 0.8), 0.0), (1.0, 1.0))
    assert phases == [0.2, 0.8]
