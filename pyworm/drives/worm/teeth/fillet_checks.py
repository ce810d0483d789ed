"""Fillets at the roots of thread and tooth: whether there is room for them, and whether the mesh meets them.

The worm's fillet is an arc in the axial section, tangent to the root cylinder and to the flank. The wheel's
is left by the hob, whose tip has its edge rounded by such an arc, tangent to the tip cylinder and the flank.
"""

from math import cos, pi

from pyworm.drives.worm.drawing.usual_fillets import USUAL
from pyworm.drives.worm.flanks.thread_section import axial_angle, thread_thickness
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth_form import worm_thickness


def check_fillets(gears: WormGears) -> None:
    """Refuse fillets that do not fit between the threads, or on the tip of the hob's (ValueError)."""
    for name in ROOMS:
        _check_room(gears, name)


ROOMS = {"worm": "the space between the threads", "wheel": "the tip of the hob's thread"}
"""Where the fillets of a body, or what makes them, have to fit in pairs."""


def _check_room(gears: WormGears, name: str) -> None:
    """Refuse a body's fillet that leaves no flank, or two of which need more than there is [m]."""
    fillet = getattr(gears, name).fillet_radius
    flank = gears.worm_flank if name == "worm" else gears.wheel_flank.hob
    if fillet == 0:
        return
    refused = f"{name}.fillet_radius is {_mm(fillet)}"
    if fillet < 0:
        raise ValueError(f"{refused}; it must not be negative")
    usual = f"as a rule it is {USUAL:g} modules, {_mm(USUAL * gears.module)}"
    try:
        radius = _form_radius(gears, name)
    except ValueError as error:
        raise ValueError(f"{refused}: {error}; {usual}") from error
    needed, room = 2 * fillet * cos(axial_angle(flank, radius)), _room(gears, name, radius)
    if room <= 0:
        raise ValueError(_closed(name, radius))
    if needed > room:
        raise ValueError(
            f"{refused}: two of them need {_mm(needed)} of {ROOMS[name]}, which is {_mm(room)} wide on a "
            f"diameter of {_mm(2 * radius)}, where they begin; {usual}"
        )


def _form_radius(gears: WormGears, name: str) -> float:
    """Radius of worm or hob at which the flank ends at a body's fillet, or without one at root or tip [m]."""
    return gears.worm_tooth.form_radius if name == "worm" else gears.wheel_tooth.hob_form_radius


def _room(gears: WormGears, name: str, radius: float) -> float:
    """Axial width of what two fillets of a body share, on a cylinder of worm or hob [m]."""
    if name == "worm":
        return pi * gears.module - worm_thickness(gears, radius)
    return hob_thickness(gears, radius)


def _closed(name: str, radius: float) -> str:
    """The sentence about flanks that meet at a radius of worm or hob [m] before the root is reached."""
    return (
        f"{name}.root_diameter leaves no room: both flanks of {ROOMS[name]} meet above a diameter of "
        f"{_mm(2 * radius)}; less depth, a smaller pressure angle, thinner threads or fewer are needed"
    )


def hob_thickness(gears: WormGears, radius: float) -> float:
    """Axial thickness of the hob's thread on a cylinder [m]: the worm's and the backlash that it cuts."""
    flank, (worm_radius, reference) = gears.wheel_flank.hob, gears.reference_radii
    there = worm_thickness(gears, worm_radius) + (gears.wheel.backlash or 0.0)
    there *= gears.hob.axial_pitch / gears.worm.axial_pitch
    return thread_thickness(flank, radius, reference, there)


def fillet_warnings(gears: WormGears) -> tuple[str, ...]:
    """A sentence for each fillet into which the path of contact, or the other tip in the mid-plane, runs."""
    distance, hob, thread = gears.axes_distance, gears.hob, gears.worm_tooth
    from_worm = thread.form_radius if thread.form_radius > gears.worm_flank.start_radius else 0.0
    from_wheel = hob.centre_distance - gears.wheel_tooth.hob_form_radius
    ends = gears.cycle.begin_boundary, gears.cycle.end_boundary
    said = []
    for name, other, form, reached in (
        ("worm", "wheel", from_worm, distance - gears.wheel.throat_radius),
        ("wheel", "worm", from_wheel, distance - gears.worm.tip_radius),
    ):
        fillet = getattr(gears, name).fillet_radius
        end = _form_radius(gears, name)
        if fillet == 0 and gears.worm.thickness is not None and _room(gears, name, end) <= 0:
            said.append(f"{_closed(name, end)} to have a fillet")
        in_path = form > 0 and f"{name} root" in ends
        if fillet == 0 or not (in_path or reached < form):
            continue
        runs = (
            "the path of contact runs into it"
            if in_path
            else f"the tip of the {other}, which reaches to {_mm(2 * reached)}, may touch it"
        )
        said.append(
            f"{name}.fillet_radius is {_mm(fillet)}; the fillet begins on a diameter of {_mm(2 * form)}, and "
            f"{runs}; a smaller one or a lower tip of the {other} is needed"
        )
    return tuple(said)


def _mm(value: float) -> str:
    return f"{value * 1e3:.4g} mm"
