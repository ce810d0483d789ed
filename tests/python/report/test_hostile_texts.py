"""Pages of cases whose every free text is markup: it stands there as text, and nothing of it is run."""

import copy
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser

import pytest
from folders import CASES
from synthetic_solution import make_hot_worm, make_mesh_cycle

import pyworm
from pyworm.case.case import case_again
from pyworm.io.input_error import CaseError
from pyworm.io.shown import Shown
from pyworm.report.explore.page import explore
from pyworm.report.page.build import build_report
from pyworm.report.page.html import render, render_variants
from pyworm.report.page.variants import variants_page
from pyworm.result.result import Result

HOSTILE = """</p></td><script>run({})</script>"><img src='x' onerror='run()'>{{{{ 7 * 7 }}}}"""
TAGS = {
    "html", "head", "meta", "title", "style", "body", "header", "main", "nav", "section", "div", "span", "p",
    "h1", "h2", "h3", "dl", "dt", "dd", "ul", "ol", "li", "a", "sub", "table", "caption", "thead", "tbody",
    "tr", "th", "td", "figure", "figcaption", "img",
}  # fmt: skip
ATTRIBUTES = {
    "lang", "charset", "http-equiv", "name", "content", "class", "id", "href", "src", "alt", "scope",
}  # fmt: skip


class Read(HTMLParser):
    """Tags and attributes of a page, and its text."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.attributes: set[str] = set()
        self.text = ""
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes |= {name for name, _ in attrs}

    def handle_data(self, data):
        self.text += data


def texts(tables: dict, path: tuple = ()) -> Iterator[tuple]:
    """Places of all texts in nested tables."""
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from texts(value, (*path, key))
        elif isinstance(value, str):
            yield (*path, key)


@pytest.fixture(scope="module")
def hostile():
    """A result whose case has markup wherever it takes any text, and the number of these places."""
    tables, count = pyworm.load(CASES / "zi_sharif_2001.toml").resolved, 0
    tables["bearings"][HOSTILE.format("key")] = tables["bearings"].pop("worm_shaft")
    del tables["assumed"]["bearings.worm_shaft"]
    del tables["published"]  # quantities
    for *path, key in list(texts(tables)):
        if key == "oil":  # a name to look up, without which there is no page to sign
            continue
        changed = copy.deepcopy(tables)
        place = changed
        for part in path:
            place = place[part]
        place[key] = HOSTILE.format(count)
        try:
            case_again(changed)
        except CaseError:
            continue
        tables, count = changed, count + 1
    solution = replace(make_hot_worm(0.5), stop_reason=HOSTILE.format("stop"))
    provenance = {
        "pyworm": HOSTILE.format("version"),
        "machine": HOSTILE.format("machine"),
        "warnings": [HOSTILE.format("warning")],
        "failed": {HOSTILE.format("name"): HOSTILE.format("reason")},
        "plans": [{"accuracy": 0.02}],
    }
    name = HOSTILE.format("case")
    return Result(name, tables, (solution,), make_mesh_cycle(), provenance), count


@pytest.mark.usefixtures("undrawn")
def test_a_report_shows_every_text_as_text(hostile):
    result, count = hostile
    assert count > 12
    identity = (("Drawing", HOSTILE.format("drawing")), ("Customer", HOSTILE.format("customer")))
    page = Read(render(build_report(result, None, HOSTILE.format("differ"), identity)))
    assert set(page.tags) <= TAGS and page.attributes <= ATTRIBUTES
    shown = set(re.findall(r"run\((\w+)\)</script>\">", page.text))
    wanted = "stop version machine warning name reason case drawing customer differ key".split()
    assert shown > {*wanted, "1", "2"}  # of the case: its title and its source
    assert "{{ 7 * 7 }}" in page.text and page.tags.count("img") == page.tags.count("figure")


@pytest.mark.usefixtures("undrawn")
def test_variants_show_every_text_as_text(hostile):
    other = replace(hostile[0], case={**hostile[0].case, "title": HOSTILE.format("title")})
    names = HOSTILE.format("first"), HOSTILE.format("second")
    page = Read(render_variants(variants_page((hostile[0], other), names)))
    assert set(page.tags) <= TAGS and page.attributes <= ATTRIBUTES
    assert all(name in page.text for name in (*names, HOSTILE.format("title")))


def test_a_page_to_explore_shows_every_text_as_text(hostile):
    page = explore(hostile[0])
    read = Read(page)
    assert read.tags.count("script") == 2 and "img" not in read.tags
    assert not {name for name in read.attributes if name.startswith("on")}
    assert read.text.count("</p></td><script>") >= 3  # title, heading and source
    data = re.search('<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    stopped = [scene["name"] for scene in json.loads(data[1])["scenes"]]
    assert stopped == ["phase 0.5"]


def test_an_object_in_a_notebook_shows_its_texts_as_text():
    class Named(Shown):
        def shown(self):
            return HOSTILE.format("heading"), {HOSTILE.format("name"): HOSTILE.format("value")}

    read = Read(Named()._repr_html_())
    assert set(read.tags) == {"table", "caption", "tr", "th", "td"}
    assert all(HOSTILE.format(name) in read.text for name in ("heading", "name", "value"))
