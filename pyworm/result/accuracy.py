"""The figures to which an accuracy refers, in words."""

from collections.abc import Sequence

from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import percent


def accuracy_words(accuracy: float, names: Sequence[str]) -> str:
    """A relative accuracy with the figures (`Solution.accuracy_of`) it refers to; empty without any."""
    words = dict.fromkeys(QUANTITIES[name].words(("", "")).removesuffix(" ()") for name in names)
    return f"{percent(accuracy)} of {', '.join(words)}" if words else ""
