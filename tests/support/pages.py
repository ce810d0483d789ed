"""What a page of the documentation has its reader write."""

import re

WRITTEN = re.compile(r"^`(\S+)`:\n\n```\w+\n(.*?)^```$", re.M | re.S)
"""The name of a file alone on its line, and what is to stand in it."""


def files_written(page: str) -> dict[str, str]:
    """Files that a page has written whole: name -> content."""
    return dict(WRITTEN.findall(page))
