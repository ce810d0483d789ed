"""Motion of the parts of a drive that no shaft drives, as a table of figures."""

from pyworm.drives.answers import FigureTable
from pyworm.ratings.rating import RatedFigure, Rating


def rate_motion(found: FigureTable) -> Rating:
    """The figures of a drive's motion, a column for each part."""
    return Rating(
        key=found.key,
        title=found.title,
        source=found.source,
        columns=found.parts,
        figures=tuple(RatedFigure(row.key, row.label, row.values, row.unit) for row in found.rows),
        words=found.words,
    )
