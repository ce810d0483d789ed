"""Factors between SI and the units of practice."""

from math import pi

ZERO_CELSIUS = 273.15
"""Temperature [K] of 0 degC."""

DEGREES_40, DEGREES_100 = 313.15, 373.15
"""Temperatures [K] at which an oil is described by two viscosities."""

SQUARE_MILLIMETRE = 1e-6
"""1 mm2 [m2]: a kinematic viscosity of 1 mm2/s [m2/s]."""

SQUARE_METRE = 1e6
"""1 m2 [mm2]: a kinematic viscosity of 1 m2/s [mm2/s]."""

VICKERS = 9.80665e6
"""Hardness of 1 HV [Pa]: a kilogram-force for each square millimetre."""

RPM = 30 / pi
"""1 rad/s [rpm]."""
