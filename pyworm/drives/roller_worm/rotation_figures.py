"""Rotation of the rollers about their axes as figures: entry into both sections, and its loss."""

from collections.abc import Sequence
from math import isnan, pi

from pyworm.drives.answers import FigureRow, FigureTable
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.roller_rotation import RollerRotation
from pyworm.drives.roller_worm.spin_up import SpinUp, energies, spin_up

WORDS = (
    "From the first touch of a part of the contact line until moments balance within 1 % of the difference "
    "of speeds at entry. Closed forms at the inlet temperature: friction that heat lowers takes longer.",
    "Away from the worm the pin's friction alone brakes the roller, not the oil around it.",
)


def rotates_freely(mesh: RollerMesh) -> bool:
    """Whether friction turns the rollers, by a known flow law."""
    return mesh.oil.flow is not None and mesh.rolling in ("free", "dynamic")


def pressed_rotations(mesh: RollerMesh) -> dict[str, RollerRotation]:
    """Section that carries load -> rotation of the rollers that pass it."""
    pressed = (name for name in mesh.sections if mesh.wheel_torque(name) > 0)
    return {name: mesh.rotation(name) for name in pressed}


def rotation_figures(mesh: RollerMesh) -> FigureTable:
    """Entry of a roller into each section that carries load."""
    rotations = pressed_rotations(mesh)
    entries = {name: spin_up(rotation, name) for name, rotation in rotations.items()}
    passing = mesh.rollers.count * mesh.wheel_speed / (2 * pi)
    found = tuple(entries.values())
    pressed = {name: "driving" if name == mesh.driving else "idling" for name in entries}
    body = next(iter(rotations.values())).spun.body
    residual = max(each.energies.residual for each in found)
    return FigureTable(
        key="roller_rotation",
        title="Rotation of the rollers",
        source="equation of motion of a roller, Radau IIA",
        parts=tuple(f"{name} section, {role}" for name, role in pressed.items()),
        rows=(
            *_entry_rows(found),
            *_energy_rows(found),
            FigureRow(
                "spin_up_loss_W",
                "Mean power of it, all rollers",
                tuple(each.energies.sliding * passing for each in found),
                "W",
            ),
            FigureRow(
                "sliding_loss_W",
                "Sliding loss in the section, all rollers",
                tuple(_sliding_loss(each, name) * passing for name, each in rotations.items()),
                "W",
            ),
        ),
        words=(
            f"Moment of inertia {body.inertia * 1e6:.3g} kg mm², friction of the pin "
            f"{body.pin_arm * 1e3:.3g} mm times its load; energies balance within {residual:.1g}.",
            *WORDS,
        ),
    )


def _sliding_loss(rotation: RollerRotation, section: str) -> float:
    """Energy that a roller loses by sliding in a section [J]."""
    return energies(rotation, *rotation.passages(section)).sliding


def _entry_rows(found: Sequence[SpinUp]) -> tuple[FigureRow, ...]:
    def row(key: str, label: str, unit: str, values: Sequence[float]) -> FigureRow:
        return FigureRow(
            key, label, tuple(None if isnan(value) else float(value) for value in values), unit
        )

    return (
        row("entry_speed_rad_s", "Speed at entry", "rpm", [e.entry_speed for e in found]),
        row("rolling_speed_rad_s", "Rolling speed there", "rpm", [e.rolling_speed for e in found]),
        row("spin_up_time_s", "Spin-up time", "ms", [e.seconds for e in found]),
        row(
            "spin_up_angle_deg", "Wheel angle of it", "°", [e.wheel_angle * 180 / pi for e in found]
        ),
        row("sliding_distance_m", "Sliding distance", "mm", [e.sliding_distance for e in found]),
        row(
            "sliding_speed_m_per_s",
            "Largest sliding speed",
            "m/s",
            [e.sliding_speed for e in found],
        ),
        row(
            "entrainment_min_m_per_s",
            "Least entrainment velocity",
            "m/s",
            [e.entrainment_min for e in found],
        ),
    )


def _energy_rows(found: Sequence[SpinUp]) -> tuple[FigureRow, ...]:
    rows = (
        ("worm_work_J", "Work of the worm's surface", "worm"),
        ("kinetic_energy_J", "  to rotation", "kinetic"),
        ("pin_loss_J", "  to the pin", "pin"),
        ("spin_up_loss_J", "  to sliding", "sliding"),
    )
    return tuple(
        FigureRow(key, label, tuple(getattr(each.energies, name) for each in found), "J")
        for key, label, name in rows
    )
