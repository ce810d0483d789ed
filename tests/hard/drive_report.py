"""Rows and counts of the gear drives of the suite, and what breaks its promises."""

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from drive_trial import (
    ACCURACIES,
    DRIVE_HEADING,
    Called,
    DriveTrial,
    DriveVerdict,
    drive_verdict,
    walked,
)
from gear_draws import drive
from promise import CYCLES, DRIVES, PHASES, TIME_FACTOR, TIMES


def drives_run(numbers: Sequence[int], seed: int, kept: Path) -> list[DriveVerdict]:
    """Run drives at each accuracy; prints a row for each, and the counts."""
    print(DRIVE_HEADING)
    verdicts = []
    for trial in _trials(numbers, seed, kept):
        for accuracy in ACCURACIES:
            verdicts.append(drive_verdict(trial, accuracy))
            print(verdicts[-1].line, flush=True)
    for line in counts(verdicts):
        print(line)
    return verdicts


def drives_walked(
    numbers: Sequence[int], seed: int, kept: Path, names: Sequence[str]
) -> tuple[list[tuple[DriveTrial, Called]], list[str]]:
    """Walk drives through commands, and what broke; prints a row for each command, and the counts."""
    outcomes: Counter[tuple[str, str]] = Counter()
    walks, broken = [], []
    for trial in _trials(numbers, seed, kept):
        print(f"{trial.name} {trial.drawn.traits['kind']}")
        for done in walked(trial, names):
            print(_row(done), flush=True)
            walks.append((trial, done))
            outcomes[done.command.split()[0], done.outcome] += 1
            broken += [f"{trial.name}, {done.command}: {flaw}" for flaw in done.flaws]
    for command in dict.fromkeys(command for command, _ in outcomes):
        of = {what: n for (name, what), n in sorted(outcomes.items()) if name == command}
        print(f"{command}: " + ", ".join(f"{n} {what}" for what, n in of.items()))
    return walks, broken


def _trials(numbers: Sequence[int], seed: int, kept: Path) -> Iterator[DriveTrial]:
    for number in numbers:
        yield DriveTrial(f"drive:{number}", drive(number, seed), kept / "drives" / f"{number:03d}")


def _row(done: Called) -> str:
    why = "; ".join(done.flaws) or (done.said.strip() if done.outcome != "done" else "")
    return f"  {done.command[:34]:34} {done.outcome:13} {done.processor:7.1f} s  {why:.300}"


def counts(verdicts: Sequence[DriveVerdict]) -> Iterator[str]:
    """Lines with the counts of runs at each accuracy."""
    for accuracy in ACCURACIES:
        some = [one for one in verdicts if one.accuracy == accuracy]
        run = [one for one in some if one.phases]
        if not some:
            continue
        phases, converged = (
            sum(getattr(one, name) for one in run) for name in ("phases", "converged")
        )
        whole = sum(one.outcome == "complete" for one in run)
        refused = sum(one.outcome == "refused" for one in some)
        broken, late = (
            sum(one.outcome == what for one in some) for what in ("broken", "out of time")
        )
        yield (
            f"{accuracy}: {len(some)} drives, {refused} refused, {broken} broke, {late} out of time; "
            f"of {len(run)} that ran "
            f"{whole} cycles are complete, {converged} of {phases} phases converged"
        )
        if run:
            yield (
                f"     wall {sum(one.wall for one in run):.0f} s, processor "
                f"{sum(one.processor for one in run):.0f} s, expected "
                f"{sum(one.expected for one in run):.0f} s; within a factor of {TIME_FACTOR:g}: "
                f"{sum(map(in_time, run))} of {len(run)}"
            )


def in_time(one: DriveVerdict) -> bool:
    """Whether a run took the time that was expected, within a factor."""
    return one.expected / TIME_FACTOR <= one.processor <= one.expected * TIME_FACTOR


def complaints_of_drives(verdicts: Sequence[DriveVerdict]) -> Iterator[str]:
    """What breaks a promise, a sentence each; fractions are judged where all drives of a seed were run."""
    for one in verdicts:
        if one.outcome in ("broken", "out of time"):
            yield f"{one.name} at {one.accuracy} is {one.outcome}: {one.reason}"
    for accuracy in ACCURACIES:
        some = [one for one in verdicts if one.accuracy == accuracy]
        run = [one for one in some if one.phases]
        if len(some) < DRIVES or not run:
            continue
        for what, share, promised in (
            (
                "phases converged",
                sum(one.converged for one in run) / sum(one.phases for one in run),
                PHASES,
            ),
            (
                "cycles are complete",
                sum(one.outcome == "complete" for one in run) / len(run),
                CYCLES,
            ),
            ("runs took the expected time", sum(map(in_time, run)) / len(run), TIMES),
        ):
            if share < promised:
                yield f"{share:.1%} of {what} at {accuracy}, {promised:.0%} are promised"
