"""Folders of the project that tests read."""

from pathlib import Path

ROOT = Path(__file__).parents[2]

CASES = ROOT / "cases"

DATA = ROOT / "tests" / "data"
"""Files of tests alone."""

PACKAGE = ROOT / "pyworm"
