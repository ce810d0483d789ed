"""Figures of a case by name: results over its contacts, ratings, contact pattern, closed forms of its mesh.

Results are `pyworm.batch.operating_points.read_results`, of solved contacts or of contacts by closed forms,
so that both have the same names and the same extremes over a mesh cycle.
"""

from collections.abc import Collection, Mapping, Sequence
from copy import deepcopy
from dataclasses import asdict
from typing import Any, Protocol

from pyworm.batch.operating_points import EXTREMES, Computed, OperatingPoint, read_results
from pyworm.case.case import Case
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.planning.closed_form_figures import closed_form_figures
from pyworm.ratings.rated_values import rated_values
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene

OF_CONTACTS = (
    *EXTREMES,
    *("specific_film", "friction_coefficient", "power_loss", "power_loss_per_length"),
    *("efficiency", "unit_efficiency", "sump_temperature"),
)
"""Figures that contacts decide."""

PATTERN_MARGIN = "pattern_margin"
"""Distance of the contact pattern without load from the nearer end of the face [m]."""


class FigureChanges(Protocol):
    """Changes of the figures of one contact to first order, such as an adjoint solution gives."""

    @property
    def figures(self) -> Mapping[str, float]:
        """Name -> figure [SI] about which changes are."""

    def change(self, plus: AnyContact, minus: AnyContact) -> Mapping[str, float]:
        """Figures of one contact less those of another, both close to that contact [SI]."""


def closed_form_summary(scene: AnyContact) -> dict[str, Any]:
    """Scalars of a contact by closed forms with the keys of `Solution.summary`, without uncertainties.

    ValueError for a scene that `pyworm.scene.scales` refuses.
    """
    line = isinstance(scene, LineScene)
    summary: dict[str, Any] = {
        "kind": "line" if line else "point",
        **asdict(ContactIndex.of(scene)),
        _load(scene).key: scene.load,
    }
    for name, value in closed_form_figures(scene).items():
        _put(summary, _quantity(name, line), value)
    return _with_specific_film(summary, scene)


def figure_in(summary: Mapping[str, Any], name: str) -> float | None:
    """A figure of the scalars of a contact [SI]; None where it was not simulated."""
    return _value(summary, _quantity(name, summary["kind"] == "line"))


def moved_summary(
    summary: Mapping[str, Any],
    scene: AnyContact,
    changes: Mapping[str, float],
    figures: Mapping[str, float],
) -> dict[str, Any]:
    """Scalars of a solved contact as they are after a small change of its inputs.

    Args:
        summary: Of the solved contact, as of `Solution.summary`.
        scene: The changed contact.
        changes: Name of a figure -> its change [SI].
        figures: The figures about which changes are; others than temperatures change in proportion.
    """
    moved, line = deepcopy(dict(summary)), isinstance(scene, LineScene)
    moved[_load(scene).key] = scene.load
    for name, change in changes.items():
        quantity = _quantity(name, line)
        before = _value(moved, quantity)
        if before is None:
            continue
        if quantity.unit == "K":
            _put(moved, quantity, before + change)
        elif figures[name]:
            _put(moved, quantity, before * (1 + change / figures[name]))
    return _with_specific_film(moved, scene)


def _load(scene: AnyContact) -> Quantity:
    return QUANTITIES["load_per_length" if isinstance(scene, LineScene) else "load"]


def _quantity(name: str, line: bool) -> Quantity:
    return QUANTITIES["power_loss_per_length" if line and name == "power_loss" else name]


def _put(summary: dict[str, Any], quantity: Quantity, value: float) -> None:
    name, celsius, body = quantity.key.partition("_C_")
    if celsius:
        summary.setdefault(f"{name}_C", {})[body] = value - ZERO_CELSIUS
        return
    summary[quantity.key] = value
    summary.setdefault(quantity.error_key, 0.0)


def _value(summary: Mapping[str, Any], quantity: Quantity) -> float | None:
    name, celsius, body = quantity.key.partition("_C_")
    if celsius:
        found = summary.get(f"{name}_C", {}).get(body)
        return None if found is None else found + ZERO_CELSIUS
    return summary.get(quantity.key)


def _with_specific_film(summary: dict[str, Any], scene: AnyContact) -> dict[str, Any]:
    film, ratio = QUANTITIES["film_min"], QUANTITIES["specific_film"]
    if scene.composite_roughness is None:
        return summary
    error = {ratio.error_key: summary[film.error_key]}
    return summary | {ratio.key: summary[film.key] / scene.composite_roughness} | error


def figures_of(
    point: OperatingPoint,
    summaries: Sequence[Mapping[str, Any]],
    wanted: Collection[str] | None = None,
) -> dict[str, Computed]:
    """Figures of a case by name [SI; ratings by the unit at the end of their key].

    Args:
        point: The case and its contacts.
        summaries: Scalars of each contact.
        wanted: Names; by default those of the contacts and the ratings.
    """
    found, rest = contact_figures(point, summaries), case_values(point.case, wanted)
    every = {name: Computed(value, 0.0) for name, value in rest.items()} | found
    return every if wanted is None else {name: every[name] for name in wanted if name in every}


def contact_figures(
    point: OperatingPoint, summaries: Sequence[Mapping[str, Any]]
) -> dict[str, Computed]:
    """Those of them that contacts decide [SI]."""
    found = dict(read_results(point, summaries))
    ratios = [_specific_film(summary) for summary in summaries]
    if ratios and None not in ratios:
        found["specific_film"] = min(filter(None, ratios), key=lambda ratio: ratio.value)
    return found


def _specific_film(summary: Mapping[str, Any]) -> Computed | None:
    quantity = QUANTITIES["specific_film"]
    value = summary.get(quantity.key)
    if value is None:
        return None
    error, model = summary.get(quantity.error_key, 0.0), summary.get(quantity.model_key, 0.0)
    return Computed(value, value * error, value * model)


def case_values(case: Case, wanted: Collection[str] | None) -> dict[str, float]:
    """Figures of a case that no contact decides, each group only if one of it is wanted."""
    if wanted is None:
        return rated_values(case)
    rest = set(wanted) - set(OF_CONTACTS)
    if not rest or case.drive is None:
        return {}
    found: dict[str, float] = {}
    if PATTERN_MARGIN in rest:
        margin = case.drive.pattern_margin
        found |= {} if margin is None else {PATTERN_MARGIN: margin}
    if rest - found.keys():
        found |= rated_values(case)
    if any(_of_cycle(name) for name in rest - found.keys()):
        found |= _cycle_extremes(case, rest)
    return found


def _of_cycle(name: str) -> bool:
    return name in QUANTITIES and bool(QUANTITIES[name].extreme)


def _cycle_extremes(case: Case, names: Collection[str]) -> dict[str, float]:
    """Extremes over the mesh cycle of closed forms of a drive."""
    cycle = None if case.drive is None else case.drive.cycle_data()
    if cycle is None:
        return {}
    return {
        name: float(
            cycle[name].min() if QUANTITIES[name].extreme == "minimum" else cycle[name].max()
        )
        for name in names
        if _of_cycle(name) and name in cycle
    }
