"""The plan: which effects are simulated, on which grids, to reach the accuracy asked for."""

from dataclasses import dataclass
from math import sqrt

from pyworm.grid import Grid, nest
from pyworm.lent import lent
from pyworm.line.grid import LineGrid, first_grids
from pyworm.line.scales import line_scales
from pyworm.line.scene import LineScene
from pyworm.oils import NEWTONIAN, Oil
from pyworm.scales import Scales, scales
from pyworm.scene import Scene
from pyworm.window import FAR, Reach, near_reach, window


@dataclass(frozen=True)
class Model:
    """What of the oil in a contact is simulated.

    Attributes
    ----------
    name : str
        Its name.
    levels : int
        Levels across the film, walls included; 0 for a Newtonian film of one temperature, which needs none.
    heated : bool
        Whether the film and the bodies warm.
    """

    name: str
    levels: int = 0
    heated: bool = False


MODELS = ("isothermal", "sheared", "mean-film", "thermal")
"""Names that `effects` may take: a Newtonian film of one temperature; one with the oil's flow law; that with
surface temperatures and a parabola of temperature across the film; with temperature resolved across it."""

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

LARGEST_GRID = 2_500_000
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

CONVOLUTIONS, LINE_CONVOLUTIONS = 150.0, 2000.0
"""What a solve of a point and of a line contact costs as a rule, in convolutions on its finest grid."""


@dataclass(frozen=True)
class Effect:
    """One physical effect and whether it is simulated.

    Attributes
    ----------
    name : str
        What it is called.
    on : bool
        Whether the solve includes it.
    reason : str
        Why, or why not.
    """

    name: str
    on: bool
    reason: str


@dataclass(frozen=True)
class Plan:
    """What a solve will do.

    Attributes
    ----------
    accuracy : float
        Relative error wanted in minimum and central film [-].
    model : Model
        What of the oil is simulated.
    effects : tuple of Effect
        Every effect judged.
    grids : tuple of Grid or LineGrid
        From the outermost to the first one of the figures; finer ones follow as the accuracy needs.
    wider_grids : tuple of Grid or LineGrid
        The same to a window of twice the reach and the same spacing, for the error by the window; none if
        that is not to be estimated.
    largest_grid : int
        Nodes beyond which grids are not refined further.
    tolerance : float
        Residual and load error, at most, at which a grid of the figures is solved.
    expected_convolutions : float
        Expected cost in convolutions on the finest grid.
    """

    accuracy: float
    model: Model
    effects: tuple[Effect, ...]
    grids: tuple[Grid | LineGrid, ...]
    wider_grids: tuple[Grid | LineGrid, ...]
    largest_grid: int
    tolerance: float
    expected_convolutions: float


def plan(scene: Scene | LineScene, accuracy: float = 0.01, effects: str | None = None) -> Plan:
    """Plan of a solve.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    accuracy : float
        Relative error wanted [-], between 1e-5 and 0.5.
    effects : str, optional
        One of `MODELS`; by default the most that is known enough of the oil for.

    Raises
    ------
    ValueError
        For a name or an accuracy that there is none of, a model that too little is known of the oil for, or a
        scene without load or size.
    """
    if effects is None:
        effects = _most(scene)
    if effects not in MODELS:
        raise ValueError(f"effects = {effects}: choose one of {', '.join(MODELS)}")
    if not 1e-5 <= accuracy <= 0.5:
        raise ValueError(
            f"accuracy = {accuracy:g}: a relative error between 1e-5 and 0.5, such as 1%"
        )
    return PLANS[type(scene)](scene, accuracy, _model(scene, accuracy, effects))


def _most(scene: Scene | LineScene) -> str:
    """The most complete model that a scene's oil is known well enough for."""
    if scene.oil.heat is not None:
        return "thermal"
    return "isothermal" if scene.oil.flow is None else "sheared"


def _model(scene: Scene | LineScene, accuracy: float, name: str) -> Model:
    if name == "isothermal":
        return Model(name)
    if name == "sheared":
        if scene.oil.flow is None:
            raise ValueError("effects = sheared: the oil has no flow law, give [oil.shear]")
        return Model(name, _levels(accuracy))
    if scene.oil.heat is None:
        raise ValueError(f"effects = {name}: how the oil takes heat is not known, give [oil.heat]")
    return Model(name, PARABOLA if name == "mean-film" else _levels(accuracy), heated=True)


def _levels(accuracy: float) -> int:
    """Levels across the film whose error is small against an accuracy (`docs/theory/heat.md`)."""
    return next(levels for levels, error in LEVEL_ERRORS if error <= LEVEL_SHARE * accuracy)


def _plan_point(scene: Scene, accuracy: float, model: Model) -> Plan:
    drawn = lent(scene) if model.heated else scene
    size = scales(drawn)
    # what heat alone carries ends with the heat: nothing lies beyond the window of the figures
    nested = slice(None) if drawn is scene else slice(-1, None)
    return Plan(
        accuracy=accuracy,
        model=model,
        effects=_effects(scene.oil, model, across=True),
        grids=_grids(scene, size, near_reach(size), FAR)[nested],
        wider_grids=_grids(scene, size, near_reach(size).doubled(), FAR.doubled())[nested],
        largest_grid=LARGEST_GRID,
        tolerance=RESIDUAL_SHARE * accuracy,
        expected_convolutions=CONVOLUTIONS,
    )


def _plan_line(scene: LineScene, accuracy: float, model: Model) -> Plan:
    size = line_scales(scene)
    if model.heated and 0 in scene.velocities:
        at_rest = scene.velocities.index(0) + 1
        raise ValueError(
            f"effects = {model.name}: body {at_rest} is at rest (0 m/s), and a body at rest under a line "
            "contact warms without end; give it a velocity, or choose sheared or isothermal"
        )
    grid, wider = first_grids(scene, size, accuracy, model.heated)
    return Plan(
        accuracy=accuracy,
        model=model,
        effects=_effects(scene.oil, model, across=False),
        grids=(grid,),
        wider_grids=(wider,),
        largest_grid=LARGEST_LINE,
        tolerance=HEATED_LINE_SHARE * accuracy if model.heated else LINE_TOLERANCE,
        expected_convolutions=LINE_CONVOLUTIONS,
    )


PLANS = {Scene: _plan_point, LineScene: _plan_line}
"""What plans each kind of contact, by its scene."""


def _grids(scene: Scene, size: Scales, near: Reach, far: Reach) -> tuple[Grid, ...]:
    """Grids from the far window down to the first one of the figures."""
    lengths = [
        sqrt(semi_axis**2 + 2 * radius * size.film)
        for semi_axis, radius in zip(
            (size.hertz.semi_axis_x, size.hertz.semi_axis_y), scene.radii, strict=True
        )
    ]
    short = min(lengths)
    dx, dy = (min(length, LARGEST_STRETCH * short) / COARSE_CELLS for length in lengths)
    return nest(window(scene, size, near), window(scene, size, far), dx, dy)


def _effects(oil: Oil, model: Model, across: bool) -> tuple[Effect, ...]:
    """Effects and whether a model has them; what the kernel does not simulate is named too.

    `across` tells whether there is a second direction for anything to happen in.
    """
    asked = f"part of the {model.name} model"
    left_out = f"not part of the {model.name} model"
    missing = "not simulated"
    line = "a line contact is the same all along"
    compressible = oil.density.d1 > 0
    piezoviscous = oil.viscosity.alpha > 0
    flow = oil.flow or NEWTONIAN

    def sheared(has_it: bool, what: str) -> tuple[bool, str]:
        if not model.levels:
            return False, left_out
        return (True, asked) if has_it else (False, what)

    def heated(on: bool) -> tuple[bool, str]:
        return (True, asked) if on else (False, left_out)

    return (
        Effect("elastic deflection", True, asked),
        Effect(
            "pressure-viscosity", piezoviscous, asked if piezoviscous else "the oil has alpha = 0"
        ),
        Effect(
            "compressibility", compressible, asked if compressible else "the oil is incompressible"
        ),
        Effect("real gap", True, asked),
        Effect("second dimension", across, asked if across else line),
        Effect("varying velocity and spin", across, asked if across else line),
        Effect("shear thinning", *sheared(flow.thins, "the oil's flow law has none")),
        Effect("limiting shear stress", *sheared(flow.limited, "the oil's flow law has none")),
        Effect("surface flash heating", *heated(model.heated)),
        Effect("film heating", *heated(model.heated)),
        Effect(
            "viscosity across the film",
            *heated(model.heated),
        ),
        *(
            Effect(name, False, missing)
            for name in ("inlet starvation", "squeeze", "surface roughness")
        ),
    )
