"""The figures to which an accuracy refers, in words."""

from collections.abc import Sequence

from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import percent


def accuracy_words(accuracy: float, names: Sequence[str]) -> str:
    """An accuracy with the figures it refers to; empty where these are not known.

    Parameters
    ----------
    accuracy : float
        Relative error asked for [-].
    names : sequence of str
        Names of the figures, `Solution.accuracy_of`.
    """
    words = dict.fromkeys(QUANTITIES[name].words(("", "")).removesuffix(" ()") for name in names)
    return f"{percent(accuracy)} of {', '.join(words)}" if words else ""
