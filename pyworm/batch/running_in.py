"""Running-in of a gear unit by a programme, against none: roughness, asperity load, temperatures, wear.

Asperities wear by Archard's law (`pyworm.ratings.duty_damage.tooth_wear`); the mean depth cuts the summits of
each flank's roughness (`truncated_roughness`). Smoother flanks carry less on asperities and rub less, which
the thermal network follows over time. Each stage begins warm from the one before, the first one cold.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from pyworm.batch.duty import LoadState, unit_at_load
from pyworm.batch.in_python import CaseLike, as_case
from pyworm.case.case import Case
from pyworm.case.ratings import RatedCase
from pyworm.drives.duty import GearPairDuty
from pyworm.drives.gear_unit import HOUR, OIL
from pyworm.drives.heat_network import ThermalStep
from pyworm.drives.run_in_programme import RunInStage
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.wear_law import RUN_IN, truncated_roughness
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.duty_damage import tooth_wear
from pyworm.ratings.mesh_estimate import MeshEstimate, MeshFriction

FIRST_STEP, STEP_GROWTH = 60.0, 1.3
"""First step of time [s], and the largest one over the step before."""

MAX_SMOOTHING = 0.03
"""Largest mean depth worn off in a step over the roughness [-]."""

ROUGHNESS_STEPS = 60
"""Values of a roughness, evenly spaced in its logarithm, from as cut to run in."""

SERVICE_STAGE = "own load"
"""Name of the stage at the case's own load."""


@dataclass(frozen=True)
class RunInState:
    """Flanks and temperatures at a time."""

    time: float
    """Time from the start [s]."""
    stage: str
    """Name of the stage."""
    oil: float
    """Temperature of the oil [K]."""
    teeth: float
    """Mean temperature of both gear bodies [K]."""
    contact: float
    """Largest temperature of the contacts' surfaces [K]."""
    asperity_load_fraction: float
    """Asperity load ratio [-]."""
    friction: float
    """Mean coefficient of friction [-]."""
    tooth_loss: float
    """Loss between the teeth [W]."""
    roughness: tuple[float, float]
    """Rq of both flanks [m]."""
    wear: tuple[float, float]
    """Largest depth worn off both flanks [m]."""


@dataclass(frozen=True)
class RunInSequence:
    """The flanks through the stages of a programme, or without one."""

    states: tuple[RunInState, ...]
    """States over time."""
    ended_by: tuple[str, ...]
    """What ended each stage: "duration", "asperity load ratio" or "oil temperature"."""

    def of_stage(self, name: str) -> tuple[RunInState, ...]:
        """States of a stage."""
        return tuple(state for state in self.states if state.stage == name)

    @cached_property
    def stages(self) -> tuple[str, ...]:
        """Names of the stages."""
        return tuple(dict.fromkeys(state.stage for state in self.states))


@dataclass(frozen=True)
class RunningIn:
    """A running-in programme against none."""

    name: str
    """Name of the case."""
    bodies: tuple[str, str]
    """Names of the gear bodies."""
    programme: RunInSequence
    """The programme, then the case's own load."""
    none: RunInSequence
    """The case's own load from the start."""
    scuffing_temperature: float | None = None
    """Scuffing temperature of the oil [K], where the case gives it."""

    def summary(self) -> dict[str, Any]:
        """Both as an object for JSON."""
        return {
            "case": self.name,
            "bodies": list(self.bodies),
            **{
                key: {
                    "ended_by": list(sequence.ended_by),
                    "states": [state_summary(state) for state in sequence.states],
                }
                for key, sequence in (("programme", self.programme), ("none", self.none))
            },
        }


def state_summary(state: RunInState) -> dict[str, Any]:
    """A state as an object for JSON."""
    return {
        "time_h": state.time / HOUR,
        "stage": state.stage,
        "oil_temperature_C": state.oil - ZERO_CELSIUS,
        "teeth_temperature_C": state.teeth - ZERO_CELSIUS,
        "contact_temperature_C": state.contact - ZERO_CELSIUS,
        "asperity_load_fraction": state.asperity_load_fraction,
        "friction": state.friction,
        "tooth_loss_W": state.tooth_loss,
        "roughness_m": list(state.roughness),
        "wear_m": list(state.wear),
    }


def running_in(case: CaseLike) -> RunningIn:
    """The programme of a case's `[running_in]` against none, as `pyworm duty --running-in`.

    CaseError of a case without one, without a roughness of both flanks or sizes of its housing.
    """
    checked_case = as_case(case)
    tables, drive = checked_case.tables, checked_case.drive
    if not isinstance(tables, RatedCase) or tables.running_in is None or drive is None:
        raise CaseError(f"{checked_case.name}: has no [running_in]")
    table, duty = tables.running_in, tables.rated_duty(drive)
    worm_or_pinion, wheel_or_gear = present(drive.rotors, "rotors")
    own_stage = RunInStage(
        torque=wheel_or_gear.torque, speed=worm_or_pinion.speed, duration=table.service
    )
    stages = {f"stage {number}": stage for number, stage in enumerate(table.stages, 1)}
    try:
        programme = _Flanks(checked_case).through({**stages, SERVICE_STAGE: own_stage})
        none = _Flanks(checked_case).through({SERVICE_STAGE: own_stage})
    except ValueError as error:
        raise CaseError(f"{checked_case.name}: {error}") from error
    first, second = drive.body_names
    scuffing = duty.scuffing_temperature if isinstance(duty, GearPairDuty) else None
    return RunningIn(checked_case.name, (first, second), programme, none, scuffing)


class _Flanks:
    """Flanks that are smoothed as they run."""

    def __init__(self, case: Case) -> None:
        drive = present(case.drive, "drive")
        first, second = (body.roughness for body in drive.bodies)
        if first is None or second is None:
            raise ValueError("running in needs a roughness of both bodies")
        self.case, self.cut = case, (first, second)
        self.base = case.tables.unit_of(drive)
        self.base.require_capacity()
        self.removed, self.wear = np.zeros(2), np.zeros(2)
        self.time = 0.0
        start = self.base.cooling.ambient_temperature
        self.warm: Mapping[str, float] = dict.fromkeys(self.base.network().capacities, start)
        self.states: list[RunInState] = []

    @property
    def roughness(self) -> tuple[float, float]:
        """Rq of both flanks now [m]."""
        first, second = (
            truncated_roughness(cut, float(off))
            for cut, off in zip(self.cut, self.removed, strict=True)
        )
        return first, second

    @property
    def _rounded(self) -> tuple[float, float]:
        """The roughnesses on some values, whose curves are found once [m]."""
        first, second = map(_rounded, self.cut, self.roughness)
        return first, second

    def through(self, stages: Mapping[str, RunInStage]) -> RunInSequence:
        """The flanks through stages, each until one of its criteria."""
        ended = tuple(self._run(name, stage) for name, stage in stages.items())
        return RunInSequence(tuple(self.states), ended)

    def _at(self, stage: RunInStage) -> LoadState:
        drive = present(self.case.drive, "drive").at_load(stage.speed, stage.torque)
        unit = unit_at_load(self.case, self.base, drive)
        return LoadState(drive, unit, MeshFriction(drive, self.case.places()))

    def _run(self, name: str, stage: RunInStage) -> str:
        """Run a stage; returns what ended it."""
        state, end, step = self._at(stage), self.time + stage.duration, FIRST_STEP
        before = 0.0
        while True:
            mesh = state.friction.at(self._teeth, self._rounded)
            now = self._recorded(name, mesh)
            share, wanted = now.asperity_load_fraction, stage.asperity_load_ratio
            if wanted is not None and share <= min(wanted, before):
                return QUANTITIES["asperity_load_fraction"].label
            before = share
            if stage.oil_temperature is not None and now.oil >= stage.oil_temperature:
                return "oil temperature"
            left = end - self.time
            if left <= 1e-9 * stage.duration:
                return "duration"
            step = self._advance(state, mesh, min(step, left)) * STEP_GROWTH

    @property
    def _teeth(self) -> float:
        first, second = (self.warm[rotor.name] for rotor in self.base.rotors)
        return (first + second) / 2

    def _advance(self, state: LoadState, mesh: MeshEstimate, step: float) -> float:
        """Wear and warm the flanks over a step, shortened by `MAX_SMOOTHING`; returns the step [s]."""
        worn = list(tooth_wear(state.drive, mesh).values())
        rates = np.array(worn) / HOUR
        fastest = float((rates[:, 1] / np.array(self.roughness)).max())
        if fastest > 0:
            step = min(step, max(MAX_SMOOTHING / fastest, FIRST_STEP))
        loss = mesh.loss.loss
        unit = replace(state.unit, tooth_loss_at=lambda known: loss)
        network = unit.network(fit=self.base.fit)
        after = network.history([ThermalStep(step)], self.warm, points=2).temperatures
        self.warm = {node: float(values[-1]) for node, values in after.items()}
        self.wear += step * rates[:, 0]
        self.removed += step * rates[:, 1]
        self.time += step
        return step

    def _recorded(self, name: str, mesh: MeshEstimate) -> RunInState:
        first, second = self.wear
        found = RunInState(
            time=self.time,
            stage=name,
            oil=self.warm[OIL],
            teeth=self._teeth,
            contact=self._teeth + max(contact.surface_rise for contact in mesh.contacts),
            asperity_load_fraction=mesh.asperity_load_fraction,
            friction=mesh.loss.friction,
            tooth_loss=mesh.loss.loss,
            roughness=self.roughness,
            wear=(float(first), float(second)),
        )
        self.states.append(found)
        return found


def _rounded(cut: float, roughness: float) -> float:
    """A roughness on the nearest of some values from as cut to run in [m]."""
    number = round(np.log(roughness / cut) / np.log(RUN_IN) * ROUGHNESS_STEPS)
    return float(cut * RUN_IN ** (number / ROUGHNESS_STEPS))
