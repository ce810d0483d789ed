"""`[contact]` and `[motion]`: a contact written directly."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, field_validator

from pyworm.case.bodies import Bodies, BodyTable
from pyworm.case.case_file import CaseTable
from pyworm.case.past import PastTable
from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.input_error import CaseError
from pyworm.io.plain_values import Number, Text
from pyworm.io.present import present
from pyworm.scene.gap_file import read_gap
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Gap, Paraboloid, RigidMotion, Scene
from pyworm.scene.sampled_gap import SampledGap


class ContactBodies(Bodies):
    """`[bodies]` of a contact written directly."""

    body_1: BodyTable
    body_2: BodyTable


class PointContactTable(Table):
    """`[contact]`, kind = "point-contact": a paraboloid on a plane."""

    kind: Literal["point-contact"]
    radii: tuple[units.Radius, units.Radius]
    load: units.Force


class LineContactTable(Table):
    """`[contact]`, kind = "line-contact": a parabolic cylinder on a plane."""

    kind: Literal["line-contact"]
    radius: units.Radius
    load: units.ForcePerLength


class GapTable(Table):
    """`[contact]`, kind = "gap": a sampled undeformed gap, its file named relative to the case file."""

    kind: Literal["gap"]
    file: Text
    load: units.Force


class MotionTable(Table):
    """`[motion]`: both surfaces' velocity (along x and y) and spin at the contact point.

    Instead of both velocities their mean may be given, with the slide-roll ratios at which the contact is to
    be solved: a traction curve.
    """

    velocity_1: tuple[units.Velocity, units.Velocity] | None = None
    velocity_2: tuple[units.Velocity, units.Velocity] | None = None
    mean_velocity: tuple[units.Velocity, units.Velocity] | None = None
    slide_roll_ratios: Annotated[tuple[Number, ...], Field(min_length=1)] | None = None
    spin_1: units.Spin = 0.0
    spin_2: units.Spin = 0.0

    @field_validator("mean_velocity")
    @classmethod
    def _what_sliding_is_compared_with(cls, velocity: tuple[float, float]) -> tuple[float, float]:
        if velocity == (0, 0):
            raise ValueError("must not be zero; give velocity_1 and velocity_2 of opposite sliding")
        return velocity

    @field_validator("slide_roll_ratios")
    @classmethod
    def _each_once(cls, ratios: tuple[float, ...]) -> tuple[float, ...]:
        if len(set(ratios)) < len(ratios):
            raise ValueError("must not name a ratio twice")
        return ratios

    def flaws(self) -> Iterator[str]:
        """Not one of both forms."""
        forms = ["velocity_1", "velocity_2"], ["mean_velocity", "slide_roll_ratios"]
        if self.given(*forms[0], *forms[1]) not in forms:
            yield "give either velocity_1 and velocity_2, or mean_velocity and slide_roll_ratios"

    def motions(self, slide_roll_ratio: float | None = None) -> tuple[RigidMotion, RigidMotion]:
        """Velocity fields of both bodies; of a mean velocity at a slide-roll ratio, (u_1 - u_2)/u_m [-]."""
        if slide_roll_ratio is None:
            first = present(self.velocity_1, "motion.velocity_1")
            second = present(self.velocity_2, "motion.velocity_2")
        else:
            factors = 1 + slide_roll_ratio / 2, 1 - slide_roll_ratio / 2
            u, v = present(self.mean_velocity, "motion.mean_velocity")
            first, second = ((factor * u, factor * v) for factor in factors)
        return RigidMotion(*first, self.spin_1), RigidMotion(*second, self.spin_2)


class LineMotionTable(Table):
    """`[motion]` of a line contact: both surfaces' velocity across the line at the contact point."""

    velocity_1: units.Velocity
    velocity_2: units.Velocity


class _ContactCase(CaseTable):
    bodies: ContactBodies
    past: PastTable | None = None


class PointCase(_ContactCase):
    """A case file about a point contact written directly."""

    contact: PointContactTable
    motion: MotionTable


class GapCase(_ContactCase):
    """A case file about a sampled gap."""

    contact: GapTable
    motion: MotionTable


class LineCase(_ContactCase):
    """A case file about a line contact written directly."""

    contact: LineContactTable
    motion: LineMotionTable


ContactCase = PointCase | GapCase | LineCase


def contact_scene(
    tables: ContactCase, name: str, directory: Path, slide_roll_ratio: float | None = None
) -> Scene | LineScene:
    """The contact of a case file, its files relative to `directory`; CaseError if one of them holds no gap.

    The slide-roll ratio selects a contact of a traction curve.
    """
    scene = (
        _line(tables, name)
        if isinstance(tables, LineCase)
        else _point(tables, name, directory, slide_roll_ratio)
    )
    return scene if tables.past is None else tables.past.of(scene)


def _point(
    tables: PointCase | GapCase, name: str, directory: Path, slide_roll_ratio: float | None
) -> Scene:
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
