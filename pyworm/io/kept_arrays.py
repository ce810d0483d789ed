"""Arrays kept in files of our own, for a later run to go on from: whole, or told to be damaged."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from pyworm.io.atomic import whole_file

Content = TypeVar("Content")


class DamagedError(ValueError):
    """A file of kept arrays that is not whole, or not one of ours."""


def keep(path: Path, **arrays: Any) -> None:
    """Write arrays, numbers and texts by their names, atomically; OSError where that fails."""
    with whole_file(path) as partial, partial.open("wb") as file:
        np.savez(file, **arrays)


def kept(path: Path, make: Callable[[dict[str, np.ndarray]], Content]) -> Content:
    """What is made of the arrays, by their names, in a file that `keep` has written.

    FileNotFoundError if there is none; DamagedError if it cannot be read, or `make` stumbles over its
    content.
    """
    try:
        with path.open("rb") as file, np.load(file) as arrays:
            return make(dict(arrays))
    except FileNotFoundError:
        raise
    except Exception as error:  # whatever a damaged archive makes the library stumble over
        raise DamagedError(f"{path}: is damaged ({type(error).__name__})") from error
