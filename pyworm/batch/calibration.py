"""Fit values of a case to measurements by weighted least squares, economically.

The model is solved on a design about the start, a step of each parameter to both sides; a response surface
(`formulas.response_surface`) stands for it in the fit. The optimum is solved, the surface shifted to meet it,
and fitted again until the parameters stay within a tenth of their uncertainty. Where they go far, a new
design is made there, and also at an optimum far from the last one: uncertainties come from its slopes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy

from pyworm.batch.operating_points import (
    NotSolvedError,
    OperatingPoint,
    Results,
    Solving,
    quantities_for,
)
from pyworm.case.case import Case, case_without_contacts
from pyworm.case.dotted_keys import with_values
from pyworm.case.measured_table import Measurement
from pyworm.case.parameters import Parameter, with_parameters
from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.least_squares import LeastSquares
from pyworm.formulas.response_surface import STEP, ResponseSurface
from pyworm.io.input_error import CaseError

POWER_LAWS = ("film_central", "film_min", "friction_coefficient", "power_loss")
"""Responses that are positive and follow power laws."""

OF_HOUSINGS = ("unit_efficiency", "sump_temperature")
"""Results that need the thermal balance of a housing."""

OF_GEARS = ("efficiency", *OF_HOUSINGS)
"""Results that gears alone have."""

TRUST = 0.7
"""Logarithm of a parameter over the centre of a design up to which its surface is trusted: a factor of 2."""

LARGEST_EXTRAPOLATION = 1.5 * STEP
"""Logarithm of a parameter over the centre of a design up to which slopes of straight responses are taken
from there: they hold to 3 %, but only to a third at `TRUST`. Power laws keep theirs all the way."""

CONVERGED_CHANGE = 0.1
"""Change of a parameter over its standard uncertainty below which a fit has converged."""

MOST_FITS = 12
"""Maximum number of fits with a solve of each optimum."""

USUAL_FITS = 2
"""Usual number of them, for the expected time."""

AT_BOUND = 1e-6
"""Logarithm of a parameter over a bound below which it is held there."""


@dataclass(frozen=True)
class Bench:
    """Measurements of a case, and its parameters that are fitted to them."""

    case: Case
    """The case."""
    rows: tuple[Measurement, ...]
    """The measurements."""
    parameters: tuple[Parameter, ...]
    """What is fitted."""
    solving: Solving
    """How contacts are solved."""

    def __post_init__(self) -> None:
        count, unknown = len(self.rows), len(self.parameters)
        if count <= unknown:
            raise CaseError(
                f"{count} measured values cannot fix {unknown} parameters with an uncertainty: "
                f"at least {unknown + 1} are needed"
            )
        self._require_computed()
        keys = {key for parameter in self.parameters for key in parameter.keys}
        for row in self.rows:
            for key in keys & set(row.conditions):
                raise CaseError(
                    f"{key} is to be fitted and given as a condition; it cannot be both"
                )

    def _require_computed(self) -> None:
        """Refuse what no contact of the case can have, before any is solved."""
        for row in self.rows:
            if row.quantity in OF_GEARS and self.case.drive is None:
                raise CaseError(
                    f"measurements, line {row.line}: {row.quantity} is that of gears, and the case has none"
                )
            if row.quantity in OF_HOUSINGS and getattr(self.case.tables, "cooling", None) is None:
                raise CaseError(
                    f"measurements, line {row.line}: {row.quantity} needs [cooling] in the case"
                )

    @property
    def measured(self) -> Array:
        """Measured values [SI]."""
        return np.array([row.value for row in self.rows])

    @property
    def uncertainties(self) -> Array:
        """Their standard uncertainties [SI]."""
        return np.array([row.standard for row in self.rows])

    @property
    def logarithmic(self) -> Flags:
        """Which of them the surface takes by their logarithm."""
        return np.array([row.quantity in POWER_LAWS for row in self.rows])

    @cached_property
    def _settings(self) -> list[tuple[dict, dict, tuple[str, ...]]]:
        """Conditions and place of each operating point, and what was measured there."""
        found: dict[str, tuple[dict, dict, list[str]]] = {}
        for row in self.rows:
            key = repr((sorted(row.conditions.items()), sorted(row.place.items())))
            found.setdefault(key, (dict(row.conditions), dict(row.place), []))[2].append(
                row.quantity
            )
        return [(conditions, place, tuple(names)) for conditions, place, names in found.values()]

    @cached_property
    def _by_formula(self) -> list[bool]:
        """Of which operating points a formula gives the films; the same ones in all of a fit."""
        points = self._points_with(self.start, [False] * len(self._settings))
        return [self.solving.formula_suffices(point) for point in points]

    def points(self, values: Array) -> list[OperatingPoint]:
        """The operating points with values of the parameters [SI]; CaseError of one that there cannot be."""
        return self._points_with(values, self._by_formula)

    def _points_with(self, values: Array, by_formula: Sequence[bool]) -> list[OperatingPoint]:
        changed = with_values(self.case.content, with_parameters(self.parameters, list(values)))
        return [
            replace(self._point(changed, *setting), by_formula=formula)
            for setting, formula in zip(self._settings, by_formula, strict=True)
        ]

    def _point(
        self, content: dict, conditions: dict, place: dict, names: Sequence[str]
    ) -> OperatingPoint:
        try:
            case = case_without_contacts(
                with_values(content, conditions), self.case.name, self.case.directory
            )
            wanted = {name: [value] for name, value in place.items()}
            places = case.places(**wanted)
        except CaseError as error:
            row = next(
                row for row in self.rows if row.conditions == conditions and row.place == place
            )
            raise CaseError(f"measurements, line {row.line}: {error}") from error
        return OperatingPoint(case, places, quantities_for(names))

    def responses(self, every: Sequence[Array]) -> "list[Responses]":
        """What is measured, as computed with each of several sets of values; all are solved together.

        Raises:
            CaseError: Measured is what the case does not compute.
            NotSolvedError: A contact without a solution.
        """
        points = [point for values in every for point in self.points(values)]
        found = self.solving.results(points)
        count = len(self._settings)
        return [
            self._of_rows(found[number * count : (number + 1) * count])
            for number in range(len(every))
        ]

    def _of_rows(self, found: Sequence[Results]) -> "Responses":
        places = [(conditions, place) for conditions, place, _ in self._settings]
        computed = []
        for row in self.rows:
            results = found[places.index((dict(row.conditions), dict(row.place)))]
            if row.quantity not in results:
                raise CaseError(
                    f"measurements, line {row.line}: {self.case.name} does not compute {row.quantity} there; "
                    f"it has {', '.join(results) or 'no results'}"
                )
            computed.append(results[row.quantity])
        return Responses(
            np.array([each.value for each in computed]), np.array([each.error for each in computed])
        )

    @property
    def expected_seconds(self) -> float:
        """Expected CPU time of a fit [s]."""
        solves = 1 + 2 * len(self.parameters) + USUAL_FITS
        return solves * self.solving.expected_seconds(self.points(self.start))

    @property
    def solves(self) -> int:
        """Expected number of operating points that are solved."""
        return (1 + 2 * len(self.parameters) + USUAL_FITS) * len(self._settings)

    @property
    def start(self) -> Array:
        """Values of the case [SI]."""
        return np.array([parameter.start for parameter in self.parameters])

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds [SI]."""
        low = np.array([parameter.low for parameter in self.parameters])
        return low, np.array([parameter.high for parameter in self.parameters])


@dataclass(frozen=True)
class Responses:
    """Computed values at the measurements, and their numerical uncertainty."""

    values: Array
    """The values [SI]."""
    errors: Array
    """Their numerical uncertainty [SI], a 95 % bound."""


@dataclass(frozen=True)
class BenchFit:
    """Values that fit measurements, and the surface with which they were found."""

    bench: Bench
    """The measurements."""
    centre: Array
    """Values at the centre of the surface [SI]."""
    surface: ResponseSurface
    """Responses about it; through a solve at the optimum."""
    place: Array
    """Logarithms of the fitted values over the centre."""
    before: Array
    """Computed with the values of the case, at the measurements [SI]."""
    errors: Array
    """Numerical uncertainty of the computed values at the optimum [SI]."""

    @property
    def numerical(self) -> float:
        """Largest standard numerical uncertainty over that of its measurement."""
        return float(np.max(self.errors / 2 / self.bench.uncertainties))

    @property
    def values(self) -> Array:
        """The fitted values [SI]."""
        found: Array = self.centre * np.exp(self.place)
        return found

    @property
    def responses(self) -> Array:
        """Computed with them, at the measurements [SI]."""
        return self.surface.responses(self.place)

    @property
    def at_bound(self) -> tuple[bool, ...]:
        """Which parameters are held at a bound."""
        low, high = (np.log(bound / self.values) for bound in self.bench.bounds)
        return tuple((np.minimum(-low, high) < AT_BOUND).tolist())

    @cached_property
    def statistics(self) -> LeastSquares:
        """Uncertainties and correlations."""
        return LeastSquares(
            values=self.values,
            sensitivity=self.surface.sensitivity(self.place) / self.values,
            residuals=self.bench.measured - self.responses,
            uncertainties=self.bench.uncertainties,
            fixed=self.at_bound,
        )

    @cached_property
    def leave_one_out(self) -> Array:
        """Each measurement less its prediction by a fit to all others [SI]."""
        found = []
        for row, measured in enumerate(self.bench.measured):
            others = np.arange(len(self.bench.rows)) != row
            place = _optimum(self.bench, self.surface, self.centre, self.place, others)
            found.append(measured - self.surface.responses(place)[row])
        return np.array(found)


def fitted(bench: Bench) -> BenchFit:
    """The values that fit measurements best.

    Raises:
        CaseError: Measured is what the case does not compute, or a point that there cannot be.
        NotSolvedError: A contact without a solution, or a fit that does not end.
    """
    centre = bench.start
    surface = _design(bench, centre)
    before = surface.responses(np.zeros(len(centre)))
    place = np.zeros(len(centre))
    for _ in range(MOST_FITS):
        found = _optimum(bench, surface, centre, place)
        (solved,) = bench.responses([centre * np.exp(found)])
        surface = surface.through_also(found, solved.values)
        again = _optimum(bench, surface, centre, found)
        fit = BenchFit(bench, centre, surface, again, before, solved.errors)
        far = np.abs(fit.place) > TRUST * (1 - 1e-6)
        if far.any() and not _held(fit, far):
            centre, place = fit.values, np.zeros(len(centre))
            surface = _design(bench, centre)
            continue
        uncertain = fit.statistics.standard / fit.values
        moved = np.abs(fit.place - found)
        if (moved <= np.maximum(CONVERGED_CHANGE * uncertain, AT_BOUND)).all():
            if not _extrapolated(fit):
                return replace(fit, place=found)
            # a step about a bound may be beyond what is possible
            held = np.array(fit.at_bound)
            centre, place = np.where(held, centre, fit.values), np.where(held, fit.place, 0.0)
            surface = _design(bench, centre)
            continue
        place = fit.place
    raise NotSolvedError(f"the fit did not converge in {MOST_FITS} steps: bounds may be too wide")


def _held(fit: BenchFit, far: Flags) -> bool:
    """Whether the parameters that went far are at a bound."""
    return bool(np.array(fit.at_bound)[far].all())


def _extrapolated(fit: BenchFit) -> bool:
    """Whether uncertainties would come from slopes that hold only near the centre."""
    far = (np.abs(fit.place) > LARGEST_EXTRAPOLATION) & ~np.array(fit.at_bound)
    return bool(far.any() and not fit.bench.logarithmic.all())


def _design(bench: Bench, centre: Array) -> ResponseSurface:
    """The surface about a centre, from solves of it and of a step of each parameter to both sides."""
    steps = np.eye(len(centre)) * STEP
    every = [
        centre,
        *(centre * np.exp(-step) for step in steps),
        *(centre * np.exp(step) for step in steps),
    ]
    mid, *sides = (found.values for found in bench.responses(every))
    less, more = (np.array(side).T for side in (sides[: len(centre)], sides[len(centre) :]))
    return ResponseSurface.through(mid, less, more, bench.logarithmic)


def _optimum(
    bench: Bench,
    surface: ResponseSurface,
    centre: Array,
    start: Array,
    chosen: Flags | slice = slice(None),
) -> Array:
    """Logarithms over the centre that fit chosen measurements best, within bounds and trust."""
    low, high = (np.log(bound / centre) for bound in bench.bounds)
    low, high = np.maximum(low, -TRUST), np.minimum(high, TRUST)
    weights = 1 / bench.uncertainties[chosen]

    def residuals(place: Array) -> Array:
        return (surface.responses(place)[chosen] - bench.measured[chosen]) * weights

    def sensitivity(place: Array) -> Array:
        return surface.sensitivity(place)[chosen] * weights[:, None]

    found = scipy.optimize.least_squares(
        residuals,
        np.clip(start, low + 1e-9, high - 1e-9),
        sensitivity,
        (low, high),
        xtol=1e-10,
        ftol=1e-12,
    )
    ends = np.where(found.active_mask < 0, low, np.where(found.active_mask > 0, high, found.x))
    return np.asarray(ends)
