"""Content security policy of pages: a browser runs and loads what is in the page, and nothing else."""

from base64 import b64encode
from hashlib import sha256


def policy(style: str, script: str | None = None) -> str:
    """What allows a page its own style, script and pictures alone; its tag stands before them.

    Words of a result or a case (titles, sources, warnings) can then neither run as a script nor fetch
    anything, even if one were not escaped. Script and style, all that stands between their tags, are known by
    their digests (Content Security Policy Level 3, section 2.3.1), so that none needs an address or a server.
    """
    allowed = {
        "default-src": "'none'",
        "style-src": _digest(style),
        "img-src": "data:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    if script is not None:
        allowed["script-src"] = _digest(script)
    return "; ".join(f"{what} {source}" for what, source in allowed.items())


def _digest(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode('utf-8')).digest()).decode('ascii')}'"
