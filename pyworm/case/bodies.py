"""`[bodies]`: the solids of a contact."""

from typing import Annotated

from pydantic import Field

from pyworm.case.table import Table
from pyworm.io import units
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


class BodyTable(Table):
    """`[bodies.NAME]`: one solid; the thermal constants are needed where the oil has `[oil.heat]`.

    Without a bulk temperature of its own a body is as warm as the oil at the inlet. The roughness is the root
    mean square height Rq, not Ra, which is about 0.8 Rq.
    """

    youngs_modulus: units.Modulus
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]
    density: units.MassDensity | None = None
    conductivity: units.Conductivity | None = None
    specific_heat: units.SpecificHeat | None = None
    bulk_temperature: units.Temperature | None = None
    roughness: units.Roughness | None = None

    def body(self, oil: Oil) -> Body:
        """The solid under an oil."""
        constants = dict(self)
        if oil.heat is not None and self.bulk_temperature is None:
            constants["bulk_temperature"] = oil.heat.inlet_temperature
        return Body(**constants)


class Bodies(Table):
    """`[bodies]`: two solids, body 1 first."""

    def pair(self, oil: Oil) -> tuple[Body, Body]:
        """Body 1 and body 2 under an oil."""
        body_1, body_2 = (getattr(self, name).body(oil) for name in type(self).model_fields)
        return body_1, body_2


class ContactBodies(Bodies):
    """`[bodies]` of a contact written directly."""

    body_1: BodyTable
    body_2: BodyTable
