"""Files of measured surfaces: read back as written, or refused in one sentence."""

import struct
import sys
import zipfile

import numpy as np
import pytest

from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.preparing import separate_waves
from pyworm.surfaces.reading import read_area, read_heights

SURFACE = gaussian(0.4e-6, 10e-6, seed=1)
HEIGHTS = SURFACE.height[:96, :64]
SPACING = SURFACE.spacing[0]


@pytest.mark.parametrize("ending", ["npy", "csv", "txt"])
def test_arrays_are_read_as_written(tmp_path, ending):
    path = tmp_path / f"flank.{ending}"
    if ending == "npy":
        np.save(path, HEIGHTS.T * 1e6)
    else:
        np.savetxt(path, HEIGHTS.T * 1e6, delimiter=";" if ending == "csv" else " ")
    heights, spacing = read_heights(path, 0.5e-6, "um")
    assert heights == pytest.approx(HEIGHTS, rel=1e-12, abs=1e-18)
    assert spacing == (0.5e-6, 0.5e-6)


@pytest.mark.parametrize("ending", ["nc", "x3p", "sur"])
def test_files_of_instruments_are_read_as_written(tmp_path, ending):
    """Written by SurfaceTopography itself, or, where it writes no such format, byte by byte."""
    library = pytest.importorskip("SurfaceTopography")
    path = tmp_path / f"flank.{ending}"
    sides = tuple(n * SPACING * 1e6 for n in HEIGHTS.shape)
    if ending == "nc":
        topography = library.Topography(HEIGHTS * 1e6, sides, unit="um")
        topography.to_netcdf(str(path))
    else:
        {"x3p": _write_x3p, "sur": _write_sur}[ending](path)
    heights, spacing = read_heights(path)
    assert heights.shape == HEIGHTS.shape
    assert spacing == pytest.approx((SPACING, SPACING), rel=1e-5)
    fine = 1e-9 if ending != "sur" else 1e-4  # heights as whole numbers of their step
    off = heights - heights.mean() - (HEIGHTS - HEIGHTS.mean())
    assert np.abs(off).max() < fine * np.abs(HEIGHTS).max()


def _write_x3p(path):
    """ISO 25178-72: a zip archive of a description and the heights in metres, x fastest."""
    n, m = HEIGHTS.shape
    axes = "".join(
        f"<C{axis}><AxisType>{kind}</AxisType><DataType>D</DataType>{step}<Offset>0</Offset></C{axis}>"
        for axis, kind, step in (
            ("X", "I", f"<Increment>{SPACING!r}</Increment>"),
            ("Y", "I", f"<Increment>{SPACING!r}</Increment>"),
            ("Z", "A", "<Increment>1</Increment>"),
        )
    )
    description = (
        '<?xml version="1.0" encoding="UTF-8"?>'
        '<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">'
        f"<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>"
        f"{axes}</Axes></Record1>"
        "<Record2><Date>2026-01-01T00:00:00</Date><Instrument><Manufacturer>none</Manufacturer>"
        "<Model>none</Model><Serial>0</Serial><Version>0</Version></Instrument></Record2>"
        f"<Record3><MatrixDimension><SizeX>{n}</SizeX><SizeY>{m}</SizeY><SizeZ>1</SizeZ></MatrixDimension>"
        "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3>"
        "</p:ISO5436_2>"
    )
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("main.xml", description)
        archive.writestr(
            "bindata/data.bin", np.ascontiguousarray(HEIGHTS.T).astype("<f8").tobytes()
        )


def _write_sur(path):
    """Digital Surf's format: a header of 512 bytes and heights as whole numbers of a step, x fastest."""
    n, m = HEIGHTS.shape
    step = float(np.float32(np.ptp(HEIGHTS) / 2**24 * 1e6))
    points = np.round((HEIGHTS.T - HEIGHTS.min()) * 1e6 / step).astype("<i4")
    header = struct.pack(
        "<12s4H30s30s5H2IH2i2iI3f48s",
        *(b"DIGITAL SURF", 0, 1, 2, 2, b"", b"", 0, 0, 0, 0, 0, 0, 0, 32),
        *(0, int(points.max()), n, m, n * m, SPACING * 1e6, SPACING * 1e6, step, b""),
    )
    header += b"um".ljust(16) * 6
    header += struct.pack(
        "<3f3H3I7Hf2I3H", 1, 1, 1, *(0,) * 6, 0, 0, 0, 1, 1, 2026, 0, 0, *(0,) * 5
    )
    path.write_bytes(header.ljust(512, b"\0") + points.tobytes())


@pytest.mark.parametrize(
    "content, options, sentence",
    [
        (b"", {}, "is empty"),
        (b"nonsense", {"spacing": 1e-6, "height_unit": "um"}, "cannot be read as an npy file"),
        (HEIGHTS * 1e6, {}, 'has numbers without a unit; give height_unit = "um"'),
        (HEIGHTS, {"height_unit": "um"}, 'give spacing = "0.5 um"'),
        (
            HEIGHTS,
            {"height_unit": "kg", "spacing": 1e-6},
            'height_unit = "kg" is no unit of length',
        ),
        (HEIGHTS[0], {"height_unit": "um", "spacing": 1e-6}, "is a profile along a line"),
        (HEIGHTS[:3], {"height_unit": "um", "spacing": 1e-6}, "has 3 x 64 points, at least 16"),
        (
            np.array([["a"]]),
            {"height_unit": "um", "spacing": 1e-6},
            "cannot be read as an npy file",
        ),
    ],
)
def test_bad_files_are_refused_in_a_sentence(tmp_path, content, options, sentence):
    path = tmp_path / "flank.npy"
    if isinstance(content, bytes):
        path.write_bytes(content)
    else:
        np.save(path, content.T)
    with pytest.raises(ValueError, match=r"^[^\n]*$") as refused:
        read_area(path, **options)
    assert sentence in str(refused.value)


def test_a_file_larger_than_memory_is_refused_before_it_is_read(tmp_path):
    path = tmp_path / "flank.npy"
    with path.open("wb") as file:  # a header, of an array of 8 GB that takes no room on the disk
        header = {"descr": "<f8", "fortran_order": False, "shape": (32_000, 32_000)}
        np.lib.format.write_array_header_1_0(file, header)
        file.truncate(file.tell() + 8 * 32_000**2)
    with pytest.raises(ValueError, match="25000000 are read at most"):
        read_heights(path, 1e-6, "um")


def test_a_format_that_nobody_knows_is_refused(tmp_path):
    pytest.importorskip("SurfaceTopography")
    path = tmp_path / "flank.sur"
    path.write_bytes(b"nonsense" * 100)
    with pytest.raises(ValueError, match="is no file of an instrument"):
        read_heights(path)


def test_without_the_library_the_extra_is_named(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    path = tmp_path / "flank.sur"
    path.write_bytes(b"anything")
    with pytest.raises(ValueError, match=r'pip install "pyworm\[surfaces\]"'):
        read_heights(path)


def test_missing_points_are_filled_as_long_as_they_are_few():
    rough = HEIGHTS * 1.0
    rough[20:24, 30:33] = np.nan
    rough[0, 0] = np.nan
    filled = separate_waves(rough, (SPACING, SPACING))
    whole = separate_waves(HEIGHTS, (SPACING, SPACING))
    assert filled.filled == pytest.approx(13 / rough.size)
    assert filled.roughness.height == pytest.approx(whole.roughness.height, abs=0.6e-6)
    rough[:, :20] = np.nan
    with pytest.raises(ValueError, match="31 % of its points are missing"):
        separate_waves(rough, (SPACING, SPACING))


def test_outliers_are_refused_filled_or_kept():
    rough = HEIGHTS.copy()
    rough[10:12, 10] = 30e-6
    with pytest.raises(ValueError, match=r"has 2 outliers, up to 30 um .* give outliers = "):
        separate_waves(rough, (SPACING, SPACING))
    filled = separate_waves(rough, (SPACING, SPACING), outliers="fill").roughness
    kept = separate_waves(rough, (SPACING, SPACING), outliers="keep").roughness
    assert filled.rms == pytest.approx(0.4e-6, rel=0.2)
    assert kept.height.max() == pytest.approx(30e-6, rel=0.05)


def test_form_is_removed_and_waves_are_separated():
    x, y = (np.linspace(-1, 1, n)[:, None] for n in (400, 80))
    form = 5e-6 * x + 20e-6 * x**2 + 3e-6 * (x * y.T)
    place = np.arange(400)[:, None]
    long, short = (1e-6 * np.sin(2 * np.pi * place / wave) + 0 * y.T for wave in (100, 10))
    waves = separate_waves(form + long + short, (1e-6, 1e-6), nesting_index=40e-6)
    inside = np.s_[60:-60, 10:-10]
    assert waves.roughness.height[inside] == pytest.approx(short[inside], abs=0.12e-6)
    total = waves.roughness.height + waves.long_waves.height
    assert total[inside] == pytest.approx((long + short)[inside], abs=0.3e-6)
    unfiltered = separate_waves(form + short, (1e-6, 1e-6))
    assert unfiltered.roughness.height == pytest.approx(short, abs=0.05e-6)
    with pytest.raises(
        ValueError, match="nesting_index of 500 um is longer than what was measured"
    ):
        separate_waves(short, (1e-6, 1e-6), nesting_index=500e-6)
    with pytest.raises(ValueError, match="nesting_index of 2 um is too short"):
        separate_waves(short, (1e-6, 1e-6), nesting_index=2e-6)
    with pytest.raises(ValueError, match="is flat"):
        separate_waves(0 * short, (1e-6, 1e-6))
