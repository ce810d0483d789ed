"""Forces of the mesh on both shafts and their bearings, with simulated friction and that of the standard."""

from collections.abc import Iterator
from dataclasses import dataclass

from pyworm.drives.drive import Drive
from pyworm.drives.forces import MeshForces
from pyworm.formulas.unknown import Unknown
from pyworm.ratings.rating import RatedFigure, Rating

RUNNING, STARTING = "running", "starting"

SOURCE = "balance of forces at mid-mesh, on the flanks that carry the load, with rigid shafts"

REVERSED = (
    "Running the other way reverses tangential and axial forces; the shafts are pushed to their other side. "
    "Loads are nominal ones, without shocks."
)

HELD = "Where the torque of the worm is negative the wheel cannot drive it: the worm has to help."


@dataclass(frozen=True)
class Friction:
    """Coefficients of friction for the forces of a mesh, by their origin."""

    running: dict[str, float]
    """Column ("standard", `SIMULATION`, "computed") -> coefficient of the running teeth [-]."""
    starting: float | Unknown
    """Coefficient at rest by the standard [-], in the first column."""

    @property
    def decisive(self) -> tuple[str, float]:
        """Origin and coefficient for bearing loads: simulated where there is one."""
        return list(self.running.items())[-1]


def rate_forces(drive: Drive, friction: Friction) -> Rating | None:
    """Forces on both shafts, either driving, and loads of their bearings; None of drives without."""
    if drive.mesh_forces() is None:
        return None
    words = [REVERSED]
    figures = tuple(_figures(drive, friction))
    if any(_negative(figure) for figure in figures):
        words.append(HELD)
    if isinstance(friction.starting, Unknown) and _rubs(drive):
        words.append(f"Forces at starting: {friction.starting.why}.")
    coefficients = ", ".join(f"{value:.3g} ({name})" for name, value in friction.running.items())
    if _rubs(drive):
        words.append(f"Coefficient of friction {coefficients}.")
    return Rating(
        key="forces",
        title="Forces on shafts and bearings",
        source=SOURCE,
        columns=tuple(friction.running),
        figures=figures,
        words=tuple(words),
    )


def _negative(figure: RatedFigure) -> bool:
    return any(isinstance(value, float) and value < 0 for value in figure.values)


def _rubs(drive: Drive) -> bool:
    """Whether friction changes the forces of a drive."""
    rubbing, smooth = drive.mesh_forces(0.1), drive.mesh_forces(0.0)
    return rubbing is not None and smooth is not None and rubbing.shafts != smooth.shafts


def _figures(drive: Drive, friction: Friction) -> Iterator[RatedFigure]:
    starts = {} if isinstance(friction.starting, Unknown) else {"": friction.starting}
    states = {RUNNING: friction.running}
    if starts and _rubs(drive):
        states[STARTING] = starts
    for driver in drive.possible_drivers:
        for state, coefficients in states.items():
            found = [drive.mesh_forces(value, driver) for value in coefficients.values()]
            plain = drive.mesh_forces(0.0, driver)
            forces = [force for force in (plain, *found) if force is not None]
            yield from _of_driver(driver, state, forces)
    yield from _bearings(drive, friction)


def _of_driver(driver: str, state: str, forces: list[MeshForces]) -> Iterator[RatedFigure]:
    """Rows of one driving shaft: forces without friction, by whose signs others count, and with it."""
    plain, *rubbing = forces
    first, second = plain.shafts
    crossed = abs(first.axial) != abs(second.axial)
    others = (f"axial of {second.shaft}", f"tangential of {second.shaft}") if crossed else ("", "")
    starting = state == STARTING
    heading = f"{driver.capitalize()} drives{f', {state}' if starting else ''}"
    key = f"{driver}_drives_{f'{state}_' if starting else ''}"
    for name, other in zip(("tangential", "axial"), others, strict=True):
        label = f"{name} force of {first.shaft}, {other}" if other else f"{name} force"
        values = tuple(abs(getattr(force.shafts[0], name)) for force in rubbing)
        yield RatedFigure(f"{key}{first.shaft}_{name}_N", f"{heading}: {label}", values, "N")
    radial = tuple(abs(force.shafts[0].radial) for force in rubbing)
    yield RatedFigure(f"{key}radial_N", f"{heading}: radial force", radial, "N")
    sign = -1.0 if first.torque < 0 else 1.0
    torques = tuple(sign * force.shafts[0].torque for force in rubbing)
    label = f"{heading}: torque of {first.shaft}"
    yield RatedFigure(f"{key}{first.shaft}_torque_N_m", label, torques, "N m")


def _bearings(drive: Drive, friction: Friction) -> Iterator[RatedFigure]:
    """Rows of the bearings of both shafts, where their places are given."""
    found = [drive.mesh_forces(value) for value in friction.running.values()]
    for shaft, supports in drive.supports.items():
        loads = [force.on(shaft).bearings(supports) for force in found if force is not None]
        for side in ("thrust", "opposite"):
            yield RatedFigure(
                f"{shaft}_{side}_bearing_radial_N",
                f"{shaft.capitalize()} bearing, {side} side: radial load",
                tuple(load[side].radial for load in loads),
                "N",
            )
        yield RatedFigure(
            f"{shaft}_bearing_thrust_N",
            f"{shaft.capitalize()} bearings: thrust",
            tuple(load["thrust"].thrust for load in loads),
            "N",
        )
