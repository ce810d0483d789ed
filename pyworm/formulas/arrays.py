"""Kinds of arrays, and of numbers that may be arrays, as types."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Numbers, of any shape."""

Flags = NDArray[np.bool_]
"""True or false of each entry, of any shape."""

Indices = NDArray[np.int_]
"""Places in other arrays, counted from 0."""

Values = float | Array
"""A number or an array of numbers."""

Alike = TypeVar("Alike", float, Array)
"""A number where a number is given, an array where an array is."""
