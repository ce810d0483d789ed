"""Fit values of a case to measurements from Python, as `pyworm calibrate` does."""

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory

from pyworm.batch.calibration import Bench, BenchFit, fitted
from pyworm.batch.in_python import CaseLike, as_case, executor, progress_of
from pyworm.batch.operating_points import Solving
from pyworm.case.case import Case
from pyworm.case.measured_table import read_measured
from pyworm.case.parameters import parameters
from pyworm.io import units
from pyworm.io.given import Names, WithUnit, kind_of, number
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import effect_names
from pyworm.result.calibration import Calibration, FittedRow, FittedValue


def calibrate(
    case: CaseLike,
    measured: str | Path,
    fit: Sequence[str],
    *,
    accuracy: WithUnit | None = None,
    effects: Names | None = None,
    out: str | Path | None = None,
    processes: int = 1,
    progress: bool | Progress = True,
) -> Calibration:
    """Fit values of a case to measurements by weighted least squares.

    Args:
        case: A case file, its tables, or a gear set (`WormDrive`).
        measured: CSV with a row for each measurement: conditions by dotted keys of the case, and measured
            quantities, each with a column u(NAME) of its standard uncertainty; units in brackets in the head.
        fit: What is fitted: "boundary_friction", "limiting_stress", "eyring_stress", "alpha", "z",
            "roughness_slope", "conductance" or a dotted key of the case, each with bounds or without,
            "alpha = 8 1/GPa to 25 1/GPa".
        accuracy, effects: As of `pyworm.plan`; by default the case's.
        out: Directory in which solved contacts are kept and found again; by default none are.
        processes: Processes that solve; more than one need a script with `if __name__ == "__main__":`.
        progress: Whether a bar shows the progress, or what is called instead.

    Raises:
        CaseError: Invalid input, measurements that the case does not compute, or too few of them.
        NotSolvedError: A contact without a solution.
    """
    with ExitStack() as stack:
        where = stack.enter_context(TemporaryDirectory()) if out is None else out
        checked = as_case(case)
        solving = Solving(
            Path(where),
            checked.accuracy
            if accuracy is None
            else number("accuracy", accuracy, kind_of(units.Share)),
            checked.effects if effects is None else effect_names(effects),
            stack.enter_context(executor(processes, None)),
            stack.enter_context(progress_of(progress)),
        )
        return calibration(bench_of(checked, measured, fit, solving), Path(measured).name)


def bench_of(case: Case, measured: str | Path, fit: Sequence[str], solving: Solving) -> Bench:
    """Measurements of a case and what is fitted to them; CaseError as of `calibrate`."""
    if not case.content:
        raise CaseError(f"{case.name}: a case of a result cannot be calibrated; load its file")
    try:
        return Bench(case, read_measured(measured), parameters(case, fit), solving)
    except CaseError as error:
        text = str(error)
        raise CaseError(
            text if text.startswith(f"{measured}") else f"{case.name}: {text}"
        ) from None


def calibration(bench: Bench, data_name: str) -> Calibration:
    """The calibration of measurements; errors as of `calibrate`."""
    best = fitted(bench)
    statistics = best.statistics
    return Calibration(
        bench.case.name,
        data_name,
        _values(best),
        _rows(best),
        tuple(map(tuple, statistics.correlation.tolist())),
        statistics.combinations,
        statistics.chi_squared,
        statistics.degrees,
        best.numerical,
    )


def _values(best: BenchFit) -> tuple[FittedValue, ...]:
    statistics = best.statistics
    found = zip(
        best.bench.parameters,
        best.values.tolist(),
        statistics.standard.tolist(),
        statistics.half_widths.tolist(),
        best.at_bound,
        strict=True,
    )
    return tuple(
        FittedValue(
            name=parameter.name,
            keys=parameter.keys,
            unit=parameter.unit,
            value=parameter.shown(value),
            standard=parameter.shown(standard),
            half_width=parameter.shown(half_width),
            start=parameter.shown(parameter.start),
            low=parameter.shown(parameter.low),
            high=parameter.shown(parameter.high),
            at_bound=held,
        )
        for parameter, value, standard, half_width, held in found
    )


def _rows(best: BenchFit) -> tuple[FittedRow, ...]:
    numbers = zip(
        best.bench.rows,
        best.before.tolist(),
        best.responses.tolist(),
        best.leave_one_out.tolist(),
        strict=True,
    )
    return tuple(
        FittedRow(
            line=row.line,
            conditions={**row.conditions, **row.place},
            quantity=row.quantity,
            measured=row.value,
            standard=row.standard,
            before=before,
            fitted=fitted_value,
            leave_one_out=leave_one_out,
        )
        for row, before, fitted_value, leave_one_out in numbers
    )
