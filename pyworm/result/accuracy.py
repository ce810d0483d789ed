"""The figures to which an accuracy refers, in words."""

from collections.abc import Sequence

from pyworm.io.format import percent

_WORDS = {
    "film_min": "minimum film",
    "film_central": "central film",
    "friction_coefficient": "friction coefficient",
    "temperature_max_body_1": "maximum surface temperatures",
    "temperature_max_body_2": "maximum surface temperatures",
    "temperature_max_film": "maximum film temperature",
}
"""Figures of `pyworm.planning.target.Aim` -> what they are called; never the maximum pressure."""


def accuracy_words(accuracy: float, names: Sequence[str]) -> str:
    """An accuracy with the figures it refers to; empty where these are not known.

    Parameters
    ----------
    accuracy : float
        Relative error asked for [-].
    names : sequence of str
        Names of the figures, `Solution.accuracy_of`.
    """
    words = dict.fromkeys(_WORDS[name] for name in names)
    return f"{percent(accuracy)} of {', '.join(words)}" if words else ""
