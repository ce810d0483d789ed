"""A microcavity that passes through a ball's contact, against published films along its path.

L. Mourier, D. Mazuyer, A. A. Lubrecht and C. Donnet, Transient increase of film thickness in
micro-textured EHL contacts, Tribology International 39 (2006) 1745: a shallow cavity in rolling, and one that
moves at half the mean speed, whose thick film runs ahead of it at the mean speed. Conditions and simulated
films, read from their figures, are those of the public code beside E. Hansen et al., Tribology Letters 70
(2022). Every film is computed in time with the cavity resolved. Run from the repository's root (two minutes
of processor):

    python benchmarks/validation/microcavity.py
"""

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pyworm import kernel
from pyworm.formulas.hertz import hertz
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

HALF_WIDTH, RADIUS, LOAD, MODULUS, SPEED = 136.5e-6, 12.5e-3, 15.0, 110e9, 0.09
"""Hertz's half-width and the ball's radius [m], load [N], reduced modulus [Pa], mean speed [m/s]."""

OIL = Oil(Roelands.from_alpha(0.25, 22e-9), Density(850.0, 0.34 / 5.9e8, 1 / 5.9e8))
INLET, SIDES, EXIT = 4.0, 2.5, 2.0
"""Ends of the window from the contact point, in half-widths."""

CELLS = 30, 45
"""Cells in a half-width on the two grids."""

TOLERANCE = 1e-7
"""Residual over the wedge flow of the whole window, of which the cavity's is a thousandth."""

FORCING = 1e-2
MOST_STEPS = 30


@dataclass(frozen=True)
class Cavity:
    """A cavity: depth and radius [m], its speed over the mean one, and published films.

    `films` are the cavity's place [µm] -> film [nm] at places on the line of its centre [µm].
    """

    depth: float
    radius: float
    speed: float
    films: dict[float, dict[float, float]]

    def shape(self, away: np.ndarray) -> np.ndarray:
        """Its depth at distances from its centre [m]."""
        part = away / (1.2 * self.radius)
        return self.depth * np.cos(np.pi / 2 * part) * np.exp(-2 * part**2)


CAVITIES = {
    "rolling": Cavity(
        175e-9,
        15.5e-6,
        1.0,
        {
            -44.7: {-84.3: 211.2, -42.8: 354.2, 2.2: 204.0, 34.2: 207.0, 70.2: 207.8},
            21.4: {-66.4: 211.8, -14.9: 209.5, 22.4: 355.4, 70.5: 208.9},
            109.5: {-51.6: 210.3, 2.8: 208.2, 46.6: 208.1, 106.5: 353.8},
        },
    ),
    "sliding": Cavity(
        160e-9,
        21.5e-6,
        0.5,
        {
            -69.0: {-69.0: 316.7, -37.3: 277.6, -19.0: 263.5, 21.7: 209.9, 72.0: 208.4},
            -37.7: {-84.7: 215.5, -37.7: 288.6, 0.0: 259.5, 20.8: 275.3, 42.7: 254.5, 85.8: 208.7},
            -8.4: {-61.0: 215.6, -8.4: 284.6, 31.0: 240.2, 61.5: 256.2, 81.7: 269.5, 93.2: 265.5},
            80.7: {-28.7: 211.8, 19.7: 211.8, 80.7: 298.5, 103.4: 234.9},
        },
    ),
}


class Contact:
    """The contact on one grid, with a cavity somewhere in it."""

    def __init__(self, cells: int):
        self.spacing = spacing = HALF_WIDTH / cells
        x = np.arange(-round(INLET * cells), round(EXIT * cells) + 1) * spacing
        y = np.arange(-round(SIDES * cells), round(SIDES * cells) + 1) * spacing
        self.x, self.y = np.meshgrid(x, y, indexing="ij")
        self.middle = len(y) // 2

    def film(self, cavity: np.ndarray) -> kernel.PointFilm:
        """The film with the depth of a cavity [m] added to its gap."""
        gap = (self.x**2 + self.y**2) / (2 * RADIUS) + cavity
        speed = np.full_like(gap, SPEED)
        covered = np.ones_like(gap, dtype=bool)
        entrainment = speed, np.zeros_like(gap)
        sizes = self.spacing, self.spacing, MODULUS, LOAD
        return kernel.PointFilm(gap, covered, entrainment, *sizes, OIL, 1e-10)

    def smooth(self) -> kernel.PointFilm:
        """The film without a cavity, from Hertz's pressure."""
        film = self.film(np.zeros_like(self.x))
        dry = hertz(RADIUS, RADIUS, LOAD, MODULUS)
        pressure = np.asfortranarray(dry.pressure(self.x, self.y))
        return settled(film, pressure, 0.2e-6 - dry.approach)

    def passing(self, cavity: Cavity) -> Iterator[tuple[float, np.ndarray]]:
        """Place of the cavity [m] and film along its path [m], a step for each cell that oil moves on."""
        film = self.smooth()
        step = self.spacing / SPEED
        place = -1.6 * HALF_WIDTH
        held = [content(film)] * 2
        while place < 1.1 * HALF_WIDTH:
            place += cavity.speed * self.spacing
            state = film.pressure, film.rigid_film
            film = self.film(cavity.shape(np.hypot(self.x - place, self.y)))
            film.set_transient_term(1.5 / step, (0.5 * held[1] - 2 * held[0]) / step)
            settled(film, *state)
            held = [content(film), held[0]]
            yield place, film.thickness()[:, self.middle]


def settled(film: kernel.PointFilm, pressure: np.ndarray, rigid_film: float) -> kernel.PointFilm:
    """The film after Newton steps from a pressure [Pa] and a rigid film [m]."""
    film.start(pressure, rigid_film)
    for _ in range(MOST_STEPS):
        if film.balance.worst <= TOLERANCE:
            return film
        film.step(FORCING)
    raise RuntimeError(f"no film: {film.balance}")


def content(film: kernel.PointFilm) -> np.ndarray:
    """rho h over the density without pressure [m]."""
    thickness, density, _ = film.fields()
    return density * thickness


def films_at(contact: Contact, cavity: Cavity) -> dict[float, np.ndarray]:
    """Film along the path [m] while the cavity is at each published place [µm], linear between steps."""
    found, before = {}, None
    for place, film in contact.passing(cavity):
        for wanted in cavity.films:
            if before and before[0] < 1e-6 * wanted <= place:
                part = (1e-6 * wanted - before[0]) / (place - before[0])
                found[wanted] = before[1] + part * (film - before[1])
        before = place, film
    return found


def main() -> None:
    rows = []
    contacts = [Contact(cells) for cells in CELLS]
    for name, cavity in CAVITIES.items():
        solved = [films_at(contact, cavity) for contact in contacts]
        for place, published in cavity.films.items():
            for at, film in published.items():
                coarse, fine = (
                    1e9 * np.interp(1e-6 * at, contact.x[:, 0], of[place])
                    for contact, of in zip(contacts, solved, strict=True)
                )
                off = f"{(fine / film - 1) * 100:+.1f} %"
                rows.append((name, place, at, film, f"{coarse:.1f}", f"{fine:.1f}", off))
                print(*rows[-1], flush=True)
    films = "published / nm", "coarser grid / nm", "finer grid / nm", "difference"
    record("microcavity", ("cavity", "cavity at / um", "film at / um", *films), rows)


if __name__ == "__main__":
    main()
