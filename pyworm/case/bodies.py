"""`[bodies]`: the solids of a contact."""

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import AfterValidator, Field, ValidationInfo, model_validator

from pyworm.case.surface import SurfaceTable, texture_of
from pyworm.case.table import Table, plain
from pyworm.formulas.rough_contact import RQ_OVER_RA
from pyworm.io import units
from pyworm.io.plain_values import AboveZeroToOne
from pyworm.materials import solids
from pyworm.materials.body import Body, SolidConstants
from pyworm.materials.coating import Coating
from pyworm.materials.fatigue_strength import FatigueStrength, check_strength
from pyworm.materials.oil import Oil
from pyworm.materials.softening import check_points
from pyworm.materials.topography import Topography


def _finish(text: str) -> str:
    if text not in solids.finishes():
        raise ValueError(f"must be one of {', '.join(solids.finishes())}")
    return text


RZ_OVER_RA = 6.0
"""Mean peak-to-valley height Rz over the arithmetic mean Ra (ISO 6336-2: Ra = Rz/6, from memory) [-]; of
single surfaces 4 to 10."""

_ROUGHNESSES = "roughness", "roughness_ra", "roughness_rz"
"""Keys that give a height of roughness, one of them."""

_OF_HEIGHTS = "roughness_slope", "roughness_aspect", "asperity_sharpness", "asperity_density"
"""Keys that say how the heights of a roughness are spread."""


class CoatingTable(Table, Coating):
    """`[bodies.NAME.coating]`: an elastic layer on the surface."""

    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]


class FatigueTable(Table, FatigueStrength):
    """`[bodies.NAME.fatigue]`: what the material endures without end, over depth."""

    def flaws(self) -> Iterator[str]:
        """Limits and profiles that no material has."""
        try:
            check_strength(self)
        except ValueError as error:
            yield str(error)


class BodyTable(Table, SolidConstants):
    """`[bodies.NAME]`: one solid; the thermal constants are needed where the oil has `[oil.heat]`.

    Without a bulk temperature of its own a body is as warm as the oil at the inlet. The roughness is the root
    mean square height Rq, or by `roughness_ra` the arithmetic mean Ra, 0.8 Rq of heights spread normally, or
    by `roughness_rz` the mean peak-to-valley height Rz, six times Ra as ISO 6336-2 has it.
    The lay is the angle of its ridges from the surface's own motion. With `asperity_sharpness` the contact is
    that of Greenwood and Tripp's asperities. A `material` by name gives all constants
    that are not given beside it, a `finish` the usual roughness of flanks so made. Where the modulus is given
    by temperature, `youngs_modulus` is the first of it, and contacts have that at the bulk temperature.
    """

    material: Annotated[str, AfterValidator(solids.named_material)] | None = None
    finish: Annotated[str, AfterValidator(_finish)] | None = None
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]
    roughness_ra: units.Roughness | None = None
    roughness_rz: units.Roughness | None = None
    roughness_slope: AboveZeroToOne | None = None
    roughness_aspect: Annotated[float, Field(strict=True, ge=1 / 9, le=9)] | None = None
    lay: units.AngleOrZero | None = None
    asperity_density: Annotated[float, Field(strict=True, gt=0, le=0.3)] | None = None
    boundary_friction_factor: Annotated[float, Field(strict=True, ge=0.2, le=5)] | None = None
    surface: SurfaceTable | None = None
    coating: CoatingTable | None = None
    fatigue: FatigueTable | None = None

    @model_validator(mode="before")
    @classmethod
    def _by_name(cls, given: Any, info: ValidationInfo) -> Any:
        """The table with what its material and its finish give; a stored one has it already."""
        if info.context == units.SI or not isinstance(given, dict):
            return given
        if {"youngs_modulus", "modulus_by_temperature"} <= given.keys():
            raise ValueError("give either youngs_modulus or modulus_by_temperature, one of the two")
        whole, finish = dict(given), given.get("finish")
        if solids.is_named(given.get("material")):
            whole = _constants_beside(given) | whole
        if "youngs_modulus" not in whole:
            whole |= _room_modulus(whole.get("modulus_by_temperature"))
        if finish is not None and given.keys() & {*_ROUGHNESSES, "surface"}:
            raise ValueError(
                "give either finish or roughness (roughness_ra, roughness_rz, surface), one of them"
            )
        if finish in solids.finishes():
            whole["roughness_ra"] = solids.usual_roughness(finish)
        return whole

    def flaws(self) -> Iterator[str]:
        """Heights beside a surface, two kinds of them, or what says nothing without others."""
        heights = self.given(*_ROUGHNESSES, *_OF_HEIGHTS, "lay")
        for name in heights if self.surface is not None else ():
            yield f"{name} has no effect with surface, whose heights give it"
        check_points("modulus_by_temperature", self.modulus_by_temperature)
        known = self.given(*_ROUGHNESSES)
        if len(known) > 1:
            yield "give either roughness (Rq), roughness_ra (Ra) or roughness_rz (Rz), one of them"
        for name in self.given(*_OF_HEIGHTS) if not known else ():
            yield f"{name} needs roughness (Rq) or roughness_ra (Ra) with it"
        if self.asperity_sharpness is not None and self.roughness_slope is not None:
            yield (
                "give either roughness_slope (rough on all scales) or asperity_sharpness (asperities of one "
                "radius), one of the two"
            )
        if self.asperity_density is not None and self.asperity_sharpness is None:
            yield "asperity_density needs asperity_sharpness with it, such as 0.01"
        if self.lay is not None and self.roughness_aspect is None:
            yield "lay needs roughness_aspect with it, such as 3: without it there is no lay"

    def body(self, oil: Oil) -> Body:
        """The solid under an oil."""
        names = {"surface", "material", "finish", "coating", "fatigue"}
        constants = {name: value for name, value in self if value is not None and name not in names}
        constants["coating"] = None if self.coating is None else plain(self.coating, Coating)
        constants["fatigue"] = (
            None if self.fatigue is None else plain(self.fatigue, FatigueStrength)
        )
        if self.surface is not None and self.surface.found:
            constants |= _of_surface(self.surface.topography())
            constants["long_waves"] = self.surface.long_waves()
        for name, factor in (
            ("roughness_ra", RQ_OVER_RA),
            ("roughness_rz", RQ_OVER_RA / RZ_OVER_RA),
        ):
            if (height := constants.pop(name, None)) is not None:
                constants["roughness"] = factor * height
        if oil.heat is not None and self.bulk_temperature is None:
            constants["bulk_temperature"] = oil.heat.inlet_temperature
        return Body(**constants)


def _constants_beside(given: dict[str, Any]) -> dict[str, Any]:
    """Constants of a table's named material; a modulus given beside it takes the place of all of its own."""
    constants = solids.constants(solids.named_material(given["material"]))
    if given.keys() & {"youngs_modulus", "modulus_by_temperature"}:
        del constants["youngs_modulus"]
        constants.pop("modulus_by_temperature", None)
    return constants


def _room_modulus(by_temperature: Any) -> dict[str, Any]:
    """The first modulus of those by temperature as they are written; nothing where none is."""
    if isinstance(by_temperature, list) and by_temperature and isinstance(by_temperature[0], list):
        return {"youngs_modulus": by_temperature[0][-1]}
    return {}


def _of_surface(surface: Topography) -> dict[str, Any]:
    """A topography and its figures, as constants of a body."""
    texture = texture_of(surface)
    return {
        "topography": surface,
        "roughness": texture.rq,
        "roughness_slope": texture.slope,
        "roughness_aspect": texture.aspect,
        "lay": texture.lay + surface.x_direction,
    }


def taken_by_name(bodies: Any) -> dict[str, str]:
    """What the names in `[bodies]`, as it is written, stand for: dotted key -> source of the constants."""
    taken = {}
    tables = bodies.items() if isinstance(bodies, dict) else ()
    for name, body in tables:
        material, finish = (
            body.get(key) if isinstance(body, dict) else None for key in ("material", "finish")
        )
        if isinstance(material, str) and solids.is_named(material):
            source = solids.source(solids.named_material(material))
            taken[f"bodies.{name}.material"] = f"for constants that are not given; {source}"
        if finish in solids.finishes():
            rough = solids.usual_roughness(finish)
            taken[f"bodies.{name}.finish"] = f"usual roughness of flanks so made, Ra {rough}"
    return taken


class Bodies(Table):
    """`[bodies]`: two solids, body 1 first."""

    @property
    def surfaces(self) -> dict[str, SurfaceTable]:
        """Surfaces that are given point by point, by the name of their body."""
        return {name: body.surface for name, body in self if body.surface is not None}

    def pair(self, oil: Oil) -> tuple[Body, Body]:
        """Body 1 and body 2 under an oil."""
        body_1, body_2 = (getattr(self, name).body(oil) for name in type(self).model_fields)
        return body_1, body_2


class ContactBodies(Bodies):
    """`[bodies]` of a contact written directly."""

    body_1: BodyTable
    body_2: BodyTable
