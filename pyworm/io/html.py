"""HTML by templates in the package's folders; all text in them is escaped but what is marked as HTML."""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

PACKAGE = Path(__file__).parents[1]

GREEK = {
    "alpha": "α", "delta": "δ", "gamma": "γ", "lambda": "λ", "mu": "µ", "rho": "ρ", "sigma": "σ", "tau": "τ",
    "theta": "θ",
}  # fmt: skip
"""Greek letters of symbols by their names."""

_INDEXED = re.compile(rf"\b({'|'.join(GREEK)}|Ra|[A-Za-z])_([A-Za-z0-9]+(?:,[a-z]\b)?)(\*?)")
_ALONE = re.compile(r"\b(lambda|mu|sigma|gamma)\b")


@cache
def _templates() -> "Environment":
    # Late: a command without pages does without the library.
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    found = Environment(
        loader=FileSystemLoader(PACKAGE),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    found.filters["typeset"] = typeset
    found.policies["json.dumps_kwargs"] = {"separators": (",", ":")}
    return found


def rendered(template: str, **content: Any) -> str:
    """HTML by a template.

    Args:
        template: Its file, from the package's folder.
        **content: What it shows.
    """
    return _templates().get_template(template).render(**content)


def typeset(text: str) -> "Markup":
    """Text as HTML, its symbols in Greek and with their indices lowered: theta_B_C becomes θ with index B."""
    from markupsafe import Markup, escape

    lowered = _INDEXED.sub(_lowered, str(escape(text)))
    return Markup(_ALONE.sub(lambda found: GREEK[found[0]], lowered))


def _lowered(found: re.Match[str]) -> str:
    index = GREEK.get(found[2], found[2])
    return f"{GREEK.get(found[1], found[1])}<sub>{index}</sub>{found[3]}"
