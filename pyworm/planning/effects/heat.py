"""Thermal effects: heating of the surfaces, of the film, and variation of viscosity across it."""

from dataclasses import replace
from math import asinh, exp, expm1, sqrt

import scipy

from pyworm.formulas.thermal_reduction import wilson_sheu
from pyworm.planning.effects.effect import EVERYTHING, Effect, Influence
from pyworm.planning.effects.rheology import unlike, unthinned
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact


def _unknown(scene: AnyContact) -> str | None:
    return "[oil.heat] is not given" if scene.oil.heat is None else None


def _cold(scene: AnyContact) -> AnyContact:
    return scene if scene.oil.heat is None else replace(scene, oil=replace(scene.oil, heat=None))


def _temperature(prediction: Prediction, rise: float) -> float:
    """A temperature rise relative to the reference of influences."""
    if rise == 0:
        return 0.0
    return rise / max(
        prediction.warmest, 1 / prediction.inlet_beta if prediction.inlet_beta > 0 else 0.0
    )


def _friction(prediction: Prediction, surfaces: bool, film: bool) -> float:
    """Relative change of the friction if surfaces or film stay cold."""
    hot = prediction.own_hot_stress
    return abs(prediction.hot_stress(surfaces, film) / hot - 1) if hot > 0 else 0.0


# ---------------------------------------------------------------------------------- surface heating

LOBE_WARMTH = 0.5
"""Change of the minimum film over that of the viscosity where it forms, inside the warm contact."""


def _surface_rise(prediction: Prediction) -> float:
    rise = prediction.rise_bodies
    if rise is None:
        rise = prediction.surface_rise(prediction.heat) + prediction.bulk
    return max(rise, prediction.bulk)


def _surface_warmth(prediction: Prediction) -> float:
    return prediction.inlet_beta * _surface_rise(prediction)


def _surfaces(prediction: Prediction) -> Influence:
    rise = _surface_rise(prediction)
    # bodies of another temperature than the inlet's warm or cool the oil that they bring
    film = max(LOBE_WARMTH * _surface_warmth(prediction), prediction.inlet_beta * prediction.bulk)
    friction = _friction(prediction, surfaces=False, film=True)
    return Influence(film, max(friction, film), _temperature(prediction, rise))


# ------------------------------------------------------------------------------------- film heating


def _inlet_loading(prediction: Prediction) -> float:
    """Thermal loading parameter of the inlet, eta0 beta u^2 / k [-]."""
    oil = prediction.oil
    return (
        oil.viscosity.eta0 * prediction.inlet_beta * prediction.speed**2 / oil.thermal.conductivity
    )


def _inlet_reduction(prediction: Prediction) -> float:
    """Relative reduction of the film by shear heating of the inlet (Wilson and Sheu 1983)."""
    slide_roll_ratio = min(prediction.sliding / prediction.speed, 2.0)  # beyond it nothing is known
    return 1 - float(wilson_sheu(_inlet_loading(prediction), slide_roll_ratio))


def _film_warmth(prediction: Prediction) -> float:
    return prediction.beta * prediction.film_rise(prediction.heat)


def _film(prediction: Prediction) -> Influence:
    film = _inlet_reduction(prediction)
    friction = _friction(prediction, surfaces=True, film=False)
    rise = prediction.film_rise(prediction.heat) + prediction.rolling_rise
    return Influence(film, max(friction, film), _temperature(prediction, rise))


def _by_heat(prediction: Prediction) -> Influence:
    """Influence shared by surface and film heating, which are simulated together."""
    if prediction.carried_by_heat:
        return EVERYTHING
    surfaces, film = _surfaces(prediction), _film(prediction)
    return Influence(
        surfaces.film + film.film,
        surfaces.friction + film.friction,
        surfaces.temperature + film.temperature,
    )


SURFACE_HEATING = Effect(
    name="surface-heating",
    symbol="beta dT of the surfaces",
    source="moving strip of heat (Jaeger 1942), the heat parting so that both are equally warm",
    indicator=_surface_warmth,
    influence=_by_heat,
    without=_cold,
    lacking=_unknown,
    together=("film-heating",),
    part_of="film-heating",
)

FILM_HEATING = Effect(
    name="film-heating",
    symbol="eta0 beta u^2 / k",
    source="film: Wilson and Sheu (1983); friction and temperature: q h / 8k",
    indicator=_inlet_loading,
    influence=_by_heat,
    without=_cold,
    lacking=_unknown,
    together=("surface-heating",),
    eased_by=("shear-thinning", "limiting-stress"),  # which bound the shear that hot oil takes
)


# -------------------------------------------------------------------------- viscosity across the film


MOST_WARMTH = 50.0
"""Warmth beyond which the error is taken as one."""


def _parabola_error(warmth: float) -> float:
    """Relative error of the friction with one viscosity across the film, that of its mean temperature.

    Exact for a film between walls of one temperature, of viscosity eta1 exp(-beta dT): with x^2 = e^w - 1,
    w = beta times the rise in the middle, friction is asinh(x)/(x sqrt(1 + x^2)) of the cold one's (Couette
    flow with heat); with uniform viscosity it is e^-m, where m e^m = 2 x^2/3.
    """
    if warmth <= 0:  # by rounding too, of an oil whose viscosity heat leaves alone
        return 0.0
    x = sqrt(expm1(min(warmth, MOST_WARMTH)))
    exact = asinh(x) / (x * sqrt(1 + x**2))
    return abs(exp(-float(scipy.special.lambertw(2 * x**2 / 3).real)) / exact - 1)


PARABOLA_FILM, PARABOLA_THINNED, PARABOLA_ROLLING = 1e-3, 0.1, 0.03
"""Errors of a film by the resolution of three levels: in any flow, relative to the change by shear thinning,
and relative to the warmth by rolling (`benchmarks/accuracy/plans.py`)."""

SHIFT_FACTOR = 4.0
"""Change of the minimum film over that of the mean velocity inside the contact, by the same benchmark."""


def _across(prediction: Prediction) -> Influence:
    if prediction.carried_by_heat:
        return EVERYTHING
    warmth = _film_warmth(prediction)
    friction = _parabola_error(warmth)
    slip = prediction.sliding / prediction.speed
    # unequal viscosities at the walls shift the mean velocity of the oil by (u1 - u2)/12 a unit of ln eta; at
    # the contact's sides the film feels more of it
    shift = SHIFT_FACTOR * slip * prediction.wall_warmth / 12
    flow = prediction.oil.flow
    thinned = (
        unlike(prediction, unthinned(flow)).film if flow is not None and flow.stress > 0 else 0.0
    )
    film = (
        PARABOLA_FILM
        + PARABOLA_THINNED * thinned
        + PARABOLA_ROLLING * prediction.rolling_warmth
        + shift
    )
    return Influence(film, max(friction, film), 2 * max(friction, film) * prediction.warmth)


VISCOSITY_ACROSS = Effect(
    name="viscosity-across",
    symbol="beta q h / 8k",
    source="Couette flow with heat, exact, against one viscosity across the film",
    indicator=_film_warmth,
    influence=_across,
    without=lambda scene: scene,
    lacking=_unknown,
    together=("film-heating", "surface-heating"),
    part_of="film-heating",
)
