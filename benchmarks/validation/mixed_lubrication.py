"""Mixed lubrication against what others found: a line, the ZI drive.

The line is set beside the formulas of Masjedi and Khonsari (2012) for film and asperities' share; friction
and efficiency of the ZI drive beside the worm standard's (`boundary_friction.py` has its reference gear).
Contacts of teeth that were solved are kept in results/mixed_lubrication.csv, and the next run goes on from
there. Run from the repository's root, both or one (the line takes seconds, each contact of teeth half a
minute to two):

    python benchmarks/validation/mixed_lubrication.py [line] [zi]
"""

import sys
import tomllib
from collections.abc import Callable
from dataclasses import asdict, fields
from math import exp, log, sqrt
from pathlib import Path
from unittest.mock import patch

import numpy as np
from boundary_friction_fit import PHASES
from yielding_summits import DENSITY, SHARPNESS, SUMMITS_ABOVE, YieldingSummits, summits

import pyworm
from pyworm.case.case import Case, case_of
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.formulas.rough_contact import greenwood_tripp, self_affine
from pyworm.formulas.worm_standard import teeth_loss
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.rough_surfaces import rough_pair
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.result.contact_loss import contact_losses
from pyworm.scene.line import LineScene, Parabola
from pyworm.solver.solution import Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record
from kept_rows import keep_rows, kept_rows

OUT = Path("results/mixed_lubrication.csv")

LOAD, SPEED, MATERIAL, HARDNESS = 1e-4, 1e-11, 4500.0, 0.01
"""W = w/(E' R), U = eta0 um/(E' R), G = alpha E', V = hardness/E' of the line contact [-], E' as here."""

HEIGHTS = (5e-6, 2e-5, 5e-5)
"""Composite roughness over the radius of the line contact [-], beside a smooth one."""

YIELDING = "summits that yield"
"""Asperities as Masjedi and Khonsari had them (`yielding_summits`)."""

FINISHES = {
    "slope 0.008": {"roughness_slope": 0.008},
    "slope 0.016": {"roughness_slope": 0.016},
    "sigma/beta 0.01": {"asperity_sharpness": SHARPNESS, "asperity_density": DENSITY},
    YIELDING: {},
}
"""Asperities of each surface: the default slope of run-in ones, twice that, and Greenwood and Tripp's of one
radius, with the numbers that Masjedi and Khonsari had for theirs (from memory)."""

RADIUS, ALPHA, ETA0 = 0.01, 20e-9, 0.04

TEETH_ACCURACY = 0.1
"""Numerical accuracy asked for: friction has less than a tenth of it, far below the bar of the model."""

ZI_CASE = Path("cases/zi_drive.toml")
ZI_HEIGHTS = (0.3, 0.5)
"""Ra of both flanks of the ZI drive [um]; the standard asks for the worm's alone."""


def masjedi_khonsari(height: float, load: float = LOAD) -> tuple[float, float]:
    """Central film over the radius and share of the asperities [-] of the line contact, by their formulas.

    M. Masjedi and M. M. Khonsari, J. Tribol. 134 (2012) 011503; from memory, against values that others read
    from their figure 2.
    """
    smooth = 2.691 * load**-0.135 * SPEED**0.705 * MATERIAL**0.556
    rise = 0.2 * height**1.222 * HARDNESS**0.223 * load**-0.229 * SPEED**-0.748 * MATERIAL**-0.842
    rough = 4470 * height**6.015 * HARDNESS**1.168 * load**0.485 * SPEED**-3.741 * MATERIAL**-2.898
    share = 0.005 * load**-0.408 * SPEED**-0.088 * MATERIAL**0.103 * log(1 + rough)
    return smooth * (1 + rise), share / 100


def rolling_line(height: float, asperities: dict[str, float]) -> LineScene:
    """The line contact, rolling without sliding, of a composite roughness over its radius [-]."""
    modulus = MATERIAL / ALPHA
    finish = {"roughness": height * RADIUS / sqrt(2)} | asperities if height else {}
    poisson = 0.3
    body = Body(modulus * (1 - poisson**2), poisson, hardness=HARDNESS * modulus, **finish)
    speed = SPEED * modulus * RADIUS / ETA0
    return LineScene(
        name=f"{height:g}",
        gap=Parabola(RADIUS),
        radius=RADIUS,
        velocities=(speed, speed),
        load=LOAD * modulus * RADIUS,
        bodies=(body, body),
        oil=Oil(
            Roelands.from_alpha(ETA0, ALPHA),
            Density.dowson_higginson_pole(870.0),
        ),
    )


def yielding_pair(*surfaces) -> YieldingSummits:
    """Surfaces as Masjedi and Khonsari had them; arguments as of `rough_pair`."""
    pair = rough_pair(*surfaces)
    return YieldingSummits(pair.surfaces, pair.modulus)


def mean_planes(scene: LineScene, solution: Solution) -> float:
    """Central gap between mean planes over the radius [-]; the film is the mean thickness of that gap."""
    film = solution.figures.film_central.value
    if scene.bodies[0].roughness is None:
        return film / RADIUS
    curves = scene.rough_pair.curves()
    return float(np.interp(film, curves.thicknesses, curves.gaps)) / RADIUS


LINE_COLUMNS = (
    "asperities",
    "sigma/R",
    "h_c/R by formula",
    "gap of mean planes / R",
    "difference of gap",
    "film / R",
    "difference of film",
    "model uncertainty of film",
    "load ratio by formula",
    "asperity load ratio",
    "model uncertainty",
    "difference / points",
)


def compare_line() -> None:
    """Film and asperity load ratio of the line contact beside the formulas."""
    rows = [line_row(0.0, "none")]
    rows += [line_row(height, finish) for finish in FINISHES for height in HEIGHTS]
    record("mixed_line", LINE_COLUMNS, rows)
    lighter, height = LOAD / 5, HEIGHTS[1]
    ratio = masjedi_khonsari(0.0, lighter)[0] / height
    print(
        f"\nat W = {lighter:g} and {height:g} the formula has {masjedi_khonsari(height, lighter)[1]:.1%}, "
        f"partial films of Patir and Cheng exp(-1.8 lambda^1.2) = {exp(-1.8 * ratio**1.2):.1%}"
    )
    compare_asperities()


def compare_asperities() -> None:
    """Pressure of the elastic asperities of each kind over E*, and of summits on a flat.

    The gap of these is from the mean of the heights, as the formulas have it, or from that of the summits.
    """
    gaps = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 3.0])
    rows = {
        "slope 0.008 of each surface": self_affine(gaps, 0.008 * sqrt(2), 1.0)[0],
        "slope 0.016": self_affine(gaps, 0.016 * sqrt(2), 1.0)[0],
        "Greenwood and Tripp, n beta sigma 0.05, sigma/beta 0.01": greenwood_tripp(
            gaps, DENSITY, SHARPNESS, 1.0
        )[0],
    }
    for origin, above in (("heights", SUMMITS_ABOVE), ("summits", 0.0)):
        for kind, hardness in (("elastic", None), ("yielding", 2 * HARDNESS)):
            rows[f"summits on a flat, {kind}, H from the mean of the {origin}"] = [
                summits(gap - above, 1.0, hardness)[0] for gap in gaps
            ]
    table = [(name, *(f"{of:.1e}" for of in pressures)) for name, pressures in rows.items()]
    record("asperity_pressures", ("asperities", *(f"p_a/E* at H = {gap:g}" for gap in gaps)), table)


def line_row(height: float, finish: str) -> tuple[str, ...]:
    """A row of the line's table, under `LINE_COLUMNS`."""
    pair = yielding_pair if finish == YIELDING else rough_pair
    with patch("pyworm.scene.contact.rough_pair", pair):
        return _line_row(height, finish)


def _line_row(height: float, finish: str) -> tuple[str, ...]:
    film, share = masjedi_khonsari(height)
    scene = rolling_line(height, FINISHES.get(finish, {}))
    effects = ("isothermal", "roughness") if height else "isothermal"
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.02, effects))
    found, borne = solution.figures.film_central, solution.figures.asperity_load_fraction
    gap, thickness = mean_planes(scene, solution), found.value / RADIUS
    row = [finish, f"{height:g}", f"{film * 1e5:.3f}e-5"]
    for of in (gap, thickness):
        row += [f"{of * 1e5:.3f}e-5", f"{(of / film - 1) * 100:+.1f} %"]
    if borne is None:
        return (*row, "", f"{0:.1f} %", "", "", "")
    return (
        *row,
        f"{found.model * 100:.1f} %",
        f"{share * 100:.1f} %",
        f"{borne.value * 100:.1f} %",
        f"{borne.value * borne.model * 100:.1f} %",
        f"{(borne.value - share) * 100:+.1f}",
    )


def zi_drive(height: float) -> Case:
    """The ZI drive with flanks of a mean roughness [um]."""
    data = tomllib.loads(ZI_CASE.read_text())
    for body in data["bodies"].values():
        body["roughness_ra"] = f"{height} um"
    return case_of(data, "zi_drive", ZI_CASE.parent)


def solved(name: str, case: Callable[[], Case], phase: float = 0.5) -> dict:
    """Friction at a phase with its parts and bars, solved once."""
    rows = kept_rows(OUT, {"name"})
    for row in rows:
        if (row["name"], row["phase"]) == (name, phase):
            return row
    scene = case().scene(phase=phase)
    solution = pyworm.solve(scene, pyworm.plan(scene, TEETH_ACCURACY, ("auto", "-squeeze")))
    figures, (contact,) = solution.figures, contact_losses([solution])
    row = {
        "name": name,
        **asdict(contact),
        "numerical": figures.friction_coefficient.error,
        "friction_model": figures.friction_coefficient.model,
        "boundary": figures.friction_boundary.value,
        "share": figures.asperity_load_fraction.value,
        "lambda": solution.summary().get("lambda_central", float("nan")),
        "mu_b": scene.boundary_friction,
        "converged": float(solution.converged),
    }
    keep_rows(OUT, [*rows, row])
    return row


def over_the_mesh(name: str, case: Callable[[], Case]) -> MeshLoss:
    """Loss of all teeth in mesh, from `PHASES`."""
    rows = [solved(name, case, phase) for phase in PHASES]
    names = [field.name for field in fields(ContactLoss)]
    return case().drive.mesh_loss([ContactLoss(**{key: row[key] for key in names}) for row in rows])


ZI_COLUMNS = (
    "Ra / um",
    "friction by the standard",
    "friction",
    "efficiency by the standard",
    "efficiency",
    "friction in mid-mesh",
    "asperity load ratio in mid-mesh",
    "lambda in mid-mesh",
)


def compare_zi() -> None:
    """Friction and efficiency of the ZI drive, over the mesh, beside the standard's."""
    record("mixed_zi", ZI_COLUMNS, [zi_row(height) for height in ZI_HEIGHTS])


def zi_row(height: float) -> tuple[str, ...]:
    """A row of the ZI drive's table, under `ZI_COLUMNS`."""
    name, case = f"ZI {height}", lambda: zi_drive(height)
    duty, found, middle = case().drive.duty(), over_the_mesh(name, case), solved(name, case)
    rated = teeth_loss(duty.gear, "PAG", duty.worm_speed, duty.torque, height * 1e-6)
    return (
        f"{height}",
        f"{rated.friction:.4f}",
        f"{found.friction:.4f} ± {found.friction * found.model:.4f}",
        f"{rated.forward_efficiency:.2%}",
        f"{found.efficiency:.2%} ± {found.model * found.loss / found.power:.2%}",
        f"{middle['friction']:.4f} ± {middle['friction'] * middle['friction_model']:.4f}",
        f"{middle['share']:.1%}",
        f"{middle['lambda']:.2f}",
    )


def main() -> None:
    parts = {"line": compare_line, "zi": compare_zi}
    for name in sys.argv[1:] or parts:
        parts[name]()
        print()


if __name__ == "__main__":
    main()
