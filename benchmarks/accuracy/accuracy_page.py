"""Tables of docs/evidence/accuracy.md and other pages, written in their places."""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

PAGE = Path("docs/evidence/accuracy.md")


def markdown(rows: Iterable[Sequence[str]]) -> str:
    """A table, its first row the heading."""
    head, *body = rows
    lines = [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *body)]
    return "\n".join(lines)


def fill(name: str, text: str, path: Path = PAGE) -> None:
    """Put a table where a page has a comment of its name, in place of what is there."""
    begin, end = f"<!-- {name} -->", "<!-- end -->"
    page = path.read_text()
    if begin not in page:
        raise ValueError(f"{path} has no place for {name}")
    pattern = re.escape(begin) + ".*?" + re.escape(end)
    path.write_text(
        re.sub(pattern, lambda _: f"{begin}\n\n{text}\n\n{end}", page, count=1, flags=re.DOTALL)
    )
