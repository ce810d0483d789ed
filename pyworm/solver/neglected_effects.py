"""Effects left out of the figures of a contact, and the regime of lubrication.

Tables, pages, pictures and JSON objects take their words and numbers from here. Error bars are numerical and
include none of these effects.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import inf, sqrt
from typing import Any, Self

from pyworm.formulas.lubrication import BY_SEVERITY, Lubrication, full_film_roughness, lubrication
from pyworm.formulas.rough_contact import RQ_OVER_RA
from pyworm.io.number_with_unit import parse_in
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.materials.solids import usual_roughness
from pyworm.planning.effects.judgement import Judgement
from pyworm.planning.plan import Plan
from pyworm.planning.prediction import predicted
from pyworm.scene.any_contact import AnyContact

MAX_SHOWN_INFLUENCE = 1.0
"""Influence as large as the figure itself, the largest that is shown."""

LAMBDAS = ("lambda_central", "lambda_min")
"""Central and least film over composite roughness."""

ROUGHNESS_REGIMES = ("mixed", "boundary")
"""Regimes in which roughness carries load."""

ASPERITY_SHARE, ASPERITY_SHARE_MODEL_ERROR = (
    "asperity_load_fraction",
    "asperity_load_fraction_model_error",
)
"""Share of the load that asperities carry, and its relative uncertainty by the model of roughness."""

MIXED_ABOVE = "mixed_above_roughness_m"
"""Composite roughness above which lubrication would be mixed, where no roughness is given."""

USUAL = "ground"
"""Finish whose usual roughness is shown beside it."""

AS_IF_SMOOTH = "smooth surfaces"
"""Qualifier of friction, loss and efficiency where roughness carries load."""


@dataclass(frozen=True)
class NeglectedEffects:
    """Effects left out of the figures of a contact, or of the worst of several, and its lubrication."""

    influence: dict[str, float] = field(default_factory=dict)
    """Effects that are off though they may change what is asked for by more than the accuracy: name ->
    largest influence over the quantities asked for [-], at most `MAX_SHOWN_INFLUENCE`; the largest first."""
    lubrication: Lubrication = "unknown"
    """Lubrication: "full", "mixed", "boundary" or "unknown"."""
    lambda_central: float | None = None
    """Central film over composite roughness [-]; None where film or roughness is not known."""
    lambda_min: float | None = None
    """Least film over composite roughness [-]; None where film or roughness is not known."""
    contacts: int = 1
    """Number of contacts of which this is the worst."""
    rough: bool = False
    """Whether roughness is simulated."""
    asperity_load_fraction: float | None = None
    """Share of the load that asperities carry; None where it is not simulated, or not known yet."""
    asperity_load_fraction_model_error: float | None = None
    """Its relative uncertainty by the model of roughness; None likewise."""
    mixed_above_roughness_m: float | None = None
    """Composite roughness [m] of mixed lubrication; None where it is given, or the film not known."""
    by_formula: bool = False
    """Whether films are those of closed forms, beside which nothing is simulated."""

    @property
    def as_if_smooth(self) -> bool:
        """Whether roughness carries load in a simulation without it: friction and loss are `AS_IF_SMOOTH`."""
        return self.lubrication in ROUGHNESS_REGIMES and not self.rough and not self.by_formula

    @property
    def words(self) -> str:
        """The effects in words, such as "neglected: roughness up to 53 %"; empty without any."""
        effects = ", ".join(
            f"{name} {_up_to(fraction)}" for name, fraction in self.influence.items()
        )
        return f"neglected: {effects}" if effects else ""

    @property
    def note(self) -> str:
        """The effects in words, for pictures and tables with error bars."""
        kinds = "numerical, and of the roughness model" if self.rough else "numerical"
        return f"{self.words}; uncertainties: {kinds}" if self.words else ""

    @property
    def sentence(self) -> str:
        """The regime of lubrication in one sentence, or why it is not judged; empty of separated surfaces."""
        if self.mixed_above_roughness_m is not None:
            return self._not_judged
        if self.lubrication not in ROUGHNESS_REGIMES:
            return ""
        which = "This contact" if self.contacts == 1 else f"The worst of {self.contacts} contacts"
        if self.by_formula:
            end = ", by closed forms"
        else:
            end = self._carried if self.rough else ", with smooth surfaces assumed"
        central, thin, roughness = (
            QUANTITIES[name].words() for name in ("film_central", "film_min", "composite_roughness")
        )
        return (
            f"{which} runs in {self.lubrication} lubrication ({central} {self.lambda_central:.2g}, "
            f"{thin} {self.lambda_min:.2g} times the {roughness}){end}."
        )

    @property
    def _not_judged(self) -> str:
        """What is not known without a roughness, and which one would matter, in words."""
        in_contacts = "" if self.contacts == 1 else f" in the worst of {self.contacts} contacts"
        usual, _ = parse_in(usual_roughness(USUAL), "um")
        above = present(self.mixed_above_roughness_m, "roughness")
        return (
            "Roughness is not given: smooth surfaces are assumed, and the lubrication regime is not judged. "
            f"Above a composite roughness of {above * 1e6:.2g} µm (Rq) it would be "
            f"mixed{in_contacts}; two {USUAL} surfaces of Ra {usual:.2g} µm have "
            f"{sqrt(2) * RQ_OVER_RA * usual:.2g} µm."
        )

    @property
    def _carried(self) -> str:
        """The asperities' share of the load in words, with its uncertainty; empty where it is not known."""
        share, error = self.asperity_load_fraction, self.asperity_load_fraction_model_error
        if share is None:
            return ""
        bar = "" if error is None else f" ± {share * error * 100:.2g} % (model)"
        return f"; asperities carry {share * 100:.2g} %{bar} of the load"

    def qualified(self, name: str) -> str:
        """The name of a friction, loss or efficiency, with what it leaves out."""
        return f"{name}, {AS_IF_SMOOTH}" if self.as_if_smooth else name

    def titled(self, title: str) -> str:
        """The title of a table with error bars, and below it the effects left out."""
        return f"{title}\n{self.note}" if self.note else title

    @classmethod
    def read(cls, summary: Mapping[str, Any]) -> Self:
        """Read from the object that `summary` made."""
        given = {
            name: summary[name]
            for name in (*LAMBDAS, ASPERITY_SHARE, ASPERITY_SHARE_MODEL_ERROR, MIXED_ABOVE)
            if name in summary
        }
        return cls(
            dict(summary["left_out"]),
            summary["lubrication"],
            rough=ASPERITY_SHARE in given,
            **given,
        )

    def summary(self) -> dict[str, Any]:
        """Influences and lubrication as an object for JSON; without a roughness that of a full film."""
        known = {name: getattr(self, name) for name in (*LAMBDAS, MIXED_ABOVE)}
        return {
            "left_out": self.influence,
            "lubrication": self.lubrication,
            **{name: value for name, value in known.items() if value is not None},
        }


def beyond(effects: Iterable[Judgement], accuracy: float) -> dict[str, float]:
    """Effects that are off, with an influence larger than an accuracy, as `NeglectedEffects.influence`."""
    largest = {
        effect.name: min(max(effect.influence.values(), default=0.0), MAX_SHOWN_INFLUENCE)
        for effect in effects
        if not effect.on
    }
    return _largest_first(
        {name: fraction for name, fraction in largest.items() if fraction > accuracy}
    )


def judged(
    effects: Sequence[Judgement],
    accuracy: float,
    films: Sequence[float],
    roughness: float | None,
    asperity_load: tuple[float | None, float | None] = (None, None),
) -> NeglectedEffects:
    """Judge the effects left out of a contact and its lubrication.

    By central and minimum film [m], empty where they may not be trusted, composite roughness [m], and, where
    they are solved, the share of the load on asperities and its relative uncertainty.
    """
    central, least = None, None
    if roughness and films:
        central, least = (film / roughness for film in films)
    share, uncertainty = asperity_load
    return NeglectedEffects(
        beyond(effects, accuracy),
        lubrication(central, least, share),
        central,
        least,
        rough=any(effect.on for effect in effects if effect.name == "roughness"),
        asperity_load_fraction=share,
        asperity_load_fraction_model_error=uncertainty,
        mixed_above_roughness_m=full_film_roughness(*films)
        if films and roughness is None
        else None,
    )


def expected(scene: AnyContact, plan: Plan) -> NeglectedEffects:
    """Effects that a plan leaves out of a contact, estimated by closed forms."""
    shown = scene if plan.model.rough else replace(scene, smooth=True)
    prediction = predicted(shown)
    films = prediction.film_central, prediction.film_min
    return judged(plan.effects, plan.accuracy, films, scene.composite_roughness)


def worst(several: Sequence[NeglectedEffects]) -> NeglectedEffects:
    """The largest influences of several contacts, with the lubrication of the one where it is worst."""
    if not several:
        return NeglectedEffects()
    influence: dict[str, float] = {}
    for contact in several:
        for name, fraction in contact.influence.items():
            influence[name] = max(fraction, influence.get(name, 0.0))
    severest = max(several, key=_severity)
    return replace(severest, influence=_largest_first(influence), contacts=len(several))


def _severity(contact: NeglectedEffects) -> tuple[float, float, float]:
    """Numbers that rise with the severity of lubrication."""
    bearable = contact.mixed_above_roughness_m
    return (
        BY_SEVERITY.index(contact.lubrication),
        -(contact.lambda_central or 0.0),
        -inf if bearable is None else -bearable,
    )


def _largest_first(influence: Mapping[str, float]) -> dict[str, float]:
    return dict(sorted(influence.items(), key=lambda item: -item[1]))


def _up_to(fraction: float) -> str:
    return "by more than 99 %" if fraction > 0.99 else f"up to {fraction * 100:.2g} %"
