"""The map of the suite: which corner of the parameter space costs what, and what failed there."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from trial import Verdict


@dataclass(frozen=True)
class Axis:
    """What runs along a side of a panel."""

    trait: str
    """The trait of a scene."""
    label: str
    """Its name with its unit."""
    unit: float = 1.0
    """The unit in SI."""


M = Axis("moes_m", "Moes' load parameter M")
L = Axis("moes_l", "Moes' lubricant parameter L")
PRESSURE = Axis("hertz_pressure", "Hertz pressure, GPa", 1e9)
ELLIPTICITY = Axis("ellipticity", "axis along y over axis along x")
FILM = Axis("film", "expected central film, nm", 1e-9)
SLIDING = Axis("slide_roll_ratio", "slide-roll ratio")
SPEED = Axis("speed", "entrainment, m/s")
SUPPLY_RATIO = Axis("supply_ratio", "oil supplied over expected film")
LAMBDA = Axis("lambda", "expected central film over roughness")

PANELS: dict[str, tuple[tuple[Axis, Axis], ...]] = {
    "isothermal": ((M, L), (ELLIPTICITY, PRESSURE), (FILM, M)),
    "thermal": ((M, L), (SLIDING, SPEED), (FILM, PRESSURE)),
    "starved": ((M, L), (SUPPLY_RATIO, PRESSURE), (FILM, ELLIPTICITY)),
    "rough": ((M, L), (LAMBDA, PRESSURE), (FILM, SLIDING)),
}
"""Kind of random scene -> its panels: what runs across, what runs up."""

DOTS_PER_INCH = 130


def draw_map(
    verdicts: Mapping[str, Sequence[Verdict]],
    traits: Mapping[str, dict[str, float]],
    path: Path,
) -> None:
    """Draw random scenes by kind: dots coloured by cost, crosses where a scene did not converge.

    Args:
        verdicts: Kind -> what its scenes came to.
        traits: Name of a scene -> its traits.
        path: The picture.
    """
    kinds = [kind for kind in PANELS if verdicts.get(kind)]
    figure = Figure(figsize=(13.0, 4.2 * len(kinds)), layout="constrained")
    rows = figure.subplots(len(kinds), 3, squeeze=False)
    costs = [one.cost for kind in kinds for one in verdicts[kind] if one.cost]
    norm = LogNorm(min(costs), max(costs))
    for kind, row in zip(kinds, rows, strict=True):
        done = sum(one.outcome == "converged" for one in verdicts[kind])
        for panel, axes in zip(row, PANELS[kind], strict=True):
            _panel(panel, axes, verdicts[kind], traits, norm)
        told = f"{kind}: {done} of {len(verdicts[kind])} scenes converged; crosses did not"
        row[0].set_title(told, loc="left")
    figure.colorbar(
        ScalarMappable(norm, "viridis"),
        ax=rows,
        label="cost: convolutions on the finest grid times its nodes, million",
    )
    figure.savefig(path, dpi=DOTS_PER_INCH)


def _panel(
    panel: Axes,
    axes: tuple[Axis, Axis],
    verdicts: Sequence[Verdict],
    traits: Mapping[str, dict[str, float]],
    norm: LogNorm,
) -> None:
    def places(some: Sequence[Verdict]) -> list[list[float]]:
        return [[traits[one.name][axis.trait] / axis.unit for one in some] for axis in axes]

    good = [one for one in verdicts if one.outcome == "converged"]
    bad = [one for one in verdicts if one.outcome != "converged"]
    panel.scatter(*places(good), c=[one.cost for one in good], norm=norm, cmap="viridis", s=18)
    panel.scatter(*places(bad), marker="x", c="tab:red", s=45)
    panel.set(xscale="log", yscale="log", xlabel=axes[0].label, ylabel=axes[1].label)
