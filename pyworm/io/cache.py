"""Directory in which measurements and tables of this machine are kept from run to run."""

import os
from pathlib import Path
from tempfile import gettempdir


def cache_directory() -> Path:
    """`pyworm` in the user's cache; in the directory of temporary files where there is no home."""
    root = os.environ.get("XDG_CACHE_HOME")
    if root:
        return Path(root) / "pyworm"
    try:
        return Path.home() / ".cache" / "pyworm"
    except RuntimeError:  # neither HOME nor an entry for the user, as in some containers
        return Path(gettempdir()) / "pyworm"
