"""Plastics of wheels against heat deflection, glass transition, melting and other books' values."""

from itertools import pairwise
from math import log
from pathlib import Path

from chapter import MEMORY, Chapter, Clause, falls, rises, within_factor
from constant_slips import Check, TableNumbers

from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.materials.softening import modulus_at

SOLIDS_TABLE = Path(__file__).parents[2] / "pyworm/materials/solids.toml"

NAMES = ("PA66", "PA46", "POM-C", "POM-H", "PEEK")

MELTING = {"PA66": 262, "PA46": 292, "POM-C": 166, "POM-H": 175, "PEEK": 343}
"""Melting temperatures [degC], read in data sheets of grades, Netzsch's page on PA46 and encyclopedias."""

GLASS = {"PA66": 60, "PA46": 75, "PEEK": 143}
"""Glass transitions [degC], read likewise; that of POM lies below room temperature."""

DEFLECTION = {"PA66": 70, "PA46": 190, "POM-C": 104, "POM-H": 115, "PEEK": 156}
"""Heat deflection temperatures at 1.8 MPa (ISO 75, method A) [degC]: of PA66 and POM-C read, others from
memory."""

COLD = {"PA66": 2.93, "PA46": 3.1, "POM-C": 2.6, "POM-H": 3.0, "PEEK": 3.6}
"""Moduli at room temperature of other books [GPa]; of PA46 that of PA66 under the same conditions."""


def _curve(of, name):
    return tuple((t, e * 1e9) for t, e in of[name]["modulus_by_temperature"])


def _all(holds):
    return lambda of: all(holds(of, name) for name in NAMES)


def _soften(of, name):
    """Moduli fall, by at most 7 % for each kelvin."""
    points = _curve(of, name)
    slopes = [log(e1 / e2) / (t2 - t1) for (t1, e1), (t2, e2) in pairwise(points)]
    temperatures = [t for t, _ in points]
    return rises(temperatures) and falls([e for _, e in points]) and max(slopes) < 0.07


def _glass(of, name):
    """They fall fastest within 40 K above the glass transition."""
    if name not in GLASS:
        return True
    pairs = list(pairwise(_curve(of, name)))
    (t1, _), (t2, _) = max(pairs, key=lambda p: log(p[0][1] / p[1][1]) / (p[1][0] - p[0][0]))
    return t1 < GLASS[name] + 40 and t2 > GLASS[name]


def _deflects(of, name):
    """A bar under 1.8 MPa has bent by another 0.2 %; it creeps as it is heated."""
    points = _curve(of, name)
    bent = 1.8e6 / (0.002 + 1.8e6 / points[0][1])
    found = modulus_at(points, DEFLECTION[name])
    return 0.85 < found / bent < 2.5


def _last(of, name):
    return 0.2e9 <= _curve(of, name)[-1][1] <= 0.8e9


def _solid(of, name):
    return _curve(of, name)[-1][0] < MELTING[name]


def _cold(of, name):
    (temperature, modulus), *_ = _curve(of, name)
    return 20 <= temperature <= 25 and within_factor(modulus, COLD[name] * 1e9, 1.15)


def _diffuses(of, name):
    m = of[name]
    return 0.11e-6 < m["conductivity"] / m["density"] / m["specific_heat"] < 0.16e-6


def _stores(of, name):
    return 1.8e6 < of[name]["density"] * of[name]["specific_heat"] < 2.6e6


def _densities(of):
    order = [of[name]["density"] for name in ("PA66", "PA46", "PEEK", "POM-C", "POM-H")]
    return rises(order) and all(1100 < density < 1450 for density in order)


def _hard(of, name):
    return 0.042 < of[name]["hardness"] * 1e9 / _curve(of, name)[0][1] < 0.063


def _bulk(of, name):
    return 3e9 < _curve(of, name)[0][1] / 3 / (1 - 2 * of[name]["poisson_ratio"]) < 6e9


def _limit(of, name):
    """Below melting, in kelvin, and where the modulus is 5 to 40 % of the cold one."""
    limit, points = of[name]["temperature_limit"], _curve(of, name)
    share = (limit + ZERO_CELSIUS) / (MELTING[name] + ZERO_CELSIUS)
    return 0.65 < share < 0.87 and 0.05 < modulus_at(points, limit) / points[0][1] < 0.4


def _results(of):
    """Moduli of a cold and a hot wheel, and what heat and asperities meet."""
    return [
        value
        for name in NAMES
        for value in (
            *(modulus_at(_curve(of, name), t) for t in (23, 60, 80, 100, 120)),
            of[name]["density"] * of[name]["specific_heat"] * of[name]["conductivity"],
            of[name]["temperature_limit"] + ZERO_CELSIUS,
            1 - of[name]["poisson_ratio"] ** 2,
        )
    ]


_READ_COLD = "modulus at 23 degC, density, heat read (the table's `source`); moduli above"

PLASTICS = Chapter(
    "Plastics of wheels",
    TableNumbers(SOLIDS_TABLE, only=NAMES),
    "Makers' data sheets, [GEARpie](bibliography.md#gearpie), Netzsch; each source stands in "
    "`pyworm/materials/solids.toml`",
    {
        "PA66": Clause(f"{_READ_COLD}, Poisson's ratio from memory; limit read", MEMORY),
        "PA46": Clause(f"{_READ_COLD}, Poisson's ratio, hardness, limit from memory", MEMORY),
        "POM-C": Clause(f"{_READ_COLD} from memory; limit read", MEMORY),
        "POM-H": Clause(
            f"{_READ_COLD} from memory, those from 100 degC on read; limit from memory", MEMORY
        ),
        "PEEK": Clause(f"{_READ_COLD} from memory, that at 100 degC read; limit read", MEMORY),
    },
    (
        Check("moduli fall with temperature, by at most 7 % for each kelvin", _all(_soften)),
        Check("fastest within 40 K above the glass transition", _all(_glass)),
        Check(
            "0.85 to 2.5 times that of a bar at its heat deflection temperature", _all(_deflects)
        ),
        Check("0.2 to 0.8 GPa where the table ends", _all(_last)),
        Check("the table ends below melting", _all(_solid)),
        Check("cold within 15 % of other books", _all(_cold)),
        Check("diffusivity 0.11 to 0.16 mm2/s, as of PEEK 0.12 to 0.14", _all(_diffuses)),
        Check("heat capacity of a volume 1.8 to 2.6 MJ/(m3 K)", _all(_stores)),
        Check("densities in order", _densities),
        Check("hardness 4.2 to 6.3 % of the cold modulus", _all(_hard)),
        Check("bulk modulus 3 to 6 GPa", _all(_bulk)),
        Check(
            "limit at 65 to 87 % of the melting temperature in kelvin, with 5 to 40 % of the cold modulus",
            _all(_limit),
        ),
    ),
    _results,
)

CHAPTERS = (PLASTICS,)
