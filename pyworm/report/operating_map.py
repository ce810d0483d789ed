"""The map of a gear set over speed and load as a table."""

from pyworm.formulas.unit_factors import RPM
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.operating_map import MAPPED_QUANTITIES, OperatingMap
from pyworm.report.table import Table

NOTE = (
    "Closed forms of the contacts listed: films with inlet heating (Wilson and Sheu), temperature of the "
    "surfaces with teeth and oil at the inlet temperature."
)


def operating_map_table(found: OperatingMap) -> Table:
    """A row for each operating point."""
    quantities = [QUANTITIES[name] for name in MAPPED_QUANTITIES]
    rows = []
    for i, speed in enumerate(found.speeds):
        for j, torque in enumerate(found.torques):
            numbers = (
                quantity.digits(quantity.number(found.values[quantity.name][i, j]))
                for quantity in quantities
            )
            rows.append(
                (f"{speed * RPM:.4g}", f"{torque:.4g}", *numbers, found.places["film_min"][i][j])
            )
    heads = (quantity.column for quantity in quantities)
    head = ("Speed\nrpm", "Torque\nN m", *heads, "Location of h_min")
    return Table(head, tuple(rows), "Engagement over speed and load", NOTE)
