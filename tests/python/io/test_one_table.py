"""Quantities stand in one table: nothing else in the package writes their labels, units or scales."""

import ast
import re
from collections import Counter

import pytest
from folders import PACKAGE

from pyworm.io import quantities
from pyworm.io.quantities import KEY_UNITS, QUANTITIES, SCALES, attributes, listed, read_key

TABLE = PACKAGE / "io/quantities.py"

SHOWN = [of for of in QUANTITIES.values() if of.shown or of.places]
"""Quantities that screens, pages and pictures show."""

LABELS = {
    words
    for of in SHOWN
    for words in (of.words().lower(), of.worst().strip().lower())
    if " " in words
}

OTHER_WORDS = {
    "least film", "thinnest film", "smallest film", "minimum film", "central film",
    "film at the contact point",
    "largest pressure", "peak pressure", "h min", "p max", "h centr.", "load on asperities",
    "largest temperature", "hottest point", "wheel behind its ideal angle", "which is",
}  # fmt: skip
"""What quantities were called beside their labels."""

UNIT = re.compile(r"\s*(/|,|\[|\s)\s*\(?(µm|um|MPa|kN|N|W|°C|%|m/s|1/s)\)?\]?$")


INPUTS = "formulas", "drives", "case", "scene"
"""Rooms that refuse their arguments and keys by name; figures are shown above them."""

KEYS = {"central film", "minimum film"}
"""Keys of JSON objects that look like labels (`ratings/rating.py`)."""


def sources():
    """Files of the package that show figures, with their syntax trees."""
    for file in sorted(PACKAGE.rglob("*.py")):
        name = file.relative_to(PACKAGE)
        if file != TABLE and name.parts[0] not in INPUTS:
            yield name.as_posix(), ast.parse(file.read_text())


def texts(tree):
    """Texts of a tree that are no docstrings."""
    alone = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in alone:
            yield node


def plain(text):
    """A label without its unit, capitals and breaks of lines."""
    return UNIT.sub("", " ".join(text.split())).lower().strip()


def known_in(tree):
    """Names of shown quantities that an expression reads: attributes, and texts as keys."""
    names = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    names |= {node.value for node in texts(tree)}
    return [of for of in SHOWN if of.name in names or (of.key in names and of.key != of.name)]


def with_units(tree):
    """Rows and texts that give a quantity its unit."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Tuple | ast.List | ast.Call):
            parts = getattr(node, "elts", None) or getattr(node, "args", [])
            said = {part.value for part in parts if isinstance(part, ast.Constant)}
            own = [of for of in SHOWN if of.name in said or of.key in said]
            if any(of.shown and of.shown in said for of in own):
                yield node
        elif isinstance(node, ast.JoinedStr):
            for value, after in zip(node.values, node.values[1:], strict=False):
                if isinstance(value, ast.FormattedValue) and isinstance(after, ast.Constant):
                    unit = after.value.removeprefix(" ")
                    for of in known_in(value.value):
                        if of.shown and re.match(rf"{re.escape(of.shown)}(\W|$)", unit):
                            yield node


def test_nothing_else_writes_a_label():
    written = [
        f"{file}:{node.lineno}: {node.value!r}"
        for file, tree in sources()
        for node in texts(tree)
        if plain(node.value) in LABELS | OTHER_WORDS
        and not (file == "ratings/rating.py" and node.value in KEYS)
    ]
    assert not written, "\n".join(written)


def test_nothing_else_gives_a_quantity_its_unit():
    written = [
        f"{file}:{node.lineno}: {ast.unparse(node)[:80]}"
        for file, tree in sources()
        for node in with_units(tree)
    ]
    assert not written, "\n".join(written)


@pytest.mark.parametrize(
    "source",
    [
        '"Least film"',
        '"largest pressure / MPa"',
        'row("Maximum\\npressure / MPa")',
        '("film_min_m", 1e6, "µm")',
        'f"{figures.film_min.value * 1e6:.3g} µm"',
        "f\"{summary['pressure_max_Pa'] / 1e6:.4g} MPa\"",
    ],
)
def test_a_second_label_or_unit_is_seen(source):
    tree = ast.parse(source)
    tree.body[0] = ast.Assign([ast.Name("shown")], tree.body[0].value, lineno=1)
    said = {plain(node.value) for node in texts(tree)}
    assert said & (LABELS | OTHER_WORDS) or list(with_units(tree))


def test_every_quantity_has_one_entry_of_its_own():
    every = (
        *quantities.EVERY_CONTACT, *quantities.MESH_CYCLE, *quantities.FIELDS, *quantities.IN_DATASETS,
    )  # fmt: skip
    assert not [name for name, count in Counter(of.name for of in every).items() if count > 1]
    keys = Counter(of.key for of in quantities.EVERY_CONTACT)
    assert not [key for key, count in keys.items() if count > 1]
    assert all(of.label and of.shown in SCALES for of in every)
    assert all(of.extreme in ("", "minimum", "maximum") for of in every)
    for place in ("key", "picture"):
        assert listed(place) and all(of.extreme for of in listed(place))


def test_one_parser_reads_units_at_the_end_of_keys():
    assert read_key("shaft_torque_N_m") == ("shaft_torque", 1.0, "N m")
    assert read_key("sliding_m_per_s") == ("sliding", 1.0, "m/s")
    assert read_key("backlash_m") == ("backlash", 1e3, "mm")
    assert read_key("contact_ratio") == ("contact_ratio", 1.0, "")
    endings = list(KEY_UNITS)
    for number, ending in enumerate(endings):
        assert not any(ending.endswith(before) for before in endings[:number]), ending


def test_keys_of_errors_have_the_stem_of_the_figure():
    loss, hot = (QUANTITIES[name] for name in ("power_loss_per_length", "temperature_max_film"))
    assert (loss.key, loss.error_key) == ("power_loss_per_length_W_m", "power_loss_error")
    assert loss.model_key == "power_loss_model_error"
    assert (hot.key, hot.error_key) == ("temperature_max_C_film", "temperature_max_error_K_film")
    assert (loss.published, hot.published) == ("power_loss", "temperature_max_film")
    assert QUANTITIES["lambda_central"].published == ""


def test_figures_over_a_life_have_the_unit_of_their_figure():
    assert attributes("life_film_min") == attributes("film_min")
    assert attributes("life_film_min_error")["units"] == "m"
    with pytest.raises(KeyError):
        attributes("life_of_nothing")
