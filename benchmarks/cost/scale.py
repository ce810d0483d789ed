"""What a sweep of many scenes takes beside their solution: files, bytes, and the time of its table.

    python benchmarks/cost/scale.py 1000 20000

Tiny scenes: line contacts whose solutions are all that of one, so that nothing but the keeping is measured.
"""

import resource
import sys
import tempfile
import time
from pathlib import Path

from pyworm.batch.case_run import SCENES
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import load_sweep
from pyworm.batch.sweep_run import run_sweep

CASE = Path(__file__).parents[2] / "cases" / "line_m20_l10.toml"

SWEEP = """
title = "Many scenes"
case = "{case}"
effects = "isothermal"
vary = [{{ "contact.load" = {{ draw = "uniform", low = "50 kN/m", high = "200 kN/m", count = {count} }} }}]
seed = 1
"""


def filled(path: Path, out: Path) -> None:
    """Put a solution of every scene into the store, as workers leave it."""
    sweep = load_sweep(path)
    first = sweep.tasks[0]
    result = first.solved()
    store = Store(out / SCENES, fields=False)
    for task in sweep.tasks:
        store.keep(task, result)


def measured(count: int, folder: Path) -> None:
    """Print what the last command of a sweep takes that finds every scene solved."""
    path, out = folder / "many.toml", folder / "out"
    path.write_text(SWEEP.format(case=CASE, count=count))
    filled(path, out)
    files = [file for file in (out / SCENES).rglob("*") if file.is_file()]
    size = sum(file.stat().st_size for file in files)
    begun, clock = time.process_time(), time.perf_counter()
    sweep = load_sweep(path, store=Store(out / SCENES, fields=False))
    checked = time.process_time()
    result = run_sweep(sweep, out)
    collected = time.process_time()
    result.save(out / "sweep.nc")
    result.save_csv(out / "sweep.csv")
    ended = time.process_time()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(
        f"{count:8} scenes: {len(files)} files, {size / count:.0f} bytes a scene; "
        f"checked {checked - begun:.1f} s, collected {collected - checked:.1f} s, "
        f"written {ended - collected:.1f} s of processor, {time.perf_counter() - clock:.1f} s by the clock; "
        f"{memory:.2f} GB; table {(out / 'sweep.nc').stat().st_size / count:.0f} bytes a scene"
    )


def main() -> None:
    """Measure each number of scenes of the command line."""
    for count in map(int, sys.argv[1:]):
        with tempfile.TemporaryDirectory() as folder:
            measured(count, Path(folder))


if __name__ == "__main__":
    main()
