"""The plan: which effects are simulated, on which grids, to reach the accuracy asked for."""

from dataclasses import dataclass
from math import sqrt

from pyworm.grid import Grid, nest
from pyworm.line.grid import LineGrid, first_grids
from pyworm.line.scales import line_scales
from pyworm.line.scene import LineScene
from pyworm.oils import Oil
from pyworm.scales import Scales, scales
from pyworm.scene import Scene
from pyworm.window import FAR, Reach, near_reach, window

MODELS = ("isothermal",)
"""Names that `effects` may take."""

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
"""Residual allowed in a line contact: Newton's last step falls far below it at no cost."""

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
    effects: tuple[Effect, ...]
    grids: tuple[Grid | LineGrid, ...]
    wider_grids: tuple[Grid | LineGrid, ...]
    largest_grid: int
    tolerance: float
    expected_convolutions: float


def plan(scene: Scene | LineScene, accuracy: float = 0.01, effects: str = "isothermal") -> Plan:
    """Plan of a solve.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    accuracy : float
        Relative error wanted [-], between 1e-5 and 0.5.
    effects : str
        Name of the model; "isothermal" is elastic, piezoviscous, compressible, Newtonian, isothermal.

    Raises
    ------
    ValueError
        For a name or an accuracy that there is none of, or a scene that entrains no oil.
    """
    if effects not in MODELS:
        raise ValueError(f"effects = {effects}: choose one of {', '.join(MODELS)}")
    if not 1e-5 <= accuracy <= 0.5:
        raise ValueError(
            f"accuracy = {accuracy:g}: a relative error between 1e-5 and 0.5, such as 1%"
        )
    return PLANS[type(scene)](scene, accuracy)


def _plan_point(scene: Scene, accuracy: float) -> Plan:
    size = scales(scene)
    return Plan(
        accuracy=accuracy,
        effects=_isothermal(scene.oil, across=True),
        grids=_grids(scene, size, near_reach(size), FAR),
        wider_grids=_grids(scene, size, near_reach(size).doubled(), FAR.doubled()),
        largest_grid=LARGEST_GRID,
        tolerance=RESIDUAL_SHARE * accuracy,
        expected_convolutions=CONVOLUTIONS,
    )


def _plan_line(scene: LineScene, accuracy: float) -> Plan:
    grid, wider = first_grids(scene, line_scales(scene), accuracy)
    return Plan(
        accuracy=accuracy,
        effects=_isothermal(scene.oil, across=False),
        grids=(grid,),
        wider_grids=(wider,),
        largest_grid=LARGEST_LINE,
        tolerance=LINE_TOLERANCE,
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


def _isothermal(oil: Oil, across: bool) -> tuple[Effect, ...]:
    """Effects of the isothermal Newtonian model; what the kernel does not simulate is named too.

    `across` tells whether there is a second direction for anything to happen in.
    """
    asked = "part of the isothermal model"
    missing = "not simulated"
    line = "a line contact is the same all along"
    compressible = oil.density.d1 > 0
    piezoviscous = oil.viscosity.alpha > 0
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
        *(
            Effect(name, False, missing)
            for name in (
                "shear thinning",
                "limiting shear stress",
                "surface flash heating",
                "film heating",
                "inlet starvation",
                "squeeze",
                "surface roughness",
            )
        ),
    )
