"""A figure with its error bar, and calculation with it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, inf, isinf, isnan
from typing import Any, TypeVar

from pyworm.io.quantities import Quantity
from pyworm.io.quantity_text import percent, with_bars

ORIGINS = ("grid", "domain", "algebra", "approximation")
"""Attributes that make up an error bar."""


Combined = TypeVar("Combined")
"""What two figures make: another one, or a comparison."""


@dataclass(frozen=True, repr=False)
class Estimate:
    """A figure, its relative error by origin (`pyworm.solver.error_estimate`), and its model uncertainty."""

    value: float
    """The figure in SI units, extrapolated to infinitely fine grids and an infinite domain where it can be
    (`pyworm.solver.grid_limit`, `pyworm.solver.window_limit`)."""
    grid: float
    """Discretisation error, from grids of halving spacing [-]."""
    domain: float = 0.0
    """Domain truncation error, from a domain of twice the size [-]."""
    algebra: float = 0.0
    """Algebraic error by stopping the Newton iteration [-]."""
    approximation: float = 0.0
    """Error of a temperature by the approximation of conduction in the bodies
    (`fortran/heat/conduction_model.f90`), of all results by the levels across the film and, where it is
    transient, by the integration in time (`pyworm.solver.transient`) [-]."""
    reason: str | None = None
    """Reason why this figure alone has an infinite uncertainty."""
    on_grid: float | None = None
    """The figure on the finest grid in its domain, that of the fields; None where not known apart."""
    model: float | None = None
    """Relative uncertainty by the assumptions of averaged roughness (`roughness_uncertainty`), by the
    temperature of the inlet film between bodies of another one than its supply's
    (`arrival_uncertainty`) and, of films, by a pressure-viscosity coefficient that was not measured
    (`oil_uncertainty`), no part of `error`; None where there is none of these."""
    datum: float = 0.0
    """Origin of errors: of temperatures that of the colder body before the contact [K], else zero."""

    @property
    def error(self) -> float:
        """Relative numerical uncertainty [-].

        Grid, domain and iteration give estimates of errors of unknown and unrelated signs, whose squares add;
        approximations are bounds of errors that do not depend on chance, which are added to that.
        """
        return hypot(self.grid, self.domain, self.algebra) + self.approximation

    @property
    def bar(self) -> float:
        """The uncertainty in the unit of the result."""
        return self.error * abs(self.value - self.datum)

    def __float__(self) -> float:
        return float(self.value)

    def __format__(self, form: str) -> str:
        """The value in a form, by default of four digits, and its uncertainty."""
        value = f"{self.value:{form or '.4g'}}"
        if isinf(self.error):
            return with_bars(value, self.error, reason=self.reason)
        return f"{value} ± {self._relative}"

    def __str__(self) -> str:
        return format(self, "")

    def __repr__(self) -> str:
        return f"<Estimate {self}>"

    @property
    def _relative(self) -> str:
        return f"{self.bar:.2g}" if self.datum else percent(self.error, 3)

    def __neg__(self) -> "Estimate":
        return self._sum(self, -1.0, Estimate(0.0, 0.0), 0.0)

    def __abs__(self) -> "Estimate":
        return -self if self.value < 0 else self

    def __add__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: first._sum(first, 1.0, second, 1.0))

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: first._sum(first, 1.0, second, -1.0))

    def __rsub__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: first._sum(second, 1.0, first, -1.0))

    def __mul__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: first._power_product(second, 1.0))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: first._power_product(second, -1.0))

    def __rtruediv__(self, other: Any) -> "Estimate":
        return self._with(other, lambda first, second: second._power_product(first, -1.0))

    def __pow__(self, exponent: float) -> "Estimate":
        if not isinstance(exponent, int | float):
            return NotImplemented
        return Estimate(1.0, 0.0)._power_product(self, float(exponent))

    def __lt__(self, other: Any) -> bool:
        return self._with(other, lambda first, second: first.value < second.value)

    def __gt__(self, other: Any) -> bool:
        return self._with(other, lambda first, second: first.value > second.value)

    def __le__(self, other: Any) -> bool:
        return self._with(other, lambda first, second: first.value <= second.value)

    def __ge__(self, other: Any) -> bool:
        return self._with(other, lambda first, second: first.value >= second.value)

    def agrees_with(self, other: "Estimate | float") -> bool:
        """Whether both uncertainties together cover the difference."""
        bar = other.bar if isinstance(other, Estimate) else 0.0
        return abs(self.value - float(other)) <= self.bar + bar

    def _with(self, other: Any, result: Callable[["Estimate", "Estimate"], Combined]) -> Combined:
        if isinstance(other, Estimate):
            return result(self, other)
        try:
            return result(self, Estimate(float(other), 0.0))
        except TypeError:
            return NotImplemented

    @staticmethod
    def _sum(first: "Estimate", by: float, second: "Estimate", times: float) -> "Estimate":
        """by one + times other; errors are added, since figures of one solve err together."""
        value = by * first.value + times * second.value
        # an exact number only shifts what the error of a temperature is relative to
        shifted = first.datum != 0 or second.datum != 0
        first_datum, second_datum = (
            summand.value if shifted and not summand.error else summand.datum
            for summand in (first, second)
        )
        datum = by * first_datum + times * second_datum
        parts = (
            (abs(by * (first.value - first.datum)), first),
            (abs(times * (second.value - second.datum)), second),
        )
        return _estimate(value, datum, parts, abs(value - datum))

    def _power_product(self, other: "Estimate", exponent: float) -> "Estimate":
        """Self times other to a power; relative errors are added."""
        parts = tuple(
            (
                times
                * (
                    1.0
                    if not factor.datum
                    else abs(factor.value - factor.datum) / abs(factor.value)
                ),
                factor,
            )
            for times, factor in ((1.0, self), (abs(exponent), other))
        )
        return _estimate(self.value * other.value**exponent, 0.0, parts, 1.0)


def _estimate(
    value: float, datum: float, parts: tuple[tuple[float, Estimate], ...], size: float
) -> Estimate:
    """A figure whose errors are those of others by their weights, over its size."""

    def joined(name: str) -> float:
        total = sum(
            weight * (getattr(estimate, name) or 0.0) for weight, estimate in parts if weight
        )
        if size:
            return total / size
        return inf if total else 0.0

    reasons = [estimate.reason for _, estimate in parts if estimate.reason is not None]
    models = any(estimate.model is not None for _, estimate in parts)
    errors = {name: joined(name) for name in ORIGINS}
    return Estimate(
        value,
        **{name: inf if isnan(error) else error for name, error in errors.items()},
        reason=reasons[0] if reasons else None,
        model=joined("model") if models else None,
        datum=datum,
    )


def in_words(figure: Estimate, quantity: Quantity, rise: float | None = None) -> str:
    """A figure with its unit and error bars, of temperatures over a rise, by default above the datum [K]."""
    value, model = quantity.text(figure.value), figure.model
    if quantity.unit != "K":
        return with_bars(value, figure.error, model, reason=figure.reason)
    scale = abs(figure.value - figure.datum) if rise is None else rise
    return with_bars(value, figure.error, model, scale, " K", figure.reason)
