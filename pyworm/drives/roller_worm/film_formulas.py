"""Films at a roller's contact line by closed forms: regimes, the source's own formulas, heat, roughness."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.roller_worm.envelope import Array
from pyworm.drives.roller_worm.motion import LineMotion
from pyworm.formulas.film import dowson_higginson, line_groups, moes_line
from pyworm.formulas.film_atlas import reciprocal_alpha
from pyworm.formulas.regime_charts import line_films, line_parameters
from pyworm.formulas.regimes import REGIMES, line_measures, regime_number
from pyworm.formulas.roller_enveloping import printed_films, printed_minimum, printed_parameters
from pyworm.formulas.thermal_reduction import thermal_loading, wilson_sheu
from pyworm.formulas.wear_distress import specific_film
from pyworm.io.present import present
from pyworm.materials.body import Body, composite_roughness, reduced_modulus
from pyworm.materials.oil import Oil


@dataclass(frozen=True)
class ClosedFilms:
    """Films of points of contact lines, by formulas."""

    g_v: Array
    """Johnson's viscosity parameter [-]."""
    g_e: Array
    """Johnson's elasticity parameter [-]."""
    printed_g_v: Array
    """Viscosity parameter as printed in the source, without square root."""
    printed_g_e: Array
    """Elasticity parameter as printed in the source, without square root."""
    regime: Array
    """Number of the regime in `pyworm.formulas.regimes.REGIMES`; NaN where there is no load."""
    by_regime: Array
    """Minimum films of the four by Johnson and Hooke, (4, ...) [m]."""
    minimum: Array
    """Dowson and Higginson's minimum film [m]."""
    central: Array
    """Moes' central film [m]."""
    printed_minimum: Array
    """The source's minimum film [m]."""
    printed: Array
    """The source's four films as printed, (4, ...), in the order of `REGIMES`."""
    heated_share: Array
    """Wilson and Sheu's film over the isothermal one; NaN without thermal properties of the oil."""
    specific_film: Array
    """Dowson and Higginson's film, heated if known, over the composite roughness [-]; NaN without."""


def closed_films(
    curvature: Array, load: Array, motion: LineMotion, bodies: tuple[Body, Body], oil: Oil
) -> ClosedFilms:
    """Films at contacts by induced curvature [1/m] and load for each length [N/m]; NaN without load."""
    modulus, viscosity = reduced_modulus(*bodies), oil.viscosity
    load = np.where(load > 0, load, np.nan)
    contact = 1 / curvature, load, modulus, np.abs(motion.entrainment), viscosity.eta0
    groups = line_groups(*contact, viscosity.alpha)
    g_v, g_e = line_parameters(groups.moes_m, groups.moes_l)
    number = regime_number(*line_measures(groups, reciprocal_alpha(viscosity, viscosity.alpha)))
    limits = line_films(g_v, g_e)
    unit = groups.radius * groups.speed / groups.load
    minimum = np.asarray(dowson_higginson(groups).minima)
    printed = printed_films(*contact, viscosity.alpha)
    printed_g_v, printed_g_e = printed_parameters(*contact, viscosity.alpha)
    heated = _heated_share(oil, motion)
    warm = np.where(np.isfinite(heated), heated, 1.0)
    return ClosedFilms(
        g_v=np.asarray(g_v),
        g_e=np.asarray(g_e),
        printed_g_v=np.asarray(printed_g_v),
        printed_g_e=np.asarray(printed_g_e),
        regime=np.where(np.isnan(load), np.nan, number),
        by_regime=np.stack([unit * limits[name] for name in REGIMES]),
        minimum=minimum,
        central=np.asarray(present(moes_line(groups).central, "central")),
        printed_minimum=np.asarray(printed_minimum(*contact, viscosity.alpha)),
        printed=np.stack(
            [
                printed.rigid_isoviscous,
                printed.rigid_piezoviscous,
                printed.elastic_isoviscous,
                printed.elastic_piezoviscous,
            ]
        ),
        heated_share=heated,
        specific_film=_specific_film(minimum * warm, bodies),
    )


def _specific_film(film: Array, bodies: tuple[Body, Body]) -> Array:
    roughness = composite_roughness(*bodies)
    return (
        np.full(film.shape, np.nan)
        if roughness is None
        else np.asarray(specific_film(film, roughness))
    )


def _heated_share(oil: Oil, motion: LineMotion) -> Array:
    """Wilson and Sheu's reduction of the film; that of simple sliding for opposite surface velocities."""
    first, second = motion.worm[0], motion.roller[0]
    if oil.heat is None:
        return np.full(first.shape, np.nan)
    beta = oil.beta
    speed = np.abs(first + second) / 2
    loading = thermal_loading(oil.viscosity.eta0, beta, speed, oil.heat.conductivity)
    sliding = np.abs(first - second)
    ratio = np.divide(sliding, speed, out=np.full_like(speed, 2.0), where=sliding < 2 * speed)
    return np.asarray(wilson_sheu(loading, ratio))
