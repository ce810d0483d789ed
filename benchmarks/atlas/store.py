"""Write a table of the atlas as a NetCDF file beside it.

python benchmarks/atlas/store.py atlas/films.csv
python benchmarks/atlas/store.py atlas/thermal.csv
"""

import argparse
import sys
from pathlib import Path

import xarray as xr

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.table import TEXTS, columns

import pyworm

SCHEMA = {
    "number": "number of the contact in the sequence of benchmarks/atlas/contacts.py",
    "moes_m": "Moes' load parameter M by the radius along the entrainment",
    "moes_l": "Moes' lubricant parameter L by the radius along the entrainment, alpha at zero pressure",
    "ratio": "larger relative radius over the smaller one",
    "angle": "angle of the entrainment from the direction of the smaller radius [deg]",
    "spin": "mean angular velocity, positive from smaller to larger radius, times Hertz's longer semi-axis, "
    "over the entrainment speed",
    "viscosity": "constant eta0 of Roelands' law [Pa s]",
    "z": "exponent of Roelands' law; pole pressure 196 MPa, pole viscosity exp(-9.67) Pa s",
    "barus": "1: viscosity by Barus' law with the same alpha instead",
    "compressible": "1: density 1 + 0.6 p/(1 + 1.7 p), p in GPa; 0: constant",
    "alpha": "pressure-viscosity coefficient at zero pressure [1/Pa]",
    "alpha_pressure": "alpha times the Hertz pressure",
    "film_central": "film at the contact point over R (2U)^(1/2)",
    "film_central_error": "relative error bar of the central film",
    "film_min": "least film over R (2U)^(1/2)",
    "film_min_error": "relative error bar of the least film",
    "film_min_x": "place of the least film along the smaller radius over Hertz's semi-axis there",
    "film_min_y": "place of the least film along the larger radius over Hertz's semi-axis there",
    "film_min_kind": "side lobe, exit or middle",
    "film_exit_min": "least film on the entrainment line through the contact point over R (2U)^(1/2)",
    "film_lift": "increase of the rigid separation by the film over R (2U)^(1/2)",
    "pressure_max": "largest pressure over Hertz's",
    "pressure_max_error": "relative error bar of the largest pressure",
    "certified": "1: both films have error bars of 0.5 % or less (thermal contacts: 5 %)",
    "status": "why the solver stopped",
    "grid_x": "nodes along the smaller radius",
    "grid_y": "nodes along the larger radius",
    "convolutions": "processor time in convolutions on the finest grid",
    "seconds": "elapsed time on a shared machine [s]",
    "sliding": "slide-roll ratio, sliding along the entrainment over the entrainment speed",
    "loading": "thermal loading eta0 beta u^2/k of the inlet",
    "conductivity_ratio": "conductivity of the oil over that of the bodies",
    "eyring": "Eyring stress over the Hertz pressure, also the limiting stress at ambient pressure",
    "limiting": "rise of the limiting stress with pressure",
    "friction": "coefficient of friction",
    "friction_error": "relative error bar of the friction",
    "warming": "largest rise of the film's temperature above the inlet times beta",
    "warming_error": "relative error bar of the rise",
}
"""Meaning of each column; the last nine are of thermal contacts."""

KINDS = {
    True: ("thermal elastohydrodynamic", "with heat, Eyring and limiting stress"),
    False: ("isothermal elastohydrodynamic", "Newtonian"),
}
"""Of contacts with and without heat: what they are, and what their oil does."""


def dataset(table: Path) -> xr.Dataset:
    """The table with the meaning of its columns."""
    found = columns(table)
    kind, oil = KINDS["loading" in found]
    data = {
        name: ("contact", of if name in TEXTS else of.astype(float), {"long_name": SCHEMA[name]})
        for name, of in found.items()
    }
    return xr.Dataset(
        data,
        attrs={
            "title": f"Converged films of {kind} point contacts",
            "source": f"pyworm {pyworm.__version__}, benchmarks/atlas/make.py",
            "license": "BSD-3-Clause, as pyworm",
            "references": "docs/reference/atlas.md",
            "conventions": "R is the radius along the entrainment, U = eta0 u/(E' R) with the mean speed u; "
            f"steady, smooth, fully flooded, {oil}, elastic half-spaces",
        },
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    table = parser.parse_args().table
    dataset(table).to_netcdf(table.with_suffix(".nc"), engine="netcdf4")


if __name__ == "__main__":
    main()
