"""Bending of threads, teeth and pins at their roots, line by line, against the fatigue limit."""

from collections.abc import Iterator
from typing import Any

from pyworm.drives.drive import Drive
from pyworm.drives.loaded_root import LoadedRoot
from pyworm.ratings.rating import RatedFigure, Rating, Safety

REQUIRED = 1.5
"""Least safety of a root [-]: usual for nominal stresses without notch factors; in no standard read here."""

MIN_SLENDERNESS = 0.5
"""Arm over thickness below which beams and plates are no longer models of a root [-]."""

SOURCE = "beams and plates held at one end (Bernoulli and Euler; Jaramillo 1950)"

HELD_AGAINST = (
    "The fluctuating stress is held against the limit in alternating bending of [bodies.NAME.fatigue], on "
    "the safe side by up to a half; notch, size and finish are not in it."
)


def rate_roots(drive: Drive) -> Rating | None:
    """Roots of a drive; None where no body has fatigue limits, or it has no model of its roots."""
    limited = any(body.fatigue is not None for body in drive.bodies)
    roots = drive.roots() if limited else ()
    if not roots:
        return None
    return Rating(
        key="roots",
        title="Bending of threads, teeth and pins at their roots",
        source=SOURCE,
        columns=("computed",),
        figures=tuple(figure for root in roots for figure in _figures(root)),
        safeties=tuple(_safety(drive, root) for root in roots),
        words=(*(root.words for root in roots), HELD_AGAINST),
        not_rated=tuple(
            f"{safety.symbol}, {safety.label}: {safety.why}"
            for safety in (_safety(drive, root) for root in roots)
            if safety.why
        ),
    )


def _figures(root: LoadedRoot) -> Iterator[RatedFigure]:
    key = root.name.replace(" ", "_")
    label = root.name.capitalize()
    yield RatedFigure(
        f"{key}_thickness_m", f"{label}: thickness of the root", (root.thickness,), "mm"
    )
    for number, (phase, force, stress) in enumerate(
        zip(root.phase, root.force, root.stress, strict=True)
    ):
        yield RatedFigure(
            f"{key}_stress_{number}_Pa",
            f"  at phase {phase:.3g}, {force:.4g} N",
            (float(stress),),
            "MPa",
        )


def _safety(drive: Drive, root: LoadedRoot) -> Safety:
    named: dict[str, Any] = {
        "symbol": f"S_F_{root.name.split()[-1]}",
        "label": f"bending of the {root.name}",
        "minimum": REQUIRED,
        "clause": "nominal stress",
    }
    strength, name = drive.bodies[root.body - 1].fatigue, drive.body_names[root.body - 1]
    if strength is None:
        return Safety(**named, why=f"the {name} has no fatigue limits ([bodies.{name}.fatigue]).")
    worst = int(root.stress.argmax())
    stress = float(root.stress[worst])
    return Safety(
        **named,
        value=strength.bending_limit / stress,
        inputs={
            "bending_limit_MPa": strength.bending_limit * 1e-6,
            "sigma_F_MPa": stress * 1e-6,
            "F_N": float(root.force[worst]),
            "arm_mm": float(root.arm[worst]) * 1e3,
            "thickness_mm": root.thickness * 1e3,
            "phase": float(root.phase[worst]),
        },
        doubts=(_range_words(root, worst),) if _range_words(root, worst) else (),
    )


def _range_words(root: LoadedRoot, worst: int) -> str:
    """That the arm is outside the range of the model, in a sentence; empty inside."""
    slender = float(root.arm[worst]) / root.thickness
    if slender >= MIN_SLENDERNESS:
        return ""
    return (
        f"The arm is {slender:.2g} of the thickness: below {MIN_SLENDERNESS:g} the root is sheared rather "
        "than bent."
    )
