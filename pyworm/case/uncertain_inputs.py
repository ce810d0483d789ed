"""Inputs of a case file with their uncertainty, `roughness = "0.4 um +- 0.1 um"`.

They are read off before the tables are checked, which see the best estimates alone: any key with a number or
a quantity may have one. What follows the sign is the standard uncertainty of the GUM (JCGM 100:2008, 2.3.1),
one standard deviation; half of an expanded uncertainty with the coverage factor 2.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from pyworm.case.dotted_keys import with_values
from pyworm.io.input_error import CaseError, shortened
from pyworm.io.uncertain import Uncertain, parse_uncertain

TEXTS = ("title", "source", "published", "assumed")
"""Keys whose texts are no inputs."""

_UNCERTAIN = re.compile(r"\s*[+-]?\.?\d.*(\+-|\+/-|±|\sto\s).*")
"""A text that begins with a number and has an uncertainty."""


@dataclass(frozen=True)
class UncertainInputs:
    """Inputs that are uncertain, and how those of one fit hang together."""

    values: Mapping[str, Uncertain] = field(default_factory=dict)
    """Dotted key -> best estimate and standard uncertainty."""
    correlations: Mapping[tuple[str, str], float] = field(default_factory=dict)
    """Two dotted keys -> their correlation; all others are independent."""

    def correlation(self, first: str, second: str) -> float:
        """Correlation of two inputs."""
        if first == second:
            return 1.0
        known = self.correlations
        return known.get((first, second), known.get((second, first), 0.0))

    def moved(self, content: dict[str, Any], key: str, steps: float) -> dict[str, Any]:
        """The content of a case file with one input moved by some of its standard uncertainties."""
        return with_values(content, {key: self.values[key].moved(steps)})


def best_estimates(
    data: Mapping[str, Any], correlations: Mapping[tuple[str, str], float] | None = None
) -> tuple[dict[str, Any], UncertainInputs]:
    """The content of a case file with best estimates in place of uncertain inputs, and these.

    Raises:
        CaseError: An uncertainty of another kind than its value, or none at all.
    """
    found: dict[str, Uncertain] = {}
    for key, text in _texts({name: part for name, part in data.items() if name not in TEXTS}):
        try:
            found[key] = parse_uncertain(text)
        except ValueError as error:
            raise CaseError(f'{key} = "{shortened(text)}": {error}') from None
    estimates = {key: value.moved() for key, value in found.items()}
    uncertain = {key: value for key, value in found.items() if value.standard > 0}
    return with_values(dict(data), estimates), UncertainInputs(uncertain, correlations or {})


def _texts(value: Any, key: str = "") -> Iterator[tuple[str, str]]:
    """Dotted key and text of each uncertain input."""
    if isinstance(value, dict):
        for name, part in value.items():
            yield from _texts(part, f"{key}.{name}" if key else str(name))
    elif isinstance(value, list):
        for place, part in enumerate(value):
            yield from _texts(part, f"{key}[{place}]")
    elif isinstance(value, str) and _UNCERTAIN.fullmatch(value):
        yield key, value
