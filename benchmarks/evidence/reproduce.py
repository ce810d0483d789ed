"""Run the short commands of the evidence, one after the other: make evidence.

The list is `docs/evidence/data/commands.csv`: each command, the processor time that it takes, and the data
that it writes. From the repository's root, without names all short ones:

    python benchmarks/evidence/reproduce.py [NAME ...]
"""

import os
import re
import shlex
import subprocess
import sys

from evidence_data import ROOT, read
from evidence_pages import write_tables

LIST = "commands"

BLANK = re.compile(r"\b(?:KIND|COUNT|SEED|NUMBER)\b")
"""What a command of the list leaves to be chosen."""


def commands(names: list[str]) -> list[str]:
    """The commands that write some data, or without names all short ones.

    Raises:
        SystemExit: If there are no such data, or if a command has to be completed by hand.
    """
    listed = read(LIST)
    rows = [dict(zip(listed.columns, row, strict=True)) for row in listed.rows]
    known = {name: row["command"] for row in rows for name in row["data"].split()}
    if strange := [name for name in names if name not in known]:
        raise SystemExit(f"{strange[0]}: {LIST} has no such data")
    if not names:
        return [row["command"] for row in rows if row["length"] == "short"]
    found = list(dict.fromkeys(known[name] for name in names))
    if blank := [command for command in found if BLANK.search(command)]:
        raise SystemExit(
            f"{blank[0]}: choose {', '.join(BLANK.findall(blank[0]))} and start it by hand"
        )
    return found


def run(command: str) -> None:
    """Run a command, which may begin with variables of the environment, by this interpreter."""
    print(f"\n$ {command}", flush=True)
    words = shlex.split(command)
    given = {}
    while "=" in words[0]:
        name, value = words.pop(0).split("=", 1)
        given[name] = value
    if words[0] == "python":
        words[0] = sys.executable
    subprocess.run(words, cwd=ROOT, env=os.environ | given, check=True)


def main() -> None:
    for command in commands(sys.argv[1:]):
        for part in command.split(" && "):
            run(part)
    write_tables()


if __name__ == "__main__":
    main()
