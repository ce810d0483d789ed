"""Made-up but plausible solutions, for tests of what reads solutions."""

from dataclasses import dataclass, replace
from math import acos, cos, pi, sin

import numpy as np
import xarray as xr
from scipy.interpolate import RegularGridInterpolator

from pyworm.drives.worm.dataset import mesh_cycle_data
from pyworm.formulas.film import line_groups, point_groups
from pyworm.formulas.film_atlas import AtlasGroups, films, regime_measures
from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.formulas.regimes import Regime, line_regime
from pyworm.io.quantities import describe
from pyworm.result.result import Result
from pyworm.solver.ending import Ending
from pyworm.solver.solution import Cost, DryFigures, Estimate, Figures, Solution


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
        ending=Ending.ACCURATE if converged else Ending.RESIDUAL,
        stop_reason=Ending.ACCURATE.message if converged else "too many iterations",
        figures=figures,
        regime=_point_regime(point_groups(*radii, load, reduced_modulus, speed, 0.04, 2.2e-8)),
        fields=fields,
        history=make_history(),
        cost=Cost(seconds=2.5, convolutions=311.5),
    )


def _point_regime(groups):
    """The regime of entrainment along an axis of the contact, by the formula of the atlas."""
    ratio = max(groups.ratio, 1 / groups.ratio)
    angle = 0.0 if groups.ratio <= 1 else np.pi / 2
    alike = AtlasGroups(groups.moes_m, groups.moes_l, ratio, angle)
    deflection, thickening = regime_measures(alike, films(alike).minimum)
    return Regime(
        float(deflection),
        float(thickening),
        0.05,
        0.3,
        float(groups.moes_m),
        float(groups.moes_l),
        ratio=ratio,
        angle=angle,
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
        ending=Ending.ACCURATE if converged else Ending.RESIDUAL,
        stop_reason=Ending.ACCURATE.message if converged else "too many iterations",
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
        regime=line_regime(line_groups(0.01, load, 226e9, 0.46, 0.04, 2.2e-8)),
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
    return mesh_cycle_data(
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
        case={"drive": {"kind": "worm", "threads": 3, "hob_swivel": 0.1 + 0.2}, "oil": None},
        solutions=(make_worm_solution(0.25), make_worm_solution(0.75, converged=False)),
        mesh_cycle=make_mesh_cycle(),
        provenance={"pyworm_version": "0.1", "effects": ["elastic"], "tolerances": {"load": 1e-6}},
    )


INLET = 333.15
"""Temperature of the oil at the inlet of heated solutions [K]."""

LEVELS = -0.5 * np.cos(np.pi * np.arange(9) / 8)
"""Places across the film of a profile."""


def with_heat(solution, velocity_1=(4.4, 0.4), velocity_2=(-0.3, -1.1), spin=40.0, traction=0.012):
    """A point contact that slides, with its friction and its heat.

    The surfaces move with these velocities [m/s], body 1 also with a spin [rad/s]. The shear stress is a
    share of the pressure; half its work goes into each surface, and from there only into the depth.
    """
    fields = solution.fields
    x, y = fields["x"].values, fields["y"].values[:, None]
    motions = (velocity_1[0] - spin * y + 0 * x, velocity_1[1] + spin * x + 0 * y), velocity_2
    (u1, v1), (u2, v2) = motions
    sliding = np.hypot(u1 - u2, v1 - v2)
    stress = traction * fields["pressure"].values
    power = stress * sliding
    surfaces = [_flash(x, y[:, 0], power / 2, motion) for motion in motions]
    film = fields["film"].values
    middle = sum(surfaces) / 2 + power * film / (8 * 0.15)
    mobility = film**3 / (12 * 0.227 * np.exp(9.5e-9 * fields["pressure"].values))
    values = {
        "entrainment_x": (u1 + u2) / 2,
        "entrainment_y": (v1 + v2) / 2,
        "sliding_x": u1 - u2,
        "sliding_y": v1 - v2,
        "shear_stress_x": stress * (u2 - u1) / sliding,
        "shear_stress_y": stress * (v2 - v1) / sliding,
        "shear_rate": 2 * sliding / np.maximum(film, 1e-9),
        "friction_power": power,
        "slip": np.where(stress > 0.97 * stress.max(), 1, 0),
        "flow_factor_sliding": 3 * mobility,
        "flow_factor_across": mobility,
        "temperature_body_1": surfaces[0],
        "temperature_body_2": surfaces[1],
        "temperature_middle": middle,
    }
    row, column = np.unravel_index(np.argmax(middle), middle.shape)
    walls = [
        tuple(float(np.broadcast_to(part, middle.shape)[row, column]) for part in motion)
        for motion in motions
    ]
    profile = make_profile(
        (x[column], y[row, 0]),
        walls,
        [surface[row, column] for surface in surfaces],
        middle[row, column],
    )
    cell = (x[1] - x[0]) * (y[1, 0] - y[0, 0])
    figures = _heated_figures(
        solution, stress.sum() * cell / solution.load, power.sum() * cell, values
    )
    changed = describe(fields.assign({name: (("y", "x"), of) for name, of in values.items()}))
    return replace(
        solution, figures=figures, fields=changed, inlet_temperature=INLET, profile=profile
    )


def line_with_heat(solution, velocities=(0.9, 0.1), traction=0.05):
    """The same of a line contact between surfaces of these velocities [m/s]."""
    fields = solution.fields
    x = fields["x"].values
    sliding = velocities[0] - velocities[1]
    stress = traction * fields["pressure"].values
    power = stress * sliding
    spread = np.array([-1e-3, 0.0, 1e-3])
    surfaces = [
        _flash(x, spread, np.tile(power / 2, (3, 1)), (velocity, 0.0))[1] for velocity in velocities
    ]
    film = fields["film"].values
    middle = sum(surfaces) / 2 + power * film / (8 * 0.15)
    values = {
        "entrainment_x": np.full(x.size, sum(velocities) / 2),
        "sliding_x": np.full(x.size, sliding),
        "shear_stress_x": -stress,
        "shear_rate": 2 * sliding / np.maximum(film, 1e-9),
        "friction_power": power,
        "slip": np.zeros(x.size),
        "flow_factor_sliding": film**3,
        "temperature_body_1": surfaces[0],
        "temperature_body_2": surfaces[1],
        "temperature_middle": middle,
    }
    hot = np.argmax(middle)
    walls = [(velocity,) for velocity in velocities]
    profile = make_profile((x[hot],), walls, [part[hot] for part in surfaces], middle[hot])
    step = x[1] - x[0]
    figures = _heated_figures(
        solution, stress.sum() * step / solution.load, power.sum() * step, values
    )
    changed = describe(fields.assign({name: ("x", of) for name, of in values.items()}))
    return replace(
        solution, figures=figures, fields=changed, inlet_temperature=INLET, profile=profile
    )


def make_profile(place, walls, surfaces, middle):
    """Temperature and velocity across the film: a parabola, and a glide between two walls."""
    share = LEVELS + 0.5
    bulge = middle - sum(surfaces) / 2
    temperature = (
        surfaces[0] + (surfaces[1] - surfaces[0]) * share + 4 * bulge * share * (1 - share)
    )
    glide = share + 0.1 * np.sin(2 * pi * share)
    variables = {"profile_temperature": ("level", temperature)}
    for axis, at, first, second in zip("xy"[: len(place)], place, *walls, strict=True):
        variables[f"profile_velocity_{axis}"] = ("level", first + (second - first) * glide)
        variables[f"profile_{axis}"] = float(at)
    return describe(xr.Dataset(variables, coords={"level_position": ("level", LEVELS)}))


def _flash(x, y, heat, motion):
    """Surface temperature [K] behind a heat flux [W/m2], of a half-space of steel that moves under it."""
    u, v = (np.broadcast_to(part, heat.shape) for part in motion)
    speed = np.hypot(u, v)
    reach = 2 * np.hypot(np.ptp(x), np.ptp(y))
    flux = RegularGridInterpolator((y, x), heat, bounds_error=False, fill_value=0.0)
    count = 30
    # evenly spaced in the root of the distance
    places = reach * (np.arange(count) + 0.5) ** 2 / count**2
    rise = np.zeros(heat.shape)
    for place in places:
        before = np.stack([y[:, None] - v / speed * place, x - u / speed * place], axis=-1)
        rise += flux(before) * 2 * np.sqrt(reach) / count
    return INLET + rise / np.sqrt(pi * 7900 * 477 * 47 * speed)


def _heated_figures(solution, friction, power, values):
    body_1, body_2, middle = (
        float(values[f"temperature_{part}"].max()) for part in ("body_1", "body_2", "middle")
    )
    hottest = {
        f"temperature_max_{place}": Estimate(value, 0.01, 0.002, 0.001)
        for place, value in (
            ("body_1", body_1),
            ("body_2", body_2),
            ("film", max(body_1, body_2, middle)),
        )
    }
    return replace(
        solution.figures,
        friction_coefficient=Estimate(float(friction), 0.004, 0.001),
        power_loss=Estimate(float(power), 0.005, 0.001),
        shear_rate_max=Estimate(float(values["shear_rate"].max()), 0.02),
        heat_balance=3e-3,
        **hottest,
    )


def without_heat(solution):
    """The same solution as an isothermal solve leaves it that looked at the shear of the film."""
    names = [f"temperature_{part}" for part in ("body_1", "body_2", "middle")]
    return replace(
        solution,
        figures=replace(
            solution.figures,
            temperature_max_body_1=None,
            temperature_max_body_2=None,
            temperature_max_film=None,
            heat_balance=None,
        ),
        fields=solution.fields.drop_vars(names),
        inlet_temperature=None,
        profile=None,
    )


def make_hot_worm(phase=0.5, **changes):
    """The slender contact of `make_worm_solution`, sliding and hot."""
    return with_heat(make_worm_solution(phase, **changes))
