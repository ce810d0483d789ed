"""From a scene and its plan to a solution: up the grids until the figures are as accurate as asked."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from time import perf_counter, process_time

import numpy as np
import xarray as xr

from pyworm import reading
from pyworm.accuracy import (
    FIGURES,
    JUDGED,
    WIDER_SHARE,
    Reading,
    domain_errors,
    grid_errors,
)
from pyworm.climb import Rung, Settled, Stride, dry_contact, first_rung, next_rung, settle
from pyworm.effects import Plan
from pyworm.grid import Grid
from pyworm.kernels import DryContact
from pyworm.scales import Scales, scales
from pyworm.scene import Scene
from pyworm.solution import Cost, DryFigures, Estimate, Figures, Solution
from pyworm.variables import describe

Progress = Callable[[str, float], None]

COARSE_TOLERANCE = 1e-4
"""Residual at which a grid that only leads to a finer window is left."""

ACCURATE = "the figures are as accurate as asked for"
"""The stop reason of a converged solution."""

ALGEBRA_SHARE = 0.1
"""Error of the films by unfinished algebra that is left on a grid, as a share of the accuracy."""

DOMAIN_SHARE = 0.3
"""Error of the films by the window beyond which the wider one is taken, as a share of the accuracy."""

MOST_UNSETTLED = 2
"""Grids of the figures that may stay short of the tolerance: one too coarse for its film is no failure."""

TIMED_CONVOLUTIONS = 10
"""Convolutions timed for the unit of cost."""


def solve(scene: Scene, plan: Plan, progress: Progress | None = None) -> Solution:
    """Solve a scene for its film.

    Parameters
    ----------
    scene : Scene
        The contact.
    plan : Plan
        What `pyworm.plan` made of it.
    progress : callable, optional
        Told what is being done and which share of the work is done, 0 to 1.

    Returns
    -------
    Solution
        Marked not converged, with the reason, where the figures are not to be trusted within the accuracy
        asked for.

    Raises
    ------
    KernelError
        If the scene makes no sense to the kernel (values that are not finite) or memory runs out.
    """
    tell = progress or (lambda message, share: None)
    size = scales(scene)
    unsettled = 0

    started, started_work = perf_counter(), process_time()
    tell(f"{scene.name}: first grids", 0.0)
    rung, settled, strides = _first_figures(scene, size, plan.grids, plan)
    domain = dict.fromkeys(FIGURES, np.inf)
    if plan.wider_grids:
        tell(f"{scene.name}: wider window", 0.1)
        wider, settled_wider, steps = _first_figures(scene, size, plan.wider_grids, plan)
        strides += steps
        domain = domain_errors(settled.reading, settled_wider.reading)
        if max(domain[name] for name in JUDGED) > DOMAIN_SHARE * plan.accuracy:
            rung, settled = wider, settled_wider
            domain = {name: WIDER_SHARE * error for name, error in domain.items()}
    readings = [settled.reading]
    while True:
        unsettled += rung.film.balance.worst > plan.tolerance
        estimates = _estimates(readings, domain, settled.algebra)
        stop_reason = _stop_reason(rung, estimates, unsettled, plan)
        if stop_reason is not None:
            break
        finer = rung.grid.finer()
        tell(f"{scene.name}: {finer.nx} x {finer.ny}", 1 - 0.7 ** (len(readings) + 1))
        rung = next_rung(scene, size, rung, finer)
        settled = _settle_figures(rung, plan)
        strides += settled.strides
        readings.append(settled.reading)
    seconds, work = perf_counter() - started, process_time() - started_work

    dry = dry_contact(scene, rung.grid, rung.gap, rung.covered, rung.film.pressure)
    if not dry.converged:
        stop_reason = "the dry contact did not converge"
    return Solution(
        name=scene.name,
        phase=scene.phase,
        load=scene.load,
        converged=stop_reason == ACCURATE,
        stop_reason=stop_reason,
        figures=_figures(size, rung, settled.reading, estimates, dry),
        fields=_fields(scene, rung, dry),
        history=_history(strides),
        cost=Cost(seconds, work / _convolution_work(rung)),
    )


def _first_figures(
    scene: Scene, size: Scales, grids: Sequence[Grid], plan: Plan
) -> tuple[Rung, Settled, list[Stride]]:
    """Up the nest to the first grid of the figures."""
    strides: list[Stride] = []
    rung = first_rung(scene, size, grids[0])
    for grid in grids[1:]:
        strides += settle(rung, COARSE_TOLERANCE).strides
        rung = next_rung(scene, size, rung, grid)
    settled = _settle_figures(rung, plan)
    return rung, settled, [*strides, *settled.strides]


def _settle_figures(rung: Rung, plan: Plan) -> Settled:
    return settle(rung, plan.tolerance, ALGEBRA_SHARE * plan.accuracy)


def _estimates(
    readings: Sequence[Reading], domain: Mapping[str, float], algebra: Mapping[str, float]
) -> dict[str, Estimate]:
    grid = grid_errors(readings)
    return {
        name: Estimate(getattr(readings[-1], name), grid[name], domain[name], algebra[name])
        for name in FIGURES
    }


def _stop_reason(
    rung: Rung, estimates: Mapping[str, Estimate], unsettled: int, plan: Plan
) -> str | None:
    """Why the climb ends here, or None if it goes on."""
    error = max(estimates[name].error for name in JUDGED)
    settled = rung.film.balance.worst <= plan.tolerance
    resolved = estimates["film_min"].value > 0
    if settled and resolved and error <= plan.accuracy:
        return ACCURATE
    domain = max(estimates[name].domain for name in JUDGED)
    if np.isfinite(domain) and domain > plan.accuracy:
        return f"the end of the window leaves an error of {domain:.1%}: films depend on surfaces far out"
    last = rung.grid.finer().nodes > plan.largest_grid
    if not settled and (last or unsettled >= MOST_UNSETTLED):
        return (
            f"the residual stayed at {rung.film.balance.worst:.1e}, {plan.tolerance:.1e} is wanted"
        )
    if not last:
        return None
    if not resolved:
        return "the largest grid allowed does not resolve the film"
    if np.isinf(error):
        return "the largest grid allowed leaves no second grid, or window, to compare with"
    return f"the largest grid allowed leaves an error of {error:.1%}"


def _figures(
    size: Scales,
    rung: Rung,
    last: Reading,
    estimates: Mapping[str, Estimate],
    dry: DryContact,
) -> Figures:
    film, density, imbalance = rung.film.fields()
    u, v = rung.entrainment
    exit_min, exit_min_at = reading.exit_minimum(rung.grid, film, size.angle)
    extents = reading.contact_extent(rung.grid, dry.pressure)
    return Figures(
        **estimates,
        film_min_at=last.film_min_at,
        film_exit_min=exit_min,
        film_exit_min_at=exit_min_at,
        dry=DryFigures(
            reading.pressure_maximum(dry.pressure), max(extents), min(extents), dry.approach
        ),
        moes_m=size.groups.moes_m,
        moes_l=size.groups.moes_l,
        load_error=rung.film.balance.load_error,
        mass_error=reading.outline_imbalance(
            rung.grid,
            (density * film * u, density * film * v),
            imbalance,
            rung.film.pressure > 0,
        ),
        residual=rung.film.balance.residual,
    )


def _fields(scene: Scene, rung: Rung, dry: DryContact) -> xr.Dataset:
    variables = {
        "gap": rung.gap,
        "covered": rung.covered.astype(np.int8),
        "dry_pressure": dry.pressure,
        "pressure": rung.film.pressure,
        "film": rung.film.fields()[0],
        "entrainment_x": rung.entrainment[0],
        "entrainment_y": rung.entrainment[1],
        "sliding_x": rung.sliding[0],
        "sliding_y": rung.sliding[1],
    }
    dataset = xr.Dataset(
        {name: (("y", "x"), values.T) for name, values in variables.items()},
        coords={"x": rung.grid.x, "y": rung.grid.y},
        attrs={
            "radius_x_m": scene.radii[0],
            "radius_y_m": scene.radii[1],
            "load_N": scene.load,
            "reduced_modulus_Pa": scene.reduced_modulus,
        },
    )
    return describe(dataset)


def _history(strides: Sequence[Stride]) -> xr.Dataset:
    columns = {
        field.name: ("iteration", np.array([getattr(stride, field.name) for stride in strides]))
        for field in fields(Stride)
    }
    return describe(xr.Dataset(columns, coords={"iteration": np.arange(len(strides))}))


def _convolution_work(rung: Rung) -> float:
    """Processor time of one convolution [s]; elapsed time would count what else the machine does."""
    started = process_time()
    for _ in range(TIMED_CONVOLUTIONS):
        rung.film.convolve()
    return (process_time() - started) / TIMED_CONVOLUTIONS
