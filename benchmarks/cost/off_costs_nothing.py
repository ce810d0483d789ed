"""What an effect costs that is switched off: instructions of the kernel's steps, counted by valgrind.

One contact, solved as a Newtonian film of one temperature and with everything on. Of each solve's Newton
steps the instructions are counted, and those among them in modules of rheology, heat and roughness. The
kernel is built once more for it, without the vector instructions that valgrind does not know. Run from the
repository's root, with valgrind installed:

    python benchmarks/cost/off_costs_nothing.py
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BUILD = Path("build/counted")
STEPS = ("*film_newton_MOD_film_step*", "*thermal_step_MOD_heated_step*")
RHEOLOGY_HEAT_ROUGHNESS = {
    *(
        path.stem
        for folder in ("heat", "thermal")
        for path in Path("fortran", folder).glob("*.f90")
    ),
    *("flow_laws", "thermal_properties", "shear_stress", "shear_flow", "shear_profile"),
    *("sheared_reynolds", "sheared_couplings", "shear_fields", "rough_surfaces"),
}
PROGRAM = """
import pyworm
scene = pyworm.load("cases/traction_steel.toml").scene(slide_roll_ratio=0.5)
solution = pyworm.solve(scene, pyworm.plan(scene, 0.2, {effects!r}, ("film",)))
assert solution.converged, solution.stop_reason
"""


def build() -> Path:
    """The kernel for a processor that valgrind knows."""
    options = ["--buildtype=release", "-Dfortran_args=-march=x86-64-v3"]
    if not BUILD.exists():
        subprocess.run(["meson", "setup", BUILD, *options], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["meson", "compile", "-C", BUILD], check=True, stdout=subprocess.DEVNULL)
    return next(BUILD.glob("fortran/_core*.so"))


def count(package: Path, effects: str, out: Path) -> dict[str, int]:
    """Instructions of a solve's steps by module; those of libraries and of no module under ""."""
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    valgrind = ["valgrind", "--tool=callgrind", "--collect-atstart=no"]
    valgrind += [f"--toggle-collect={step}" for step in STEPS]
    program = [sys.executable, "-S", "-c", f"import sys; sys.path += {sys.path[1:]!r}\n"]
    program[-1] += PROGRAM.format(effects=effects)
    subprocess.run(
        [*valgrind, f"--callgrind-out-file={out}", *program],
        check=True,
        cwd=package,  # first where modules are looked for
        env=environment,
        capture_output=True,
    )
    shown = subprocess.run(
        ["callgrind_annotate", "--threshold=100", out], check=True, capture_output=True, text=True
    ).stdout
    counts: dict[str, int] = {}
    for line in shown.splitlines():
        found = re.match(r" *([\d,]+) \([ \d.]+%\)  \S*?:(?:__(\w+?)_MOD_)?", line)
        if found and "PROGRAM TOTALS" not in line:
            module = found[2] or ""
            counts[module] = counts.get(module, 0) + int(found[1].replace(",", ""))
    return counts


def main() -> None:
    kernel = build()
    with tempfile.TemporaryDirectory() as directory:
        package = Path(directory)
        ignored = shutil.ignore_patterns("_core*", "__pycache__")
        shutil.copytree("pyworm", package / "pyworm", ignore=ignored)
        shutil.copy(kernel, package / "pyworm")
        shutil.copytree("cases", package / "cases")
        for effects in ("isothermal", "all"):
            counts = count(package, effects, package / "callgrind.out")
            total = sum(counts.values())
            theirs = sum(n for module, n in counts.items() if module in RHEOLOGY_HEAT_ROUGHNESS)
            print(
                f"{effects:10} {total:15,} instructions, {theirs:15,} in rheology, heat and roughness"
            )


if __name__ == "__main__":
    main()
