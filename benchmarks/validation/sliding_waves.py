"""Waves on a surface that slides, resolved node by node, beside the closed form and linear theory.

In a film h of constant viscosity eta, a wave r of wave number k that moves with u_r through oil entrained
with u makes the pressure wave p = r (k E'/4) i Q/(1 - i Q - i C Q), with Q = 48 (u_r - u) eta/(E' h^3 k^2),
C = h E' k/(4 B) and the oil's bulk modulus B (Morales-Espejel and Brizmer 2011); the film keeps r +
4 p/(k E') of it. A second wave leaves the inlet with the oil, u/u_r as long. Linear theory
(`linear_waves`) knows its amplitude. Both are fitted to films along y = 0. Run from the repository's
root (three minutes):

    python benchmarks/validation/sliding_waves.py
"""

import sys
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
from line import STEEL
from linear_waves import Eyring, SmoothContact, film_wave
from rough_patch import AMPLITUDE, contact, wave

import pyworm
import pyworm.scene.scales
from pyworm.materials.flow_laws import FlowLaw
from pyworm.scene.point import RigidMotion, Scene
from pyworm.solver.patch.rough_patch import rough_patch

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

M, L = 100.0, 10.0

WAVELENGTH = 0.5
"""Wavelength over Hertz's radius."""

RUNS = (
    *(("newtonian", pace) for pace in (0.0, 0.5, 0.75, 1.25, 1.5)),
    *(("eyring", pace) for pace in (0.75, 1.25)),
)
"""Flow law of the oil, and speed of the wavy surface over the entrainment."""

EYRING_STRESS = 5e6
"""Eyring's stress [Pa]."""

NODES = 129
"""Nodes along each side of the patch."""

FITTED = 0.6
"""Half the length of the film to which waves are fitted, in Hertz's radii."""


def sliding(pace: float, law: str) -> Scene:
    """The contact with a body 2 that moves with a part of the entrainment, and an oil of a flow law."""
    scene = contact(M, L)
    if law == "eyring":
        scene = replace(scene, oil=replace(scene.oil, flow=FlowLaw("eyring", stress=EYRING_STRESS)))
    speed = scene.motions[0].u
    motions = RigidMotion((2 - pace) * speed, 0.0), RigidMotion(pace * speed, 0.0)
    return replace(scene, motions=motions)


def parts(x: np.ndarray, film: np.ndarray, number: float, pace: float) -> tuple[float, float]:
    """Amplitudes of the wave that moves with the surface and of that which moves with the oil, in a film."""
    complex_film = np.iscomplexobj(film)
    columns = [np.ones_like(x), x / x.max(), (x / x.max()) ** 2]
    first = len(columns)
    for known in (number, number * pace)[: 2 if pace else 1]:
        turn = np.exp(1j * known * x)
        columns += [turn] if complex_film else [turn.real, turn.imag]
    best, *_ = np.linalg.lstsq(np.array(columns).T, film, rcond=None)
    found = best[first:] if complex_film else best[first::2] + 1j * best[first + 1 :: 2]
    surface, oil = (*np.abs(found), 0.0)[:2]
    return float(surface), float(oil)


def closed_form(smooth: SmoothContact, number: float, pace: float, shear: Eyring | None) -> float:
    """Part of a wave that the film keeps far inside the contact."""
    middle = int(np.argmin(np.abs(smooth.grid.x)))
    p, h = float(smooth.pressure[middle, 0]), float(smooth.film[middle, 0])
    density, eta = smooth.oil.density, smooth.oil.eta(p)
    if shear is not None:
        eta /= float(shear.thinned(np.array(eta * shear.sliding / h), True)[0])
    bulk = density(p) * 2e6 / (density(p + 1e6) - density(p - 1e6))
    modulus = 2 * smooth.modulus  # E' of the authors
    compressed = h * modulus * number / (4 * bulk)
    slip = (pace - 1) * smooth.entrainment
    flow = 48 * slip * eta / (modulus * h**3 * number**2)
    return abs(1 + 1j * flow / (1 - 1j * flow - 1j * compressed * flow))


def main() -> None:
    """Waves in the film by the patch, by linear theory and by the closed form."""
    table = []
    for law, pace in RUNS:
        scene = sliding(pace, law)
        size = pyworm.scene.scales.scales(scene)
        radius = size.hertz.semi_axis_x
        number, given = 2 * pi / (WAVELENGTH * radius), AMPLITUDE * size.film
        surface = wave(WAVELENGTH * radius, given)
        found = rough_patch(scene, (None, surface), nodes=NODES, averaged=0.1)
        modulus = STEEL.youngs_modulus / (2 * (1 - STEEL.poisson_ratio**2))
        speed = sum(motion.u for motion in scene.motions) / 2
        smooth = SmoothContact.of(found, speed, modulus, scene.oil)
        x = found.grid.x
        inside = np.abs(x) < FITTED * radius
        film = (found.last.film - found.smooth_film)[inside, found.grid.ny // 2] / given
        slip = 2 * abs(1 - pace) * speed
        shear = Eyring(slip, EYRING_STRESS, True) if law == "eyring" else None
        linear = film_wave(smooth, number, pace, shear)[inside]
        kept = parts(x[inside], film, number, pace), parts(x[inside], linear, number, pace)
        row = (
            law, pace, f"{2 * (1 - pace):+.1f}", f"{closed_form(smooth, number, pace, shear):.3f}",
            *(f"{kind[0]:.3f}" for kind in kept[::-1]), *(f"{kind[1]:.3f}" for kind in kept[::-1]),
            f"{found.cpu_seconds:.0f}",
        )  # fmt: skip
        table.append(row)
        print(*row, flush=True)
    head = (
        "oil", "speed of the wave / entrainment", "slide-roll ratio", "kept: closed form",
        "kept: linear theory", "kept: patch", "in the oil: linear theory", "in the oil: patch",
        "processor time of the patch [s]",
    )  # fmt: skip
    record("patch_sliding_waves", head, table)


if __name__ == "__main__":
    main()
