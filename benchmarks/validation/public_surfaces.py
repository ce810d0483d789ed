"""Files of measured surfaces and profiles from public collections: figures, or the sentence on each.

    python benchmarks/validation/public_surfaces.py DIR

DIR holds files of any formats, such as the examples with which SurfaceTopography is tested (none come with
pyworm). Outliers are filled, as `pyworm surface` does. Where a file lacks unit or distance, both are given as
the sentence asks, and it is tried again.
"""

import argparse
import sys
import warnings
from pathlib import Path

from pyworm.surfaces.parameters import texture
from pyworm.surfaces.preparing import separate_waves
from pyworm.surfaces.profile import roughness_profile
from pyworm.surfaces.profile_parameters import profile_figures
from pyworm.surfaces.reading import read_heights

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ASKED = (("height_unit =", {"height_unit": "um"}), ("spacing =", {"spacing": 1e-6}))
COLUMNS = ("file", "points", "verdict", "Sq or Rq / um", "sentence")


def figures(path: Path, **given: object) -> tuple[str, float]:
    """Points and root mean square height [um] of a file."""
    heights, steps = read_heights(path, **given)
    points = " x ".join(map(str, heights.shape))
    if heights.ndim == 1:
        return points, profile_figures(
            roughness_profile(heights, steps[0], outliers="fill")
        ).rq * 1e6
    waves = separate_waves(heights, (steps[0], steps[1]), outliers="fill", fill=0.9)
    return points, texture(waves.roughness).rq * 1e6


def tried(path: Path) -> tuple[str, ...]:
    """The row of a file."""
    try:
        points, height = figures(path)
        return path.name, points, "figures", f"{height:.3g}", ""
    except ValueError as error:
        sentence = str(error)
    given = {}
    for words, keys in ASKED:
        if f"give {words}" in sentence or f"and {words}" in sentence:
            given |= keys
    try:
        points, height = figures(path, **given)
        return path.name, points, "figures, as asked", f"{height:.3g}", sentence
    except ValueError as error:
        return path.name, "", "sentence", "", str(error)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", type=Path)
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    rows = [tried(path) for path in sorted(options.directory.iterdir()) if path.is_file()]
    record("public_surfaces", COLUMNS, rows)
    for verdict in ("figures", "figures, as asked", "sentence"):
        print(verdict, sum(row[2] == verdict for row in rows))


if __name__ == "__main__":
    main()
