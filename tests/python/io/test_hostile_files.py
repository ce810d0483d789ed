"""Hostile files: one sentence within a second; and odd files that people do write, which are read."""

import io
import os
import time
import zipfile

import numpy as np
import pytest
from folders import CASES

from pyworm.case.case import load
from pyworm.io.input_error import CaseError
from pyworm.io.toml import MAX_FILE_BYTES, read_toml
from pyworm.scene.gap_file import read_gap

CASE = (CASES / "point_m20_l10.toml").read_text()
LOAD = 'load = "3.6774 N"'

SOON = 1.0
"""Time within which a file is refused [s of the processor]; a hang is minutes."""


@pytest.fixture
def refusal(tmp_path):
    """The one sentence with which a file's content is refused, and soon."""

    def of(content):
        path = tmp_path / "case.toml"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        load(
            CASES / "point_m20_l10.toml"
        )  # what is imported at the first case is not the file's doing
        begun = time.process_time()
        with pytest.raises(CaseError) as caught:
            load(path)
        assert time.process_time() - begun < SOON
        sentence = str(caught.value)
        assert "\n" not in sentence and len(sentence) < 1000
        return sentence

    return of


def changed(new):
    assert LOAD in CASE
    return CASE.replace(LOAD, new)


def test_a_byte_order_mark_is_no_part_of_a_case(tmp_path):
    path = tmp_path / "case.toml"
    path.write_bytes(b"\xef\xbb\xbf" + CASE.encode())
    assert read_toml(path) == read_toml(CASES / "point_m20_l10.toml")


@pytest.mark.parametrize(
    ("content", "wanted"),
    [
        (("# Stößel\n" + CASE).encode("latin-1"), "not in UTF-8 (line 1 has the byte 0xf6"),
        (CASE.encode("utf-16"), "not in UTF-8 (line 1 has the byte 0xff"),
        (f"x = {'[' * 900}{']' * 900}\n{CASE}", "too many brackets within each other"),
        (f"x = {'{a=' * 900}1{'}' * 900}\n{CASE}", "too many brackets within each other"),
        (f"a{'.a' * 100_000} = 1\n{CASE}", "too many tables within each other"),
        (changed(f"load = {'9' * 5000}"), "a number of too many digits"),
        (changed(f"load = {'9' * 4000}"), "contact.load = 9999"),
        (changed(f"load = {'9' * 400}"), "whole numbers lie between -9223372036854775807 and"),
        (changed(f'load = "{"9" * 5000} N"'), "must be a force with its unit"),
        (changed('load = "1 kN/m**(9**9**9)"'), '"1 kN/m**(9**9**9)": must be a force with its un'),
        (changed(f'load = "1{" " * 100_000}x"'), "must be a force with its unit"),
        (f"{'k' * 100_000} = 1\n{CASE}", "no such key"),
        (
            f'title = "{"a" * 50_000_000}"\n',
            f"has 50.0 MB, a case file has {MAX_FILE_BYTES / 1e6:.1f} MB",
        ),
    ],
    ids=lambda of: None if len(of) > 100 else of,
)
def test_a_hostile_file_is_refused_at_once(refusal, content, wanted):
    assert wanted in refusal(content)


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null"])
def test_a_device_is_no_case(path):
    with pytest.raises(CaseError, match=f"{path}: is no file but a device"):
        load(path)


def test_a_pipe_and_a_directory_are_no_cases(tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    with pytest.raises(CaseError, match="is no file but a pipe"):
        load(tmp_path / "pipe.toml")  # which would wait for ever for whoever writes into it
    with pytest.raises(CaseError, match="is no file but a directory"):
        load(tmp_path)


# ------------------------------------------------------------------------------------------ gaps

BOWL = (np.arange(-20, 21) * 1e-5) ** 2 / 0.02 + (np.arange(-20, 21)[:, None] * 1e-5) ** 2 / 0.02
GOOD = {"gap": BOWL, "dx": np.array(1e-5), "dy": np.array(1e-5)}


def array_file(shape, dtype="<f8", data=b""):
    """The content of an npy file whose header says what it wants to."""
    file = io.BytesIO()
    header = {"descr": dtype, "fortran_order": False, "shape": shape}
    np.lib.format.write_array_header_1_0(file, header)
    return file.getvalue() + data


def write(path, members):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            if not isinstance(content, bytes):
                buffer = io.BytesIO()
                np.save(buffer, content)
                content = buffer.getvalue()
            archive.writestr(f"{name}.npy", content)


def test_other_arrays_are_not_read(tmp_path):
    write(tmp_path / "gap.npz", {**GOOD, "notes": b"no array at all", "raw": array_file((10**7,))})
    assert read_gap(tmp_path / "gap.npz").gap.shape == BOWL.shape


@pytest.mark.parametrize(
    ("name", "content", "wanted"),
    [
        ("gap", array_file((200_000, 200_000)), "an array of 40000000000 numbers"),
        ("gap", array_file((10**9, 10**9), data=b"\0" * 80), "50000000 are read at most"),
        ("gap", array_file((41, 41), dtype="|V100000"), "numbers"),
        ("gap", array_file((41, 41), data=b"\0" * 8), "gap has 8 bytes of numbers for 1681"),
        ("gap", array_file((41, 41), dtype="|O", data=b"\0" * 13448), "numbers"),
        ("dx", np.full(1_000_000, 1e-5), "dx must be one length"),
        ("dy", array_file((3,), dtype="<U9", data=b"\0" * 108), "dy must be one length"),
    ],
    ids=["large", "larger", "bytes", "short", "objects", "spacings", "words"],
)
def test_a_gap_file_is_bounded_before_it_is_read(tmp_path, monkeypatch, name, content, wanted):
    write(tmp_path / "gap.npz", GOOD | {name: content})

    whole = np.lib.format.read_array

    def read(file, **how):
        assert file.name != f"{name}.npy", "the array was read before it was bounded"
        return whole(file, **how)

    monkeypatch.setattr(np.lib.format, "read_array", read)
    with pytest.raises(ValueError, match=wanted):
        read_gap(tmp_path / "gap.npz")


def test_other_variables_of_a_netcdf_file_are_not_read(tmp_path):
    import netCDF4

    with netCDF4.Dataset(tmp_path / "gap.nc", "w") as file:
        for name in "yx":
            file.createDimension(name, 41)
            file.createVariable(name, np.float64, name)[:] = np.arange(-20, 21) * 1e-5
        file.createVariable("gap", np.float64, ("y", "x"))[:] = BOWL
        file.createDimension("record", 200_000)
        # chunks that were never written take no room in the file, and 320 GB when read
        file.createVariable("raw", np.float64, ("record", "record"), chunksizes=(1000, 1000))
    assert read_gap(tmp_path / "gap.nc").gap.shape == BOWL.shape
