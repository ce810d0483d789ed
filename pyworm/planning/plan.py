"""The plan: which effects are simulated, on which grids, to reach the accuracy asked for."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from pyworm.formulas.regimes import Regime
from pyworm.io import units
from pyworm.io.given import Names, WithUnit, kind_of, number, unusual
from pyworm.io.present import present
from pyworm.io.quantity_text import percent
from pyworm.io.shown import Shown
from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.planning.discretisation import PLANS
from pyworm.planning.effects.effect import FILM, FRICTION, QUANTITIES, TEMPERATURE
from pyworm.planning.effects.heat import FILM_HEATING, SURFACE_HEATING, VISCOSITY_ACROSS
from pyworm.planning.effects.judgement import Judgement, judge, simplified
from pyworm.planning.effects.selection import (
    SIMULATED,
    BesideAuto,
    beside_auto,
    chosen,
    effect_names,
    quantity_names,
    require,
)
from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.expected_work import Work
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.model import Model, model_for
from pyworm.planning.prediction import Prediction, predicted
from pyworm.planning.target import FILMS, HEAT_FIGURES, AccuracyTarget
from pyworm.scene.line import LineScene
from pyworm.scene.own_functions import require_functions
from pyworm.scene.plausibility import UnusualWarning, doubts, require_conceivable
from pyworm.scene.point import Scene


@dataclass(frozen=True, repr=False)
class Plan(Shown):
    """Effects, model, grids and tolerance of a solve."""

    accuracy: float
    """Relative error required in the requested quantities [-]."""
    quantities: tuple[str, ...]
    """Requested quantities, of `pyworm.planning.effects.effect.QUANTITIES`."""
    asked: tuple[str, ...] | None
    """Effects named by the user; None where the accuracy decides."""
    effects: tuple[Judgement, ...]
    """Every effect with its judgement."""
    regime: Regime
    """The regime of lubrication."""
    target: AccuracyTarget
    """The results to whose numerical uncertainties the accuracy refers."""
    model: Model
    """Levels across the film and heat, as the kernel simulates them."""
    grids: tuple[Grid | LineGrid, ...]
    """Grids from the outermost to the first one of the figures; finer ones are added as needed."""
    wider_grids: tuple[Grid | LineGrid, ...]
    """Grids of the same spacing to a domain of twice the size, for the domain truncation error; empty if
    that is not to be estimated, and no part of uncertainties."""
    largest_grid: int
    """Nodes beyond which grids are not refined further."""
    tolerance: float
    """Residual and load error, at most, at which a grid of the figures is solved."""
    work: Work
    """Expected Newton steps; `pyworm.solver.cost.expected_time` gives their time."""
    refusal: str | None = None
    """Reason why no grid is refined, the film needing far more nodes than allowed; else None."""
    excluded: Mapping[str, str] = field(default_factory=dict)
    """Effects neglected whatever the accuracy requires, and the reason of each."""
    contact: tuple[float, ...] = ()
    """Load, reduced modulus, viscosity, radii and velocities of the contact that it is made for."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of its picture in words."""
        first, last = (" x ".join(map(str, self.grids[number].shape)) for number in (0, -1))
        return "Plan", {
            "accuracy": percent(self.accuracy, 3),
            "regime": self.regime.words,
            "grids": f"from {first} to {last} nodes, finer ones as needed",
            "quantities": ", ".join(self.quantities),
            "simulated": ", ".join(sorted(self.on)) or "no effect",
            **({"refused": self.refusal} if self.refusal else {}),
        }

    def require_of(self, scene: Scene | LineScene) -> None:
        """Refuse another scene than that of the plan; ValueError."""
        if self.contact != _identity(scene):
            raise ValueError(
                f"the plan was made for another contact than {scene.name}; make one for it, "
                "pyworm.plan(scene)"
            )

    @property
    def on(self) -> frozenset[str]:
        """Names of the effects that are simulated."""
        return frozenset(judgement.name for judgement in self.effects if judgement.on)

    @property
    def may_grow(self) -> bool:
        """Whether it neglects effects that the solution may call for."""
        neglected_effects = {
            effect.name for effect in self.effects if not effect.on and effect.influence
        }
        return self.asked is None and not neglected_effects.isdisjoint(
            SIMULATED.keys() - self.excluded.keys()
        )

    def simplified(self, scene: Scene | LineScene) -> Scene | LineScene:
        """The scene without the neglected effects.

        Where the user neglects the oil's flow law, no law remains, since the friction of a Newtonian oil
        would be meaningless.
        """
        simple = simplified(scene, self.on)
        if self.asked is not None and simple.oil.flow == NEWTONIAN != scene.oil.flow:
            return replace(simple, oil=replace(simple.oil, flow=None))
        return simple


def plan(
    scene: Scene | LineScene,
    accuracy: WithUnit = 0.01,
    effects: Names = "auto",
    quantities: Names | None = None,
) -> Plan:
    """Plan the solve of a scene: effects, model, grids and tolerance.

    Args:
        scene: The contact.
        accuracy: Relative error wanted [-], between 1e-5 and 0.5.
        effects: "auto": what the accuracy requires; ("auto", "squeeze", "-roughness"): in any case with the
            first effect and without the second. Otherwise "all", "isothermal", or names of effects, as of
            `planning.effects.selection.chosen`.
        quantities: Requested quantities: "film", "friction", "temperature"; by default all that the oil's
            data allow.

    Returns:
        Unusual values of the scene, such as slips of units are, give an `UnusualWarning` each.

    Raises:
        ValueError: For an unknown name, an accuracy out of range, an effect for which data of the scene are
            missing, or a scene without load or size, or that not even a model's bodies or films could make.
    """
    if not isinstance(scene, Scene | LineScene):
        raise ValueError(f"scene is a {type(scene).__name__}: must be a Scene or a LineScene")
    require_functions(scene)
    _require_conduction(scene)
    for sentence in (*unusual(scene), *doubts((scene,), "load")):
        warnings.warn(f"{scene.name}: {sentence}", UnusualWarning, stacklevel=2)
    require_conceivable(scene, f"{scene.name}: load")
    return plan_of(scene, accuracy, effects, quantities)


def _require_conduction(scene: Scene | LineScene) -> None:
    """Refuse bodies that are to take up heat and have no constants for it; ValueError."""
    if scene.oil.heat is None:
        return
    for which, body in enumerate(scene.bodies, 1):
        constants = ("conductivity", "density", "specific_heat")
        missing = [name for name in constants if getattr(body, name) is None]
        if missing:
            raise ValueError(
                f"{scene.name}: its oil has heat, but body {which} has no {' or '.join(missing)}; give both "
                "bodies theirs, or the oil no heat"
            )


def plan_of(
    scene: Scene | LineScene,
    accuracy: WithUnit = 0.01,
    effects: Names = "auto",
    quantities: Names | None = None,
) -> Plan:
    """The plan of a scene that is known to be possible; arguments as of `plan`."""
    accuracy = number("accuracy", accuracy, kind_of(units.Share))
    names = effect_names(effects)
    quantities = quantity_names(quantities)
    if not 1e-5 <= accuracy <= 0.5:
        raise ValueError(
            f"accuracy = {accuracy:g}: must be a relative error between 1e-5 and 0.5, such as 1%"
        )
    known = _known(scene)
    for quantity in quantities or ():
        if quantity not in QUANTITIES:
            raise ValueError(f"quantities: {quantity} is none of {', '.join(QUANTITIES)}")
        if quantity not in known:
            raise ValueError(
                f"quantities: {quantity} cannot be found without [oil.shear] or [oil.heat]"
            )
    wanted = known if quantities is None else quantities
    beside = beside_auto(names)
    asked = names if beside is None else None
    beside = beside or BesideAuto()
    excluded = dict.fromkeys(beside.excluded, "neglected as requested")
    for name in beside.required:
        require(scene, name, names)
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            prediction = predicted(scene)
            return planned(scene, accuracy, wanted, prediction, asked, beside.required, excluded)
    except ArithmeticError as error:
        raise ValueError(
            f"{scene.name}: its load, speed, oil and bodies are out of all proportion ({error}); "
            "check their units"
        ) from error


def planned(
    scene: Scene | LineScene,
    accuracy: float,
    quantities: tuple[str, ...],
    prediction: Prediction,
    asked: tuple[str, ...] | None = None,
    required: frozenset[str] = frozenset(),
    excluded: Mapping[str, str] | None = None,
) -> Plan:
    """The plan from a prediction of the contact; effects in `required` stay on, those in `excluded` off."""
    judgements = _judged(scene, accuracy, quantities, prediction, asked, required, excluded)
    on = frozenset(judgement.name for judgement in judgements if judgement.on)
    simple = simplified(scene, on)
    model = model_for(simple, accuracy, on, prediction)
    numerics = PLANS[type(simple)](simple, accuracy, model)
    # without sliding friction has no size, and without its flow law it means nothing
    sheared = model.heated or simple.oil.flow not in (None, NEWTONIAN)
    law = sheared or asked is None or simple.oil.flow == scene.oil.flow
    told = simple.oil.flow is not None or simple.oil.heat is not None
    _require_any(quantities, asked, {FILM: True, FRICTION: told and law, TEMPERATURE: model.heated})
    rubs = told and law and prediction.sliding > 0
    target = _target(scene, quantities, model, rubs=rubs, beta=prediction.inlet_beta)
    return Plan(
        accuracy,
        quantities,
        asked,
        judgements,
        prediction.regime,
        target,
        model,
        **vars(numerics),
        excluded=dict(excluded or {}),
        contact=_identity(scene),
    )


def _require_any(
    quantities: tuple[str, ...], asked: tuple[str, ...] | None, found: Mapping[str, bool]
) -> None:
    """Refuse effects without which nothing that is asked for would be found; ValueError."""
    if asked is not None and not any(found[quantity] for quantity in quantities):
        raise ValueError(
            f"quantities: {', '.join(quantities)} cannot be found with effects = {','.join(asked)}, which "
            "neglects the oil's flow law and heat; request film, or effects = auto"
        )


def _identity(scene: Scene | LineScene) -> tuple[float, ...]:
    """What tells a contact from others of other sizes: `Plan.contact`."""
    origin = (np.zeros(()),) * len(scene.radii_along)
    speeds = (float(part) for body in scene.velocities_at(*origin) for part in body)
    sizes = scene.load, scene.reduced_modulus, scene.oil.viscosity.eta0
    return (*sizes, *scene.radii_along, *speeds)


def first_grids_of(scene: Scene | LineScene, plan: Plan) -> tuple[Grid | LineGrid, ...]:
    """The grids of the plan for another scene."""
    return PLANS[type(scene)](scene, plan.accuracy, plan.model).grids


def effects_for(scene: Scene | LineScene, plan: Plan, prediction: Prediction) -> frozenset[str]:
    """Names of the effects that a plan's accuracy calls for in another scene."""
    how = scene, plan.accuracy, plan.quantities, prediction, plan.asked
    judged = _judged(*how, frozenset(), plan.excluded)
    return frozenset(judgement.name for judgement in judged if judgement.on)


def _target(
    scene: Scene | LineScene, quantities: tuple[str, ...], model: Model, rubs: bool, beta: float
) -> AccuracyTarget:
    """The figures of the quantities asked for that the model has."""
    figures = {
        FILM: FILMS,
        FRICTION: ("friction_coefficient",) * rubs,
        TEMPERATURE: HEAT_FIGURES * model.heated,
    }
    names = tuple(name for quantity in quantities for name in figures[quantity])
    roughness = present(scene.composite_roughness, "roughness") if model.rough else 0.0
    return AccuracyTarget(names, 1 / beta if beta > 0 else 0.0, roughness)


def steady(plan: Plan, reason: str) -> Plan:
    """The plan without a transient solution, for a reason."""
    return replace(
        plan,
        effects=tuple(
            replace(effect, on=False, reason=reason) if effect.name == SQUEEZE.name else effect
            for effect in plan.effects
        ),
        excluded={**plan.excluded, SQUEEZE.name: reason},
    )


def isothermal(scene: Scene | LineScene, plan: Plan, reason: str) -> Plan:
    """The plan of a scene without heat, for a reason."""
    heat = FILM_HEATING.name, SURFACE_HEATING.name, VISCOSITY_ACROSS.name
    excluded = {**plan.excluded, **dict.fromkeys(heat, reason)}
    how = scene, plan.accuracy, plan.quantities, predicted(scene), plan.asked
    return planned(*how, plan.on.difference(heat), excluded)


def reviewed(scene: Scene | LineScene, plan: Plan, figures: Mapping[str, float]) -> Plan:
    """Judge a plan's effects again by solved figures, which adds some, or none and leaves the rest."""
    prediction = predicted(scene).updated(figures)
    how = (scene, plan.accuracy, plan.quantities, prediction, plan.asked, plan.on, plan.excluded)
    again = replace(plan, effects=_judged(*how))
    return again if again.on == plan.on else planned(*how)


def with_accuracy(scene: Scene | LineScene, plan: Plan, accuracy: float) -> Plan:
    """The plan of a scene at another accuracy; its effects stay on, and its largest grid the same."""
    repeated = planned(
        scene, accuracy, plan.quantities, predicted(scene), plan.asked, plan.on, plan.excluded
    )
    return replace(repeated, largest_grid=plan.largest_grid)


def _judged(
    scene: Scene | LineScene,
    accuracy: float,
    quantities: tuple[str, ...],
    prediction: Prediction,
    asked: tuple[str, ...] | None,
    required: frozenset[str],
    excluded: Mapping[str, str] | None,
) -> tuple[Judgement, ...]:
    names = None if asked is None else chosen(scene, asked)
    return judge(scene, accuracy, quantities, prediction, names, required, excluded)


def _known(scene: Scene | LineScene) -> tuple[str, ...]:
    """Quantities that can be asked for, given the oil's data."""
    oil = scene.oil
    known = {FILM: True, FRICTION: oil.flow or oil.heat, TEMPERATURE: oil.heat}
    return tuple(quantity for quantity in QUANTITIES if known[quantity])
