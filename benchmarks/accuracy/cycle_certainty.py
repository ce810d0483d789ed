"""How much time buys how much certainty of a whole mesh cycle: the ZI worm drive.

The least film and the mean power loss over the cycle, from the middle phase alone and from 3, 5 and 9 phases,
with the effects that 5 and 1 % call for and, to 5 %, without rheology and heat: their errors against 9 phases
at 1 %, over the processor time of all phases. What was solved is kept in results/accuracy/cycle.csv, and the
next run goes on from there.
"""

import sys
from dataclasses import asdict, dataclass
from math import nan
from pathlib import Path
from time import process_time

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter
from scipy.interpolate import CubicSpline

import pyworm
from pyworm.plots.layout import write

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record
from kept_rows import keep_rows, kept_rows

CASE = Path("cases/zi_sharif_2001.toml")
FIRST, LAST = 0.1, 0.9
"""Phases between which the cycle is looked at; before and after teeth meet along their edges."""

MODELS = {
    "isothermal, to 5 %": ("isothermal", 0.05, "tab:green"),
    "to 5 %": (("auto", "-squeeze"), 0.05, "tab:orange"),
    "to 1 %": (("auto", "-squeeze"), 0.01, "tab:blue"),
}
"""What is solved -> effects, accuracy of each phase, colour; the last is the reference. Films are steady, as
those of the source."""

COUNTS = (1, 3, 5, 9)
PHASES = np.linspace(FIRST, LAST, COUNTS[-1])
DENSE = np.linspace(FIRST, LAST, 801)

FLOOR = 1e-4
"""Least error shown."""

OUT = Path("results/accuracy/cycle.csv")
PICTURE = Path("docs/pictures/accuracy_cycle.png")


@dataclass(frozen=True)
class Phase:
    """What one phase gave."""

    model: str
    phase: float
    film: float
    film_error: float
    loss: float
    loss_error: float
    seconds: float


def solved(case, phase: float, model: str) -> Phase:
    """One phase."""
    effects, accuracy, _ = MODELS[model]
    started = process_time()
    scene = case.scene(phase=phase)
    figures = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects)).figures
    loss = figures.power_loss
    return Phase(
        model,
        phase,
        figures.film_min.value,
        figures.film_min.error,
        nan if loss is None else loss.value,
        nan if loss is None else loss.error,
        process_time() - started,
    )


def some(count: int) -> slice:
    """Which phases, evenly over the cycle; of one the middle."""
    middle = len(PHASES) // 2
    return (
        slice(middle, middle + 1)
        if count == 1
        else slice(None, None, (len(PHASES) - 1) // (count - 1))
    )


def cycle(found: list[Phase], count: int) -> tuple[float, float]:
    """Least film [m] and mean loss [W] over the cycle, by splines through some of its phases."""
    used = found[some(count)]
    films, losses = ([getattr(one, name) for one in used] for name in ("film", "loss"))
    if count == 1:
        return films[0], losses[0]
    least = np.exp(CubicSpline(PHASES[some(count)], np.log(films))(DENSE).min())
    if not np.isfinite(losses).all():
        return float(least), nan
    mean = CubicSpline(PHASES[some(count)], losses).integrate(FIRST, LAST) / (LAST - FIRST)
    return float(least), float(mean)


def seconds(found: list[Phase], count: int) -> float:
    """Processor time of some phases [s]."""
    return sum(one.seconds for one in found[some(count)])


def every() -> dict[str, list[Phase]]:
    """Model -> all phases, those solved before not again."""
    case = pyworm.load(CASE)
    known = {
        (one.model, round(one.phase, 6)): one
        for one in (Phase(**row) for row in kept_rows(OUT, {"model"}))
    }
    found = {}
    for model in MODELS:
        found[model] = []
        for phase in PHASES:
            key = model, round(float(phase), 6)
            if key not in known:
                known[key] = solved(case, float(phase), model)
                keep_rows(OUT, [asdict(phase) for phase in known.values()])
                print(known[key], flush=True)
            found[model].append(known[key])
    return found


def draw(found: dict[str, list[Phase]], whole: tuple[float, float], bars) -> Figure:
    """Errors of the least film and of the mean loss against processor time."""
    figure = Figure(figsize=(11, 4.8), layout="constrained")
    figure.suptitle(
        f"Error over a mesh cycle against CPU time: {CASE.stem}, phases {FIRST:g} to {LAST:g}"
    )
    titles = (
        f"Minimum film thickness of the cycle ({whole[0] * 1e6:.3f} µm)",
        f"Mean power loss ({whole[1]:.0f} W)",
    )
    for number, (panel, title) in enumerate(zip(figure.subplots(1, 2), titles, strict=True)):
        for model, (_, _, colour) in MODELS.items():
            errors = [
                (
                    seconds(found[model], count),
                    abs(cycle(found[model], count)[number] / whole[number] - 1),
                )
                for count in COUNTS
            ]
            # the reference itself has no error to show
            points = [(x, y, n) for (x, y), n in zip(errors, COUNTS, strict=True) if y > FLOOR]
            if points:
                x, y, _ = zip(*points, strict=True)
                panel.loglog(x, y, "o-", color=colour)
            for x, y, count in points:
                panel.annotate(
                    f"{count}", (x, y), (4, 4), textcoords="offset points", fontsize=9, color=colour
                )
        panel.axhspan(FLOOR / 10, bars[number], color="0.88", zorder=0)
        panel.set_xscale("log")
        panel.set_ylim(FLOOR, 1.0)
        panel.set_xlim(0.3, 100.0)
        panel.set(title=title, xlabel="CPU time of all phases / s", ylabel="relative error")
        panel.yaxis.set_major_formatter(FuncFormatter(lambda share, _: f"{share * 100:g} %"))
        panel.xaxis.set_major_formatter(FuncFormatter(lambda time, _: f"{time:g}"))
        panel.grid(True, color="0.9")
    handles = [
        Line2D([], [], marker="o", color=colour, label=f"each phase {model}")
        for model, (_, _, colour) in MODELS.items()
    ]
    handles.append(Patch(color="0.88", label="uncertainty of the reference"))
    figure.legend(
        handles=handles,
        loc="outside lower center",
        ncols=len(handles),
        frameon=False,
        title="numbers: phases in the cycle",
    )
    return figure


def main() -> None:
    found = every()
    best = list(found.values())[-1]
    whole = cycle(best, COUNTS[-1])
    losses = sum(one.loss_error * one.loss for one in best) / sum(one.loss for one in best)
    bars = min(best, key=lambda one: one.film).film_error, losses
    rows = []
    for model, phases in found.items():
        for count in COUNTS:
            film, loss = cycle(phases, count)
            told = [f"{loss:.1f}", f"{abs(loss / whole[1] - 1) * 100:.2g} %"]
            rows.append(
                [
                    model,
                    f"{count}",
                    f"{seconds(phases, count):.0f}",
                    f"{film * 1e6:.4f}",
                    f"{abs(film / whole[0] - 1) * 100:.2g} %",
                    *(told if np.isfinite(loss) else ["", ""]),
                ]
            )
    values = "h_min / um", "error of h_min", "mean power loss / W", "error of power loss"
    record("cycle_certainty", ("each phase", "phases", "time / s", *values), rows)
    write(draw(found, whole, bars), PICTURE)


if __name__ == "__main__":
    main()
