"""Play between the flanks of worm and wheel as assembled, without which they cannot be put together."""

from math import pi
from typing import TYPE_CHECKING

from pyworm.drives.zi_worm.interference import PHASES

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.gears import ZiWormGears


def circumferential_play(gears: "ZiWormGears") -> float | None:
    """Circumferential play on the wheel's reference circle [m], negative of teeth that jam; None if unknown.

    The backlash as designed, less how far each flank turns the wheel ahead of where it is without errors of
    the assembly: by its contact point, and by how far it stands off that where the flanks touch at an edge.
    """
    backlash = gears.wheel.backlash
    if backlash is None or (gears.aligned and gears.edge_contact is None):
        return backlash
    return backlash - gears.wheel_reference_radius * (_turned(gears) + _turned(gears.turned))


def check_play(gears: "ZiWormGears") -> None:
    """Refuse teeth that errors of the assembly leave no play: they cannot be assembled.

    Raises
    ------
    ValueError
        The sentence begins with the table at fault.
    """
    left, backlash = gears.play, gears.wheel.backlash
    if left is None or backlash is None or left >= 0 or gears.aligned:
        return
    raise ValueError(
        f"assembly: with {gears.errors_in_words} the teeth jam: of the backlash of "
        f"{backlash * 1e3:.3g} mm, {-left * 1e3:.3g} mm are missing; smaller errors or a larger "
        "backlash are needed"
    )


def _turned(gears: "ZiWormGears") -> float:
    """How far the driven flank turns the wheel ahead of where it is without errors of the assembly [rad]."""
    ahead = gears.cycle.absolute_error - gears.aligned_cycle.absolute_error
    pitch = 2 * pi / gears.wheel.teeth
    ahead -= pitch * round(ahead / pitch)  # another pair of teeth is as good
    lever = float(abs(gears.cycle.lever))
    touches = (gears.first_touch(gears.cycle.contact(phase)) for phase in PHASES)
    least = min((touch.gap for touch in touches if touch is not None), default=0.0)
    return ahead - least / lever
