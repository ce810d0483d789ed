"""Equations of the pages become MathML, and a bad one fails the site."""

import csv

import pytest
from equations import Equations, mathml
from folders import ROOT
from markdown import Markdown
from mkdocs.commands.build import build
from mkdocs.config import load_config

PAGE = r"""# A page

The pressure $p_\mathrm{max}$ costs `$5`.

$$
h = h_0 + \frac{x^2}{2 R} \tag{1}
$$

```sh
echo "$HOME $(date)"
```
"""


@pytest.fixture
def site(tmp_path):
    """A function that builds the site of one page, and gives the page as HTML."""

    def built(text: str) -> str:
        (tmp_path / "docs").mkdir()
        (tmp_path / "docs/index.md").write_text(text)
        (tmp_path / "mkdocs.yml").write_text(
            f"site_name: test\nhooks: [{ROOT}/tools/equations.py]\n"
        )
        build(load_config(str(tmp_path / "mkdocs.yml")))
        return (tmp_path / "site/index.html").read_text()

    return built


def test_a_page_with_equations_becomes_mathml(site):
    page = site(PAGE.partition("```sh")[0])
    assert page.count("<math ") == 2
    assert '<div class="equation" id="eq-1"><math' in page
    assert '<span class="equation-number">(1)</span>' in page
    assert "<code>$5</code>" in page
    assert "$$" not in page and r"\tag" not in page


def test_functions_are_spaced_and_bold_letters_are_characters():
    assert ">ln</mo><mi>x</mi>" in mathml(r"\ln x")
    assert "<mi>\U0001d749</mi>" in mathml(r"\boldsymbol{\tau}")
    assert 'form="prefix">&#x0007C;' in mathml(r"\lvert x \rvert")
    assert "<mi>\U0001d753</mi>" in mathml(r"\boldsymbol{\phi}")


def test_code_stays_code():
    page = Markdown(extensions=["fenced_code", Equations()]).convert(PAGE)
    assert 'echo "$HOME $(date)"' in page.replace("&quot;", '"')


@pytest.mark.parametrize(
    "bad",
    [
        r"\frac{a}",
        r"\frac{a}{b",
        r"\nonsense x",
        r"a_",
        r"\left( x",
        r"\begin{aligned} a &= b \end{aligned}",
    ],
)
def test_a_bad_equation_fails_the_site(bad, site):
    with pytest.raises(ValueError, match="no equation"):
        mathml(bad)
    with pytest.raises(ValueError, match="no equation"):
        site(f"The equation\n\n$$\n{bad}\n$$\n")


def test_an_equation_that_is_not_recognised_fails_the_site(site):
    with pytest.raises(ValueError, match="not an equation"):
        site("An equation $$ that nobody closes\n")


@pytest.mark.parametrize("page", sorted((ROOT / "docs").rglob("*.md")), ids=lambda page: page.stem)
def test_equations_of_the_pages_are_shown(page):
    shown = Markdown(extensions=["tables", "fenced_code", "md_in_html", Equations()]).convert(
        page.read_text()
    )
    assert "$$" not in shown


def test_the_sources_of_the_equations_are_there():
    with (ROOT / "docs/theory/implementation.csv").open(newline="") as file:
        listed = list(csv.DictReader(file))
    pages = {path.stem for path in (ROOT / "docs/theory").glob("*.md")}
    assert {row["page"] for row in listed} <= pages
    missing = [
        name for row in listed for name in row["sources"].split() if not (ROOT / name).exists()
    ]
    assert not missing
