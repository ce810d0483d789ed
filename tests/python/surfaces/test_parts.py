"""Parts of measured areas: crop, mask, channel, archives, more missing points, worn summits."""

import bz2
import gzip
import lzma
import zipfile

import numpy as np
import pytest

from pyworm.case.case import checked
from pyworm.case.surface import SurfaceTable
from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.reading import read_heights

ROUGH = gaussian(0.4e-6, 8e-6, seed=3).height[:80, :60].copy()
STEP = 1e-6
GIVEN = {"spacing": "1 um", "height_unit": "um"}


@pytest.fixture
def waves(tmp_path):
    """Waves of a file of the heights with further keys."""
    np.save(tmp_path / "flank.npy", ROUGH.T * 1e6)

    def of(**keys):
        table = checked(SurfaceTable, GIVEN | {"file": "flank.npy"} | keys)
        table.lie_in(tmp_path)
        return table.waves()

    return of


def test_a_crop_is_the_file_of_its_part(waves, tmp_path):
    crop = ["10 um", "50 um", "5 um", "45 um"]
    found = waves(crop=crop).roughness
    np.save(tmp_path / "part.npy", ROUGH[10:50, 5:45].T * 1e6)
    assert found == waves(file="part.npy").roughness
    assert found.height.shape == (40, 40)


@pytest.mark.parametrize(
    ("crop", "sentence"),
    [
        (["50 um", "10 um", "5 um", "45 um"], "give the lesser first"),
        (["10 um", "50 um", "5 um", "90 um"], "ends at 9e-05 m along y, beyond the area"),
        (["10 um", "20 um", "5 um", "45 um"], "leaves 10 points along x"),
    ],
)
def test_a_crop_that_is_none_is_refused(waves, crop, sentence):
    with pytest.raises(ValueError, match=sentence):
        waves(crop=crop)


def test_masked_points_are_missing(waves, tmp_path):
    mask = np.ones(ROUGH.shape)
    mask[20:25, 30:40] = 0
    np.savetxt(tmp_path / "mask.txt", mask.T)
    found = waves(mask="mask.txt")
    assert found.filled == pytest.approx(50 / ROUGH.size)
    assert np.array_equal(found.roughness.known, mask > 0)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("other.npy", "mask other.npy has 30 x 20 numbers, the surface 80 x 60"),
        ("none.npy", "no such file"),
    ],
)
def test_a_mask_of_another_size_is_refused(waves, tmp_path, name, sentence):
    np.save(tmp_path / "other.npy", np.ones((20, 30)))
    with pytest.raises(ValueError, match=sentence):
        waves(mask=name)


def test_more_points_are_filled_if_asked(waves, tmp_path):
    holed = ROUGH.copy()
    holed[20:60, 20:40] = np.nan
    np.save(tmp_path / "holed.npy", holed.T * 1e6)
    with pytest.raises(
        ValueError, match=r"17 % of its points are missing.*by crop, or fill = 0.22"
    ):
        waves(file="holed.npy")
    assert waves(file="holed.npy", fill=0.22).filled == pytest.approx(800 / ROUGH.size)


@pytest.mark.parametrize("packed", [gzip, bz2, lzma])
def test_compressed_files_are_read(tmp_path, packed):
    path = tmp_path / f"flank.txt.{packed.__name__[:2]}"
    text = "\n".join(" ".join(f"{z:.6f}" for z in row) for row in ROUGH.T * 1e6)
    path.write_bytes(packed.compress(text.encode()))
    path = path.rename(tmp_path / "flank.txt.gz") if packed is gzip else path
    endings = {gzip: ".gz", bz2: ".bz2", lzma: ".xz"}
    path = path.rename(tmp_path / f"flank.txt{endings[packed]}")
    heights, _ = read_heights(path, STEP, "um")
    assert heights == pytest.approx(ROUGH, abs=1e-12)
    path.write_bytes(path.read_bytes()[:-200])
    with pytest.raises(ValueError, match="cannot be unpacked"):
        read_heights(path, STEP, "um")


def test_a_file_that_unpacks_beyond_bounds_is_refused(tmp_path, monkeypatch):
    from pyworm.surfaces import compressed_file

    monkeypatch.setattr(compressed_file, "MOST_BYTES", 1000)
    path = tmp_path / "flank.txt.gz"
    path.write_bytes(gzip.compress(b"0 1\n" * 1000))
    with pytest.raises(ValueError, match="when unpacked"):
        read_heights(path, STEP, "um")


def test_an_archive_is_to_be_unpacked(tmp_path):
    pytest.importorskip("SurfaceTopography")
    path = tmp_path / "flank.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("flank.txt", "1 2 3")
    with pytest.raises(ValueError, match="is an archive; unpack it"):
        read_heights(path, STEP, "um")


def test_channels_are_chosen_by_name_or_number(tmp_path):
    library = pytest.importorskip("SurfaceTopography")
    path = tmp_path / "flank.nc"
    sides = tuple(n * STEP * 1e6 for n in ROUGH.shape)
    library.Topography(ROUGH * 1e6, sides, unit="um").to_netcdf(str(path))
    with library.open_topography(str(path)) as reader:
        name = reader.channels[0].name
    for channel in (1, name):
        assert read_heights(path, channel=channel)[0] == pytest.approx(ROUGH)
    for channel in (2, "Phase"):
        with pytest.raises(
            ValueError, match=f"has no channel {channel!r}; its channels are 1 {name}"
        ):
            read_heights(path, channel=channel)
    np.save(tmp_path / "flank.npy", ROUGH)
    with pytest.raises(ValueError, match="has one channel; omit channel"):
        read_heights(tmp_path / "flank.npy", STEP, "um", 1)


def test_summits_wear_off_to_a_ratio_of_the_roughness(waves):
    new, worn = waves().roughness, waves(run_in=0.6).roughness
    assert worn.rms == pytest.approx(0.6 * new.rms, rel=1e-6)
    same = worn.height < worn.height.max() - 1e-15
    assert np.ptp((worn.height - new.height)[same]) < 1e-15
    assert all(
        part.rms == pytest.approx(0.6 * whole.rms, rel=1e-6)
        for part, whole in zip(worn.samples, new.samples, strict=True)
    )


def test_quarters_are_the_whole():
    known = np.random.default_rng(1).random(ROUGH.shape) > 0.1
    surface = Topography(ROUGH - ROUGH.mean(), (STEP, STEP), measured=known)
    quarters = surface.quarters
    assert sum(quarter.height.size for quarter in quarters) == ROUGH.size
    assert sum(quarter.known.sum() for quarter in quarters) == known.sum()
    assert all(abs(quarter.height.mean()) < 1e-20 for quarter in quarters)


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ({"across": ["a.txt"]}, "give one of along, aspect"),
        ({"across": ["a.txt"], "along": ["b.txt"], "aspect": 2.0}, "give one of along, aspect"),
        ({"across": [], "aspect": 2.0}, "across names no file"),
        ({"file": "a.npy", "aspect": 2.0}, "aspect has no effect without across"),
        (
            {"across": ["a.txt"], "aspect": 2.0, "crop": ["0 um"] * 4},
            "crop has no effect without file",
        ),
        ({"across": ["none.txt"], "aspect": 2.0}, "surface.across: none.txt no such file"),
    ],
)
def test_keys_that_do_not_go_together_are_refused(tmp_path, keys, sentence):
    with pytest.raises(ValueError, match=sentence):
        table = checked(SurfaceTable, keys)
        table.lie_in(tmp_path)
        table.waves()


def test_a_surface_of_profiles_is_one_of_a_body(tmp_path):
    line = gaussian(0.4e-6, 8e-6, seed=3)
    for name, heights in (("a.txt", line.height[5]), ("b.txt", line.height[:, 7])):
        np.savetxt(tmp_path / name, heights * 1e6)
    keys = {"across": ["a.txt"], "along": ["b.txt"], "seed": 3}
    table = checked(SurfaceTable, keys | {"spacing": f"{line.spacing[0]} m", "height_unit": "um"})
    table.lie_in(tmp_path)
    found = table.topography()
    assert found.periodic
    assert len(found.samples) == 4
    assert table.long_waves() is None
    assert set(table.contents) == {"across", "along"}
