"""Base of all drives: scenes of their contacts, and data for tables, pictures, ratings and reports."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

from pyworm.drives.answers import (
    ElementBearing,
    FigureTable,
    HobSetup,
    Misalignment,
    Shim,
    Space,
)
from pyworm.drives.duty import Duty
from pyworm.drives.forces import MeshForces, Supports
from pyworm.drives.loaded_root import LoadedRoot
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.oil_supply import Lubricated
from pyworm.drives.rotor import Rotor
from pyworm.drives.torque_balance import MeshAtTorque
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.quantities import BODIES
from pyworm.io.shown import Shown
from pyworm.io.solid import Solid
from pyworm.materials.body import Body
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

AllowedErrors = dict[str, dict[str, float | str]]
"""Entry of `[drive.assembly]` -> from where to where, in the unit of the key, and what limits it."""


class Drive(Shown, Lubricated, ABC):
    """A machine with lubricated contacts, which implements `scene` and `cycle_data` and never solves."""

    def __init_subclass__(cls) -> None:
        """Keep dataclasses derived from it, whose parts are many, at one line of their own."""
        super().__init_subclass__()
        cls.__repr__ = Shown.__repr__  # type: ignore[method-assign]  # a dataclass would add its own

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the drive in words: its bodies and its oil."""
        law = self.oil.viscosity
        bodies = zip(self.body_names, self.bodies, strict=True)
        return type(self).__name__, {
            **{
                name.replace("_", " "): f"{body.youngs_modulus / 1e9:.4g} GPa"
                for name, body in bodies
            },
            "oil": f"{law.eta0:.3g} Pa s, alpha {law.alpha * 1e9:.3g} 1/GPa",
            **({"sections": ", ".join(self.sections)} if self.sections else {}),
        }

    body_names: ClassVar[tuple[str, str]] = BODIES
    """Names of body 1 and body 2 of its contacts."""
    rated_as: ClassVar[type[Duty] | None] = None
    """Type of its `duty`, by which standards rate it; None where no standard covers such a drive."""
    cycle_seconds: ClassVar[float] = 0.0
    """Usual processor time of `cycle_data` and its pictures [s], without the evaluation of flanks."""
    cycle_points: ClassVar[float] = 0.0
    """Points of the gap that take as long to evaluate as flanks for these, loads, plans and time grids."""
    sheet: ClassVar[tuple[str, ...]] = ()
    """Keys of its `geometry_table` that are printed, in order; the others are in JSON objects only."""
    possible_drivers: ClassVar[tuple[str, ...]] = ()
    """Shafts that may drive it, for its `mesh_forces`, by the names of their bodies."""
    bodies: tuple[Body, Body]
    """Body 1 and body 2."""

    @property
    def assumptions(self) -> tuple[str, ...]:
        """Assumptions of its loads and its geometry, a sentence each."""
        return ("The load of each contact is that of the gear set.",)

    @property
    def usual_values(self) -> tuple[str, ...]:
        """Dimensions that the input does not give, assumed by common practice."""
        return ()

    @property
    def warnings(self) -> tuple[str, ...]:
        """Unusual properties that change its contacts, a sentence each, beginning with a key of `[drive]`."""
        return ()

    @abstractmethod
    def scene(self, *place: Any, **named: Any) -> Scene | LineScene:
        """The lubricated contact at a phase of the mesh cycle, 0 to 1.

        A drive with several contacts at a phase takes the other names of `ContactIndex` that `[operation]`
        lists (`pyworm.case.case.MESH_PLACES`) too, and names its `sections`.

        ValueError if there is no contact, or none under load.
        """

    @abstractmethod
    def cycle_data(self) -> "xr.Dataset":
        """The unloaded mesh cycle for the result; its attribute `drive` names the kind of drive."""

    def cycle_around_contact(self) -> "xr.Dataset":
        """The part of the cycle's data that the result of a single contact keeps; all of it by default."""
        return self.cycle_data()

    @property
    def phases_per_second(self) -> float | None:
        """Phases of its mesh cycle that pass in a second; None where that is not known."""
        return None

    @property
    def sections(self) -> Mapping[str, Any]:
        """Sections of its worm by name; empty of a worm that is one."""
        return {}

    @property
    def all_assumptions(self) -> tuple[str, ...]:
        """Its assumptions, those of softening bodies, and that of the oil which its contacts get."""
        return (*self.assumptions, *self._softening_warnings, self._oil_words)

    @property
    def _softening_warnings(self) -> tuple[str, ...]:
        pairs = zip(self.body_names, self.bodies, strict=True)
        return tuple(
            sentence for name, body in pairs if (sentence := _softening_warnings(name, body))
        )

    @property
    def _oil_words(self) -> str:
        if self.oil_supply is not None:
            return self.oil_supply.words
        if self.oil.supply is not None:
            return "The layer of oil before the contacts is given, the same at each."
        return "Fully flooded inlet at each contact: the oil supply to the teeth is not given."

    def loaded_cycle(self) -> "xr.Dataset":
        """The part of the cycle's data from which loss and loads follow; all of it by default."""
        return self.cycle_data()

    def scene_data(self, scene: Scene | LineScene) -> PlainDataset:
        """Data that pictures of one scene show beside the fields of its solution; may be empty."""
        return PlainDataset({}, (), {})

    def in_space(self, places: Sequence[ContactIndex]) -> Space | None:
        """Its surfaces in space with their turns at some places; None where they are not known."""
        return None

    def solids(self) -> dict[str, Solid] | None:
        """Its gears, and the tool of one, as solids by name; None where no solids are made of them.

        ValueError where a tooth has no solid.
        """
        return None

    def normal_load(self, phase: float) -> float:
        """Normal load of the contact at a phase [N], for each length of a line contact [N/m]."""
        return self.scene(phase).load

    def idle(self, phase: float) -> bool:
        """Whether the contact at a phase carries no load, as its neighbours carry all of it."""
        return False

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss between all teeth, from that of some contacts; None where they are not enough."""
        return None

    def roots(self) -> tuple[LoadedRoot, ...]:
        """Roots of its threads, teeth or pins under load; empty where no model of them is known."""
        return ()

    def mesh_at_torque(self) -> MeshAtTorque | None:
        """Loss both ways and yielding of its mesh; None where locking or yielding is not computed.

        ValueError where its contacts share no torque.
        """
        return None

    def misalignment(self, contacts: Sequence[Scene | LineScene]) -> Misalignment:
        """Some of its contacts under errors of mounting, at unchanged load."""
        return Misalignment(
            "How misalignment changes the contacts of this gear set is not known in closed form."
        )

    def hob_setup(self, wanted: dict[str, float]) -> HobSetup | None:
        """The hob's set-up and the one for a wanted contact pattern; None where no hob cuts a wheel.

        Wanted may be `face`, the middle of the marked part [m], and `size`, the part of the flank [-].
        """
        return None

    def wheel_shim(self, wanted: float | None) -> Shim | None:
        """The shift of the wheel for a wanted middle of the mark along the face [m]; None where not known.

        Without one it is that for no errors of assembly.
        """
        return None

    @property
    def pattern_margin(self) -> float | None:
        """Distance of the contact pattern without load from the nearer end of the face [m]; None without."""
        return None

    def allowed_errors(self) -> AllowedErrors:
        """Errors of the assembly that it allows, each alone; empty where they are not known."""
        return {}

    def motion_figures(self) -> FigureTable | None:
        """Motion of parts that no shaft drives, such as rollers on pins; None of a drive without them."""
        return None

    def geometry(self) -> dict[str, float | str]:
        """Computed geometry of its gears, for the page to sign; keys as of `geometry_table`."""
        found = self.geometry_table()
        return {key: found[key] for key in self.sheet if key in found}

    def geometry_table(self) -> dict[str, float | str]:
        """Computed geometry and kinematics, in order; keys end in the SI unit, angles in `_deg`."""
        return {}

    def mesh_forces(
        self, friction: float | None = None, driver: str | None = None
    ) -> MeshForces | None:
        """Mean forces of the mesh on both shafts; None where they are not known.

        With a coefficient of friction, by default that of its balance of torques, and a driving shaft, by
        default its own, which drives on the flanks that are under load.
        """
        return None

    @property
    def supports(self) -> Mapping[str, Supports]:
        """Bearings of its shafts, by the name of the body that a shaft carries, where they are given."""
        return {}

    @property
    def shaft_speeds(self) -> Mapping[str, float]:
        """Speeds of its shafts [rad/s], by the name of the body that a shaft carries."""
        return {}

    def element_bearing(self) -> ElementBearing | None:
        """Bearing of elements that turn on its wheel; None of solid teeth."""
        return None

    @property
    def rotors(self) -> tuple[Rotor, Rotor] | None:
        """Its gear bodies with their shafts, as its thermal network sees them; None where not known."""
        return None

    def at_load(self, speed: float, torque: float) -> "Drive":
        """The drive at another speed of its first shaft [rad/s] and torque of its second [N m].

        ValueError where another load is given than that of a shaft.
        """
        raise ValueError("the load of this gear set is not that of a shaft")

    def duty(self) -> Duty | None:
        """Input of its rating by standards, of the type `rated_as`; None where no standard covers it.

        ValueError if the methods do not apply to it, or data are missing.
        """
        return None


def _softening_warnings(name: str, body: Body) -> str:
    """The modulus of a body that softens, in a sentence; empty of one that does not."""
    if not body.modulus_by_temperature or body.bulk_temperature is None:
        return ""
    temperature, modulus = body.modulus_by_temperature[0]
    return (
        f"The {name.replace('_', ' ')} has a Young's modulus of {body.youngs_modulus * 1e-9:.3g} GPa at its "
        f"bulk temperature of {body.bulk_temperature - ZERO_CELSIUS:.0f} °C ({modulus * 1e-9:.3g} GPa at "
        f"{temperature - ZERO_CELSIUS:.0f} °C)."
    )
