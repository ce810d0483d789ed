"""The reason of a failure as one line."""


def reason_of(error: BaseException) -> str:
    """The message of an exception as one line; several lines are joined."""
    said = " ".join(str(error).split())
    if isinstance(error, MemoryError):
        return f"there is not enough memory ({said})" if said else "there is not enough memory"
    return f"{type(error).__name__}: {said}" if said else type(error).__name__
