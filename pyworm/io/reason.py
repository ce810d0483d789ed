"""The reason of a failure as one line."""


def reason_of(error: BaseException) -> str:
    """The message of an exception as one line; several lines are joined."""
    text = " ".join(str(error).split())
    if isinstance(error, MemoryError):
        return f"there is not enough memory ({text})" if text else "there is not enough memory"
    return f"{type(error).__name__}: {text}" if text else type(error).__name__
