"""Ratings of a case as numbers by name: safeties by symbol, figures by key."""

from pyworm.case.case import Case
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import rating_request, ratings


def rated_values(case: Case) -> dict[str, float]:
    """Closed-form safeties and figures of a case; empty of one that no standard rates.

    Keys are symbols of safeties ("S_H") and keys of figures ("wear_depth_m"), which end in their unit.
    """
    try:
        request = rating_request(case)
    except CaseError:
        return {}
    found: dict[str, float] = {}
    for rating in ratings(request):
        for figure in rating.figures:
            value = figure.values[0]
            if isinstance(value, float | int):
                found.setdefault(figure.key, float(value))
        for safety in rating.safeties:
            if safety.value is not None:
                found[safety.symbol] = safety.value
    return found
