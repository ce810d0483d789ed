"""Type of lubricant for gears: oil, grease, open-gear compound or solid film, with reasons and limits.

The rules are those of R. Errichello, Lubrication of Gears, part 3, who gives no numbers: "Oil should be used
as the lubricant unless the operating conditions preclude its use." Speeds and temperatures are of the sources
that stand with them.
"""

from dataclasses import dataclass
from typing import Literal

from pyworm.formulas.ranges import within
from pyworm.formulas.unit_factors import ZERO_CELSIUS

SOURCE = "R. Errichello, Lubrication of Gears, part 3; limits of makers"

Enclosure = Literal["oil-tight", "leaking", "open", "vacuum"]
LubricantKind = Literal["oil", "grease", "open-gear compound", "solid film"]

KINDS: tuple[LubricantKind, ...] = ("oil", "grease", "open-gear compound", "solid film")
"""Types, the first that meets the requirements is the choice."""

GREASE_SPEED, GREASE_SLIDING = 6.5, 4.0
"""Pitch line velocity of spur and bevel gears, and sliding velocity of worms, up to which grease does [m/s]
(table of Goang Chyan Gear)."""

COMPOUND_SPEED = 2.5
"""Pitch line velocity up to which adhesive compounds stay on teeth [m/s] (DIN 51509, from memory)."""

LIGHT_LOAD = 0.6e9
"""Maximum contact pressure up to which a load counts as light [Pa]: assumed, a third of what hard steel
bears."""

OIL_RANGE = {
    "mineral": (263.15, 373.15),
    "ester": (258.15, 373.15),
    "PAO": (253.15, 383.15),
    "PAG": (253.15, 383.15),
}
"""Base stock -> temperatures of its oils in operation [K], the upper ones for a short time, 10 K above those
for long (Flender BA 7300)."""

SHORT_TIME = 10.0
"""Kelvin below the upper ones that oils bear for long (Flender BA 7300)."""

GREASE_RANGE = 243.15, 393.15
"""Temperatures of lithium greases [K] (from memory)."""

SOLID_RANGE = 53.15, 505.15
"""Temperatures of bonded films of molybdenum disulphide [K] (Anoplate: -365 to 450 degF)."""


@dataclass(frozen=True)
class TypeConditions:
    """What decides on the type of lubricant."""

    base: str
    """Base stock of the oil."""
    velocity: float
    """Pitch line velocity, or sliding velocity of a worm gear [m/s]."""
    sliding: bool
    """Whether it is a worm gear."""
    coldest: float
    """Lowest temperature at which the gears start [K]."""
    hottest: float
    """Temperature of the sump [K]."""
    enclosure: Enclosure
    """Housing: oil-tight with shaft seals, leaking, none, or vacuum."""
    pressure: float | None = None
    """Maximum, or mean, contact pressure of the teeth [Pa]; None where not known."""

    def __post_init__(self) -> None:
        """Refuse other units."""
        within("velocity", self.velocity, 0, 300, "m/s")
        within("lowest temperature", self.coldest, 4, 800, "K")
        within("sump temperature", self.hottest, 4, 1300, "K")


@dataclass(frozen=True)
class TypeVerdict:
    """Whether a type of lubricant meets the requirements."""

    kind: LubricantKind
    """The type."""
    against: tuple[str, ...]
    """What speaks against it, a clause each; none where it meets the requirements."""
    limits: str
    """What it cannot do, after the source."""

    @property
    def suitable(self) -> bool:
        """Whether it meets the requirements."""
        return not self.against


def type_verdicts(under: TypeConditions) -> tuple[TypeVerdict, ...]:
    """Verdict on every type of lubricant, in the order of preference; the first that suits is the choice."""
    cools = "distributes itself, cools and can be filtered"
    lasting = OIL_RANGE[under.base][1] - SHORT_TIME
    if under.hottest > lasting:
        cools += f"; above {lasting - ZERO_CELSIUS:.0f} degC for a short time only"
    return (
        TypeVerdict("oil", tuple(_against_oil(under)), cools),
        TypeVerdict(
            "grease",
            tuple(_against_grease(under)),
            "boundary lubrication, poor coolant, keeps wear particles in the mesh",
        ),
        TypeVerdict(
            "open-gear compound",
            tuple(_against_compound(under)),
            "boundary lubrication, is pushed into the roots, costly and messy to maintain",
        ),
        TypeVerdict(
            "solid film",
            tuple(_against_solid(under)),
            "limited wear life, expensive to apply, no cooling",
        ),
    )


def _outside(under: TypeConditions, least: float, most: float) -> list[str]:
    """Where the temperatures leave a range."""
    words = []
    if under.coldest < least:
        words.append(
            f"starts at {under.coldest - ZERO_CELSIUS:.0f} degC, colder than {least - ZERO_CELSIUS:.0f} degC"
        )
    if under.hottest > most:
        words.append(
            f"sump of {under.hottest - ZERO_CELSIUS:.0f} degC, hotter than {most - ZERO_CELSIUS:.0f} degC"
        )
    return words


def _against_oil(under: TypeConditions) -> list[str]:
    words = _outside(under, *OIL_RANGE[under.base])
    if under.enclosure != "oil-tight":
        return [f"the enclosure is not oil-tight ({under.enclosure})", *words]
    return words


def _against_grease(under: TypeConditions) -> list[str]:
    words = _outside(under, *GREASE_RANGE)
    limit = GREASE_SLIDING if under.sliding else GREASE_SPEED
    if under.velocity > limit:
        words.insert(0, f"{under.velocity:.3g} m/s is above {limit:g} m/s: it is thrown off")
    if under.pressure is not None and under.pressure > LIGHT_LOAD:
        words.append(
            f"{under.pressure / 1e6:.0f} MPa is no light load (above {LIGHT_LOAD / 1e6:.0f} MPa)"
        )
    if under.enclosure in ("open", "vacuum"):
        words.append(f"no enclosure keeps it at the teeth ({under.enclosure})")
    return words


def _against_compound(under: TypeConditions) -> list[str]:
    words = _outside(under, *GREASE_RANGE)
    if under.enclosure != "open":
        words.insert(0, f"meant for open gears (here: {under.enclosure})")
    if under.sliding:
        words.append("the sliding of a worm gear pushes it off the flanks")
    if under.velocity > COMPOUND_SPEED:
        words.append(f"{under.velocity:.3g} m/s is above {COMPOUND_SPEED:g} m/s: it is thrown off")
    return words


def _against_solid(under: TypeConditions) -> list[str]:
    words = _outside(under, *SOLID_RANGE)
    leakage = under.enclosure in ("leaking", "vacuum")
    cold, hot = GREASE_RANGE
    if not (leakage or under.coldest < cold or under.hottest > hot):
        words.append("only where temperatures, leakage or vacuum preclude oil and grease")
    return words
