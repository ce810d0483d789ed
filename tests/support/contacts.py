"""Contacts as a script makes them."""

import pyworm

INLET = 333.15
"""Temperature of the oil at the inlet [K]."""


def steel():
    """A smooth solid of steel."""
    return pyworm.Body.from_name("16MnCr5", bulk_temperature=INLET)


def motions(sliding=0.2, speed=1.0):
    """Both surfaces along x."""
    return tuple(
        pyworm.RigidMotion(speed * factor, 0.0) for factor in (1 + sliding / 2, 1 - sliding / 2)
    )


def ball(**changes):
    """A steel ball on a steel disc in oil."""
    given = {
        "name": "ball",
        "gap": pyworm.Paraboloid(0.01, 0.01),
        "load": 30.0,
        "motions": motions(),
        "bodies": (steel(), steel()),
        "oil": pyworm.named_oil("PAO VG 220").oil(INLET),
    }
    return pyworm.Scene(**given | changes)


def roller(**changes):
    """A steel roller on a steel disc in oil."""
    given = {
        "name": "roller",
        "gap": pyworm.Parabola(0.01),
        "load": 1e5,
        "velocities": (1.1, 0.9),
        "bodies": (steel(), steel()),
        "oil": pyworm.named_oil("PAO VG 220").oil(INLET),
    }
    return pyworm.LineScene(**given | changes)
