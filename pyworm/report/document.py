"""A page of HTML that needs nothing else: its style, its script and the policy that allows these alone."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pyworm.io.html import rendered
from pyworm.report.policy import policy


def document(template: str, style: Path, scripts: Sequence[Path] = (), **content: Any) -> str:
    """The page of a template that extends `layout.html`.

    Args:
        template: Its file, from the package's folder.
        style: Its style.
        scripts: Parts of its script in their order.
        **content: What the template shows.
    """
    from markupsafe import Markup

    css, script = (
        Markup("\n".join(file.read_text(encoding="utf-8") for file in files))
        for files in ([style], scripts)
    )
    allowed = policy(css, script if scripts else None)
    return rendered(template, policy=allowed, style=css, script=script, **content)
