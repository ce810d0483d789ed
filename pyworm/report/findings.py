"""What a report shows, asked once at its door: case, sound result, ratings, mesh loss, effects left out."""

from dataclasses import dataclass
from functools import cached_property

from pyworm.case.case import Case, case_again
from pyworm.case.kinds import rated
from pyworm.case.ratings import RatedCase
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.io.input_error import CaseError
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.rated_case import not_rated, rating_request, ratings
from pyworm.ratings.rating import Rating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss, standard_loss
from pyworm.result.headline import of_all, opening
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects


@dataclass(frozen=True)
class Findings:
    """All that the sections of a report show."""

    case: Case
    """The case, which may be another than the solved one, such as one with other ratings."""
    result: Result
    """Every contact that was solved."""
    sound: Result
    """Those that converged."""
    ratings: tuple[Rating, ...]
    """Ratings that the case asks for."""
    not_rated: tuple[str, ...]
    """What is not rated, with the reason."""
    standard: StandardLoss | NoStandard
    """Loss between the teeth by a standard."""
    mesh_loss: MeshLoss | None
    """Simulated loss of a whole mesh cycle; None where it is not known."""
    neglected_effects: NeglectedEffects
    """Effects left out of the figures, at the worst of the contacts."""

    @cached_property
    def composite_roughness(self) -> float | None:
        """Composite roughness of the surfaces [m], where it is known."""
        solutions = self.result.solutions
        return solutions[0].composite_roughness if solutions else None

    def opening(self) -> list[str]:
        """Sentences before any figure."""
        solutions, beyond = self.result.solutions, self.case.beyond_limits
        return opening(solutions, self.standard.words, beyond)


def findings(result: Result, case: Case | None = None) -> Findings:
    """The findings of a result, by its case or another one; CaseError if this version does not know it."""
    case = case or case_again(result.case)
    possible, lacking = _rated(case, result)
    return Findings(
        case=case,
        result=result,
        sound=result.sound,
        ratings=possible,
        not_rated=lacking,
        standard=standard_loss(case),
        mesh_loss=mesh_loss(case.drive, result),
        neglected_effects=of_all(result.solutions),
    )


def _rated(case: Case, result: Result) -> tuple[tuple[Rating, ...], tuple[str, ...]]:
    """The ratings of a case, and those left out with the reason."""
    if case.drive is None:
        return (), ()
    if not isinstance(case.tables, RatedCase):
        kinds = ", ".join(rated())
        return (), (f"Gears, scuffing and bearings: only drives of kind {kinds} are rated.",)
    try:
        request = rating_request(case)
        possible = ratings(request, result)
    except CaseError as error:
        return (), (f"Not rated: {error}.",)
    return possible, not_rated(request, possible)
