r"""Equations of the pages as MathML, which browsers show without scripts, fonts or network.

`mkdocs.yml` names this file as a hook. `$...$` is an equation in a sentence. `$$...$$` between blank lines
stands alone, with its number in `\tag{...}`, by which `#eq-NUMBER` links to it. GitHub shows the same source.
"""

import re
from collections.abc import MutableMapping
from typing import Any
from xml.etree.ElementTree import Element, fromstring

from latex2mathml.converter import convert
from markdown import Markdown
from markdown.extensions import Extension
from markdown.inlinepatterns import InlineProcessor
from markdown.preprocessors import Preprocessor

DISPLAYED = re.compile(r"^\$\$\s*(.*?)\s*\$\$$", re.M | re.S)
IN_SENTENCE = r"(?<![\\$\w])\$(?![\s$])([^$]+?)(?<!\s)\$(?![\w$])"
TAG = re.compile(r"\s*\\tag\{([\w.]+)\}")

FUNCTION = re.compile(r"<mi>(arctan|cos|exp|lim|ln|log|max|min|sin|sinh|tan|tanh)</mi>")
SPACED = r'<mo form="prefix" lspace="0.167em" rspace="0.167em">\1</mo>'
"""A function has a space around it."""

BOLD = re.compile(r'<mi mathvariant="bold-italic">&#x00([0-9A-F]{3});</mi>')
BOLD_GREEK = {0x391: 0x1D71C, 0x3B1: 0x1D736, 0x3D5: 0x1D753}
"""First letter of a row -> its bold form: browsers know no `mathvariant` but "normal"."""

SIGN = re.compile(r"(<mo[^>]*>(?:&#x00028;|&#x0003D;|&#x0002C;)</mo>)<mo>(&#x02212;)</mo>")
"""A minus that is a sign and no operator."""

OPERANDS = {
    "mfrac": 2,
    "msub": 2,
    "msup": 2,
    "munder": 2,
    "mover": 2,
    "msubsup": 3,
    "munderover": 3,
}
"""Number of children that a MathML element must have."""


class BadEquationError(ValueError):
    """An equation that is not LaTeX, or not of the part that the converter knows."""


def mathml(latex: str, display: str = "inline") -> str:
    """MathML of an equation.

    The converter passes unknown commands and missing operands on; both are refused here.

    Raises:
        BadEquationError: If the equation is incomplete or has an unknown command.
    """
    braces = re.findall(r"(?<!\\)[{}]", latex)
    try:
        paired = latex.replace(r"\lvert", r"\left|").replace(r"\rvert", r"\right|")
        text = convert(paired, display=display).replace("<mi>&</mi>", "<mi>&amp;</mi>")
        text = BOLD.sub(_bold, FUNCTION.sub(SPACED, text))
        text = SIGN.sub(r'\1<mo form="prefix">\2</mo>', text)
        elements = list(fromstring(text).iter())
    except Exception as error:  # the converter raises errors of many kinds
        raise BadEquationError(f"no equation: {latex} ({type(error).__name__})") from error
    unknown = [e.text for e in elements if e.text and (e.text.startswith("\\") or e.text == "&")]
    incomplete = [e for e in elements if len(e) != OPERANDS.get(e.tag.rpartition("}")[2], len(e))]
    if unknown or incomplete or braces.count("{") != braces.count("}"):
        reason = f"unknown: {unknown[0]}" if unknown else "a brace or an operand is missing"
        raise BadEquationError(f"no equation: {latex} ({reason})")
    return text


def _bold(letter: re.Match[str]) -> str:
    """A bold Greek letter as a character of its own."""
    code = int(letter[1], 16)
    first = max(start for start in BOLD_GREEK if start <= code)
    return f"<mi>{chr(BOLD_GREEK[first] + code - first)}</mi>"


class _DisplayedEquations(Preprocessor):
    """Numbered equations, replaced before anything in them is read as Markdown."""

    def run(self, lines: list[str]) -> list[str]:
        return DISPLAYED.sub(self._stashed, "\n".join(lines)).split("\n")

    def _stashed(self, found: re.Match[str]) -> str:
        tag = TAG.search(found[1])
        equation = mathml(TAG.sub("", found[1]), "block")
        number = f'<span class="equation-number">({tag[1]})</span>' if tag else ""
        anchor = f' id="eq-{tag[1]}"' if tag else ""
        block = f'<div class="equation"{anchor}>{equation}{number}</div>'
        return f"\n{self.md.htmlStash.store(block)}\n"


class _EquationsInSentences(InlineProcessor):
    """Equations in a sentence, left alone in code."""

    def handleMatch(  # noqa: N802
        self, m: re.Match[str], data: str
    ) -> tuple[str | Element, int, int]:
        return self.md.htmlStash.store(mathml(m[1])), m.start(0), m.end(0)


class Equations(Extension):
    """Markdown with equations."""

    def extendMarkdown(self, md: Markdown) -> None:  # noqa: N802
        """Add both kinds of equations to a reader of Markdown."""
        # After fenced code (25), before blocks of HTML (20); after code (190), before escapes (180).
        md.preprocessors.register(_DisplayedEquations(md), "displayed_equations", 24)
        md.inlinePatterns.register(_EquationsInSentences(IN_SENTENCE, md), "equations", 185)


def on_config(config: MutableMapping[str, Any]) -> MutableMapping[str, Any]:
    """Let every page of the site have equations."""
    config["markdown_extensions"].append(Equations())
    return config


def on_post_page(output: str, **_: object) -> str:
    """Refuse a page on which an equation was not recognised.

    Raises:
        BadEquationError: If the page has two dollar signs in a row.
    """
    if "$$" in output:
        raise BadEquationError(f"not an equation: {output[output.index('$$') :][:60]}")
    return output
