"""How oil comes to the teeth of a drive, and the layer that their contacts are fed with.

A bath leaves a layer on the flanks that dip, which drains until they mesh; jets spread theirs over all flanks
that pass. Rules of practice (R. Errichello, Lubrication of Gears, part 3) judge depth, speed and flow.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi
from typing import Literal

from pyworm.formulas.gear_oil import FLOWS, FOOT_PER_MINUTE, application_method, oil_flow
from pyworm.formulas.oil_layers import GRAVITY, dragged_layer, drained_layer, sprayed_layer
from pyworm.io import units
from pyworm.materials.oil import Oil

Side = Literal["incoming", "outgoing"]

DIPPED_DEPTHS = 2.0
"""Depths of a tooth to which gears should dip (Errichello)."""

SPLASH_SPEED = 3000 * FOOT_PER_MINUTE
"""Velocity above which a plain bath is not enough [m/s] (Errichello)."""

INCOMING_SPEED = 8000 * FOOT_PER_MINUTE
"""Velocity up to which jets belong at the incoming side of the mesh [m/s] (Errichello)."""


@dataclass(frozen=True)
class Bath:
    """An oil bath into which one body dips."""

    body: str
    """Its name."""
    depth: units.Length
    """How deep its tips dip while it runs [m]."""


@dataclass(frozen=True)
class Jets:
    """Jets of oil onto the mesh."""

    flow: units.OilFlow
    """Flow of all jets of the mesh [m3/s]."""
    side: Side = "incoming"
    """Side of the mesh: "incoming", where the teeth meet, or "outgoing", where they part."""


@dataclass(frozen=True)
class LubricatedBody:
    """The teeth of one body as they carry oil."""

    tip_radius: float
    """Radius of its tips [m]."""
    depth: float
    """Depth of its teeth [m]."""
    speed: float
    """Speed of its rotation [rad/s]."""

    @property
    def velocity(self) -> float:
        """Velocity of its tips [m/s]."""
        return self.speed * self.tip_radius

    @property
    def pull(self) -> float:
        """Largest acceleration that drains its flanks, centrifugal and gravity [m/s2]."""
        return self.speed**2 * self.tip_radius + GRAVITY

    def drained(self, layer: float, oil: Oil, turns: float) -> float:
        """What is left at half the depth of its flanks of a layer, some turns later [m]."""
        time = turns * 2 * pi / self.speed
        return drained_layer(layer, oil.eta(0.0), oil.density.rho0, self.pull, self.depth / 2, time)


@dataclass(frozen=True)
class LubricatedTeeth:
    """The teeth of a drive as they carry oil."""

    bodies: dict[str, LubricatedBody]
    """Its bodies by the keys of `[bodies]`."""
    face_width: float
    """Face width of the mesh [m]."""
    rate: float
    """Pairs of teeth that pass the mesh [1/s]."""
    power: float
    """Power that the mesh transmits [W]."""


@dataclass(frozen=True)
class OilSupply:
    """The oil that is brought to the contacts of a drive."""

    layer: float
    """Thickness of the oil on both flanks together, at the mesh [m]."""
    words: str
    """How it follows and what is assumed, in sentences."""
    warnings: tuple[str, ...]
    """Where rules of practice are left, a sentence each that begins with a key of the case."""


def oil_supply(by: Bath | Jets, teeth: LubricatedTeeth, oil: Oil) -> OilSupply:
    """The oil that a bath or jets bring to the mesh; ValueError for a bath too deep."""
    return _by_bath(by, teeth, oil) if isinstance(by, Bath) else _by_jets(by, teeth, oil)


class Lubricated:
    """What meshes in oil, and the oil that its contacts get."""

    oil: Oil
    """The oil."""
    lubrication: Bath | Jets | None = None
    """How oil comes to its teeth; None where that is not known, and there is enough."""

    def lubricated_teeth(self) -> LubricatedTeeth | None:
        """Its teeth as they carry oil; None where that is not known."""
        return None

    @cached_property
    def oil_supply(self) -> OilSupply | None:
        """The oil that its lubrication brings; None where not known, ValueError where impossible."""
        if self.lubrication is None:
            return None
        teeth = self.lubricated_teeth()
        if teeth is None:
            raise ValueError("method: how the teeth of this kind of gears carry oil is not known")
        return oil_supply(self.lubrication, teeth, self.oil)

    @property
    def oil_supplied(self) -> Oil:
        """The oil with the layer that arrives at its contacts, where that is known."""
        if self.oil_supply is None:
            return self.oil
        return replace(self.oil, supply=self.oil_supply.layer)


def _by_bath(bath: Bath, teeth: LubricatedTeeth, oil: Oil) -> OilSupply:
    body = teeth.bodies[bath.body]
    if bath.depth > 2 * body.tip_radius:
        raise ValueError(
            f"depth is {bath.depth * 1e3:.4g} mm, but the {bath.body} is "
            f"{2e3 * body.tip_radius:.4g} mm across"
        )
    dragged = dragged_layer(oil.eta(0.0), oil.density.rho0, body.velocity)
    layer = body.drained(dragged, oil, 0.5)
    depths = bath.depth / body.depth
    words = (
        f"The {bath.body} dips {bath.depth * 1e3:.3g} mm into the bath, {depths:.2g} of its tooth depth, and "
        f"brings {layer * 1e6:.3g} µm of oil to the mesh: what the bath leaves on its flanks (Landau and "
        "Levich, Deryagin), drained by gravity and centrifugal force at half their depth (Jeffreys) over "
        "half a turn. It is assumed that the layer reaches the inlet whole."
    )
    warnings = []
    if depths < DIPPED_DEPTHS:
        warnings.append(
            f"lubrication.depth is {depths:.2g} of the {bath.body}'s tooth depth, {body.depth * 1e3:.3g} mm; "
            f"gears should dip about twice that (Errichello)"
            + (", and flanks below the level stay dry" if depths < 1 else "")
        )
    if body.velocity > SPLASH_SPEED:
        warnings.append(
            f"lubrication.method is bath, and the {bath.body} dips at {body.velocity:.3g} m/s; practice is: "
            f"{application_method(body.velocity)} (Errichello)"
        )
    return OilSupply(layer, words, tuple(warnings))


def _by_jets(jets: Jets, teeth: LubricatedTeeth, oil: Oil) -> OilSupply:
    bodies = teeth.bodies.values()
    depth = sum(body.depth for body in bodies) / len(bodies)
    layer = sprayed_layer(jets.flow, teeth.face_width * depth, teeth.rate)
    late = jets.side == "outgoing"
    brought = sum(body.drained(layer, oil, 1.0) if late else layer for body in bodies)
    flow = 60e3 * jets.flow
    drained = (
        ", drained by gravity and centrifugal force (Jeffreys) over the turn until they mesh again"
        if late
        else ""
    )
    words = (
        f"Jets of {flow:.3g} l/min at the {jets.side} side bring {brought * 1e6:.3g} µm of oil to the mesh: "
        f"their flow spread evenly over all flanks that pass{drained}. It is assumed that no oil misses the "
        "teeth or is thrown off them."
    )
    warnings = [*_flow_warnings(jets.flow, teeth.power), *_side_warnings(jets.side, teeth)]
    return OilSupply(brought, words, tuple(warnings))


def _flow_warnings(flow: float, power: float) -> list[str]:
    least = oil_flow(power, "adequate")
    if flow >= least:
        return []
    word = next((name for name in FLOWS if flow >= oil_flow(power, name)), "less than starved")
    return [
        f"lubrication.flow is {60e3 * flow:.3g} l/min for {power / 1e3:.3g} kW, {word}; adequate are "
        f"{60e3 * least:.3g} l/min (Errichello)"
    ]


def _side_warnings(side: Side, teeth: LubricatedTeeth) -> list[str]:
    velocity = max(body.velocity for body in teeth.bodies.values())
    slow = velocity <= INCOMING_SPEED
    if slow == (side == "incoming"):
        return []
    return [
        f"lubrication.side is {side} at {velocity:.3g} m/s; practice is "
        f"{'the incoming side, where oil is to lubricate' if slow else 'mostly the outgoing side, to cool'} "
        "(Errichello)"
    ]
