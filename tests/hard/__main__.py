"""The suite of hard scenes: solve, judge, tell, draw.

    python tests/hard                   # all; what was solved before is not solved again
    python tests/hard named             # a part: named, a kind of random scenes, stability or fuzz
    python tests/hard isothermal:0-99   # some random scenes, by number
    python tests/hard thermal:37        # one scene, with its case file
    python tests/hard drive             # gear drives, run to 5 and to 10 % as a user does; drive:0-9 some
    python tests/hard commands          # gear drives walked through every command; commands:0-9 some
    python tests/hard --only check,rate commands   # through some of the commands
    python tests/hard explore           # pages of mutated result files; explore:0-99 some
    python tests/hard killed            # a batch that is killed twenty times and resumed
    python tests/hard --seed 7          # the random scenes of another seed; parts as above
    python tests/hard --record drive:0  # what came of it goes to docs/evidence/data, and so to the page
    python tests/hard --trapped         # the named scenes in a debug build, on their first grids

Rows appear as scenes are solved. Exit code 1 if a scene broke, or fewer converged than promised, or one of
the default seed that did not converge is not listed in docs/evidence/data/hard_not_converged.csv.
"""

import argparse
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from case_text import case_text
from cost_map import PANELS, draw_map
from draws import DRAWS, SEED
from drive_report import complaints_of_drives, drives_run, drives_walked
from drive_trial import COMMANDS
from fuzz import many
from fuzz_readers import many as many_read
from fuzz_results import MANY, many_explored
from fuzz_results import many as many_files
from hard_record import record_contacts, record_drives, record_walks
from killed import killed_and_resumed
from named import GAPS, HOT, ISOTHERMAL
from promise import COUNTS, DRIVES, complaints
from stability import CHECKS
from traps import set_traps
from trial import HEADING, BriefTrial, Trial, Verdict, trial, verdict

from pyworm.batch.solved_scenes import Store

EFFECTS = {
    "isothermal": "isothermal",
    "thermal": "all",
    "rough": "all",
    "past": ("isothermal", "squeeze"),
    "starved": "all",
}


def named_trials(directory: Path, kind: type[Trial] = Trial) -> Iterator[Trial]:
    """The named scenes; gaps are written into a directory."""
    for name, tables in ISOTHERMAL.items():
        yield trial(tables, name, directory, "isothermal", kind)
    for name, make in GAPS.items():
        yield trial(make(directory), name, directory, "isothermal", kind)
    for name, tables in HOT.items():
        yield trial(tables, name, directory, "all", kind)


def random_trials(
    kind: str, numbers: Sequence[int], directory: Path, seed: int = SEED
) -> Iterator[Trial]:
    """Random scenes of a kind, by number."""
    for number in numbers:
        yield trial(DRAWS[kind](number, seed).tables, f"{kind}:{number}", directory, EFFECTS[kind])


def judged(trials: Iterator[Trial], store: Store) -> list[Verdict]:
    """What scenes came to, a row told for each."""
    verdicts = []
    for one in trials:
        verdicts.append(verdict(one, store))
        print(verdicts[-1].line, flush=True)
    return verdicts


def report(part: str, verdicts: Sequence[Verdict]) -> None:
    """The table's last lines: how many of what, at which cost."""
    counts = {
        outcome: sum(one.outcome == outcome for one in verdicts)
        for outcome in ("converged", "not converged", "broken")
    }
    costs = sorted(one.cost for one in verdicts)
    print(
        f"{part}: {counts['converged']} of {len(verdicts)} converged "
        f"({counts['converged'] / len(verdicts):.1%}), {counts['broken']} broke; cost at the median "
        f"{costs[len(costs) // 2]:.0f}, of nine in ten {costs[9 * len(costs) // 10]:.0f}, largest "
        f"{costs[-1]:.0f} million node convolutions\n"
    )


def show(one: Trial, tables: dict[str, Any], store: Store) -> None:
    """One scene: its case file, its plan's grids and what it came to."""
    print(case_text(tables))
    print("grids", *(" x ".join(map(str, grid.shape)) for grid in one.plan.grids), sep="  ")
    print(HEADING)
    judged(iter([one]), store)


def arguments() -> argparse.Namespace:
    """What was asked for, with the directory of its seed's results as `kept`."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("what", nargs="*")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--out", type=Path, default=Path("results/hard"))
    parser.add_argument("--trapped", action="store_true")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--only", default=",".join(COMMANDS))
    options = parser.parse_args()
    options.only = options.only.split(",")
    if strange := [name for name in options.only if name not in COMMANDS]:
        parser.error(f"--only {strange[0]}: commands are {', '.join(COMMANDS)}")
    if not 0 <= options.seed:
        parser.error(f"--seed {options.seed}: a whole number, 0 or more")
    options.kept = options.out / f"seed-{options.seed}"
    if not options.what:
        # what is not drawn is the same for every seed
        others = options.seed == SEED
        options.what = ["named"] * others + [*COUNTS] + ["stability", "fuzz"] * others
    return options


def _numbers(text: str, count: int) -> range:
    """Numbers that "3-7" or "3" means; without any all of a count."""
    first, _, last = text.partition("-")
    return range(int(first), int(last or first) + 1) if text else range(count)


def main() -> int:
    """Run what was asked for."""
    options = arguments()
    kept, seed = options.kept, options.seed
    kept.mkdir(parents=True, exist_ok=True)
    store = Store(kept / "scenes", fields=False)
    if options.trapped:
        set_traps()
        verdicts = judged(named_trials(kept, BriefTrial), store)
        return 1 if any(one.outcome == "broken" for one in verdicts) else 0
    found, drawn = [], {}
    print(f"seed {seed}, 5 % accuracy; results in {kept}")
    for what in options.what:
        part, _, numbers = what.partition(":")
        if part == "fuzz":
            with TemporaryDirectory() as directory:
                found += many(print, Path(directory))
                found += many_files(print, Path(directory))
                found += many_read(print, Path(directory))
            continue
        if part == "explore":
            with TemporaryDirectory() as directory:
                found += many_explored(print, Path(directory), _numbers(numbers, MANY))
            continue
        if part == "killed":
            with TemporaryDirectory() as directory:
                found += killed_and_resumed(print, Path(directory))
            continue
        if part in ("drive", "commands"):
            wanted = _numbers(numbers, DRIVES)
            if part == "drive":
                runs = drives_run(wanted, seed, kept)
                found += complaints_of_drives(runs)
                if options.record:
                    record_drives(runs, seed)
            else:
                walks, broken = drives_walked(wanted, seed, kept, options.only)
                found += broken
                if options.record:
                    record_walks(walks, seed)
            continue
        if part == "stability":
            found += [f"stability: {flaw}" for check in CHECKS for flaw in check(print)]
            continue
        if part == "named":
            print(HEADING)
            verdicts = judged(
                (one for one in named_trials(kept) if numbers in ("", one.case.name)), store
            )
        elif numbers.isdecimal():
            tables = DRAWS[part](int(numbers), seed).tables
            show(trial(tables, what, kept, EFFECTS[part]), tables, store)
            continue
        else:
            wanted = _numbers(numbers, COUNTS[part])
            print(HEADING)
            verdicts = judged(random_trials(part, wanted, kept, seed), store)
            drawn[part] = verdicts
        report(part, verdicts)
        # of another seed than the default one some contacts may do
        if options.record and (seed != SEED or len(verdicts) == COUNTS.get(part)):
            record_contacts(part, verdicts, seed)
        found += complaints(part, verdicts, seed)
    if drawn.keys() & PANELS.keys():
        traits = {
            one.name: DRAWS[kind](int(one.name.partition(":")[2]), seed).traits
            for kind, verdicts in drawn.items()
            for one in verdicts
        }
        draw_map(drawn, traits, kept / "map.png")
        print(f"map: {kept / 'map.png'}")
    for complaint in found:
        print(complaint)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
