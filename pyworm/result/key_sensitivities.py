"""Sensitivities of the results of a case to the numbers of its file."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pyworm.io.shown import Shown

if TYPE_CHECKING:
    from pyworm.result.result import Result


IN_PROVENANCE = "sensitivities"
"""Entry of a result's provenance."""


@dataclass(frozen=True)
class KeySensitivity:
    """Derivatives of results with respect to one number of a case file."""

    key: str
    """Dotted key."""
    value: float
    """Its value [unit]."""
    unit: str
    """Unit of the number, empty without one."""
    change: float
    """Change for which `changes` are [unit]."""
    change_words: str
    """That change in words: "0.1 mm"."""
    derivatives: dict[str, float]
    """Name of a result -> its derivative [SI unit of the result over the unit of the number]."""

    def change_of(self, name: str) -> float:
        """Change of a result that goes with `change`, to first order [SI]."""
        return self.derivatives[name] * self.change


@dataclass(frozen=True, repr=False)
class KeySensitivities(Shown):
    """Derivatives of the results of a case with respect to all numbers of its file."""

    case_name: str
    """Name of the case."""
    results: dict[str, float]
    """Name -> result [SI; ratings by the unit at the end of their name]."""
    keys: tuple[KeySensitivity, ...]
    """One for each number that changes a result."""
    not_varied: dict[str, str]
    """Key of a number that cannot be changed alone -> why, a clause."""
    method: str
    """How figures of contacts were differentiated, a sentence."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows in words."""
        return f"Sensitivities of {self.case_name}", {
            "results": f"{len(self.results)}",
            "numbers": f"{len(self.keys)}",
        }

    def __getitem__(self, key: str) -> KeySensitivity:
        """The sensitivity to a number by its dotted key; KeyError without it."""
        for found in self.keys:
            if found.key == key:
                return found
        raise KeyError(key)

    def relative_change(self, key: str, name: str) -> float:
        """Relative change of a result with the change of a number that tables show, to first order [-]."""
        return self[key].change_of(name) / self.results[name]

    def summary(self) -> dict[str, Any]:
        """All of it as an object."""
        return {
            "case": self.case_name,
            "method": self.method,
            "results": self.results,
            "keys": {
                found.key: {
                    "value": found.value,
                    "unit": found.unit,
                    "change": found.change_words,
                    "step": found.change,
                    "derivatives": found.derivatives,
                    "changes": {name: found.change_of(name) for name in found.derivatives},
                }
                for found in self.keys
            },
            "not_varied": self.not_varied,
        }


def sensitivities_in(result: "Result") -> KeySensitivities | None:
    """The sensitivities that a result holds; None without them."""
    kept = result.provenance.get(IN_PROVENANCE)
    if kept is None:
        return None
    return KeySensitivities(
        kept["case"],
        kept["results"],
        tuple(
            KeySensitivity(
                key, part["value"], part["unit"], part["step"], part["change"], part["derivatives"]
            )
            for key, part in kept["keys"].items()
        ),
        kept["not_varied"],
        kept["method"],
    )
