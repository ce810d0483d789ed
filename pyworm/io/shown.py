"""Objects in words: a line on a terminal, a small table in a notebook."""

from html import escape

LONGEST = 160
"""Characters of the line of an object."""


class Shown:
    """What has a short line (`repr`) and, in notebooks, a table, both from `shown`."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading, and what is shown beneath it by name."""
        raise NotImplementedError

    def __repr__(self) -> str:
        heading, rows = self.shown()
        line = f"<{heading}: {', '.join(f'{name} {value}' for name, value in rows.items())}>"
        return line if len(line) <= LONGEST else f"{line[: LONGEST - 4]}...>"

    def _repr_html_(self) -> str:
        heading, rows = self.shown()
        body = "".join(
            f"<tr><th style='text-align:left'>{escape(name)}</th>"
            f"<td style='text-align:left'>{escape(value)}</td></tr>"
            for name, value in rows.items()
        )
        return f"<table><caption>{escape(heading)}</caption>{body}</table>"
