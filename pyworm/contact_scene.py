"""The scene of a contact that a case file writes directly."""

from collections.abc import Callable
from pathlib import Path

from pyworm.case_error import CaseError
from pyworm.line.scene import LineScene, Parabola
from pyworm.sampled_gap import SampledGap, read_gap
from pyworm.scene import Gap, Paraboloid, Scene
from pyworm.schema import ContactCase, GapCase, LineCase, PointCase


def contact_scene(tables: ContactCase, name: str, directory: Path) -> Scene | LineScene:
    """The contact of a case file.

    Parameters
    ----------
    tables : ContactCase
        The file, in SI.
    name : str
        What to call the contact.
    directory : Path
        What the files that it names are relative to.

    Raises
    ------
    CaseError
        A file that it names holds no gap.
    """
    return _MAKERS[type(tables)](tables, name, directory)


def _paraboloid(tables: PointCase, name: str, directory: Path) -> Scene:
    radii = tables.contact.radii
    return _point(tables, name, Paraboloid(*radii), radii)


def _sampled(tables: GapCase, name: str, directory: Path) -> Scene:
    file = tables.contact.file
    try:
        gap: SampledGap = read_gap(directory / file)
        radii = gap.radii  # a gap that opens nowhere is refused here, with the file's name
    except ValueError as error:
        raise CaseError(f'contact.file = "{file}": {error}') from error
    return _point(tables, name, gap, radii)


def _point(tables: PointCase | GapCase, name: str, gap: Gap, radii: tuple[float, float]) -> Scene:
    oil = tables.oil.oil()
    return Scene(
        name=name,
        gap=gap,
        radii=radii,
        motions=tables.motion.motions(),
        load=tables.contact.load,
        bodies=tables.bodies.pair(oil),
        oil=oil,
    )


def _line(tables: LineCase, name: str, directory: Path) -> LineScene:
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


_MAKERS: dict[type, Callable] = {PointCase: _paraboloid, GapCase: _sampled, LineCase: _line}
"""What makes the scene of each kind of contact."""
