"""Films by every formula of a contact, each with its range and its deviation."""

from dataclasses import replace

import pytest
from contacts import ball, roller
from synthetic_solution import make_solution

import pyworm


def test_a_point_contact_by_every_formula():
    table = pyworm.compare_formulas(ball())
    rows = {row.formula: row for row in table}
    assert list(rows) == [
        "Hamrock-Dowson",
        "Chittenden",
        "Nijenbanning-Venner-Moes",
        "Masjedi-Khonsari",
        "atlas",
    ]
    atlas = pyworm.film_of(ball())
    assert rows["atlas"].film_central == float(atlas.central)
    assert rows["atlas"].deviation_min == 0.0
    one = rows["Hamrock-Dowson"]
    assert one.outside == ""
    assert one.deviation_min == one.film_min / rows["atlas"].film_min - 1
    assert rows["Nijenbanning-Venner-Moes"].film_min is None
    assert table.to_dict()[0]["formula"] == "Hamrock-Dowson"
    assert str(table).splitlines()[1].startswith("Hamrock-Dowson            h_c ")


def test_a_contact_outside_of_ranges_is_marked():
    slender = ball(gap=pyworm.Paraboloid("10 mm", "0.1 mm"), radii=None)
    outside = {row.formula: row.outside for row in pyworm.compare_formulas(slender)}
    assert outside["Hamrock-Dowson"].startswith("ellipticity 0.0")
    assert outside["Chittenden"] == ""


def test_a_line_contact_and_a_solution_as_reference():
    assert pyworm.compare_formulas(roller()).reference == "Moes"
    solution = make_solution()
    table = pyworm.compare_formulas(ball(), solution)
    atlas = table.rows[-1]
    assert table.reference == "solution"
    film = solution.figures.film_central.value
    assert atlas.deviation_central == pytest.approx(atlas.film_central / film - 1)


def test_what_is_no_contact_is_refused():
    with pytest.raises(ValueError, match="scene is a str: must be a Scene"):
        pyworm.compare_formulas("ball")
    with pytest.raises(ValueError, match="solution is a Scene: must be a Solution"):
        pyworm.compare_formulas(ball(), replace(ball(), name="other"))
