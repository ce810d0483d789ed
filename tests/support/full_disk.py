"""A disk that is full, and what a command leaves and says there."""

import resource


class Disk:
    """A disk on which no file can be longer than so many bytes, which is as if it were full."""

    def __init__(self, room):
        self._room = room

    def __enter__(self):
        self._before = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (self._room, self._before[1]))

    def __exit__(self, *error):
        resource.setrlimit(resource.RLIMIT_FSIZE, self._before)


def files(directory):
    """Files below a directory by name, with their contents."""
    return {path: path.read_bytes() for path in directory.rglob("*") if path.is_file()}


def refusals(said):
    """What was said, without words on progress, which depend on the machine."""
    lines = said.splitlines()
    assert all(line.startswith("pyworm: ") for line in lines), said
    return [line for line in lines if not line.startswith("pyworm: still ")]
