"""Whether a change of the code leaves the results of eight contacts as they were, to the last bit.

    python benchmarks/cost/same_bits.py keep FILE      # solve them; keep figures and digests of fields
    python benchmarks/cost/same_bits.py compare FILE   # solve them again; exit code 1 if anything differs

Run both on one machine. A contact that differs is told with the largest relative change of its figures.
"""

import json
import sys
from hashlib import sha256
from pathlib import Path

import numpy as np

import pyworm

CONTACTS = {
    "point, isothermal": ("mourier_2006.toml", "isothermal", 0.05),
    "point, thermal": ("ball_pag_460.toml", "all", 0.05),
    "line, isothermal": ("line_m20_l10.toml", "isothermal", 0.01),
    "line, thermal": ("line_thermal.toml", "all", 0.05),
    "ZI worm, isothermal": ("zi_sharif_2001.toml", "isothermal", 0.1),
    "ZI worm, thermal": ("zi_sharif_2001.toml", "auto", 0.1),
    "roller worm": ("roller_ref.toml", "auto", 0.05),
    "gear pair": ("spur_pair.toml", "auto", 0.05),
}
"""Name of a contact -> its case file, effects and accuracy; the contact in the middle of a mesh cycle."""

COST = {"seconds", "convolutions"}
"""Keys of a summary that differ from run to run."""

LEFT = ("error", "residual", "balance")
"""Parts of the names of what an iteration leaves: their relative changes mean nothing."""


def result_of(case_file: str, effects: str, accuracy: float) -> dict:
    """Figures of a solved contact and a digest of each of its fields."""
    case = pyworm.load(Path(__file__).parents[2] / "cases" / case_file)
    places = case.places()
    scene = case.scene(**places[len(places) // 2].given)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    digests = {
        str(name): sha256(np.ascontiguousarray(field.values).tobytes()).hexdigest()
        for name, field in sorted(solution.fields.items())
    }
    figures = {key: value for key, value in solution.summary().items() if key not in COST}
    return {"figures": json.loads(json.dumps(figures)), "fields": digests}


def numbers(value: object, name: str = "") -> dict[str, float]:
    """All numbers within figures, by name."""
    if isinstance(value, dict):
        parts = value.items()
    elif isinstance(value, list):
        parts = enumerate(value)
    else:
        return {name: float(value)} if isinstance(value, int | float) else {}
    return {
        key: number for part, of in parts for key, number in numbers(of, f"{name}.{part}").items()
    }


def differences(before: dict, after: dict) -> str:
    """What differs between two results; empty where nothing does."""
    fields = [
        name for name, digest in before["fields"].items() if after["fields"].get(name) != digest
    ]
    old, new = numbers(before["figures"]), numbers(after["figures"])
    moved = {
        name.lstrip("."): abs(new[name] / value - 1) if value else abs(new[name])
        for name, value in old.items()
        if name in new and new[name] != value
    }
    if not fields and not moved and before["figures"].keys() <= after["figures"].keys():
        return ""
    meant = [name for name in moved if not any(part in name for part in LEFT)]
    largest = max(meant, key=moved.get, default=None)
    figures = "" if largest is None else f"; {largest} moves most, by {moved[largest]:.1e}"
    return f"{len(fields)} fields and {len(moved)} figures differ{figures}"


def main(action: str, file: str) -> int:
    """Keep results, or compare with those kept."""
    results = {name: result_of(*contact) for name, contact in CONTACTS.items()}
    if action == "keep":
        Path(file).write_text(json.dumps(results, indent=1))
        return 0
    kept = json.loads(Path(file).read_text())
    found = {name: differences(kept[name], result) for name, result in results.items()}
    for name, difference in found.items():
        print(f"{name:22}{difference or 'the same bits'}")
    return 1 if any(found.values()) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
