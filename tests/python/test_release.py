"""`make release` finds what disagrees, in copied trees where one thing does."""

import shutil
import subprocess
from datetime import date

import pytest
import release
import try_installed
from folders import ROOT

from pyworm.case.shipped import TEMPLATES

GIT = ("git", "-c", "user.name=Somebody", "-c", "user.email=somebody@example.org")
TODAY = date.fromisoformat(release.found(ROOT, "CITATION.cff", r"^date-released: (\S+)$"))
NUMBER = release.version(ROOT)


def git(root, *words):
    subprocess.run([*GIT, "-C", root, *words], check=True, capture_output=True)


@pytest.fixture(scope="module")
def original(tmp_path_factory):
    """A repository of the files that name the version, committed and tested."""
    root = tmp_path_factory.mktemp("original")
    for file in (*release.PLACES, "meson.build", "pyproject.toml", "CHANGELOG.md", ".gitignore"):
        (root / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, root / file)
    git(root, "init", "--quiet")
    git(root, "add", ".")
    git(root, "commit", "--quiet", "--message", "all")
    release.record_tests(root)
    return root


@pytest.fixture
def tree(original, tmp_path):
    return shutil.copytree(original, tmp_path / "tree")


def test_this_tree_agrees(original):
    assert [*release.texts(original, TODAY), *release.commit(original)] == []


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        ("CITATION.cff", f"version: {NUMBER}", "version: 9.9.9", "CITATION.cff: version 9.9.9, in"),
        ("CITATION.cff", "date-released: 2", "date-released: 1", "CITATION.cff: date-released 1"),
        ("CITATION.cff", "date-released", "released", "CITATION.cff: date-released None"),
        ("README.md", f"version {NUMBER},", "version 9.9.9,", "README.md: version 9.9.9, in"),
        ("docs/how-to/install.md", f"pyworm-{NUMBER}-cp", "pyworm-0-cp", "install.md: version 0, in"),
        ("fpm.toml", f'"{NUMBER}"', '"9.9"', "fpm.toml: version 9.9, in"),
        ("tools/conda-forge/recipe.yaml", f'"{NUMBER}"', '"9.9"', "recipe.yaml: version 9.9, in"),
        ("meson.build", f"'{NUMBER}'", "'9.9.9'", "in meson.build 9.9.9"),
        ("pyproject.toml", 'dynamic = ["version"]', 'version = "0"', "version must be dynamic"),
        ("pyproject.toml", "[project.scripts]", "[project.urls]\n[project.scripts]", "have addresses"),
        ("CHANGELOG.md", f"## {NUMBER}", "## Unreleased\n\n- x\n\n## 0", 'section "Unreleased", must'),
        ("CHANGELOG.md", "## ", f"## {NUMBER}, {TODAY}\n\n## ", "lists no change"),
    ],
)  # fmt: skip
def test_what_disagrees_is_said(tree, file, old, new, said):
    text = (tree / file).read_text()
    assert old in text
    (tree / file).write_text(text.replace(old, new, 1))
    assert any(said in line for line in release.texts(tree, TODAY))
    assert next(release.commit(tree)) == f"not committed: {file}"


def test_a_day_later_the_date_is_another(tree):
    later = date.fromordinal(TODAY.toordinal() + 1)
    assert [*release.texts(tree, later)] == [
        f"CITATION.cff: date-released {TODAY}, today is {later}"
    ]


def test_a_tag_and_a_commit_without_tests_are_said(tree):
    git(tree, "tag", f"v{NUMBER}")
    assert [*release.commit(tree)] == [f"v{NUMBER}: the tag is there already"]
    (tree / "new").write_text("new")
    release.record_tests(tree)  # of a changed tree nothing
    git(tree, "tag", "--delete", f"v{NUMBER}")
    git(tree, "add", "new")
    git(tree, "commit", "--quiet", "--message", "more")
    assert [*release.commit(tree)] == [
        "build/tested: not all tests have passed on this commit (.ci/run)"
    ]
    release.record_tests(tree)
    assert [*release.commit(tree)] == []


def test_wheels_are_built_by_this_version_and_tried(tree, monkeypatch):
    """A build that makes a wheel of another version, then one that fails."""
    (tree / "Makefile").write_text("wheel:\n\tmkdir -p dist; touch dist/pyworm-0-cp311-x.whl\n")
    (said,) = release.wheels(tree)
    assert said.startswith(f"dist: there must be one wheel pyworm-{NUMBER}-cp")
    (tree / "Makefile").write_text("wheel:\n\tfalse\n")
    assert [*release.wheels(tree)] == ["wheel: make wheel failed"]


def test_the_cheapest_examples_are_run_of_an_installed_wheel():
    assert try_installed.cheapest({"dear": 9.0, "cheap": 0.5, "between": 2.0}, 2) == [
        "cheap",
        "between",
    ]
    assert {path.stem for path in TEMPLATES.glob("*.toml")} == {*try_installed.KINDS}
    script, notebook = (ROOT / part for part in release.TRIAL)
    assert script.is_file() and "pyworm.solve(" in try_installed.code(notebook)
