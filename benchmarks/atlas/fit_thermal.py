"""Fit the reduction of films by heat and shear thinning to the thermal contacts of the atlas.

    python benchmarks/atlas/fit_thermal.py atlas/thermal.csv atlas/films.csv [--write]

The factors are films with heat over films without, of the isothermal contact of the same number where that
is solved and by the formula of the atlas elsewhere. Every fifth contact is held out of all fits; the bars are
made of contacts in folds of the others. `--write` writes `pyworm/formulas/film_reduction.json`.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.fit import COVERED, FOLDS, HELD_OUT, _listed
from atlas.regions import percent
from atlas.table import groups, known
from atlas.thermal_contacts import thermal_contact, thermal_order

from pyworm.formulas import film_reduction
from pyworm.formulas.film_atlas import AtlasGroups, films
from pyworm.formulas.film_reduction import HeatGroups
from pyworm.scene.formula_heat import heat_groups
from pyworm.scene.scales import scales

HIDDEN, DECAY, STEPS, ROBUST = 6, 2e-2, 1500, 0.02
"""Tangents, weight of squares in the fit, its steps, and miss beyond which contacts count linearly."""

FITTED_BAR, LARGEST_BAR = 0.1, 0.05
"""Bar of the contacts fitted to, which count the less the wider it is, and of those that tell errors."""


def heat_of(data: dict, central: np.ndarray) -> HeatGroups:
    """Groups of heat of a table's contacts, from their isothermal central films in Moes' unit."""
    found = []
    for number, film in zip(data["number"].astype(int), central, strict=True):
        scene = thermal_contact(number)
        found.append(vars(heat_groups(scene, film * scales(scene).groups.moes_film)))
    return HeatGroups(**{name: np.array([of[name] for of in found]) for name in found[0]})


def factors(data: dict, of: AtlasGroups, cold: dict) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Central films without heat, -ln of both factors and their bars, (contacts,) and twice (contacts, 2)."""
    formula = films(of)
    told = np.stack([formula.central, formula.minimum], axis=1)
    bars = np.stack([formula.central_error, formula.minimum_error], axis=1) / 2
    place = {int(number): at for at, number in enumerate(cold["number"])}
    for row, number in enumerate(data["number"].astype(int)):
        if number in place:
            at = place[number]
            told[row] = cold["film_central"][at], cold["film_min"][at]
            bars[row] = cold["film_central_error"][at], cold["film_min_error"][at]
    hot = np.stack([data["film_central"], data["film_min"]], axis=1)
    own = np.stack([data["film_central_error"], data["film_min_error"]], axis=1)
    return told[:, 0], np.log(told / hot), np.hypot(bars, own)


def fitted(
    read: np.ndarray, heat: HeatGroups, aims: np.ndarray, bars: np.ndarray, seed: int
) -> dict:
    """Constants of the network and its box."""
    box = {"low": read.min(0), "high": read.max(0)}
    box["low"][film_reduction.SLENDER] = (
        0.0  # nothing happens between the roundest ellipse and a circle
    )
    kept = film_reduction.scaled(read, box)
    shapes = {
        "inner": (kept.shape[1], HIDDEN),
        "inner_bias": (HIDDEN,),
        "outer": (HIDDEN, 4),
        "straight": (kept.shape[1], 4),
        "bias": (4,),
    }
    ends = np.cumsum([0, *(int(np.prod(shape)) for shape in shapes.values())])
    scale = np.hypot(ROBUST, bars)
    terms = film_reduction.terms(heat)[:, None, :]

    def split(flat: np.ndarray) -> dict[str, np.ndarray]:
        pieces = np.split(flat, ends[1:-1])
        return {name: of.reshape(shapes[name]) for name, of in zip(shapes, pieces, strict=True)}

    def loss(flat: np.ndarray) -> tuple[float, np.ndarray]:
        w = split(flat)
        hidden = np.tanh(kept @ w["inner"] + w["inner_bias"])
        each = terms * np.exp(film_reduction.exponents(kept, w))
        miss = (each.sum(-1) - aims) / scale
        root = np.sqrt(1 + miss**2)
        slope = ((miss / root / scale / len(kept))[..., None] * each).reshape(len(kept), 4)
        back = slope @ w["outer"].T * (1 - hidden**2)
        parts = kept.T @ back, back.sum(0), hidden.T @ slope, kept.T @ slope, slope.sum(0)
        weights = DECAY, 0.0, DECAY, DECAY, 0.0
        gradient = [
            (one + 2 * weight * w[name]).ravel()
            for name, one, weight in zip(shapes, parts, weights, strict=True)
        ]
        decay = sum(
            weight * (w[name] ** 2).sum() for name, weight in zip(shapes, weights, strict=True)
        )
        return (root - 1).sum() / len(kept) + decay, np.concatenate(gradient)

    first = np.random.default_rng(seed).normal(0, 0.2, ends[-1])
    done = minimize(loss, first, jac=True, method="L-BFGS-B", options={"maxiter": STEPS})
    return box | {"films": split(done.x)}


def errors(read: np.ndarray, heat: HeatGroups, aims: np.ndarray, constants: dict) -> np.ndarray:
    """Errors of ln of both factors, (contacts, 2)."""
    kept = film_reduction.scaled(read, constants)
    return aims - film_reduction.heat_reduction(kept, heat, constants["films"])


def heat_part(heat: HeatGroups, which: np.ndarray) -> HeatGroups:
    """Some of the contacts."""
    return HeatGroups(*(of[which] for of in vars(heat).values()))


def neglected_effects(read, heat, aims, bars) -> np.ndarray:
    """Errors of contacts in folds by fits that have not seen them, (contacts, 2)."""
    fold = np.random.default_rng(1).permutation(len(read)) % FOLDS
    missed = np.empty_like(aims)
    for number in range(FOLDS):
        seen, unseen = fold != number, fold == number
        constants = fitted(read[seen], heat_part(heat, seen), aims[seen], bars[seen], number)
        missed[unseen] = errors(read[unseen], heat_part(heat, unseen), aims[unseen], constants)
    return missed


def bars_of(read: np.ndarray, constants: dict, missed: np.ndarray) -> dict:
    """How left-out errors depend on the contact: a straight line in what is read, as of the films."""
    x = np.column_stack([film_reduction.scaled(read, constants), np.ones(len(read))])
    size = np.log(np.abs(missed) + 0.005)
    ridge = np.diag([0.02 * len(x)] * (x.shape[1] - 1) + [0])
    slope = np.linalg.solve(x.T @ x + ridge, x.T @ size)
    level = slope[-1] + np.quantile(np.log(np.abs(missed)) - x @ slope, COVERED, axis=0)
    return {"slope": slope[:-1], "level": level}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("isothermal", type=Path)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    data = known(given.table, FITTED_BAR)
    of = groups(data)
    central, aims, bars = factors(data, of, known(given.isothermal, LARGEST_BAR))
    heat = heat_of(data, central)
    read = film_reduction.features(of, central, heat)
    place = {number: at for at, number in enumerate(thermal_order())}
    held = np.array([place[int(one)] for one in data["number"]]) % HELD_OUT == HELD_OUT - 1
    exact = (bars[:, 0] <= LARGEST_BAR) & (bars[:, 1] <= FITTED_BAR)
    seen = ~held
    constants = fitted(read[seen], heat_part(heat, seen), aims[seen], bars[seen], 0)
    missed = neglected_effects(read[seen], heat_part(heat, seen), aims[seen], bars[seen])
    sure = exact[seen]
    constants |= bars_of(read[seen][sure], constants, missed[sure])
    print(f"factors: central {np.exp(-np.percentile(aims[:, 0], [95, 50, 5]))} (5, 50, 95 of 100)")
    tell("in folds of those fitted to", data, seen & exact, missed[sure])
    told = held & exact
    missed = errors(read[told], heat_part(heat, told), aims[told], constants)
    tell("held out", data, told, missed)
    within = np.abs(missed) <= film_reduction.bars(
        film_reduction.scaled(read[told], constants), constants
    )
    print(f"within their bars: central {within[:, 0].mean():.1%}, least {within[:, 1].mean():.1%}")
    if given.write:
        content = {"contacts": int(seen.sum())} | constants
        target = Path(film_reduction.__file__).with_suffix(".json")
        target.write_text(json.dumps(content, default=_listed) + "\n")


def tell(name: str, data: dict, which: np.ndarray, missed: np.ndarray) -> None:
    """Print errors of factors by region."""
    data = {key: of[which] for key, of in data.items()}
    regions = {
        "all": np.ones(len(missed), bool),
        "loading below 0.3": data["loading"] < 0.3,
        "loading 0.3 to 3": (data["loading"] >= 0.3) & (data["loading"] < 3),
        "loading above 3": data["loading"] >= 3,
        "slide-roll ratio below 0.5": data["sliding"] < 0.5,
        "slide-roll ratio 0.5 to 2": (data["sliding"] >= 0.5) & (data["sliding"] < 2),
        "slide-roll ratio above 2": data["sliding"] >= 2,
        "ratio of radii up to 3": data["ratio"] <= 3,
        "slender, to 60 deg": (data["ratio"] > 3) & (data["angle"] <= 60),
        "slender, 60 to 90 deg": (data["ratio"] > 3) & (data["angle"] > 60),
        "L below 2": data["moes_l"] < 2,
        "L above 2": data["moes_l"] >= 2,
    }
    print(f"{name}: {len(missed)} contacts, errors in %: median, 90, 95, 99 of 100, largest")
    for region, one in regions.items():
        cells = "  least ".join(percent(row[one]) for row in missed.T)
        print(f"{region:28s} {one.sum():5d}  central {cells}")


if __name__ == "__main__":
    main()
