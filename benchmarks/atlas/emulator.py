"""A Gaussian process (scikit-learn) beside the network of the film formula: left-out errors of both.

    python benchmarks/atlas/emulator.py atlas/films.csv

The process learns what the joined limits leave of the central film, and ln of central over least film, from
what the network reads; scikit-learn is needed here alone.
"""

import argparse
import sys
import warnings
from pathlib import Path

import numpy as np
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.fit import FOLDS, LARGEST_BAR, fit_limits, read_by_network
from atlas.regions import percent, regions
from atlas.table import groups, known, part


def learnt(read: np.ndarray, aim: np.ndarray) -> GaussianProcessRegressor:
    """A process with a length for each thing that is read."""
    kernel = ConstantKernel(0.01) * RBF(np.full(read.shape[1], 3.0), (0.3, 300)) + WhiteKernel(
        1e-4, (1e-6, 1e-2)
    )
    return GaussianProcessRegressor(kernel, normalize_y=True).fit(read, aim)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    data = known(parser.parse_args().table, LARGEST_BAR)
    of, central, minimum = groups(data), data["film_central"], data["film_min"]
    fold = np.random.default_rng(1).permutation(len(central)) % FOLDS
    missed = np.empty((2, len(central)))
    within = np.empty(len(central), bool)
    for number in range(FOLDS):
        seen, unseen = fold != number, fold == number
        constants = fit_limits(part(of, seen), central[seen])
        film, read = read_by_network(of, constants)
        read = (read - read[seen].mean(0)) / read[seen].std(0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # lengths at their bounds: what is read twice
            first, second = (
                learnt(read[seen], aim[seen])
                for aim in (np.log(central) - film, np.log(central / minimum))
            )
        told, spread = first.predict(read[unseen], return_std=True)
        below = np.maximum(second.predict(read[unseen]), 0.0)
        missed[0, unseen] = film[unseen] + told - np.log(central[unseen])
        missed[1, unseen] = missed[0, unseen] + np.log(central / minimum)[unseen] - below
        within[unseen] = np.abs(missed[0, unseen]) <= 1.96 * spread
    for name, which in regions(of).items():
        errors = "  least ".join(percent(row[which]) for row in missed)
        print(f"{name:28s} {which.sum():5d}  central {errors}")
    print(f"central films within two of its own standard deviations: {within.mean():.1%}")


if __name__ == "__main__":
    main()
