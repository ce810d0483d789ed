"""Sensitivity of film and pressure to oil grade, temperature and misalignment, by closed forms.

Each variation changes the closed-form film of every solved contact; the simulated film is taken to change by
the same fraction. Nothing is solved again.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import isnan, nan

from pyworm.case.case import Case
from pyworm.case.contact import GapCase
from pyworm.drives.answers import DryContact, MountingError
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.io.quantities import QUANTITIES
from pyworm.materials.oil import Oil
from pyworm.materials.tabulated import TabulatedViscosity
from pyworm.report.findings import Findings
from pyworm.report.page.content import Block, Section
from pyworm.report.table import Table
from pyworm.result.result import Result
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.scales import LineScales, Scales, line_scales, scales

GRADE_STEP = 10 ** (1 / 6)
"""Ratio of the viscosities at 40 degC of neighbouring grades of ISO 3448, on average."""

WARMER = 10.0
"""Change of the oil's temperature [K]."""


@dataclass(frozen=True)
class Variation:
    """Variation of one input."""

    label: str
    """What is varied."""
    film: float
    """Minimum film thickness of all contacts that follows [m]; nan, as its ratio, where there is no contact,
    or one comes to rest on an edge, for which there is no closed form."""
    film_ratio: float
    """Film there over what it was [-]."""
    pressure_ratio: float
    """Largest dry pressure of all contacts over what it was [-]."""
    note: str = ""
    """What else it does."""


@dataclass(frozen=True)
class Sensitivity:
    """What changes of oil and mounting do to a result."""

    variations: tuple[Variation, ...]
    """One change at a time."""
    mounting: str | None
    """How those of mounting were found, a sentence; None of a contact without a drive."""


def sensitivity_section(found: Findings) -> Section | None:
    """The variations of a case as a table; None without a film, and of a gap whose file is not kept."""
    case, result = found.case, found.sound
    if isinstance(case.tables, GapCase) or not result.solutions:
        return None
    changes = sensitivity(case, result)
    roughness = found.composite_roughness
    film = QUANTITIES["film_min"]
    thinnest = min(solution.figures.film_min.value for solution in result.solutions)
    rows = [("as it is", film.text(thinnest), "", *_lambda(thinnest, roughness), "", "")]
    rows += [
        (
            variation.label,
            "" if isnan(variation.film) else film.text(variation.film),
            _change(variation.film_ratio),
            *_lambda(variation.film, roughness),
            _change(variation.pressure_ratio),
            variation.note,
        )
        for variation in changes.variations
    ]
    ratio = (QUANTITIES["specific_film"].symbol,) if roughness else ()
    dry = QUANTITIES["dry_pressure"]
    head = ("", film.title(), "change", *ratio, dry.words(), "")
    words = (
        "By closed forms, not solved again: at each solved contact the simulated film is changed by the "
        "fraction by which the minimum film thickness of the atlas changes, outside its box the film of "
        "Nijenbanning, Venner and Moes (point), or that of Moes (line contact). One grade is a factor of "
        f"{GRADE_STEP:.2f} in viscosity at one temperature; temperatures are those of the oil at the inlet, "
        "by the case's own law of viscosity."
    )
    blocks: list[Block] = [Table(head, tuple(rows)), words]
    if changes.mounting is not None:
        blocks.append(changes.mounting)
    return Section("Sensitivity", tuple(blocks))


def _change(ratio: float) -> str:
    """A change in percent; nothing where there is none."""
    return "" if isnan(ratio) or abs(ratio - 1) < 1e-9 else f"{(ratio - 1) * 100:+.1f} %"


def _lambda(film: float, roughness: float | None) -> tuple[str, ...]:
    if not roughness:
        return ()
    return ("" if isnan(film) else f"{film / roughness:.3g}",)


def sensitivity(case: Case, result: Result) -> Sensitivity:
    """Film and pressure of every variation for which the case has the data."""
    films = tuple(solution.figures.film_min.value for solution in result.solutions)
    solved = _Solved(
        tuple(case.scene(**ContactIndex.of(solution).given) for solution in result.solutions), films
    )
    if case.drive is None:
        return Sensitivity(tuple(_of_oil(solved)), None)
    misalignment = case.drive.misalignment(solved.contacts)
    misassembled = (solved.misassembled(error, misalignment.dry) for error in misalignment.errors)
    return Sensitivity((*_of_oil(solved), *misassembled), misalignment.method)


@dataclass(frozen=True)
class _Solved:
    """Solved contacts with their least films [m]."""

    contacts: tuple[AnyContact, ...]
    films: tuple[float, ...]

    def changed(self, label: str, contacts: Sequence[AnyContact], note: str = "") -> Variation:
        """What other contacts make of these films."""
        ratios = [_film_change(old, new) for old, new in zip(self.contacts, contacts, strict=True)]
        films = [film * ratio for film, ratio in zip(self.films, ratios, strict=True)]
        before, after = (
            max(_sizes(contact).hertz.pressure_max for contact in group)
            for group in (self.contacts, contacts)
        )
        return Variation(
            label=label,
            film=min(films),
            film_ratio=min(films) / min(self.films),
            pressure_ratio=after / before,
            note=note,
        )

    def misassembled(self, error: MountingError, before: tuple[DryContact, ...]) -> Variation:
        """What an error of mounting makes of them, and of their dry contacts without it."""
        if not error.contacts:
            return Variation(error.label, nan, nan, nan, error.note)
        if not before:
            return self.changed(error.label, error.contacts, error.note)
        kept = [
            old if dry.at_edge else new
            for old, new, dry in zip(self.contacts, error.contacts, before, strict=True)
        ]
        found = self.changed(error.label, kept, error.note)
        largest = [max(dry.pressure_max for dry in group) for group in (before, error.dry)]
        found = replace(found, pressure_ratio=largest[1] / largest[0])
        if any(new.at_edge and not old.at_edge for old, new in zip(before, error.dry, strict=True)):
            return replace(found, film=nan, film_ratio=nan)
        return found


def _of_oil(solved: _Solved) -> Iterator[Variation]:
    """Other grades, and other temperatures where the oil's viscosity knows them."""

    def with_oil(label: str, change: Callable[[Oil], Oil]) -> Variation:
        return solved.changed(
            label, [replace(contact, oil=change(contact.oil)) for contact in solved.contacts]
        )

    yield with_oil("one grade thinner", lambda oil: thickened(oil, 1 / GRADE_STEP))
    yield with_oil("one grade thicker", lambda oil: thickened(oil, GRADE_STEP))
    if solved.contacts[0].oil.heat is not None:
        yield with_oil(f"oil {WARMER:g} K cooler", lambda oil: oil.warmed(-WARMER))
        yield with_oil(f"oil {WARMER:g} K warmer", lambda oil: oil.warmed(WARMER))


def _sizes(scene: AnyContact) -> Scales | LineScales:
    return line_scales(scene) if isinstance(scene, LineScene) else scales(scene)


def _film_change(before: AnyContact, after: AnyContact) -> float:
    """Film of a contact over that of another, both by one formula.

    The least film by the atlas where that has both contacts, else Nijenbanning, Venner and Moes' central one:
    beyond its box the atlas is nearer to films, but not to their changes (docs/reference/atlas.md).
    """
    old, new = _sizes(before), _sizes(after)
    if isinstance(old, LineScales) or isinstance(new, LineScales):
        return new.film / old.film
    if before.oil.supply is not None or (old.inside_atlas and new.inside_atlas):
        return new.least * new.film / (old.least * old.film)
    changed, known = (nijenbanning_venner_moes(sizes.groups).central_number for sizes in (new, old))
    return changed / known


def thickened(oil: Oil, ratio: float) -> Oil:
    """The oil with another viscosity at ambient pressure, alpha being kept."""
    law = oil.viscosity
    if isinstance(law, TabulatedViscosity):
        return replace(oil, viscosity=replace(law, values=law.values * ratio))
    return replace(oil, viscosity=law.with_eta0(law.eta0 * ratio))
