"""Load impulses, a start-stop and a reversal of lines against theories that need no solver of films.

Rigid cylinders roll and squeeze oil of constant viscosity: Reynolds' equation by quadrature, with rupture
where pressure and its slope vanish, and the load that the film carries give its rate of change. The quantity
of C. J. Hooke (1992, doi 10.1243/PIME_PROC_1992_206_136_02), the least film while entrainment turns round,
follows.

Elastic lines with piezoviscous oil: Grubin's inlet with squeeze and an edge that moves as the load changes,
and its film carried on with the surfaces. That is our derivation, by the mechanism of C. J. Hooke and G. E.
Morales-Espejel (2016, Journal of Tribology 138, 031501: load changes Hertz's width and so the effective
entrainment, and the inlet's films are transported through the contact) and of A. Felix-Quinonez and
Morales-Espejel (2010, Proc. IMechE C 224, 2559-2567: an inlet with squeeze and the edge's motion). Their
abstracts were read, not their tables.

Under a load that swings film thickness has waves along the contact. By Y. H. Wijnant and C. H. Venner (1999,
Contact dynamics of starved elastohydrodynamic lubrication, in Lubrication at the Frontier, Elsevier;
abstract, of starved circular contacts) they run at the dimensionless speed one, that of the oil, and so are
2 pi / Omega long, Omega the frequency times the contact's half-width over that speed.
Run from the repository's root (a minute):

    python benchmarks/validation/transients.py [docs/pictures/transients.png]
"""

import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from math import atan, pi, sin, sqrt, tan
from pathlib import Path
from unittest.mock import patch

import matplotlib.pyplot as plt
import numpy as np
import scipy
from line import ALPHA, ETA0, OILS, RADIUS, line

import pyworm
from pyworm.formulas.arrays import Array
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.scales import line_scales
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import TimeIntegration, integrate_in_time

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

Factor = Callable[[float], float]
"""Time, in transits of the contact at the beginning, to speed or load over that at the beginning."""

NODES, WEIGHTS = np.polynomial.legendre.leggauss(300)

M, L = 20.0, 10.0
"""The elastic line, with an incompressible oil of Barus: its largest pressure is 18 times 1 / alpha."""

RIGID = LineScene(
    name="rigid line",
    gap=Parabola(0.02),
    radius=0.02,
    velocities=(1.0, 1.0),
    load=3000.0,
    bodies=(Body(1.4e12, 0.3), Body(1.4e12, 0.3)),
    oil=Oil(Barus(0.09, 1e-12), Density.incompressible(850.0)),
)
"""A line that its pressure flattens by some thousandth of its film."""

MILLISECOND = 1e-3
"""The unit of time of the rigid line, in which oil passes three lengths of its film's parabola [s]."""

RIGID_STEPS = 4
"""Time steps in which oil passes its width by Hertz, a hundredth of the length of its film."""

PERIODS = (2.0, 1.0, 0.5)
"""Periods in which the load of the elastic line swings [transits]."""

SWUNG, SETTLING, INNER = 3, 3.0, 0.7
"""Periods that are evaluated, transits before them, and part of the contact's half-width within which."""

ENDLESS = 0.03
"""Half a window beyond which rigid films bear no pressure [m]."""


@dataclass(frozen=True)
class Transient:
    """A transient film."""

    times: Array
    """Times, in transits, of the rigid line in milliseconds."""
    solved: Array
    """Its central film by the transient solve: of the elastic line over that before anything changes, of the
    rigid line in metres."""
    theory: Array
    """Its central film by the theory, likewise."""
    steady: Array
    """The theory's steady film of each time, likewise."""


def bump(part: float, begin: float, width: float) -> Factor:
    """One, and between two times a wave of sin^2 on it that goes up (or down) by a part."""
    return lambda time: (
        1 + part * sin(pi * (time - begin) / width) ** 2 if begin < time < begin + width else 1.0
    )


def swing(period: float) -> Factor:
    """One, and a tenth up and down with a period."""
    return lambda time: 1 + 0.1 * sin(2 * pi * time / period)


def constant(time: float) -> float:
    """A speed or a load that stays."""
    return 1.0


def turning(time: float) -> float:
    """A speed that goes from one direction to the other between 1 and 3 ms."""
    return float(np.interp(time, (1.0, 3.0), (1.0, -1.0)))


def solved(
    scene: LineScene, unit: float, duration: float, speed: Factor, load: Factor, kinks, refinement
) -> tuple[Array, Array]:
    """Times, in a unit [s], and central films [m] of a line by one transient solve."""
    found = integrated(scene, unit, duration, speed, load, kinks, refinement)
    times = np.array([one.seconds for one in found.records]) / unit
    return times, np.array([one.figures["film_central"] for one in found.records])


def integrated(
    scene: LineScene, unit: float, duration: float, speed: Factor, load: Factor, kinks, refinement
) -> TimeIntegration:
    """One transient solve of a line whose speed and load change with time, in a unit [s]."""

    def contact(seconds: float) -> LineScene:
        velocity = scene.entrainment * speed(seconds / unit)
        return replace(
            scene, velocities=(velocity, velocity), load=scene.load * load(seconds / unit)
        )

    end = duration * unit
    life = Life(end, contact, kinks=tuple(kink * unit for kink in kinks))
    present = replace(contact(end), past=Past(life, end))
    plan = pyworm.plan(present, 0.05, ("isothermal", "squeeze"), ("film",))
    found = integrate_in_time(time_grid_of(life, plan), refinement, 0.0, [0.95 * end])
    if found.failure is not None:
        raise RuntimeError(found.failure)
    return found


def inlet_rate(film: float, half_width: float, widening: float, speed: float) -> float:
    """Rate of change [m/s] of the film at the edge of Hertz's contact, by its inlet.

    With X the distance from the centre over the half-width a, g Hertz's gap, whose change with a is
    -(a/R) arccosh X, and no flow by pressure at the edge, where it is high,

        h^3 q' / 12 eta = u g - a h_t (X - 1) + (a^2 a_t / R) (X arccosh X - sqrt(X^2 - 1)),

    and the reduced pressure q rises to 1 / alpha at the edge (Grubin): linear in the rate h_t.

    Args:
        film, half_width: Film at the edge and Hertz's half-width [m].
        widening, speed: Rate of change of the half-width, and mean speed of the surfaces [m/s].
    """
    end = np.arccosh(4.0)
    angle = end * (1 + NODES) / 2
    x, root = np.cosh(angle), np.sinh(angle)
    gap = half_width**2 / (2 * RADIUS) * (x * root - angle)
    each = 12 * ETA0 * half_width * (end / 2 * WEIGHTS * root) / (film + gap) ** 3
    moved = half_width**2 * widening / RADIUS * (x * angle - root)
    return float((each @ (speed * gap + moved) - 1 / ALPHA) / (each @ (half_width * (x - 1))))


def inlet_steady(half_width: float, speed: float) -> float:
    """Grubin's film [m] at a half-width [m] and a speed [m/s]."""
    return scipy.optimize.brentq(
        lambda film: inlet_rate(film, half_width, 0.0, speed), 1e-9, 1e-4, xtol=1e-13
    )


def elastic(duration: float, speed: Factor, load: Factor, kinks, refinement=1) -> Transient:
    """The elastic line in motion for some transits."""
    scene = line(M, L, OILS["incompressible"])
    first, fast = line_scales(scene).hertz.half_width, scene.entrainment
    transit = 2 * first / fast
    times, films = solved(scene, transit, duration, speed, load, kinks, refinement)
    fine = np.linspace(0, duration, 4001)
    widths = np.array([first * sqrt(load(time)) for time in fine])
    speeds = np.array([fast * speed(time) for time in fine])
    at_edge = scipy.integrate.solve_ivp(
        lambda time, film: (
            transit
            * inlet_rate(
                film[0],
                np.interp(time, fine, widths),
                np.interp(time, fine, np.gradient(widths, fine)) / transit,
                fast * speed(time),
            )
        ),
        (0, duration),
        [inlet_steady(first, fast * speed(0))],
        method="LSODA",
        rtol=1e-6,
        atol=1e-12,
        max_step=0.02,
        dense_output=True,
    ).sol
    way = scipy.integrate.cumulative_trapezoid(speeds, fine, initial=0) * transit
    # oil is in the centre when it has gone as far as the edge was away when it came in
    entries = np.interp(np.interp(times, fine, way), way + widths, fine, left=0)
    theory = np.array([at_edge(time)[0] for time in entries])
    steady = np.array(
        [inlet_steady(first * sqrt(load(time)), fast * speed(time)) for time in times]
    )
    settled = np.interp(0.95 * min(kinks), times, films)
    return Transient(times, films / settled, theory / theory[0], steady / theory[0])


def rigid_rate(film: float, load: float, speed: float) -> float:
    """Rate of change [m/s] of a rigid film [m] that carries a load for each length [N/m] at a speed [m/s].

    With H = h + x^2 / 2R the pressure's slope is 12 eta (u H + h_t x - c) / H^3; c and h_t follow from the
    load and pressure that is zero at both ends, or at the inlet and, with its slope, where the film ruptures.
    """
    speed, size = abs(speed), sqrt(2 * RIGID.radius * film)
    low = -atan(ENDLESS / size)

    def before(end: float) -> tuple[Array, Array, Array]:
        angle = low + (end - low) * (1 + NODES) / 2
        x = size * np.tan(angle)
        height = film + x**2 / (2 * RIGID.radius)
        width = WEIGHTS * (end - low) / 2 * size / np.cos(angle) ** 2
        return x, height, 12 * RIGID.oil.viscosity.eta0 * width / height**3

    def ruptured(end: float) -> tuple[float, float]:
        x, height, each = before(end)
        place = size * tan(end)
        wedge, apart = height - film - place**2 / (2 * RIGID.radius), x - place
        rate = -speed * (each @ wedge) / (each @ apart)
        return rate, -(each * x) @ (speed * wedge + rate * apart) - load

    x, height, each = before(-low)
    matrix = np.array([[each @ x, -each.sum()], [-(each * x) @ x, each @ x]])
    known = [-speed * (each @ height), load + speed * ((each * x) @ height)]
    rate, flow = np.linalg.solve(matrix, known)
    if speed * (film + ENDLESS**2 / (2 * RIGID.radius)) + rate * ENDLESS <= flow:
        return float(rate)  # pressure up to the end
    ends = -low * np.linspace(-0.99, 1, 60)
    excess = [ruptured(end)[1] for end in ends]
    (first,) = np.flatnonzero(np.diff(np.sign(excess)))
    exit_place = scipy.optimize.brentq(lambda end: ruptured(end)[1], ends[first], ends[first + 1])
    return ruptured(exit_place)[0]


@cache  # of most times of a course load and speed are the same
def rigid_steady(load: float, speed: float) -> float:
    """The film [m] of the rigid line under a load [N/m] at a speed [m/s] (Martin)."""
    return scipy.optimize.brentq(lambda film: rigid_rate(film, load, speed), 1e-8, 1e-4, xtol=1e-13)


def rigid(duration: float, speed: Factor, load: Factor, kinks) -> Transient:
    """The rigid line in motion for some milliseconds."""
    with patch.dict(STEPS_A_TRANSIT, line=RIGID_STEPS):
        times, films = solved(RIGID, MILLISECOND, duration, speed, load, kinks, 0)
    theory = scipy.integrate.solve_ivp(
        lambda time, film: MILLISECOND * rigid_rate(film[0], RIGID.load * load(time), speed(time)),
        (0, duration),
        [rigid_steady(RIGID.load * load(0), speed(0))],
        rtol=1e-5,
        atol=1e-12,
        max_step=duration / 60,
        dense_output=True,
    ).sol(times)[0]
    steady = [
        rigid_steady(RIGID.load * load(time), speed(time)) if abs(speed(time)) > 0.01 else np.nan
        for time in times
    ]
    return Transient(times, films, theory, np.array(steady))


def clearance(least: float, acceleration: float) -> float:
    """C of a least film h = C (eta^2 A)^(2/3) R^(5/3) / w^(4/3) [m] while entrainment turns with A [m/s^2].

    Of the variables of a rigid line no other length can be made.
    """
    eta, radius = RIGID.oil.viscosity.eta0, RIGID.radius
    return least * RIGID.load ** (4 / 3) / ((eta**2 * acceleration) ** (2 / 3) * radius ** (5 / 3))


COURSES: dict[str, Callable[[], Transient]] = {
    "rigid, load impulse": partial(rigid, 3.5, constant, bump(4.0, 1.0, 1.0), (1.0, 2.0)),
    "rigid, reversal": partial(rigid, 4.0, turning, constant, (1.0, 3.0)),
    "elastic, small load impulse": partial(elastic, 4.0, constant, bump(0.1, 1.0, 1.0), (1.0, 2.0)),
    "elastic, load doubled": partial(elastic, 5.0, constant, bump(1.0, 1.0, 2.0), (1.0, 3.0)),
    "elastic, load doubled fast": partial(elastic, 4.0, constant, bump(1.0, 1.0, 1.0), (1.0, 2.0)),
    "elastic, stop and start": partial(elastic, 7.0, bump(-0.9, 1.0, 3.0), constant, (1.0, 4.0)),
}
"""Name -> what happens: loads times 5, 1.1, 2; speeds to a tenth and back, or turned round."""


@dataclass(frozen=True)
class Waves:
    """Film thickness along a contact whose load swings."""

    speed: float
    """Speed of its waves over the mean one of the surfaces [-]."""
    length: float
    """Their length [half-widths]."""
    published: float
    """2 pi / Omega [half-widths]."""
    least: float
    """Least amplitude along the contact, over the film [-]."""
    largest: float
    """Largest amplitude along the contact, over the film [-]."""


def waves(period: float, refinement: int = 1) -> Waves:
    """Waves of the film of the elastic line under a load that swings with a period [transits]."""
    scene = line(M, L, OILS["incompressible"])
    half_width, end = line_scales(scene).hertz.half_width, SWUNG * period + SETTLING
    transit = 2 * half_width / scene.entrainment
    found = integrated(scene, transit, end, constant, swing(period), (0.0,), refinement)
    framed = [one for one in found.records if one.frame is not None]
    times = np.array([one.seconds for one in framed]) / transit
    some = times > times[-1] - SWUNG * period
    x = np.linspace(-INNER, INNER, 57)
    films = np.array(
        [
            np.interp(x * half_width, one.frame.places[0], one.frame.film)
            for one, taken in zip(framed, some, strict=True)
            if taken
        ]
    )
    angles = 2 * pi * times[some] / period
    parts = np.stack([np.cos(angles), np.sin(angles), np.ones_like(angles)], axis=1)
    (even, odd, mean), *_ = np.linalg.lstsq(parts, films)
    wave = even - 1j * odd
    number = -np.polyfit(x, np.unwrap(np.angle(wave)), 1)[
        0
    ]  # positive of waves that go with the oil
    frequency = pi / period  # a transit is two half-widths
    sizes = np.abs(wave) / mean
    return Waves(frequency / number, 2 * pi / number, 2 * pi / frequency, sizes.min(), sizes.max())


def compared(name: str, found: Transient) -> list[tuple[str, ...]]:
    """Extremes of a transient film beside those of the theory, and its deviations from it."""
    difference = found.solved - found.theory
    unit = 1e-6 if name.startswith("rigid") else 1.0
    deviations = (
        f"{np.sqrt(np.mean(difference**2)) / np.ptp(found.theory) * 100:.1f} %",
        f"{np.max(np.abs(difference / found.theory)) * 100:.1f} %",
    )
    return [
        (name, label, *(f"{at(of) / unit:.3f}" for of in (found.solved, found.theory)), *deviations)
        for label, at in (("largest", np.max), ("smallest", np.min))
    ]


def draw(time_grids: dict[str, Transient], path: str) -> None:
    """Save curves of all courses as a picture."""
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.5), layout="constrained")
    for ax, (name, time_grid) in zip(axes.flat, time_grids.items(), strict=True):
        unit = 1e-6 if name.startswith("rigid") else 1.0
        ax.plot(
            time_grid.times, time_grid.steady / unit, color="0.7", label="steady film thickness"
        )
        ax.plot(time_grid.times, time_grid.theory / unit, "k--", label="theory")
        ax.plot(time_grid.times, time_grid.solved / unit, "C0", label="transient solution")
        ax.set_title(name)
        ax.set_xlabel("time / ms" if unit < 1 else "time / transits")
        ax.set_ylabel("film thickness / µm" if unit < 1 else "central film thickness / initial")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    figure.savefig(path, dpi=110)


def main() -> None:
    """Compare all courses, and draw them if a picture is named."""
    found = {name: run() for name, run in COURSES.items()}
    rows = [row for name, one in found.items() for row in compared(name, one)]
    deviations = "rms deviation / range", "largest deviation / film"
    record("line_transients", ("transient", "extreme", "solved", "theory", *deviations), rows)
    turned = found["rigid, reversal"]
    for label, films in (("solved", turned.solved), ("theory", turned.theory)):
        print(f"h_min while entrainment turns, {label}: C = {clearance(min(films), 1e3):.3f}")
    swings = []
    for period in PERIODS:
        of = waves(period)
        size = f"{of.least * 100:.2f} to {of.largest * 100:.2f} %"
        swings.append(
            (f"{period:g}", f"{of.length:.4f}", f"{of.published:g}", f"{of.speed:.4f}", size)
        )
    columns = "period / transits", "wavelength / b", "published", "speed / that of the oil"
    record("load_swings", (*columns, "amplitude / film"), swings)
    if sys.argv[1:]:
        draw(found, sys.argv[1])


if __name__ == "__main__":
    main()
