"""`[past]`: loads and speeds that a contact written directly had before."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Annotated

from pydantic import Field

from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.plain_values import Number
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.history import History, Interpolated
from pyworm.scene.life import Past

Factors = Annotated[tuple[Number, ...], Field(min_length=2)]


class PastTable(Table):
    """`[past]`: factors of the load and of the surfaces' velocities at some times, straight between them.

    Where the load is zero the separation of the surfaces may be given. The last time is the present, at which
    the contact is solved.
    """

    times: Annotated[tuple[units.TimeOrZero, ...], Field(min_length=2)]
    """Times since the beginning [s]; the last one is the present."""
    load: Factors | None = None
    """Factors of the load [-]; None where it is always the present one."""
    speed: Factors | None = None
    """Factors of velocities and spins [-]; None likewise."""
    separation: Annotated[tuple[units.Separation, ...], Field(min_length=2)] | None = None
    """Distances of the undeformed surfaces [m], which hold where the factor of the load is zero."""

    def flaws(self) -> Iterator[str]:
        """What makes no course that ends at present."""
        if self.times[0] != 0 or any(after <= before for before, after in pairwise(self.times)):
            yield 'times begin at "0 s" and rise'
        given = {
            key: factors for key in ("load", "speed") if (factors := getattr(self, key)) is not None
        }
        if not given:
            yield "give the factors of load, of speed, or both"
        for key, factors in given.items():
            if len(factors) != len(self.times):
                yield (
                    f"{key} has {len(factors)} factors and times {len(self.times)}; "
                    "one factor per time required"
                )
            if factors[-1] != 1:
                yield (
                    f"{key} ends with {factors[-1]:g}; the last time is the present, whose factor is 1"
                )
        if self.separation is not None:
            yield from self._flaws_of_separation(self.separation)
        if self.load is not None and min(self.load) < 0:
            yield f"load has a factor of {min(self.load):g}; load must not be negative"

    def _flaws_of_separation(self, lengths: tuple[float, ...]) -> Iterator[str]:
        """A separation without a time at which it holds, or one that is none."""
        if len(lengths) != len(self.times):
            yield (
                f"separation has {len(lengths)} lengths and times {len(self.times)}; "
                "one factor per time required"
            )
        if self.load is None or min(self.load) > 0:
            yield "separation holds where the factor of load is 0; give load such factors"
            return
        apart = [gap for gap, load in zip(lengths, self.load, strict=True) if load == 0]
        if not min(apart) > 0:
            yield (
                f"separation is {min(apart):g} m where the load is zero; surfaces that are apart have one "
                "above zero"
            )

    def of(self, scene: AnyContact) -> AnyContact:
        """The contact with this past."""
        history = History(
            contact=scene,
            times=self.times,
            load=self._over_time(self.load, scene.load),
            speed=self._over_time(self.speed),
            separation=self._over_time(self.separation),
        )
        return replace(history(self.times[-1]), past=Past(history.life, self.times[-1]))

    def _over_time(
        self, values: tuple[float, ...] | None, scale: float = 1.0
    ) -> Interpolated | None:
        """Values straight between the times."""
        return None if values is None else Interpolated(self.times, values, scale)
