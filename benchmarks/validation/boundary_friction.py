"""Friction of asperities, mu_b, fitted to the mesh mean of the worm standard's reference gear, leave-one-out.

Run from the repository's root (each contact of teeth takes ten seconds to a minute; they are kept in
results/boundary_friction.csv, and the next run goes on from there):

    python benchmarks/validation/boundary_friction.py [solve] [phases] [fit]

`solve` solves the contacts, `phases` shows how many of them make the mesh mean, `fit` prints the table.
"""

import csv
import sys
import tomllib
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np
from mixed_lubrication import OILS, REFERENCE, SPEEDS

import pyworm
from pyworm.case.case import Case, case_of
from pyworm.drives.mesh_loss import ContactLoss
from pyworm.formulas.unit_factors import RPM
from pyworm.formulas.worm_gear import REFERENCE_FILM, REFERENCE_GEAR
from pyworm.formulas.worm_standard import tooth_friction
from pyworm.formulas.worm_wheel_material import WHEEL_MATERIALS
from pyworm.result.contact_loss import contact_losses

OUT = Path("results/boundary_friction.csv")

ACCURACY = 0.2
"""Numerical accuracy asked for; friction has less than a tenth of it."""

PHASES = (0.1, 0.5, 0.9)
"""Phases of the mesh cycle for the mesh mean."""

KEPT = ("phase", "load", "friction", "power", "error", "model")
"""What is kept of a contact's loss."""

MORE_PHASES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Phases to which the fewer are compared, for one oil and speed."""

WHEELS = {
    "CuSn12Ni2-C-GZ": (OILS, SPEEDS),
    "CuAl10Fe5Ni5-C-GZ": (("mineral", "PAG"), (150, 1500)),
    "EN-GJS-400-15": (("mineral", "PAG"), (150, 1500)),
}
"""Wheel material -> oils and speeds of its rows."""


@dataclass(frozen=True)
class Row:
    """A row of the standard: wheel material, oil, speed of the worm [r/min]."""

    wheel: str
    oil: str
    speed: int

    @property
    def sliding(self) -> float:
        """Sliding speed [m/s]."""
        return REFERENCE_GEAR.sliding_speed(self.speed / RPM)

    def standard(self, lubrication: str = "injection") -> float:
        """Friction of the standard [-]."""
        material = WHEEL_MATERIALS[self.wheel]
        return tooth_friction(
            self.oil,
            self.sliding,
            0.1,
            REFERENCE_FILM,
            0.5e-6,
            material.friction_factor,
            lubrication,
            material.family,
        )

    def case(self) -> Case:
        """The reference gear of this row."""
        data = tomllib.loads(REFERENCE)
        data["bodies"]["wheel"]["material"] = self.wheel
        data["oil"]["name"] = OILS[self.oil]
        data["operation"]["worm_speed"] = f"{self.speed} rpm"
        return case_of(data, "reference_gear", Path())


ROWS = tuple(
    Row(wheel, oil, speed)
    for wheel, (oils, speeds) in WHEELS.items()
    for oil, speed in product(oils, speeds)
)


def saved() -> list[dict]:
    """Contacts of earlier runs."""
    if not OUT.exists():
        return []
    with OUT.open() as file:
        return [
            {key: value if key in ("wheel", "oil") else float(value) for key, value in row.items()}
            for row in csv.DictReader(file)
        ]


def save(rows: list[dict]) -> None:
    """Write what is known so far."""
    OUT.parent.mkdir(parents=True, exist_ok=True)
    with OUT.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def found(row: Row, phase: float, rows: list[dict]) -> dict | None:
    """A contact of earlier runs."""
    return next(
        (
            one
            for one in rows
            if (one["wheel"], one["oil"], one["speed"], one["phase"])
            == (row.wheel, row.oil, row.speed, phase)
        ),
        None,
    )


def solve(row: Row, phase: float) -> dict:
    """A contact, solved once."""
    rows = saved()
    known = found(row, phase, rows)
    if known is not None:
        return known
    scene = row.case().scene(phase=phase)
    solution = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "auto,-squeeze"))
    figures, (contact,) = solution.figures, contact_losses([solution])
    made = {
        "wheel": row.wheel,
        "oil": row.oil,
        "speed": row.speed,
        **{key: getattr(contact, key) for key in KEPT},
        "boundary": figures.friction_boundary.value,
        "share": figures.asperity_load_fraction.value,
        "mu_b": scene.boundary_friction,
        "factor": scene.boundary_friction / scene.oil.boundary_friction,
        "converged": float(solution.converged),
    }
    save([*rows, made])
    print(row, phase, f"{contact.friction:.4f}", flush=True)
    return made


def solve_all() -> None:
    """Solve what is missing."""
    for row in ROWS:
        for phase in PHASES:
            solve(row, phase)
    for phase in MORE_PHASES:
        solve(Row("CuSn12Ni2-C-GZ", "mineral", 1500), phase)


def over_the_mesh(row: Row, phases: tuple[float, ...], rows: list[dict]) -> tuple[float, float]:
    """Mean friction of the mesh [-]: of the oil, and of asperities over mu_b."""
    contacts = [known for phase in phases if (known := found(row, phase, rows)) is not None]
    if len(contacts) < len(phases):
        raise SystemExit(f"{row}: not solved yet")
    drive = row.case().drive
    losses = [ContactLoss(**{key: one[key] for key in KEPT}) for one in contacts]
    rubbed = [
        replace(loss, friction=one["boundary"], power=loss.power * one["boundary"] / loss.friction)
        for loss, one in zip(losses, contacts, strict=True)
    ]
    whole, boundary = (drive.mesh_loss(parts).friction for parts in (losses, rubbed))
    return whole - boundary, boundary / contacts[0]["mu_b"]


def compare_phases() -> None:
    """Mesh mean of one oil and speed by three and by five phases."""
    rows, row = saved(), Row("CuSn12Ni2-C-GZ", "mineral", 1500)
    for phases in (PHASES, MORE_PHASES):
        oil, slope = over_the_mesh(row, phases, rows)
        mu_b = found(row, 0.5, rows)["mu_b"]
        print(f"{len(phases)} phases: {oil + mu_b * slope:.4f}")


def fit(lubrication: str) -> None:
    """Fit mu_b of each oil and a factor of each wheel material to ln mu_b; leave each row out once."""
    rows = saved()
    parts = np.array([over_the_mesh(row, PHASES, rows) for row in ROWS])
    wanted = np.array([row.standard(lubrication) for row in ROWS])
    wheels = list(WHEELS)[1:]
    design = np.array(
        [
            [row.oil == oil for oil in OILS] + [row.wheel == wheel for wheel in wheels]
            for row in ROWS
        ],
        dtype=float,
    )
    needed = np.log((wanted - parts[:, 0]) / parts[:, 1])
    whole = np.exp(np.linalg.lstsq(design, needed)[0])
    print(
        f"\n{lubrication}: "
        + ", ".join(f"{a} {b:.3f}" for a, b in zip((*OILS, *wheels), whole, strict=True))
    )
    print(
        "| wheel | oil | v_g m/s | standard | left out and predicted | off |\n|---|---|---|---|---|---|"
    )
    off = []
    for index, row in enumerate(ROWS):
        rest = np.arange(len(ROWS)) != index
        mu_b = np.exp(design[index] @ np.linalg.lstsq(design[rest], needed[rest])[0])
        predicted = parts[index, 0] + mu_b * parts[index, 1]
        off.append(abs(predicted / wanted[index] - 1))
        print(
            f"| {row.wheel} | {row.oil} | {row.sliding:.2f} | {wanted[index]:.4f} | {predicted:.4f} | "
            f"{predicted / wanted[index] - 1:+.0%} |"
        )
    off.sort()
    print(f"{sum(of < 0.25 for of in off)} of {len(off)} rows within 25 %, largest {off[-1]:.1%}")


def fit_both() -> None:
    """The fit to the standard's curves of either way of lubrication."""
    for lubrication in ("injection", "bath"):
        fit(lubrication)


def main() -> None:
    parts = {"solve": solve_all, "phases": compare_phases, "fit": fit_both}
    for name in sys.argv[1:] or parts:
        parts[name]()


if __name__ == "__main__":
    main()
