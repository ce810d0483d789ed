"""Cache of the compliance of a ZI worm drive's tooth pairs over their mesh cycle."""

from dataclasses import dataclass, field
from functools import lru_cache

from pyworm.drives.worm.drawing.design import Assembly, Hob, Wheel, Worm
from pyworm.drives.worm.loads.tooth_compliance import ToothSprings, tooth_springs
from pyworm.drives.worm.teeth.gears import WormGears


@dataclass(frozen=True)
class MeshedTeeth:
    """Teeth by what decides their contacts.

    Attributes
    ----------
    parts : tuple of Worm, Wheel and Hob
        The design table.
    distance : float
        Distance of worm and wheel axes [m].
    mounted : Assembly
        Where the worm runs.
    gears : WormGears
        The gears of them, whatever their load and oil.
    """

    parts: tuple[Worm, Wheel, Hob]
    distance: float
    mounted: Assembly
    gears: WormGears = field(compare=False)

    @classmethod
    def of(cls, gears: WormGears) -> "MeshedTeeth":
        """The teeth of gears, or of a drive."""
        parts = gears.worm, gears.wheel, gears.hob
        return cls(parts, gears.centre_distance, gears.mounted, gears)


@lru_cache(maxsize=2)
def mesh_springs(
    teeth: MeshedTeeth, modulus: float, whole_load: float, stiffness: float
) -> ToothSprings:
    """Compliance by all that decides it; cached, as drives often differ in friction, lifts and oil only."""
    gears = teeth.gears
    return tooth_springs(
        gap_at=lambda phase: gears.gap(gears.cycle.contact(phase)),
        radii_at=lambda phase: gears.cycle.contact(phase).radii,
        reduced_modulus=modulus,
        whole_load=whole_load,
        stiffness=stiffness,
        longest=gears.wheel.face_width,
        touch_at=lambda phase: gears.touching_place(gears.cycle.contact(phase)),
        follows=gears.cycle.follows,
    )
