"""Rows of tables that a page shows, compared with those that a command prints."""

import re

import pytest

NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]\d+)?")


def numbers(text: str) -> list[float]:
    """Numbers of a text."""
    return [float(number) for number in NUMBER.findall(text)]


def same_row(shown: str, printed: str, value: float = 1e-3, others: float = 0.02) -> bool:
    """Whether words are the same, the first number by a relative `value` and the others by `others`."""
    first, *bars = numbers(shown) or [0.0]
    found, *printed_bars = numbers(printed) or [0.0]
    words = [" ".join(NUMBER.sub("#", row).replace("│", " ").split()) for row in (shown, printed)]
    return (
        words[0] == words[1]
        and found == pytest.approx(first, rel=value)
        and printed_bars == pytest.approx(bars, rel=others)
    )
