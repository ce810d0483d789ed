"""Rough surfaces resolved node by node, beside published waves and beside the averaged model.

Run from the repository's root, one of

    python benchmarks/validation/rough_patch.py waves         (five minutes)
    python benchmarks/validation/rough_patch.py averaged      (ten minutes)
    python benchmarks/validation/rough_patch.py steps         (five minutes)
    python benchmarks/validation/rough_patch.py time 513      (five minutes)
"""

import sys
from dataclasses import replace
from math import pi, sqrt
from pathlib import Path

import numpy as np
from line import ALPHA, ETA0, OILS, RADIUS, STEEL

import pyworm
import pyworm.scene.scales
from pyworm.materials.topography import Topography
from pyworm.scene.point import Paraboloid, RigidMotion, Scene
from pyworm.solver.patch.rough_patch import RoughPatch, rough_patch
from pyworm.surfaces.generated import gaussian

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

WAVES = (
    (100.0, 10.0, 2.0),
    (100.0, 10.0, 1.0),
    (100.0, 10.0, 0.5),
    (100.0, 10.0, 0.25),
)
"""Moes' M and L, wavelength over Hertz's radius."""

AMPLITUDE = 0.1
"""Amplitude of the wave over the smooth central film."""

LONG_GRIDS, SHORT_GRIDS = ((129, 1), (257, 2)), ((193, 1), (257, 1))
"""Nodes along each side, and nodes that the oil moves on in a step, for waves from half a radius on and for
shorter ones."""

CORRELATION = 30e-6
"""Correlation length of the rough surface [m]."""

RUNS = (
    (0.05e-6, CORRELATION, 257),
    (0.1e-6, CORRELATION, 257),
    (0.1e-6, CORRELATION, 129),
    (0.2e-6, CORRELATION, 129),
    (0.25e-6, CORRELATION, 129),
    (0.36e-6, CORRELATION, 129),
    (0.36e-6, 2 * CORRELATION, 129),
    (0.5e-6, 2 * CORRELATION, 129),
    (0.7e-6, 2 * CORRELATION, 129),
)
"""Root mean square heights of the rough surface and its correlation length [m], and nodes."""


HEIGHT = 0.1e-6
"""Root mean square height where time steps and time are looked at [m]."""


def contact(m: float, lubricant: float) -> Scene:
    """A rolling ball of given Moes parameters."""
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    speed_group = (lubricant / (ALPHA * modulus)) ** 4 / 2
    speed = speed_group * modulus * RADIUS / ETA0
    return Scene(
        name=f"({m:g}, {lubricant:g})",
        gap=Paraboloid(RADIUS, RADIUS),
        motions=(RigidMotion(speed, 0.0), RigidMotion(speed, 0.0)),
        load=m * (2 * speed_group) ** 0.75 * modulus * RADIUS**2,
        bodies=(STEEL, STEEL),
        oil=OILS["compressible"],
    )


def wave(length: float, amplitude: float) -> Topography:
    """Waves across the motion."""
    count, waves = 32, 16
    height = amplitude * np.cos(2 * pi * np.arange(count * waves) / count)
    return Topography(
        np.repeat(height[:, None], 4, axis=1), (length / count, length), periodic=True
    )


def amplitude_left(found: RoughPatch) -> float:
    """Amplitude of the central film while the last wave passes [m]."""
    films = [known.film_central for known in found.records if known.time >= found.taken_from]
    return (max(films) - min(films)) / 2


def waves() -> None:
    """Amplitude that waves keep, beside Venner and Lubrecht's formula."""
    table = []
    for m, lubricant, ratio in WAVES:
        scene = contact(m, lubricant)
        size = pyworm.scene.scales.scales(scene)
        radius = size.hertz.semi_axis_x
        given = AMPLITUDE * size.film
        left = []
        for nodes, stride in LONG_GRIDS if ratio >= 0.5 else SHORT_GRIDS:
            found = rough_patch(
                scene,
                (None, wave(ratio * radius, given)),
                nodes=nodes,
                stride=stride,
                averaged=ratio,
            )
            left.append(amplitude_left(found) / given)
        group = ratio * sqrt(m / lubricant)
        formula = 1 / (1 + 0.15 * group + 0.015 * group**2)
        table.append(
            (
                m,
                lubricant,
                ratio,
                f"{group:.2f}",
                f"{formula:.3f}",
                *(f"{x:.3f}" for x in left),
            )
        )
        print(*table[-1], flush=True)
    head = "M", "L", "wavelength / a", "nabla", "formula", "coarser grid", "finer grid"
    record("patch_waves", head, table)


def rubbing(roughness: float, correlation: float = CORRELATION) -> tuple[Scene, Topography]:
    """A sliding contact and the rough surface of its second body."""
    scene = pyworm.load("cases/traction_steel.toml").scene(slide_roll_ratio=0.2)
    return scene, gaussian(roughness, correlation, seed=1)


def with_surface(scene: Scene, surface: Topography) -> Scene:
    """The contact whose averaged model has the surface on its second body."""
    first, second = scene.bodies
    return replace(
        scene,
        bodies=(
            replace(first, roughness=1e-9),
            replace(second, roughness=surface.rms, topography=surface),
        ),
    )


FIGURES = "film_mean", "touching_load", "friction"
"""Figures of both models."""


def by_averages(scene: Scene, surface: Topography) -> dict[str, float]:
    """Figures of the averaged model, its film within half the half-axes as the patch has it."""
    model = pyworm.solve(with_surface(scene, surface), accuracy=0.03)
    figures, film = model.figures, model.fields["film"].transpose("x", "y")
    size = pyworm.scene.scales.scales(scene).hertz
    x, y = np.meshgrid(film["x"], film["y"], indexing="ij")
    central = np.hypot(x / size.semi_axis_x, y / size.semi_axis_y) < 0.5
    share = figures.asperity_load_fraction
    return {
        "film_mean": float(film.values[central].mean()),
        "touching_load": share.value if share else 0.0,
        "friction": figures.friction_coefficient.value,
        "temperature": figures.temperature_max_body_2.value,
    }


def averaged() -> None:
    """The resolved patch beside the averaged model by roughness and correlation length."""
    table = []
    for roughness, correlation, nodes in RUNS:
        scene, surface = rubbing(roughness, correlation)
        found = rough_patch(scene, (None, surface), nodes=nodes)
        parted = sum(known.parts > 1 for known in found.records)
        print(
            f"{len(found.records)} steps, {parted} of them in parts, {found.cpu_seconds:.0f} s, "
            f"largest pressure {found.mean('pressure_max')[0] / 1e9:.1f} GPa, converged: {found.converged}",
            flush=True,
        )
        known = by_averages(scene, surface)
        rows = {
            name: (getattr(found.smooth, name), *found.mean(name), known[name]) for name in FIGURES
        }
        rows["temperature"] = (
            found.smooth.temperatures[1], found.mean_temperatures()[1], 0.0, known["temperature"],
        )  # fmt: skip
        ratio = f"{found.smooth.film_mean / roughness:.2f}"
        for name, values in rows.items():
            shown = (f"{value:.5g}" for value in values)
            given = f"{roughness * 1e6:g}", f"{correlation * 1e6:g}", ratio, nodes
            table.append((*given, UNITS[name], *shown, f"{found.cpu_seconds:.0f}"))
            print(*table[-1], flush=True)
        record("patch_averaged", AVERAGED_HEAD, table)


AVERAGED_HEAD = (
    "Rq [um]", "correlation length [um]", "film / Rq", "nodes", "figure", "smooth", "patch",
    "deviation in time", "averaged", "processor time of the patch [s]",
)  # fmt: skip
"""Columns of the comparison."""


UNITS = {
    "film_mean": "mean film [m]",
    "touching_load": "asperity load ratio",
    "friction": "friction coefficient",
    "temperature": "maximum temperature of body 2 [K]",
}
"""Figure -> its name in the table."""


def steps() -> None:
    """Figures by the time step and the tolerance."""
    table = []
    scene, surface = rubbing(HEIGHT)
    for stride, tolerance in ((2, 1e-3), (1, 1e-3), (2, 1e-4)):
        found = rough_patch(scene, (None, surface), nodes=129, stride=stride, tolerance=tolerance)
        row = (
            stride, tolerance, *(f"{found.mean(name)[0]:.4g}" for name in FIGURES),
            f"{found.mean_temperatures()[2]:.2f}", f"{max(k.residual for k in found.records):.1e}",
            f"{max(abs(k.load_error) for k in found.records):.1e}",
            f"{max(k.added for k in found.records):.1e}",
            f"{found.cpu_seconds:.0f}",
        )  # fmt: skip
        table.append(row)
        print(*row, flush=True)
    head = (
        "stride", "tolerance", *FIGURES, "temperature_max_film [K]", "mass error", "load error", "mass added",
        "processor time [s]",
    )  # fmt: skip
    record("patch_steps", head, table)


def timed(nodes: int) -> None:
    """Time of a patch with heat."""
    scene, surface = rubbing(HEIGHT)
    found = rough_patch(scene, (None, surface), nodes=nodes, averaged=0.5)
    newton = sum(known.newton for known in found.records)
    krylov = sum(known.krylov for known in found.records)
    row = (
        nodes, len(found.records), newton, krylov, f"{found.seconds:.0f}", f"{found.cpu_seconds:.0f}",
        *(f"{found.mean(name)[0]:.4g}" for name in FIGURES), f"{found.mean_temperatures()[2]:.2f}",
    )  # fmt: skip
    print(*row)
    head = (
        "nodes", "steps", "newton", "gmres", "elapsed [s]", "processor [s]", *FIGURES,
        "temperature_max_film [K]",
    )  # fmt: skip
    record("patch_time", head, [row], key=("nodes",))


if __name__ == "__main__":
    if sys.argv[1] == "time":
        timed(int(sys.argv[2]))
    else:
        {"waves": waves, "averaged": averaged, "steps": steps}[sys.argv[1]]()
