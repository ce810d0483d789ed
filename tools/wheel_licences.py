"""Add to a wheel the licences of the libraries that auditwheel put in, and say what the whole is under.

Usage: tools/wheel_licences.py WHEEL DIRECTORY
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LIBRARIES = {
    "libfftw3": "GPL-2.0-or-later",
    "libfftw3f": "GPL-2.0-or-later",
    "libopenblas": "BSD-3-Clause",
    "libgfortran": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libquadmath": "LGPL-2.1-or-later",
    "libgomp": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libgcc_s": "GPL-3.0-or-later WITH GCC-exception-3.1",
}
"""Library -> its licence, by the copyright file of its Debian package."""


def owner(name: str) -> Path:
    """Copyright file of the Debian package that a library of this system comes from."""
    for folder in ("/usr/lib", "/lib"):
        for file in sorted(Path(folder).rglob(f"{name}.so.*")):
            said = subprocess.run(
                ["dpkg", "-S", file.resolve()], capture_output=True, text=True, check=False
            ).stdout
            copyright_file = Path("/usr/share/doc", said.partition(":")[0], "copyright")
            if said and copyright_file.is_file():
                return copyright_file
    raise SystemExit(f"no Debian package with {name} has a copyright file here")


def add_licences(unpacked: Path) -> list[str]:
    """Copy the licences of all bundled libraries; returns the expressions of licences."""
    (about,) = unpacked.glob("*.dist-info")
    folder = about / "licenses" / "bundled"
    folder.mkdir(parents=True, exist_ok=True)
    expressions = {"BSD-3-Clause": None}
    for file in sorted((unpacked / "pyworm.libs").iterdir()):
        # the library's file is libopenblasp-r0.3.21.so, its name libopenblas
        name = re.split(r"[-.]", file.name)[0].replace("libopenblasp", "libopenblas")
        if name not in LIBRARIES:
            raise SystemExit(f"{file.name}: name its licence in tools/wheel_licences.py")
        expressions[LIBRARIES[name]] = None
        shutil.copy(owner(name), folder / f"{name}.txt")
    for name in ("GPL-2", "GPL-3", "LGPL-2.1"):  # to which the packages' own files refer
        shutil.copy(Path("/usr/share/common-licenses", name), folder / f"{name}.txt")
    return list(expressions)


def state_licence(unpacked: Path, expressions: list[str]) -> None:
    """Write the licence of the whole and the licence files into the metadata."""
    (metadata,) = unpacked.glob("*.dist-info/METADATA")
    lines, blank, body = metadata.read_text().partition("\n\n")
    kept = [line for line in lines.splitlines() if not line.startswith("License-Expression:")]
    kept.append(f"License-Expression: {' AND '.join(expressions)}")
    for file in sorted((metadata.parent / "licenses" / "bundled").iterdir()):
        kept.append(f"License-File: bundled/{file.name}")
    note = (
        "\n\n*This wheel holds FFTW and is under the GNU GPL; the source is under BSD-3-Clause.*\n"
    )
    metadata.write_text("\n".join(kept) + blank + body + note)


def main(wheel: Path, directory: Path) -> None:
    """Unpack a wheel, add licences and pack it into a directory."""
    directory.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as aside:
        tool = [sys.executable, "-m", "wheel"]
        subprocess.run([*tool, "unpack", "--dest", aside, wheel], check=True, capture_output=True)
        (unpacked,) = Path(aside).iterdir()
        state_licence(unpacked, add_licences(unpacked))
        subprocess.run([*tool, "pack", "--dest-dir", directory, unpacked], check=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
