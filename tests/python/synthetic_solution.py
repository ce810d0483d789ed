"""Made-up but plausible solutions, for tests of what reads solutions."""

from dataclasses import dataclass
from math import acos, cos, pi, sin

import numpy as np
import xarray as xr

from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.result import Result, mesh_cycle_dataset
from pyworm.solution import Cost, DryFigures, Estimate, Figures, Solution
from pyworm.variables import describe


def make_solution(
    name="circular",
    radii=(12.5e-3, 12.5e-3),
    load=15.0,
    reduced_modulus=110e9,
    film_central=213e-9,
    speed=0.09,
    spin=0.0,
    angle=0.0,
    turn=0.0,
    points=(129, 129),
    extent=((-3.0, 2.0), (-2.2, 2.2)),
    edge=None,
    phase=None,
    converged=True,
):
    """A Hertz pressure with an inlet tail and a film with a horseshoe at the exit.

    The ellipse is turned by `turn` [rad] and entrained at `angle` [rad] from x; `extent` is in
    semi-axes of the box around the ellipse; `edge` is a tooth edge y <= edge + x/40 [m].
    """
    contact = hertz(*radii, load, reduced_modulus)
    a, b = contact.semi_axis_x, contact.semi_axis_y
    half_x = np.hypot(a * cos(turn), b * sin(turn))
    half_y = np.hypot(a * sin(turn), b * cos(turn))
    x = np.linspace(*extent[0], points[0]) * half_x
    y = np.linspace(*extent[1], points[1])[:, None] * half_y
    along, across = x * cos(turn) + y * sin(turn), -x * sin(turn) + y * cos(turn)
    s = np.hypot(along / a, across / b)
    entrainment_x = speed * cos(angle) - spin * y + 0 * x
    entrainment_y = speed * sin(angle) + spin * x + 0 * y
    covered = np.ones(s.shape) if edge is None else (y <= edge + x / 40).astype(float)
    dry_pressure = contact.pressure(along, across) * covered
    outside = np.maximum(s, 1.0)
    deformed = contact.approach / pi * ((outside**2 - 2) * np.arccos(1 / outside))
    deformed += contact.approach / pi * np.sqrt(outside**2 - 1)
    downstream = (x * cos(angle) / half_x + y * sin(angle) / half_y) / np.maximum(s, 1e-9)
    lobe = np.exp(-(((s - 0.93) / 0.09) ** 2)) * (0.25 + 0.3 * np.exp(-2 * (downstream - 0.3) ** 2))
    film = film_central * (1 - lobe * (downstream > -0.4)) + deformed
    tail = 0.05 * contact.pressure_max * np.exp(-np.maximum(s - 1, 0) / 0.2) * (downstream < 0)
    fields = describe(
        xr.Dataset(
            {
                "gap": (("y", "x"), along**2 / (2 * radii[0]) + across**2 / (2 * radii[1])),
                "covered": (("y", "x"), covered),
                "dry_pressure": (("y", "x"), dry_pressure),
                "pressure": (("y", "x"), np.maximum(0.97 * dry_pressure, tail)),
                "film": (("y", "x"), film),
                "entrainment_x": (("y", "x"), entrainment_x),
                "entrainment_y": (("y", "x"), entrainment_y),
                "sliding_x": (("y", "x"), 0.1 * entrainment_x),
                "sliding_y": (("y", "x"), 0.1 * entrainment_y),
            },
            coords={"x": x, "y": y[:, 0]},
            attrs={
                "radius_x_m": radii[0],
                "radius_y_m": radii[1],
                "load_N": load,
                "reduced_modulus_Pa": reduced_modulus,
            },
        )
    )
    lowest = np.unravel_index(np.argmin(film), film.shape)
    figures = Figures(
        film_min=Estimate(float(film.min()), 0.013),
        film_central=Estimate(film_central, 0.004),
        pressure_max=Estimate(0.97 * contact.pressure_max, 0.002),
        film_min_at=(float(x[lowest[1]]), float(y[lowest[0], 0])),
        film_exit_min=0.8 * film_central,
        film_exit_min_at=0.93 * a,
        dry=DryFigures(contact.pressure_max, 2 * max(a, b), 2 * min(a, b), contact.approach),
        moes_m=63.8,
        moes_l=5.79,
        load_error=1e-7,
        mass_error=3e-4,
        residual=8e-9,
    )
    return Solution(
        name=name,
        kind="point",
        phase=phase,
        load=load,
        converged=converged,
        stop_reason="residual below its tolerance" if converged else "too many iterations",
        figures=figures,
        fields=fields,
        history=make_history(),
        cost=Cost(seconds=2.5, convolutions=311.5),
    )


def make_line_solution(load=183e3, film_central=175e-9, phase=None, converged=True):
    """A line contact of radius 10 mm: Hertz's pressure with a tail before it, and a dip at the exit."""
    contact = hertz_line(0.01, load, 226e9)
    x = np.linspace(-3, 1.6, 185) * contact.half_width
    s = x / contact.half_width
    pressure = contact.pressure(x)
    tail = 0.2 * contact.pressure_max * np.exp(8 * np.minimum(s + 1, 0)) * (s < 0)
    film = film_central * (
        1 + 3 * np.maximum(abs(s) - 1, 0) - 0.2 * np.exp(-(((s - 0.95) / 0.05) ** 2))
    )
    fields = describe(
        xr.Dataset(
            {
                "gap": ("x", x**2 / 0.02),
                "covered": ("x", np.ones(x.size)),
                "pressure": ("x", np.maximum(pressure, tail)),
                "film": ("x", film),
                "entrainment_x": ("x", np.full(x.size, 0.46)),
                "sliding_x": ("x", np.zeros(x.size)),
            },
            coords={"x": x},
            attrs={"radius_m": 0.01, "load_per_length_N_m": load, "reduced_modulus_Pa": 226e9},
        )
    )
    return Solution(
        name="line",
        kind="line",
        phase=phase,
        load=load,
        converged=converged,
        stop_reason="the figures are accurate" if converged else "too many iterations",
        figures=Figures(
            film_min=Estimate(float(film.min()), 0.004, 0.001),
            film_central=Estimate(film_central, 0.002, 0.001),
            pressure_max=Estimate(contact.pressure_max, 0.001),
            film_min_at=(float(x[np.argmin(film)]),),
            moes_m=20.0,
            moes_l=10.0,
            load_error=1e-12,
            mass_error=1e-7,
            residual=2e-7,
        ),
        fields=fields,
        history=make_history().drop_vars("points_y"),
        cost=Cost(seconds=0.05, convolutions=2000.0),
    )


def make_history():
    """Three grids with a residual that falls on each."""
    points = np.repeat([33, 65, 129], [9, 7, 5])
    residual = np.concatenate([10.0 ** -np.arange(n) for n in (9, 7, 5)])
    return describe(
        xr.Dataset(
            {
                "points_x": ("iteration", points),
                "points_y": ("iteration", points),
                "residual": ("iteration", residual),
                "load_error": ("iteration", 0.3 * residual**0.9),
                "krylov": ("iteration", np.full(points.size, 12)),
            },
            coords={"iteration": np.arange(points.size)},
        )
    )


@dataclass(frozen=True)
class Contact:
    """A contact as a drive reports it."""

    phase: float
    worm_angle: float
    wheel_angle: float
    transmission_error: float
    point: tuple[float, float, float]
    normal: tuple[float, float, float]
    radii: tuple[float, float]


def make_mesh_cycle(count=21):
    """A contact that wanders across a tooth."""
    return mesh_cycle_dataset(
        Contact(
            phase=p,
            worm_angle=2 * pi * p,
            wheel_angle=2 * pi * p * 3 / 59,
            transmission_error=2e-5 * cos(2 * pi * p) - 1e-5 * p,
            point=(0.260 + 0.014 * p, 0.018 * cos(acos(0.9) + 3 * p), 0.02 * (p - 0.5)),
            normal=(0.4, 0.3, 0.75**0.5),
            radii=(3.0 + 2 * (p - 0.5) ** 2, 0.095 + 0.02 * p),
        )
        for p in np.linspace(0, 1, count)
    )


def make_worm_solution(phase=0.5, edge=1.6e-3, **changes):
    """A slender contact, 22 x 2.3 mm, cut by a tooth edge, with spin."""
    settings = {
        "name": f"worm {phase}",
        "radii": (3.046, 0.0954),
        "load": 14e3,
        "reduced_modulus": 170.81e9,
        "film_central": 1.4e-6,
        "speed": 3.0,
        "spin": 40.0,
        "angle": 1.3,
        "points": (193, 97),
        "extent": ((-1.5, 1.5), (-3.2, 2.2)),
        "edge": edge,
        "phase": phase,
    }
    return make_solution(**(settings | changes))


def make_result():
    """A drive with two solved scenes."""
    return Result(
        case_name="made-up worm",
        case={"drive": {"kind": "zi-worm", "threads": 3, "hob_swivel": 0.1 + 0.2}, "oil": None},
        solutions=(make_worm_solution(0.25), make_worm_solution(0.75, converged=False)),
        mesh_cycle=make_mesh_cycle(),
        provenance={"pyworm_version": "0.1", "effects": ["elastic"], "tolerances": {"load": 1e-6}},
    )
