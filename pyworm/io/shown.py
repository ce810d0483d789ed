"""Objects in words: a line on a terminal, a small table in a notebook."""

from dataclasses import dataclass, fields

from pyworm.io.given import quantities
from pyworm.io.html import rendered
from pyworm.io.quantity import Kind
from pyworm.io.quantity_text import as_text

MAX_LINE_LENGTH = 160
"""Characters of the line of an object."""


class Shown:
    """What has a short line (`repr`) and, in notebooks, a table, both from `shown`."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading, and what is shown beneath it by name."""
        raise NotImplementedError

    def __repr__(self) -> str:
        heading, rows = self.shown()
        line = f"<{heading}: {', '.join(f'{name} {value}' for name, value in rows.items())}>"
        return line if len(line) <= MAX_LINE_LENGTH else f"{line[: MAX_LINE_LENGTH - 4]}...>"

    def _repr_html_(self) -> str:
        heading, rows = self.shown()
        return rendered("io/shown.html", heading=heading, rows=rows)


@dataclass(frozen=True, eq=False, repr=False)
class ShownFields(Shown):
    """A dataclass that shows its fields beyond their defaults, quantities with units."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Name of the class, and its fields by name."""
        owner: type = type(self)
        kinds = quantities(owner)
        rows = {}
        for part in fields(self):
            value = getattr(self, part.name)
            if value is not None and value != part.default:
                kind, _ = kinds.get(part.name, (None, False))
                rows[part.name] = _text(value, kind)
        return owner.__name__, rows


def _text(value: object, kind: Kind | None) -> str:
    """A field in words: of several numbers how many there are, and the first and the last."""
    if isinstance(value, tuple):
        ends = [_text(end, kind) for end in (value[0], value[-1])] if kind else []
        return " to ".join(ends) + f" ({len(value)} values)" if ends else f"{len(value)} entries"
    if isinstance(value, bool | str) or not isinstance(value, int | float):
        return value if isinstance(value, str) else repr(value)
    return f"{value:.4g}" if kind is None else as_text(value, kind)
