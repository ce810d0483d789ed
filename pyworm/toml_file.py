"""Reading TOML files."""

import tomllib
from pathlib import Path
from typing import Any

from pyworm.case_error import CaseError


def read_toml(path: Path) -> dict[str, Any]:
    """What stands in a TOML file; CaseError if nothing can be read there."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise CaseError(f"{path}: no such file") from None
    except (OSError, UnicodeDecodeError) as error:
        raise CaseError(f"{path}: cannot be read ({error})") from None
    except tomllib.TOMLDecodeError as error:
        raise CaseError(f"{path}: not a TOML file: {error}") from None
