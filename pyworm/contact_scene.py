"""The scene of a contact that a case file writes directly."""

from collections.abc import Callable
from pathlib import Path

from pyworm.case_error import CaseError
from pyworm.line.scene import LineScene, Parabola
from pyworm.sampled_gap import SampledGap, read_gap
from pyworm.scene import Gap, Paraboloid, Scene
from pyworm.schema.contact import ContactCase, GapCase, LineCase, PointCase


def contact_scene(
    tables: ContactCase, name: str, directory: Path, slide_roll_ratio: float | None = None
) -> Scene | LineScene:
    """The contact of a case file.

    Parameters
    ----------
    tables : ContactCase
        The file, in SI.
    name : str
        What to call the contact, if it is the only one.
    directory : Path
        What the files that it names are relative to.
    slide_roll_ratio : float, optional
        Which contact of a traction curve; for a file that gives the mean velocity of a point contact.

    Raises
    ------
    CaseError
        A file that it names holds no gap.
    """
    if isinstance(tables, LineCase):
        return _line(tables, name)
    gap, radii = _GAPS[type(tables)](tables, directory)
    oil = tables.oil.oil()
    return Scene(
        name=name if slide_roll_ratio is None else f"slide-roll ratio {slide_roll_ratio:g}",
        gap=gap,
        radii=radii,
        motions=tables.motion.motions(slide_roll_ratio),
        load=tables.contact.load,
        bodies=tables.bodies.pair(oil),
        oil=oil,
        slide_roll_ratio=slide_roll_ratio,
    )


def _paraboloid(tables: PointCase, directory: Path) -> tuple[Gap, tuple[float, float]]:
    radii = tables.contact.radii
    return Paraboloid(*radii), radii


def _sampled(tables: GapCase, directory: Path) -> tuple[Gap, tuple[float, float]]:
    file = tables.contact.file
    try:
        gap: SampledGap = read_gap(directory / file)
        return gap, gap.radii  # a gap that opens nowhere is refused here, with the file's name
    except ValueError as error:
        raise CaseError(f'contact.file = "{file}": {error}') from error


_GAPS: dict[type, Callable] = {PointCase: _paraboloid, GapCase: _sampled}
"""What makes the gap of each kind of point contact, and the radii of curvature at its contact point."""


def _line(tables: LineCase, name: str) -> LineScene:
    radius, oil = tables.contact.radius, tables.oil.oil()
    return LineScene(
        name=name,
        gap=Parabola(radius),
        radius=radius,
        velocities=(tables.motion.velocity_1, tables.motion.velocity_2),
        load=tables.contact.load,
        bodies=tables.bodies.pair(oil),
        oil=oil,
    )
