"""Two published contacts beside what pyworm finds at 1 %: Mourier's ball, and the worm of Sharif et al.

The worm contact is solved with the true gap of the teeth, and as a paraboloid of the published radii; its
surfaces are smooth, as published. Run from the repository's root:

    python benchmarks/validation/published_contacts.py
"""

import sys
from math import hypot
from pathlib import Path

import pyworm
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.solver.solution import Estimate, Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ACCURACY = 0.01

NM, UM, MM, MPA = 1e-9, 1e-6, 1e-3, 1e6

MOURIER_SIDE_LOBES = "119 (recomputed elsewhere)"
"""Minimum film thickness of all [nm], which Mourier et al. do not print."""

SHARIF = {
    "radii of relative curvature / m and mm": "3.046 and 95.4",
    "dry contact length / mm": "23.2",
    "dry contact width / mm": "2.4",
    "maximum dry pressure / MPa": "540",
    "p_max / MPa": "",
    "T_max of the worm / degC": "108",
    "T_max of the wheel / degC": "106",
    "T_max of the film / degC": "117",
    "maximum shear rate / 1/s": "order of 1e7",
    "slide-roll ratio": "almost 2",
    "h_c / um": "",
    "h_min / um": "",
    "friction coefficient": "",
    "power loss / W": "",
    "heat balance / %": "",
}
"""Printed by Sharif, Evans, Snidle and Newall (2001); what is empty they do not print as a number."""


def solved(case: str, effects: str | tuple[str, ...], **place: float) -> Solution:
    """A contact of a case at the accuracy."""
    scene = pyworm.load(Path(f"cases/{case}.toml")).scene(**place)
    return pyworm.solve(scene, pyworm.plan(scene, ACCURACY, effects))


def text(found: Estimate, unit: float, digits: int) -> str:
    """A value with its uncertainty, both in a unit."""
    size = abs(found.value - found.datum) * found.error
    return f"{found.value / unit:.{digits}f} ± {size / unit:.{digits}f}"


def temperature(found: Estimate) -> str:
    """A temperature with its uncertainty [degC]."""
    return f"{found.value - ZERO_CELSIUS:.1f} ± {abs(found.value - found.datum) * found.error:.1f}"


def mourier() -> None:
    """The ball on a disc."""
    figures = solved("mourier_2006", "auto").figures
    at = float(figures.film_exit_min_at)
    rows = (
        ("h_c / nm", "209.3 (measured: 206 to 212)", text(figures.film_central, NM, 1)),
        ("h_min on the centre line / nm", "175.3", f"{figures.film_exit_min / NM:.1f}"),
        ("place of it / um", "126", f"{at / UM:.0f}"),
        ("h_min / nm", MOURIER_SIDE_LOBES, text(figures.film_min, NM, 1)),
    )
    record("mourier", ("quantity", "published", "pyworm"), rows)


def sharif() -> None:
    """The worm contact in mid-mesh, as teeth and as a paraboloid."""
    teeth = solved("zi_sharif_2001", ("auto", "-roughness", "-squeeze"), phase=0.5)
    drive = pyworm.load(Path("cases/zi_sharif_2001.toml")).drive
    paraboloid = solved("zi_paraboloid", ("auto", "-roughness", "-squeeze"))
    columns = (
        values(teeth, drive.contact(0.5).radii),
        values(paraboloid, pyworm.load(Path("cases/zi_paraboloid.toml")).scene().radii),
    )
    rows = [(name, printed, *(of[name] for of in columns)) for name, printed in SHARIF.items()]
    record("sharif", ("quantity", "published", "teeth", "paraboloid"), rows)


def slide_roll_ratio(solution: Solution) -> float:
    """Sliding over mean velocity at the contact point."""
    point = solution.fields.interp(x=0.0, y=0.0)
    sliding, mean = (
        hypot(float(point[f"{name}_x"]), float(point[f"{name}_y"]))
        for name in ("sliding", "entrainment")
    )
    return sliding / mean


def values(solution: Solution, radii: tuple[float, float]) -> dict[str, str]:
    """What is compared, by the names of `SHARIF`."""
    figures, summary = solution.figures, solution.summary()
    friction = figures.friction_coefficient
    long, short = sorted(radii, reverse=True)
    found = (
        f"{long:.3f} and {short / MM:.1f}",
        f"{summary['dry_length_m'] / MM:.2f}",
        f"{summary['dry_width_m'] / MM:.2f}",
        f"{summary['dry_pressure_max_Pa'] / MPA:.0f}",
        text(figures.pressure_max, MPA, 1),
        temperature(figures.temperature_max_body_1),
        temperature(figures.temperature_max_body_2),
        temperature(figures.temperature_max_film),
        f"{figures.shear_rate_max.value:.3g}",
        f"{slide_roll_ratio(solution):.2f}",
        text(figures.film_central, UM, 3),
        text(figures.film_min, UM, 3),
        f"{friction.value:.5f} ± {friction.error * 100:.2f} %",
        f"{figures.power_loss.value:.0f}",
        f"{abs(figures.heat_balance) * 100:.2f}",
    )
    return dict(zip(SHARIF, found, strict=True))


def main() -> None:
    mourier()
    sharif()


if __name__ == "__main__":
    main()
