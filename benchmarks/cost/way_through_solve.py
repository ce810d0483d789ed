"""Rooms and modules that the worm contact enters on its way through `pyworm.solve`.

    python benchmarks/cost/way_through_solve.py

Every call from one module of the package to another is recorded. A move is a pair of modules between which
there are such calls; it goes back where the called room lies on a higher floor than the calling one.
"""

import sys
from collections import Counter
from pathlib import Path
from types import FrameType

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "tests" / "python"))

from test_house import FLOORS  # noqa: E402

import pyworm  # noqa: E402

CASE = ROOT / "cases" / "zi_sharif_2001.toml"


def module_of(frame: FrameType | None) -> str | None:
    """The module of a frame, below the package; None of another package's."""
    name = "" if frame is None else frame.f_globals.get("__name__", "")
    return name.removeprefix("pyworm.") if name.startswith("pyworm.") else None


def main() -> None:
    """Solve the contact in the middle of the mesh, to 10 %, and print where it went."""
    scene = pyworm.load(CASE).scene(phase=0.5)
    plan = pyworm.plan(scene, accuracy=0.1)
    moves: Counter[tuple[str, str]] = Counter()

    def record(frame: FrameType, event: str, _) -> None:
        if event == "call":
            here, caller = module_of(frame), module_of(frame.f_back)
            if here is not None and caller is not None and here != caller:
                moves[caller, here] += 1

    sys.setprofile(record)
    pyworm.solve(scene, plan)
    sys.setprofile(None)

    modules = {module for move in moves for module in move}
    rooms = {module.split(".")[0] for module in modules}
    back = [move for move in moves if FLOORS[move[1].split(".")[0]] > FLOORS[move[0].split(".")[0]]]
    of_rooms = {tuple(module.split(".")[0] for module in move) for move in moves}
    print(f"{len(rooms)} rooms: {', '.join(sorted(rooms, key=FLOORS.get, reverse=True))}")
    print(f"{sum(a != b for a, b in of_rooms)} moves between rooms")
    print(f"{len(modules)} modules, {len(moves)} moves between modules, {len(back)} of them back")
    for caller, here in back:
        print(f"  {caller} -> {here}")


if __name__ == "__main__":
    main()
