"""Passes of one contact after another over one track, each fed with what the one before left."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pyworm.io import units
from pyworm.io.given import Names, WithUnit, kind_of, number
from pyworm.materials.oil_layer import OilLayer
from pyworm.scene.point import Scene, require_point
from pyworm.solver.solution import Solution
from pyworm.solver.solve import solve


def passes(
    scene: Scene,
    count: int,
    accuracy: WithUnit = 0.05,
    effects: Names = "auto",
    replenished: WithUnit = 0.0,
) -> Iterator[Solution]:
    """Solve passes of a contact over one track, as of rollers or balls in a row, one after another.

    Args:
        scene: The contact; its oil has the `supply` of the first pass.
        count: Number of passes.
        accuracy, effects: As of `pyworm.plan`.
        replenished: Part of the oil that is missing against the first supply which flows back from the sides
            between two passes, 0 to 1 [-].

    Yields:
        Of each pass. They end before one that is not starved, or whose film did not converge.

    Raises:
        ValueError: No supply, or a part that is none.

    The law of replenishment is the simplest: a fixed part, everywhere across the track. What a contact leaves
    is the oil behind it (Chevalier, Lubrecht, Cann, Colin and Dalmaz 1998).
    """
    require_point(scene)
    if scene.oil.supply is None:
        raise ValueError(f"{scene.name}: its oil has no supply; give the layer of the first pass")
    replenished = number("replenished", replenished, kind_of(units.Share))
    if not 0 <= replenished <= 1:
        raise ValueError(f"replenished = {replenished:g}: must be between 0 and 1")
    first = scene
    for _ in range(count):
        solution = solve(scene, accuracy=accuracy, effects=effects)
        yield solution
        supply = solution.figures.supply
        if not solution.converged or supply is None:
            return
        left = np.array(supply.layer.thickness)
        offered = first.oil.layer_at(np.array(supply.layer.across))
        thickness = left + replenished * np.maximum(offered - left, 0.0)
        layer = OilLayer(supply.layer.across, tuple(thickness.tolist()))
        scene = replace(scene, oil=replace(scene.oil, supply=layer))
