"""Pictures of a result for its report, as PNG in memory."""

from collections.abc import Callable, Iterable
from functools import partial
from io import BytesIO

from matplotlib.figure import Figure

from pyworm.io.quantities import QUANTITIES
from pyworm.io.reason import reason_of
from pyworm.plots.draw import KEY_PICTURES, SCENE_PICTURES, has_picture, scene_picture
from pyworm.plots.drives.picture import cycle_pictures
from pyworm.plots.regimes import draw_regimes
from pyworm.plots.traction import draw_traction, traction_curve
from pyworm.report.findings import Findings
from pyworm.report.page.content import Picture, Section
from pyworm.report.page.figures import place_of
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects
from pyworm.solver.solution import Solution

DOTS_PER_INCH = 100
"""Fewer than of pictures in files: a report holds them all."""

MOST_CONTACTS = 12
"""Contacts beyond which only the one with the thinnest film is shown."""

_CAPTIONS = {
    "gap": "Undeformed gap",
    "entrainment": "Entrainment",
    "profiles": "Film and pressure along the contact",
    "history": "How the solution converged",
    "friction": "Friction",
    "temperature": "Temperatures",
    "across_film": "Across the film where it is hottest",
    "supply": "Lubricant supply",
    "stress": "Stress below the surface",
}


def signed_pictures(found: Findings) -> tuple[Picture | str, ...]:
    """Pictures of the mesh cycle that belong to what is signed."""
    return tuple(_of_cycle(found, signed=True))


def _of_cycle(found: Findings, signed: bool) -> list[Picture | str]:
    return _those_drawn(
        _drawn(
            _captioned(picture.caption, found.neglected_effects),
            partial(picture.draw, found.result),
        )
        for picture in cycle_pictures(found.result).values()
        if picture.signed is signed
    )


def _those_drawn(drawn: Iterable[Picture | str | None]) -> list[Picture | str]:
    """Pictures without those of which there is nothing to draw."""
    return [picture for picture in drawn if picture is not None]


def cycle_section(found: Findings, signed: bool) -> Section | None:
    """Pictures of the whole mesh cycle or traction curve; None where there are none.

    Args:
        found: The findings of the report.
        signed: Whether those that belong to what is signed stand elsewhere.
    """
    pictures = _of_cycle(found, signed=False)
    if not signed:
        pictures += _of_cycle(found, signed=True)
    if traction_curve(found.result):
        caption = _captioned("Traction curve", found.neglected_effects)
        pictures += _those_drawn([_drawn(caption, partial(draw_traction, found.result))])
    return Section("The whole cycle", tuple(pictures)) if pictures else None


def contact_section(result: Result) -> Section:
    """Pictures: regimes of all contacts, all of the thinnest contact, the most important of the others."""
    solutions = result.solutions
    thin = solutions[result.thinnest]
    shown = solutions if len(solutions) <= MOST_CONTACTS else (thin,)
    pictures = [_drawn("Contacts on the chart of regimes", partial(draw_regimes, result))]
    for solution in shown:
        names = SCENE_PICTURES[solution.kind] if solution is thin else KEY_PICTURES[solution.kind]
        pictures += [
            _picture(result, solution, name) for name in names if has_picture(solution, name)
        ]
    return Section("Contacts", tuple(_those_drawn(pictures)))


def _picture(result: Result, solution: Solution, name: str) -> Picture | str | None:
    caption = f"{_CAPTIONS.get(name) or QUANTITIES[name].title()}, {place_of(solution)}"
    return _drawn(
        _captioned(caption, solution.neglected_effects), scene_picture(result, solution, name)
    )


def _drawn(caption: str, draw: Callable[[], Figure | None]) -> Picture | str | None:
    """A picture, or the reason why it failed; None where there is nothing to draw."""
    try:
        figure = draw()
        return None if figure is None else Picture(caption, png(figure))
    except Exception as error:
        return f"{caption}: could not be drawn ({reason_of(error)})."


def _captioned(caption: str, neglected_effects: NeglectedEffects) -> str:
    """A caption with the effects left out."""
    return f"{caption}; {neglected_effects.words}" if neglected_effects.words else caption


def png(figure: Figure) -> bytes:
    """A figure as PNG."""
    content = BytesIO()
    figure.savefig(content, format="png", dpi=DOTS_PER_INCH)
    return content.getvalue()
