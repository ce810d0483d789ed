"""From a scene and its plan to a solution: up the grids until the figures are as accurate as asked."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from time import perf_counter, process_time

import numpy as np
import xarray as xr

from pyworm import reading
from pyworm.climb import Rung, Stride, dry_contact, first_rung, next_rung, settle
from pyworm.effects import Plan
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

MOST_UNSETTLED = 2
"""Grids of the figures that may stay short of the tolerance: one too coarse for its film is no failure."""

TIMED_CONVOLUTIONS = 10
"""Convolutions timed for the unit of cost."""


@dataclass(frozen=True)
class _Reading:
    """Figures on one grid: films [m] and their place [m], pressure [Pa]."""

    film_min: float
    film_min_at: tuple[float, float]
    film_central: float
    pressure_max: float


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
    strides: list[Stride] = []
    readings: list[_Reading] = []
    unsettled = 0

    started, started_work = perf_counter(), process_time()
    tell(f"{scene.name}: dry contact", 0.0)
    rung = first_rung(scene, size, plan.grids[0])
    for grid in plan.grids[1:]:
        strides += settle(rung, COARSE_TOLERANCE)
        rung = next_rung(scene, size, rung, grid)
    while True:
        tell(f"{scene.name}: {rung.grid.nx} x {rung.grid.ny}", 1 - 0.5 ** (len(readings) + 1))
        strides += settle(rung, plan.tolerance)
        readings.append(_read(rung))
        unsettled += rung.film.balance.worst > plan.tolerance
        stop_reason = _stop_reason(rung, readings, unsettled, plan)
        if stop_reason is not None:
            break
        rung = next_rung(scene, size, rung, rung.grid.finer())
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
        figures=_figures(size, rung, readings, dry),
        fields=_fields(scene, rung, dry),
        history=_history(strides),
        cost=Cost(seconds, work / _convolution_work(rung)),
    )


def _read(rung: Rung) -> _Reading:
    film, _, _ = rung.film.fields()
    film_min, at = reading.film_minimum(rung.grid, film, rung.film.pressure > 0)
    return _Reading(
        film_min,
        at,
        reading.value_at_origin(rung.grid, film),
        reading.pressure_maximum(rung.film.pressure),
    )


def _stop_reason(
    rung: Rung, readings: Sequence[_Reading], unsettled: int, plan: Plan
) -> str | None:
    """Why the climb ends here, or None if it goes on."""
    errors = _errors(readings)
    error = max(errors[name] for name in _JUDGED)
    settled = rung.film.balance.worst <= plan.tolerance
    resolved = readings[-1].film_min > 0
    if settled and resolved and error <= plan.accuracy:
        return ACCURATE
    last = rung.grid.finer().nodes > plan.largest_grid
    if not settled and (last or unsettled >= MOST_UNSETTLED):
        return (
            f"the residual stayed at {rung.film.balance.worst:.1e}, {plan.tolerance:.1e} is wanted"
        )
    if not last:
        return None
    if not resolved:
        return "the largest grid allowed does not resolve the film"
    if len(readings) < 2:
        return "the largest grid allowed leaves no second grid to compare with"
    return f"the largest grid allowed leaves an error of {error:.1%}"


_JUDGED = ("film_min", "film_central")
"""Figures that the accuracy is asked of. The largest pressure has its error bar, but is not among them: under
light loads it is the tip of a spike at the exit, which no practicable grid resolves."""


def _errors(readings: Sequence[_Reading]) -> dict[str, float]:
    """Relative error of each figure on the last of grids of halving spacing.

    The last change, or a quarter of the one before if that is larger (a figure may stand still by chance),
    divided by what the observed fall of the changes promises: at second order three quarters of the error are
    gone at each grid. On two grids no fall is seen; then the larger change of both films is the error of all.
    """
    values = {name: [getattr(r, name) for r in readings] for name in (*_JUDGED, "pressure_max")}
    changes = {name: np.abs(np.diff(of) / of[-1]) for name, of in values.items()}
    if len(readings) == 1:
        return dict.fromkeys(values, np.inf)
    if len(readings) == 2:
        films = max(float(changes[name][-1]) for name in _JUDGED)
        return {name: max(films, float(change[-1])) for name, change in changes.items()}
    errors = {}
    for name, change in changes.items():
        before, last = change[-2:]
        fall = np.clip(before / last, 2.0, 4.0) if last > 0 else 4.0
        errors[name] = float(max(last, before / 4) / (fall - 1))
    return errors


def _figures(size: Scales, rung: Rung, readings: Sequence[_Reading], dry: DryContact) -> Figures:
    film, density, imbalance = rung.film.fields()
    u, v = rung.entrainment
    exit_min, exit_min_at = reading.exit_minimum(rung.grid, film, size.angle)
    extents = reading.contact_extent(rung.grid, dry.pressure)
    estimates = {
        name: Estimate(getattr(readings[-1], name), error)
        for name, error in _errors(readings).items()
    }
    return Figures(
        **estimates,
        film_min_at=readings[-1].film_min_at,
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
