"""Summary of a result on the console: regime, film thickness, friction, efficiency, neglected effects."""

from collections.abc import Iterator, Sequence
from math import isfinite

from pyworm.drives.mesh_loss import MeshLoss
from pyworm.formulas.lubrication import Lubrication
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.io.quantity_text import UNKNOWN, percent
from pyworm.report.table import Table
from pyworm.result.headline import of_all
from pyworm.result.mesh_cycle import DriveCycle
from pyworm.scene.index import ContactIndex
from pyworm.solver.neglected_effects import AS_IF_SMOOTH, NeglectedEffects
from pyworm.solver.solution import Solution

REGIMES: dict[Lubrication, str] = {
    "full": "full film",
    "mixed": "mixed",
    "boundary": "boundary",
    "unknown": "not judged",
}
"""Lubrication -> its name as a value."""

Row = tuple[str, ...]
"""Label, value, numerical uncertainty, model uncertainty, remark."""


def summary_table(
    solutions: Sequence[Solution], cycle: DriveCycle | None, loss: MeshLoss | None
) -> Table:
    """What decides over a result, at the worst of its converged contacts.

    `loss` is that of a drive whose cycle has none.
    """
    sound = [solution for solution in solutions if solution.converged]
    neglected = of_all(solutions)
    known = loss is not None or (cycle is not None and cycle.loss is not None)
    rows: list[Row] = [_regime(neglected)]
    if not sound:
        rows.append((QUANTITIES["film_min"].title(), "not converged"))
    names = ("film_min",) if known else ("film_min", "friction_coefficient")
    for name in names if sound else ():
        rows += _worst(QUANTITIES[name], sound, neglected)
    if cycle is not None and cycle.loss is not None:
        rows += _loss_of_cycle(cycle, neglected)
    elif loss is not None:
        rows += _loss(loss, neglected)
    accuracy = max((solution.accuracy for solution in solutions), default=0.0)
    rows += _neglected(neglected, accuracy)
    head = ("Summary", "Value", "Numerical\nuncertainty", "Model\nuncertainty", "Remark")
    full = [(*row, *[""] * (len(head) - len(row))) for row in rows]
    shown = [n for n in range(len(head)) if n < 2 or any(row[n] for row in full)]
    return Table(
        head=tuple(head[n] for n in shown),
        rows=tuple(tuple(row[n] for n in shown) for row in full),
        texts=(len(shown) - 1,) if len(head) - 1 in shown else (),
    )


def _regime(neglected: NeglectedEffects) -> Row:
    """Lubrication regime, with the specific film thickness that it follows from."""
    remark = ""
    if neglected.lambda_min is not None:
        remark = f"{QUANTITIES['specific_film'].symbol} {neglected.lambda_min:.2g}"
    elif neglected.mixed_above_roughness_m is not None:
        remark = "no roughness given"
    return ("Lubrication regime", REGIMES[neglected.lubrication], "", "", remark)


def _worst(
    quantity: Quantity, sound: Sequence[Solution], neglected: NeglectedEffects
) -> Iterator[Row]:
    """A quantity at the contact where it is worst."""
    known = [solution for solution in sound if quantity.value_in(solution) is not None]
    if not known:
        yield quantity.title(), "not simulated"
        return
    extreme = min if quantity.extreme == "minimum" else max
    solution = extreme(known, key=lambda solution: quantity.value_in(solution).value)
    figure = quantity.value_in(solution)
    label = quantity.worst_title() if len(sound) > 1 else quantity.title()
    smooth = [AS_IF_SMOOTH] * (neglected.as_if_smooth and quantity.extreme == "maximum")
    remark = ", ".join(filter(None, (str(ContactIndex.of(solution)), *smooth)))
    model = "" if figure.model is None else _relative(figure.model)
    yield label, quantity.text(figure.value), _relative(figure.error), model, remark


Errors = tuple[float, float | None]
"""Relative numerical uncertainty of a quantity, and that of the model of roughness where there is one."""


def _loss_of_cycle(cycle: DriveCycle, neglected: NeglectedEffects) -> Iterator[Row]:
    """Mean friction and efficiency over a whole mesh cycle."""
    loss = present(cycle.loss, "loss")
    share, model, of_share = loss.efficiency, loss.model_error, loss.efficiency_model_error
    friction = loss.error / loss.power, None if model is None else model / loss.power
    efficiency = loss.efficiency_error / share, None if of_share is None else of_share / share
    return _mesh_rows(loss.friction, friction, share, efficiency, cycle.missing, neglected)


def _loss(loss: MeshLoss, neglected: NeglectedEffects) -> Iterator[Row]:
    """Mean friction and efficiency of a drive without a table of its cycle's loss."""
    share = loss.loss / loss.power / loss.efficiency
    friction = loss.error, loss.model
    efficiency = share * loss.error, None if loss.model is None else share * loss.model
    return _mesh_rows(loss.friction, friction, loss.efficiency, efficiency, loss.missing, neglected)


def _mesh_rows(
    friction: float,
    friction_errors: Errors,
    efficiency: float,
    efficiency_errors: Errors,
    missing: str,
    neglected: NeglectedEffects,
) -> Iterator[Row]:
    """Mean friction and efficiency of the whole mesh; contacts that the latter lacks are named."""
    smooth = AS_IF_SMOOTH if neglected.as_if_smooth else ""
    coefficient, share = QUANTITIES["mesh_friction"], QUANTITIES["mesh_efficiency"]
    for quantity, value, (error, model), lacking in (
        (coefficient, coefficient.text(friction), friction_errors, ""),
        (share, f"{efficiency * 100:.2f} %", efficiency_errors, missing),
    ):
        label = quantity.title().removesuffix(" of the teeth")
        by_model = "" if model is None else _relative(model)
        yield label, value, _relative(error), by_model, ", ".join(filter(None, (smooth, lacking)))


def _neglected(neglected: NeglectedEffects, accuracy: float) -> Iterator[Row]:
    """Effects that are off though they may change results by more than the accuracy."""
    if not neglected.influence:
        yield "Neglected effects", f"none > {percent(accuracy)}"
    for name, fraction in neglected.influence.items():
        shown = "> 99 %" if fraction > 0.99 else f"≤ {percent(fraction)}"
        yield f"Neglected: {name}", shown, "", "", "change of results"


def _relative(error: float) -> str:
    return f"± {percent(error)}" if isfinite(error) else UNKNOWN
