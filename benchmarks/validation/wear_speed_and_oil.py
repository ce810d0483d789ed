"""Wear of a run-in unit at other speeds and with other oils, after one calibration, against the standard's.

    python benchmarks/validation/wear_speed_and_oil.py [--accuracy 10%]

The unit of tests/data/zi_a100.toml with both roughnesses run in. Its simulated wear an hour, mean over
the pattern, is calibrated at 1500 1/min with polyglycol; every other row then compares with DIN 3996.
"""

import argparse
import tempfile
from math import pi
from pathlib import Path

import pyworm
from pyworm.batch.drive_iteration import run_balanced
from pyworm.batch.task import Task
from pyworm.batch.wear_run import EFFECTS
from pyworm.formulas.wear_law import RUN_IN, WEAR_COEFFICIENT
from pyworm.io.quantity import SHARE_KIND, parse
from pyworm.ratings.worm_loads import RatedWormGear
from pyworm.result.flank_wear import asperity_pass, flank_grid

DATA = Path(__file__).parents[2] / "tests" / "data" / "zi_a100.toml"

ROWS = (
    ("PAG VG 220", 1500), ("PAG VG 220", 750), ("PAG VG 220", 3000), ("PAG VG 460", 1500),
    ("mineral VG 220", 1500), ("mineral VG 460", 1500), ("mineral VG 460", 3000), ("PAO VG 220", 1500),
)  # fmt: skip
"""Oil and speed of the worm [1/min]; the first row calibrates."""


def case_of(oil: str, speed: int, directory: Path) -> pyworm.Case:
    """The unit with another oil and speed."""
    text = DATA.read_text().replace("PAG VG 220", oil).replace("1500 rpm", f"{speed} rpm")
    for height in (0.5, 0.6):  # of the worm, of the wheel
        text = text.replace(f'roughness = "{height} um"', f'roughness = "{height * RUN_IN:g} um"')
    path = directory / f"{oil} {speed}.toml".replace(" ", "_")
    path.write_text(text.replace("[0.1, 0.3, 0.5, 0.7, 0.9]", "[0.2, 0.5, 0.8]"))
    return pyworm.load(path)


def simulated(case: pyworm.Case, accuracy: float, directory: Path) -> tuple[float, float]:
    """Mean depth worn off the pattern in an hour [m/h], and the mean load on asperities [-]."""
    tasks = [Task(case, place, accuracy, effects=EFFECTS) for place in case.places()]
    result, _ = run_balanced(case, tasks, directory)
    made = asperity_pass(result, flank_grid(result), case.drive.phases_per_second)
    duty = case.drive.duty()
    turns = duty.worm_speed / duty.gear.ratio / (2 * pi) * 3600
    mean = float((made.work**2).sum() / made.work.sum())
    shares = [of.figures.asperity_load_fraction.value for of in result.solutions]
    return WEAR_COEFFICIENT * turns * mean, sum(shares) / len(shares)


def main() -> None:
    """Print a row for each oil and speed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--accuracy", default="10 %")
    accuracy = parse(parser.parse_args().accuracy, SHARE_KIND)
    print(
        "| oil | 1/min | standard's film µm | asperities | standard nm/h | simulated nm/h | ratio |"
    )
    print("|---|---|---|---|---|---|---|")
    scale = None
    with tempfile.TemporaryDirectory() as name:
        for oil, speed in ROWS:
            case = case_of(oil, speed, Path(name))
            found, share = simulated(case, accuracy, Path(name) / f"{oil}{speed}")
            duty = case.tables.rated_duty(case.drive)
            (load,) = RatedWormGear(case.tables.rating_as_run(), duty, case.directory).loads
            rate = load.rated.wear.depth / load.hours
            scale = scale or rate / found
            print(
                f"| {oil} | {speed} | {load.rated.film * 1e6:.3g} | {share:.1%} | {rate * 1e9:.3g} | "
                f"{scale * found * 1e9:.3g} | {scale * found / rate:.3g} |",
                flush=True,
            )
    print(f"\nk = {scale * WEAR_COEFFICIENT:.3g} m2/N by the first row.")


if __name__ == "__main__":
    main()
