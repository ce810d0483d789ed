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
