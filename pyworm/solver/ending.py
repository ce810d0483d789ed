"""Outcomes of a solve, each with its message."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Self

LESS_ACCURATE = "less accurate than requested"
"""Beginning of the message of a converged solution whose error bars are wider than asked for."""

_ACCURATE = "the results have the requested accuracy"


class Ending(StrEnum):
    """How a solve ended: a word for files, with a message whose places in braces are filled in.

    What is decided by it depends on the member alone, never on the message.
    """

    message: str
    """Sentence for the reader."""

    def __new__(cls, word: str, message: str) -> Self:
        """A member, equal to its word."""
        member = str.__new__(cls, word)
        member._value_ = word
        member.message = message
        return member

    ACCURATE = "accurate", _ACCURATE
    ACCURATE_BUT_FOR_SPIKE = (
        "accurate but for spike",
        f"{_ACCURATE} but for the maximum film temperature, the {{spike}}",
    )
    ACCURATE_BUT_FOR_CONDUCTION = (
        "accurate but for conduction",
        f"{_ACCURATE} but for temperatures, of which the approximation of conduction in the bodies leaves "
        "{error} of their rise",
    )
    WIDER_BARS = "wider bars", f"{LESS_ACCURATE}, {{error}}: {{reason}}"
    WIDER_BARS_OF_HEAT = (
        "wider bars of heat",
        f"{LESS_ACCURATE}, {{error}}, of temperatures more than {{widest}}: {{reason}}",
    )
    COARSER_REQUEST = (
        "coarser request",
        f"{LESS_ACCURATE}, {{error}}: requested {{accuracy}}, {{reason}}",
    )
    WINDOW_OF_FILM = (
        "window of film",
        "domain truncation error of the film {error}: enlarge the domain",
    )
    WINDOW_OF_HEAT = (
        "window of heat",
        "domain truncation error of heat conduction {error}: enlarge the domain",
    )
    NO_WIDER_FILM = (
        "no wider film",
        "no film was found in the wider domain, which shows the domain truncation error",
    )
    NO_SHEAR_STRESS = (
        "no shear stress",
        "the shear stress was not found in {places} places of the film",
    )
    NO_FILM = (
        "no film",
        "no film was found whose stresses and temperatures the laws of the oil bear",
    )
    NO_DRY_CONTACT = "no dry contact", "the dry contact did not converge"
    CIRCULATING = (
        "circulating",
        "no temperature was found of the oil that circulates in the wide inlet of a thick film",
    )
    RESIDUAL = "residual", "the residual stayed at {residual:.1e}, {tolerance:.1e} is required"
    NOT_RESOLVED = "not resolved", "the largest grid allowed does not resolve the film"
    NOT_COMPARED = (
        "not compared",
        "the largest grid allowed leaves no second grid, or domain, to compare with",
    )
    LARGEST_GRID = "largest grid", "the largest grid allowed leaves an error of {error}"
    BEYOND_REFINEMENT = (
        "beyond refinement",
        "grid refinement does not reduce the error of {error}: {sources}",
    )
    OUT_OF_REACH = (
        "out of reach",
        "the largest grid allowed would leave an error of at least {error}",
    )
    REFUSED_BY_PLAN = "refused by plan", "{reason}"
    RATE_OF_CHANGE = "rate of change", "{reason}"
    MEMORY = "memory", "{reason}"

    @property
    def accurate(self) -> bool:
        """Whether the figures have the accuracy asked for, as far as any grid gives it."""
        return self in _ACCURATE_ENDINGS

    @property
    def converged(self) -> bool:
        """Whether the figures may be trusted within their error bars, however wide."""
        return self.accurate or self in _WIDE_ENDINGS

    def stop(self, **words: str | float) -> "Stop":
        """The outcome of a solve with its message, whose places in braces are filled by words."""
        return Stop(self, self.message.format(**words))


_ACCURATE_ENDINGS = {
    Ending.ACCURATE,
    Ending.ACCURATE_BUT_FOR_SPIKE,
    Ending.ACCURATE_BUT_FOR_CONDUCTION,
}

_WIDE_ENDINGS = {Ending.WIDER_BARS, Ending.WIDER_BARS_OF_HEAT, Ending.COARSER_REQUEST}


@dataclass(frozen=True)
class Stop:
    """How one solve ended."""

    ending: Ending
    """The outcome, by which all else decides."""
    reason: str
    """Its message, for the reader."""
