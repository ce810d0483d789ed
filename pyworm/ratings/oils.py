"""The oil that a table names."""

from pathlib import Path

from pyworm.case_error import CaseError
from pyworm.named_oils import NamedOil, named_oil, read_oil


def oil_called(name: str, directory: Path) -> NamedOil:
    """The oil of a name ("PAG VG 460"), or of a file, relative to a directory, whose name ends in .toml.

    Raises
    ------
    CaseError
        No such oil, or no oil in the file.
    """
    if name.endswith(".toml"):
        return read_oil(directory / name)
    try:
        return named_oil(name)
    except ValueError as error:
        raise CaseError(str(error)) from error
