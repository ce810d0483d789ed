"""Report pages without their pictures, which take most of the time that a page takes."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from pyworm.report.page.content import Picture


@contextmanager
def undrawn_pages() -> Iterator[None]:
    """Pictures of report pages are not drawn, for tests of what is written beside them."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "pyworm.report.page.pictures._drawn", lambda caption, draw: Picture(caption, b"")
        )
        yield


@contextmanager
def plain_pages() -> Iterator[None]:
    """Nor do they show how figures depend on oil and mounting, by tens of dry contacts; files of pictures are
    empty.
    """
    with undrawn_pages(), pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.attempts.write", lambda figure, path: path.touch() or path)
        patch.setattr("pyworm.report.page.build.sensitivity_section", lambda found: None)
        yield
