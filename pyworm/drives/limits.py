"""Lower and upper deviations of a dimension, as drawings give them."""

from collections.abc import Mapping

from pyworm.io import units

Limits = tuple[units.Offset, units.Offset]
"""Lower and upper deviation [m]."""


def check_order(given: Mapping[str, Limits | None]) -> None:
    """Refuse deviations, by their names, whose upper one comes first (ValueError)."""
    for name, limits in given.items():
        if limits is not None and limits[0] > limits[1]:
            low, high = (limit * 1e3 for limit in limits)
            raise ValueError(
                f"inspection.{name} is [{low:.4g}, {high:.4g}] mm; give the lower deviation first"
            )
