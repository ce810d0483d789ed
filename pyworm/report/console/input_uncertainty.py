"""Table of the uncertainty of results by inputs, by the model and by the numbers."""

from pyworm.io.quantity_text import percent
from pyworm.report.table import Table
from pyworm.result.input_uncertainty import InputUncertainty, UncertainResult

MOST_NAMED = 3
"""Inputs that are named for a result, those with the largest shares."""

SMALLEST_SHARE = 0.01
"""Share of the variance by inputs below which an input is not named."""


def uncertainty_table(found: InputUncertainty) -> Table:
    """Results with their standard uncertainties, and the inputs that contribute most."""
    inputs = "; ".join(f"{key} {text}" for key, text in zip(found.inputs, found.texts, strict=True))
    return Table(
        head=(
            *("Standard uncertainty", "Value", "Combined", "By inputs", "By model", "By numbers"),
            "Largest contributions by inputs",
        ),
        rows=tuple(_row(found, each) for each in found.results),
        title="Uncertainty by inputs",
        note=f"Inputs: {inputs}.",
        texts=(6,),
        narrow=True,
    )


def _row(found: InputUncertainty, each: UncertainResult) -> tuple[str, ...]:
    quantity = each.quantity
    scale = quantity.scale
    widths = (each.combined, each.inputs, each.model, each.numerical)
    shares = sorted(zip(each.shares.tolist(), found.inputs, strict=True), reverse=True)
    named = [
        f"{key} {percent(share)}" for share, key in shares[:MOST_NAMED] if share >= SMALLEST_SHARE
    ]
    return (
        quantity.title(),
        quantity.text(each.value),
        *(f"{width * scale:.2g}" if width else "" for width in widths),
        ", ".join(named),
    )
