"""ZI worm drives that the tests share."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from pyworm.drives.worm import drive
from pyworm.drives.worm.drawing.design import Hob, Wheel, Worm
from pyworm.drives.worm.drive import WormDrive
from pyworm.drives.worm.loads import mesh, tooth_compliance
from pyworm.drives.worm.loads.tooth_compliance import mesh_springs
from pyworm.drives.worm.patterns import contact_pattern
from pyworm.drives.worm.teeth import flank_grid
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands

MM = 1e-3
DEGREE = np.pi / 180

WORM = Worm(3, 48.01 * MM, 29.03 * MM, 26.23 * MM, 28.73 * MM, 86.18 * MM, 27.61 * DEGREE)
WHEEL = Wheel(59, 60.33 * MM, 278.61 * MM, 274.03 * MM)
HOB = Hob(
    tip_radius=51.63 * MM,
    root_radius=31.58 * MM,
    base_radius=26.48 * MM,
    lead=85.97 * MM,
    axial_pitch=28.66 * MM,
    base_lead_angle=27.33 * DEGREE,
    centre_distance=305.62 * MM,
    swivel=0.255 * DEGREE,
    axial_shift=-0.519 * MM,
)


def sharif(**changes) -> WormDrive:
    """The drive of Sharif et al. (2001), Part 1, Tables 1 and 2, with some entries changed."""
    entries = {
        "worm": WORM,
        "wheel": WHEEL,
        "hob": HOB,
        "centre_distance": 304.8 * MM,
        "speed": 1500 * 2 * np.pi / 60,
        "tooth_load": 14e3,
        "bodies": (Body(207e9, 0.3), Body(120e9, 0.35)),
        "oil": Oil(Roelands(0.227, 0.227), Density.dowson_higginson(1025.0)),
    }
    return WormDrive(**(entries | changes))


def conjugate() -> WormDrive:
    """The same worm with a wheel cut by its own likeness: line contact."""
    hob = Hob(
        tip_radius=50.81 * MM,
        root_radius=30.77 * MM,
        base_radius=WORM.base_radius,
        lead=WORM.lead,
        axial_pitch=WORM.axial_pitch,
        base_lead_angle=WORM.base_lead_angle,
        centre_distance=304.8 * MM,
        swivel=0.0,
        axial_shift=0.0,
    )
    return sharif(hob=hob)


def changed(table, **entries):
    """A design table with some entries changed."""
    return replace(table, **entries)


def coarse_patterns(monkeypatch) -> None:
    """Fewer places and phases for contact patterns, in tests of what follows from them."""
    monkeypatch.setattr(flank_grid, "FACE_PLACES", 25)
    monkeypatch.setattr(flank_grid, "HEIGHT_PLACES", 9)
    monkeypatch.setattr(contact_pattern, "PHASES", np.linspace(-0.2, 1.2, 29))


def without_allowed_errors(monkeypatch) -> None:
    """No allowed errors of the assembly, each of which takes tens of dry contacts, in tests of all else."""
    monkeypatch.setattr(drive, "tolerances", lambda drive: ())


def coarse_springs(monkeypatch) -> None:
    """Fewer phases and loads for the compliance of tooth pairs, in tests that do not ask for its accuracy."""
    monkeypatch.setattr(tooth_compliance, "SPRING_PHASES", np.linspace(-0.2, 1.2, 15))
    monkeypatch.setattr(tooth_compliance, "LOAD_SHARES", np.array([0.02, 0.3, 1.0]))


def shared_springs(monkeypatch) -> None:
    """Tooth springs are found once for all tests of a process, those of fewer phases or loads apart."""
    monkeypatch.setattr(
        mesh,
        "mesh_springs",
        lambda *given: _springs(
            tooth_compliance.SPRING_PHASES.tobytes(), tooth_compliance.LOAD_SHARES.tobytes(), *given
        ),
    )


@lru_cache(maxsize=30)
def _springs(phases: bytes, loads: bytes, *given) -> tooth_compliance.ToothSprings:
    """Springs of the phases and loads that are asked for at the time."""
    return mesh_springs.__wrapped__(*given)


def quickly_described(monkeypatch) -> None:
    """Coarse patterns and springs and no allowed errors, in tests of what is said of a drive and how."""
    without_allowed_errors(monkeypatch)
    coarse_patterns(monkeypatch)
    coarse_springs(monkeypatch)
