"""Fixtures of drives."""

import pytest
from zi_drives import coarse_patterns, coarse_springs


@pytest.fixture(scope="module")
def coarse_mesh():
    """Fewer places, phases and loads: a set-up is looked for at many."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_patterns(patch)
        coarse_springs(patch)
        yield
