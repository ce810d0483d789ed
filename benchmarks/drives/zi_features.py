"""What Sharif et al. (2001, section 6) describe of the worm's heated film, measured in a result.

Rises are those over the inlet's temperature, places in the tangent plane. Run from the repository's root:

    pyworm run cases/zi_sharif_2001.toml --phase 0.5 --out results/zi_features
    python benchmarks/drives/zi_features.py results/zi_features/result.nc
"""

import sys
from pathlib import Path

import numpy as np
import xarray as xr

from pyworm.result.result import open_result

MM = 1e-3
HIGH = 100e6
"""Pressure whose contour the paper compares with the dry contact [Pa]."""


def at(field: xr.DataArray, x: float, y: float) -> float:
    """Value at a place given in mm."""
    return float(field.interp(x=x * MM, y=y * MM))


def largest(field: xr.DataArray) -> str:
    """Place and value of a field's largest node."""
    node = field.argmax(dim=("x", "y"))
    return f"at ({float(field.x[node['x']]) / MM:.2f}, {float(field.y[node['y']]) / MM:.2f}) mm"


def valleys(film: np.ndarray, dry: np.ndarray) -> np.ndarray:
    """Nodes of a line across the contact where its film is least nearby."""
    inner = (film[1:-1] < film[:-2]) & (film[1:-1] <= film[2:]) & dry[1:-1]
    return np.flatnonzero(inner) + 1


def distance_outside(fields: xr.Dataset, dry: np.ndarray) -> float:
    """How far beyond the dry contact pressure is high [m], from node to nearest node."""
    beyond = np.argwhere((fields.pressure.values > HIGH) & ~dry)
    if not len(beyond):
        return 0.0
    spacing = np.array([float(np.diff(fields.y)[0]), float(np.diff(fields.x)[0])])
    inside = np.argwhere(dry)
    return max(float(np.hypot(*((inside - node) * spacing).T).min()) for node in beyond)


def main() -> None:
    solution = open_result(Path(sys.argv[1])).solutions[0]
    fields = solution.fields
    dry = fields.dry_pressure.values > 0
    rise = {
        place: fields[f"temperature_{name}"] - solution.inlet_temperature
        for place, name in (("worm", "body_1"), ("wheel", "body_2"), ("mid-film", "middle"))
    }
    for place, field in rise.items():
        print(f"{place}: hottest {largest(field)}, {float(field.max()):.1f} K")
    lines = fields.dry_pressure.where(dry)
    along = rise["worm"].where(lines > 0).max("y")
    print(
        "worm, largest rise at x:",
        [(x, round(float(along.interp(x=x * MM)), 1)) for x in (-8, -4, 0, 4, 6, 8)],
    )
    print(
        "wheel at x = 3 mm, y:",
        [(y, round(at(rise["wheel"], 3, y), 1)) for y in (0.9, 0.3, -0.3, -0.6, -0.9)],
    )
    for what, place in (
        ("half a millimetre below the inlet", (-7, -1.24)),
        ("half a millimetre below the inlet", (-9, -0.74)),
        ("main inlet", (-13, 0.2)),
        ("main inlet", (-10.5, 0.2)),
    ):
        print(
            f"{what}, {place} mm:",
            {name: round(at(field, *place), 1) for name, field in rise.items()},
        )
    for x in (-4, -2, 0, 2, 4, 6):
        column = int(np.argmin(abs(fields.x.values - x * MM)))
        film = fields.film.values[:, column]
        low = valleys(film, dry[:, column])
        print(
            f"x = {x} mm, minimum film thicknesses:",
            [(round(float(fields.y[j]) / MM, 2), round(float(film[j]) * 1e6, 2)) for j in low],
        )
    print("film on y = 0:", [(x, round(at(fields.film, x, 0) * 1e6, 2)) for x in (-4, 4, 10)])
    outside = fields.pressure.where(~dry, 0.0)
    print(
        f"outside the dry contact at most {float(outside.max()) / 1e6:.0f} MPa {largest(outside)}; "
        f"100 MPa reach {distance_outside(fields, dry) / MM:.2f} mm beyond it, "
        f"{float((fields.pressure.values > HIGH)[dry].mean()):.0%} of it is above"
    )
    power = fields.friction_power * float(np.diff(fields.x)[0] * np.diff(fields.y)[0])
    share = fields.pressure / fields.pressure.max()
    print(
        "power [W] where pressure exceeds a share of the largest:",
        [
            (over, round(float(power.where(share > over).sum())))
            for over in (0.1, 0.05, 0.02, 0.01, 0.001, 0)
        ],
        f"all {float(power.sum()):.0f}",
    )
    stress = np.hypot(fields.shear_stress_x, fields.shear_stress_y)
    print(
        f"largest stress {float(stress.max()) / 1e6:.1f} MPa; nodes that slip: {int((fields.slip > 0).sum())}"
    )


if __name__ == "__main__":
    main()
