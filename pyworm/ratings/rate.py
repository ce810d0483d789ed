"""Ratings of a case by standards and closed forms, next to its simulated result."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any
from warnings import warn

from pyworm.case.case import Case, load
from pyworm.case.workshop_units import assumptions
from pyworm.io.input_error import CaseError
from pyworm.io.shown import Shown
from pyworm.io.stage import stage
from pyworm.ratings.rated_case import (
    RatingRequest,
    load_rating_request,
    neglected_effects,
    not_rated,
    rating_request,
    ratings,
    unconverged,
)
from pyworm.ratings.rating import Rating
from pyworm.result.result import Result
from pyworm.result.result_case import as_solved_in
from pyworm.scene.plausibility import UnusualWarning
from pyworm.solver.neglected_effects import NeglectedEffects


@dataclass(frozen=True, repr=False)
class CaseRatings(Shown):
    """Every rating of a case that is possible; iterating gives them."""

    request: RatingRequest
    """The case with its requests for ratings."""
    ratings: tuple[Rating, ...]
    """Ratings, each with its figures and safeties."""
    neglected_effects: NeglectedEffects
    """Effects that the simulated figures neglect; without any, the lubrication by closed forms."""
    not_rated: tuple[str, ...]
    """What is not rated, each with the reason."""
    not_converged: tuple[str, ...]
    """Contacts of the result that did not converge and are not included, a sentence each."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading, and of each rating its safeties."""
        return f"Ratings of {self.request.name}", {
            rating.title: ", ".join(
                f"{safety.symbol} {safety.shown or safety.verdict}" for safety in rating.safeties
            )
            or f"{len(rating.figures)} figures"
            for rating in self.ratings
        }

    def __iter__(self) -> Iterator[Rating]:
        """The ratings."""
        return iter(self.ratings)

    def __getitem__(self, key: str) -> Rating:
        """The rating of a key, such as "worm_gear"; KeyError with those that there are."""
        for rating in self.ratings:
            if rating.key == key:
                return rating
        raise KeyError(f"{key}: must be one of {', '.join(rating.key for rating in self.ratings)}")

    @cached_property
    def assumptions(self) -> dict[str, str]:
        """Values that the source does not give -> why they are what they are."""
        return assumptions(self.request.tables)

    def summary(self) -> dict[str, Any]:
        """All of it as one object, as `pyworm rate --json` prints it."""
        return {
            "case": self.request.name,
            **self.neglected_effects.summary(),
            "ratings": [rating.summary() for rating in self.ratings],
            "not_rated": self.not_rated,
            "warnings": self.request.warnings,
            "beyond_limits": self.request.beyond_limits,
            "not_converged": self.not_converged,
            "assumed": self.request.tables.assumed,
        }


def rate(case: Case | str | Path | Mapping[str, Any], result: Result | None = None) -> CaseRatings:
    """Rate a case by standards and closed forms, as the command `pyworm rate`.

    Args:
        case: A gear set or another case of `pyworm.load`, its file or tables, or those of ratings alone,
            such as of bearings.
        result: Simulated result of the same gears (`pyworm.run`), for comparison.

    Raises:
        CaseError: Invalid input, no rating that is requested or possible, or a result of another case.
    """
    if result is not None:
        case = case if isinstance(case, Case) else load(case)
        case, _ = as_solved_in(case, case.name, result)
    request = rating_request(case) if isinstance(case, Case) else load_rating_request(case)
    for sentence in request.warnings:
        warn(f"{request.name}: {sentence}", UnusualWarning, stacklevel=2)
    return rated(request, result, request.name)


def rated(request: RatingRequest, result: Result | None, name: object) -> CaseRatings:
    """The ratings that a case asks for; CaseError with its name if there is none."""
    with stage(f"rating {request.name}"):
        found = ratings(request, result)
        lacking = neglected_effects(request, result)
    left = not_rated(request, found) if found or request.rating_is_asked else ()
    if not found:
        reason = next(iter(left), "no rating is requested; give [worm_rating] or [bearings.NAME]")
        raise CaseError(f"{name}: {reason}")
    return CaseRatings(request, found, lacking, left, unconverged(result))
