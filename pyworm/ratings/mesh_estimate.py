"""Friction, films and loss of a mesh by closed forms, at any temperature of its teeth.

Each contact that the case lists is predicted (`pyworm.planning.prediction`): its film by the atlas or Moes,
its friction by the flow law of the oil that shear warms. Where both flanks have a roughness, asperities carry
their pressure at the central film over the mean one of the contact, and rub with the boundary friction.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import exp, inf

import numpy as np

from pyworm.drives.drive import Drive
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.formulas.arrays import Array
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene

FEWEST_TEMPERATURES, SPACING = 4, 15.0
"""Least number and largest spacing [K] of the temperatures between which a loss is interpolated."""


@dataclass(frozen=True)
class ContactEstimate:
    """A contact by closed forms."""

    film_min: float
    """Minimum film [m]."""
    specific_film: float
    """Minimum film over the composite roughness [-]; infinite of smooth surfaces."""
    asperity_load_fraction: float
    """Share of the load that asperities carry [-]."""
    friction: float
    """Coefficient of friction [-]."""
    sliding: float
    """Sliding velocity [m/s]."""
    load: float
    """Load [N], of a line contact for each length [N/m]."""
    unit_load: float
    """Load for each length across the entrainment, in the mean [N/m]."""
    velocities: tuple[float, float]
    """Speeds of both surfaces over the contact [m/s]."""
    surface_rise: float
    """Temperature rise of the surfaces by the friction [K]."""


@dataclass(frozen=True)
class MeshEstimate:
    """A mesh by closed forms."""

    loss: MeshLoss
    """Loss between the teeth."""
    contacts: tuple[ContactEstimate, ...]
    """Its contacts, in the order of their places."""
    phases: tuple[float, ...]
    """Phase of each in the mesh cycle [-]."""

    @property
    def film_min(self) -> float:
        """Minimum film of all contacts [m]."""
        return min(contact.film_min for contact in self.contacts)

    @property
    def specific_film(self) -> float:
        """Minimum film over the composite roughness, of all contacts [-]."""
        return min(contact.specific_film for contact in self.contacts)

    @property
    def asperity_load_fraction(self) -> float:
        """Share of the load that asperities carry, weighted with load and sliding [-]."""
        weights = np.array([contact.load * contact.sliding for contact in self.contacts])
        shares = np.array([contact.asperity_load_fraction for contact in self.contacts])
        return float((weights * shares).sum() / max(weights.sum(), 1e-300))


@dataclass(frozen=True)
class MeshFriction:
    """The friction of a drive's mesh by closed forms; ValueError of an oil without a flow law or heat."""

    drive: Drive
    """The drive."""
    places: Sequence[ContactIndex]
    """Its contacts."""

    def __post_init__(self) -> None:
        for name in ("flow", "heat"):
            if getattr(self.drive.oil, name) is None:
                table = {"flow": "shear", "heat": "heat"}[name]
                raise ValueError(f"friction by closed forms needs [oil.{table}]")

    @cached_property
    def scenes(self) -> tuple[AnyContact, ...]:
        """The contacts that carry load."""
        drive = self.drive
        return tuple(
            drive.scene(**place.given)
            for place in self.places
            if place.phase is None or not drive.idle(place.phase)
        )

    def at(self, temperature: float, roughness: tuple[float, float] | None = None) -> MeshEstimate:
        """The mesh with oil and teeth at a temperature [K]; `roughness` replaces Rq of both flanks [m]."""
        scenes = self.warmed(temperature, roughness)
        contacts = tuple(estimated(predicted(scene)) for scene in scenes)
        losses = [
            ContactLoss(
                phase=present(scene.phase, "phase"),
                load=contact.load,
                friction=contact.friction,
                power=contact.friction * contact.load * contact.sliding,
                error=0.0,
                section=scene.section,
                station=scene.station,
            )
            for scene, contact in zip(scenes, contacts, strict=True)
        ]
        loss = self.drive.mesh_loss(losses)
        if loss is None:
            raise ValueError(
                f"operation.phases: the {len(losses)} phases under load are too few for the loss of the mesh"
            )
        return MeshEstimate(loss, contacts, tuple(contact.phase for contact in losses))

    def warmed(
        self, temperature: float, roughness: tuple[float, float] | None = None
    ) -> list[AnyContact]:
        """The contacts with oil and teeth at a temperature [K]."""
        return [_warmed(scene, temperature, roughness) for scene in self.scenes]

    def losses(self, low: float, high: float) -> tuple[Array, Array]:
        """Temperatures between two [K], and the loss between the teeth at each [W]."""
        count = max(FEWEST_TEMPERATURES, int(np.ceil((high - low) / SPACING)) + 1)
        temperatures = np.linspace(low, high, count)
        return temperatures, np.array([self.at(float(each)).loss.loss for each in temperatures])


def estimated(prediction: Prediction) -> ContactEstimate:
    """A contact by its prediction."""
    scene = prediction.scene
    fluid = prediction.own_hot_stress / prediction.pressure_mean
    share, specific = 0.0, inf
    if scene.composite_roughness is not None and not scene.smooth:
        curves = present(scene.rough_pair, "roughness").curves()
        borne = exp(curves.at_thickness(prediction.film_central)[0])
        share = min(borne / prediction.pressure_mean, 1.0)
        specific = prediction.film_min / scene.composite_roughness
    friction = (1 - share) * fluid + share * scene.boundary_friction
    length = 1.0 if isinstance(scene, LineScene) else 2 * prediction.half_length
    return ContactEstimate(
        film_min=prediction.film_min,
        specific_film=specific,
        asperity_load_fraction=share,
        friction=friction,
        sliding=prediction.sliding,
        load=scene.load,
        unit_load=scene.load / length,
        velocities=prediction.velocities,
        surface_rise=prediction.surface_rise(
            friction * prediction.pressure_mean * prediction.sliding
        ),
    )


def _warmed(
    scene: AnyContact, temperature: float, roughness: tuple[float, float] | None
) -> AnyContact:
    """A contact with oil and bodies at a temperature [K], and another roughness [m]."""
    rise = temperature - scene.oil.thermal.inlet_temperature
    first, second = (
        _with(body, temperature, None if roughness is None else roughness[number])
        for number, body in enumerate(scene.bodies)
    )
    return replace(scene, oil=scene.oil.warmed(rise), bodies=(first, second))


def _with(body: Body, temperature: float, roughness: float | None) -> Body:
    warm = replace(body, bulk_temperature=temperature)
    return warm if roughness is None else replace(warm, roughness=roughness)
