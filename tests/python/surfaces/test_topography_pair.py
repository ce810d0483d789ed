"""Curves of a pair of surfaces from their heights, against the closed forms that they take the place of."""

from dataclasses import replace

import numpy as np
import pytest

from pyworm.io.input_error import CaseError
from pyworm.materials.body import Body
from pyworm.materials.rough_surfaces import MIN_GAP_RATIO, RoughPair, RoughSurface, gap_rows
from pyworm.materials.roughness_assumptions import variations
from pyworm.materials.topography import Topography
from pyworm.surfaces import cell_table as tables
from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.parameters import slopes
from pyworm.surfaces.topography_pair import TopographyPair, topography_pair

MODULUS = 226e9
GAP = gap_rows()[1]


@pytest.fixture(autouse=True)
def cache(tmp_path_factory, monkeypatch):
    """A cache of the tests' own, so that nothing is taken from another program."""
    root = tmp_path_factory.getbasetemp() / "cache"
    monkeypatch.setenv("XDG_CACHE_HOME", str(root))
    return root


def _coarse(roughness: float, seed: int, aspect: float = 1.0) -> Topography:
    """A Gaussian surface on every fourth point: cheap, and alike in its averages."""
    fine = gaussian(roughness, 20e-6, aspect, seed)
    height = fine.height[::4, ::4]
    spacing = tuple(4 * step for step in fine.spacing)
    return Topography(height * (roughness / height.std()), spacing, periodic=True)


ALONG = _coarse(0.4e-6, 1, 3.0)


def _curves(pair):
    """Curves by name, the flow and shear tensors in their order xx, yy, xy."""
    values = pair.curves().values
    return {
        "pressure": np.exp(values[0]),
        "thickness": values[1] + GAP * pair.height,
        "area": values[2],
        "flow": values[3:6],
        "shear": values[6:9] / pair.height,
    }


def _at(values, gap):
    return values[..., np.abs(GAP - gap).argmin()]


@pytest.mark.parametrize("hardness", [None, 1e9])
def test_curves_have_the_order_of_closed_forms(hardness):
    surface = _coarse(0.4e-6, 1)
    found = _curves(TopographyPair((surface, None), (0.4e-6, 0.3e-6), MODULUS, hardness))
    slope = float(np.hypot(*slopes(surface))) * 0.5 / 0.4
    closed = _curves(
        RoughPair(
            (RoughSurface(0.5e-6, slope, hardness=hardness), RoughSurface(1e-12, 1e-12)),
            MODULUS / 2,
        )
    )
    for gap in (0.5, 1.0, 1.5):
        for name in ("pressure", "area"):
            ratio = _at(found[name], gap) / _at(closed[name], gap)
            assert 0.6 < ratio < 1.7, (name, gap)
    for gap in (3.0, 5.0, 20.0):
        assert _at(found["flow"], gap)[:2] == pytest.approx(_at(closed["flow"], gap)[:2], rel=0.06)
        # the other surface is 3/5 as high, and drags against it
        shear = _at(found["shear"], gap)[:2].mean()
        assert shear == pytest.approx(_at(closed["shear"], gap)[0] * (16 - 9) / 25, rel=0.12)
    if hardness is not None:
        assert found["pressure"].max() < hardness
        assert _at(found["pressure"], -3.0) > 0.9 * hardness


def test_curves_are_smooth_and_monotone():
    found = TopographyPair((ALONG, None), (0.4e-6, 0.3e-6), MODULUS, 1e9).curves()
    assert np.all(np.isfinite(found.values))
    assert np.all(np.isfinite(found.slopes))
    assert np.all(np.diff(found.values[0]) <= 0)
    thickness = found.values[1] + GAP * found.scale
    assert np.all(np.diff(thickness) >= -1e-12 * found.scale)
    assert thickness.min() == pytest.approx(MIN_GAP_RATIO * found.scale, rel=1e-6)
    steps = np.abs(np.diff(found.values[0]))
    assert np.all(steps[GAP[1:] < 6] < 1.5)


def test_a_turned_surface_turns_its_flow():
    """Ridges along x turned by a quarter have the factors of x and y exchanged, by an eighth they deflect."""
    pair = TopographyPair((ALONG, None), (0.4e-6, 0.0), MODULUS, 1e9)
    own, quarter, eighth = (
        _at(_curves(replace(pair, surfaces=(ALONG.turned(angle), None)))["flow"], 2.0)
        for angle in (0.0, np.pi / 2, np.pi / 4)
    )
    assert own[0] > 1.2 * own[1]
    assert quarter[:2] == pytest.approx(own[1::-1], rel=1e-9)
    assert eighth[2] == pytest.approx((own[0] - own[1]) / 2, rel=1e-9)
    assert eighth[:2].sum() == pytest.approx(own[:2].sum(), rel=1e-9)


def test_equal_surfaces_drag_against_each_other():
    surface = _coarse(0.4e-6, 1)
    pair = TopographyPair((surface, surface), (0.4e-6, 0.4e-6), MODULUS, 1e9)
    found = _curves(pair)
    assert np.abs(found["shear"]).max() < 1e-12
    # two of the same heights in one place are one of twice their height, not of sqrt(2)
    assert pair.height == pytest.approx(0.4e-6 * 2**0.5)
    worn = _curves(TopographyPair((surface, None), (0.4e-6, 0.4e-6), MODULUS, 1e9))
    assert found["pressure"] == pytest.approx(worn["pressure"])


def test_bodies_give_the_pair():
    softer = Body(110e9, 0.35, roughness=0.3e-6, hardness=1e9)
    rough = Body(206e9, 0.3, roughness=0.4e-6, topography=ALONG.turned(0.2), hardness=8e9)
    pair = topography_pair((rough, softer), (0.1, 2.0))
    assert pair.hardness == 1e9
    assert pair.height == pytest.approx(0.5e-6)
    assert pair.surfaces[0].x_direction == pytest.approx(0.3)
    assert pair.surfaces[1] is None


def test_a_table_is_solved_once_and_damaged_ones_again(cache, monkeypatch):
    cell = _coarse(0.4e-6, 7)
    solved = []
    solve = tables.solve_cell

    def counted(*given):
        solved.append(given)
        return solve(*given)

    monkeypatch.setattr(tables, "solve_cell", counted)
    monkeypatch.setattr(tables, "SEPARATIONS", np.array([4.0, 2.0, 1.0]))
    monkeypatch.setattr(tables, "CROSSED_SEPARATIONS", np.array([]))
    kept = []
    for _ in range(2):
        tables.cell_table.cache_clear()
        kept.append(tables.cell_table(cell, MODULUS, None))
    assert len(solved) == 1
    assert np.array_equal(kept[0].conducted, kept[1].conducted)
    for file in (cache / "pyworm" / "surfaces").iterdir():
        file.write_bytes(file.read_bytes()[:100])
    tables.cell_table.cache_clear()
    again = tables.cell_table(cell, MODULUS, None)
    assert len(solved) == 2
    assert np.array_equal(kept[0].pressure, again.pressure)
    tables.cell_table(cell, MODULUS / 2, None)
    assert len(solved) == 3


def test_a_table_that_does_not_converge_is_one_sentence(monkeypatch):
    monkeypatch.setattr("pyworm.kernel.rough_cell.MOST_ITERATIONS", 0)
    with pytest.raises(
        CaseError, match=r"did not converge at a gap of .* Rq; give a shortest_wave"
    ):
        tables.solve_cell(_coarse(0.4e-6, 1), MODULUS, None)


HARD = {
    "stripes": lambda x, y: np.sign(np.sin(2 * np.pi * (x + 0.5) / 16)) + 0 * y,
    "spike": lambda x, y: np.where((x == 3) & (y == 5), 30.0, np.sin(x) * np.sin(y)),
    "plateau": lambda x, y: np.minimum(np.sin(0.6 * x + y) + np.sin(1.7 * y - x), 0.3),
    "white": lambda x, y: np.random.default_rng(1).standard_normal((32, 32)),
}


@pytest.mark.parametrize("hardness", [None, 1e9, 200e9])
@pytest.mark.parametrize("name", HARD)
def test_surfaces_of_any_shape_have_sound_curves(name, hardness):
    """Steps, single summits, plateaus that touch all at once, heights without any correlation."""
    height = HARD[name](*np.meshgrid(np.arange(32), np.arange(32), indexing="ij"))
    height = (height - height.mean()) * (0.4e-6 / height.std())
    surface = Topography(height, (2e-6, 1e-6), periodic=True)
    found = _curves(TopographyPair((surface, None), (0.4e-6, 0.0), MODULUS, hardness))
    assert all(np.all(np.isfinite(values)) for values in found.values())
    assert np.all(np.diff(found["pressure"]) <= 0)
    assert np.all(found["flow"][:2] > 0)
    # no wall carries more than twice the oil that there is
    assert np.all(np.abs(found["shear"]) * 0.4e-6 <= 2 * found["thickness"])


def test_other_places_show_how_uncertain_the_averages_are(monkeypatch):
    monkeypatch.setattr(tables, "SEPARATIONS", np.geomspace(6.0, 0.5, 10))
    samples = tuple(_coarse(0.4e-6, seed) for seed in (3, 4, 5, 6))
    whole = TopographyPair((ALONG, None), (0.4e-6, 0.3e-6), MODULUS, None)
    assert whole.sampled() is None
    known = replace(whole, surfaces=(replace(ALONG, samples=samples), None))
    pressure, flow = known.sampled()
    curves = [replace(whole, surfaces=(sample, None)).curves().values for sample in samples]
    touching, apart = (np.abs(GAP - gap).argmin() for gap in (1.0, 5.5))
    # the mean of four samples: Student's t of three degrees of freedom, 3.182; and what they show of bias
    parts = [values[0, touching] for values in curves]
    scatter = 3.182 / 2 * np.std(parts, ddof=1)
    bias = abs(np.mean(parts) - whole.curves().values[0, touching]) / 3
    assert pressure[touching] == pytest.approx(scatter + bias, rel=1e-3)
    assert 0 < flow[apart] < flow[touching] < 1
    assert pressure.max() <= 1.0
    varied = dict(variations(known, 0.1, 0.1, np.full(9, 0.5e-6)))["sample"].curves.values
    before = known.curves().values
    assert varied[0] - before[0] == pytest.approx(0.1 * pressure, abs=1e-9)
    assert varied[3:5] / before[3:5] - 1 == pytest.approx(0.1 * np.array([flow, flow]), abs=1e-9)
    assert "sample" not in dict(variations(whole, 0.1, 0.1, np.full(9, 0.5e-6)))
