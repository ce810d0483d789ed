"""What squeeze does to a drive's films: as plans estimate it, and by transient films.

Loads are shared dry. Run from the repository's root (it takes eleven minutes):

    python benchmarks/drives/squeeze.py [CASE] [--phase PHASE ...] [--accuracy 0.05] [--effects auto]
"""

from argparse import ArgumentParser
from collections.abc import Sequence
from time import process_time

import pyworm
from pyworm.planning.effects.squeeze import SQUEEZE, lag, spread
from pyworm.planning.prediction import predicted
from pyworm.solver.solution import Estimate

HEADS = ("ms", "lag", "spread", "estimate", "central", "least", "friction", "s")


def changed(after: Estimate, before: Estimate) -> str:
    """A figure over what it was, and the error of that by both error bars."""
    ratio = after.value / before.value
    return f"{ratio - 1:+.1%}±{ratio * (after.error + before.error):.1%}"


def main(path: str, phases: Sequence[float] | None, accuracy: float, effects: str) -> None:
    """A row for each contact that the case lists, or at some of its phases."""
    print(f"{'':>32} " + " ".join(f"{head:>12}" for head in HEADS))
    for scene in pyworm.load(path).scenes(phase=phases):
        lacking = SQUEEZE.lacking(scene)
        if lacking is not None:
            print(f"{scene.name:>32} {lacking}")
            continue
        of = predicted(scene)
        row = [f"{of.transit * 1e3:.2f}"]
        row += [f"{fraction:.1%}" for fraction in (lag(of), spread(of), SQUEEZE.influence(of).film)]
        started = process_time()
        steady, transient = (
            pyworm.solve(scene, pyworm.plan(scene, accuracy, chosen))
            for chosen in (effects, f"{effects},squeeze")
        )
        for name in ("film_central", "film_min", "friction_coefficient"):
            row.append(changed(getattr(transient.figures, name), getattr(steady.figures, name)))
        row.append(f"{process_time() - started:.0f}")
        failed = "" if steady.converged and transient.converged else " not converged"
        print(f"{scene.name:>32} " + " ".join(f"{cell:>12}" for cell in row) + failed, flush=True)


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", default="cases/zi_drive.toml")
    parser.add_argument("--phase", type=float, nargs="+")
    parser.add_argument("--accuracy", type=float, default=0.05)
    parser.add_argument("--effects", default="auto")
    asked = parser.parse_args()
    main(asked.case, asked.phase, asked.accuracy, asked.effects)
