"""Files compressed as a whole, such as flank.txt.gz, unpacked for reading."""

import bz2
import gzip
import lzma
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO, Any

_OPEN: dict[bytes, Callable[..., IO[Any]]] = {
    b"\x1f\x8b": gzip.open,
    b"BZh": bz2.open,
    b"\xfd7zXZ": lzma.open,
}
"""How compressed files begin, and what opens them; formats that are archives themselves begin otherwise."""

_ENDINGS = (".gz", ".bz2", ".xz")

MOST_BYTES = 2_000_000_000
"""Bytes up to which a file is unpacked."""

BYTES_AT_ONCE = 1 << 20
"""Bytes unpacked at once."""


@contextmanager
def unpacked(path: Path) -> Iterator[Path]:
    """The file itself, or what is in it if it is compressed, for as long as the context lasts.

    ValueError if it is damaged or larger than `MOST_BYTES` when unpacked.
    """
    with path.open("rb") as file:
        begin = file.read(8)
    how = next((found for mark, found in _OPEN.items() if begin.startswith(mark)), None)
    if how is None:
        yield path
        return
    name = path.stem if path.suffix.lower() in _ENDINGS else path.name
    with TemporaryDirectory() as directory:
        plain = Path(directory) / name
        try:
            with how(path) as packed, plain.open("wb") as file:
                while part := packed.read(BYTES_AT_ONCE):
                    file.write(part)
                    if file.tell() > MOST_BYTES:
                        raise ValueError(f"has more than {MOST_BYTES / 1e9:g} GB when unpacked")
        except (OSError, EOFError, lzma.LZMAError) as error:
            raise ValueError(f"cannot be unpacked ({error}); it may be cut short") from None
        yield plain
