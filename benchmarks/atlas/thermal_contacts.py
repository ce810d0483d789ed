"""The thermal contacts of the atlas: isothermal ones with sliding, heat and an oil that shears thin.

To each contact of `contacts.sequence` come similarity groups of heat, drawn likewise: the film over that
without heat depends on them. A thermal contact has the number of the isothermal one, so that the factor by
which heat and shear thinning change a film follows from two rows.
"""

from dataclasses import dataclass, replace
from functools import cache
from math import log

from atlas.contacts import DRAWN, Groups, contact, logarithmic, order, sequence
from scipy.stats import qmc

from pyworm.formulas.hertz import hertz
from pyworm.formulas.oil_properties import ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.thermal_properties import OilHeat
from pyworm.scene.point import Scene
from pyworm.scene.slide_roll import with_slide_roll_ratio

SEED = 128
"""Of the scrambling."""

SLIDING = (0.0, 4.0)
"""Slide-roll ratio, evenly; above 2 the surfaces move in opposite directions."""

LOADING = (0.01, 30.0)
"""Thermal loading eta0 beta u^2/k, evenly in the logarithm."""

MOST_LOADING = 6.0
"""Loading up to which contacts are solved: beyond it one in five had no film within 10 %."""

CONDUCTIVITY_RATIO = (0.002, 0.2)
"""Conductivity of the oil over that of the bodies, in the logarithm: from steel to glass."""

EYRING, LIMITING = (0.002, 0.03), (0.03, 0.12)
"""Eyring stress over the Hertz pressure, in the logarithm, and the limiting stress over pressure."""

RATIO, LEAST_M, MOES_L, PRESSURE, THICKNESS = 30.0, 5.0, (0.5, 15.0), 15.0, (0.015, 0.25)
"""Of the isothermal contact: largest ratio of radii, least M, L, largest alpha p_H, film over Hertz approach.
Thinner films need more nodes than a set of some thousand seconds can have, thicker ones depend on surfaces
far out, and under larger pressures the limiting stress of the oil bears no pressure spike."""

INLET, CONDUCTIVITY, SPECIFIC_HEAT, BETA = 333.15, 0.14, 2000.0, 0.04
"""Inlet temperature [K], conductivity [W/(m K)], specific heat [J/(kg K)] and fall of viscosity [1/K] of the
oil: realisations of the groups."""

BODY_HEAT = 3.6e6
"""Heat capacity of the bodies for each volume, as of steel [J/(m3 K)]."""


@dataclass(frozen=True)
class Heat:
    """Similarity groups of heat and flow."""

    sliding: float
    """Slide-roll ratio [-]."""
    loading: float
    """eta0 beta u^2/k [-]."""
    conductivity_ratio: float
    """Conductivity of the oil over that of the bodies [-]."""
    eyring: float
    """Eyring stress over the Hertz pressure [-]."""
    limiting: float
    """Limiting stress over pressure [-]."""


def thermal_order() -> list[int]:
    """Numbers of thermal contacts in the order in which they are solved, `contacts.order` in their box."""
    found = (number for number in order() if _inside(sequence()[number]))
    return [number for number in found if heats()[number].loading <= MOST_LOADING]


def _inside(of: Groups) -> bool:
    return (
        of.ratio <= RATIO
        and of.moes_m >= LEAST_M
        and MOES_L[0] <= of.moes_l <= MOES_L[1]
        and of.pressure <= PRESSURE
        and THICKNESS[0] <= of.thickness <= THICKNESS[1]
    )


@cache
def heats() -> dict[int, Heat]:
    """Groups of heat by the numbers of the contacts."""
    rows = qmc.Sobol(5, seed=SEED).random(2 * DRAWN).tolist()
    return {number: _heat(*rows[number]) for number in sequence()}


def _heat(sliding, loading, conductivity, eyring, limiting) -> Heat:
    return Heat(
        SLIDING[0] + (SLIDING[1] - SLIDING[0]) * sliding,
        logarithmic(LOADING, loading),
        logarithmic(CONDUCTIVITY_RATIO, conductivity),
        logarithmic(EYRING, eyring),
        LIMITING[0] + (LIMITING[1] - LIMITING[0]) * limiting,
    )


def thermal_contact(number: int) -> Scene:
    """A contact of the atlas that slides and warms.

    Its size follows from the thermal loading: at given groups of the film the speed goes with the size, so
    that all lengths are those of the isothermal contact times a factor.
    """
    of, heat, cold = sequence()[number], heats()[number], contact(number)
    speed = (heat.loading * CONDUCTIVITY / (of.viscosity * BETA)) ** 0.5
    size = speed / _speed(of)
    motion = cold.motions[0]
    fast = replace(motion, u=size * motion.u, v=size * motion.v)  # a spin goes with speed over size
    radii = tuple(size * radius for radius in cold.radii)
    load = cold.load * size**2
    peak = hertz(*radii, load, of.reduced_modulus).pressure_max
    body = replace(
        cold.bodies[0],
        density=7800.0,
        specific_heat=BODY_HEAT / 7800.0,
        conductivity=CONDUCTIVITY / heat.conductivity_ratio,
    )
    span = INLET - ROELANDS_POLE_TEMPERATURE
    exponent = BETA if of.barus else BETA * span / (log(of.viscosity) + ROELANDS_POLE_LOG)
    oil = replace(
        cold.oil,
        flow=FlowLaw(
            "eyring-limited",
            stress=heat.eyring * peak,
            limit=heat.eyring * peak,
            limit_pressure=heat.limiting,
        ),
        heat=OilHeat(INLET, exponent, CONDUCTIVITY, SPECIFIC_HEAT),
    )
    rolling = replace(
        cold,
        gap=type(cold.gap)(*radii),
        radii=radii,
        motions=(fast, fast),
        load=load,
        bodies=(body, body),
        oil=oil,
    )
    return replace(with_slide_roll_ratio(rolling, heat.sliding), name=cold.name)


def _speed(of: Groups) -> float:
    """Entrainment speed of the isothermal realisation [m/s]."""
    return of.speed * of.reduced_modulus * of.along / of.viscosity
