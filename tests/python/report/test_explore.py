"""The page to explore a result, in a browser without network."""

import json
from base64 import b64decode
from dataclasses import replace

import numpy as np
import pytest
from browser import CHROMIUM, WHY_NOT, browse
from folders import CASES
from synthetic_solution import line_with_heat, make_line_solution

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED
from pyworm.report.explore.packed import packed
from pyworm.report.explore.page import content, explore
from pyworm.report.explore.scenes import NODES, scene_rows
from pyworm.result.result import open_result

in_browser = pytest.mark.skipif(CHROMIUM is None, reason=WHY_NOT)


@pytest.fixture(scope="module")
def cycle(tmp_path_factory):
    """Four phases of the drive, roughly, and their results file."""
    out = tmp_path_factory.mktemp("cycle")
    phases = ("0.2", "0.4", "0.6", "0.8")
    how = ("--accuracy", "30 %", "--effects", "auto,-squeeze", "--pictures", "none")
    words = ["run", str(CASES / "zi_drive.toml"), "--phase", *phases, *how, "--out", str(out)]
    assert main(words) in (CONVERGED, 3)
    return out / "result.nc"


def test_numbers_come_back_within_half_a_step():
    values = np.array([[1e-7, 2.5e-6, np.nan], [3e-5, 1e-3, 0.2]])
    for logarithmic in (False, True):
        of = packed(values, logarithmic)
        numbers = np.frombuffer(b64decode(of["data"]), "<u2")
        found = of["low"] + of["step"] * numbers
        found = np.exp(found) if logarithmic else found
        known = np.isfinite(values).ravel()
        assert (numbers[~known] == 65535).all()
        step = of["step"] * (values.ravel()[known] if logarithmic else 1)
        assert (np.abs(found[known] - values.ravel()[known]) <= 0.51 * step).all()


def test_what_has_no_logarithm_is_left_out():
    """As of a contact whose film was not found, where the dry bodies overlap."""
    some = packed(np.array([-2e-7, 0.0, 1e-7, 1e-3]), logarithmic=True)
    numbers = np.frombuffer(b64decode(some["data"]), "<u2")
    assert list(numbers) == [65535, 65535, 0, 65534]
    none = packed(np.array([-1.0, np.nan]), logarithmic=True)
    assert list(np.frombuffer(b64decode(none["data"]), "<u2")) == [65535, 65535]


def test_figures_have_the_uncertainty_of_the_model_beside_the_numerical_one():
    hot = line_with_heat(make_line_solution(phase=0.5))
    film = replace(hot.figures.film_min, model=0.12)
    warm = replace(hot.figures.temperature_max_film, model=0.3)
    rough = replace(hot, figures=replace(hot.figures, film_min=film, temperature_max_film=warm))
    rows = dict(scene_rows(rough, ("pinion", "gear")))
    assert rows["Minimum film thickness"].endswith("± 12 % (model)")
    rise = warm.value - hot.inlet_temperature
    assert rows["Maximum film temperature"].endswith(f"± {0.3 * rise:.2g} K (model)")
    smooth = dict(scene_rows(hot, ("pinion", "gear")))
    assert not any("(model)" in of for of in smooth.values())


@pytest.mark.long
def test_the_page_has_the_fields_of_every_contact_reduced(cycle):
    result = open_result(cycle)
    found = content(result)
    assert [one["name"] for one in found["scenes"]] == [
        f"phase {of:g}" for of in (0.2, 0.4, 0.6, 0.8)
    ]
    for one, solution in zip(found["scenes"], result.solutions, strict=True):
        assert one["x"][2] <= NODES[0] and one["y"][2] <= NODES[1]
        pressure = one["fields"]["pressure"]
        highest = pressure["low"] + 65534 * pressure["step"]
        assert highest == pytest.approx(solution.figures.pressure_max.value * 1e-6, rel=0.03)
    assert found["flank"]["fields"].keys() >= {"film", "pressure"}
    worm, wheel = found["space"]["shapes"]
    assert (worm["body"], wheel["body"], len(wheel["pressures"])) == (1, 2, 4)
    assert not {"http://", "https://"} & set(explore(result).split('"'))


async def _visited(page, file, pictures):
    """What a user sees: time of opening, panels before and after the slider moves, read-outs."""
    await page.open(file)
    seen = {"seconds": await page.processor_time()}
    panels = ("map", "along-x", "along-y", "flank", "space")
    image = "document.getElementById('{}').toDataURL()"
    seen["before"] = [await page.run(image.format(of)) for of in panels]
    await page.run(
        "const s = document.getElementById('slider'); s.value = 2; s.dispatchEvent(new Event('input'))"
    )
    seen["place"] = await page.run("document.getElementById('place').textContent")
    seen["after"] = [await page.run(image.format(of)) for of in panels]
    box = json.loads(
        await page.run("JSON.stringify(document.getElementById('map').getBoundingClientRect())")
    )
    at = box["x"] + 0.45 * box["width"], box["y"] + 0.4 * box["height"]
    await page.mouse("mouseMoved", *at)
    seen["read"] = await page.run("document.getElementById('map-read').textContent")
    await page.click(*at)
    seen["picked"] = await page.run("state.picked")
    seen["marked"] = [await page.run(image.format(of)) for of in panels]
    seen["flank"] = await page.run("loadedMost(...onFlank(scene(), state.scene)).number")
    seen["value"] = await page.run("unpacked(scene().fields.pressure)[node(scene().y, state.picked[1])"
                                   " * scene().x[2] + node(scene().x, state.picked[0])]")  # fmt: skip
    await page.run("play()")
    await page.run("new Promise((done) => setTimeout(done, 10))")
    seen["plays"] = await page.run("element('play').textContent")
    await page.run("play()")
    await page.picture(pictures)
    seen["errors"] = page.errors
    return seen


@in_browser
@pytest.mark.long
def test_the_page_in_a_browser(cycle, tmp_path):
    assert main(["explore", str(cycle), "--out", str(tmp_path / "page.html")]) == CONVERGED
    file = tmp_path / "page.html"
    assert file.stat().st_size < 30e6
    seen = browse(tmp_path / "profile", lambda page: _visited(page, file, tmp_path / "page.png"))
    assert seen["errors"] == []
    assert 0 < seen["seconds"] < 2
    assert seen["place"] == "phase 0.6"
    assert all(one != other for one, other in zip(seen["before"], seen["after"], strict=True))
    assert "pressure" in seen["read"] and "µm" in seen["read"]
    assert seen["plays"] == "❚❚"
    # field, profiles and flank follow the place picked; its pressure is that of the results file
    assert all(
        one != other for one, other in zip(seen["after"][:4], seen["marked"][:4], strict=True)
    )
    x, y = (1e-3 * of for of in seen["picked"])
    solution = open_result(cycle).solutions[2]
    there = solution.fields["pressure"].interp(x=x, y=y) * 1e-6
    assert seen["value"] == pytest.approx(float(there), rel=0.05, abs=5)
    assert seen["flank"] in range(4)
    assert (tmp_path / "page.png").stat().st_size > 50_000


@in_browser
def test_a_line_contact_has_a_profile_and_no_map(tmp_path):
    out = tmp_path / "line"
    how = ("--accuracy", "10 %", "--pictures", "none", "--out", str(out))
    assert main(["run", str(CASES / "line_m20_l10.toml"), *how]) == CONVERGED
    assert main(["explore", str(out / "result.nc")]) == CONVERGED

    async def visit(page):
        await page.open(out / "explore.html")
        hidden = await page.run(
            "['map', 'y-part', 'flank-part', 'space-part', 'play'].map((id) => element(id).hidden)"
        )
        return hidden, await page.run("document.getElementById('figures').innerText"), page.errors

    hidden, figures, errors = browse(tmp_path / "profile", visit)
    assert hidden == [True] * 5 and errors == []
    assert "Minimum film thickness" in figures


@in_browser
@pytest.mark.parametrize("case, words", [("spur_pair", []), ("roller_ref", ["--section", "left"])])
def test_drives_of_line_contacts_have_their_line_in_space(case, words, tmp_path):
    place = ("--phase", "0.2", "0.8", *words, *(("--station", "0.5") if words else ()))
    how = ("--accuracy", "10 %", "--effects", "isothermal", "--pictures", "none")
    assert (
        main(["run", str(CASES / f"{case}.toml"), *place, *how, "--out", str(tmp_path)])
        == CONVERGED
    )
    assert main(["explore", str(tmp_path / "result.nc")]) == CONVERGED

    async def visit(page):
        await page.open(tmp_path / "explore.html")
        image = "element('space').toDataURL()"
        first = await page.run(image)
        await page.run("show(1)")
        read = await page.run("element('space-read').textContent")
        return first, await page.run(image), read, page.errors

    first, second, read, errors = browse(tmp_path / "profile", visit)
    assert first != second and "Red: line of contact" in read and errors == []


def test_a_directory_in_place_of_a_page_is_refused(tmp_path, capsys):
    assert main(["explore", "result.nc", "--out", str(tmp_path)]) == BAD_INPUT
    assert "is a directory" in capsys.readouterr().err
