"""Values of an immutable object are found once, by what they depend on."""

import pickle
from dataclasses import dataclass, replace

import pytest

from pyworm.drives import cached as module
from pyworm.drives.cached import cached

ASKED = []


@dataclass(frozen=True)
class Asked:
    offset: float

    @cached
    def sum(self, one, other):
        ASKED.append((one, other))
        return self.offset + one + other


@pytest.fixture(autouse=True)
def nothing_asked():
    ASKED.clear()


def test_each_value_is_found_once_and_by_its_arguments():
    asked = Asked(1.0)
    assert [asked.sum(1, 2), asked.sum(2, 2), asked.sum(1, 2)] == [4.0, 5.0, 4.0]
    assert ASKED == [(1, 2), (2, 2)]


def test_another_object_keeps_its_own_and_a_copy_starts_empty():
    asked = Asked(1.0)
    asked.sum(1, 2)
    assert replace(asked, offset=2.0).sum(1, 2) == 5.0
    there = pickle.loads(pickle.dumps(asked))
    assert there == asked and there.sum(1, 2) == 4.0
    assert len(ASKED) == 3


def test_the_least_recently_used_goes(monkeypatch):
    monkeypatch.setattr(module, "MAX_KEPT_VALUES", 2)
    asked = Asked(0.0)
    for one in (1, 2, 1, 3, 1, 2):
        asked.sum(one, 0)
    assert ASKED == [(1, 0), (2, 0), (3, 0), (2, 0)]
