"""Elastohydrodynamic lubrication of worm gears: films between teeth, rollers and balls.

A contact in five statements, numbers in SI:

    import pyworm
    steel = pyworm.named_body("16MnCr5")
    oil = pyworm.named_oil("PAO VG 220").oil(333.15)
    motions = pyworm.RigidMotion(1.1, 0), pyworm.RigidMotion(0.9, 0)
    scene = pyworm.Scene(gap=pyworm.Paraboloid(0.01, 0.01), load=50, motions=motions,
                         bodies=(steel, steel), oil=oil)
    solution = pyworm.solve(scene, accuracy=0.02)

A contact
    Scene           a point contact at one instant
    LineScene       a line contact at one instant
    Paraboloid      gap of a point contact by its radii
    Parabola        gap of a line contact by its radius
    SampledGap      gap by an array of heights
    read_gap        a gap from a file
    RigidMotion     translation and spin of a surface
    with_slide_roll_ratio   a scene at another slide-roll ratio

Solids and oils
    Body            elastic and thermal constants of a solid
    named_body      a solid of the list of materials
    Oil             laws of viscosity, density, flow and heat
    Barus, Roelands     viscosity against pressure
    Density         density against pressure
    FlowLaw         how an oil shears under stress
    OilHeat         how an oil takes heat
    OilLayer        the oil that arrives, over the place across the track
    TabulatedViscosity, TabulatedDensity    a function or measurements over pressure and temperature
    Branch          one branch of a Carreau-Yasuda law
    named_liquid    a liquid of the literature, with its laws over pressure and temperature
    NamedOil        an oil over temperature
    named_oil       an oil of the list of oils
    read_oil        an oil from a file

Solving
    load            a case file, checked
    Case            what `load` gives: it makes scenes
    plan            effects, grids and tolerance for an accuracy
    Plan            what `plan` gives
    solve           the film of a scene, to an accuracy or by its plan
    dry_contact     the pressure of a scene without oil
    passes          one contact after another over one track, by what each leaves
    film            films of many contacts by a formula, without a solve
    film_of         those of a scene
    FormulaFilms    what they give
    traction_curve  friction over the slide-roll ratio
    sweep           many scenes to one table

Results
    Solution        fields, figures, convergence and cost of one solve
    Figures         scalars of a solution
    Estimate        a figure with its error bar, to calculate with
    compare         two solutions side by side
    Comparison      what `compare` gives
    Result          solutions of a case, as files hold them
    open_result     a result from its file
    open_solution   a solution from its file
    SweepResult     the table of a sweep
    open_sweep      a sweep from its file
    write_csv       fields as comma-separated values
    write_vtk       fields for ParaView

What goes wrong
    CaseError       invalid input, one sentence
    KernelError     the kernel gave up
    UnusualWarning  a value that is mostly a slip

Beside
    formulas        closed forms: Hertz, films, regimes, ratings
    plots           pictures of solutions, curves and sweeps
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

# One thread a process unless asked otherwise, since batch work runs a process a core. This stands before
# NumPy and the kernel are loaded, which count their threads then.
os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

if (
    TYPE_CHECKING
):  # what editors and type checkers read; at run time names are loaded with their first use
    from pyworm import formulas as formulas
    from pyworm import plots as plots
    from pyworm.batch.study import sweep as sweep
    from pyworm.batch.study import traction_curve as traction_curve
    from pyworm.case.case import Case as Case
    from pyworm.case.case import load as load
    from pyworm.case.oil import named_liquid as named_liquid
    from pyworm.io.input_error import CaseError as CaseError
    from pyworm.kernel.core import KernelError as KernelError
    from pyworm.materials.body import Body as Body
    from pyworm.materials.body import named_body as named_body
    from pyworm.materials.flow_laws import Branch as Branch
    from pyworm.materials.flow_laws import FlowLaw as FlowLaw
    from pyworm.materials.library import NamedOil as NamedOil
    from pyworm.materials.library import named_oil as named_oil
    from pyworm.materials.oil import Oil as Oil
    from pyworm.materials.oil_file import read_oil as read_oil
    from pyworm.materials.oil_layer import OilLayer as OilLayer
    from pyworm.materials.tabulated import TabulatedDensity as TabulatedDensity
    from pyworm.materials.tabulated import TabulatedViscosity as TabulatedViscosity
    from pyworm.materials.thermal_properties import OilHeat as OilHeat
    from pyworm.materials.viscosity_density import (
        Barus as Barus,
    )
    from pyworm.materials.viscosity_density import (
        Density as Density,
    )
    from pyworm.materials.viscosity_density import (
        Roelands as Roelands,
    )
    from pyworm.planning.plan import Plan as Plan
    from pyworm.planning.plan import plan as plan
    from pyworm.result.compare import Comparison as Comparison
    from pyworm.result.compare import compare as compare
    from pyworm.result.export import write_csv as write_csv
    from pyworm.result.export import write_vtk as write_vtk
    from pyworm.result.result import Result as Result
    from pyworm.result.result import open_result as open_result
    from pyworm.result.result import open_solution as open_solution
    from pyworm.result.sweep_result import SweepResult as SweepResult
    from pyworm.result.sweep_result import open_sweep as open_sweep
    from pyworm.scene.formula_film import FormulaFilms as FormulaFilms
    from pyworm.scene.formula_film import film as film
    from pyworm.scene.formula_film import film_of as film_of
    from pyworm.scene.gap_file import read_gap as read_gap
    from pyworm.scene.line import LineScene as LineScene
    from pyworm.scene.line import Parabola as Parabola
    from pyworm.scene.plausibility import UnusualWarning as UnusualWarning
    from pyworm.scene.point import (
        Paraboloid as Paraboloid,
    )
    from pyworm.scene.point import (
        RigidMotion as RigidMotion,
    )
    from pyworm.scene.point import (
        Scene as Scene,
    )
    from pyworm.scene.sampled_gap import SampledGap as SampledGap
    from pyworm.scene.slide_roll import with_slide_roll_ratio as with_slide_roll_ratio
    from pyworm.solver.estimate import Estimate as Estimate
    from pyworm.solver.passes import passes as passes
    from pyworm.solver.point.dry import dry_contact as dry_contact
    from pyworm.solver.solution import Figures as Figures
    from pyworm.solver.solution import Solution as Solution
    from pyworm.solver.solve import solve as solve

_HOMES = {
    "Barus": "pyworm.materials.viscosity_density",
    "Body": "pyworm.materials.body",
    "Branch": "pyworm.materials.flow_laws",
    "Case": "pyworm.case.case",
    "CaseError": "pyworm.io.input_error",
    "Comparison": "pyworm.result.compare",
    "Density": "pyworm.materials.viscosity_density",
    "Estimate": "pyworm.solver.estimate",
    "Figures": "pyworm.solver.solution",
    "FlowLaw": "pyworm.materials.flow_laws",
    "FormulaFilms": "pyworm.scene.formula_film",
    "KernelError": "pyworm.kernel.core",
    "LineScene": "pyworm.scene.line",
    "NamedOil": "pyworm.materials.library",
    "Oil": "pyworm.materials.oil",
    "OilHeat": "pyworm.materials.thermal_properties",
    "Parabola": "pyworm.scene.line",
    "Paraboloid": "pyworm.scene.point",
    "Plan": "pyworm.planning.plan",
    "Result": "pyworm.result.result",
    "RigidMotion": "pyworm.scene.point",
    "Roelands": "pyworm.materials.viscosity_density",
    "SampledGap": "pyworm.scene.sampled_gap",
    "Scene": "pyworm.scene.point",
    "Solution": "pyworm.solver.solution",
    "SweepResult": "pyworm.result.sweep_result",
    "TabulatedDensity": "pyworm.materials.tabulated",
    "TabulatedViscosity": "pyworm.materials.tabulated",
    "UnusualWarning": "pyworm.scene.plausibility",
    "compare": "pyworm.result.compare",
    "dry_contact": "pyworm.solver.point.dry",
    "film": "pyworm.scene.formula_film",
    "film_of": "pyworm.scene.formula_film",
    "load": "pyworm.case.case",
    "named_body": "pyworm.materials.body",
    "named_liquid": "pyworm.case.oil",
    "named_oil": "pyworm.materials.library",
    "OilLayer": "pyworm.materials.oil_layer",
    "passes": "pyworm.solver.passes",
    "open_result": "pyworm.result.result",
    "open_solution": "pyworm.result.result",
    "open_sweep": "pyworm.result.sweep_result",
    "plan": "pyworm.planning.plan",
    "read_gap": "pyworm.scene.gap_file",
    "read_oil": "pyworm.materials.oil_file",
    "solve": "pyworm.solver.solve",
    "sweep": "pyworm.batch.study",
    "traction_curve": "pyworm.batch.study",
    "with_slide_roll_ratio": "pyworm.scene.slide_roll",
    "write_csv": "pyworm.result.export",
    "write_vtk": "pyworm.result.export",
}
"""Public name -> the module that it comes from."""

_ROOMS = ("formulas", "plots")

__all__ = [
    "__version__",
    *_ROOMS,
    *_HOMES,
]


def __getattr__(name: str) -> Any:
    # Late, so that a look at the version or a check of a case does not wait for, or need, the kernel.
    if name == "__version__":
        from importlib.metadata import version

        return version("pyworm")
    if name in _ROOMS:
        return import_module(f"pyworm.{name}")
    if name not in _HOMES:
        raise AttributeError(f"module 'pyworm' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted(__all__)
