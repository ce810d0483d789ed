"""Provenance: what made a result is told, down to the compiled kernel."""

import shutil
import subprocess
from hashlib import sha256
from pathlib import Path

import pytest
from folders import ROOT

from pyworm import _core, kernel
from pyworm.batch import provenance
from pyworm.batch.provenance import where_and_when


def test_provenance_names_compiler_flags_and_kernel():
    said = where_and_when()
    version = subprocess.run(["gfortran", "-dumpfullversion"], capture_output=True, text=True)
    assert version.stdout.strip() in said["compiler"]
    flags = said["compiler_flags"].split()
    assert "-O3" in flags and "-fopenmp" in flags and "-std=f2018" in flags
    assert len(flags) == len(set(flags)) and not any("/" in flag for flag in flags)
    content = Path(_core.__file__).read_bytes()
    assert sha256(content).hexdigest().startswith(said["kernel_digest"])


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="not a checkout")
def test_provenance_names_the_commit():
    head = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True)
    assert where_and_when()["commit"].split(",")[0] == head.stdout.strip()


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    """A repository with one commit, in place of that of the program."""
    if shutil.which("git") is None:
        pytest.skip("there is no git")
    (tmp_path / "pyworm").mkdir()
    source = tmp_path / "pyworm" / "__init__.py"
    source.write_text("")
    who = ["-c", "user.name=A", "-c", "user.email=a@b"]
    for command in (["init", "-q"], ["add", "."], [*who, "commit", "-qm", "first"]):
        subprocess.run(["git", "-C", tmp_path, *command], check=True)
    monkeypatch.setattr(provenance.pyworm, "__file__", str(source))
    provenance.origin.cache_clear()
    yield source
    provenance.origin.cache_clear()


def test_sources_changed_since_their_commit_are_marked(checkout):
    clean = provenance.origin()["commit"]
    assert len(clean) == 40
    checkout.write_text("changed = True\n")
    provenance.origin.cache_clear()
    assert provenance.origin()["commit"] == f"{clean}, changed since"


def test_without_git_there_is_no_commit(checkout, monkeypatch):
    monkeypatch.setenv("PATH", "")
    assert "commit" not in provenance.origin()


def test_an_installed_package_has_no_commit(checkout):
    shutil.rmtree(checkout.parents[1] / ".git")
    assert "commit" not in provenance.origin()
    assert provenance.origin()["compiler"] == kernel.compiled_with()[0]
