"""Use of pages in a browser: no error, by the keyboard, on a narrow screen and on paper."""

from pathlib import Path

import pytest
from browser import CHROMIUM, WHY_NOT, browse
from folders import CASES

from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=WHY_NOT)

SITE = Path(__file__).parents[3] / "build/docs"
SITE_PAGES = "index.html", "theory/film.html", "reference/symbols.html", "evidence/validation.html"

NARROW = 360
"""Width of a narrow screen, a telephone's [px]."""

TAB, RIGHT = ("Tab", 9), ("ArrowRight", 39)

FOCUSED = """(() => {
  const one = document.activeElement, style = getComputedStyle(one);
  const all = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')];
  const seen = style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0
    || style.boxShadow !== 'none';
  return {number: all.indexOf(one), seen, name: one.id || one.textContent.slice(0, 30)};
})()"""
"""The element with the focus: its number among all that take it, and whether it is marked."""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """A report and a page to explore of a gear pair at two phases."""
    out = tmp_path_factory.mktemp("pair")
    how = ("--accuracy", "10 %", "--effects", "isothermal", "--pictures", "none", "--out", str(out))
    assert main(["run", str(CASES / "spur_pair.toml"), "--phase", "0.2", "0.8", *how]) == CONVERGED
    for name in ("report", "explore"):
        assert main([name, str(out / "result.nc"), "--out", str(out / f"{name}.html")]) == CONVERGED
    return out


async def _used(page, file):
    """What a visitor with a keyboard, one with a telephone and one with a printer see."""
    await page.open(file)
    focused = []
    for _ in range(4):
        await page.press(*TAB)
        focused.append(await page.run(FOCUSED))
    narrow = await page.width(NARROW)
    await page.call("Emulation.clearDeviceMetricsOverride")
    await page.medium("print")
    printed = await page.run(
        "[...document.querySelectorAll('button, input, select')]"
        ".filter((one) => one.offsetParent !== null).map((one) => one.id || one.className || one.tagName)"
    )
    paper = await page.width(720)
    await page.medium("screen")
    return {"focused": focused, "narrow": narrow, "controls": printed, "paper": paper,
            "errors": page.errors}  # fmt: skip


def check(seen):
    numbers = [one["number"] for one in seen["focused"]]
    assert seen["errors"] == []
    assert numbers == sorted(numbers) and len(set(numbers)) > 1, seen["focused"]
    assert all(one["seen"] for one in seen["focused"]), seen["focused"]
    assert seen["narrow"] <= NARROW
    assert seen["controls"] == []
    assert seen["paper"] <= 720


@pytest.mark.parametrize("name", ["report", "explore"])
def test_a_page_is_used_by_keyboard_telephone_and_printer(pages, name, tmp_path):
    check(browse(tmp_path / "profile", lambda page: _used(page, pages / f"{name}.html")))


def test_sliders_move_by_the_arrow_keys(pages, tmp_path):
    async def visit(page):
        await page.open(pages / "explore.html")
        before = await page.run("element('place').textContent")
        await page.run("element('slider').focus()")
        await page.press(*RIGHT)
        return before, await page.run("element('place').textContent"), page.errors

    before, after, errors = browse(tmp_path / "profile", visit)
    assert (before, after, errors) == ("phase 0.2", "phase 0.8", [])


@pytest.mark.skipif(not (SITE / "index.html").is_file(), reason="the site is not built (make docs)")
def test_pages_of_the_site_are_used_by_keyboard_and_telephone(tmp_path):
    async def visit(page):
        return {name: await _used(page, SITE / name) for name in SITE_PAGES}

    for name, seen in browse(tmp_path / "profile", visit).items():
        print(name, seen)
        assert seen["errors"] == [], name
        assert seen["narrow"] <= NARROW, name
        assert all(one["seen"] for one in seen["focused"]), name
