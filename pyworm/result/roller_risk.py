"""Fatigue of worm thread and rollers along the contact lines of a roller worm, over both sections."""

import numpy as np

from pyworm.drives.tooth_loss import FEWEST_PHASES
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import describe
from pyworm.result.flank_map import PITTED_AREA, pitting_probability
from pyworm.result.mesh_cycle import phase_of
from pyworm.result.result import Result
from pyworm.solver.solution import Solution


def roller_risk(result: Result) -> "xr.Dataset | None":
    """Fatigue of both bodies over (section, phase, station); None without enough phases that have it.

    fatigue_ratio_body_1 (worm thread) and fatigue_ratio_body_2 (rollers) where a body has fatigue limits, and
    pitting_probability over (body, section, phase, station), NaN where no contact was solved. A position of
    the contact line lies on one place of the thread; the roller turns, so its probability is that of a
    surface that meets this position in every pass, an upper limit.
    """
    solved = [
        solution
        for solution in result.solutions
        if solution.converged and solution.station is not None and _bodies(solution)
    ]
    phases = sorted({phase_of(solution) for solution in solved})
    if len(phases) < FEWEST_PHASES:
        return None
    cycle = result.cycle_data
    sections = [str(name) for name in cycle["section"].values]
    stations = sorted({float(solution.station or 0.0) for solution in solved})
    shape = len(sections), len(phases), len(stations)
    ratios, risks = np.full((2, *shape), np.nan), np.full((2, *shape), np.nan)
    for solution in solved:
        place = (
            sections.index(str(solution.section)),
            phases.index(phase_of(solution)),
            stations.index(float(solution.station or 0.0)),
        )
        for body in _bodies(solution):
            for values, kind in ((ratios, "ratio"), (risks, "risk")):
                values[(body - 1, *place)] = solution.fields[f"fatigue_{kind}_body_{body}"].max()
    over = "section", "phase", "station"
    variables = {
        f"fatigue_ratio_body_{body}": (over, ratio)
        for body, ratio in enumerate(ratios, 1)
        if np.isfinite(ratio).any()
    }
    probability = ("body", *over), pitting_probability(risks * PITTED_AREA)
    angles = [
        np.interp(phases, cycle["phase"], cycle["wheel_angle"].sel(section=name))
        for name in sections
    ]
    return describe(
        xr.Dataset(
            {
                **variables,
                "pitting_probability": probability,
                "wheel_angle": (("section", "phase"), np.array(angles)),
            },
            coords={"section": sections, "phase": phases, "station": stations},
        )
    )


def _bodies(solution: Solution) -> list[int]:
    """Numbers of the bodies whose fatigue a solution has."""
    return [body for body in (1, 2) if f"fatigue_risk_body_{body}" in solution.fields]
