"""Whether a solution converged, and with the accuracy asked for: what its stop reason begins with."""

ACCURATE = "the figures are as accurate as asked for"
"""Stop reason of a solution that has the accuracy asked for, or its beginning."""

LESS_ACCURATE = "less accurate than asked for"
"""Beginning of the stop reason of a converged solution whose error bars are wider than that."""


def is_accurate(reason: str) -> bool:
    """Whether a stop reason is that of a solution with the accuracy asked for."""
    return reason.startswith(ACCURATE)


def is_converged(reason: str) -> bool:
    """Whether a stop reason is that of a converged solution, whose error bars are known."""
    return reason.startswith((ACCURATE, LESS_ACCURATE))
