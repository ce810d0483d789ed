"""Fit the film formula to the atlas and tell its left-out errors.

    python benchmarks/atlas/fit.py atlas/films.csv [--write]

First the constants of the limits are fitted, then the network to what they leave. Left-out errors are of
contacts in folds that neither fit has seen. `--write` writes `pyworm/formulas/film_atlas.json`.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares, minimize

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.regions import evenly_drawn, percent, regions
from atlas.table import columns, groups, known, part

from pyworm.formulas import film_atlas
from pyworm.formulas.film_atlas import AtlasGroups

MEMBERS, HIDDEN, DECAY, STEPS = 4, 16, 1e-3, 500
"""Networks whose mean is taken, tangents of each, weight of their squares in the fit, and steps of that."""

FOLDS, ROBUST, LARGEST_BAR = 5, 0.02, 0.02
"""Folds of the left-out errors; miss beyond which contacts count linearly; bar of the contacts fitted to."""

COVERED = 0.95
"""Share of the left-out contacts within the bars."""

START = {
    "isoviscous": {"factor": 1.2, "bend": 0.15, "rate": 0.8, "fall": 2.0, "turn": 2.0},
    "piezoviscous": {"factor": 0.25, "bend": 0.02, "rate": 2.0, "fall": 0.2, "turn": 2.0},
    "joined": {"isoviscous": 4.0, "rate": 0.7, "middle": -2.0, "power": 1.4, "compression": 0.7},
}
BOUNDS = {
    "factor": (-1, 3),
    "bend": (0.001, 10),
    "rate": (0.2, 3.5),
    "fall": (-1, 6),
    "turn": (0.3, 6),
    "isoviscous": (0.5, 8),
    "middle": (-4, 4),
    "power": (0.7, 6),
    "compression": (0.3, 1.5),
}


def fit_limits(of: AtlasGroups, central: np.ndarray) -> dict:
    """Constants of the limits and of how they are joined."""
    names = [(one, two) for one in START for two in START[one]]
    first = np.array([START[one][two] for one, two in names])
    low, high = np.array([BOUNDS[two] for _, two in names]).T

    def constants(values) -> dict:
        made: dict = {one: {} for one in START}
        for (one, two), value in zip(names, values, strict=True):
            made[one][two] = float(value)
        return made

    def missed(values):
        now = constants(values)
        return film_atlas.joined(of, film_atlas.limits(of, now), now) - np.log(central)

    found = least_squares(
        missed, first, bounds=(low, high), loss="soft_l1", f_scale=0.05, max_nfev=200
    )
    return constants(found.x)


def read_by_network(of: AtlasGroups, constants: dict) -> tuple[np.ndarray, np.ndarray]:
    """ln of the film of the limits joined, and what the network reads."""
    found = film_atlas.limits(of, constants)
    film = film_atlas.joined(of, found, constants)
    return film, film_atlas.features(of, found, film)


def fit_network(
    of: AtlasGroups, constants: dict, central: np.ndarray, minimum: np.ndarray, seed: int
) -> dict:
    """Constants of the network."""
    film, read = read_by_network(of, constants)
    span = {"shift": read.mean(0), "scale": read.std(0), "low": read.min(0), "high": read.max(0)}
    x, faded = (read - span["shift"]) / span["scale"], film_atlas.fade(of, film)
    aims = np.stack([np.log(central) - film, np.log(central / minimum)], axis=1)
    width = x.shape[1]
    shapes = {
        "inner": (width, HIDDEN),
        "inner_bias": (HIDDEN,),
        "outer": (HIDDEN, 2),
        "straight": (width, 2),
        "bias": (2,),
    }
    ends = np.cumsum([0, *(int(np.prod(shape)) for shape in shapes.values())])
    weights = dict(zip(shapes, (DECAY, 0.0, DECAY, DECAY / 10, 0.0), strict=True))

    def split(flat: np.ndarray) -> dict[str, np.ndarray]:
        pieces = np.split(flat, ends[1:-1])
        return {name: of.reshape(shapes[name]) for name, of in zip(shapes, pieces, strict=True)}

    def loss(flat: np.ndarray) -> tuple[float, np.ndarray]:
        w = split(flat)
        hidden = np.tanh(x @ w["inner"] + w["inner_bias"])
        out = hidden @ w["outer"] + x @ w["straight"] + w["bias"]
        told = np.stack([faded * out[:, 0], np.logaddexp(0, out[:, 1])], axis=1)
        miss = (told - aims) / ROBUST
        root = np.sqrt(1 + miss**2)
        slope = miss / root / ROBUST / len(x)
        slope *= np.stack([faded, 1 / (1 + np.exp(-out[:, 1]))], axis=1)
        back = slope @ w["outer"].T * (1 - hidden**2)
        parts = x.T @ back, back.sum(0), hidden.T @ slope, x.T @ slope, slope.sum(0)
        gradient = [
            (one + 2 * weights[name] * w[name]).ravel()
            for name, one in zip(shapes, parts, strict=True)
        ]
        value = (root - 1).sum() / len(x) + sum(weights[n] * (w[n] ** 2).sum() for n in shapes)
        return value, np.concatenate(gradient)

    first = np.random.default_rng(seed).normal(0, 0.3, ends[-1])
    done = minimize(loss, first, jac=True, method="L-BFGS-B", options={"maxiter": STEPS})
    return span | split(done.x)


def films(of: AtlasGroups, constants: dict) -> np.ndarray:
    """ln of central and least film, (2, contacts)."""
    film, read = read_by_network(of, constants)
    beside = film_atlas.network(read, constants["network"])
    central = film + film_atlas.fade(of, film) * beside[:, 0]
    return np.array([central, central - np.logaddexp(0, beside[:, 1])])


def fitted(of: AtlasGroups, central: np.ndarray, minimum: np.ndarray, seed: int) -> dict:
    """All constants from some contacts."""
    constants = fit_limits(of, central)
    seeds = range(MEMBERS * seed, MEMBERS * (seed + 1))
    members = [fit_network(of, constants, central, minimum, one) for one in seeds]
    return constants | {"network": mean_network(members)}


def mean_network(members: list[dict]) -> dict:
    """The mean of networks as one: their tangents side by side."""
    joined = {"inner": 1, "inner_bias": 0, "outer": 0}
    mean = {name: np.mean([of[name] for of in members], axis=0) for name in members[0]}
    side = {
        name: np.concatenate([of[name] for of in members], axis) for name, axis in joined.items()
    }
    return mean | side | {"outer": side["outer"] / len(members)}


def left_out(of: AtlasGroups, central: np.ndarray, minimum: np.ndarray) -> np.ndarray:
    """Errors of contacts by fits that have not seen them, of ln of central and least film, (2, contacts)."""
    fold = np.random.default_rng(1).permutation(len(central)) % FOLDS
    missed = np.empty((2, len(central)))
    for number in range(FOLDS):
        seen, unseen = fold != number, fold == number
        constants = fitted(part(of, seen), central[seen], minimum[seen], number)
        found = films(part(of, unseen), constants)
        missed[:, unseen] = found - np.log([central[unseen], minimum[unseen]])
    return missed


def bars(of: AtlasGroups, constants: dict, missed: np.ndarray) -> dict:
    """How the left-out errors depend on the contact: a straight line in what the network reads."""
    _, read = read_by_network(of, constants)
    network = constants["network"]
    x = (read - network["shift"]) / network["scale"]
    full = np.column_stack([x, np.ones(len(x))])
    size = np.log(np.abs(missed.T) + 0.003)
    slope = np.linalg.solve(
        full.T @ full + np.diag([0.02 * len(x)] * x.shape[1] + [0]), full.T @ size
    )
    level = slope[-1] + np.quantile(np.log(np.abs(missed.T)) - full @ slope, COVERED, axis=0)
    return {name: network[name] for name in ("shift", "scale", "low", "high")} | {
        "slope": slope[:-1],
        "level": level,
    }


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("table", type=Path)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    data = known(given.table, LARGEST_BAR)
    of, central, minimum = groups(data), data["film_central"], data["film_min"]
    missed = left_out(of, central, minimum)
    constants = fitted(of, central, minimum, 0)
    constants["errors"] = bars(of, constants, missed)
    alone = read_by_network(of, constants)[0] - np.log(central)
    print(f"{len(central)} contacts, errors in %: median, 90, 95, 99 of 100, largest")
    print(f"limits joined, central:       {percent(alone)}")
    even = evenly_drawn(data["number"], columns(given.table)["number"])
    for name, which in ({"evenly drawn over the box": even} | regions(of)).items():
        errors = "  least ".join(percent(row[which]) for row in missed)
        print(f"{name:28s} {which.sum():5d}  central {errors}")
    _, read = read_by_network(of, constants)
    within = np.abs(missed.T) <= film_atlas.scatter(read, constants["errors"])
    print(f"within their bars: central {within[:, 0].mean():.1%}, least {within[:, 1].mean():.1%}")
    if given.write:
        ends = {
            name: [float(np.min(value)), float(np.max(value))]
            for name, value in _box(of, read).items()
        }
        content = {"contacts": len(central), "box": ends} | constants
        target = Path(film_atlas.__file__).with_suffix(".json")
        target.write_text(json.dumps(content, default=_listed) + "\n")


def _box(of: AtlasGroups, read: np.ndarray) -> dict[str, np.ndarray]:
    """What bounds the atlas: groups as drawn, and what of them was refused."""
    return {
        "moes_m": of.moes_m,
        "moes_l": of.moes_l,
        "ratio": np.append(of.ratio, 1.0),
        "spin": np.abs(of.spin),
        "alpha_ratio": of.alpha_ratio,
        "compression": of.compression,
        "pressure": np.exp(read[:, film_atlas.PRESSURE]),
        "thickness": np.append(np.exp(read[:, film_atlas.THICKNESS]), 0.0),
    }


def _listed(array: np.ndarray) -> list:
    """An array for JSON, to seven digits."""
    return np.vectorize(lambda value: float(f"{value:.7g}"))(array).tolist()


if __name__ == "__main__":
    main()
