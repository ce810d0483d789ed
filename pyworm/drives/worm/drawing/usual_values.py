"""Usual values of what a drawing leaves out, each of which is told.

Sources: DIN 3975 for addenda, clearance, groove and face width (as handed on in textbooks, such as Niemann
and Winter, Maschinenelemente III), Sharif et al. (2001) for the hob's oversize (1.64 mm on some 78 mm).
Backlash, fillets and tip relief have none, nor has the grinding disc of ZK and ZC: values of the usual size.
"""

from collections.abc import Callable, Mapping
from math import degrees, pi, sqrt
from typing import Any

from pyworm.drives.worm.drawing.drawing import CLEARANCE, Drawing, key_of
from pyworm.drives.worm.drawing.usual_fillets import USUAL, fitting_fillets
from pyworm.drives.worm.flanks.worm_profiles import Profile

FILLETS = "worm_fillet_radius", "wheel_fillet_radius"
"""Numbers of a drawing that follow, if they are not given, from the flanks (`usual_fillets`)."""

Known = Mapping[str, float]
"""Numbers of a drawing by their names in `Drawing`."""

_FILLET = "0.2 modules or what fits, assumed without a source"
_HOB_FILLET = f"{_FILLET}, from a rounded edge of the hob's tip"

_USUAL: dict[str, tuple[Callable[[Known], float], str]] = {
    "pressure_angle": (lambda known: pi / 9, "as of most worms"),
    "worm_tip_diameter": (
        lambda known: known["module"] * (known["diameter_factor"] + 2),
        "an addendum of one module",
    ),
    "worm_root_diameter": (
        lambda known: known["module"] * (known["diameter_factor"] - 2 - 2 * CLEARANCE),
        "a dedendum of 1.2 modules",
    ),
    "worm_thickness": (lambda known: pi / 2 * known["module"], "half the axial pitch"),
    "wheel_throat_diameter": (
        lambda known: _mean_diameter(known) + 2 * known["module"],
        "one module beyond the worm's reference cylinder",
    ),
    "wheel_outside_diameter": (
        lambda known: known["wheel_throat_diameter"] + known["module"],
        "one module more than the throat",
    ),
    "wheel_root_diameter": (
        lambda known: _mean_diameter(known) - 2 * (1 + CLEARANCE) * known["module"],
        "1.2 modules within the worm's reference cylinder",
    ),
    "wheel_groove_radius": (
        lambda known: known["centre_distance"] - known["wheel_throat_diameter"] / 2,
        "concentric with the worm",
    ),
    "face_width": (
        lambda known: 2 * known["module"] * (0.5 + sqrt(known["diameter_factor"] + 1)),
        "2 m (0.5 + sqrt(q + 1))",
    ),
    "backlash": (lambda known: 0.03 * known["module"], "0.03 modules, assumed without a source"),
    "worm_fillet_radius": (lambda known: 0.0, _FILLET),
    "wheel_fillet_radius": (lambda known: 0.0, _HOB_FILLET),
    "worm_tip_relief": (
        lambda known: 0.004 * known["module"],
        "0.004 modules, assumed without a source",
    ),
    "worm_tip_relief_length": (lambda known: 0.25 * known["module"], "a quarter of a module"),
    "wheel_tip_relief": (
        lambda known: 0.004 * known["module"],
        "0.004 modules, assumed without a source",
    ),
    "wheel_tip_relief_length": (lambda known: 0.25 * known["module"], "a quarter of a module"),
    "hob_oversize": (
        lambda known: 0.02 * known["module"] * known["diameter_factor"],
        "2 % of the worm's reference diameter",
    ),
    "hob_axial_shift": (lambda known: 0.0, "in the middle of the face"),
}
"""Number of a drawing -> its usual value from those before it, and that in words; fillets follow from the
flanks when all else is known."""

_DISC = (lambda known: 0.5, "as of new grinding wheels")
_ARC = (lambda known: 6 * known["module"], "six modules, of 5 to 7")

_USUAL_OF: dict[Profile, dict[str, tuple[Callable[[Known], float], str]]] = {
    "ZK": {"worm_disc_diameter": _DISC},
    "ZC": {"worm_disc_diameter": _DISC, "worm_arc_radius": _ARC},
    "ZC2": {"worm_arc_radius": _ARC},
}
"""Profile with a disc or an arc -> usual values of the numbers that only such a profile has."""


def _mean_diameter(known: Known) -> float:
    """Diameter of the wheel at the worm's reference cylinder d_m2 = 2 a - d_m1 [m]."""
    return 2 * known["centre_distance"] - known["diameter_factor"] * known["module"]


def completed(
    given: Mapping[str, float | None], profile: Profile = "ZI"
) -> tuple[Drawing, tuple[str, ...]]:
    """A drawing with usual values where none, or None, is given, and a sentence on each, by its key."""
    known: dict[str, Any] = {name: value for name, value in given.items() if value is not None}
    assumed = {}
    for name, (rule, words) in (_USUAL | _USUAL_OF.get(profile, {})).items():
        if name not in known:
            known[name] = rule(known)
            assumed[name] = words
    if any(name in assumed for name in FILLETS):
        fits = _fitting(Drawing(**known, profile=profile))
        known |= {name: fit for name, fit in zip(FILLETS, fits, strict=True) if name in assumed}
    sentences = (
        f"{key_of(name)} = {_shown(name, known[name])}, {words}" for name, words in assumed.items()
    )
    return Drawing(**known, profile=profile), tuple(sentences)


def _fitting(drawing: Drawing) -> tuple[float, float]:
    """Usual fillets of worm and wheel [m]; of a drawing without flanks, which is refused, by its module."""
    try:
        return fitting_fillets(drawing)
    except ValueError:
        return USUAL * drawing.module, USUAL * drawing.module


def _shown(name: str, value: float) -> str:
    return f"{degrees(value):.5g} deg" if name.endswith("angle") else f"{value * 1e3:.5g} mm"
