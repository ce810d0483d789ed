"""`[past]`: loads and speeds that a contact written directly had before."""

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Self

import numpy as np
from pydantic import Field, model_validator

from pyworm.case.table import Table, plain
from pyworm.io import units
from pyworm.io.plain_values import Number
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.life import Life, Past, unturned
from pyworm.scene.line import LineScene
from pyworm.scene.point import RigidMotion
from pyworm.scene.waves import velocities

Factors = Annotated[tuple[Number, ...], Field(min_length=2)]


@dataclass(frozen=True, kw_only=True)
class LoadHistory:
    """Factors of the load and of the surfaces' velocities at some times, straight between them."""

    times: Annotated[tuple[units.TimeOrZero, ...], Field(min_length=2)]
    """Times since the beginning [s]; the last one is the present."""
    load: Factors | None = None
    """Factors of the load [-]; None where it is always the present one."""
    speed: Factors | None = None
    """Factors of velocities and spins [-]; None likewise."""
    separation: Annotated[tuple[units.Separation, ...], Field(min_length=2)] | None = None
    """Distances of the undeformed surfaces [m], which hold where the factor of the load is zero."""


class PastTable(Table, LoadHistory):
    """`[past]`: factors of the load and of the surfaces' velocities at some times, straight between them.

    Where the load is zero the separation of the surfaces may be given. The last time is the present, at which
    the contact is solved.
    """

    @model_validator(mode="after")
    def _a_course_that_ends_at_present(self) -> Self:
        if self.times[0] != 0 or any(after <= before for before, after in pairwise(self.times)):
            raise ValueError('times begin at "0 s" and rise')
        given = {
            key: factors for key in ("load", "speed") if (factors := getattr(self, key)) is not None
        }
        if not given:
            raise ValueError("give the factors of load, of speed, or both")
        for key, factors in given.items():
            if len(factors) != len(self.times):
                raise ValueError(
                    f"{key} has {len(factors)} factors and times {len(self.times)}; "
                    "one factor per time required"
                )
            if factors[-1] != 1:
                raise ValueError(
                    f"{key} ends with {factors[-1]:g}; the last time is the present, whose factor is 1"
                )
        self._check_separation()
        if self.load is not None and min(self.load) < 0:
            raise ValueError(f"load has a factor of {min(self.load):g}; load must not be negative")
        return self

    def _check_separation(self) -> None:
        """Refuse a separation without a time at which it holds, or one that is none."""
        if self.separation is None:
            return
        if len(self.separation) != len(self.times):
            raise ValueError(
                f"separation has {len(self.separation)} lengths and times {len(self.times)}; "
                "one factor per time required"
            )
        if self.load is None or min(self.load) > 0:
            raise ValueError(
                "separation holds where the factor of load is 0; give load such factors"
            )
        apart = [gap for gap, load in zip(self.separation, self.load, strict=True) if load == 0]
        if not min(apart) > 0:
            raise ValueError(
                f"separation is {min(apart):g} m where the load is zero; surfaces that are apart have one "
                "above zero"
            )

    def of(self, scene: AnyContact) -> AnyContact:
        """The contact with this past."""
        history = _WrittenLife(present=scene, **vars(plain(self, LoadHistory)))
        life = Life(self.times[-1], history, unturned, self.times[1:-1])
        return replace(history(self.times[-1]), past=Past(life, self.times[-1]))


@dataclass(frozen=True, kw_only=True)
class _WrittenLife(LoadHistory):
    """Time since the beginning [s] -> the contact then; ValueError where it carries no load."""

    present: AnyContact

    def __call__(self, seconds: float) -> AnyContact:
        load, speed = (
            1.0 if factors is None else float(np.interp(seconds, self.times, factors))
            for factors in (self.load, self.speed)
        )
        moving = replace(_moving(self.present, speed), travelled=self._travelled(seconds))
        if load > 0:
            return replace(moving, load=load * self.present.load)
        if self.separation is None:
            raise ValueError("the contact carries no load")
        return replace(moving, separation=float(np.interp(seconds, self.times, self.separation)))

    def _travelled(self, seconds: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """How far the surfaces are from their place at present, along each direction [m]."""
        knots = np.array([seconds, *(time for time in self.times if time > seconds)])
        speeds = np.ones(knots.size)
        if self.speed is not None:
            speeds = np.interp(knots, self.times, self.speed)
        left = float(np.trapezoid(speeds, knots))
        body_1, body_2 = velocities(self.present)
        return tuple(-left * velocity for velocity in body_1), tuple(
            -left * velocity for velocity in body_2
        )


def _moving(scene: AnyContact, factor: float) -> AnyContact:
    """A contact whose surfaces, which translate and spin at most, move some times as fast."""
    if isinstance(scene, LineScene):
        first, second = scene.velocities
        return replace(scene, velocities=(factor * first, factor * second))
    rigid = [motion for motion in scene.motions if isinstance(motion, RigidMotion)]
    body_1, body_2 = (
        RigidMotion(factor * motion.u, factor * motion.v, factor * motion.spin) for motion in rigid
    )
    return replace(scene, motions=(body_1, body_2))
