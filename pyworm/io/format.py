"""Numbers and durations in words for people."""


def rough(value: float) -> str:
    """A number that is not known well, as people read it: two digits, without powers of ten."""
    return f"{float(f'{value:.2g}'):.10g}"


def duration(seconds: float) -> str:
    """A time [s] as people read it."""
    return f"{rough(seconds)} s" if seconds >= 0.01 else f"{rough(seconds * 1e3)} ms"


def percent(share: float) -> str:
    """A share as people read it."""
    return f"{share * 100:.0f} %" if share >= 0.095 else f"{share * 100:.2g} %"
