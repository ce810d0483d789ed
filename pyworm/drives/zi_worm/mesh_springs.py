"""Cache of the compliance of a ZI worm drive's tooth pairs over their mesh cycle."""

from functools import lru_cache

from pyworm.drives.zi_worm.flanks import WheelSurface, contact_paths
from pyworm.drives.zi_worm.gap import ToothGap
from pyworm.drives.zi_worm.mesh_cycle import find_mesh_cycle
from pyworm.drives.zi_worm.tooth import WheelTooth, WormTooth
from pyworm.drives.zi_worm.tooth_compliance import ToothSprings, tooth_springs


@lru_cache(maxsize=2)
def mesh_springs(
    flank: WheelSurface,
    worm_tooth: WormTooth,
    wheel_tooth: WheelTooth,
    threads: int,
    reference_radii: tuple[float, float],
    modulus: float,
    whole_load: float,
    stiffness: float,
) -> ToothSprings:
    """Compliance by all its parameters; cached, since drives often differ in friction, lifts and oil only."""
    paths = contact_paths(worm_tooth.worm, flank, threads, reference_radii)
    cycle = find_mesh_cycle(paths, flank.ratio, worm_tooth, wheel_tooth)
    return tooth_springs(
        gap_at=lambda phase: ToothGap(cycle.contact(phase), worm_tooth, wheel_tooth),
        radii_at=lambda phase: cycle.contact(phase).radii,
        reduced_modulus=modulus,
        whole_load=whole_load,
        stiffness=stiffness,
        longest=wheel_tooth.face_width,
    )
