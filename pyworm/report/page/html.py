"""A report, or variants side by side, as one self-contained page of HTML, without script or network."""

from pathlib import Path

from pyworm.report.document import document
from pyworm.report.page.content import Report, Variants

_STYLE = Path(__file__).with_name("page.css")


def render(report: Report) -> str:
    """The page of a report."""
    return document("report/page/report.html", _STYLE, title=report.title, report=report)


def render_variants(variants: Variants) -> str:
    """The page of variants side by side."""
    return document("report/page/variants.html", _STYLE, title=variants.title, variants=variants)
