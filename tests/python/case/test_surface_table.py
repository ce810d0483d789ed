"""`[bodies.NAME.surface]`: what it makes of a body, and the one sentence for what is wrong with it."""

import numpy as np
import pytest
from folders import CASES
from refusals import changed

import pyworm
from pyworm.case.case import case_again
from pyworm.io.input_error import CaseError
from pyworm.surfaces.topography_pair import TopographyPair

POINT = (CASES / "point_m20_l10.toml").read_text()
GAUSSIAN = (
    'generated = { spectrum = "gaussian", roughness = "0.1 um", '
    'correlation_length = "9 um", seed = 1 }'
)
ARRAY = 'file = "flank.npy"\nspacing = "0.5 um"\nheight_unit = "um"'


def _case(directory, keys, body_2='roughness = "0.05 um"'):
    path = directory / "rough.toml"
    first = f"[bodies.body_1.surface]\n{keys}\n[bodies.body_1]\n"
    second = f"[bodies.body_2]\n{body_2}\n"
    path.write_text(changed(POINT, ("[bodies.body_1]\n", first), ("[bodies.body_2]\n", second)))
    return path


@pytest.fixture
def flank(tmp_path):
    heights = 0.1 * np.random.default_rng(1).standard_normal((64, 80))
    np.save(tmp_path / "flank.npy", heights)
    return heights


def test_heights_take_the_place_of_figures(tmp_path):
    case = pyworm.load(_case(tmp_path, f'{GAUSSIAN}\nx_direction = "30 deg"'))
    scene = case.scene()
    body = scene.bodies[0]
    assert body.roughness == pytest.approx(0.1e-6)
    assert body.topography.x_direction == pytest.approx(np.radians(30))
    assert body.roughness_slope == pytest.approx(0.0336, rel=0.05)
    assert scene.composite_roughness == pytest.approx(np.hypot(0.1e-6, 0.05e-6))
    assert isinstance(scene.rough_pair, TopographyPair)


def test_a_file_is_read_beside_its_case_and_decides_what_is_solved(tmp_path, flank):
    path = _case(tmp_path, ARRAY)
    case = pyworm.load(path)
    assert case.scene().bodies[0].roughness == pytest.approx(0.1e-6, rel=0.02)
    before = case.physics
    np.save(tmp_path / "flank.npy", 2 * flank)
    changed_case = pyworm.load(path)
    assert changed_case.scene().bodies[0].roughness == pytest.approx(0.2e-6, rel=0.02)
    assert changed_case.physics != before
    assert case.resolved == changed_case.resolved


def test_the_case_of_a_result_has_its_surface_but_no_file(tmp_path, flank):
    case = pyworm.load(_case(tmp_path, ARRAY))
    again = case_again(case.resolved)
    assert again.tables.bodies.body_1.surface.file == "flank.npy"
    assert again.scene().bodies[0].topography is None


@pytest.mark.parametrize(
    "keys, sentence",
    [
        ("", "give one of file, across, generated"),
        (f'{GAUSSIAN}\nfile = "flank.npy"', "give one of file, across, generated"),
        (f'{GAUSSIAN}\nspacing = "1 um"', "spacing has no effect without file"),
        (GAUSSIAN.replace("gaussian", "fractal"), "generated.spectrum"),
        (GAUSSIAN.replace(", seed = 1", ""), "bodies.body_1.surface.generated.seed is missing"),
        (
            GAUSSIAN.replace("0.1 um", "0.1 m"),
            'roughness = "0.1 m": must be a root mean square height',
        ),
        ('file = "none.npy"', 'bodies.body_1.surface.file = "none.npy": no such file'),
        (
            'file = "flank.npy"',
            'give height_unit = "um" and spacing = "0.5 um" with it',
        ),
        (
            f'{ARRAY}\nnesting_index = "2.5 mm"',
            "nesting_index of 2500 um is longer than what was measured",
        ),
        (f'{ARRAY}\noutliers = "drop"', 'outliers = "drop": must be "refuse", "fill" or "keep"'),
        (f"{ARRAY}\nfilter = 3", "bodies.body_1.surface.filter: no such key"),
    ],
)
def test_wrong_surfaces_are_refused_in_one_sentence(tmp_path, flank, keys, sentence):
    with pytest.raises(CaseError) as refused:
        pyworm.load(_case(tmp_path, keys))
    assert sentence in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "name, content, sentence",
    [
        ("empty.npy", b"", "is empty"),
        ("spikes.npy", "spikes", "has 3 outliers"),
        ("holes.npy", "holes", "50 % of its points are missing"),
    ],
)
def test_bad_heights_are_refused_in_one_sentence(tmp_path, flank, name, content, sentence):
    if content == b"":
        (tmp_path / name).write_bytes(content)
    else:
        heights = flank.copy()
        if content == "spikes":
            heights[3, 4:7] = 50.0
        else:
            heights[:32] = np.nan
        np.save(tmp_path / name, heights)
    keys = ARRAY.replace("flank.npy", name)
    with pytest.raises(CaseError, match=rf'bodies\.body_1\.surface\.file = "{name}": {sentence}'):
        pyworm.load(_case(tmp_path, keys))


def test_figures_beside_heights_are_refused(tmp_path):
    path = _case(tmp_path, GAUSSIAN)
    text = path.read_text()
    path.write_text(changed(text, ("[bodies.body_1]\n", '[bodies.body_1]\nroughness = "1 um"\n')))
    with pytest.raises(CaseError, match="roughness has no effect with surface"):
        pyworm.load(path)
