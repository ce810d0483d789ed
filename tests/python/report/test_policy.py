"""Pages run and load what is in them and nothing else: their policy, by itself and in a browser."""

import re
from base64 import b64encode
from hashlib import sha256
from html import unescape

import pytest
from browser import CHROMIUM, WHY_NOT, browse
from folders import CASES

from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.report.policy import policy

in_browser = pytest.mark.skipif(CHROMIUM is None, reason=WHY_NOT)

POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">')
INLINE = re.compile(r"<(style|script)>(.*?)</\1>", re.S)


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """A report, two results side by side and a page to explore of a line contact."""
    out = tmp_path_factory.mktemp("line")
    how = ("--accuracy", "10 %", "--out", str(out))
    assert main(["run", str(CASES / "line_m20_l10.toml"), *how]) == CONVERGED
    result = str(out / "result.nc")
    built = {}
    for name, words in (
        ("report", ["report", result]),
        ("variants", ["report", result, result]),
        ("explore", ["explore", result]),
    ):
        built[name] = out / f"{name}.html"
        assert main([*words, "--out", str(built[name])]) == CONVERGED
    return built


@pytest.mark.parametrize("name", ["report", "variants", "explore"])
def test_a_page_allows_its_own_style_and_script_alone(pages, name):
    text = pages[name].read_text(encoding="utf-8")
    (said,) = POLICY.findall(text)
    allowed = dict(part.split(" ", 1) for part in unescape(said).split("; "))
    assert allowed.pop("default-src") == allowed.pop("base-uri") == "'none'"
    assert (allowed.pop("form-action"), allowed.pop("img-src")) == ("'none'", "data:")
    inside = {f"{kind}-src": content for kind, content in INLINE.findall(text)}
    assert inside.keys() == allowed.keys()
    for kind, content in inside.items():
        digest = b64encode(sha256(content.encode("utf-8")).digest()).decode()
        assert allowed[kind] == f"'sha256-{digest}'"
    assert text.index("Content-Security-Policy") < text.index("<style>")
    # neither attributes would be allowed
    outside = INLINE.sub("", re.sub(r'<script type="application/json".*?</script>', "", text))
    assert not re.search(r"<[^>]*\s(?:style|on\w+)=", outside)


def test_the_digest_is_that_of_the_standard():
    """The digest of alert('Hello, world.'); which the standard itself gives (CSP Level 2, section 7.17.2)."""
    assert "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='" in policy(
        "", "alert('Hello, world.');"
    )


async def _seen(page, file):
    await page.open(file)
    return {
        "title": await page.run("document.title"),
        "font": await page.run("getComputedStyle(document.body).fontFamily"),
        "pictures": await page.run("[...document.images].map((one) => one.naturalWidth)"),
        "errors": page.errors,
    }


@in_browser
@pytest.mark.parametrize("name", ["report", "variants", "explore"])
def test_a_page_works_under_its_policy_without_an_error(pages, name, tmp_path):
    seen = browse(tmp_path / "profile", lambda page: _seen(page, pages[name]))
    assert seen["errors"] == []
    assert "sans-serif" in seen["font"]
    assert all(seen["pictures"])
    assert seen["pictures"] or name != "report"


@in_browser
@pytest.mark.parametrize("name", ["report", "explore"])
def test_what_comes_in_by_words_runs_and_loads_nothing(pages, name, tmp_path):
    foreign = (
        '<script>document.title = "taken over"</script>'
        '<img src="x.png" onerror="document.title = \'taken over\'">'
        "<style>body { font-family: fantasy }</style>"
    )
    page = tmp_path / "page.html"
    text = pages[name].read_text(encoding="utf-8")
    page.write_text(text.replace("</header>", f"{foreign}</header>", 1), encoding="utf-8")
    seen = browse(tmp_path / "profile", lambda one: _seen(one, page))
    assert seen["title"] != "taken over"
    assert "fantasy" not in seen["font"]
    assert sum("Content Security Policy" in error for error in seen["errors"]) >= 3
