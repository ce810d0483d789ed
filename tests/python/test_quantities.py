"""Every number with a dimension that the public interface takes may be a text with its unit.

The test walks over all fields of public dataclasses and all arguments of public functions and methods. Each
is among those without a dimension, or is given once as a number in SI and once as a text.
"""

import dataclasses
import inspect
import re
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np
import pytest
from attribute_literals import attribute_literals
from contacts import ball, roller
from folders import ROOT
from synthetic_solution import make_solution

import pyworm
from pyworm.batch.transient import _history, _times
from pyworm.drives.answers import HobSetup
from pyworm.solver.solution import StressFigures

MADE = (
    "TransientResult",
    "Case",
    "CaseDuty",
    "CaseRatings",
    "CaseSetup",
    "CaseWear",
    "CheckedCase",
    "Comparison",
    "Estimate",
    "Figures",
    "FormulaComparison",
    "FormulaFilm",
    "FormulaFilms",
    "Plan",
    "PlannedContact",
    "Result",
    "Solution",
    "SweepResult",
)
"""Classes that the program makes: nobody gives their fields."""

OTHERS = ("__version__", "formulas", "plots", "CaseError", "KernelError", "UnusualWarning")


def public_functions(name, owner):
    """Functions, or methods of a class that are its own, by name, without what begins with an underscore."""
    if inspect.isfunction(owner):
        yield name, owner
        return
    for part in dir(owner):
        member = inspect.getattr_static(owner, part)
        function = getattr(member, "__func__", member)
        public = not part.startswith("_") or part == "__call__"
        if public and inspect.isfunction(function) and function.__module__.startswith("pyworm"):
            yield f"{name}.{part}", function


def places():
    """All places of the public interface where a value stands, and the documentation of each."""
    found = {}
    for name in pyworm.__all__:
        if name in OTHERS:
            continue
        owner = getattr(pyworm, name)
        if dataclasses.is_dataclass(owner) and name not in MADE:
            literals = attribute_literals(owner)
            for field in dataclasses.fields(owner):
                found[f"{name}.{field.name}"] = literals.get(field.name, "")
        for called, function in public_functions(name, owner):
            text = inspect.getdoc(function) or ""
            for part in inspect.signature(function).parameters:
                if part not in ("self", "cls"):
                    found[f"{called}({part})"] = documented(text, part)
    return found


def documented(text, name):
    """What a docstring says of a parameter."""
    entry = re.search(
        rf"^    (?:\w+, )*\*?\*?{name}(?:, \w+)*(?: \(.*\))?:(.*(?:\n     .*)*)", text, re.M
    )
    return entry[1] if entry else ""


WORM = pyworm.Case("worm", Path(), SimpleNamespace(hob_life=()))
vars(WORM)["drive"] = SimpleNamespace(
    hob_setup=HobSetup, allowed_errors=dict, wheel_shim=lambda wanted: wanted
)
"""A case whose gears answer with what they are asked for."""


def tolerance_of_wear(tolerance):
    """The tolerance that a time integration of wear gets."""
    integration = {
        "as_case": lambda case: case,
        "require_worm": lambda case, name: None,
        "requested": lambda *request: [],
        "WearRun": lambda case, tasks, plan, *how, **more: plan,
        "worn": lambda plan, *words: plan.tolerance,
    }
    with patch.multiple("pyworm.batch.wear", **integration):
        return pyworm.wear(
            WORM, 1.0, coefficient=1e-16, worm_ratio=0.1, tolerance=tolerance, progress=False
        )


PROFILED = pyworm.FatigueStrength(5e8, 3e8, (0.0, 1e-4), (-4e8, 0.0), (7e9, 5e9))
OIL = pyworm.named_oil("PAO VG 220")
WARM = OIL.oil(333.15)
NAMED = {
    name: (lambda value, name=name: getattr(OIL, name)(value), 333.15, "60 degC")
    for name in (
        "kinematic_viscosity", "density", "viscosity", "alpha", "agma_alpha", "expansivity",
        "viscosity_slope", "conductivity", "flow", "oil",
    )
}  # fmt: skip
BARUS, ROELANDS = pyworm.Barus(0.04, 2e-8), pyworm.Roelands(0.04, 0.6)
DENSITY = pyworm.Density(870.0, 0.6e-9, 1.7e-9)
EYRING = pyworm.FlowLaw("eyring-limited", stress=5e6, limit=1e8)
LAYER = pyworm.OilLayer((-1e-3, 1e-3), (1e-6, 2e-6))
SUPPLIED = dataclasses.replace(WARM, supply=LAYER)
FILMS = ((0.01, 0.02), 50.0, 226e9, (1.0, 0.1), WARM)


def thick(pressure, temperature):
    return 0.04 * np.exp(2e-8 * pressure - 0.03 * (temperature - 333.15))


def dense(pressure, temperature):
    return 870.0 + 1e-7 * pressure - 0.6 * (temperature - 333.15)


TABLE = pyworm.TabulatedViscosity.of(thick, 333.15)
DENSITIES = pyworm.TabulatedDensity.of(dense, 333.15)
GRID = [-1e-3, -0.5e-3, 0.0, 0.5e-3, 1e-3]
HEIGHTS = np.add.outer(np.square(GRID), np.square(GRID)) / 0.02


def texts(values, unit, scale=1.0):
    """Numbers as texts, in rows as they stand."""
    if np.ndim(values):
        return [texts(one, unit, scale) for one in values]
    return f"{float(values) / scale!r} {unit}"


def built(cls, name, **others):
    return lambda value: cls(**{name: value}, **others)


def heat(name):
    constants = {
        "inlet_temperature": 333.15, "viscosity_exponent": 1.1, "conductivity": 0.14, "specific_heat": 2e3,
    }  # fmt: skip
    return lambda value: pyworm.OilHeat(**{**constants, name: value})


def eyring(name):
    constants = {"law": "eyring-limited", "stress": 5e6, "limit": 1e8}
    return lambda value: pyworm.FlowLaw(**{**constants, name: value})


def tabulated(cls, name):
    given = {
        "pressures": [0.0, 1e8, 2e8, 3e8],
        "temperatures": [313.15, 353.15],
        "values": np.full((4, 2), 800.0),
        "reference": 333.15,
    }
    return lambda value: cls(**{**given, name: value})


def sampled(name):
    given = {"x": np.array(GRID), "y": np.array(GRID), "gap": HEIGHTS}
    return lambda value: pyworm.SampledGap(**{**given, name: value})


def film(place, part=None):
    def called(value):
        given = list(FILMS)
        given[place] = (
            value
            if part is None
            else tuple(value if n == part else one for n, one in enumerate(FILMS[place]))
        )
        return pyworm.film(*given).central

    return called


def table_by(cls, function, name):
    return lambda value: cls.of(function, **{"reference": 333.15, name: value})


def stress_depths(depths):
    """Depths of the stress below a solved contact."""
    solution = make_solution(points=(33, 33))
    known = StressFigures(*[pyworm.Estimate(1e8, 0.0)] * 2, 1e-5, 1e-5, (0.3, 0.3), 0.1)
    figures = dataclasses.replace(solution.figures, stress=known)
    return solution.changed(figures=figures).stress(depths=depths).depths.tolist()


LAWS = dict.fromkeys(("load", "speed", "sliding", "separation"))
SHEET = {"nu40": 2.2e-4, "nu100": 2.6e-5, "alpha": 1.5e-8}
KINEMATIC = {"temperatures": (313.15, 373.15), "nu": (2.2e-4, 2.6e-5)}

SCENES = {"Scene": ball, "LineScene": roller}

DIMENSIONED = {
    "Barus.eta0": (built(pyworm.Barus, "eta0", alpha=2e-8), 0.04, "40 mPa s"),
    "Barus.alpha": (built(pyworm.Barus, "alpha", eta0=0.04), 2e-8, "20 1/GPa"),
    "Barus.__call__(pressure)": (BARUS, 5e8, "500 MPa"),
    "Barus.with_eta0(eta0)": (BARUS.with_eta0, 0.05, "50 mPa s"),
    "Roelands.with_eta0(eta0)": (ROELANDS.with_eta0, 0.05, "50 mPa s"),
    "Roelands.eta0": (built(pyworm.Roelands, "eta0", z=0.6), 0.04, "40 mPa s"),
    "Roelands.p0": (built(pyworm.Roelands, "p0", eta0=0.04, z=0.6), 1.96e8, "196 MPa"),
    "Roelands.__call__(pressure)": (ROELANDS, 5e8, "500 MPa"),
    "Roelands.from_alpha(eta0)": (lambda v: pyworm.Roelands.from_alpha(v, 2e-8), 0.04, "40 mPa s"),
    "Roelands.from_alpha(alpha)": (lambda v: pyworm.Roelands.from_alpha(0.04, v), 2e-8, "20 1/GPa"),
    "Roelands.from_alpha(p0)": (
        lambda v: pyworm.Roelands.from_alpha(0.04, 2e-8, v),
        1.96e8,
        "196 MPa",
    ),
    "Roelands.s0(beta)": (lambda v: ROELANDS.s0(v, 333.15), 0.04, "0.04 1/K"),
    "Roelands.s0(temperature)": (lambda v: ROELANDS.s0(0.04, v), 333.15, "60 degC"),
    "Density.rho0": (built(pyworm.Density, "rho0", d1=6e-10, d2=1.7e-9), 870.0, "0.87 g/cm^3"),
    "Density.d1": (built(pyworm.Density, "d1", rho0=870.0, d2=1.7e-9), 6e-10, "0.6 1/GPa"),
    "Density.d2": (built(pyworm.Density, "d2", rho0=870.0, d1=6e-10), 1.7e-9, "1.7 1/GPa"),
    "Density.__call__(pressure)": (DENSITY, 5e8, "500 MPa"),
    **{
        f"Density.{name}(rho0)": (getattr(pyworm.Density, name), 870.0, "870 kg/m^3")
        for name in ("incompressible", "dowson_higginson", "dowson_higginson_pole")
    },
    **{
        f"Body.{name}": (built(pyworm.Body, name, **others), number, text)
        for name, others, number, text in (
            ("youngs_modulus", {"poisson_ratio": 0.3}, 207e9, "207 GPa"),
            *(
                (name, {"youngs_modulus": 2e11, "poisson_ratio": 0.3}, number, text)
                for name, number, text in (
                    ("density", 7850.0, "7.85 g/cm^3"),
                    ("conductivity", 47.0, "47 W/(m K)"),
                    ("specific_heat", 477.0, "477 J/(kg K)"),
                    ("bulk_temperature", 333.15, "60 degC"),
                    ("roughness", 4e-7, "0.4 um"),
                    ("lay", np.pi / 2, "90 deg"),
                    ("hardness", 1.1e9, "1.1 GPa"),
                    ("temperature_limit", 373.15, "100 degC"),
                    ("thermal_expansion", 11.5e-6, "11.5e-6 1/K"),
                    (
                        "modulus_by_temperature",
                        ((293.15, 3e9), (373.15, 1e9)),
                        (("20 degC", "3 GPa"), ("100 degC", "1 GPa")),
                    ),
                )
            ),
        )
    },
    "Coating.thickness": (lambda v: pyworm.Coating(v, 2e11, 0.2).thickness, 3e-6, "3 um"),
    "Coating.youngs_modulus": (
        lambda v: pyworm.Coating(3e-6, v, 0.2).youngs_modulus,
        2e11,
        "200 GPa",
    ),
    "FatigueStrength.bending_limit": (
        lambda v: pyworm.FatigueStrength(v, 3e8).bending_limit,
        5e8,
        "500 MPa",
    ),
    "FatigueStrength.torsion_limit": (
        lambda v: pyworm.FatigueStrength(5e8, v).torsion_limit,
        3e8,
        "300 MPa",
    ),
    **{
        f"FatigueStrength.{name}": (
            lambda v, name=name: getattr(
                pyworm.FatigueStrength(5e8, 3e8, **{"depths": (0.0, 1e-4), name: v}), name
            ),
            numbers,
            texts,
        )
        for name, numbers, texts in (
            ("depths", (0.0, 1e-4), ("0 um", "100 um")),
            ("residual_stresses", (-4e8, 0.0), ("-400 MPa", "0 MPa")),
            ("hardnesses", (7e9, 5e9), ("7 GPa", "5 GPa")),
        )
    },
    **{
        f"FatigueStrength.{name}(depths)": (
            lambda v, name=name: getattr(PROFILED, name)(v).tolist(),
            [0.0, 5e-5],
            ["0 um", "50 um"],
        )
        for name in ("limit", "residual")
    },
    "Body.warm_at(inlet)": (pyworm.Body(2e11, 0.3).warm_at, 333.15, "60 degC"),
    "named_liquid(temperature)": (lambda v: pyworm.named_liquid("squalane", v), 333.15, "60 degC"),
    **{f"NamedOil.{name}(temperature)": case for name, case in NAMED.items()},
    "FlowLaw.stress": (eyring("stress"), 5e6, "5 MPa"),
    "FlowLaw.stress_pressure": (eyring("stress_pressure"), 1e-9, "1 1/GPa"),
    "FlowLaw.stress_temperature": (eyring("stress_temperature"), 0.01, "0.01 1/K"),
    "FlowLaw.limit": (eyring("limit"), 1e8, "100 MPa"),
    "FlowLaw.of(stress)": (
        lambda v: pyworm.FlowLaw.of(lambda y: 5e6 * np.arcsinh(y / 5e6), v),
        5e6,
        "5 MPa",
    ),
    "FlowLaw.of(limit)": (
        lambda v: pyworm.FlowLaw.of(lambda y: 5e6 * np.arcsinh(y / 5e6), 5e6, limit=v),
        1e8,
        "100 MPa",
    ),
    "FlowLaw.limit_at(pressure)": (
        pyworm.FlowLaw("bair-winer", limit_pressure=0.05).limit_at,
        5e8,
        "500 MPa",
    ),
    "FlowLaw.stress_at(newtonian)": (lambda v: EYRING.stress_at(v, 5e8), 2e7, "20 MPa"),
    "FlowLaw.stress_at(pressure)": (
        lambda v: dataclasses.replace(EYRING, stress_pressure=1e-9).stress_at(2e7, v),
        5e8,
        "500 MPa",
    ),
    **{
        f"OilHeat.{name}": (heat(name), number, text)
        for name, number, text in (
            ("inlet_temperature", 333.15, "60 degC"),
            ("viscosity_exponent", 0.04, "0.04 1/K"),
            ("conductivity", 0.14, "140 mW/(m K)"),
            ("specific_heat", 2000.0, "2 kJ/(kg K)"),
            ("expansivity", 7e-4, "7e-4 1/K"),
            ("expansivity_decay", 1e-9, "1 1/GPa"),
            ("conductivity_c1", 1.56e-9, "1.56 1/GPa"),
            ("conductivity_c2", 0.61e-9, "0.61 1/GPa"),
            ("heat_capacity_b0", 3.4e-4, "3.4e-4 1/K"),
            ("heat_capacity_b1", 3.3e-9, "3.3 1/GPa"),
            ("heat_capacity_b2", -2.3e-18, "-2.3 1/GPa^2"),
            ("heat_capacity_k1", 0.5e-9, "0.5 1/GPa"),
            ("heat_capacity_k2", 0.5e-9, "0.5 1/GPa"),
            ("supply_temperature", 313.15, "40 degC"),
        )
    },
    "Oil.supply": (lambda v: dataclasses.replace(WARM, supply=v), 1e-6, "1 um"),
    "Oil.layer_at(across)": (SUPPLIED.layer_at, 5e-4, "0.5 mm"),
    "Oil.eta(pressure)": (lambda v: WARM.eta(v, 10.0), 5e8, "500 MPa"),
    "Oil.eta(rise)": (lambda v: WARM.eta(5e8, v), -10.0, "-10 K"),
    "Oil.warmed(rise)": (WARM.warmed, 10.0, "10 K"),
    "OilLayer.across": (
        built(pyworm.OilLayer, "across", thickness=(1e-6, 2e-6)),
        (-1e-3, 1e-3),
        ("-1 mm", "1 mm"),
    ),
    "OilLayer.thickness": (
        built(pyworm.OilLayer, "thickness", across=(-1e-3, 1e-3)),
        (0.0, 2e-6),
        ("0 um", "2 um"),
    ),
    "OilLayer.at(across)": (LAYER.at, 5e-4, "0.5 mm"),
    "Paraboloid.radius_x": (built(pyworm.Paraboloid, "radius_x", radius_y=0.02), 0.01, "10 mm"),
    "Paraboloid.radius_y": (built(pyworm.Paraboloid, "radius_y", radius_x=0.02), 0.01, "10 mm"),
    "Paraboloid.__call__(x)": (lambda v: pyworm.Paraboloid(0.01, 0.02)(v, 0.0), 1e-4, "0.1 mm"),
    "Paraboloid.__call__(y)": (lambda v: pyworm.Paraboloid(0.01, 0.02)(0.0, v), 1e-4, "0.1 mm"),
    "Parabola.radius": (pyworm.Parabola, 0.01, "10 mm"),
    "Parabola.__call__(x)": (pyworm.Parabola(0.01), 1e-4, "0.1 mm"),
    "RigidMotion.u": (lambda v: pyworm.RigidMotion(v, 0.0), 1.1, "1.1 m/s"),
    "RigidMotion.v": (lambda v: pyworm.RigidMotion(0.0, v), -1.1, "-1.1 m/s"),
    "RigidMotion.spin": (lambda v: pyworm.RigidMotion(1.0, 0.0, v), 10.0, "10 rad/s"),
    "RigidMotion.__call__(x)": (lambda v: pyworm.RigidMotion(1, 0, 9.0)(v, 0.0), 1e-4, "0.1 mm"),
    "RigidMotion.__call__(y)": (lambda v: pyworm.RigidMotion(1, 0, 9.0)(0.0, v), 1e-4, "0.1 mm"),
    "SampledGap.x": (sampled("x"), np.array(GRID), texts(GRID, "mm", 1e-3)),
    "SampledGap.y": (sampled("y"), np.array(GRID), texts(GRID, "mm", 1e-3)),
    "SampledGap.gap": (sampled("gap"), HEIGHTS, texts(HEIGHTS, "um", 1e-6)),
    "SampledGap.__call__(x)": (lambda v: sampled("x")(GRID)(v, 0.0), 1e-4, "0.1 mm"),
    "SampledGap.__call__(y)": (lambda v: sampled("x")(GRID)(0.0, v), 1e-4, "0.1 mm"),
    "Scene.load": (lambda v: ball(load=v), 30.0, "0.03 kN"),
    "LineScene.load": (lambda v: roller(load=v), 1e5, "100 kN/m"),
    **{
        f"{name}.separation": (lambda v, make=make: make(separation=v), 1e-6, "1 um")
        for name, make in SCENES.items()
    },
    "Scene.travelled": (
        lambda v: ball(travelled=v),
        ((1e-4, 0.0), (0.0, 1e-4)),
        (("0.1 mm", 0.0), (0.0, "0.1 mm")),
    ),
    "LineScene.travelled": (
        lambda v: roller(travelled=v),
        ((1e-4,), (2e-4,)),
        (("0.1 mm",), ("0.2 mm",)),
    ),
    "Scene.radii": (
        lambda v: ball(gap=pyworm.Paraboloid(0.01, 0.02), radii=v),
        (0.01, 0.02),
        ("10 mm", "20 mm"),
    ),
    "LineScene.radius": (lambda v: roller(gap=pyworm.Parabola(0.01), radius=v), 0.01, "10 mm"),
    "LineScene.velocities": (lambda v: roller(velocities=v), (1.1, 0.9), ("1.1 m/s", "0.9 m/s")),
    **{
        f"{name}.{method}(places)": (
            lambda v, method=method, make=make, count=count: getattr(make(), method)(*(v,) * count),
            1e-4,
            "0.1 mm",
        )
        for name, make, count in (("Scene", ball, 2), ("LineScene", roller, 1))
        for method in ("velocities_at", "entrainment_at", "sliding_at")
    },
    "Scene.entrainment(places)": (lambda v: ball().entrainment(v, v), 1e-4, "0.1 mm"),
    "Scene.sliding(places)": (lambda v: ball().sliding(v, v), 1e-4, "0.1 mm"),
    **{
        f"{name}.supply_at(places)": (
            lambda v, make=make, count=count: make(oil=SUPPLIED).supply_at(*(v,) * count),
            1e-4,
            "0.1 mm",
        )
        for name, make, count in (("Scene", ball, 2), ("LineScene", roller, 1))
    },
    "FormulaFilms.specific(roughness)": (pyworm.film(*FILMS).specific, 4e-7, "0.4 um"),
    "film(radii)": (film(0, 1), 0.02, "20 mm"),
    "film(load)": (film(1), np.array([50.0, 60.0]), ["50 N", "0.06 kN"]),
    "film(reduced_modulus)": (film(2), 226e9, "226 GPa"),
    "film(velocity)": (film(3, 0), 1.0, "1 m/s"),
    "film(spin)": (lambda v: pyworm.film(*FILMS, spin=v).central, 10.0, "10 rad/s"),
    "setup(place)": (lambda v: pyworm.setup(WORM, place=v).current, 2e-3, "2 mm"),
    "setup(size)": (lambda v: pyworm.setup(WORM, size=v).current, 0.3, "30 %"),
    "shim(place)": (lambda v: pyworm.shim(WORM, v), 2e-3, "2 mm"),
    "wear(tolerance)": (tolerance_of_wear, 0.5e-6, "0.5 um"),
    "plan(accuracy)": (lambda v: pyworm.plan(ball(), v), 0.2, "20 %"),
    "solve(accuracy)": (
        lambda v: pyworm.solve(ball(), accuracy=v, effects="isothermal").accuracy,
        0.5,
        "50 %",
    ),
    "passes(accuracy)": (
        lambda v: next(pyworm.passes(ball(oil=SUPPLIED), 1, v, "isothermal")).accuracy,
        0.3,
        "30 %",
    ),
    "passes(replenished)": (
        lambda v: next(pyworm.passes(ball(oil=SUPPLIED), 1, 0.3, "isothermal", v)).accuracy,
        0.1,
        "10 %",
    ),
    **{
        f"{cls.__name__}.{name}": (tabulated(cls, name), np.array(number), text)
        for cls, unit in ((pyworm.TabulatedViscosity, "Pa s"), (pyworm.TabulatedDensity, "kg/m^3"))
        for name, number, text in (
            ("pressures", [0.0, 1e8, 2e8, 3e8], ["0 MPa", "100 MPa", "200 MPa", "300 MPa"]),
            ("temperatures", [313.15, 353.15], ["40 degC", "80 degC"]),
            ("values", np.full((4, 2), 800.0), texts(np.full((4, 2), 800.0), unit)),
            ("reference", 333.15, "60 degC"),
        )
    },
    **{
        f"{cls.__name__}.{place}": case
        for cls, function, table in (
            (pyworm.TabulatedViscosity, thick, TABLE),
            (pyworm.TabulatedDensity, dense, DENSITIES),
        )
        for place, case in (
            ("of(reference)", (table_by(cls, function, "reference"), 333.15, "60 degC")),
            ("of(largest_pressure)", (table_by(cls, function, "largest_pressure"), 2e9, "2 GPa")),
            (
                "of(temperatures)",
                (
                    table_by(cls, function, "temperatures"),
                    (313.15, 393.15),
                    ("40 degC", "120 degC"),
                ),
            ),
            ("at(temperature)", (table.at, 343.15, "70 degC")),
            ("__call__(pressure)", (table, 5e8, "500 MPa")),
            ("__call__(rise)", (lambda v, table=table: table(5e8, v), 10.0, "10 K")),
        )
    },
    "Density.with_rho0(rho0)": (DENSITY.with_rho0, 880.0, "0.88 g/cm^3"),
    "TabulatedDensity.with_rho0(rho0)": (DENSITIES.with_rho0, 880.0, "0.88 g/cm^3"),
    "TabulatedViscosity.with_eta0(eta0)": (TABLE.with_eta0, 0.05, "50 mPa s"),
    "Roughness.rms": (built(pyworm.Roughness, "rms"), 4e-7, "0.4 um"),
    "Roughness.lay": (built(pyworm.Roughness, "lay", rms=4e-7), np.pi / 2, "90 deg"),
    "Body.from_name(roughness)": (lambda v: pyworm.Body.from_name("16MnCr5", v), 4e-7, "0.4 um"),
    "Body.from_name(bulk_temperature)": (
        lambda v: pyworm.Body.from_name("16MnCr5", None, v),
        333.15,
        "60 degC",
    ),
    **{
        f"Oil.with_({name})": (
            lambda v, name=name: OIL.oil(333.15).with_(**{name: v}),
            number,
            text,
        )
        for name, number, text in (
            ("eta0", 0.1, "100 mPa s"),
            ("alpha", 2e-8, "20 1/GPa"),
            ("beta", 0.05, "0.05 1/K"),
            ("rho0", 880.0, "0.88 g/cm^3"),
        )
    },
    **{
        f"NamedOil.from_datasheet({name})": (
            lambda v, name=name: pyworm.NamedOil.from_datasheet(**SHEET | {name: v}),
            number,
            text,
        )
        for name, number, text in (
            ("nu40", 2.2e-4, "220 mm^2/s"),
            ("nu100", 2.6e-5, "26 mm^2/s"),
            ("density15", 860.0, "0.86 g/cm^3"),
            ("alpha", 2e-8, "20 1/GPa"),
            ("alpha_at", 333.15, "60 degC"),
        )
    },
    **{
        f"NamedOil.from_table({name})": (
            lambda v, name=name, given=given: pyworm.NamedOil.from_table(**given | {name: v}),
            number,
            text,
        )
        for name, given, number, text in (
            ("temperatures", KINEMATIC, [313.15, 373.15], ["40 degC", "100 degC"]),
            ("nu", KINEMATIC, [2.2e-4, 2.6e-5], ["220 mm^2/s", "26 mm^2/s"]),
            ("eta", {"temperatures": (313.15, 373.15)}, [0.19, 0.02], ["190 mPa s", "20 mPa s"]),
            ("density", KINEMATIC, [848.0, 812.0], ["0.848 g/cm^3", "812 kg/m^3"]),
            ("alpha", KINEMATIC, 2e-8, "20 1/GPa"),
            ("alpha_at", KINEMATIC | {"alpha": 2e-8}, 333.15, "60 degC"),
        )
    },
    **{
        f"transient({name})": (
            lambda v, name=name: _history(ball(), (0.0, 1.0), LAWS | {name: v}, None)(0.5),
            number,
            text,
        )
        for name, number, text in (
            ("load", [20.0, 30.0], ["20 N", "30 N"]),
            ("speed", [1.0, 2.0], ["1 m/s", "2000 mm/s"]),
            ("sliding", 0.1, "100 mm/s"),
        )
    },
    "transient(separation)": (
        lambda v: _history(ball(), (0.0, 1.0), LAWS | {"load": 0.0, "separation": v}, None)(0.5),
        1e-5,
        "10 um",
    ),
    "transient(radii)": (
        lambda v: _history(ball(), (0.0, 1.0), LAWS, (v, 0.01))(0.5),
        [0.01, 0.02],
        ["10 mm", "20 mm"],
    ),
    "transient(times)": (_times, (0.0, 1e-3), ("0 s", "1 ms")),
    "Solution.stress(depths)": (stress_depths, [0.0, 2e-5], ["0 um", "0.02 mm"]),
}
"""Place -> what takes the value, the value in SI, and as a text."""

PLAIN = {
    "Body": (
        "poisson_ratio roughness_slope roughness_aspect asperity_sharpness asperity_density "
        "boundary_friction_factor topography long_waves coating fatigue"
    ),
    "Coating": "poisson_ratio",
    "Body.from_name": "material",
    "Roughness": "slope aspect sharpness density",
    "Branch": "fraction ratio exponent yasuda",
    "FlowLaw": "law limit_pressure exponent yasuda branches table",
    "FlowLaw.of": "function",
    "FlowLaw.shape_at": "newtonian",
    "FlowLaw.with_stress_factor": "stress_factor",
    "Oil": "viscosity density flow heat boundary_friction boundary_friction_spread alpha_spread",
    "Barus.with_alpha_times": "factor",
    "Roelands": "z",
    "Roelands.with_alpha_times": "factor",
    "NamedOil": "name stock walther_m walther_n source",
    "NamedOil.from_datasheet": "viscosity_index base name",
    "NamedOil.from_table": "base name",
    "TabulatedViscosity.with_alpha_times": "factor",
    "TransientResult.animate": "path",
    "TransientResult.save": "path",
    "draw": "method count seed logarithmic ranges",
    "transient": "scene accuracy effects quantities progress",
    "Scene": "name gap bodies oil phase slide_roll_ratio section station past rigid smooth motions",
    "LineScene": "name gap bodies oil phase slide_roll_ratio section station past rigid smooth",
    "TabulatedViscosity.of": "function",
    "TabulatedDensity.of": "function",
    "Case.with_found": "found",
    "Case.scene": "phase slide_roll_ratio section station",
    "Case.idle_phases": "phases",
    "Case.places": "wanted",
    "Case.scenes": "wanted",
    "Estimate.agrees_with": "other",
    "Plan.require_of": "scene",
    "Plan.simplified": "scene",
    "Result.save": "path",
    "GearPair": "name keys",
    "RollerWorm": "name keys",
    "WormDrive": "name keys",
    "gear_set": "kind name keys",
    "check": ("case accuracy effects quantities phases sections stations slide_roll_ratios"),
    "run": (
        "case accuracy effects quantities phases sections stations slide_roll_ratios out fields processes "
        "inputs_uncertain scheduler progress"
    ),
    "calibrate": "case measured fit accuracy effects out processes progress",
    "Calibration": (
        "case_name data_name values rows correlation combinations chi_squared degrees numerical"
    ),
    "Calibration.save": "path",
    "design": "path out processes scheduler progress",
    "BestDesign": (
        "name title case_name variables figures violated open front estimates solved method"
    ),
    "BestDesign.save": "path",
    "rate": "case result",
    "setup": "case",
    "shim": "case",
    "wear": (
        "case hours coefficient energy calibrate worm_ratio accuracy phases out processes scheduler progress"
    ),
    "Sensitivity": "value error",
    "Sensitivities": "figures name inputs table adjoint",
    "Sensitivities.of": "figure by",
    "Sensitivities.by_gap": "figure",
    "sensitivities": "scene plan solution accuracy effects inputs",
    "Solution.sensitivities": "inputs",
    "Solution.stress": "body thermal",
    "Solution.fatigue": "body strength thermal",
    "Solution.held": "part",
    "Solution.dataset": "part",
    "Solution.figure_text": "quantity",
    "Solution.changed": "changes",
    "Solution.save": "path",
    "Solution.rise": "temperature",
    "SweepResult.save": "path",
    "SweepResult.save_csv": "path",
    "compare": "first second",
    "compare_formulas": "scene solution",
    "dry_contact": "scene nodes",
    "film": "oil",
    "film_of": "scene reduced",
    "load": "source name",
    "named_liquid": "name",
    "named_oil": "name",
    "open_result": "path",
    "open_solution": "path",
    "open_sweep": "path",
    "passes": "scene count effects",
    "plan": "scene effects quantities",
    "read_gap": "path",
    "read_oil": "path",
    "rough_patch": "scene surfaces nodes stride averaged tolerance progress",
    "solve": "scene plan progress rates effects quantities",
    "sweep": (
        "make out accuracy effects quantities fields processes scheduler progress title largest_grid "
        "together vary"
    ),
    "traction_curve": "scene slide_roll_ratios accuracy effects out processes progress",
    "with_slide_roll_ratio": "scene ratio",
    "duty": "case table solve_loads progress",
    "write_csv": "solution path",
    "write_vtk": "solution path",
}
"""Owner -> names of its values without a dimension; of studies and of runs the accuracy is that of a plan
(`test_studies_take_an_accuracy_in_per_cent`)."""

WITHOUT = {
    f"{owner}.{name}" if owner in dir(pyworm) and dataclasses.is_dataclass(getattr(pyworm, owner))
    else f"{owner}({name})"
    for owner, names in PLAIN.items()
    for name in names.split()
}  # fmt: skip

UNIT = re.compile(r"\[(?!-\])[\w/ ()^-]+\]")
"""A unit in a docstring, which is not that of a plain number."""

ABOUT_OTHERS = {"FlowLaw.of(function)", "TabulatedViscosity.of(function)", "TabulatedDensity.of(function)",
                "FlowLaw.table"}  # fmt: skip
"""Values without a dimension whose documentation names units of something else: of what a function takes."""


def test_every_value_is_known_with_or_without_a_dimension():
    assert not WITHOUT & set(DIMENSIONED)
    assert set(places()) == WITHOUT | set(DIMENSIONED)


def test_what_is_documented_with_a_unit_has_a_dimension():
    wrong = {place for place, text in places().items() if place in WITHOUT and UNIT.search(text)}
    assert wrong - ABOUT_OTHERS == set()


def same(one, other):
    """Whether two results are equal, numbers to rounding."""
    if dataclasses.is_dataclass(one) and not isinstance(one, pyworm.SampledGap):
        names = [field.name for field in dataclasses.fields(one)]
        return type(one) is type(other) and all(
            same(getattr(one, name), getattr(other, name)) for name in names
        )
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, float | np.ndarray):
        return np.allclose(one, other, rtol=1e-12, atol=0)
    return one == other


@pytest.mark.filterwarnings("ignore::pyworm.UnusualWarning")
@pytest.mark.parametrize("place", DIMENSIONED)
def test_a_text_with_its_unit_does_as_well(place):
    take, number, text = DIMENSIONED[place]
    assert same(take(text), take(number))


WRONG = {
    place: (take, text)
    for place, (take, _, text) in DIMENSIONED.items()
    if isinstance(text, str)
}  # fmt: skip


@pytest.mark.filterwarnings("ignore::pyworm.UnusualWarning")
@pytest.mark.parametrize("place", WRONG)
def test_a_text_of_another_dimension_is_refused_in_a_sentence(place):
    take, _ = WRONG[place]
    name = re.split(r"[.(]", place.rstrip(")"))[-1]
    for wrong, sentence in (("3 kg^2", '= "3 kg^2": must be'), (object(), "<object object at")):
        with pytest.raises(ValueError, match=r"^[^\n]*$") as refused:
            take(wrong)
        assert sentence in str(refused.value)
        assert name in str(refused.value) or name in ("places", "velocity", "radii")


def test_studies_take_an_accuracy_in_per_cent():
    with pytest.raises(ValueError, match='accuracy = "3 kg"'):
        pyworm.sweep(ball, load=(20.0, 30.0), accuracy="3 kg")
    with pytest.raises(ValueError, match='accuracy = "3 kg"'):
        pyworm.traction_curve(ball(), (0.1, 0.2), accuracy="3 kg")
    case = pyworm.load(ROOT / "cases/point_m20_l10.toml")
    for command in (pyworm.check, pyworm.run):
        with pytest.raises(ValueError, match='accuracy = "3 kg"'):
            command(case, accuracy="3 kg")
