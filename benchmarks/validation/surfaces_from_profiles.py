"""Surfaces made of profiles, against the generated surfaces on which the profiles lie.

Each of forty random surfaces, Gaussian or self-affine, with a lay, half of them with worn summits, is read
along three lines across the lay and two along it. Figures, asperity pressure and flow factors of the surface
made of these profiles are compared with those of the whole: how many lie within their uncertainties. The
uncertainty was built on surfaces 100 to 179.

    python benchmarks/validation/surfaces_from_profiles.py
"""

import sys
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from pyworm.kernel.rough_cell import conduct, press
from pyworm.materials.roughness_assumptions import flow_scatter
from pyworm.materials.topography import Topography
from pyworm.surfaces.from_profiles import profiles_along, sampled_surface
from pyworm.surfaces.parameters import texture
from pyworm.surfaces.profile import Profile, roughness_profile
from pyworm.surfaces.scatter import uncertainty_of_whole
from pyworm.surfaces.topography_pair import MOST_SCATTER

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

SURFACES = range(200, 240)
"""Seeds, none of which was seen when the parts of the uncertainty were chosen."""
NODES, STEP = 512, 1.25e-6
FIGURES = ("rq", "ra", "rk", "rpk", "rvk", "slope_y", "slope_x", "length_across", "length_along")
CORE = "rk", "rpk", "rvk"
"""Heights that worn summits make small or none."""
GAPS = (1.0, 1.5, 2.0)
MODULUS = 2.0
FLOOR = 1e-2
NONE = 1e-12
"""Pressure over E* that is none: worn summits may not touch."""


def truth(number: int) -> Topography:
    """A random surface, its lay along x."""
    rng = np.random.default_rng(number)
    aspect = float(rng.uniform(1.5, 6.0))
    spacing = STEP * aspect, STEP
    kx, ky = (2 * np.pi * np.fft.fftfreq(NODES, step) for step in spacing)
    k = np.hypot(aspect * kx[:, None], ky[None, :])
    if number % 2:
        length = rng.uniform(8e-6, 16e-6)
        density = np.exp(-((k * length) ** 2) / (4 * np.log(10)))
    else:
        longest, hurst = rng.uniform(40e-6, 80e-6), rng.uniform(0.6, 0.9)
        inside = (k >= 2 * np.pi / longest) & (k <= 2 * np.pi / 5e-6)
        density = np.where(inside, np.where(inside, k, 1.0) ** (-2 - 2 * hurst), 0.0)
    noise = np.fft.fft2(rng.standard_normal((NODES, NODES)))
    height = np.fft.ifft2(noise * np.sqrt(density)).real
    surface = Topography(height * (0.5e-6 / height.std()), spacing, periodic=True)
    return surface.run_in(0.7) if worn(number) else surface


def averages(surface: Topography) -> dict[str, float]:
    """Logarithm of the pressure over E*, and flow factors, at gaps over the roughness."""
    cell = replace(surface, height=surface.height / surface.rms, spacing=surface.spacing)
    found = {}
    for gap in GAPS:
        steps = [step / surface.rms for step in surface.spacing]
        pressure, open_gap = press(cell.height, tuple(steps), MODULUS, gap, 1e6, 1e-4)
        found[f"ln p at H = {gap:g}"] = float(np.log(max(pressure.mean(), NONE)))
        flowing = np.maximum(open_gap, FLOOR)
        conducted, _ = conduct(flowing, tuple(steps))
        cube = flowing.mean() ** 3
        found[f"phi along at H = {gap:g}"] = conducted[0] / cube
        found[f"phi across at H = {gap:g}"] = conducted[1] / cube
    return found


def compared(number: int) -> list[tuple]:
    """Rows: surface, quantity, its own value, that by profiles, uncertainty."""
    whole = truth(number)
    rng = np.random.default_rng(1000 + number)
    lines = rng.choice(NODES, 5, replace=False)
    across = [roughness_profile(whole.height[line], whole.spacing[1]) for line in lines[:3]]

    def read_along(index: float | None) -> list[Profile]:
        heights = [whole.height[:, line] for line in lines[3:]]
        if index is not None and index > whole.extent[0]:
            index = None
        return [
            roughness_profile(height, whole.spacing[0], nesting_index=index, by_class=False)
            for height in heights
        ]

    along = profiles_along(read_along, across)
    made = sampled_surface(across, along, None, number)
    rows = []
    own, by = asdict(texture(whole)), asdict(texture(made))
    samples = [asdict(texture(sample)) for sample in made.samples]
    for name in FIGURES:
        bar = float(uncertainty_of_whole([sample[name] for sample in samples], by[name]))
        rows.append((number, name, own[name], by[name], bar))
    own, by = averages(whole), averages(made)
    samples = [averages(sample) for sample in made.samples]
    for name, value in own.items():
        if value == np.log(NONE):
            continue
        bar = float(uncertainty_of_whole([sample[name] for sample in samples], by[name]))
        if name.startswith("ln"):
            bar = min(bar, MOST_SCATTER)
        if name.startswith("phi"):
            bar = float(np.hypot(bar, flow_scatter(float(name.split()[-1])) * by[name]))
        rows.append((number, name, value, by[name], bar))
    return rows


def worn(number: int) -> bool:
    """Whether the summits of a surface are worn off."""
    return number % 4 > 1


def _counted(rows: list[tuple]) -> tuple:
    """Number of surfaces and of those within their uncertainty, and sizes: what they are off, uncertainty.

    They are over the figure itself, of heights of the core over Rq.
    """
    if not rows:
        return 0, 0, "", "", ""
    off, bars, own = (
        np.array(column)
        for column in zip(*((row[3] - row[2], row[4], row[2]) for row in rows), strict=True)
    )
    if rows[0][1].startswith("ln"):
        scale = np.ones(len(off))
    elif rows[0][1] in CORE:
        scale = np.array([truth(row[0]).rms for row in rows])
    else:
        scale = np.abs(own)
    sizes = np.median(np.abs(off / scale)), np.mean(bars / scale), np.mean(off / scale)
    return len(rows), int(np.sum(np.abs(off) <= bars)), *(f"{size:.3f}" for size in sizes)


def main() -> None:
    rows = []
    for number in SURFACES:
        rows += compared(number)
        print(number, flush=True)
    names = list(dict.fromkeys(row[1] for row in rows))
    table = [
        (kind, name, *_counted([row for row in rows if row[1] == name and worn(row[0]) == is_worn]))
        for kind, is_worn in (("as made", False), ("worn summits", True))
        for name in names
    ]
    head = (
        "summits",
        "quantity",
        "surfaces",
        "within",
        "median difference",
        "mean uncertainty",
        "mean difference",
    )
    record("surfaces_from_profiles", head, table)


if __name__ == "__main__":
    main()
