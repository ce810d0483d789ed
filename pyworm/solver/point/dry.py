"""The dry contact of a scene, as scripts ask for it."""

from dataclasses import dataclass

from pyworm.formulas.arrays import Array
from pyworm.io.quantities import QUANTITIES
from pyworm.io.shown import Shown
from pyworm.planning.grid import Grid
from pyworm.scene.own_functions import require_functions
from pyworm.scene.point import Scene, require_point
from pyworm.scene.scales import scales
from pyworm.solver import figures
from pyworm.solver.point.level import dry_contact as solved_on

HALF_WINDOW_RATIO = 1.5
"""Half window over the semi-axes of Hertz' ellipse, with which is begun."""

MOST_GROWTHS = 6
"""Times that the window is enlarged by half where the contact touches its border."""


@dataclass(frozen=True, eq=False, repr=False)
class DryPressure(Shown):
    """The pressure of a dry contact."""

    x: Array
    """Places of the nodes along x [m]."""
    y: Array
    """Places of the nodes along y [m]."""
    pressure: Array
    """Pressure [Pa], shape (x, y)."""
    pressure_max: float
    """Largest pressure, between nodes [Pa]."""
    approach: float
    """Rigid approach of the bodies [m]."""
    converged: bool
    """Whether the iteration met its tolerance."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the contact in words."""
        highest, approach = QUANTITIES["dry_pressure_max"], QUANTITIES["dry_approach"]
        return "DryPressure", {
            highest.words(): highest.text(self.pressure_max),
            approach.words(): approach.text(self.approach),
            "nodes": " x ".join(map(str, self.pressure.shape)),
        }


def dry_contact(scene: Scene, nodes: int = 129) -> DryPressure:
    """Solve the dry contact of a point contact under its load: its gap, edges included, without oil.

    Args:
        scene: The contact.
        nodes: Nodes a side of the square grid.

    Raises:
        ValueError: No point contact, or one that is wider than its Hertz ellipse allows for.
    """
    require_point(scene)
    if isinstance(nodes, bool) or not isinstance(nodes, int) or nodes < 9:
        raise ValueError(f"nodes = {nodes!r:.40}: must be a whole number from 9")
    require_functions(scene)
    hertz = scales(scene).hertz
    a, b = HALF_WINDOW_RATIO * hertz.semi_axis_x, HALF_WINDOW_RATIO * hertz.semi_axis_y
    for _ in range(MOST_GROWTHS):
        grid = Grid(-a, -b, 2 * a / (nodes - 1), 2 * b / (nodes - 1), nodes, nodes)
        x, y = grid.mesh()
        gap, covered = scene.gap(x, y)
        found = solved_on(scene, grid, gap, covered, hertz.pressure(x, y))
        p = found.pressure
        along_x, along_y = p[[0, -1]].any(), p[:, [0, -1]].any()
        if not (along_x or along_y):
            largest = figures.maximum(p, covered)
            return DryPressure(grid.x, grid.y, p, largest, found.approach, found.converged)
        a, b = (1.5 if along_x else 1.0) * a, (1.5 if along_y else 1.0) * b
    raise ValueError(f"{scene.name}: the contact is far larger than Hertz' ellipse of its radii")
