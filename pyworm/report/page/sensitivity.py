"""How film and pressure answer to oil grade, temperature and misalignment, by closed forms.

Each variation changes the closed-form film of every solved contact; the simulated film is taken to change by
the same share. Nothing is solved again.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import isnan, nan

from pyworm.case.case import Case
from pyworm.case.contact import GapCase
from pyworm.drives.gear_pair.drive import GearPairDrive
from pyworm.drives.zi_worm.drive import ZiWormDrive
from pyworm.materials.oil import Barus, Oil, Roelands
from pyworm.report.page.content import Block, Section, Table, Words
from pyworm.report.page.figures import composite_roughness
from pyworm.result.result import Result
from pyworm.scene.index import Place
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales, scales

GRADE_STEP = 10 ** (1 / 6)
"""Ratio of the viscosities at 40 degC of neighbouring grades of ISO 3448, on average."""

WARMER = 10.0
"""Change of the oil's temperature [K]."""

SHIFT = 0.1e-3
"""Error of mounting of a worm drive [m]."""

TILT = 1e-3
"""Error of the shaft angle of a worm drive [rad]: 0.1 mm over 100 mm."""

LEAD_ERROR = 10e-6
"""Deviation of the flank lines of a gear pair over the face width [m]."""

MESH_STIFFNESS = 0.85 * 20e9
"""Stiffness of the teeth of steel spur gears, for each width, against an uneven load [N/m2].

0.85 of 20 N/(mm um), the usual value of ISO 6336-1 (method C), from memory.
"""

Contact = Scene | LineScene


@dataclass(frozen=True)
class Variation:
    """One thing changed.

    Attributes
    ----------
    label : str
        What.
    film : float
        Least film of all contacts that follows [m]; nan, as the ratios, where there is no contact.
    film_ratio, pressure_ratio : float
        Film there and largest Hertz pressure of all contacts over what they were [-].
    note : str
        What else it does.
    """

    label: str
    film: float
    film_ratio: float
    pressure_ratio: float
    note: str = ""


def sensitivity_section(case: Case, result: Result) -> Section | None:
    """The variations of a case as a table; None without a film, and of a gap whose file is not kept."""
    if isinstance(case.tables, GapCase) or not result.solutions:
        return None
    found = variations(case, result)
    roughness = composite_roughness(result)
    least = min(of.figures.film_min.value for of in result.solutions)
    rows = [("as it is", f"{least * 1e6:.3g} µm", "", *_lambda(least, roughness), "", "")]
    rows += [
        (
            one.label,
            "" if isnan(one.film) else f"{one.film * 1e6:.3g} µm",
            _change(one.film_ratio),
            *_lambda(one.film, roughness),
            _change(one.pressure_ratio),
            one.note,
        )
        for one in found
    ]
    head = ("", "Least film", "change", *(("lambda",) if roughness else ()), "Hertz pressure", "")
    words = (
        "By closed forms, not solved again: the film of Nijenbanning, Venner and Moes (point) or of Moes "
        "(line contact) at each solved contact, the simulated film changed by the same share. One grade "
        f"is a factor of {GRADE_STEP:.2f} in viscosity at one temperature; temperatures are those of the "
        "oil at the inlet, by the case's own law of viscosity."
    )
    blocks: list[Block] = [Table(head, tuple(rows)), Words(words)]
    blocks += [Words(of) for of in _misalignment_words(case)]
    return Section("Sensitivity", tuple(blocks))


def _change(ratio: float) -> str:
    """A change in percent; nothing where there is none."""
    return "" if isnan(ratio) or abs(ratio - 1) < 1e-9 else f"{(ratio - 1) * 100:+.1f} %"


def _lambda(film: float, roughness: float | None) -> tuple[str, ...]:
    if not roughness:
        return ()
    return ("" if isnan(film) else f"{film / roughness:.3g}",)


def variations(case: Case, result: Result) -> list[Variation]:
    """Film and pressure of every variation that the case knows enough for."""
    scenes = [case.scene(**Place.of(of).given) for of in result.solutions]
    films = [of.figures.film_min.value for of in result.solutions]

    def with_oil(label: str, change: Callable[[Oil], Oil]) -> Variation:
        return _variation(label, scenes, films, [replace(s, oil=change(s.oil)) for s in scenes])

    found = [
        with_oil("one grade thinner", lambda oil: thickened(oil, 1 / GRADE_STEP)),
        with_oil("one grade thicker", lambda oil: thickened(oil, GRADE_STEP)),
    ]
    if scenes[0].oil.heat is not None:
        found += [
            with_oil(f"oil {WARMER:g} K cooler", lambda oil: oil.warmed(-WARMER)),
            with_oil(f"oil {WARMER:g} K warmer", lambda oil: oil.warmed(WARMER)),
        ]
    if isinstance(case.drive, ZiWormDrive):
        found += _worm_misaligned(case.drive, result, scenes, films)
    if isinstance(case.drive, GearPairDrive):
        found += _gears_misaligned(case.drive, scenes, films)
    return found


def _variation(
    label: str, before: list[Contact], films: list[float], after: list[Contact], note: str = ""
) -> Variation:
    """What changed contacts make of the films of those that were solved."""
    shares = [
        _closed_form(new)[0] / _closed_form(old)[0] for old, new in zip(before, after, strict=True)
    ]
    changed = [film * share for film, share in zip(films, shares, strict=True)]
    worst = changed.index(min(changed))
    pressures = [max(_closed_form(scene)[1] for scene in scenes) for scenes in (before, after)]
    return Variation(
        label=label,
        film=changed[worst],
        film_ratio=changed[worst] / min(films),
        pressure_ratio=pressures[1] / pressures[0],
        note=note,
    )


def _closed_form(scene: Contact) -> tuple[float, float]:
    """Film [m] and largest pressure [Pa] of a contact in closed form."""
    sizes = line_scales(scene) if isinstance(scene, LineScene) else scales(scene)
    return sizes.film, sizes.hertz.pressure_max


def thickened(oil: Oil, ratio: float) -> Oil:
    """The oil with another viscosity at ambient pressure, alpha being kept."""
    law = oil.viscosity
    if isinstance(law, Barus):
        return replace(oil, viscosity=Barus(law.eta0 * ratio, law.alpha))
    return replace(oil, viscosity=Roelands.from_alpha(law.eta0 * ratio, law.alpha, law.p0))


def _worm_misaligned(
    drive: ZiWormDrive, result: Result, scenes: list[Contact], films: list[float]
) -> list[Variation]:
    """A ZI drive mounted wrongly: its contacts move over the tooth and change their curvature."""
    mounted = (
        ("centre distance {0:+.1f} mm", "assembly.centre_distance", SHIFT),
        ("worm shifted {0:+.1f} mm along the wheel's axis", "assembly.axial_shift", SHIFT),
        ("shaft angle {0:+.1f} mrad", "assembly.shaft_angle", TILT),
    )
    found = []
    for label, entry, size in mounted:
        for by in (-size, size):
            called = label.format(by * 1e3)
            try:
                other = drive.varied(entry, by)
                after = [other.scene_under(of.load, of.phase) for of in result.solutions]
            except ValueError:
                found.append(Variation(called, nan, nan, nan, "the teeth no longer touch"))
                continue
            found.append(_variation(called, scenes, films, after, _moved(drive, other)))
    return found


def _moved(drive: ZiWormDrive, other: ZiWormDrive) -> str:
    """Where the contact at mid-mesh goes, and its relative radii."""
    before, after = drive.contact(0.5), other.contact(0.5)
    across = (after.point[1] - before.point[1]) * 1e3
    long_radius, short_radius = max(after.radii), min(after.radii)
    return (
        f"at mid-mesh the contact moves {across:+.1f} mm along the wheel's axis; radii "
        f"{long_radius:.2f} m, {short_radius * 1e3:.1f} mm"
    )


def _gears_misaligned(
    drive: GearPairDrive, scenes: list[Contact], films: list[float]
) -> list[Variation]:
    """Flanks that are not parallel: the load grows linearly over the face."""
    if not all(isinstance(scene, LineScene) for scene in scenes):
        return []
    mean = drive.normal_force / drive.teeth.face_width
    excess = MESH_STIFFNESS * LEAD_ERROR / (2 * mean)
    factor = 1 + excess if excess <= 1 else 2 * excess**0.5
    after = [replace(scene, load=scene.load * factor) for scene in scenes]
    label = f"flank lines {LEAD_ERROR * 1e6:g} µm apart over the face"
    note = f"load at one end {factor:.2f} times the mean (K_Hbeta)"
    return [_variation(label, scenes, films, after, note)]


def _misalignment_words(case: Case) -> list[str]:
    if isinstance(case.drive, ZiWormDrive):
        return [
            "Misalignment by the drive's own geometry: the unloaded contact is found again, at the same "
            "phases of its new mesh cycle; the load of the tooth stays."
        ]
    if isinstance(case.drive, GearPairDrive):
        return [
            "Misalignment by K_Hbeta of ISO 6336-1 with a mesh stiffness of 17 N/(mm µm), without crowning: "
            "1 + c F/(2 w), or 2 [c F/(2 w)]^(1/2) where the contact does not reach over the whole face."
        ]
    if case.drive is not None:
        return ["How misalignment changes the contacts of this drive is not known in closed form."]
    return []
