"""Films of a contact by every formula for its kind, each with its range and its deviation."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from pyworm.formulas.film import Film
from pyworm.formulas.film_ranges import FORMULA_RANGES
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import percent
from pyworm.io.shown import Shown
from pyworm.scene.film_formulas import ATLAS, LINE_FORMULAS, POINT_FORMULAS, films_by_formula
from pyworm.scene.formula_film import FormulaFilms
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales, scales
from pyworm.solver.solution import Solution

OUTSIDE_ATLAS = "outside the range of the atlas"


@dataclass(frozen=True, repr=False)
class FormulaFilm(Shown):
    """Films of a contact by one formula."""

    formula: str
    """Name of the formula."""
    film_central: float | None
    """Central film thickness [m]; None where the formula gives none."""
    film_min: float | None
    """Minimum film thickness [m]; None where the formula gives none."""
    outside: str
    """Why the contact is outside the range of the formula; empty inside."""
    deviation_central: float | None = None
    """Relative deviation of the central film thickness from the reference [-]; None without one."""
    deviation_min: float | None = None
    """Relative deviation of the minimum film thickness from the reference [-]; None without one."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the films in words."""
        return f"FormulaFilm {self.formula}", {
            name: f"{value * 1e6:.4g} µm"
            for name in ("film_central", "film_min")
            if (value := getattr(self, name)) is not None
        } | ({"outside its range": self.outside} if self.outside else {})


@dataclass(frozen=True, repr=False)
class FormulaComparison(Shown):
    """Films of a contact by every formula for its kind; iterating gives the rows of the table."""

    name: str
    """Name of the contact."""
    reference: str
    """What deviations refer to: a formula, or "solution"."""
    rows: tuple[FormulaFilm, ...]
    """Films by each formula."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading, and of each formula its films with their deviations and its range."""
        return f"Film thickness of {self.name} by formula, deviation from {self.reference}", {
            row.formula: ", ".join(
                filter(
                    None,
                    (
                        _in_words("film_central", row.film_central, row.deviation_central),
                        _in_words("film_min", row.film_min, row.deviation_min),
                        row.outside and f"outside its range: {row.outside}",
                    ),
                )
            )
            for row in self.rows
        }

    def __str__(self) -> str:
        heading, rows = self.shown()
        width = max(map(len, rows))
        return "\n".join([heading, *(f"{name:{width}}  {text}" for name, text in rows.items())])

    def __iter__(self) -> Iterator[FormulaFilm]:
        """The rows of the table."""
        return iter(self.rows)

    def to_dict(self) -> list[dict[str, Any]]:
        """The rows as dictionaries, such as for `pandas.DataFrame`."""
        return [asdict(row) for row in self.rows]


def compare_formulas(
    scene: Scene | LineScene, solution: Solution | None = None
) -> FormulaComparison:
    """Films of a contact by every formula for its kind, without a solve: isothermal, smooth, fully flooded.

    Args:
        scene: The contact.
        solution: Its solution, to which deviations refer; by default they refer to the formula of the atlas,
            of line contacts to that of Moes.

    Raises:
        ValueError: What is no contact, or no solution.
    """
    if not isinstance(scene, Scene | LineScene):
        raise ValueError(f"scene is a {type(scene).__name__}: must be a Scene or a LineScene")
    if solution is not None and not isinstance(solution, Solution):
        raise ValueError(f"solution is a {type(solution).__name__}: must be a Solution")
    with np.errstate(all="ignore"):  # a formula far outside its range may overflow
        films = {name: found() for name, found in films_by_formula(scene).items()}
    reference = ATLAS if ATLAS in films else next(iter(LINE_FORMULAS))
    central, minimum = _numbers(films[reference]) if reference in films else (None, None)
    if solution is not None:
        figures, reference = solution.figures, "solution"
        central, minimum = figures.film_central.value, figures.film_min.value
    rows = []
    for name, film in films.items():
        found = _numbers(film)
        deviations = (_deviation(*pair) for pair in zip(found, (central, minimum), strict=True))
        rows.append(FormulaFilm(name, *found, _outside(scene, name, film), *deviations))
    return FormulaComparison(scene.name, reference, tuple(rows))


def _numbers(film: Film | FormulaFilms) -> tuple[float | None, float | None]:
    """Central and minimum film [m]."""
    central, minimum = (
        None if value is None else float(value) for value in (film.central, film.minimum)
    )
    return central, minimum


def _outside(scene: Scene | LineScene, name: str, film: Film | FormulaFilms) -> str:
    """Why a contact is outside the range of a formula."""
    if isinstance(film, FormulaFilms):
        return "" if bool(film.inside) else OUTSIDE_ATLAS
    size = line_scales(scene) if isinstance(scene, LineScene) else scales(scene)
    formula = (POINT_FORMULAS | LINE_FORMULAS)[name].__name__.removesuffix("_line")
    return FORMULA_RANGES[formula].objection(size.groups, size.regime)


def _deviation(film: float | None, reference: float | None) -> float | None:
    """Relative deviation of a film from another one."""
    return None if film is None or not reference else film / reference - 1


def _in_words(name: str, film: float | None, deviation: float | None) -> str:
    """A film with its deviation; empty without it."""
    if film is None:
        return ""
    quantity = QUANTITIES[name]
    off = "" if not deviation else f" ({'+' if deviation > 0 else '-'}{percent(abs(deviation), 2)})"
    return f"{quantity.symbol} {quantity.text(film)}{off}"
