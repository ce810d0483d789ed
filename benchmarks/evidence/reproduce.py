"""Run the short commands of the evidence, one after the other: make evidence.

The list is `docs/evidence/data/commands.csv`: each command, the processor time that it takes, and the data
that it writes. From the repository's root, without names all short ones:

    python benchmarks/evidence/reproduce.py [NAME ...]
"""

import shlex
import subprocess
import sys

from evidence_data import ROOT, read
from evidence_pages import write_tables

LIST = "commands"


def commands(names: list[str]) -> list[str]:
    """The commands that write some data, or without names all short ones."""
    listed = read(LIST)
    rows = [dict(zip(listed.columns, row, strict=True)) for row in listed.rows]
    known = {name: row["command"] for row in rows for name in row["data"].split()}
    if strange := [name for name in names if name not in known]:
        raise SystemExit(f"{strange[0]}: {LIST} has no such data")
    if names:
        return list(dict.fromkeys(known[name] for name in names))
    return [row["command"] for row in rows if row["length"] == "short"]


def main() -> None:
    for command in commands(sys.argv[1:]):
        for part in command.split(" && "):
            print(f"\n$ {part}", flush=True)
            words = shlex.split(part)
            subprocess.run(
                [sys.executable if words[0] == "python" else words[0], *words[1:]],
                cwd=ROOT,
                check=True,
            )
    write_tables()


if __name__ == "__main__":
    main()
