"""Checks of a worm gear's drawing; each refusal begins with the key that is wrong.

Values that follow from others are checked against them, within what drawings round.
"""

from collections.abc import Callable, Mapping
from math import degrees, pi, radians

from pyworm.drives.worm.drawing.drawing import Drawing, key_of
from pyworm.drives.worm.flanks.worm_profiles import Profile
from pyworm.io.present import present

MOST_DISC = 1.0
"""Largest diameter of a grinding disc [m]."""

ROUNDING = 1e-3
"""Relative disagreement of a redundant length taken as rounding."""

ANGLE_ROUNDING = radians(0.05)
"""Disagreement of a redundant angle taken as rounding [rad]."""

SHIFT_ROUNDING = 0.005
"""Disagreement of a redundant profile shift taken as rounding."""

MOST_THREADS = 12
"""Most threads of a worm; more wind so steeply that they make a pair of crossed gears."""

PRESSURE_ANGLES = radians(10), radians(30)
"""Pressure angles that worms have, each in the definition of its profile."""

MOST_SHIFT = 1.5
"""Largest profile shift in either direction; usual ones are within 0.5."""

LARGEST_OVERSIZE = 0.25
"""Largest oversize of a hob over the worm's reference diameter."""

LEAST_OVERSIZE = 1e-3
"""Least oversize of a hob, likewise: a smaller one leaves a line contact."""

OF_PROFILES: dict[str, tuple[Profile, ...]] = {
    "worm_base_diameter": ("ZI",),
    "worm_base_lead_angle": ("ZI",),
    "worm_disc_diameter": ("ZK", "ZC"),
    "worm_arc_radius": ("ZC", "ZC2"),
}
"""Number of a drawing -> the profiles that have it."""

DERIVED: dict[str, tuple[Callable[[Drawing], float], str]] = {
    "profile_shift": (
        lambda drawing: drawing.profile_shift,
        "centre_distance, module, diameter_factor and teeth, a / m - (q + z2) / 2",
    ),
    "worm_reference_diameter": (
        lambda drawing: drawing.reference_diameter,
        "diameter_factor x module",
    ),
    "worm_axial_pitch": (lambda drawing: pi * drawing.module, "pi x module"),
    "worm_lead": (lambda drawing: drawing.lead, "pi x module x threads"),
    "worm_lead_angle": (lambda drawing: drawing.lead_angle, "tan = threads / diameter_factor"),
    "worm_base_diameter": (lambda drawing: 2 * drawing.base_radius, "the base helix"),
    "worm_base_lead_angle": (lambda drawing: drawing.base_lead_angle, "the base helix"),
    "wheel_reference_diameter": (
        lambda drawing: drawing.wheel_reference_diameter,
        "teeth x module",
    ),
    "hob_reference_diameter": (
        lambda drawing: drawing.reference_diameter + drawing.hob_oversize,
        "the worm's reference diameter and hob.oversize",
    ),
}
"""Number that follows from others -> how, and in words."""


def check_given(given: Mapping[str, float | None]) -> None:
    """Refuse counts, angles and a centre distance that no worm gear has (ValueError)."""
    threads, teeth, module, factor = (
        present(given[key], f"drive.{key}")
        for key in ("threads", "teeth", "module", "diameter_factor")
    )
    if threads >= teeth or threads > MOST_THREADS:
        swapped = teeth <= MOST_THREADS and threads > teeth
        right = f"swapped? threads = {teeth}, teeth = {threads}" if swapped else "such as 2"
        raise ValueError(
            f"threads is {threads} with {teeth} teeth; a worm has 1 to {MOST_THREADS} threads and fewer than "
            f"its wheel has teeth, {right}"
        )
    angle = given.get("pressure_angle")
    low, high = PRESSURE_ANGLES
    if angle is not None and not low <= angle <= high:
        raise ValueError(
            f"pressure_angle is {degrees(angle):.4g} deg; worms have {degrees(low):g} to "
            f'{degrees(high):g} deg, as a rule "20 deg"'
        )
    if not 4 <= factor <= 40:
        meant = factor * module
        raise ValueError(
            f"diameter_factor is {factor:.4g}; worms have 4 to 40, reference diameter over module: here the "
            f"worm's reference diameter would be {_mm(meant)}"
        )


def check_profile(profile: Profile, given: Mapping[str, float | None]) -> None:
    """Refuse numbers that only other profiles have, of discs, arcs and base cylinders (ValueError)."""
    for name, profiles in OF_PROFILES.items():
        if given.get(name) is not None and profile not in profiles:
            words = " and ".join(f'"{profile}"' for profile in profiles)
            raise ValueError(f'{key_of(name)} belongs to profile {words}; profile is "{profile}"')


def check_drawing(drawing: Drawing) -> None:
    """Refuse a drawing of which no worm gear can be made (ValueError)."""
    _check_distance(drawing)
    _check_worm(drawing)
    _check_disc(drawing)
    _check_wheel(drawing)
    _check_engagement(drawing)
    _check_hob(drawing)


def check_redundant(drawing: Drawing, given: Mapping[str, float | None]) -> None:
    """Refuse numbers of a drawing that contradict others (ValueError)."""
    for name, (derive, words) in DERIVED.items():
        value = given.get(name)
        if value is None:
            continue
        right = derive(drawing)
        allowed, shown = ROUNDING * right, "{:.6g} mm".format
        scale = 1e3
        if name == "profile_shift":
            allowed, shown, scale = SHIFT_ROUNDING, "{:.4g}".format, 1.0
        elif name.endswith("angle"):
            allowed, shown, scale = ANGLE_ROUNDING, "{:.2f} deg".format, degrees(1.0)
        if abs(value - right) > allowed:
            raise ValueError(
                f"{key_of(name)} is {shown(value * scale)}, but {words} give {shown(right * scale)}"
                f"{_as_radius(name, value, right)}"
            )


def _mm(value: float) -> str:
    return f"{value * 1e3:.5g} mm"


def _as_radius(name: str, value: float, right: float) -> str:
    """The question whether a diameter is a radius; empty where it is none."""
    halved = name.endswith("diameter") and abs(2 * value / right - 1) < 0.02
    return "; is it a radius? a diameter is required" if halved else ""


def _check_distance(drawing: Drawing) -> None:
    """Refuse a centre distance that asks for an impossible profile shift."""
    if abs(drawing.profile_shift) <= MOST_SHIFT:
        return
    plain = drawing.module / 2 * (drawing.diameter_factor + drawing.teeth)
    twice = abs(drawing.centre_distance / plain - 2) < 0.1
    fitting = (
        f"; a module of {_mm(drawing.module * drawing.centre_distance / plain)} would need none"
    )
    raise ValueError(
        f"centre_distance is {_mm(drawing.centre_distance)}, which asks for a profile shift of "
        f"{drawing.profile_shift:.3g}; module, diameter_factor and teeth make {_mm(plain)}, and shifts "
        f"of up to one module are usual{'; is it twice the distance?' if twice else fitting}"
    )


def _check_between(name: str, value: float, low: float, high: float, why: str) -> None:
    """Refuse a diameter outside an open range; a radius in its place is recognised."""
    if low < value < high:
        return
    meant = "; is it a radius? a diameter is required" if low < 2 * value < high else ""
    if low < value / 2 < high:
        meant = f"; did you mean {_mm(value / 2)}?"
    raise ValueError(
        f"{key_of(name)} is {_mm(value)}; it must lie between {_mm(low)} and {_mm(high)}, "
        f"{why}{meant}"
    )


def _check_worm(drawing: Drawing) -> None:
    """Refuse a worm without addendum or dedendum, or without threads."""
    reference, module = drawing.reference_diameter, drawing.module
    _check_between(
        "worm_tip_diameter",
        drawing.worm_tip_diameter,
        reference,
        reference + 4 * module,
        "above the reference diameter by twice the addendum, as a rule one module",
    )
    _check_between(
        "worm_root_diameter",
        drawing.worm_root_diameter,
        reference - 4 * module,
        reference,
        "below the reference diameter by twice the dedendum, as a rule 1.2 modules",
    )
    pitch = pi * module
    if not 0.2 * pitch < drawing.worm_thickness < 0.8 * pitch:
        raise ValueError(
            f"worm.thickness is {_mm(drawing.worm_thickness)}; the thread's axial thickness is about half "
            f"the axial pitch, {_mm(pitch / 2)}"
        )


def _check_disc(drawing: Drawing) -> None:
    """Refuse a grinding disc that is none, and a disc or an arc that leaves no flank."""
    diameter, arc = drawing.worm_disc_diameter, drawing.worm_arc_radius
    if diameter is not None and not drawing.reference_diameter <= diameter <= MOST_DISC:
        raise ValueError(
            f"worm.disc_diameter is {_mm(diameter)}; grinding discs are larger than the worm, "
            f"{_mm(drawing.reference_diameter)}, and up to {_mm(MOST_DISC)}"
        )
    if arc is not None and not 3 * drawing.module <= arc <= 100 * drawing.module:
        raise ValueError(
            f"worm.arc_radius is {_mm(arc)}; the arc has 3 to 100 modules, as a rule 5 to "
            f"7, {_mm(5 * drawing.module)} to {_mm(7 * drawing.module)}"
        )
    for part, make in (("worm", lambda: drawing.worm), ("hob", lambda: drawing.hob)):
        try:
            make()
        except ValueError as error:
            sizes = {"worm.disc_diameter": diameter, "worm.arc_radius": arc}
            given = [name for name, size in sizes.items() if size is not None]
            raise ValueError(
                f"{', '.join(given)} and pressure_angle do not fit: for the {part} {error} at its lead angle "
                f"of {degrees(drawing.lead_angle):.3g} deg; a larger {', '.join(given)}, pressure_angle or "
                "diameter_factor, or fewer threads are needed"
            ) from error


def _check_wheel(drawing: Drawing) -> None:
    """Refuse a wheel whose diameters do not follow each other, and a face that no worm spans."""
    mean = 2 * drawing.centre_distance - drawing.reference_diameter
    module, throat = drawing.module, drawing.wheel_throat_diameter
    groove = drawing.centre_distance - mean / 2 - module
    if abs(throat / 2 - groove) < 0.25 * module or abs(throat - groove) < 0.25 * module:
        raise ValueError(
            f"wheel.throat_diameter is {_mm(throat)}; that is the size of the throat's groove "
            f"(wheel.groove_radius), the wheel's diameter at the throat is about {_mm(mean + 2 * module)}"
        )
    _check_between(
        "wheel_throat_diameter",
        throat,
        mean,
        mean + 4 * module,
        "above 2 centre_distance - worm.reference_diameter by twice the addendum, as a rule one module",
    )
    _check_between(
        "wheel_root_diameter",
        drawing.wheel_root_diameter,
        mean - 4 * module,
        mean,
        "below 2 centre_distance - worm.reference_diameter by twice the dedendum, as a rule 1.2 modules",
    )
    _check_between(
        "wheel_outside_diameter",
        drawing.wheel_outside_diameter,
        throat * (1 - ROUNDING),
        throat + 4 * module,
        "not below the throat's diameter, as a rule one module above it",
    )
    widest = drawing.worm_tip_diameter
    if not drawing.module < drawing.face_width <= widest:
        raise ValueError(
            f"face_width is {_mm(drawing.face_width)}; a wheel is narrower than its worm's tip diameter, "
            f"{_mm(widest)}, about 2 m (0.5 + sqrt(q + 1)) = "
            f"{_mm(2 * module * (0.5 + (drawing.diameter_factor + 1) ** 0.5))}"
        )
    smallest = drawing.centre_distance - throat / 2
    if not 0.5 * smallest <= drawing.wheel_groove_radius <= 3 * smallest:
        raise ValueError(
            f"wheel.groove_radius is {_mm(drawing.wheel_groove_radius)}; the groove lies about the worm, "
            f"with centre_distance - throat_diameter / 2 = {_mm(smallest)} as a rule"
        )


def _check_engagement(drawing: Drawing) -> None:
    """Refuse tips that touch roots, and a backlash that is none."""
    distance = drawing.centre_distance
    for tip, root, key, other in (
        (
            drawing.worm_tip_diameter,
            drawing.wheel_root_diameter,
            "worm.tip_diameter",
            "wheel.root_diameter",
        ),
        (
            drawing.wheel_throat_diameter,
            drawing.worm_root_diameter,
            "wheel.throat_diameter",
            "worm.root_diameter",
        ),
    ):
        if tip + root >= 2 * distance:
            raise ValueError(
                f"{key} is {_mm(tip)}; with {other} of {_mm(root)} the tip touches the root, they "
                f"must make less than twice centre_distance, {_mm(2 * distance)}"
            )
    if drawing.backlash >= drawing.module:
        raise ValueError(
            f"backlash is {_mm(drawing.backlash)}; it must be a small part of module, such as "
            f"{_mm(0.03 * drawing.module)}"
        )
    for part, height in (
        ("worm", drawing.worm_tip_diameter - drawing.worm_root_diameter),
        ("wheel", drawing.wheel_throat_diameter - drawing.wheel_root_diameter),
    ):
        amount, length = (getattr(drawing, f"{part}_tip_relief{end}") for end in ("", "_length"))
        if amount > 0 and not 0 < length < height / 2:
            raise ValueError(
                f"{part}.tip_relief_length is {_mm(length)}; it must lie between 0 and the tooth's "
                f"height, {_mm(height / 2)}"
            )


def _check_hob(drawing: Drawing) -> None:
    """Refuse a hob smaller than the worm, and one of another kind of number."""
    largest = LARGEST_OVERSIZE * drawing.reference_diameter
    if drawing.hob_oversize < 0:
        raise ValueError(
            f"hob.oversize is {_mm(drawing.hob_oversize)}; a hob smaller than the worm cuts a wheel that "
            "touches it at both ends of the face, it must be zero or more, as a rule 2 % of "
            f"worm.reference_diameter, {_mm(0.02 * drawing.reference_diameter)}"
        )
    least = LEAST_OVERSIZE * drawing.reference_diameter
    if drawing.hob_oversize < least:
        raise ValueError(
            f"hob.oversize is {_mm(drawing.hob_oversize)}; a hob as large as the worm leaves a contact along "
            f"a line, point contacts are computed, for which it must be {_mm(least)} or more, as a rule 2 % "
            f"of worm.reference_diameter, {_mm(0.02 * drawing.reference_diameter)}"
        )
    if drawing.hob_oversize > largest:
        raise ValueError(
            f"hob.oversize is {_mm(drawing.hob_oversize)}; it is the hob's reference diameter beyond the "
            f"worm's {_mm(drawing.reference_diameter)}, at most {_mm(largest)}"
        )
    usual = drawing.centre_distance + drawing.hob_oversize / 2
    distance = drawing.hob_centre_distance or usual
    if abs(distance - usual) > drawing.module / 2:
        raise ValueError(
            f"hob.centre_distance is {_mm(distance)}; it is the distance of the hob's "
            f"axis from the wheel's, within half a module of {_mm(usual)}, centre_distance and half of "
            "hob.oversize"
        )
    tip = drawing.hob.tip_radius
    if 2 * tip < drawing.worm_tip_diameter:
        raise ValueError(
            f"hob.centre_distance is {_mm(drawing.hob.centre_distance)}; with wheel.root_diameter of "
            f"{_mm(drawing.wheel_root_diameter)} the hob's tip diameter would be {_mm(2 * tip)}, below that "
            f"of the worm, {_mm(drawing.worm_tip_diameter)}, whose tip would touch the root that the hob "
            "leaves"
        )
