"""JSON output for programs."""

import json
import math
from typing import Any

from pyworm.io.terminal import print_result


def print_json(content: dict[str, Any]) -> None:
    """Print an object as JSON on standard output."""
    print_result(as_json(content))


def as_json(content: dict[str, Any]) -> str:
    """An object as JSON; NaN and infinity become null."""
    return json.dumps(finite(content), indent=2, default=lambda scalar: scalar.item())  # numpy's


def finite(content: Any) -> Any:
    """Replace NaN and infinity, which JSON does not have, by null."""
    if isinstance(content, dict):
        return {key: finite(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [finite(value) for value in content]
    if isinstance(content, float) and not math.isfinite(content):
        return None
    return content
