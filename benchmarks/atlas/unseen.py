"""Errors of the formula that ships at contacts of the atlas which its fit had not seen, and its bars there.

git show 58bcc6e:atlas/films.csv > fitted.csv          # the table that the formula was fitted to
python benchmarks/atlas/unseen.py atlas/films.csv fitted.csv
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.regions import percent, regions
from atlas.table import columns, groups, known

from pyworm.formulas.film_atlas import films

LARGEST_BAR = 0.02
"""Bar of a contact up to which it tells something of the formula's errors, as in the fit [-]."""


def main() -> None:
    """Print errors by region, and the share of contacts within the formula's bars."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("fitted", type=Path)
    given = parser.parse_args()
    data, seen = known(given.table, LARGEST_BAR), columns(given.fitted)["number"]
    data = {name: of[~np.isin(data["number"], seen)] for name, of in data.items()}
    of, found = groups(data), films(groups(data))
    central = found.central / data["film_central"] - 1
    minimum = found.minimum / data["film_min"] - 1
    print(f"{len(central)} contacts, errors in %: median, 90, 95, 99 of 100, largest")
    for name, which in regions(of).items():
        errors = f"central {percent(central[which])}  least {percent(minimum[which])}"
        print(f"{name:28s} {which.sum():5d}  {errors}")
    kept = [
        np.mean(abs(missed) <= bar)
        for missed, bar in ((central, found.central_error), (minimum, found.minimum_error))
    ]
    print(f"within their bars: central {kept[0]:.1%}, least {kept[1]:.1%}")
    print(f"inside the box: {np.mean(found.inside):.1%}")


if __name__ == "__main__":
    main()
