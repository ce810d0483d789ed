"""`[drive]` of a worm drive: the numbers of its drawing.

The flanks are those of a module, or of the base cylinders of worm and hob.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import degrees, pi
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, model_validator

from pyworm.case import drawing_words
from pyworm.case.shafts import SupportsTable
from pyworm.case.table import Table, plain
from pyworm.drives.worm.drawing.base_cylinders import (
    OF_HOB,
    base_cylinder_design,
    check_no_cylinder_of_the_hob,
)
from pyworm.drives.worm.drawing.design import Assembly, Design, Hand
from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.drawing.drawing import Drawing, key_of
from pyworm.drives.worm.drawing.drawing_checks import (
    DERIVED,
    check_drawing,
    check_given,
    check_profile,
    check_redundant,
)
from pyworm.drives.worm.drawing.usual_values import completed
from pyworm.drives.worm.flanks.worm_profiles import PROFILES, Profile
from pyworm.drives.worm.inspection import Inspection
from pyworm.drives.worm.loads.worm_shaft import WormShaft
from pyworm.drives.worm.patterns.hob_setting import with_swivel
from pyworm.io import units
from pyworm.io.plain_values import Count, Number, PositiveNumber, Text
from pyworm.io.present import present

KNOWN = ", ".join(f'"{profile}"' for profile in PROFILES)

QUALITY = ("quality", "quality_grade", "accuracy_grade", "tolerance_grade")
"""Names of a grade of accuracy, such as those of DIN 3974, by which nothing is computed."""

RIGHT_ANGLE = pi / 2

GLOBOID = ("globoid", "double-enveloping", "hindley")


def _computed(profile: object) -> Profile:
    if not isinstance(profile, str):
        raise ValueError(f"must be one of {KNOWN}")
    if profile.lower() in GLOBOID:
        raise ValueError(
            f"globoid worms are not computed; there are cylindrical worms of the profiles {KNOWN} and roller "
            'enveloping ones, kind = "roller-worm"'
        )
    for known in PROFILES:
        if profile == known:
            return known
    meant = profile.upper()
    meant = drawing_words.PROFILES.get(meant, meant)
    hint = f'; did you mean "{meant}"?' if meant in PROFILES else ""
    raise ValueError(f"must be one of {KNOWN}{hint}")


class DeviationTable(Table, FlankDeviations):
    """What a file of deviations holds, in SI; stored with the case, so that it is the case again."""

    file: Text


class AssemblyTable(Table, Assembly):
    """`[drive.assembly]`: assembly errors, as differences from the design."""


class ShaftTable(Table, WormShaft):
    """`[drive.shaft]`: the worm's shaft between its bearings, which bends."""


class InspectionTable(Table, Inspection):
    """`[drive.inspection]`: balls and deviations for the inspection sheet."""


class _Drawn(Table):
    """A table of a drawing, which has diameters."""

    @model_validator(mode="before")
    @classmethod
    def _diameters(cls, given: Any) -> Any:
        for key in given if isinstance(given, dict) else ():
            right = key.replace("radius", "diameter")
            if key != right and key not in cls.model_fields and right in cls.model_fields:
                raise ValueError(f"{key}: drawings have diameters, give {right}, twice as much")
        return given


class DrawnWormTable(_Drawn):
    """`[drive.worm]` of a drawing; all may be left out, and what follows from other numbers is checked."""

    also_called = drawing_words.OF_WORM

    tip_diameter: units.Length | None = None
    root_diameter: units.Length | None = None
    thickness: units.Length | None = None
    fillet_radius: units.LengthOrZero | None = None
    tip_relief: units.Relief | None = None
    tip_relief_length: units.LengthOrZero | None = None
    reference_diameter: units.Length | None = None
    axial_pitch: units.Length | None = None
    lead: units.Length | None = None
    lead_angle: units.Angle | None = None
    base_diameter: units.Length | None = None
    base_lead_angle: units.Angle | None = None
    disc_diameter: units.Length | None = None
    arc_radius: units.Length | None = None
    deviations: DeviationTable | None = None


class DrawnWheelTable(_Drawn):
    """`[drive.wheel]` of a drawing, likewise."""

    also_called = drawing_words.OF_WHEEL

    throat_diameter: units.Length | None = None
    outside_diameter: units.Length | None = None
    root_diameter: units.Length | None = None
    groove_radius: units.Length | None = None
    fillet_radius: units.LengthOrZero | None = None
    tip_relief: units.Relief | None = None
    tip_relief_length: units.LengthOrZero | None = None
    reference_diameter: units.Length | None = None
    deviations: DeviationTable | None = None


class DrawnHobTable(_Drawn):
    """`[drive.hob]` of a drawing, likewise."""

    also_called = drawing_words.OF_HOB

    oversize: units.Offset | None = None
    reference_diameter: units.Length | None = None
    tip_diameter: units.Length | None = None
    root_diameter: units.Length | None = None
    base_diameter: units.Length | None = None
    axial_pitch: units.Length | None = None
    lead: units.Length | None = None
    base_lead_angle: units.Angle | None = None
    centre_distance: units.Length | None = None
    swivel: units.Tilt | None = None
    axial_shift: units.Offset | None = None


class WormDriveTable(Table):
    """`[drive]`, kind = "worm": the numbers of a drawing.

    Without a `module` the flanks are those of the base cylinders of worm and hob. A right shaft angle may be
    given, others are refused.
    """

    also_called = drawing_words.OF_DRIVE

    kind: Literal["worm"]
    shaft_angle: units.Angle | None = None
    profile: Annotated[Profile, BeforeValidator(_computed)]
    centre_distance: units.Length | None = None
    threads: Count
    teeth: Count
    module: units.Length | None = None
    diameter_factor: PositiveNumber | None = None
    pressure_angle: units.AngleOrZero | None = None
    profile_shift: Number | None = None
    face_width: units.FaceWidth | None = None
    backlash: units.LengthOrZero | None = None
    hand: Hand = "right"
    stiffness: units.Stiffness | None = None
    worm: DrawnWormTable = DrawnWormTable()
    wheel: DrawnWheelTable = DrawnWheelTable()
    hob: DrawnHobTable = DrawnHobTable()
    assembly: AssemblyTable = AssemblyTable()
    shaft: ShaftTable | None = None
    wheel_shaft: SupportsTable | None = None
    inspection: InspectionTable | None = None

    @model_validator(mode="before")
    @classmethod
    def _no_grade(cls, given: Any) -> Any:
        for key in QUALITY:
            if isinstance(given, dict) and key in given:
                raise ValueError(
                    f"{key}: nothing is computed by a grade of accuracy; give its deviations as "
                    "worm.deviations and wheel.deviations, its errors of assembly in [drive.assembly]; "
                    "pyworm check prints the errors of assembly that are allowed"
                )
        return given

    def flaws(self) -> Iterator[str]:
        """Another shaft angle than a right one, and no size of the worm."""
        if self.shaft_angle is not None and abs(self.shaft_angle - RIGHT_ANGLE) > 1e-9:
            yield (
                f"shaft_angle is {degrees(self.shaft_angle):.6g} deg; axes at 90 deg are computed; an "
                "error of that angle goes into assembly.shaft_angle"
            )
        if self.module is None:
            return  # all sizes are given, which `base_cylinder_design` asks for
        sizes = self.diameter_factor, self.worm.reference_diameter, self.profile_shift
        if all(size is None for size in sizes):
            yield (
                "diameter_factor is missing (q, reference diameter of the worm over module); or give "
                "worm.reference_diameter or profile_shift"
            )
        if self.centre_distance is None and (
            self.profile_shift is None or self._given_factor is None
        ):
            yield (
                "centre_distance is missing (a); or give profile_shift, of which it follows with "
                "diameter_factor or worm.reference_diameter"
            )

    def design(self) -> Design:
        """Worm, wheel and hob of the drawing; ValueError with the key at fault if none can be made so."""
        if self.module is None:
            return self._with_deviations(
                base_cylinder_design(self.profile, self._numbers(), self.hand)
            )
        return self._design(*self._drawing())

    def reground(self, part: float) -> tuple[float, Design]:
        """Oversize [m] of a hob of which a part is left, and the design, the hob set up as usual.

        For a drive with a module; ValueError as of `design`.
        """
        drawing, assumed = self._drawing()
        smaller = replace(
            drawing,
            hob_oversize=part * drawing.hob_oversize,
            hob_swivel=None if part < 1 else drawing.hob_swivel,
            hob_centre_distance=None if part < 1 else drawing.hob_centre_distance,
        )
        return smaller.hob_oversize, self._design(smaller, assumed)

    def completed_numbers(self) -> dict[str, Any]:
        """Numbers of the design by their keys in `[drive]`, with those assumed and the hob's settings, in SI.

        ValueError as of `design`.
        """
        if self.module is None:
            found = self._numbers()
        else:
            drawing, _ = self._drawing()
            if drawing.hob_swivel is None:
                drawing, _ = with_swivel(drawing)
            found = vars(drawing) | {"hob_centre_distance": drawing.hob.centre_distance}
        return {key_of(name): value for name, value in found.items() if value is not None}

    def _drawing(self) -> tuple[Drawing, tuple[str, ...]]:
        """The complete drawing, and the dimensions assumed by common practice."""
        given = self._numbers() | {
            "centre_distance": self._distance,
            "diameter_factor": self._diameter_factor(),
        }
        check_no_cylinder_of_the_hob(given)
        if given["hob_oversize"] is None and self.hob.reference_diameter is not None:
            worm = given["diameter_factor"] * self._module
            given["hob_oversize"] = self.hob.reference_diameter - worm
        check_given(given)
        independent = {
            name: value for name, value in given.items() if name not in {*DERIVED, *OF_HOB}
        }
        check_profile(self.profile, given)
        drawing, assumed = completed(independent, self.profile)
        check_redundant(drawing, given)
        check_drawing(drawing)
        return drawing, assumed

    def _design(self, drawing: Drawing, assumed: tuple[str, ...]) -> Design:
        """Worm, wheel and hob of a drawing, the hob's swivel found where it is not given."""
        if drawing.hob_swivel is None:
            drawing, swivel = with_swivel(drawing)
            assumed = *assumed, swivel
        return self._with_deviations(
            Design(
                drawing.worm,
                drawing.wheel,
                drawing.hob,
                drawing.centre_distance,
                self.hand,
                assumed,
            )
        )

    def _with_deviations(self, design: Design) -> Design:
        """A design with the deviations of flanks that are given."""
        worm, wheel = (
            None if part.deviations is None else plain(part.deviations, FlankDeviations)
            for part in (self.worm, self.wheel)
        )
        return replace(
            design,
            worm=replace(design.worm, deviations=worm),
            wheel=replace(design.wheel, deviations=wheel),
        )

    def _numbers(self) -> dict[str, Any]:
        """Numbers of the drawing by their names in `Drawing`, and those that follow from others."""
        numbers = {
            key: getattr(self, key)
            for key in (
                *("centre_distance", "threads", "teeth", "module", "diameter_factor"),
                *("pressure_angle", "profile_shift", "face_width", "backlash"),
            )
        }
        for part in ("worm", "wheel", "hob"):
            table = dict(getattr(self, part))
            table.pop("deviations", None)
            numbers |= {f"{part}_{key}": value for key, value in table.items()}
        return numbers

    def _diameter_factor(self) -> float:
        """q as it is given, or as it follows from the reference diameter or the profile shift."""
        if self._given_factor is not None:
            return self._given_factor
        return 2 * (self._distance / self._module - self._shift) - self.teeth

    @property
    def _module(self) -> float:
        return present(self.module, "drive.module")

    @property
    def _shift(self) -> float:
        return present(self.profile_shift, "drive.profile_shift")

    @property
    def _given_factor(self) -> float | None:
        """q where it is given, or the reference diameter."""
        if self.diameter_factor is not None:
            return self.diameter_factor
        diameter = self.worm.reference_diameter
        return None if diameter is None else diameter / self._module

    @property
    def _distance(self) -> float:
        """a as it is given, or as it follows from the profile shift, m ((q + z2) / 2 + x) [m]."""
        if self.centre_distance is not None:
            return self.centre_distance
        factor = present(self._given_factor, "drive.diameter_factor")
        return self._module * ((factor + self.teeth) / 2 + self._shift)
