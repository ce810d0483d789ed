"""`[contact]` and `[motion]`: a contact written directly."""

from typing import Annotated, Literal

from pydantic import Field, field_validator, model_validator

from pyworm import units
from pyworm.scene import RigidMotion
from pyworm.schema.bodies import Bodies, BodyTable
from pyworm.schema.case import CaseTable
from pyworm.schema.table import Number, Table, Text


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

    @model_validator(mode="after")
    def _one_of_both_forms(self):
        given = {
            name
            for name in ("velocity_1", "velocity_2", "mean_velocity", "slide_roll_ratios")
            if getattr(self, name) is not None
        }
        if given not in ({"velocity_1", "velocity_2"}, {"mean_velocity", "slide_roll_ratios"}):
            raise ValueError(
                "give either velocity_1 and velocity_2, or mean_velocity and slide_roll_ratios"
            )
        return self

    def motions(self, slide_roll_ratio: float | None = None) -> tuple[RigidMotion, RigidMotion]:
        """Velocity fields of body 1 and body 2.

        Parameters
        ----------
        slide_roll_ratio : float, optional
            Velocity of body 1 less that of body 2, over their mean [-]; where the mean velocity is given.
        """
        if slide_roll_ratio is None:
            velocities = self.velocity_1, self.velocity_2
        else:
            shares = 1 + slide_roll_ratio / 2, 1 - slide_roll_ratio / 2
            velocities = tuple(tuple(share * of for of in self.mean_velocity) for share in shares)
        spins = self.spin_1, self.spin_2
        first, second = (
            RigidMotion(*velocity, spin) for velocity, spin in zip(velocities, spins, strict=True)
        )
        return first, second


class LineMotionTable(Table):
    """`[motion]` of a line contact: both surfaces' velocity across the line at the contact point."""

    velocity_1: units.Velocity
    velocity_2: units.Velocity


class _ContactCase(CaseTable):
    bodies: ContactBodies


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
