"""A page of HTML as PDF, printed by a Chromium browser of this machine."""

import shutil
import subprocess
import tempfile
from pathlib import Path

from pyworm.io.input_error import CaseError

BROWSERS = (
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "msedge",
)
"""Names of browsers that print without a window."""

PATIENCE = 120.0
"""How long one may take [s]."""


def browser() -> str | None:
    """Path of the first of `BROWSERS` that is installed; None without any."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def print_pdf(page: Path, pdf: Path) -> None:
    """Print a page; CaseError if there is no such browser, or it failed."""
    found = browser()
    if found is None:
        raise CaseError(
            f"--pdf: none of {', '.join(BROWSERS)} is installed; install one (apt install chromium), or open "
            f"{page} in any browser and print it to a file"
        )
    with tempfile.TemporaryDirectory() as home:
        command = [
            found, "--headless", "--disable-gpu", "--no-sandbox", "--no-pdf-header-footer",
            f"--user-data-dir={home}", f"--print-to-pdf={pdf}", page.resolve().as_uri(),
        ]  # fmt: skip
        try:
            subprocess.run(command, check=True, capture_output=True, timeout=PATIENCE)
        except (subprocess.SubprocessError, OSError) as error:
            raise CaseError(f"--pdf: {found} did not print {page}: {error}") from None
    if not pdf.is_file() or not pdf.stat().st_size:
        raise CaseError(f"--pdf: {found} printed nothing of {page}")
