"""FZG test gears of type C, and the specific film at which an oil fails the micropitting test with them."""

from math import acos, cos, pi, sin, sqrt, tan

import numpy as np

from pyworm.formulas.micropitting import Flanks, GearOil, bulk_rise, micropitting_films
from pyworm.formulas.ranges import positive
from pyworm.formulas.scuffing import effusivity

TEST_TORQUE = {5: 69.98, 6: 98.82, 7: 132.455, 8: 171.585, 9: 215.513, 10: 265.0}
"""Torque of the test gears' pinion [N m] at the load stages of the micropitting test FVA 54/7, that of FZG
rigs with a lever of 0.35 m (as in github.com/cfernandesFEUP/GEARpie)."""

TEST_TEMPERATURE = 363.15
"""Oil of the micropitting test unless it is that of 60 degC [K]."""

_TEST_SPEED = 2250 * pi / 30
_TEST_ROUGHNESS = 0.5e-6
_STEEL = 206e9, 0.3
_STEEL_HEAT = 46.0, 7830.0, 465.0
"""Conductivity, density and specific heat of the test gears' steel."""


def fzg_test_gears(torque: float) -> tuple[Flanks, float]:
    """The FZG test gears of type C at 2250 1/min and a torque of the pinion [N m], and their loss factor H_v.

    16 and 24 teeth of 4.5 mm, 91.5 mm apart, tips of 82.5 and 118.4 mm, 14 mm wide, profiles not modified:
    where two pairs share the load, one takes a third to two thirds. Source: ISO 14635-1, FVA 54/7.
    """
    positive("torque", torque, "N m")
    teeth, module, apart, width = (16, 24), 4.5e-3, 91.5e-3, 14e-3
    base = [z * module / 2 * cos(np.radians(20)) for z in teeth]
    tips = [82.5e-3 / 2, 118.4e-3 / 2]
    working = acos(sum(base) / apart)
    whole, pitch = apart * sin(working), 2 * pi * base[0] / teeth[0]
    start, end = whole - sqrt(tips[1] ** 2 - base[1] ** 2), sqrt(tips[0] ** 2 - base[0] ** 2)
    pinion = np.linspace(start, end, 401)
    along, path = pinion - start, end - start
    shared = path - pitch  # length over which two pairs are in contact
    share = np.clip((1 + along / shared) / 3, 0, 2 / 3)
    share = np.minimum(share, (1 + along[::-1] / shared) / 3)
    share[(along > shared) & (along < pitch)] = 1.0
    gear = whole - pinion
    speeds = _TEST_SPEED * pinion, _TEST_SPEED * teeth[0] / teeth[1] * gear
    modulus = _STEEL[0] / (1 - _STEEL[1] ** 2)
    flanks = Flanks(
        pinion * gear / whole,
        torque / base[0] / width * share,
        *speeds,
        modulus,
        (float(effusivity(*_STEEL_HEAT)),) * 2,
        _TEST_ROUGHNESS,
    )
    # approach and recess over the base pitch, from the pitch point
    approach, recess = (
        (base[0] * tan(working) - start) / pitch,
        (end - base[0] * tan(working)) / pitch,
    )
    ratio = teeth[1] / teeth[0]
    sliding = 1 - approach - recess + approach**2 + recess**2
    return flanks, pi * (ratio + 1) / (teeth[0] * ratio) * sliding


def film_at_load_stage(
    stage: int, oil: GearOil, oil_temperature: float = TEST_TEMPERATURE
) -> float:
    """lambda_GFT [-]: minimum specific film of the test gears at the load stage that an oil fails at.

    Failure load stages of the micropitting test FVA 54/7 are 5 to 10; the temperature [K] is that of the
    test.
    """
    if stage not in TEST_TORQUE:
        raise ValueError(f"load stage {stage} of the micropitting test: must be one of 5 to 10")
    torque = TEST_TORQUE[stage]
    flanks, loss_factor = fzg_test_gears(torque)
    # bulk temperature and friction: that of friction does not depend on it
    friction = micropitting_films(flanks, oil, oil_temperature, oil_temperature).friction
    rise = bulk_rise(torque * _TEST_SPEED, friction, loss_factor, 91.5e-3, 14e-3)
    films = micropitting_films(flanks, oil, oil_temperature, oil_temperature + rise)
    return float(films.specific_film.min())
