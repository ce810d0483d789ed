"""A mesh cycle of made-up solutions whose load, friction and sliding are known at every phase."""

from dataclasses import replace
from functools import cache

import numpy as np
import xarray as xr
from synthetic_solution import make_mesh_cycle, make_result, make_worm_solution, with_heat

from pyworm.solver.solution import Estimate

PHASES = np.linspace(0.05, 0.95, 13)
LOAD_PHASES = np.linspace(-0.1, 1.1, 241)
PITCH, LEVER, SLIDING_LEVER, SLIDING = 0.5, 0.24, -0.09, 6.0
WORM_SPEED, WHEEL_SPEED = 157.0, 8.0


def tooth_load(phase):
    """Load of the tooth at a phase [N]."""
    return 15e3 * np.maximum(np.sin(np.pi * np.clip(phase, 0, 1)), 0.0)


def friction(phase):
    """Friction coefficient at a phase."""
    return 0.01 * (1.3 - phase * (1 - phase))


@cache
def contact():
    """What is the same at all phases."""
    return with_heat(make_worm_solution(0.5, edge=np.inf, points=(97, 65)))


def cycle_solution(phase, **changes):
    """A contact that moves along the face and down the flank as the cycle goes on."""
    one = replace(contact(), phase=float(phase))
    x, y = np.linspace(-0.03, 0.03, 5), np.linspace(-0.02, 0.02, 5)
    place = xr.Dataset(
        {
            "tooth_face": (("tooth_y", "tooth_x"), x + 0 * y[:, None] + 0.02 * (phase - 0.5)),
            "tooth_radius": (
                ("tooth_y", "tooth_x"),
                0.27 + y[:, None] + 0 * x - 0.015 * (phase - 0.5),
            ),
        },
        coords={"tooth_x": x, "tooth_y": y},
    )
    force = float(tooth_load(phase))
    figures = replace(
        one.figures, power_loss=Estimate(float(friction(phase)) * force * SLIDING, 0.004, 0.001)
    )
    return replace(one, load=force, figures=figures, fields=one.fields.merge(place), **changes)


def cycle_result(phases, driver="worm", roughness=0.5e-6, **changes):
    """A result with a solution at each phase and the loads of all teeth over the cycle."""
    turn = -1 if driver == "wheel" else 1
    loaded = xr.Dataset(
        {
            "tooth_load": ("load_phase", tooth_load(LOAD_PHASES)),
            "wheel_turn": ("load_phase", 1e-4 + 0 * LOAD_PHASES),
            "sliding_speed": ("load_phase", SLIDING + 0 * LOAD_PHASES),
            "lever": ("load_phase", LEVER + 0 * LOAD_PHASES),
            "sliding_lever": ("load_phase", turn * SLIDING_LEVER + 0 * LOAD_PHASES),
            "rim_face": ("rim", np.array([-0.03, 0.03, 0.03, -0.03, -0.03])),
            "rim_radius": ("rim", np.array([0.25, 0.25, 0.28, 0.28, 0.25])),
        },
        coords={"load_phase": LOAD_PHASES},
        attrs={
            "pitch": PITCH,
            "worm_speed": WORM_SPEED,
            "wheel_speed": WHEEL_SPEED,
            "driver": driver,
            "friction_assumed": 0.01,
            "sump_temperature": 333.15,
            "worm_temperature": 350.0,
            "wheel_temperature": 335.0,
        },
    )
    cycle = make_mesh_cycle().merge(loaded, combine_attrs="no_conflicts")
    return replace(
        make_result(),
        solutions=tuple(
            cycle_solution(phase, composite_roughness=roughness, **changes) for phase in phases
        ),
        mesh_cycle=cycle,
    )
