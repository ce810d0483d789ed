"""The kernel for a level of x86-64 is chosen by what the processor has."""

import subprocess
import sys

import pytest

from pyworm.kernel.levels import BASE, CPU_FLAGS, built, chosen, features, supported

CPUINFO = """processor	: 0
model name	: some
flags		: fpu {}
bogomips	: 1

processor	: 1
flags		: fpu
"""

V2 = set(CPU_FLAGS["x86-64-v2"])
V3 = V2 | set(CPU_FLAGS["x86-64-v3"])
V4 = V3 | set(CPU_FLAGS["x86-64-v4"])


def test_features_are_those_of_the_first_processor():
    assert features(CPUINFO.format("sse4_1 avx")) == {"fpu", "sse4_1", "avx"}
    assert features("no such line") == set()


@pytest.mark.parametrize(
    ("has", "highest"),
    [
        (set(), BASE),
        (V2 - {"popcnt"}, BASE),
        (V2, "x86-64-v2"),
        (V3 - {"fma"}, "x86-64-v2"),
        (V3, "x86-64-v3"),
        # levels build upon each other, whatever else a processor has
        (V4 - {"avx2"}, "x86-64-v2"),
        (V4, "x86-64-v4"),
    ],
)
def test_a_level_needs_all_of_its_features(has, highest):
    assert supported(has)[-1] == highest


def test_the_highest_that_is_there_and_runs_is_taken(tmp_path):
    for level in ("x86-64-v2", "x86-64-v4"):
        (tmp_path / level).mkdir()
        (tmp_path / level / "_core_x.cpython-311.so").touch()
    others = built(tmp_path)
    assert list(others) == ["x86-64-v2", "x86-64-v4"]
    assert chosen(others, V4, None) == "x86-64-v4"
    assert chosen(others, V3, None) == "x86-64-v2"
    assert chosen(others, V4, BASE) == BASE
    with pytest.raises(ImportError, match=r"PYWORM_LEVEL=x86-64-v4: .* has x86-64, x86-64-v2"):
        chosen(others, V3, "x86-64-v4")
    with pytest.raises(ImportError, match="PYWORM_LEVEL=i386"):
        chosen(others, V3, "i386")


def test_a_build_of_ones_own_has_a_single_kernel():
    code = "from pyworm.kernel.core import LEVEL, EXTENSION; print(LEVEL, EXTENSION.name)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    level, name = said.stdout.split()
    assert (level, name.partition(".")[0]) == ("None", "_core")
