"""Losses of a drive besides those between its teeth, with where they come from."""

from dataclasses import dataclass
from typing import Any

from pyworm.formulas.worm_losses import OtherLosses


@dataclass(frozen=True)
class NonMeshLosses:
    """Losses of a drive besides its teeth: by the worm standard or closed forms, or one number as given."""

    standard: OtherLosses | None = None
    """Churning, bearings and seals by the standard or closed forms."""
    bearings: str = ""
    """How the worm is held by the standard; empty of closed forms."""
    given: float = 0.0
    """The number [W], where there is no standard's."""

    @property
    def power(self) -> float:
        """All of them [W]."""
        return self.given if self.standard is None else self.standard.power

    @property
    def words(self) -> str:
        """What they are and where they come from, in a sentence."""
        if self.standard is None:
            return f"Bearings, seals and churning lose {self.given:.4g} W as given."
        losses = self.standard
        if not self.bearings:
            return (
                f"Besides the teeth {losses.power:.4g} W are estimated within a factor of 2: dipping gears "
                f"{losses.churning:.4g} W, bearings {losses.bearings:.4g} W, seals {losses.seals:.4g} W."
            )
        return (
            f"Besides the teeth {losses.power:.4g} W are assumed by the worm standard's regressions: "
            f"churning {losses.churning:.4g} W, bearings of a worm that is {self.bearings} "
            f"{losses.bearings:.4g} W, seals {losses.seals:.4g} W."
        )

    def summary(self) -> dict[str, Any]:
        """The losses as an object for JSON."""
        if self.standard is None:
            return {"other_W": self.given, "other_by": "given"}
        return {
            "other_W": self.power,
            "other_by": "standard" if self.bearings else "closed forms",
            "churning_W": self.standard.churning,
            "bearings_W": self.standard.bearings,
            "seals_W": self.standard.seals,
        }
