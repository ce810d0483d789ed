"""Checks whether a contact is possible and usual, before anything is solved.

A contact that no bodies or no film could make is refused: the equations would be solved all the same, and
their answer would be an answer to nothing.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from pyworm.formulas.film import radii_at_angle
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.input_error import CaseError
from pyworm.materials.body import Body
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales, scales

BEARABLE_PRESSURES = (
    (150e9, "hard steel", 4e9, 1 / 20),
    (30e9, "bronze, cast iron and light metals", 1e9, 1 / 20),
    (0.5e9, "polymers", 0.15e9, 1 / 10),
    (0.0, "rubber", 5e6, 1 / 4),
)
"""Least modulus of a class of materials [Pa], its name, the Hertz pressure that it bears as a rule [Pa], and
the fraction of its modulus that none bears.

A point contact yields first at 1.6 times the yield stress, and the hardness is some 2.8 times that (Johnson,
Contact Mechanics, 1985, sections 4.2 and 6.3): at 4 GPa of bearing steel, as in ISO 76, at 1 GPa of a bronze
of 180 HB. At a twentieth of its modulus the mean pressure is the hardness of the hardest steel; rubber does
not yield, but at a quarter the contact is as large as the radius."""

MAX_PRESSURE_RATIO = 1 / 4
"""Hertz pressure over the modulus of the softer body beyond which a contact is wide as its radius: a
half-width over the radius is 4 p / E' of a line contact and pi p / E' of a point contact (Johnson, eqs 4.22,
4.24, 4.43 and 4.45). Model contacts of given Moes parameters stay below, real ones far below."""

THICK = 1 / 20
"""Film over the radius along the entrainment from which a film is reported as thick; thin-film theory takes
it as small, and beyond 1 the surfaces do not make a contact."""

MIN_PRESSURE_RATIO = 1 / 4000
"""Hertz pressure over the reduced modulus below which a contact is reported as light: 57 MPa of steel on
steel, where gears and bearings bear some hundred and more."""

MOLECULE = 1e-9
"""Thickness of a few molecules of oil [m], below which a film is no fluid."""


HOTTEST_FILM = 300.0
"""Temperature [degC] from which the molecules of oils break within hours; flashes of microseconds may pass
it, but no law of viscosity was measured there (from memory; makers say 250 to 350)."""


class UnusualWarning(UserWarning):
    """A value or a contact that may be meant, but is mostly a slip of a unit."""


@dataclass(frozen=True)
class Doubt:
    """An objection to a contact."""

    quantity: str
    """The quantity in doubt."""
    excess: float
    """How far it is beyond what is usual [-]; above 1."""
    possible: bool
    """Whether real bodies may make it all the same."""
    conceivable: bool
    """Whether a model contact, of given dimensionless groups, may have it."""
    sentence: str
    """The sentence without its key."""


def require_possible(scene: Scene | LineScene, key: str) -> None:
    """Refuse a contact, by the key that loads it, with a pressure or film beyond all bodies (CaseError)."""
    _refuse((doubt for doubt in _judged(scene) if not doubt.possible), key)


def require_conceivable(scene: Scene | LineScene, key: str) -> None:
    """Refuse a contact beyond even a model's bodies, which bear more than real ones (CaseError)."""
    _refuse((doubt for doubt in _judged(scene) if not doubt.conceivable), key)


def _refuse(doubts: Iterator[Doubt], key: str) -> None:
    for doubt in doubts:
        raise CaseError(f"{key}: {doubt.sentence}; check their units")


def doubts(scenes: Iterable[Scene | LineScene], key: str) -> tuple[str, ...]:
    """A sentence for each quantity that is unusual in contacts, of the worst of them; arguments as above."""
    worst: dict[str, Doubt] = {}
    for scene in scenes:
        for doubt in _judged(scene):
            if doubt.quantity not in worst or doubt.excess > worst[doubt.quantity].excess:
                worst[doubt.quantity] = doubt
    return tuple(f"{key}: {doubt.sentence}" for doubt in worst.values())


def overheated(summaries: Iterable[Mapping[str, Any]]) -> tuple[str, ...]:
    """The warning about a film temperature, in summaries of contacts, beyond what oils withstand."""
    hot = [summary for summary in summaries if "temperature_max_C" in summary]
    hottest = max(hot, key=lambda summary: summary["temperature_max_C"]["film"], default=None)
    if hottest is None or not hottest["temperature_max_C"]["film"] > HOTTEST_FILM:
        return ()
    reached = hottest["temperature_max_C"]["film"]
    return (
        f"{hottest['name']}: the film reaches {reached:.0f} degC; oils break from {HOTTEST_FILM:.0f} degC "
        "on, and their laws are extrapolated there",
    )


def _judged(scene: Scene | LineScene) -> Iterator[Doubt]:
    """Doubts about a contact; none where it has no scales, which planning refuses with the reason."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            pressure, film, radius = _sizes(scene)
    except (ValueError, ArithmeticError):
        return
    where = str(ContactIndex.of(scene))
    where = f" at {where}" if where else ""
    yield from _of_pressure(scene, pressure, where)
    yield from _of_hardness(scene, pressure, where)
    if film > THICK * radius:
        possible = film <= radius
        yield Doubt(
            "film",
            film / (THICK * radius),
            possible,
            possible,
            f"a film of {film * 1e3:.3g} mm is expected{where} between surfaces of a radius of "
            f"{radius * 1e3:.3g} mm; "
            + ("films are thin against it as a rule" if possible else _DISPROPORTION),
        )
    elif pressure < MIN_PRESSURE_RATIO * scene.reduced_modulus:
        yield Doubt(
            "lightness",
            MIN_PRESSURE_RATIO * scene.reduced_modulus / pressure,
            True,
            True,
            f"the bodies are pressed together with {pressure / 1e6:.3g} MPa only by Hertz{where}, where the "
            f"radii are {_radii(scene)}; "
            f"from {MIN_PRESSURE_RATIO * scene.reduced_modulus / 1e6:.0f} MPa on as a rule",
        )
    if film < MOLECULE:
        yield Doubt(
            "molecules",
            MOLECULE / film,
            True,
            True,
            f"a film of {film * 1e9:.2g} nm is expected{where}; below 1 nm, a few molecules, oil is no fluid",
        )


def beyond_limits(names: Iterable[str], bodies: Iterable[Body]) -> tuple[str, ...]:
    """A sentence for each body that is hotter in bulk than its material bears in continuous use."""
    pairs = zip(names, bodies, strict=True)
    return tuple(
        sentence for name, body in pairs if (sentence := _beyond_limit(name, body)) is not None
    )


def _beyond_limit(name: str, body: Body) -> str | None:
    bulk, limit = body.bulk_temperature, body.temperature_limit
    if bulk is None or limit is None or bulk <= limit:
        return None
    return (
        f"The {name} has a bulk temperature of {bulk - ZERO_CELSIUS:.0f} °C, above the "
        f"{limit - ZERO_CELSIUS:.0f} °C that its material bears in continuous use."
    )


_DISPROPORTION = "they make no contact, load, speed and viscosity do not fit each other"


def _radii(scene: Scene | LineScene) -> str:
    return " and ".join(f"{radius:.4g} m" for radius in scene.radii_along)


def _sizes(scene: Scene | LineScene) -> tuple[float, float, float]:
    """Hertz's largest pressure [Pa], the expected film and the radius along the entrainment [m]."""
    if isinstance(scene, LineScene):
        of_line = line_scales(scene)
        return of_line.hertz.pressure_max, of_line.film, scene.radius
    expected = scales(scene)
    along, _ = radii_at_angle(*scene.radii, expected.angle)
    return expected.hertz.pressure_max, expected.film, float(along)


def _of_pressure(scene: Scene | LineScene, pressure: float, where: str) -> Iterator[Doubt]:
    softer = min(body.youngs_modulus for body in scene.bodies)
    name, usual, fraction = next(row[1:] for row in BEARABLE_PRESSURES if softer >= row[0])
    if pressure <= usual:
        return
    possible = pressure <= fraction * softer
    sentence = f"the bodies are pressed together with {pressure / 1e9:.3g} GPa by Hertz{where}"
    if possible:
        sentence += (
            f"; {name} (the softer body has a modulus of {softer / 1e9:.3g} GPa) bear up to "
            f"{usual / 1e9:g} GPa as a rule"
        )
    else:
        sentence += (
            f"; nothing with a modulus of {softer / 1e9:.3g} GPa, as the softer body has, bears more than "
            f"{fraction * softer / 1e9:.3g} GPa"
        )
    conceivable = pressure <= MAX_PRESSURE_RATIO * softer
    yield Doubt("pressure", pressure / usual, possible, conceivable, sentence)


def _of_hardness(scene: Scene | LineScene, pressure: float, where: str) -> Iterator[Doubt]:
    """A doubt where the softer body yields as a whole, and its asperities could not bear the load.

    Below two thirds of Hertz's largest pressure, the mean one of a point contact, even a dry contact of any
    film's thickness would not balance the load.
    """
    yielding = [body.hardness for body in scene.bodies if body.hardness is not None]
    if not yielding or pressure <= min(yielding):
        return
    softer = min(yielding)
    possible = 2 / 3 * pressure <= softer
    yield Doubt(
        "hardness",
        pressure / softer,
        possible,
        possible,
        f"the bodies are pressed together with {pressure / 1e9:.3g} GPa by Hertz{where}, more than the "
        f"hardness of {softer / 1e9:.3g} GPa of the softer body: it yields as a whole, not in its "
        "asperities alone",
    )
