"""What plans tell of squeeze over a drive's mesh cycle: by the film's change, and by the contact's.

Loads are shared dry. Run from the repository's root (it takes seconds):

    python benchmarks/squeeze.py [CASE]
"""

import sys

import pyworm
from pyworm.effects.sketch import sketch
from pyworm.effects.unsimulated import SQUEEZE, lag, spread


def main(path: str) -> None:
    """A row for each contact that the case lists."""
    print(f"{'':>32} {'lag':>7} {'spread':>7} {'told':>7}")
    for scene in pyworm.load(path).scenes():
        if scene.neighbours is None:
            print(f"{scene.name:>32} steady")
            continue
        of = sketch(scene)
        shares = lag(of), spread(of), SQUEEZE.influence(of).film
        print(f"{scene.name:>32} " + " ".join(f"{share:7.2%}" for share in shares))


if __name__ == "__main__":
    main(*sys.argv[1:] or ["cases/zi_drive.toml"])
