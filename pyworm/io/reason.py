"""Why something failed, in one line."""


def reason_of(error: BaseException) -> str:
    """What went wrong, in one line: a message of several has its lines joined."""
    said = " ".join(str(error).split())
    if isinstance(error, MemoryError):
        return f"there is not enough memory ({said})" if said else "there is not enough memory"
    return f"{type(error).__name__}: {said}" if said else type(error).__name__
