"""The size of things in a line contact before anything is solved: Hertz's strip, Moes' groups, a film."""

from dataclasses import dataclass

from pyworm.formulas.film import LineGroups, line_groups, moes_line
from pyworm.formulas.hertz import HertzLine, hertz_line
from pyworm.line.scene import LineScene
from pyworm.scales import require_proportion


@dataclass(frozen=True)
class LineScales:
    """The size of things in a line contact.

    Attributes
    ----------
    hertz : HertzLine
        The dry contact of the radius at the contact point.
    groups : LineGroups
        Dimensionless groups.
    film : float
        Film where the pressure is largest by Moes [m].
    """

    hertz: HertzLine
    groups: LineGroups
    film: float


def line_scales(scene: LineScene) -> LineScales:
    """Sizes of a line contact from its radius, load, oil and entrainment.

    Raises
    ------
    ValueError
        If there is no entrainment, load or viscosity, or they are out of all proportion.
    """
    viscosity = scene.oil.viscosity
    if not abs(scene.entrainment) > 0:
        raise ValueError(
            f"{scene.name}: the surfaces entrain no oil (mean velocity 0 m/s); "
            "give them velocities whose mean is not zero"
        )
    if not (scene.load > 0 and viscosity.eta0 > 0):
        raise ValueError(
            f"{scene.name}: a load of {scene.load:g} N/m on an oil of {viscosity.eta0:g} Pa s forms no film; "
            "both must be positive"
        )
    groups = line_groups(
        scene.radius,
        scene.load,
        scene.reduced_modulus,
        abs(scene.entrainment),
        viscosity.eta0,
        viscosity.alpha,
    )
    require_proportion(scene.name, groups)
    contact = hertz_line(scene.radius, scene.load, scene.reduced_modulus)
    return LineScales(contact, groups, float(moes_line(groups).central))
