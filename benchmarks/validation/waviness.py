"""How much of a wave on a rolling surface is left in the film, against Venner's numbers, on two grids.

A wavy line rolls through a line contact (M = 100, L = 11, pure rolling). Elastic flattening leaves a part of
its amplitude in the film at the contact's centre, more of shorter waves: the reason why the short waves of a
surface keep their shape in averaged films and long ones belong into the gap. Every film is computed in time
with the wave resolved. Run from the repository's root (three minutes):

    python benchmarks/validation/waviness.py
"""

import sys
from collections.abc import Iterator
from math import pi
from pathlib import Path

import numpy as np
from line import OILS, line

from pyworm import kernel
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene
from pyworm.scene.scales import line_scales

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

M, L = 100.0, 11.0

VENNER = {
    0.1: {4.0: 0.030, 2.0: 0.073, 1.0: 0.183, 0.5: 0.394, 0.25: 0.660, 0.125: 0.839},
    0.5: {4.0: 0.029, 2.0: 0.073, 1.0: 0.195, 0.5: 0.378, 0.25: 0.679, 0.125: 0.859},
}
"""Amplitude over the smooth central film -> wave length over Hertz's half-width -> amplitude of the film over
that of the wave; C. H. Venner et al., Waviness deformation in starved and line contacts, 1997, table 1."""

INLET, EXIT = 4.5, 2.0
"""Ends of the window, before and behind the centre, in half-widths."""

CELLS = 128, 256
"""Least number of cells in a half-width on the two grids; a wave has at least a quarter of that."""

PASSED = 3.0
"""Time after which waves in the centre entered the contact as waves, in half-widths over the speed."""

TOLERANCE = 1e-6
FORCING = 1e-3
MOST_STEPS = 12
LOST = 1e-3
"""Residual above which a film counts as lost: where nodes rupture and fill in turns, 1e-4 may be left."""


def film_on(grid: LineGrid, scene: LineScene, wave: np.ndarray) -> kernel.LineFilm:
    """The film of the contact with a wave [m] added to its gap."""
    gap, covered = scene.gap(grid.x)
    return kernel.LineFilm(
        gap + wave,
        covered,
        *scene.entrainment_at(grid.x),
        grid.dx,
        scene.reduced_modulus,
        scene.load,
        scene.oil,
        1e-3 * line_scales(scene).film,
    )


def settled(film: kernel.LineFilm, pressure: np.ndarray, rigid_film: float) -> None:
    """Newton steps from a pressure [Pa] and a rigid film [m] until the equations are met."""
    film.start(pressure, rigid_film)
    for _ in range(MOST_STEPS):
        if film.balance.worst <= TOLERANCE:
            return
        film.step(FORCING)
    if film.balance.worst > LOST:
        raise RuntimeError(f"no film: {film.balance}")


def smooth_film(grid: LineGrid, scene: LineScene) -> kernel.LineFilm:
    """The film without waves, from Hertz's pressure."""
    sizes = line_scales(scene)
    film = film_on(grid, scene, np.zeros(grid.nodes))
    pressure = sizes.hertz.pressure(grid.x)
    pressure[1:-1] = (pressure[:-2] + 2 * pressure[1:-1] + pressure[2:]) / 4
    film.start(pressure * scene.load / (pressure.sum() * grid.dx), 0.0)
    middle = -grid.first
    settled(film, film.pressure, sizes.film - float(film.thickness()[middle]))
    return film


def central_films(
    scene: LineScene, grid: LineGrid, length: float, part: float
) -> Iterator[tuple[float, float]]:
    """Time [s] and central film [m] while a wave of a length [m] rolls through, a step for each cell.

    Its amplitude is this part of the smooth central film. Time steps are implicit, of second order.
    """
    film = smooth_film(grid, scene)
    middle = -grid.first
    amplitude = part * float(film.thickness()[middle])
    speed = abs(scene.entrainment)
    step = grid.dx / speed
    pressure, rigid_film = film.pressure, film.rigid_film
    held = [content(film)] * 2
    half_width = line_scales(scene).hertz.half_width
    for count in range(1, round((PASSED * half_width + 1.25 * length) / grid.dx)):
        wave = amplitude * np.cos(2 * pi * (grid.x - count * grid.dx) / length)
        film = film_on(grid, scene, wave)
        film.set_transient_term(1.5 / step, (0.5 * held[1] - 2 * held[0]) / step)
        settled(film, pressure, rigid_film)
        pressure, rigid_film = film.pressure, film.rigid_film
        held = [content(film), held[0]]
        yield count * step, float(film.thickness()[middle])


def content(film: kernel.LineFilm) -> np.ndarray:
    """rho h over the density without pressure [m]."""
    thickness, density, _ = film.fields()
    return density * thickness


def amplitude_left(scene: LineScene, cells: int, ratio: float, part: float) -> float:
    """Amplitude of the central film over that of the wave, whose length over the half-width is the ratio."""
    half_width = line_scales(scene).hertz.half_width
    spacing = half_width / max(cells, round(cells / (4 * ratio)))
    grid = LineGrid(
        spacing, round(-INLET * half_width / spacing), round((INLET + EXIT) * half_width / spacing)
    )
    smooth = float(smooth_film(grid, scene).thickness()[-grid.first])
    length = ratio * half_width
    speed = abs(scene.entrainment)
    films = list(central_films(scene, grid, length, part))
    last = [film for time, film in films if time > films[-1][0] - length / speed]
    return (max(last) - min(last)) / (2 * part * smooth)


def main() -> None:
    scene = line(M, L, OILS["compressible"])
    table = []
    for part, rows in VENNER.items():
        for ratio, expected in rows.items():
            coarse, fine = (amplitude_left(scene, cells, ratio, part) for cells in CELLS)
            limit = fine + (fine - coarse) / 3
            off = f"{(limit / expected - 1) * 100:+.1f} %"
            found = f"{expected:.3f}", f"{coarse:.4f}", f"{fine:.4f}", f"{limit:.3f}", off
            table.append((part, ratio, *found))
            print(*table[-1], flush=True)
    found = "Venner", "coarser grid", "finer grid", "limit", "difference"
    record("waviness", ("A_i/H_c", "wavelength / b", *found), table)


if __name__ == "__main__":
    main()
