"""Error bars of transient films on random pasts of balls and rollers, against a finer transient solve.

Loads or speeds rise, step, swing or turn round while oil passes; every third contact is a point. Run from the
repository's root (it takes two minutes; a number solves that past alone):

    python benchmarks/accuracy/random_pasts.py [--seed 1] [NUMBER ...]
"""

import sys
from argparse import ArgumentParser
from collections.abc import Callable, Sequence
from dataclasses import replace
from math import cos, pi, tanh
from pathlib import Path

import numpy as np
from motion_error import ACCURACY, Tally, found
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.planning.effects.geometry import as_line
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.next_film import NoFilmError

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

COUNT = 20
"""Pasts of a seed."""

TRANSITS = 8.0
"""Age of the contacts, in transits of the oil through them as they are in the mean."""

SHAPES = ("ramp", "step", "sine", "reversal")


def shape(name: str, size: float, place: float) -> Callable[[float], float]:
    """Share of a life that is past -> factor of load or speed."""
    return {
        "ramp": lambda share: 1 + size * share,
        "step": lambda share: 1 + size * (1 + tanh((share - place) * TRANSITS / 0.3)) / 2,
        "sine": lambda share: 1 + size / 2 * cos(2 * pi * (share + place) * TRANSITS / 4),
        "reversal": lambda share: cos(pi * share * (0.6 + 0.4 * place)),
    }[name]


def drawn(number: int, seed: int) -> Scene | LineScene:
    """A contact with a past."""
    rng = np.random.default_rng((seed, number))
    name = SHAPES[number % len(SHAPES)]
    factor = shape(name, rng.uniform(-0.4, 0.8), rng.uniform(0.3, 0.7))
    load, speed = 10 ** rng.uniform(1.2, 2.2), 10 ** rng.uniform(-0.3, 0.5)
    oil = mineral(10 ** rng.uniform(-1.7, -0.7), rng.uniform(1.2e-8, 2.4e-8))
    of_load = name != "reversal" and rng.random() < 0.5
    flat = (lambda scene: scene) if number % 3 == 0 else as_line

    def contact(share: float) -> Scene | LineScene:
        u = speed * (1.0 if of_load else factor(share)) or 1e-9 * speed
        pressed = load * (factor(share) if of_load else 1.0)
        ball = point(f"{number} {name}", (0.02, 0.02), pressed, ((u, 0.0),) * 2, (STEEL,) * 2, oil)
        return flat(ball)

    still = replace(contact(0.0), name="still")
    age = TRANSITS * predicted(still).transit
    life = Life(age, lambda seconds: contact(seconds / age))
    at = rng.uniform(0.5, 0.95) * age
    return replace(life.at(at), past=Past(life, at))


def main(numbers: Sequence[int], seed: int) -> None:
    """Rows for each past; then how many bars hold."""
    tally = Tally()
    for number in numbers:
        scene = drawn(number, seed)
        plan = pyworm.plan(scene, ACCURACY, ("isothermal", "squeeze"), ("film",))
        try:
            rates = found([scene], plan, 3)[scene.name]
        except (NoFilmError, ValueError) as error:
            print(f"{scene.name:>24} {error}", flush=True)
            continue
        tally.show(scene, plan, rates)
    counts = tally.end()
    if len(numbers) == COUNT:
        columns = "seed", "hold after one solve", "hold after two solves", "estimates"
        row = (seed, *(held for _, held, _ in counts[:2]), counts[0][2])
        record("error_histories", columns, [row], key=("seed",))


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("number", type=int, nargs="*", default=range(COUNT))
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    main(asked.number, asked.seed)
