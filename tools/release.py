"""Check that a tree can be released, and print the command that tags it. Called by `make release`.

All that is wrong is printed, a line each: versions that differ, changelog, citation, a tree that is not
committed or not tested. If nothing is, wheels are built, and the one for this Python is installed and run.
Usage: tools/release.py [--tested]; with --tested record that the tests passed on this commit (`.ci/run`).
"""

import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from datetime import date
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]

PLACES = {
    "CITATION.cff": r"^version: (\S+)$",
    "README.md": r"version (\d\S*), software",
    "docs/how-to/install.md": r"pyworm-(\d[^-]*)-cp",
    "tools/conda-forge/recipe.yaml": r'^  version: "(.*)"$',
    "fpm.toml": r'^version = "(.*)"$',
    "fortran/base/version_number.f90": r"pyworm_version = '(.*)'$",
}
"""File -> where it names the version, which is that of meson.build."""

STAMP = "build/tested"
"""File with the git tree on which all tests have passed."""

TRIAL = ("tools/try_installed.py", "examples/ball_on_disc.ipynb")
"""What an installed wheel is tried with, and the notebook that it runs."""


def found(root: Path, file: str, pattern: str) -> str | None:
    """First group of a pattern in a file; None if it is not there."""
    match = re.search(pattern, (root / file).read_text(encoding="utf-8"), re.MULTILINE)
    return match[1] if match else None


def version(root: Path) -> str | None:
    """The version of the tree."""
    return found(root, "meson.build", r"^  version: '(.*)',$")


def git(root: Path, *words: str) -> str:
    """Output of a git command; empty if it fails."""
    command = ["git", "-C", str(root), *words]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.rstrip()


def texts(root: Path, today: date) -> Iterator[str]:
    """What is wrong in the files that name the version, its date or the project's address."""
    number, released = version(root), found(root, "CITATION.cff", r"^date-released: (\S+)$")
    for file, pattern in PLACES.items():
        if (other := found(root, file, pattern)) != number:
            yield f"{file}: version {other}, in meson.build {number}"
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    if "version" not in project.get("dynamic", ()):
        yield "pyproject.toml: version must be dynamic, of meson.build"
    urls = project.get("urls", {"none": "https://"}).values()
    if not urls or not all(url.startswith("https://") for url in urls):
        yield "pyproject.toml: [project.urls] must have addresses, or be left out"
    if released != today.isoformat():
        yield f"CITATION.cff: date-released {released}, today is {today}"
    _, first, *_ = (root / "CHANGELOG.md").read_text(encoding="utf-8").split("\n## ")
    heading, _, section = first.partition("\n")
    if heading != f"{number}, {released}":
        yield f'CHANGELOG.md: first section "{heading}", must be "{number}, {released}"'
    if "\n- " not in section:
        yield f"CHANGELOG.md: section {heading} lists no change"


def commit(root: Path) -> Iterator[str]:
    """What is wrong with the commit to be tagged."""
    changed = git(root, "status", "--porcelain").splitlines()
    if changed:
        yield f"not committed: {', '.join(line[3:] for line in changed[:5])}"
    if git(root, "tag", "--list", f"v{version(root)}"):
        yield f"v{version(root)}: the tag is there already"
    stamp = root / STAMP
    if not stamp.is_file() or stamp.read_text() != git(root, "rev-parse", "HEAD^{tree}"):
        yield f"{STAMP}: not all tests have passed on this commit (.ci/run)"


def record_tests(root: Path) -> None:
    """Record that all tests have passed on this commit, where nothing is changed beside it."""
    tree = git(root, "rev-parse", "HEAD^{tree}")
    if not tree or git(root, "status", "--porcelain"):
        print("nothing recorded for a release: changes that are not committed", file=sys.stderr)
        return
    (root / STAMP).parent.mkdir(exist_ok=True)
    (root / STAMP).write_text(tree)


def wheels(root: Path) -> Iterator[str]:
    """What is wrong with the wheels; builds them, and installs and runs that for this Python."""
    python = "cp{}{}".format(*sys.version_info[:2])
    folder = root / "build/release"
    try:
        subprocess.run(["make", "wheel"], cwd=root, check=True)
        (wheel,) = (root / "dist").glob(f"pyworm-{version(root)}-{python}-*.whl")
        subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
        subprocess.run([folder / "bin/pip", "install", "--quiet", wheel], check=True)
        script, notebook = (root / part for part in TRIAL)
        with TemporaryDirectory() as away:
            subprocess.run([folder / "bin/python", script, away, notebook], check=True)
    except subprocess.CalledProcessError as error:
        yield f"wheel: {' '.join(map(str, error.cmd))} failed"
    except ValueError:
        yield f"dist: there must be one wheel pyworm-{version(root)}-{python}"


def main() -> int:
    """Check the tree; the exit code is 1 if it cannot be released."""
    if "--tested" in sys.argv:
        record_tests(ROOT)
        return 0
    wrong = [*texts(ROOT, date.today()), *commit(ROOT)] or [*wheels(ROOT)]
    number = version(ROOT)
    tag = (
        f'pyworm {number} can be released: git tag --annotate v{number} --message "pyworm {number}"'
    )
    print("\n".join(wrong or [tag]), file=sys.stderr if wrong else sys.stdout)
    return bool(wrong)


if __name__ == "__main__":
    raise SystemExit(main())
