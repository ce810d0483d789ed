"""Ratings as tables, for console and page."""

from pyworm.ratings.rating import Rating
from pyworm.report.page.symbols import inputs_as_text, named
from pyworm.report.table import Table


def rating_table(rating: Rating) -> Table:
    """The figures of a rating, a column for each of their origins."""
    columns = range(len(rating.columns))
    return Table(
        head=("Quantity", *rating.headings),
        rows=tuple((figure.label, *map(figure.shown, columns)) for figure in rating.figures),
        title=rating.titled,
        note=f"Source: {rating.source}.",
    )


def safeties_table(rating: Rating, inputs: bool) -> Table:
    """The safeties of a rating with what they require and, where there is room, their inputs."""
    head = ("Safety factor", "Value", "Required", "Verdict", *(["Inputs"] if inputs else []))
    rows = (
        (
            f"{named(safety.symbol)}, {safety.label}",
            safety.shown,
            f"{safety.minimum:g}",
            safety.verdict,
        )
        + ((inputs_as_text(safety),) if inputs else ())
        for safety in rating.safeties
    )
    return Table(head, tuple(rows), f"{rating.title}: safety factors", texts=(3, 4))
