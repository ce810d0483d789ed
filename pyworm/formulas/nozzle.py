"""Discharge of a jet of thick oil: Bernoulli's flow through a hole with viscous resistance."""

from math import pi, sqrt

import scipy

from pyworm.formulas.ranges import positive, within

TURBULENT_DISCHARGE = 0.7
"""Discharge coefficient of a drilled hole at large Reynolds numbers [-]."""

ENTRY_RESISTANCE = 12 * pi
"""Pressure over (rho/2) nu v/d that creeping flow into a hole of diameter d takes [-] (Sampson 1891)."""

PIPE_RESISTANCE = 64.0
"""That of laminar flow through a length d of a pipe [-] (Hagen and Poiseuille)."""

LENGTHS = 0.0, 20.0
"""Lengths of holes over their diameters that are jets [-]."""


def discharge_coefficient(reynolds: float, length: float) -> float:
    """Discharge coefficient C of a hole [-], at Re = d sqrt(2 p/rho)/nu and a length over its diameter.

    Pressures add: C^2/C_t^2 + (12 pi + 64 l/d) C/Re = 1 with C_t = `TURBULENT_DISCHARGE`. Both limits are
    exact, and the sum of the viscous parts within 1 % (Dagan, Weinbaum and Pfeffer 1982).
    """
    positive("Reynolds number", reynolds, "")
    within("length of the hole over its diameter", length, *LENGTHS, "")
    drag = (ENTRY_RESISTANCE + PIPE_RESISTANCE * length) / reynolds
    squared = TURBULENT_DISCHARGE**-2
    # the positive root, in the form without cancellation
    return 2 / (drag + sqrt(drag**2 + 4 * squared))


def jet_discharge(
    flow: float, pressure: float, density: float, viscosity: float, number: int, length: float
) -> float:
    """Discharge coefficient of jets just large enough for a flow of all of them [m3/s], at a pressure [Pa].

    `viscosity` is the kinematic one [m2/s] at the temperature of the feed, `length` over the diameter.
    """
    positive("oil flow", flow, "m3/s")
    positive("feed pressure", pressure, "Pa")
    positive("kinematic viscosity", viscosity, "m2/s")
    ideal = sqrt(2 * pressure / density)

    def coefficient(diameter: float) -> float:
        return discharge_coefficient(diameter * ideal / viscosity, length)

    def surplus(diameter: float) -> float:
        return number * pi / 4 * diameter**2 * coefficient(diameter) * ideal - flow

    return coefficient(float(scipy.optimize.brentq(surplus, 1e-7, 10.0, xtol=1e-12)))
