"""What a dry contact costs: pyworm beside tamaas and ContactMechanics, at the same pressure error.

A circular Hertz contact at 1 GPa in a box of three radii, free space (no periodic images), one thread. The
three discretise alike, so that the mean error against Hertz within the contact comes to the same level on a
grid; each gets the loosest tolerance, in steps of ten, that reaches the level within 2 %. Times are medians
of whole solutions from gap to pressure, set-up included. Run from the repository's root:

    python benchmarks/cost/dry.py [NODES ...]

The peers are no dependencies: `python -m pip install tamaas ContactMechanics`.
"""

import os

os.environ.update(
    OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1"
)  # before any of them starts threads

import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from pyworm import kernel

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

NODES = (256, 512, 1024)
REPEATS = 5
PATIENCE = 40.0
"""Seconds for the repeats of one solver on one grid; the first run counts if it takes longer."""

PRESSURE = 1e9
RADIUS = 0.01
REDUCED_MODULUS = 226e9
LEVEL = 1.02
TIGHT = 1e-9
TOLERANCES = tuple(10.0**-exponent for exponent in range(3, 10))


class Hertz:
    """A circular contact on n x n nodes."""

    def __init__(self, n: int):
        a = np.pi * PRESSURE * RADIUS / REDUCED_MODULUS
        x = np.linspace(-1.5 * a, 1.5 * a, n)
        square = x[:, None] ** 2 + x**2
        self.n = n
        self.spacing = x[1] - x[0]
        self.gap = np.asfortranarray(square / (2 * RADIUS))
        self.load = 2 / 3 * np.pi * a**2 * PRESSURE
        self.approach = a**2 / RADIUS
        self.nodes_in_contact = np.pi * (a / self.spacing) ** 2
        self.pressure = PRESSURE * np.sqrt(np.maximum(1 - square / a**2, 0))

    def error(self, pressure) -> float:
        """Mean pressure error within the contact over the largest pressure."""
        inside = self.pressure > 0
        return float(np.abs(pressure - self.pressure)[inside].mean() / PRESSURE)


def pyworm(hertz: Hertz, tolerance: float):
    dry = kernel.dry_contact(
        hertz.gap,
        np.ones_like(hertz.gap),
        hertz.spacing,
        hertz.spacing,
        REDUCED_MODULUS,
        hertz.load,
        np.ones_like(hertz.gap),
        tolerance,
    )
    return dry.pressure, dry.iterations


def tamaas(hertz: Hertz, tolerance: float):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.warning)
    size = hertz.n * hertz.spacing
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [size, size], [hertz.n, hertz.n])
    model.E, model.nu = REDUCED_MODULUS / 2, 0.0
    tm.ModelFactory.registerNonPeriodic(model, "free space")
    solver = tm.PolonskyKeerRey(model, -np.ascontiguousarray(hertz.gap), tolerance)
    solver.setIntegralOperator("free space")
    solver.max_iter = 1000
    solver.solve(hertz.load / size**2)
    return model.traction.copy(), "-"  # it does not tell its iterations


def contact_mechanics(hertz: Hertz, tolerance: float):
    from ContactMechanics import FreeFFTElasticHalfSpace, make_system
    from SurfaceTopography import Topography

    shape, sizes = (hertz.n, hertz.n), (hertz.n * hertz.spacing,) * 2
    substrate = FreeFFTElasticHalfSpace(shape, REDUCED_MODULUS / 2, sizes)
    system = make_system(
        substrate=substrate,
        surface=Topography(-np.ascontiguousarray(hertz.gap), sizes),
        physical_sizes=sizes,
    )
    result = system.minimize_proxy(
        external_force=hertz.load,
        pentol=tolerance * hertz.approach,
        forcetol=tolerance * hertz.load / hertz.nodes_in_contact,
        thermotol=tolerance,
        maxiter=1000,
    )
    return result.jac / hertz.spacing**2, result.nit


@dataclass(frozen=True)
class Cost:
    """What one solver needed."""

    seconds: float
    runs: int
    iterations: int | str
    tolerance: float
    error: float


def cost(solver, hertz: Hertz, level: float) -> Cost | None:
    """Cost at the loosest tolerance that reaches the level of error; None if none does."""
    for tolerance in TOLERANCES:
        start = perf_counter()
        pressure, iterations = solver(hertz, tolerance)
        seconds = [perf_counter() - start]
        error = hertz.error(pressure)
        if error <= level:
            break
    else:
        return None
    while len(seconds) < REPEATS and sum(seconds) + seconds[0] < PATIENCE:
        start = perf_counter()
        solver(hertz, tolerance)
        seconds.append(perf_counter() - start)
    return Cost(median(seconds), len(seconds), iterations, tolerance, error)


def main() -> None:
    rows = []
    for n in [int(argument) for argument in sys.argv[1:]] or NODES:
        hertz = Hertz(n)
        level = LEVEL * hertz.error(pyworm(hertz, TIGHT)[0])
        ours = None
        for solver in (pyworm, tamaas, contact_mechanics):
            try:
                found = cost(solver, hertz, level)
            except ModuleNotFoundError as absent:
                print(f"{n:>5} x {n:<3} {solver.__name__:17} python -m pip install {absent.name}")
                continue
            if found is None:
                print(
                    f"{n:>5} x {n:<3} {solver.__name__:17} does not reach an error of {level:.2e}"
                )
                continue
            ours = ours or found.seconds
            times = f"{found.seconds:.3g}", f"{found.iterations}", f"{found.tolerance:.0e}"
            error = f"{found.error:.2e}", f"{found.seconds / ours:.1f}"
            rows.append(
                (
                    n,
                    solver.__name__.replace("contact_mechanics", "ContactMechanics"),
                    *times,
                    *error,
                )
            )
            print(*rows[-1], flush=True)
    columns = "seconds", "iterations", "tolerance", "error", "over pyworm"
    record("dry_contact_cost", ("nodes", "solver", *columns), rows, key=("nodes", "solver"))


if __name__ == "__main__":
    main()
