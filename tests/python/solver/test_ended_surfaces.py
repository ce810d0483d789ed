"""Heat and dry contact where one of both surfaces has ended, and what is left of the gap means nothing."""

from dataclasses import replace

import numpy as np
import pytest
from plan_scenes import STEEL, point

import pyworm
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil, OilHeat
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.scene.point import Paraboloid
from pyworm.scene.scales import scales
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.newton import converge
from pyworm.solver.point.level import dry_contact

RADIUS = 0.02
HEAT = OilHeat(333.15, 0.0, 0.14, 2000.0, 7e-4)
OIL = Oil(Barus(0.02, 1e-8), Density.incompressible(850.0), FlowLaw("newtonian"), HEAT)
ROUND = Paraboloid(RADIUS, RADIUS)


def ended(edge, overlap=0.0):
    """A sliding ball that ends at y = `edge` [m]; far beyond that its gap goes on less an overlap [m]."""

    def gap(x, y):
        height, _ = ROUND(x, y)
        return height - overlap * (y > 2 * edge), y < edge

    ball = point("ball", (RADIUS,) * 2, 20.0, ((1.5, 0.0), (0.5, 0.0)), (STEEL, STEEL), OIL)
    return replace(ball, gap=gap)


def whole_grids(effects):
    """Those of a ball that does not end."""
    return pyworm.plan(replace(ended(1.0), gap=ROUND), 0.1, effects).grids


def heated(scene):
    plan = pyworm.plan(scene, 0.1, "all")
    level, _ = SOLVERS[type(scene)](scene, plan).begin(whole_grids("all"))
    converge(level, 1e-6, plan.target, 1e-5)
    return level


@pytest.mark.parametrize("overlap", [1e-5, 1e-3])
def test_no_heat_arises_where_a_surface_has_ended(overlap):
    """Where the other would overlap it the film is as thin as the kernel lets it, or thicker than a tooth."""
    edge = 0.5 * scales(ended(1.0)).hertz.semi_axis_y
    open_gap, closed = (heated(ended(edge, less)) for less in (0.0, overlap))
    assert closed.film.thickness().min() < -overlap / 2 < open_gap.film.thickness().min()
    for level in (open_gap, closed):
        assert np.all(level.film.heat_fields().flux[~level.covered] == 0)
    where = closed.covered
    hottest = open_gap.film.rise()[where].max()
    assert hottest > 1
    assert np.abs(closed.film.rise() - open_gap.film.rise())[where].max() < 0.01 * hottest
    assert closed.film.rise().max() < 1.05 * hottest


def test_a_light_contact_whose_point_lies_beyond_an_edge_has_a_dry_pressure():
    """Hertz's pressure about the point is zero wherever both surfaces exist."""
    scene = ended(-1.2 * scales(ended(1.0)).hertz.semi_axis_y)
    grid = whole_grids("isothermal")[-1]
    gap, covered = scene.gap(*grid.mesh())
    nowhere = scales(scene).hertz.pressure(*grid.mesh())
    assert not np.any(nowhere[covered] > 0)
    dry = dry_contact(scene, grid, gap, covered, nowhere)
    assert dry.converged and np.all(dry.pressure[~covered] == 0)
    assert dry.pressure.sum() * grid.dx * grid.dy == pytest.approx(scene.load, rel=1e-6)
