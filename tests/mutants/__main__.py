"""Mutations of the program, one line each: which of them do tests see?

    python tests/mutants                # all; what was decided before and has not changed is not run again
    python tests/mutants film-heat ...  # some, by name

Each is made in a copy of the tree, built and tested by what touches it; tests have to pass without it first.
A mutation whose line no longer stands in its file is stale and counts for nothing. Exit code 1 if tests see
less than the promised fraction, or a mutation is stale or undecided, or a survivor has no reason.
"""

import argparse
import json
import sys
import time
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from rules import ROOT, Mutation, mutations
from scratch import Scratch

PROMISED = 0.95
"""Fraction of the mutations that tests see."""

DIRECTORY = ROOT / "build" / "mutants"
OUTCOMES = DIRECTORY / "outcomes.json"


def digest(tree: Path, mutation: Mutation) -> str:
    """Of a mutation, its file and its tests: while it is the same, so is the outcome."""
    parts = [repr(mutation), (tree / mutation.file).read_text(encoding="utf-8")]
    parts += [
        (tree / f"tests/fortran/test_{name}.f90").read_text(encoding="utf-8")
        for name in mutation.programs
    ]
    files = sorted({test.split("::")[0] for test in mutation.python_tests})
    parts += [(tree / name).read_text(encoding="utf-8") for name in files]
    return sha256("\0".join(parts).encode()).hexdigest()


def failing_without(scratch: Scratch, pending: Sequence[Mutation]) -> set[str]:
    """Tests of some mutations that fail without any."""
    programs = sorted({name for mutation in pending for name in mutation.programs})
    failing = {name for name in programs if scratch.program_failure(name)}
    tests = sorted({test for mutation in pending for test in mutation.python_tests})
    return failing | set(scratch.python_failures(tests) if tests else ())


def unsound(mutation: Mutation, failing: set[str]) -> str | None:
    """Which of a mutation's tests fails without it."""
    return next(
        (
            one
            for one in failing
            for test in mutation.tests
            if one == test or (".py" in test and one.startswith(test))
        ),
        None,
    )


def decide(scratch: Scratch, pending: Sequence[Mutation], known: dict[str, dict]) -> None:
    """Run mutations and note each outcome."""
    failing = failing_without(scratch, pending)
    for mutation in pending:
        if failed := unsound(mutation, failing):
            print(f"UNSOUND   {mutation.name}: {failed} fails without it", flush=True)
            continue
        started = time.perf_counter()
        with scratch.mutated(mutation):
            seen = scratch.failure(mutation)
        seconds = time.perf_counter() - started
        known[mutation.name] = {"digest": digest(scratch.tree, mutation), "seen": seen}
        OUTCOMES.write_text(json.dumps(known, indent=1))
        print(
            f"{'seen' if seen else 'SURVIVES':9} {mutation.name}  {seen or ''}  {seconds:.0f} s",
            flush=True,
        )


def told(chosen: Sequence[Mutation], known: dict[str, dict], stale: Sequence[Mutation]) -> bool:
    """Print the score and what is wrong; whether all is well."""
    decided = [mutation for mutation in chosen if mutation.name in known and mutation not in stale]
    seen = [mutation for mutation in decided if known[mutation.name]["seen"]]
    for where, kernel in (("kernel", True), ("Python", False)):
        part = [mutation for mutation in decided if mutation.in_kernel is kernel]
        print(f"{where}: {sum(of in seen for of in part)} of {len(part)} seen")
    share = len(seen) / max(len(decided), 1)
    print(f"all: {len(seen)} of {len(decided)} seen, {share:.1%}")
    survivors = [mutation for mutation in decided if mutation not in seen]
    for mutation in survivors:
        print(f"survives: {mutation.name}: {mutation.survives or 'NO REASON GIVEN'}")
    for mutation in stale:
        print(f"stale: {mutation.name}: its line is not in {mutation.file}")
    undecided = len(chosen) - len(decided) - len(stale)
    if undecided:
        print(f"not decided: {undecided}")
    reasons = all(mutation.survives for mutation in survivors)
    return share >= PROMISED and reasons and not stale and not undecided


def main() -> int:
    """Decide the mutations asked for and print the score."""
    parser = argparse.ArgumentParser(prog="tests/mutants", description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these")
    names = parser.parse_args().names
    listed = {mutation.name: mutation for mutation in mutations()}
    if missing := [name for name in names if name not in listed]:
        parser.error(f"{missing[0]}: there is no such mutation")
    chosen = [listed[name] for name in names] if names else list(listed.values())

    scratch = Scratch(DIRECTORY)
    scratch.refresh()
    known = json.loads(OUTCOMES.read_text()) if OUTCOMES.is_file() else {}
    stale = [mutation for mutation in chosen if mutation.applied(scratch.tree) is None]
    pending = []
    for mutation in chosen:
        if mutation in stale or known.get(mutation.name, {}).get("digest") != digest(
            scratch.tree, mutation
        ):
            known.pop(mutation.name, None)
            pending.append(mutation)
    decide(scratch, [mutation for mutation in pending if mutation not in stale], known)
    return 0 if told(chosen, known, stale) else 1


if __name__ == "__main__":
    sys.exit(main())
