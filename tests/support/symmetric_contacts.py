"""Contacts with every effect at once in turned and mirrored axes, other units, and with bodies exchanged."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import cos, pi

import pyworm
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.scene.life import Life, Past

AGE = 1e-3
"""Time that a contact in motion has had [s]; its entrainment reverses after 0.6 of it."""

ZERO_CELSIUS = 273.15


@dataclass(frozen=True)
class Units:
    """Factors of length, time and mass by which all data of a contact are multiplied."""

    length: float = 1.0
    time: float = 1.0
    mass: float = 1.0

    @property
    def velocity(self) -> float:
        """Factor of velocities."""
        return self.length / self.time

    @property
    def pressure(self) -> float:
        """Factor of pressures."""
        return self.mass / (self.length * self.time**2)

    @property
    def density(self) -> float:
        """Factor of densities."""
        return self.mass / self.length**3

    @property
    def conductivity(self) -> float:
        """Factor of conductivities."""
        return self.mass * self.length / self.time**3

    @property
    def specific_heat(self) -> float:
        """Factor of specific heats."""
        return self.velocity**2


@dataclass(frozen=True)
class View:
    """A way to look at the same contact."""

    axes: tuple[tuple[int, int], tuple[int, int]] = ((1, 0), (0, 1))
    """Rows of the matrix by which directions are turned or mirrored; a line contact takes its first entry."""
    exchanged: bool = False
    """Whether body 2 is called body 1."""
    units: Units = Units()
    """Units of length, time and mass."""

    def turned(self, u: float, v: float) -> tuple[float, float]:
        """Components of a direction in these axes."""
        (xx, xy), (yx, yy) = self.axes
        return xx * u + xy * v, yx * u + yy * v

    @property
    def handedness(self) -> int:
        """1 of turned axes, -1 of mirrored ones, in which spins and lays change their sign."""
        (xx, xy), (yx, yy) = self.axes
        return xx * yy - xy * yx


VIEWS = {
    "turned by 90 degrees": View(((0, -1), (1, 0))),
    "turned by 180 degrees": View(((-1, 0), (0, -1))),
    "mirrored along x": View(((-1, 0), (0, 1))),
    "mirrored along y": View(((1, 0), (0, -1))),
    "bodies exchanged": View(exchanged=True),
    "other units": View(units=Units(length=2.0, mass=2.0)),  # powers of two, which round nothing
}


def _oil(units: Units, layer: float | None) -> Oil:
    per_pressure = 1 / units.pressure
    return Oil(
        Barus(0.04 * units.pressure * units.time, 18e-9 * per_pressure),
        Density(870 * units.density, 0.6e-9 * per_pressure, 1.7e-9 * per_pressure),
        FlowLaw(
            "eyring-limited",
            stress=6e6 * units.pressure,
            stress_pressure=2e-10 * per_pressure,
            limit=1e7 * units.pressure,
            limit_pressure=0.06,
        ),
        OilHeat(
            inlet_temperature=60 + ZERO_CELSIUS,
            viscosity_exponent=0.03,
            conductivity=0.14 * units.conductivity,
            specific_heat=2000 * units.specific_heat,
            expansivity=6e-4,
        ),
        supply=None if layer is None else layer * units.length,
    )


def _bodies(view: View) -> tuple[pyworm.Body, pyworm.Body]:
    """Steel and bronze, rough with a lay and warmer than the oil."""
    units = view.units

    def body(modulus, density, conductivity, specific_heat, warmer, height, lay):
        return pyworm.Body(
            modulus * units.pressure,
            0.3,
            density * units.density,
            conductivity * units.conductivity,
            specific_heat * units.specific_heat,
            60 + warmer + ZERO_CELSIUS,
            height * units.length,
            roughness_slope=0.01,
            roughness_aspect=2.0,
            lay=view.handedness * lay,
        )

    bodies = body(2.06e11, 7850, 46, 460, 8, 2e-7, 0.4), body(1e11, 8800, 60, 380, 3, 1.5e-7, -0.9)
    return bodies[::-1] if view.exchanged else bodies


def _in_motion(contact: Callable[[float, float], pyworm.Scene], units: Units):
    """The present of a contact of factors of speed and load, whose load swings and entrainment reverses."""

    def at(share: float):
        return contact(cos(pi * min(share, 1.0) * 0.5 / 0.6), 1 + 0.3 * cos(3 * share))

    life = Life(AGE * units.time, lambda seconds: at(seconds / (AGE * units.time)))
    return replace(at(1.0), past=Past(life, AGE * units.time))


def ellipse(view: View, moves: bool, layer: float | None = None) -> pyworm.Scene:
    """An ellipse entrained obliquely, with sliding across it and spin; starved by a layer [m]."""
    units = view.units
    radii = (0.02, 0.012)[:: 1 if view.axes[0][0] else -1]

    def motion(u, v, spin):
        across, along = view.turned(u * units.velocity, v * units.velocity)
        return pyworm.RigidMotion(across, along, view.handedness * spin / units.time)

    def contact(speed: float, load: float) -> pyworm.Scene:
        motions = (
            motion(1.1 * speed, 0.5 * speed + 0.2, 30.0),
            motion(0.9 * speed, 0.6 * speed, 9.0),
        )
        return pyworm.Scene(
            name="ellipse",
            gap=pyworm.Paraboloid(*(radius * units.length for radius in radii)),
            load=30 * load * units.pressure * units.length**2,
            motions=motions[::-1] if view.exchanged else motions,
            bodies=_bodies(view),
            oil=_oil(units, layer),
        )

    return _in_motion(contact, units) if moves else contact(1.0, 1.0)


def line(view: View, moves: bool, layer: float | None = None) -> pyworm.LineScene:
    """A line contact with sliding; starved by a layer [m]."""
    units = view.units

    def contact(speed: float, load: float) -> pyworm.LineScene:
        velocities = tuple(
            view.axes[0][0] * of * units.velocity for of in (1.1 * speed + 0.05, 0.9 * speed)
        )
        return pyworm.LineScene(
            name="line",
            gap=pyworm.Parabola(0.02 * units.length),
            load=1e5 * load * units.pressure * units.length,
            velocities=velocities[::-1] if view.exchanged else velocities,
            bodies=_bodies(view),
            oil=_oil(units, layer),
        )

    return _in_motion(contact, units) if moves else contact(1.0, 1.0)


LENGTHS = "film_min", "film_central"


def seen(figures: dict[str, float], view: View, each_length: bool) -> dict[str, float]:
    """Figures of the contact as it is from those that a view shows."""
    units, seen = view.units, dict(figures)
    power = units.pressure * units.length**3 / units.time
    factors = dict.fromkeys(LENGTHS, units.length) | {
        "pressure_max": units.pressure,
        "power_loss": power / (units.length if each_length else 1.0),
    }
    for name, factor in factors.items():
        seen[name] /= factor
    if view.exchanged:
        names = "temperature_max_body_1", "temperature_max_body_2"
        first, second = (seen[name] for name in names)
        seen |= dict(zip(names, (second, first), strict=True))
    return seen
