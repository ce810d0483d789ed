"""The charts of docs/oils.md: viscosity and pressure-viscosity coefficient of gear oils over temperature.

python benchmarks/oil_charts.py [DIRECTORY]
"""

import sys
from pathlib import Path

from pyworm.named_oils import BASES, named_oil
from pyworm.plots.oil import draw_pressure_viscosity, draw_viscosity


def main() -> None:
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else "docs/pictures")
    oils = [named_oil(f"{base} VG {grade}") for base in BASES for grade in (100, 220, 460)]
    draw_viscosity(oils).savefig(directory / "oil_viscosity.png", dpi=110)
    draw_pressure_viscosity(oils).savefig(directory / "oil_pressure_viscosity.png", dpi=110)


if __name__ == "__main__":
    main()
