"""How much time buys how much certainty of a whole mesh cycle: the ZI worm drive.

The least film and the mean power loss over the cycle, from 3, 5 and 9 phases, solved to 5 and 1 %: their
errors against 9 phases at 1 %, over the processor time of all phases. What was solved is kept in
results/accuracy/cycle.csv, and the next run goes on from there.
"""

import csv
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from time import process_time

import numpy as np
from accuracy_page import fill, markdown
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter
from scipy.interpolate import CubicSpline

import pyworm
from pyworm.plots.style import write

CASE = Path("cases/zi_sharif_2001.toml")
FIRST, LAST = 0.1, 0.9
"""Phases between which the cycle is looked at; before and after teeth meet along their edges."""

ACCURACIES = (0.05, 0.01)
COUNTS = (3, 5, 9)
DENSE = np.linspace(FIRST, LAST, 801)

OUT = Path("results/accuracy/cycle.csv")
PICTURE = Path("docs/pictures/accuracy_cycle.png")


@dataclass(frozen=True)
class Phase:
    """What one phase gave."""

    accuracy: float
    phase: float
    film: float
    film_error: float
    loss: float
    loss_error: float
    seconds: float


def solved(case, phase: float, accuracy: float) -> Phase:
    """One phase to one accuracy."""
    started = process_time()
    scene = case.scene(phase=phase)
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy))
    figures = solution.figures
    return Phase(
        accuracy,
        phase,
        figures.film_min.value,
        figures.film_min.error,
        figures.power_loss.value,
        figures.power_loss.error,
        process_time() - started,
    )


def cycle(phases: np.ndarray, found: list[Phase]) -> tuple[float, float]:
    """Least film [m] and mean loss [W] over the cycle, by splines through the phases."""
    film = CubicSpline(phases, np.log([one.film for one in found]))
    loss = CubicSpline(phases, [one.loss for one in found])
    return float(np.exp(film(DENSE).min())), float(loss.integrate(FIRST, LAST) / (LAST - FIRST))


def every() -> dict[float, list[Phase]]:
    """Accuracy -> all phases, those solved before not again."""
    case = pyworm.load(CASE)
    known = {(one.accuracy, round(one.phase, 6)): one for one in kept()}
    found = {}
    for accuracy in ACCURACIES:
        found[accuracy] = []
        for phase in np.linspace(FIRST, LAST, COUNTS[-1]):
            key = accuracy, round(float(phase), 6)
            if key not in known:
                known[key] = solved(case, float(phase), accuracy)
                keep(list(known.values()))
                print(known[key], flush=True)
            found[accuracy].append(known[key])
    return found


def kept() -> list[Phase]:
    """Phases of an earlier run."""
    if not OUT.exists():
        return []
    with OUT.open() as file:
        return [
            Phase(**{name: float(value) for name, value in row.items()})
            for row in csv.DictReader(file)
        ]


def keep(phases: list[Phase]) -> None:
    OUT.parent.mkdir(parents=True, exist_ok=True)
    with OUT.open("w", newline="") as file:
        writer = csv.DictWriter(file, [field.name for field in fields(Phase)])
        writer.writeheader()
        writer.writerows(asdict(phase) for phase in phases)


def draw(found: dict[float, list[Phase]], whole: tuple[float, float], bars) -> Figure:
    """Errors of the least film and of the mean loss against processor time."""
    phases = np.linspace(FIRST, LAST, COUNTS[-1])
    figure = Figure(figsize=(11, 4.6), layout="constrained")
    figure.suptitle(f"{CASE.stem}: a whole mesh cycle, phases {FIRST:g} to {LAST:g}")
    titles = (
        f"Least film of the cycle ({whole[0] * 1e6:.3f} µm)",
        f"Mean power loss ({whole[1]:.0f} W)",
    )
    for number, (panel, title) in enumerate(zip(figure.subplots(1, 2), titles, strict=True)):
        for accuracy, colour in zip(ACCURACIES, ("tab:orange", "tab:blue"), strict=True):
            points = []
            for count in COUNTS:
                some = slice(None, None, (COUNTS[-1] - 1) // (count - 1))
                value = cycle(phases[some], found[accuracy][some])[number]
                seconds = sum(one.seconds for one in found[accuracy][some])
                points.append((seconds, max(abs(value / whole[number] - 1), 1.2e-4)))
            panel.loglog(
                *zip(*points, strict=True),
                "o-",
                color=colour,
                label=f"each phase to {accuracy:.0%}",
            )
            for count, (x, y) in zip(COUNTS, points, strict=True):
                panel.annotate(
                    f"{count}", (x, y), (4, 4), textcoords="offset points", fontsize=9, color=colour
                )
        panel.axhspan(
            1e-6, bars[number], color="0.88", zorder=0, label="error bar of the reference"
        )
        panel.set_ylim(1e-4, 1.0)
        panel.set(title=title, xlabel="processor time of all phases / s", ylabel="relative error")
        panel.yaxis.set_major_formatter(FuncFormatter(lambda share, _: f"{share * 100:g} %"))
        panel.grid(True, color="0.9")
    panel.legend(frameon=False, title="number: phases in the cycle", fontsize=9)
    return figure


def main() -> None:
    found = every()
    phases = np.linspace(FIRST, LAST, COUNTS[-1])
    best = found[ACCURACIES[-1]]
    whole = cycle(phases, best)
    thinnest = min(best, key=lambda one: one.film)
    losses = sum(one.loss_error * one.loss for one in best) / sum(one.loss for one in best)
    bars = thinnest.film_error, losses
    rows = [["each phase to", "phases", "s", "least film / µm", "error", "mean loss / W", "error"]]
    for accuracy, all_phases in found.items():
        for count in COUNTS:
            some = slice(None, None, (COUNTS[-1] - 1) // (count - 1))
            film, loss = cycle(phases[some], all_phases[some])
            rows.append(
                [
                    f"{accuracy * 100:g} %",
                    f"{count}",
                    f"{sum(one.seconds for one in all_phases[some]):.0f}",
                    f"{film * 1e6:.4f}",
                    f"{abs(film / whole[0] - 1) * 100:.2g} %",
                    f"{loss:.1f}",
                    f"{abs(loss / whole[1] - 1) * 100:.2g} %",
                ]
            )
    print(markdown(rows))
    fill("cycle", markdown(rows))
    write(draw(found, whole, bars), PICTURE)


if __name__ == "__main__":
    main()
