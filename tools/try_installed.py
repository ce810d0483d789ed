"""Try the installed pyworm of a Python as a user does, away from the repository. Called by `make release`.

Every example is written and checked, the cheapest are run, so is each template of `pyworm new`; a result
becomes a report and a page; the code of a notebook runs. Usage: PYTHON tools/try_installed.py FOLDER NOTEBOOK
"""

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

KINDS = ("ball", "line", "gear-pair", "roller")
"""Templates of `pyworm new`."""

RUNS = 10
"""Number of examples that are run."""

ACCURACY = ("--accuracy", "10%")


def pyworm(folder: Path, *words: str) -> str:
    """Standard output of a command; CalledProcessError if it fails."""
    print("pyworm", *words, flush=True)
    program = Path(sys.executable).with_name("pyworm")
    done = subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.PIPE)
    return done.stdout.decode()


def names(folder: Path) -> list[str]:
    """Names of all examples, as the installed package lists them."""
    ask = "from pyworm.case.shipped import examples; print(*examples())"
    done = subprocess.run(
        [sys.executable, "-c", ask], cwd=folder, check=True, stdout=subprocess.PIPE
    )
    return done.stdout.decode().split()


def cheapest(seconds: Mapping[str, float], count: int = RUNS) -> list[str]:
    """Names of the examples that take the least expected time."""
    return sorted(seconds, key=lambda name: seconds[name])[:count]


def expected(folder: Path, name: str) -> float:
    """Expected time of a case [s], by its check."""
    found = json.loads(pyworm(folder, "check", f"{name}.toml", "--json", *ACCURACY))
    return float(found["expected_seconds"] + found["expected_seconds_of_search"])


def code(notebook: Path) -> str:
    """The code of a notebook."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


def main(folder: Path, notebook: Path) -> None:
    """Try everything; the first command that fails ends it with a CalledProcessError."""
    script = code(notebook)
    folder.mkdir(parents=True, exist_ok=True)
    print(pyworm(folder, "--version").strip())
    rated = [name for name in names(folder) if "pyworm rate" in pyworm(folder, "example", name)]
    for name in rated:
        pyworm(folder, "rate", f"{name}.toml")
    solved = [name for name in names(folder) if name not in rated]
    seconds = {name: expected(folder, name) for name in solved}
    for name in cheapest(seconds):
        how = *ACCURACY, "--pictures", "none", "--out", f"results/{name}"
        pyworm(folder, "run", f"{name}.toml", *how)
    result = f"results/{cheapest(seconds)[0]}/result.nc"
    for command in ("report", "explore"):
        pyworm(folder, command, result)
    for kind in KINDS:
        pyworm(folder, "new", f"new_{kind}.toml", "--kind", kind)
        expected(folder, f"new_{kind}")
    subprocess.run([sys.executable, "-c", script], cwd=folder, check=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]).resolve())
