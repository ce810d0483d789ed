"""The plan: which effects are simulated, on which grids, to reach the accuracy asked for."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import cos, hypot, pi, sin, sqrt

import numpy as np

from pyworm.accuracy import FILMS, HEAT_FIGURES, Aim
from pyworm.effects.choice import beside_auto, chosen
from pyworm.effects.effect import FILM, FRICTION, QUANTITIES, TEMPERATURE
from pyworm.effects.judgement import Judgement, judge, simplified
from pyworm.effects.sketch import Sketch, sketch
from pyworm.formulas.regimes import Regime, line_regime, point_regime
from pyworm.grid import Box, Grid, nest
from pyworm.lent import lent
from pyworm.line.grid import LineGrid, first_grids
from pyworm.line.scales import line_scales
from pyworm.line.scene import LineScene
from pyworm.oils import NEWTONIAN
from pyworm.scales import Scales, scales
from pyworm.scene import Scene
from pyworm.window import FAR, grown, near_reach, windows
from pyworm.work import LENT_CHANGE, Work, expected_work, first_change, stiffness


@dataclass(frozen=True)
class Model:
    """What the kernel simulates of a contact.

    Attributes
    ----------
    levels : int
        Levels across the film, walls included; 0 for a Newtonian film of one temperature, which needs none.
    heated : bool
        Whether the film and the bodies warm.
    """

    levels: int = 0
    heated: bool = False


PARABOLA = 3
"""Levels across a film whose temperature is a parabola."""

LEVEL_ERRORS = ((5, 1e-2), (7, 4e-4), (9, 3e-5), (11, 0.0))
"""Levels across the film, and what error they leave in its figures: the worst of films, friction and largest
temperatures of seven contacts against 13 levels (`benchmarks/levels.py`, `docs/validation.md`)."""

LEVEL_SHARE = 0.1
"""Error by the levels allowed, as a share of the accuracy asked for."""

COARSE_CELLS = 16
"""Cells of the first grid of the figures along the short one of the contact's lengths: Hertz's semi-axis and,
where the film is thick, the distance over which the undeformed gap rises by a film, together."""

LARGEST_STRETCH = 3.0
"""Largest ratio of the spacing along the long axis to that along the short one: side lobes and exit of a
slender contact scale with its short axis."""

LARGEST_GRID = 4_000_000
"""Nodes beyond which grids are not refined further."""

LARGEST_LINE = 33_000
"""The same for a line contact. A step costs some milliseconds at 2000 and grows nearly as their number."""

LINE_TOLERANCE = 1e-6
"""Residual allowed in a line contact that does not warm: Newton's last step falls far below it at no cost."""

HEATED_LINE_SHARE = 0.01
"""Residual allowed in one that warms, as a share of the accuracy asked for. Film and temperature take turns
there; ten times as much left temperatures beyond their error bars in half of 40 random scenes."""

RESIDUAL_SHARE = 0.1
"""Residual allowed, as a share of the accuracy asked for; what it leaves in the figures is judged apart."""


@dataclass(frozen=True)
class Plan:
    """What a solve will do.

    Attributes
    ----------
    accuracy : float
        Relative error wanted in the quantities asked for [-].
    quantities : tuple of str
        What is asked for, of `pyworm.effects.effect.QUANTITIES`.
    asked : str or None
        The effects asked for in words; None where the accuracy chose them.
    effects : tuple of Judgement
        Every effect judged.
    regime : Regime
        The regime of lubrication by the chart.
    aim : Aim
        The figures whose error bars the accuracy is asked of.
    model : Model
        What the kernel simulates.
    grids : tuple of Grid or LineGrid
        From the outermost to the first one of the figures; finer ones follow as the accuracy needs.
    wider_grids : tuple of Grid or LineGrid
        The same to a window of twice the reach and the same spacing, for the error by the window; none if
        that is not to be estimated.
    largest_grid : int
        Nodes beyond which grids are not refined further.
    tolerance : float
        Residual and load error, at most, at which a grid of the figures is solved.
    work : Work
        The Newton steps that are expected; what they take is told by `pyworm.expectation`.
    refusal : str or None
        Why no grid is refined: the film needs far more nodes than allowed. None of any other contact.
    """

    accuracy: float
    quantities: tuple[str, ...]
    asked: str | None
    effects: tuple[Judgement, ...]
    regime: Regime
    aim: Aim
    model: Model
    grids: tuple[Grid | LineGrid, ...]
    wider_grids: tuple[Grid | LineGrid, ...]
    largest_grid: int
    tolerance: float
    work: Work
    refusal: str | None = None

    @property
    def on(self) -> frozenset[str]:
        """Names of the effects that are simulated."""
        return frozenset(judgement.name for judgement in self.effects if judgement.on)

    def simplified(self, scene: Scene | LineScene) -> Scene | LineScene:
        """The scene without the effects that are left out.

        Where the oil's flow law is left out whatever that changes, none is left: the friction of a Newtonian
        oil would mean nothing.
        """
        simple = simplified(scene, self.on)
        if self.asked is not None and simple.oil.flow == NEWTONIAN != scene.oil.flow:
            return replace(simple, oil=replace(simple.oil, flow=None))
        return simple


@dataclass(frozen=True)
class _Numerics:
    """The part of a plan that depends on how a kind of contact is solved."""

    grids: tuple[Grid | LineGrid, ...]
    wider_grids: tuple[Grid | LineGrid, ...]
    largest_grid: int
    tolerance: float
    work: Work
    refusal: str | None


def plan(
    scene: Scene | LineScene,
    accuracy: float = 0.01,
    effects: str = "auto",
    quantities: Sequence[str] | None = None,
) -> Plan:
    """Plan of a solve.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    accuracy : float
        Relative error wanted [-], between 1e-5 and 0.5.
    effects : str
        "auto": what the accuracy calls for, and effects named after a comma; otherwise what
        `pyworm.effects.choice.chosen` reads: "all", "isothermal", or names of effects with commas.
    quantities : sequence of str, optional
        What is asked for: "film", "friction", "temperature"; by default all that the oil is known for.

    Raises
    ------
    ValueError
        For a name or an accuracy that there is none of, an effect that too little is known of the scene for,
        or a scene without load or size.
    """
    if not 1e-5 <= accuracy <= 0.5:
        raise ValueError(
            f"accuracy = {accuracy:g}: a relative error between 1e-5 and 0.5, such as 1%"
        )
    known = _known(scene)
    for quantity in quantities or ():
        if quantity not in QUANTITIES:
            raise ValueError(f"quantities: {quantity} is none of {', '.join(QUANTITIES)}")
        if quantity not in known:
            raise ValueError(
                f"quantities: {quantity} cannot be told, give [oil.shear] or [oil.heat]"
            )
    wanted = known if quantities is None else tuple(quantities)
    named = beside_auto(effects)
    asked = effects if named is None else None
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            return planned(scene, accuracy, wanted, sketch(scene), asked, named or frozenset())
    except ArithmeticError as error:
        raise ValueError(
            f"{scene.name}: its load, speed, oil and bodies are out of all proportion ({error}); "
            "check their units"
        ) from error


def planned(
    scene: Scene | LineScene,
    accuracy: float,
    quantities: tuple[str, ...],
    seen: Sketch,
    asked: str | None = None,
    kept: frozenset[str] = frozenset(),
) -> Plan:
    """The plan by a sketch of the contact; effects that are `kept` stay on whatever it says."""
    judgements = _judged(scene, accuracy, quantities, seen, asked, kept)
    on = frozenset(judgement.name for judgement in judgements if judgement.on)
    simple = simplified(scene, on)
    model = _model(simple, accuracy, on)
    numerics = PLANS[type(simple)](simple, accuracy, model)
    # without sliding friction has no size, and without its flow law it means nothing
    law = model.levels > 0 or asked is None or simple.oil.flow == scene.oil.flow
    aim = _aim(quantities, model, rubs=law and seen.sliding > 0, beta=seen.inlet_beta)
    regime = (line_regime if isinstance(scene, LineScene) else point_regime)(seen.groups)
    return Plan(accuracy, quantities, asked, judgements, regime, aim, model, **vars(numerics))


def first_grids_of(scene: Scene | LineScene, plan: Plan) -> tuple[Grid | LineGrid, ...]:
    """The grids that a plan would have if it were one of this scene."""
    return PLANS[type(scene)](scene, plan.accuracy, plan.model).grids


def _aim(quantities: tuple[str, ...], model: Model, rubs: bool, beta: float) -> Aim:
    """The figures that tell what is asked for, as far as the model has them."""
    figures = {
        FILM: FILMS,
        FRICTION: ("friction_coefficient",) * rubs,
        TEMPERATURE: HEAT_FIGURES * model.heated,
    }
    names = tuple(name for quantity in quantities for name in figures[quantity])
    return Aim(names, 1 / beta if beta > 0 else 0.0)


def reviewed(scene: Scene | LineScene, plan: Plan, figures: Mapping[str, float]) -> Plan:
    """The plan judged again by solved figures, by name; effects that are on stay on.

    Only where effects come in is anything else of it planned anew.
    """
    seen = sketch(scene).seen(figures)
    how = scene, plan.accuracy, plan.quantities, seen, plan.asked, plan.on
    again = replace(plan, effects=_judged(*how))
    return again if again.on == plan.on else planned(*how)


def _judged(
    scene: Scene | LineScene,
    accuracy: float,
    quantities: tuple[str, ...],
    seen: Sketch,
    asked: str | None,
    kept: frozenset[str],
) -> tuple[Judgement, ...]:
    """The effects, judged as of `planned`."""
    names = None if asked is None else chosen(scene, asked)
    return judge(scene, accuracy, quantities, seen, names, kept)


def _known(scene: Scene | LineScene) -> tuple[str, ...]:
    """What can be asked of a scene by what is known of its oil."""
    oil = scene.oil
    known = {FILM: True, FRICTION: oil.flow or oil.heat, TEMPERATURE: oil.heat}
    return tuple(quantity for quantity in QUANTITIES if known[quantity])


def _model(simple: Scene | LineScene, accuracy: float, on: frozenset[str]) -> Model:
    """The model of a scene that has only the effects that are on."""
    if simple.oil.heat is not None:
        return Model(_levels(accuracy) if "viscosity-across" in on else PARABOLA, heated=True)
    return Model() if simple.oil.flow in (None, NEWTONIAN) else Model(_levels(accuracy))


def _levels(accuracy: float) -> int:
    """Levels across the film whose error is small against an accuracy (`docs/theory/heat.md`)."""
    return next(levels for levels, error in LEVEL_ERRORS if error <= LEVEL_SHARE * accuracy)


def _plan_point(scene: Scene, accuracy: float, model: Model) -> _Numerics:
    drawn = lent(scene) if model.heated else scene
    size = scales(drawn)
    # what heat alone carries ends with the heat: nothing lies beyond the window of the figures
    nested = slice(None) if drawn is scene else slice(-1, None)
    near = near_reach(size)
    inner, outer, wider, *far = windows(scene, size, near, FAR, near.doubled(), FAR.doubled())
    if (
        wider == inner
    ):  # beside a thin film the gap rises beyond both within one step of the windows' growth
        wider = grown(inner)
    grids = _grids(scene, size, inner, outer)[nested]
    wider_grids = _grids(scene, size, wider, *far)[nested]
    half_widths = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    change = LENT_CHANGE
    if drawn is scene:
        change = first_change(
            grids[-1].spacing,
            half_widths,
            scene.radii,
            size.film,
            size.groups.moes_l,
            _slenderness(size),
        )
    work = expected_work(
        "point",
        _nodes(grids, wider_grids),
        change,
        accuracy,
        LARGEST_GRID,
        full=model.levels > 0,
        stiffness=stiffness(model.heated, size.groups.moes_l),
        lent=drawn is not scene,
        moving=scene.past is not None,
    )
    return _Numerics(
        grids=grids,
        wider_grids=wider_grids,
        largest_grid=LARGEST_GRID,
        tolerance=RESIDUAL_SHARE * accuracy,
        work=work,
        refusal=_refusal(work, size.film, LARGEST_GRID),
    )


def _plan_line(scene: LineScene, accuracy: float, model: Model) -> _Numerics:
    size = line_scales(scene)
    if model.heated and 0 in scene.velocities:
        at_rest = scene.velocities.index(0) + 1
        raise ValueError(
            f"{scene.name}: body {at_rest} is at rest (0 m/s), and a body at rest under a line contact "
            "warms without end; give it a velocity, or leave heat out (effects = isothermal)"
        )
    grid, wider = first_grids(scene, size, accuracy, model.heated)
    change = first_change(
        grid.spacing, (size.hertz.half_width,), (scene.radius,), size.film, size.groups.moes_l
    )
    work = expected_work(
        "line",
        _nodes((grid,), (wider,)),
        change,
        accuracy,
        LARGEST_LINE,
        full=model.levels > 0,
        stiffness=stiffness(model.heated, size.groups.moes_l),
        moving=scene.past is not None,
    )
    return _Numerics(
        grids=(grid,),
        wider_grids=(wider,),
        largest_grid=LARGEST_LINE,
        tolerance=HEATED_LINE_SHARE * accuracy if model.heated else LINE_TOLERANCE,
        work=work,
        refusal=_refusal(work, size.film, LARGEST_LINE),
    )


def _refusal(work: Work, film: float, largest: int) -> str | None:
    """Why a film [m] is not sought on finer grids; None if it is."""
    if not work.in_vain:
        return None
    return (
        f"the film of {film * 1e9:.2g} nm that is expected needs some {work.needed / 1e6:.3g} million nodes, "
        f"{largest / 1e6:.3g} million are the largest grid allowed"
    )


def _slenderness(size: Scales) -> float:
    """Length of Hertz's contact along the entrainment over that across it."""
    along, across = (
        hypot(cos(angle) / size.hertz.semi_axis_x, sin(angle) / size.hertz.semi_axis_y)
        for angle in (size.angle, size.angle + pi / 2)
    )
    return across / along


def _nodes(*nests: Sequence[Grid | LineGrid]) -> list[list[int]]:
    """Nodes of the grids of each window."""
    return [[grid.nodes for grid in nest] for nest in nests]


PLANS = {Scene: _plan_point, LineScene: _plan_line}
"""What plans each kind of contact, by its scene."""


def _grids(scene: Scene, size: Scales, inner: Box, outer: Box) -> tuple[Grid, ...]:
    """Grids from the outer window down to the first one of the figures, in the inner."""
    lengths = [
        sqrt(semi_axis**2 + 2 * radius * size.film)
        for semi_axis, radius in zip(
            (size.hertz.semi_axis_x, size.hertz.semi_axis_y), scene.radii, strict=True
        )
    ]
    short = min(lengths)
    dx, dy = (min(length, LARGEST_STRETCH * short) / COARSE_CELLS for length in lengths)
    return nest(inner, outer, dx, dy)
