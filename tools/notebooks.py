"""Write the notebooks of the gallery from its scripts: python tools/notebooks.py."""

import json
import re
from pathlib import Path

EXAMPLES = Path(__file__).parents[1] / "examples"

NOTEBOOKS = ("ball_on_disc", "traction_map", "oil_comparison")
"""Scripts that are notebooks too."""


def notebook(name: str) -> str:
    """The notebook of a script: its first line as a heading, its blocks as cells, without arguments."""
    text = (EXAMPLES / f"{name}.py").read_text()
    _, title, code = text.split('"""', 2)
    code = code.replace("import sys\n\n", "")
    code = re.sub(r"accuracy = sys.argv.* else (.*)\n", r"accuracy = \1\n", code)
    imports, rest = code.strip().split("accuracy =", 1)
    cells = [{"cell_type": "markdown", "metadata": {}, "source": [f"# {title}"]}]
    cells += [
        {
            "cell_type": "code",
            "execution_count": None,
            "metadata": {},
            "outputs": [],
            "source": part.strip().splitlines(keepends=True),
        }
        for part in (imports, f"accuracy ={rest}")
    ]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    content = {
        "cells": cells,
        "metadata": {"kernelspec": kernel},
        "nbformat": 4,
        "nbformat_minor": 4,
    }
    return json.dumps(content, indent=1) + "\n"


if __name__ == "__main__":
    for name in NOTEBOOKS:
        (EXAMPLES / f"{name}.ipynb").write_text(notebook(name))
