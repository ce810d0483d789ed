"""The list of mutations (tests/mutants): each can still be made, and its tests are there."""

from collections import Counter

import pytest
from rules import ROOT, Mutation, mutations

LISTED = mutations()
PROGRAMS = (ROOT / "tests" / "fortran" / "programs.txt").read_text().split()


@pytest.mark.parametrize("mutation", LISTED, ids=lambda mutation: mutation.name)
def test_a_mutation_changes_one_line_of_the_program(mutation):
    changed = mutation.applied()
    assert changed is not None, f"{mutation.old!r} is not in {mutation.file} once"
    before = (ROOT / mutation.file).read_text().splitlines()
    after = changed.splitlines()
    assert len(before) == len(after)
    assert sum(one != other for one, other in zip(before, after, strict=True)) == 1


@pytest.mark.parametrize("mutation", LISTED, ids=lambda mutation: mutation.name)
def test_its_tests_are_there(mutation):
    assert mutation.tests
    for program in mutation.programs:
        assert program in PROGRAMS
    for test in mutation.python_tests:
        file, _, name = test.partition("::")
        text = (ROOT / file).read_text()
        assert not name or f"def {name}(" in text, test


def test_there_are_enough_of_the_kernel_and_of_python_and_none_twice():
    kernel = sum(mutation.in_kernel for mutation in LISTED)
    assert kernel >= 35 and len(LISTED) - kernel >= 45
    assert max(Counter(mutation.name for mutation in LISTED).values()) == 1


def test_a_line_that_is_gone_or_there_twice_cannot_be_mutated(tmp_path):
    (tmp_path / "twice.py").write_text("a = 1\nb = a\nc = a\n")
    for file, old, new in (
        ("nowhere.py", "a", "b"),
        ("twice.py", "= a", "= b"),
        ("twice.py", "d = 1", "d = 2"),
    ):
        assert Mutation("gone", file, old, new, ("oil_laws",)).applied(tmp_path) is None
    once = Mutation("once", "twice.py", "b = a", "b = 2", ("oil_laws",))
    assert once.applied(tmp_path) == "a = 1\nb = 2\nc = a\n"
