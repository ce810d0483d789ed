"""Table of the uncertainty of results by inputs, by the model and by the numbers."""

from pyworm.io.quantities import BODIES
from pyworm.io.quantity_text import percent
from pyworm.report.table import Table
from pyworm.result.input_uncertainty import InputUncertainty, UncertainResult

MOST_NAMED = 3
"""Inputs that are named for a result, those with the largest shares."""

SMALLEST_SHARE = 0.01
"""Share of the variance by inputs below which an input is not named."""


def uncertainty_tables(
    found: InputUncertainty, bodies: tuple[str, str] = BODIES
) -> tuple[Table, ...]:
    """Results with their standard uncertainties; where there are several inputs, which contribute most."""
    inputs = "; ".join(f"{key} {text}" for key, text in zip(found.inputs, found.texts, strict=True))
    uncertainties = Table(
        head=("Standard uncertainty", "Value", "All", "Inputs", "Model", "Numbers"),
        rows=tuple(_row(each, bodies) for each in found.results),
        title="Uncertainty by inputs, by the model and by the numerical solution",
        note=f"Inputs: {inputs}.",
        narrow=True,
    )
    if len(found.inputs) == 1:
        return (uncertainties,)
    contributions = Table(
        head=("Share in the variance by inputs", "Largest contributions"),
        rows=tuple(
            (each.quantity.title(bodies), _contributions(found, each)) for each in found.results
        ),
        texts=(1,),
        narrow=True,
    )
    return uncertainties, contributions


def _row(each: UncertainResult, bodies: tuple[str, str]) -> tuple[str, ...]:
    quantity = each.quantity
    widths = (each.combined, each.inputs, each.model, each.numerical)
    return (
        quantity.title(bodies),
        quantity.text(each.value),
        *(f"{width * quantity.scale:.2g}" if width else "" for width in widths),
    )


def _contributions(found: InputUncertainty, each: UncertainResult) -> str:
    shares = sorted(zip(each.shares.tolist(), found.inputs, strict=True), reverse=True)
    return ", ".join(
        f"{key} {percent(share)}" for share, key in shares[:MOST_NAMED] if share >= SMALLEST_SHARE
    )
