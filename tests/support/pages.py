"""What a page of the documentation has its reader write."""

import re

WRITTEN = re.compile(r"^`(\S+)`:\n\n```\w+\n(.*?)^```$", re.M | re.S)
"""The name of a file alone on its line, and what is to stand in it."""

REPLACED = re.compile(r"^In `(\S+)`:\n\n```\w+\n((\w+) = .*?)\n```$", re.M | re.S)
"""The name of a file, and the assignment that takes the place of its own."""


def files_written(page: str) -> dict[str, str]:
    """Files that a page has written whole: name -> content."""
    return dict(WRITTEN.findall(page))


def lines_replaced(page: str) -> list[tuple[str, str, str]]:
    """Lines that a page has changed: name of the file, the line, the name that it assigns."""
    return REPLACED.findall(page)
