"""Films of point contacts by the formula of the atlas (`formulas.film_atlas`), a microsecond each."""

from dataclasses import dataclass, replace

import numpy as np

from pyworm.formulas.film_atlas import (
    AtlasGroups,
    films,
    hertz_pressure,
    longer_semi_axis,
    reciprocal_alpha,
    regimes,
)
from pyworm.formulas.film_reduction import reduction
from pyworm.formulas.hertz import hertz
from pyworm.formulas.ranges import Values, positive
from pyworm.materials.oil import Oil
from pyworm.scene.formula_heat import heat_groups, lacks_heat
from pyworm.scene.point import Scene

LEAST_L = 1e-3
"""Moes' L of oils whose viscosity does not rise with pressure: far below where that thickens a film."""

SPIN_STEP = 0.1
"""Distance over which the spin of a scene's velocities is read, over Hertz's smaller semi-axis."""


@dataclass(frozen=True)
class FormulaFilms:
    """Isothermal films of smooth point contacts with enough oil, by the formula of the atlas.

    Attributes
    ----------
    central, minimum : array
        Film at the contact point and least film [m].
    central_error, minimum_error : array
        Relative errors that 19 of 20 contacts kept which the fit had not seen [-]; infinite outside the box
        of the atlas.
    inside : array of bool
        Whether the contact is in that box.
    groups : AtlasGroups
        Its similarity groups.
    holds : tuple of str
        Effects of `pyworm.planning.effects` that the films hold besides (`film_of`).
    """

    central: np.ndarray
    minimum: np.ndarray
    central_error: np.ndarray
    minimum_error: np.ndarray
    inside: np.ndarray
    groups: AtlasGroups
    holds: tuple[str, ...] = ()

    @property
    def regime(self) -> np.ndarray:
        """Names of the regimes of lubrication, `pyworm.formulas.regimes`."""
        return regimes(self.groups)

    def specific(self, roughness: Values) -> np.ndarray:
        """Central film over the composite roughness [m]: lambda [-]."""
        positive("composite roughness", roughness, "m")
        return self.central / roughness


def film(
    radii: tuple[Values, Values],
    load: Values,
    reduced_modulus: Values,
    velocity: tuple[Values, Values],
    oil: Oil,
    spin: Values = 0.0,
) -> FormulaFilms:
    """Films of point contacts by the formula of the atlas; numbers or arrays that broadcast together.

    Isothermal, smooth, with enough oil, whatever the oil's flow law: heat, shear thinning, roughness and a
    short supply are left out. A contact outside the box of the atlas has infinite errors.

    Parameters
    ----------
    radii : tuple of float or array
        Relative radii of curvature along x and y [m].
    load : float or array
        Normal load [N].
    reduced_modulus : float or array
        E' [Pa] with 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
    velocity : tuple of float or array
        Mean velocity of both surfaces along x and y at the contact point [m/s].
    oil : Oil
        The oil at its inlet temperature.
    spin : float or array, optional
        Mean angular velocity of both surfaces about the common normal, positive from x to y [rad/s].

    Returns
    -------
    FormulaFilms
        Films with left-out errors.

    Raises
    ------
    ValueError
        Radii, loads or moduli that are not positive, or no entrainment.
    """
    groups, unit = _groups(radii, load, reduced_modulus, velocity, oil, spin)
    found = films(groups)
    central_error, minimum_error = (
        np.where(found.inside, of, np.inf) for of in (found.central_error, found.minimum_error)
    )
    return FormulaFilms(
        unit * found.central,
        unit * found.minimum,
        central_error,
        minimum_error,
        found.inside,
        groups,
    )


def _groups(
    radii: tuple[Values, Values],
    load: Values,
    reduced_modulus: Values,
    velocity: tuple[Values, Values],
    oil: Oil,
    spin: Values,
) -> tuple[AtlasGroups, np.ndarray]:
    """The groups of contacts, and Moes' unit of their films [m]; arguments as of `film`."""
    rx, ry, load, modulus, u, v, spin = (
        np.asarray(of, dtype=float) for of in (*radii, load, reduced_modulus, *velocity, spin)
    )
    speed = np.hypot(u, v)
    for name, value, unit in (
        ("radius along x", rx, "m"),
        ("radius along y", ry, "m"),
        ("load", load, "N"),
        ("reduced modulus", modulus, "Pa"),
        ("entrainment speed", speed, "m/s"),
    ):
        positive(name, value, unit)
    swapped = rx > ry
    short, long = np.minimum(rx, ry), np.maximum(rx, ry)
    cos2 = np.minimum((np.where(swapped, v, u) / speed) ** 2, 1.0)
    along = 1 / (cos2 / short + (1 - cos2) / long)
    twice = 2 * oil.viscosity.eta0 * speed / (modulus * along)
    semi_axis = longer_semi_axis(long / short) * np.cbrt(load * short / modulus)
    peak = hertz_pressure(long / short) * np.cbrt(load * (modulus / short) ** 2)
    # mirrors turn a spin about: that which exchanges the axes, and one for each part of the velocity
    turned = np.where((u < 0) ^ (v < 0) ^ swapped, -1.0, 1.0)
    alpha = oil.viscosity.alpha
    groups = AtlasGroups(
        moes_m=load / (modulus * along**2) * twice**-0.75,
        moes_l=np.maximum(alpha * modulus * twice**0.25, LEAST_L),
        ratio=long / short,
        angle=np.arccos(np.sqrt(cos2)),
        spin=turned * spin * semi_axis / speed,
        alpha_ratio=reciprocal_alpha(oil.viscosity, alpha),
        compression=oil.density(peak) / oil.density(np.zeros(())) - 1,
    )
    return groups, along * np.sqrt(twice)


HEAT_AND_FLOW = (
    "film-heating",
    "surface-heating",
    "viscosity-across",
    "shear-thinning",
    "limiting-stress",
)
"""Effects of the thermal contacts of the atlas."""


def film_of(scene: Scene, reduced: bool = False) -> FormulaFilms:
    """The films of a scene by `film`: its radii, load and velocities at the contact point, its oil.

    Parameters
    ----------
    scene : Scene
        The contact.
    reduced : bool, optional
        Whether by heat and shear thinning too, where oil and bodies have the data and the contact is in the
        box of the thermal contacts; `holds` tells whether they are.

    Raises
    ------
    ValueError
        No entrainment at the contact point, such as under pure spin.
    """
    axes = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    step = SPIN_STEP * min(axes.semi_axis_x, axes.semi_axis_y)
    places = (
        step * np.array([0.0, 1.0, -1.0, 0.0, 0.0]),
        step * np.array([0.0, 0.0, 0.0, 1.0, -1.0]),
    )
    u, v = (np.broadcast_to(of, 5) for of in scene.entrainment(*places))
    spin = ((v[1] - v[2]) - (u[3] - u[4])) / (4 * step)
    cold = film(scene.radii, scene.load, scene.reduced_modulus, (u[0], v[0]), scene.oil, spin)
    return cold if not reduced or lacks_heat(scene) else _reduced(scene, cold)


def _reduced(scene: Scene, cold: FormulaFilms) -> FormulaFilms:
    """Films with heat and shear thinning; those without outside the box of the thermal contacts."""
    heat = heat_groups(scene, cold.central)
    by = reduction(cold.groups, films(cold.groups).central, heat)
    if not (by.inside and cold.inside):
        return cold
    return replace(
        cold,
        central=cold.central * by.central,
        minimum=cold.minimum * by.minimum,
        central_error=cold.central_error + by.central_error,
        minimum_error=cold.minimum_error + by.minimum_error,
        holds=HEAT_AND_FLOW,
    )
