"""Fit of the asperities' friction mu_b to the worm standard's friction, from contacts that were solved.

tests/data/boundary_friction.csv has the contacts (`boundary_friction.py` solves them): friction of each, how
it follows mu_b, and how it would change by other laws of contact. Here they become means over the mesh; mu_b
of each oil and a factor of each wheel material are fitted to these, and each row is predicted by a fit to all
others.
"""

import csv
import tomllib
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from math import hypot
from pathlib import Path

import numpy as np
import scipy

from pyworm.case.case import Case, case_of
from pyworm.case.fitted_friction import FITTED_SPREADS
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.formulas.unit_factors import RPM
from pyworm.formulas.unknown import known
from pyworm.formulas.worm_curves import OilKind
from pyworm.formulas.worm_gear import REFERENCE_FILM, REFERENCE_GEAR
from pyworm.formulas.worm_standard import tooth_friction
from pyworm.formulas.worm_wheel_material import FAMILIES, WHEEL_MATERIALS, Family
from pyworm.materials.roughness_assumptions import REFITTED, SLOPE_POWER
from pyworm.solver.roughness_uncertainty import VARIED_FRACTION, whole_change

TABLE = Path(__file__).parents[2] / "tests/data/boundary_friction.csv"

REFERENCE = """
title = "The worm standard's reference gear"
source = "a = 100 mm, 2/41, m 4 mm, q 9; torque, grade and temperature of the oil are our choice"
accuracy = "10 %"

[drive]
kind = "worm"
profile = "ZI"
centre_distance = "100 mm"
threads = 2
teeth = 41
module = "4 mm"
diameter_factor = 9
face_width = "30 mm"

[operation]
worm_speed = "1500 rpm"
wheel_torque = "300 Nm"
phases = [0.5]

[bodies.worm]
material = "16MnCr5"
roughness_ra = "0.5 um"

[bodies.wheel]
material = "CuSn12Ni2-C-GZ"
finish = "run-in"

[oil]
name = "mineral VG 220"
temperature = "60 degC"
"""

OILS: dict[OilKind, str] = {
    "mineral": "mineral VG 220",
    "PAO": "PAO VG 220",
    "PAG": "PAG VG 220",
}

SPEEDS = (150, 500, 1000, 1500, 3000)
"""Speeds of the worm [r/min]: sliding at 0.29 to 5.8 m/s."""

PHASES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Phases of the mesh cycle for the mesh mean."""

MATERIAL = "CuSn12Ni2-C-GZ"
"""Wheel material of the fit's mu_b; the others have a factor."""

_FEW: tuple[tuple[OilKind, ...], tuple[int, ...]] = ("mineral", "PAG"), (150, 1500)

WHEELS: dict[str, tuple[tuple[OilKind, ...], tuple[int, ...]]] = {
    MATERIAL: (tuple(OILS), SPEEDS),
    "CuSn12-C-GZ": _FEW,
    "CuAl10Fe5Ni5-C-GZ": _FEW,
    "EN-GJS-400-15": _FEW,
    "EN-GJL-250": _FEW,
}
"""Wheel material -> oils and speeds of its rows."""

KEPT = ("phase", "load", "friction", "power", "error")
"""What is kept of a contact's loss."""

LAWS = ("stiffer", "one radius", "elastic")
"""Other laws of contact, each with a column: the relative change of friction by it."""


@dataclass(frozen=True)
class Row:
    """A row of the standard: wheel material, oil, speed of the worm [r/min]."""

    wheel: str
    oil: OilKind
    speed: int

    @property
    def sliding(self) -> float:
        """Sliding speed [m/s]."""
        return REFERENCE_GEAR.sliding_speed(self.speed / RPM)

    def standard(self, lubrication: str = "bath") -> float:
        """Friction of the standard [-]."""
        material = WHEEL_MATERIALS[self.wheel]
        return tooth_friction(
            self.oil,
            self.sliding,
            REFERENCE_GEAR.centre_distance,
            REFERENCE_FILM,
            0.5e-6,
            material.friction_factor,
            lubrication,
            material.family,
        )

    def case(self) -> Case:
        """The reference gear of this row."""
        return _case_of(self)


@cache
def _case_of(row: Row) -> Case:
    data = tomllib.loads(REFERENCE)
    data["bodies"]["wheel"]["material"] = row.wheel
    data["oil"]["name"] = OILS[row.oil]
    data["operation"]["worm_speed"] = f"{row.speed} rpm"
    return case_of(data, "reference_gear", Path())


ROWS = tuple(
    Row(wheel, oil, speed)
    for wheel, (oils, speeds) in WHEELS.items()
    for oil, speed in product(oils, speeds)
)


def contacts() -> list[dict]:
    """Contacts that were solved."""
    if not TABLE.exists():
        return []
    with TABLE.open() as file:
        return [
            {key: value if key in ("wheel", "oil") else float(value) for key, value in one.items()}
            for one in csv.DictReader(file)
        ]


def contacts_of(row: Row, phases: tuple[float, ...]) -> list[dict]:
    """Contacts of a row at phases, in their order; ValueError where one is missing."""
    found = {
        one["phase"]: one
        for one in contacts()
        if (one["wheel"], one["oil"], one["speed"]) == (row.wheel, row.oil, row.speed)
    }
    missing = [phase for phase in phases if phase not in found]
    if missing:
        raise ValueError(f"{row}: phases {missing} are not solved")
    return [found[phase] for phase in phases]


@dataclass(frozen=True)
class OverTheMesh:
    """Friction of a row over the mesh."""

    loss: MeshLoss
    """With the mu_b of the solve."""
    mu_b: float
    """That mu_b [-]."""
    rubbing: float
    """Relative change of friction over that of mu_b [-]."""
    laws: dict[str, float]
    """Other law of contact -> relative change of friction [-]."""

    def friction(self, mu_b: float) -> float:
        """Mean friction with another mu_b [-]."""
        return self.loss.friction * (1 + self.rubbing * (mu_b / self.mu_b - 1))

    def needed(self, friction: float) -> float:
        """The mu_b for a mean friction [-]."""
        return self.mu_b * (1 + (friction / self.loss.friction - 1) / self.rubbing)


@cache
def over_the_mesh(row: Row, phases: tuple[float, ...] = PHASES) -> OverTheMesh:
    """Means of a row over the mesh."""
    solved = contacts_of(row, phases)
    family = known(WHEEL_MATERIALS[row.wheel].family)
    losses = [
        ContactLoss(**{key: one[key] for key in KEPT}, model=contact_model(one, family))
        for one in solved
    ]
    drive = row.case().drive
    whole = drive.mesh_loss(losses)

    def mean(key: str) -> float:
        """Relative change of the mean by those of the contacts."""
        changed = [
            replace(loss, power=loss.power * (1 + one[key]))
            for loss, one in zip(losses, solved, strict=True)
        ]
        return drive.mesh_loss(changed).friction / whole.friction - 1

    laws = {law: mean(law) for law in LAWS}
    return OverTheMesh(whole, solved[0]["mu_b"], mean("rubbing"), laws)


def contact_model(contact: dict, family: Family) -> float:
    """Model uncertainty of a contact: by mu_b, the law of contact that changes it most, and others [-]."""
    rubbing, law = contact["rubbing"], max(LAWS, key=lambda law: abs(contact[law]))
    steeper = (1 + contact["stiffer"]) ** SLOPE_POWER, REFITTED["stiffer"] ** SLOPE_POWER
    tied = [
        whole_change(
            1.0,
            changed**VARIED_FRACTION * (1 + rubbing * (refitted**VARIED_FRACTION - 1)),
            by_factor=True,
        )
        for changed, refitted in ((1 + contact[law], REFITTED[law]), steeper)
    ]
    return hypot(contact["others"], *tied, FITTED_SPREADS[family] * rubbing)


@dataclass(frozen=True)
class Fit:
    """mu_b fitted to all rows, and what follows by leaving each out."""

    mu_b: dict[str, float]
    """Oil -> mu_b with the wheel of `MATERIAL` [-]."""
    factors: dict[str, float]
    """Other wheel material -> factor of mu_b [-]."""
    wanted: np.ndarray
    """Friction by the standard, of each row [-]."""
    predicted: np.ndarray
    """Friction by a fit to all other rows [-]."""
    bars: np.ndarray
    """Relative model uncertainty of that [-]."""
    off: np.ndarray
    """The mu_b that a row needs over that of a fit to all others, less 1 [-]."""

    @property
    def spreads(self) -> dict[Family, float]:
        """Group of wheel materials -> what 19 of 20 of its `off` do not exceed, of either sign [-]."""
        groups = np.array([WHEEL_MATERIALS[row.wheel].family for row in ROWS])
        return {
            family: float(np.quantile(np.abs(self.off[groups == family]), 0.95))
            for family in FAMILIES
        }

    @property
    def held(self) -> np.ndarray:
        """Whether the model uncertainty of a row left out reaches the standard."""
        return np.abs(self.predicted - self.wanted) <= self.bars * self.predicted


def _nearest(design: np.ndarray, needed: np.ndarray) -> np.ndarray:
    """Logarithms by whose sums the needed mu_b, over that of the fit, are off least in their squares."""
    start = np.linalg.lstsq(design, np.log(needed))[0]
    return scipy.optimize.least_squares(lambda of: needed * np.exp(-design @ of) - 1, start).x


def fitted(lubrication: str = "bath") -> Fit:
    """Fit mu_b of each oil and a factor of each wheel material; leave each row out once."""
    means = [over_the_mesh(row) for row in ROWS]
    wanted = np.array([row.standard(lubrication) for row in ROWS])
    needed = np.array([mean.needed(of) for mean, of in zip(means, wanted, strict=True)])
    others = [wheel for wheel in WHEELS if wheel != MATERIAL]
    design = np.array(
        [[row.oil == oil for oil in OILS] + [row.wheel == of for of in others] for row in ROWS],
        dtype=float,
    )
    whole = np.exp(_nearest(design, needed))
    left_out = np.empty(len(ROWS))
    for index, columns in enumerate(design):
        rest = np.arange(len(ROWS)) != index
        left_out[index] = np.exp(columns @ _nearest(design[rest], needed[rest]))
    return Fit(
        mu_b=dict(zip(OILS, whole, strict=False)),
        factors=dict(zip(others, whole[len(OILS) :], strict=True)),
        wanted=wanted,
        predicted=np.array([mean.friction(of) for mean, of in zip(means, left_out, strict=True)]),
        bars=np.array([mean.loss.model for mean in means]),
        off=needed / left_out - 1,
    )


def refitted() -> dict[str, float]:
    """Other law of contact -> factor of mu_b [-] that keeps the rows' friction, their geometric mean."""
    means = [over_the_mesh(row) for row in ROWS]
    return {
        law: float(np.exp(-np.mean([np.log1p(of.laws[law]) / of.rubbing for of in means])))
        for law in LAWS
    }
