"""A result as one page of HTML to explore, without network: its data, its script and its style inside."""

from pathlib import Path
from typing import Any

from pyworm.io.json import finite
from pyworm.report.document import document
from pyworm.report.explore.colours import FIELDS, FLANK, shown, used
from pyworm.report.explore.flank import flank
from pyworm.report.explore.scenes import reduced, scenes
from pyworm.report.explore.space import space
from pyworm.result.headline import headline, of_all
from pyworm.result.result import Result

_HERE = Path(__file__).parent

SCRIPTS = ("base.js", "map.js", "profiles.js", "flank.js", "space.js", "page.js")
"""Parts of the script in their order; each uses only those before it."""


def content(result: Result) -> dict[str, Any]:
    """What the script shows of a result with one solution at least."""
    grids = [reduced(solution) for solution in result.solutions]
    found, on_flank = scenes(result, grids), flank(result, grids)
    fields = shown(FIELDS, {name for scene in found for name in scene["fields"]}, result.body_names)
    maps = (
        {} if on_flank is None else shown(FLANK, set(on_flank["fields"]), result.body_names, True)
    )
    return {
        "bodies": result.body_names,
        "scenes": found,
        "fields": fields,
        "flank": on_flank,
        "maps": maps,
        "space": space(result, grids),
        "colours": used(fields, maps, shown(FIELDS, {"pressure"}, result.body_names)),
    }


def explore(result: Result) -> str:
    """The page."""
    words = " ".join(filter(None, (of_all(result.solutions).sentence, headline(result.solutions))))
    return document(
        "report/explore/page.html",
        _HERE / "page.css",
        [_HERE / name for name in SCRIPTS],
        title=result.case.get("title", result.case_name),
        source=result.case.get("source", ""),
        words=words,
        data=finite(content(result)),
    )
