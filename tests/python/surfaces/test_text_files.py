"""Text files of heights: units and distances by headers, lists of points, refusals with a reason."""

import re

import numpy as np
import pytest

from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.reading import read_area, read_heights

HEIGHTS = gaussian(0.1e-6, 2e-6, seed=5).height[:20, :18]
STEP = 0.5e-6
GIVEN = {"spacing": STEP, "height_unit": "um"}


def rows(numbers, separator=" ", form="%.8e"):
    return "\n".join(separator.join(form % one for one in row) for row in numbers.T) + "\n"


def written(tmp_path, text, name="flank.txt", encoding="utf-8"):
    path = tmp_path / name
    path.write_bytes(text.encode(encoding))
    return path


SIDES = "10.00", "9.00"

HEADERS = {
    "Gwyddion": (
        "# Channel: Height\n# Width: 10.00 µm\n# Height: 9.00 µm\n# Value units: m\n",
        1.0,
    ),
    "Gwyddion in German": (
        "# Kanal: Höhe\n# Breite: 10.00 µm\n# Höhe: 9000 nm\n# Einheiten: nm\n",
        1e9,
    ),
    "Gwyddion in Russian": (
        "# Канал: 1\n# Ширина: 10 µm\n# Высота: 9 µm\n# Единицы измерения: m\n",
        1,
    ),
    "Nova": (
        "NX = 20\nNY = 18\nScale X = 0.5\nScale Y = 0.5\nUnit X = um\nUnit Data = nm\nStart of Data :\n",
        1e9,
    ),
    "SPIP's keys": ("# x-length = 10\n# y-length = 9\n# x-unit = um\n# z-unit = um\n", 1e6),
    "Zygo": ("h=18 w=20\npixel size=5e-007 m\nheight conversion factor (-> m)=2e-008\n", 0.5e8),
    "one unit for all": ("% dx = 0.5\n% units = um\n", 1e6),
    "a comment on the values": ("# heights in nm\n# pixel size: 0.5 um\n", 1e9),
    "a comment in brackets": ("# z [nm]\n# spacing: 0.5 um\n", 1e9),
}


@pytest.mark.parametrize("program", HEADERS)
def test_a_header_gives_unit_and_distance(tmp_path, program):
    header, scale = HEADERS[program]
    heights, spacing = read_heights(written(tmp_path, header + rows(HEIGHTS * scale)))
    assert heights == pytest.approx(HEIGHTS, rel=1e-6, abs=1e-15)
    assert spacing == pytest.approx((STEP, STEP))


@pytest.mark.parametrize("key", ["height_unit", "spacing"])
def test_what_the_header_says_is_not_given_twice(tmp_path, key):
    path = written(tmp_path, HEADERS["Gwyddion"][0] + rows(HEIGHTS))
    with pytest.raises(ValueError, match=f"in its header; omit {key}"):
        read_heights(path, **{key: GIVEN[key]})


def test_values_that_are_no_heights_are_refused(tmp_path):
    header = HEADERS["Gwyddion"][0].replace("Value units: m", "Value units: V")
    with pytest.raises(ValueError, match='has values in "V" by its header; heights are needed'):
        read_heights(written(tmp_path, header + rows(HEIGHTS)))


@pytest.mark.parametrize(("factor", "unit"), [(1.0, "m"), (1e3, "mm"), (1e6, "um"), (1e9, "nm")])
def test_the_hint_is_the_unit_that_the_numbers_have(tmp_path, factor, unit):
    numbers = 5 * HEIGHTS * factor  # Rq of half a micrometre
    with pytest.raises(ValueError, match=f'give height_unit = "{unit}" and spacing = "0.5 um"'):
        read_heights(written(tmp_path, rows(numbers)))


LAYOUTS = {
    "blanks": (rows(HEIGHTS * 1e6), "utf-8"),
    "tabs": (rows(HEIGHTS * 1e6, "\t"), "utf-8"),
    "commas": (rows(HEIGHTS * 1e6, ", "), "utf-8"),
    "semicolons, one at the end": (rows(HEIGHTS * 1e6, ";").replace("\n", ";\n"), "utf-8"),
    "decimal commas": (rows(HEIGHTS * 1e6, ";").replace(".", ","), "utf-8"),
    "decimal commas and tabs": (rows(HEIGHTS * 1e6, "\t").replace(".", ","), "utf-8"),
    "two bytes a letter": (rows(HEIGHTS * 1e6), "utf-16"),
    "a mark of the encoding": (rows(HEIGHTS * 1e6), "utf-8-sig"),
    "Latin letters": ("Fläche in µm\n" + rows(HEIGHTS * 1e6), "latin-1"),
    "a count before": ("20 18\n" + rows(HEIGHTS * 1e6), "utf-8"),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_layouts_of_rows_are_read(tmp_path, layout):
    text, encoding = LAYOUTS[layout]
    heights, _ = read_heights(written(tmp_path, text, encoding=encoding), **GIVEN)
    assert heights == pytest.approx(HEIGHTS, rel=1e-6, abs=1e-15)


@pytest.mark.parametrize("word", ["", "bad", "NaN", "---", "-1.#IND"])
def test_words_for_missing_points_are_known(tmp_path, word):
    lines = [line.split(" ") for line in rows(HEIGHTS * 1e6).splitlines()]
    lines[3][4] = word
    text = "\n".join(";".join(line) for line in lines)
    heights, _ = read_heights(written(tmp_path, text, "flank.csv"), **GIVEN)
    assert np.argwhere(np.isnan(heights)).tolist() == [[4, 3]]


def points(metres=1e-6, order=slice(None)):
    x, y = np.meshgrid(np.arange(20) * STEP, np.arange(18) * 2 * STEP, indexing="ij")
    return np.stack([x.ravel() / metres, y.ravel() / metres, HEIGHTS.ravel() * 1e6], axis=1)[order]


def as_text(listed):
    return "\n".join(" ".join(f"{one:.8g}" for one in point) for point in listed)


@pytest.mark.parametrize("name", ["grid.xyz", "grid.txt", "grid.csv"])
def test_a_list_of_points_on_a_grid_is_read(tmp_path, name):
    shuffled = np.random.default_rng(1).permutation(20 * 18)
    path = written(tmp_path, as_text(points(1e-3, shuffled)), name)
    heights, spacing = read_heights(path, **GIVEN)
    assert heights == pytest.approx(HEIGHTS, rel=1e-6, abs=1e-15)
    assert spacing == pytest.approx((STEP, 2 * STEP), rel=1e-3)


@pytest.mark.parametrize(
    "header",
    ["x [mm]; y [mm]; z [um]", "X/mm\tY/mm\tZ/um", "x in mm, y in mm, z in µm", "mm mm um"],
)
def test_titles_of_columns_give_their_units(tmp_path, header):
    heights, spacing = read_heights(
        written(tmp_path, header + "\n" + as_text(points(1e-3)), "p.csv")
    )
    assert heights == pytest.approx(HEIGHTS, rel=1e-6, abs=1e-15)
    assert spacing == pytest.approx((STEP, 2 * STEP), rel=1e-3)


def test_labels_give_the_units_of_points(tmp_path):
    header = "# Channel: Height\n# Lateral units: µm\n# Value units: m\n"
    listed = points(1e-6) * [1, 1, 1e-6]
    heights, spacing = read_heights(written(tmp_path, header + as_text(listed), "p.xyz"))
    assert heights == pytest.approx(HEIGHTS, rel=1e-6, abs=1e-15)
    assert spacing == pytest.approx((STEP, 2 * STEP), rel=1e-3)


def test_points_that_are_not_listed_are_missing(tmp_path):
    kept = np.delete(np.arange(20 * 18), [0, 25, 26])
    heights, _ = read_heights(written(tmp_path, as_text(points(order=kept))), **GIVEN)
    assert np.flatnonzero(np.isnan(heights)).tolist() == [0, 25, 26]


def scattered():
    listed = points()
    listed[:, :2] += np.random.default_rng(2).uniform(-0.2, 0.2, (len(listed), 2))
    return as_text(listed)


REFUSED = {
    "scattered points": (scattered(), "is a list of points on no regular grid: along x"),
    "a place twice": (as_text(points()) + "\n0 0 0.1", "two lie at one place"),
    "one row of points": (as_text(points() * [1, 0, 1]), "all have one y; an area is needed"),
    "a profile": ("\n".join(f"{x} {x * x}" for x in range(99)), "is a profile along a line"),
    "a column": ("\n".join(map(str, range(99))), "is a profile along a line"),
    "a row cut short": (rows(HEIGHTS)[:-40], "line 18 has 18 entries, those before 20"),
    "a longer row before": ("1 " + rows(HEIGHTS), "line 1 has 21 entries, the next 20"),
    "words": ("no numbers at all\n", "no line has numbers alone"),
    "a word among numbers": (
        "x7 " + rows(HEIGHTS).split(" ", 1)[1],
        'line 1 has "x7", which is none',
    ),
    "a word in the middle": (
        rows(HEIGHTS).replace(rows(HEIGHTS).split()[50], "abc", 1),
        'line 3 has "abc", which is none',
    ),
    "two channels": (
        (HEADERS["Gwyddion"][0] + rows(HEIGHTS)) * 2,
        "has another header in line 23; give a file of one channel",
    ),
    "bytes": ("\0\1\2" * 99, "it is no text"),
    "nothing but missing points": ("nan nan nan nan\n" * 20, "no line has numbers alone"),
}


@pytest.mark.parametrize("content", REFUSED)
def test_other_texts_are_refused_in_a_sentence(tmp_path, content):
    text, sentence = REFUSED[content]
    options = {} if content == "two channels" else GIVEN
    with pytest.raises(ValueError, match=r"^[^\n]*$") as refused:
        read_area(written(tmp_path, text), **options)
    assert re.search(sentence, str(refused.value))
