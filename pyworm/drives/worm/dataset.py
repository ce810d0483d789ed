"""Datasets of a worm drive for pictures: its mesh cycle, and the tooth of a contact."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from pyworm.drives.worm.loads.load_sharing import SharedLoad
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.patterns.contact_pattern import THICKNESS, ContactPattern
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset, described
from pyworm.io.quantities import describe
from pyworm.scene.point import Gap

KIND = "worm"

FLANKS = "driving", "other"
"""The flank that the worm drives, and the other one, which drives when it turns the other way."""

TOOTH_SAMPLES = 129
"""Number of points along each direction at which the gap is sampled over the whole tooth."""


def mesh_cycle_data(contacts: Iterable[Any]) -> "xr.Dataset":
    """The contacts of a mesh cycle as one dataset over phase, vectors in the axes of the drive."""
    contacts = tuple(contacts)

    def column(name: str) -> np.ndarray:
        return np.array([getattr(contact, name) for contact in contacts], dtype=float)

    radii = column("radii")
    return describe(
        xr.Dataset(
            {
                "worm_angle": ("phase", column("worm_angle")),
                "wheel_angle": ("phase", column("wheel_angle")),
                "transmission_error": ("phase", column("transmission_error")),
                "point": (("phase", "axis"), column("point")),
                "normal": (("phase", "axis"), column("normal")),
                "radius_x": ("phase", radii[:, 0]),
                "radius_y": ("phase", radii[:, 1]),
            },
            coords={"phase": column("phase"), "axis": ["x", "y", "z"]},
            attrs={"drive": KIND},
        )
    )


def pattern_data(
    patterns: Sequence[ContactPattern], loaded: Sequence[ContactPattern]
) -> "xr.Dataset":
    """The contact patterns of both `FLANKS`, without load and under it."""
    dims = "marked_flank", "marking_height", "marking_face"
    columns = {
        "marking_place": np.stack([pattern.face for pattern in patterns]),
        "marking_radius": np.stack([pattern.radius for pattern in patterns]),
        "marking_separation": np.stack([pattern.separation for pattern in patterns]),
        "loaded_separation": np.stack([pattern.separation for pattern in loaded]),
    }
    parts = {
        "marking_fraction": np.array([pattern.fraction() for pattern in patterns]),
        "loaded_marking_fraction": np.array([pattern.fraction() for pattern in loaded]),
    }
    return describe(
        xr.Dataset(
            {name: (dims, values) for name, values in columns.items()}
            | {name: ("marked_flank", values) for name, values in parts.items()},
            coords={"marked_flank": list(FLANKS)},
            attrs={"marking_thickness": THICKNESS},
        )
    )


LOADED_PHASES = 101
"""Number of phases of the loads of the tooth pairs, for curves and integrals over the cycle."""


def loaded_cycle_data(mesh: WormMesh, beyond: float) -> "xr.Dataset":
    """Loads, levers and speeds of a tooth pair over its cycle and `beyond` [phases] before and after."""
    phases = np.linspace(-beyond, 1 + beyond, LOADED_PHASES)
    arms = mesh.arms(phases)
    shared = [mesh.shared(float(phase)) for phase in phases]
    dry = {}
    if mesh.without_film_lift is not None:
        without_film_lift = [mesh.without_film_lift.shared(float(phase)) for phase in phases]
        dry = {"dry_tooth_load": ("load_phase", _loads(without_film_lift, phases))}
    rim = mesh.wheel_flank.cut_point(*mesh.rim)
    warm = {}
    if mesh.oil.heat is not None:
        worm, wheel = (body.bulk_temperature for body in mesh.bodies)
        warm = {
            "sump_temperature": mesh.oil.heat.inlet_temperature,
            "worm_temperature": worm,
            "wheel_temperature": wheel,
        }
    given = mesh.transmission
    torque = {} if given is None else {"torque": given.torque, "torque_shaft": given.shaft}
    return describe(
        xr.Dataset(
            {
                "tooth_load": ("load_phase", _loads(shared, phases)),
                **dry,
                "wheel_turn": ("load_phase", np.array([share.turn for share in shared])),
                "sliding_speed": ("load_phase", np.linalg.norm(mesh.sliding(phases), axis=0)),
                "lever": ("load_phase", arms.wheel_normal),
                "sliding_lever": ("load_phase", arms.wheel_sliding),
                "rim_face": ("rim", rim[1]),
                "rim_radius": ("rim", wheel_radius(rim)),
            },
            coords={"load_phase": phases},
            attrs={
                "drive": KIND,
                "pitch": mesh.pitch,
                "worm_speed": mesh.speed,
                "wheel_speed": mesh.speed * mesh.cycle.speed_ratio,
                "driver": mesh.driver,
                "friction_assumed": mesh.friction,
                **torque,
                **warm,
            },
        )
    )


def _loads(shared: Sequence[SharedLoad], phases: np.ndarray) -> np.ndarray:
    """Normal load [N] of the pair at each phase."""
    return np.array(
        [share.force(float(phase)) for share, phase in zip(shared, phases, strict=True)]
    )


FlankPlace = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]
"""(x, y) [m] -> two coordinates [m] on a flank under a tangent plane."""


def tooth_data(outline: Any, gap: Gap, place: FlankPlace, on_thread: FlankPlace) -> PlainDataset:
    """The tooth, its gap and its path of contact over a contact's tangent plane, places on both flanks."""
    x = np.linspace(outline.x.min(), outline.x.max(), TOOTH_SAMPLES)
    y = np.linspace(outline.y.min(), outline.y.max(), TOOTH_SAMPLES)
    opening, covered = gap(*np.meshgrid(x, y))
    face, radius = place(*np.meshgrid(x, y))
    axial, from_axis = on_thread(*np.meshgrid(x, y))
    return described(
        {
            "tooth_gap": (("tooth_y", "tooth_x"), np.where(covered, opening, np.nan)),
            "tooth_face": (("tooth_y", "tooth_x"), face),
            "tooth_radius": (("tooth_y", "tooth_x"), radius),
            "thread_axial": (("tooth_y", "tooth_x"), axial),
            "thread_radius": (("tooth_y", "tooth_x"), from_axis),
            "tooth_outline_x": (("outline",), outline.x),
            "tooth_outline_y": (("outline",), outline.y),
            "contact_path_x": (("path",), outline.path_x),
            "contact_path_y": (("path",), outline.path_y),
        },
        coords={"tooth_x": (("tooth_x",), x), "tooth_y": (("tooth_y",), y)},
    )
