"""Fit the film formula to the atlas and tell its left-out errors.

    python benchmarks/atlas/fit.py atlas/films.csv [--write]

First the constants of the limits are fitted, then the network to what they leave. Every fifth contact of the
order in which they were solved is held out: no fit and no choice saw it, and the errors told are of these.
The bars are made of contacts in folds of the others. `--write` writes `pyworm/formulas/film_atlas.json`.
"""

import argparse
import json
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares, minimize

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.contacts import order
from atlas.regions import evenly_drawn, percent, regions
from atlas.table import columns, groups, known, part

from pyworm.formulas import film_atlas
from pyworm.formulas.film_atlas import AtlasGroups

MEMBERS, HIDDEN, DECAY, STEPS = 2, 48, 1e-3, 4000
"""Networks whose mean is taken, tangents of each, weight of their squares in the fit, and steps of that."""

HELD_OUT, FOLDS, ROBUST = 5, 5, 0.02
"""One of so many contacts is held out; folds of the others; miss beyond which contacts count linearly."""

FITTED_BAR, LARGEST_BAR = 0.1, 0.02
"""Bar of the contacts fitted to, which count the less the wider it is, and of those that tell errors."""

THINNEST = 0.005
"""Share of the contacts, those of the thinnest films over the Hertz approach, that are outside the box: most
of their like have no certified film."""

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


@dataclass(frozen=True)
class Known:
    """Films of contacts in Moes' unit and their relative bars, (contacts,) and (contacts, 2)."""

    central: np.ndarray
    minimum: np.ndarray
    bars: np.ndarray

    @classmethod
    def of(cls, data: dict) -> "Known":
        """The films of a table's contacts."""
        bars = np.stack([data["film_central_error"], data["film_min_error"]], axis=1)
        return cls(data["film_central"], data["film_min"], bars)

    def part(self, which: np.ndarray) -> "Known":
        """Some of the contacts."""
        return Known(self.central[which], self.minimum[which], self.bars[which])


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


def fit_network(of: AtlasGroups, constants: dict, known: Known, seed: int) -> dict:
    """Constants of the network."""
    film, read = read_by_network(of, constants)
    span = {"shift": read.mean(0), "scale": read.std(0), "low": read.min(0), "high": read.max(0)}
    x, faded = (read - span["shift"]) / span["scale"], film_atlas.fade(of, film)
    aims = np.stack([np.log(known.central) - film, np.log(known.central / known.minimum)], axis=1)
    scale = np.hypot(ROBUST, known.bars)
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
        miss = (told - aims) / scale
        root = np.sqrt(1 + miss**2)
        slope = miss / root / scale / len(x)
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
    beside = film_atlas.network(film_atlas.scaled(read, constants["network"]), constants["network"])
    central = film + film_atlas.fade(of, film) * beside[:, 0]
    return np.array([central, central - np.logaddexp(0, beside[:, 1])])


def fitted(of: AtlasGroups, known: Known, seed: int) -> dict:
    """All constants from some contacts."""
    constants = fit_limits(of, known.central)
    seeds = range(MEMBERS * seed, MEMBERS * (seed + 1))
    members = [fit_network(of, constants, known, one) for one in seeds]
    return constants | {"network": mean_network(members)}


def mean_network(members: list[dict]) -> dict:
    """The mean of networks as one: their tangents side by side."""
    joined = {"inner": 1, "inner_bias": 0, "outer": 0}
    mean = {name: np.mean([of[name] for of in members], axis=0) for name in members[0]}
    side = {
        name: np.concatenate([of[name] for of in members], axis) for name, axis in joined.items()
    }
    return mean | side | {"outer": side["outer"] / len(members)}


def neglected_effects(of: AtlasGroups, known: Known) -> np.ndarray:
    """Errors of contacts by fits that have not seen them, of ln of central and least film, (2, contacts)."""
    fold = np.random.default_rng(1).permutation(len(known.central)) % FOLDS
    missed = np.empty((2, len(fold)))
    for number in range(FOLDS):
        seen, unseen = fold != number, fold == number
        constants = fitted(part(of, seen), known.part(seen), number)
        missed[:, unseen] = errors(part(of, unseen), known.part(unseen), constants)
    return missed


def errors(of: AtlasGroups, known: Known, constants: dict) -> np.ndarray:
    """Errors of ln of central and least film, (2, contacts)."""
    return films(of, constants) - np.log([known.central, known.minimum])


def bars(of: AtlasGroups, constants: dict, missed: np.ndarray) -> dict:
    """How the left-out errors depend on the contact: a straight line in what the network reads."""
    _, read = read_by_network(of, constants)
    x = film_atlas.scaled(read, constants["network"])
    full = np.column_stack([x, np.ones(len(x))])
    size = np.log(np.abs(missed.T) + 0.003)
    slope = np.linalg.solve(
        full.T @ full + np.diag([0.02 * len(x)] * x.shape[1] + [0]), full.T @ size
    )
    level = slope[-1] + np.quantile(np.log(np.abs(missed.T)) - full @ slope, COVERED, axis=0)
    return {"slope": slope[:-1], "level": level}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("table", type=Path)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    data = known(given.table, FITTED_BAR)
    of, found = groups(data), Known.of(data)
    place = {number: at for at, number in enumerate(order())}
    held = np.array([place[int(number)] for number in data["number"]]) % HELD_OUT == HELD_OUT - 1
    exact = found.bars.max(axis=1) <= LARGEST_BAR
    seen, of_seen = found.part(~held), part(of, ~held)
    constants = fitted(of_seen, seen, 0)
    missed, sure = neglected_effects(of_seen, seen), exact[~held]
    constants["errors"] = bars(part(of_seen, sure), constants, missed[:, sure])
    even = evenly_drawn(data["number"], columns(given.table)["number"])
    alone = read_by_network(of, constants)[0] - np.log(found.central)
    print(f"limits joined, central: {percent(alone[exact])}")
    print(f"contacts in {FOLDS} folds of those fitted to")
    tell(part(of_seen, sure), missed[:, sure], constants, even[~held][sure])
    print("contacts held out")
    told = part(of, held & exact)
    missed = errors(told, found.part(held & exact), constants)
    tell(told, missed, constants, even[held & exact])
    if given.write:
        _, read = read_by_network(of_seen, constants)
        ends = {
            name: [float(np.min(value)), float(np.max(value))]
            for name, value in _box(of_seen, read).items()
        }
        content = {"contacts": len(seen.central), "box": ends} | constants
        target = Path(film_atlas.__file__).with_suffix(".json")
        target.write_text(json.dumps(content, default=_listed) + "\n")


def tell(of: AtlasGroups, missed: np.ndarray, constants: dict, even: np.ndarray) -> None:
    """Print errors by region, and the share of contacts within the bars."""
    print(f"{len(even)} contacts, errors in %: median, 90, 95, 99 of 100, largest")
    for name, which in ({"evenly drawn over the box": even} | regions(of)).items():
        cells = "  least ".join(percent(row[which]) for row in missed)
        print(f"{name:28s} {which.sum():5d}  central {cells}")
    _, read = read_by_network(of, constants)
    kept = film_atlas.scaled(read, constants["network"])
    within = np.abs(missed.T) <= film_atlas.scatter(kept, constants["errors"])
    print(f"within their bars: central {within[:, 0].mean():.1%}, least {within[:, 1].mean():.1%}")


def _box(of: AtlasGroups, read: np.ndarray) -> dict[str, np.ndarray]:
    """What bounds the atlas: groups as drawn, and what of them was refused or could not be resolved."""
    thick = np.exp(read[:, film_atlas.THICKNESS])
    return {
        "moes_m": of.moes_m,
        "moes_l": of.moes_l,
        "ratio": np.append(of.ratio, 1.0),
        "spin": np.abs(of.spin),
        "alpha_ratio": of.alpha_ratio,
        "compression": of.compression,
        "pressure": np.exp(read[:, film_atlas.PRESSURE]),
        "thickness": np.maximum(thick, np.quantile(thick, THINNEST)),
    }


def _listed(array: np.ndarray) -> list:
    """An array for JSON, to seven digits."""
    return np.vectorize(lambda value: float(f"{value:.7g}"))(array).tolist()


if __name__ == "__main__":
    main()
