"""Layers of oil that a bath or jets leave on the flanks of teeth, by closed forms."""

from math import sqrt

from pyworm.formulas.ranges import positive, within

GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s2]."""

SURFACE_TENSION = 0.03
"""Surface tension of lubricating oils [N/m]: 0.028 to 0.036, of which a layer takes the sixth root."""

MAX_LAYER_RATIO = 1.0
"""Largest layer over sqrt(eta U / (rho g)) [-]: at high speed gravity alone holds the oil back."""


def dragged_layer(viscosity: float, density: float, speed: float) -> float:
    """Thickness of the layer on a surface that is drawn upwards out of a bath [m]; arguments in SI units.

    h = 0.944 Ca^(1/6) sqrt(eta U / (rho g)), Ca = eta U / sigma, of slow surfaces (Landau and Levich 1942);
    fast ones, beyond Ca of about 1, carry at most sqrt(eta U / (rho g)) (Deryagin 1943).
    """
    positive("viscosity", viscosity, "Pa s")
    within("density", density, 100, 5000, "kg/m3")
    positive("speed", speed, "m/s")
    capillary_number = viscosity * speed / SURFACE_TENSION
    part = min(0.944 * capillary_number ** (1 / 6), MAX_LAYER_RATIO)
    return float(part * sqrt(viscosity * speed / (density * GRAVITY)))


def drained_layer(
    first: float, viscosity: float, density: float, acceleration: float, height: float, time: float
) -> float:
    """Thickness [m] of a layer that begins with `first` [m], after it drained for a time [s] along a flank.

    On a vertical plate the layer of thickness h_0 thins to h^2 = eta y / (rho g t) down to where that is h_0
    (Jeffreys 1930). Here under any acceleration a along the flank, with both joined: 1/h^2 = 1/h_0^2 + rho a
    t / (eta y), at most sqrt(2) too thin, where they meet; y (`height`) counts from where the oil begins to
    flow.
    """
    positive("first", first, "m")
    positive("viscosity", viscosity, "Pa s")
    positive("height", height, "m")
    loss = density * acceleration * time / (viscosity * height)
    return first / sqrt(1 + loss * first**2)


def sprayed_layer(flow: float, flank: float, rate: float) -> float:
    """Thickness on each flank where all the oil of jets spreads evenly over the teeth that pass [m].

    h = q / (4 A f) of a flow q [m3/s], flanks of an area A [m2] and f pairs of teeth that pass [1/s]: each
    has two flanks on either body.
    """
    positive("flow", flow, "m3/s")
    positive("flank", flank, "m2")
    positive("rate", rate, "1/s")
    return flow / (4 * flank * rate)
