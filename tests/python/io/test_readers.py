"""A bounded part of the attack on readers of files (`tests/hard/fuzz_readers.py`), and what it has found."""

import fuzz_readers
import numpy as np
import pytest
from fuzz_readers import Reader, met, outcome, readers

from pyworm.io.kept_arrays import DamagedError, keep, kept
from pyworm.surfaces.reading import read_heights

pytest.importorskip("SurfaceTopography")
READERS = {reader.name: reader for reader in readers()}


@pytest.mark.parametrize("name", READERS)
def test_a_sound_file_is_read(tmp_path, name):
    assert outcome(READERS[name], READERS[name].content, tmp_path) == ("read", [])


@pytest.mark.parametrize("name", READERS)
def test_a_mutated_file_is_read_or_refused_in_one_sentence(tmp_path, name):
    outcomes, flaws = met(READERS[name], range(25), tmp_path)
    assert flaws == []
    assert outcomes["refused"] > 0


def test_the_judge_of_readers_sees_what_is_wrong(tmp_path, monkeypatch):
    def came_to(read):
        return outcome(Reader("any", "txt", b"1", read), b"1", tmp_path)

    def refuses(words):
        def read(path):
            raise ValueError(words)

        return read

    assert came_to(refuses("no such unit")) == ("refused", [])
    assert came_to(refuses("two\nlines"))[1] == ["not one sentence: two\nlines"]
    assert came_to(refuses(""))[1] == ["not one sentence: "]
    assert came_to(lambda path: 1 // 0)[1] == [
        "ZeroDivisionError: integer division or modulo by zero"
    ]
    assert came_to(lambda path: np.float64(1e308) * 10)[1][0].startswith("RuntimeWarning: overflow")
    monkeypatch.setattr(fuzz_readers, "SOON", -1.0)
    assert came_to(lambda path: None)[1][0].startswith("took ")


# ------------------------------------------------------------------------------ found by the attack


@pytest.mark.parametrize("mark", [1e308, -1e308, np.inf, -np.inf, 32767.0])
def test_marks_of_missing_points_are_no_heights(tmp_path, mark):
    heights = np.random.default_rng(1).normal(size=(32, 32))
    heights[3, 5] = mark
    np.save(tmp_path / "flank.npy", heights)
    with pytest.raises(
        ValueError, match="which no surface has; points that are missing must be NaN"
    ):
        read_heights(tmp_path / "flank.npy", 0.5e-6, "m")


def test_another_kind_of_nan_is_a_missing_point(tmp_path):
    heights = np.random.default_rng(1).normal(size=(32, 32))
    heights.view(np.uint64)[3, 5] = 0x7FF0000000000001  # a signalling NaN
    np.save(tmp_path / "flank.npy", heights)
    with np.errstate(invalid="raise"):
        read, _ = read_heights(tmp_path / "flank.npy", 0.5e-6, "um")
    assert np.isnan(read).sum() == 1


# ------------------------------------------------------------------------------------ kept arrays


def test_arrays_are_kept_to_the_last_bit(tmp_path):
    values = np.random.default_rng(1).normal(size=(7, 3))
    keep(tmp_path / "a.npz", values=values, name="x", number=0.1)
    held = kept(tmp_path / "a.npz", dict)
    assert (held["values"] == values).all()
    assert str(held["name"]) == "x" and float(held["number"]) == 0.1


def test_a_file_that_is_not_there_is_not_damaged(tmp_path):
    with pytest.raises(FileNotFoundError):
        kept(tmp_path / "a.npz", dict)


def test_what_cannot_be_made_of_a_file_is_a_damage_of_it(tmp_path):
    keep(tmp_path / "a.npz", values=np.ones(3))
    with pytest.raises(DamagedError, match="is damaged"):
        kept(tmp_path / "a.npz", lambda held: held["others"])
