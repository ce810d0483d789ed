"""Friction of asperities, mu_b, fitted to the mesh mean of the worm standard's reference gear, leave-one-out.

Run from the repository's root. Each contact of teeth takes ten to twenty seconds; they are kept in
tests/data/boundary_friction.csv, and the next run goes on from there: without that file all are solved anew.

    python benchmarks/validation/boundary_friction.py [solve] [phases] [fit]

`solve` solves the contacts, `phases` shows how many of them make the mesh mean, `fit` prints the tables.
"""

import sys
from functools import partial
from math import hypot, sqrt
from pathlib import Path
from unittest.mock import patch

from boundary_friction_fit import (
    KEPT,
    LAWS,
    PHASES,
    ROWS,
    TABLE,
    Row,
    contacts,
    fitted,
    over_the_mesh,
    refitted,
)

import pyworm
from pyworm.formulas.worm_gear import REFERENCE_GEAR
from pyworm.formulas.worm_standard import forward_efficiency
from pyworm.materials.rough_surfaces import RoughPair
from pyworm.materials.roughness_assumptions import Variation, other_laws, pressed, variations
from pyworm.result.contact_loss import contact_losses
from pyworm.solver.level import Level
from pyworm.solver.roughness_uncertainty import (
    VARIED_FRACTION,
    NeglectedWaves,
    changes_by,
    roughness_uncertainty,
)

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record
from kept_rows import keep_rows

ACCURACY = 0.2
"""Numerical accuracy asked for; friction has less than a tenth of it."""

MORE_PHASES = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
"""Phases to which the fewer are compared."""

COMPARED = Row("CuSn12Ni2-C-GZ", "mineral", 150), Row("CuSn12Ni2-C-GZ", "mineral", 1500)
"""Rows whose number of phases is studied."""


def watched(
    found: dict,
    level: Level,
    pair: RoughPair,
    mu_b: float,
    waves: NeglectedWaves,
    fitted_spread: float,
) -> dict[str, float]:
    """Uncertainty of figures; notes that of the power lost by mu_b, by laws of contact and by all else."""
    curves, thickness = pair.curves(), level.film.thickness()
    laws = other_laws(pair, curves)
    varied = {
        law: Variation(pressed(curves, laws[law], VARIED_FRACTION), mu_b, True) for law in LAWS
    }
    varied["rubbing"] = Variation(curves, mu_b * (1 + VARIED_FRACTION))
    changes = changes_by(level, pair, mu_b, varied)
    found |= {name: change["power_loss"] for name, change in changes.items()}
    uncertainty = roughness_uncertainty(level, pair, mu_b, waves, fitted_spread)
    assumed = dict(variations(pair, mu_b, VARIED_FRACTION, thickness, waves.film, fitted_spread))
    fitted = {name: assumed[name] for name in ("contact", "slope", "boundary friction")}
    parts = [change["power_loss"] for change in changes_by(level, pair, mu_b, fitted).values()]
    found["others"] = sqrt(uncertainty["power_loss"] ** 2 - hypot(*parts) ** 2)
    return uncertainty


def solve(row: Row, phase: float) -> None:
    """Solve a contact, unless it is known."""
    known = contacts()
    if any(
        (one["wheel"], one["oil"], one["speed"], one["phase"])
        == (row.wheel, row.oil, row.speed, phase)
        for one in known
    ):
        return
    scene = row.case().scene(phase=phase)
    changes: dict[str, float] = {}
    with patch("pyworm.solver.contact.roughness_uncertainty", partial(watched, changes)):
        solution = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, ("auto", "-squeeze")))
    (contact,) = contact_losses([solution])
    made = {
        "wheel": row.wheel,
        "oil": row.oil,
        "speed": row.speed,
        **{key: f"{getattr(contact, key):.6g}" for key in KEPT},
        "mu_b": f"{scene.boundary_friction:.6g}",
        "boundary": f"{solution.figures.friction_boundary.value:.6g}",
        **{key: f"{changes[key]:.4g}" for key in ("others", "rubbing", *LAWS)},
    }
    if not solution.converged:
        raise SystemExit(f"{row}, phase {phase}: {solution.stop_reason}")
    keep_rows(TABLE, [*known, made])
    print(row, phase, made["friction"], flush=True)


def solve_all() -> None:
    """Solve what is missing."""
    for row in ROWS:
        for phase in MORE_PHASES if row in COMPARED else PHASES:
            solve(row, phase)


def compare_phases() -> None:
    """Mesh mean by three, five and nine phases."""
    rows = []
    for row in COMPARED:
        means = {
            len(phases): over_the_mesh(row, phases).loss.friction
            for phases in (PHASES[::2], PHASES, MORE_PHASES)
        }
        whole = means[len(MORE_PHASES)]
        rows += [
            (row.oil, row.speed, count, f"{of:.4f}", f"{(of / whole - 1) * 100:+.1f} %")
            for count, of in means.items()
        ]
    columns = "oil", "worm speed / rpm", "phases", "mean friction", "difference from nine"
    record("worm_standard_phases", columns, rows)


FIT_COLUMNS = (
    "wheel",
    "oil",
    "v_g / m/s",
    "friction by the standard",
    "left out and predicted",
    "difference",
    "model uncertainty",
    "holds",
)


def fit() -> None:
    """The fit to the standard's curves of either way of lubrication; the table is of the bath."""
    fits = []
    for lubrication in ("injection", "bath"):
        found = fitted(lubrication)
        off = abs(found.predicted / found.wanted - 1)
        fits.append(
            (
                lubrication,
                len(off),
                int(sum(off < 0.25)),
                f"{max(off) * 100:.1f} %",
                f"{min(found.bars) * 100:.1f} to {max(found.bars) * 100:.1f} %",
                int(sum(found.held)),
                *(f"{of:.4f}" for of in (found.mu_b | found.factors).values()),
                *(f"{spread:.3f}" for spread in found.spreads.values()),
            )
        )
    counts = "rows", "within 25 %", "largest", "model uncertainty", "held by it"
    names = [f"mu_b of {name}" for name in found.mu_b]
    factors = [f"factor of {name}" for name in found.factors]
    spreads = [f"spread of mu_b with {family}" for family in found.spreads]
    record("worm_standard_fits", ("lubrication", *counts, *names, *factors, *spreads), fits)
    rows = []
    for index, row in enumerate(ROWS):
        wanted, predicted = found.wanted[index], found.predicted[index]
        cells = row.wheel, row.oil, f"{row.sliding:.2f}", f"{wanted:.4f}", f"{predicted:.4f}"
        off, bar = f"{(predicted / wanted - 1) * 100:+.0f} %", f"{found.bars[index] * 100:.0f} %"
        rows.append((*cells, off, bar, "yes" if found.held[index] else "no"))
    record("worm_standard_friction", FIT_COLUMNS, rows)


def efficiencies() -> None:
    """Friction and efficiency of the teeth of tin bronze at 1500 r/min beside the standard's."""
    rows = []
    for row in ROWS:
        if (row.wheel, row.speed) != ("CuSn12Ni2-C-GZ", 1500):
            continue
        loss, standard = over_the_mesh(row).loss, row.standard()
        efficiency = forward_efficiency(REFERENCE_GEAR.tan_lead, standard)
        rows.append(
            (
                row.oil,
                f"{standard:.4f}",
                f"{loss.friction:.4f} ± {loss.friction * loss.model:.4f}",
                f"{efficiency * 100:.1f} %",
                f"{loss.efficiency * 100:.1f} ± {(1 - loss.efficiency) * loss.model * 100:.1f} %",
            )
        )
    columns = "friction by the standard", "friction", "efficiency by the standard", "efficiency"
    record("worm_standard_efficiency", ("oil", *columns), rows)


def show_fits() -> None:
    """The fit to the standard's curves of either way of lubrication, and what follows."""
    fit()
    print("\nrefitted:", ", ".join(f"{law} {of:.3f}" for law, of in refitted().items()))
    efficiencies()


def main() -> None:
    parts = {"solve": solve_all, "phases": compare_phases, "fit": show_fits}
    for name in sys.argv[1:] or parts:
        parts[name]()


if __name__ == "__main__":
    main()
