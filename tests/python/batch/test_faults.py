"""Faults: damaged files, a full disk, interrupts. What is finished is kept; what is said is one sentence."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import redirect_stdout
from dataclasses import replace
from functools import partial
from io import StringIO

import fuzz
import fuzz_results
import netCDF4
import numpy as np
import pytest
import xarray as xr
from folders import CASES
from full_disk import Disk, files
from hypothesis import HealthCheck, Phase, given, settings

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, FAILED
from pyworm.planning.grid import Grid
from pyworm.result.netcdf import as_netcdf
from pyworm.result.result import _load, open_result

TRACTION = CASES / "traction_steel.toml"
GAP = CASES / "gap_example.toml"
CHEAP = ("--accuracy", "30%", "--effects", "isothermal", "--json")

# ------------------------------------------------------------------------------------ case files


drawn = partial(
    settings,
    deadline=None,
    derandomize=True,
    database=None,
    phases=[Phase.generate],
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
"""Settings of tests that draw their inputs, the same ones in each run."""


@drawn(max_examples=60)
@given(mutant=fuzz.mutants(fuzz.QUICK))
def test_a_mutated_case_is_planned_or_refused_in_one_sentence(tmp_path, mutant):
    _, _, flaws = fuzz.outcome(mutant, tmp_path)
    assert flaws == [], f"{mutant.base}: {mutant.what}"


@drawn(max_examples=12)
@given(mutant=fuzz.mutants(("point_m20_l10", "line_thermal")))
def test_a_mutated_case_that_can_be_planned_is_solved_or_marked(tmp_path, mutant):
    _, _, flaws = fuzz.solved(mutant, tmp_path)
    assert flaws == [], f"{mutant.base}: {mutant.what}"


def test_the_judge_of_mutants_sees_what_is_wrong(tmp_path, monkeypatch):
    mutant = fuzz.Mutant("none", "value", "load", b"")

    def says(text, code):
        def command(arguments):
            sys.stderr.write(text)
            return code

        monkeypatch.setattr(fuzz, "main", command)
        return fuzz.outcome(mutant, tmp_path)[2]

    assert says("pyworm: load = 3: must be a force\n", BAD_INPUT) == []
    assert says("pyworm: radius = 3: must be a length\n", BAD_INPUT) != []
    assert says("pyworm: load\nTraceback\n", BAD_INPUT) != []
    assert says("", FAILED) != []
    monkeypatch.setattr(fuzz, "main", lambda arguments: 1 // 0)
    assert fuzz.outcome(mutant, tmp_path)[2] == [
        "ZeroDivisionError: integer division or modulo by zero"
    ]


# ------------------------------------------------------------------------- result and gap files


@pytest.fixture(autouse=True, scope="module")
def without_pictures():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
        yield


def run_into(out, *ratios):
    """The command that solves the cheap case at slide-roll ratios."""
    return ["run", str(TRACTION), *CHEAP, "--slide-roll-ratio", *ratios, "--out", str(out)]


@pytest.fixture(scope="module")
def result_file(tmp_path_factory):
    """A result file of one contact."""
    out = tmp_path_factory.mktemp("whole")
    assert main(run_into(out, "0")) == 0
    return (out / "result.nc").read_bytes()


@pytest.fixture
def refusal(tmp_path, capsys):
    """What a command says when it refuses what it is given; nothing else may happen."""

    def run(*arguments):
        before = {path: path.stat().st_size for path in tmp_path.rglob("*")}
        assert main(list(arguments)) == BAD_INPUT
        said = capsys.readouterr()
        assert said.out == ""
        assert said.err.startswith("pyworm: ") and said.err.count("\n") == 1
        assert {path: path.stat().st_size for path in tmp_path.rglob("*")} == before
        return said.err

    return run


@pytest.mark.parametrize("share", [0.0, 0.001, 0.1, 0.5, 0.9, 0.999])
def test_a_truncated_result_is_refused(tmp_path, refusal, result_file, share):
    file = tmp_path / "result.nc"
    content = result_file.rstrip(b"\0")  # what fills the last block is not missed
    file.write_bytes(content[: int(share * len(content))])
    assert "is not a pyworm result" in refusal("plot", str(file))


def _drop_fields(tree):
    del tree["scene_000"]["fields"]


def _drop_provenance(tree):
    del tree.attrs["provenance"]


def _scalars_of_another_kind(tree):
    tree["scene_000"].attrs["solution"] = "[1, 2, 3]"


def _no_json(tree):
    tree.attrs["case"] = "{"


def _no_version(tree):
    del tree.attrs["format_version"]


@pytest.mark.parametrize(
    "damage", [_drop_fields, _drop_provenance, _scalars_of_another_kind, _no_json, _no_version]
)
def test_a_result_with_the_wrong_things_in_it_is_refused(tmp_path, refusal, result_file, damage):
    file = tmp_path / "result.nc"
    file.write_bytes(result_file)
    tree = xr.load_datatree(file, engine="netcdf4")
    damage(tree)
    tree.to_netcdf(file, engine="netcdf4")
    assert str(file) in refusal("plot", str(file))


@pytest.fixture(scope="module")
def sound_files(tmp_path_factory):
    """Files that are mutated: a result and a sweep."""
    return fuzz_results.bases(tmp_path_factory.mktemp("sound"), ("traction_steel", "sweep"))


@pytest.mark.long
@pytest.mark.parametrize("place", [0, 1], ids=["result", "sweep"])
def test_a_mutated_file_is_used_or_refused_in_one_sentence(tmp_path, sound_files, place):
    found = [fuzz_results.met([sound_files[place]], number, tmp_path) for number in range(25)]
    assert [flaw for _, flaws in found for flaw in flaws] == []
    assert {0, BAD_INPUT} <= {code for code, _ in found}


def test_the_judge_of_mutated_files_sees_what_is_wrong(tmp_path, monkeypatch, sound_files):
    base = sound_files[0]

    def says(text, code, command="report"):
        def run(arguments):
            sys.stderr.write(text)
            return code

        monkeypatch.setattr(fuzz_results, "main", run)
        return fuzz_results.outcome(base, command, base.content, tmp_path)[1]

    assert says("pyworm: result.nc is damaged\n", BAD_INPUT) == []
    assert says("pyworm: not drawn: x.png: no\n", FAILED, "plot") == []
    assert says("", FAILED) != []
    assert says("pyworm: a\nTraceback\n", BAD_INPUT) != []
    monkeypatch.setattr(fuzz_results, "main", lambda arguments: 1 // 0)
    assert fuzz_results.outcome(base, "plot", base.content, tmp_path)[1] == [
        "ZeroDivisionError: integer division or modulo by zero"
    ]


def _field(name, number):
    def damage(groups):
        groups["/scene_000/fields"][name][3] = number

    return damage


def _scalar(*path, value):
    def damage(groups):
        content = json.loads(groups["/scene_000"].attrs["solution"])
        inner = content
        for key in path[:-1]:
            inner = inner[key]
        inner[path[-1]] = value
        groups["/scene_000"].attrs["solution"] = json.dumps(content)

    return damage


def _no_field(groups):
    groups["/scene_000/fields"] = groups["/scene_000/fields"].drop_vars("pressure")


def _no_scenes(groups):
    for name in [name for name in groups if name.startswith("/scene")]:
        del groups[name]


def _case_is_no_table(groups):
    groups["/"].attrs["case"] = "[1, 2]"


@pytest.mark.parametrize(
    ("damage", "sentence"),
    [
        (
            _field("film", np.nan),
            "scene_000: it is marked as converged, but its field film is not finite",
        ),
        (_field("pressure", -1.0), "marked as converged, but its pressure is negative somewhere"),
        (_field("film", -1e-6), "marked as converged, but its film is not above zero everywhere"),
        (_scalar("converged", value="no"), "scene_000: converged is 'no'"),
        (_scalar("figures", "film_min", "value", value=float("nan")), "film_min is nan"),
        (_scalar("figures", "film_min", "value", value=-1e-6), "its film_min is -1e-06"),
        (_scalar("figures", "pressure_max", value=[1]), "figures.pressure_max is [1]"),
        (_no_field, "scene_000: the field pressure is missing"),
        (_no_scenes, "it has no contacts"),
        (_case_is_no_table, "case is [1, 2]"),
    ],
)
def test_a_result_that_no_solver_wrote_is_refused_with_its_error(
    tmp_path, refusal, result_file, damage, sentence
):
    file = tmp_path / "result.nc"
    file.write_bytes(result_file)
    groups = _load(file)
    damage(groups)
    file.write_bytes(as_netcdf(groups))
    for command in ("plot", "report"):
        assert sentence in refusal(command, str(file))


def test_a_film_may_cross_zero_where_a_flank_has_ended(tmp_path, result_file):
    """Flanks are continued beyond their ends, where they may pass through each other."""
    file = tmp_path / "result.nc"
    file.write_bytes(result_file)
    groups = _load(file)
    for name, number in (("covered", 0), ("film", -1e-6), ("pressure", 0.0)):
        _field(name, number)(groups)
    file.write_bytes(as_netcdf(groups))
    (solution,) = open_result(file).solutions
    assert solution.converged and solution.fields["film"].values.min() < 0


def test_a_run_over_a_damaged_result_solves_again(tmp_path, capsys, result_file):
    file = tmp_path / "result.nc"
    file.write_bytes(result_file[: len(result_file) // 2])
    assert main(run_into(tmp_path, "0")) == 0
    assert open_result(file).converged
    assert "solved before" not in capsys.readouterr().err


def gap_case(directory, file):
    """A case about a gap file in a directory."""
    case = directory / "case.toml"
    case.write_text(GAP.read_text().replace("gap_example.npz", file))
    return str(case)


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 0.99])
def test_a_truncated_gap_is_refused(tmp_path, refusal, share):
    content = GAP.with_suffix(".npz").read_bytes()
    (tmp_path / "gap.npz").write_bytes(content[: int(share * len(content))])
    assert 'contact.file = "gap.npz": ' in refusal("check", gap_case(tmp_path, "gap.npz"))


def axis():
    return 1e-5 * np.arange(-20, 21)


def bowl():
    return (axis()[:, None] ** 2 + axis() ** 2) / 0.02


@pytest.mark.parametrize(
    ("arrays", "sentence"),
    [
        ({"gap": np.full((9, 9), "1 mm"), "dx": 1e-5, "dy": 1e-5}, "npz file of numbers"),
        ({"gap": np.array([[None] * 9] * 9), "dx": 1e-5, "dy": 1e-5}, "npz file of numbers"),
        ({"gap": bowl(), "dx": np.nan, "dy": 1e-5}, "dx must be one length greater than zero"),
        ({"gap": bowl(), "dx": 1e-5, "dy": 1e-5, "x0": axis()}, "x0 must be one length"),
        ({"gap": bowl(), "dx": 1e-5, "dy": 1e-5, "x0": np.nan}, "x must increase"),
        (
            {"gap": np.full((9, 9), np.nan), "dx": 1e-5, "dy": 1e-5},
            "must be a number at the contact",
        ),
    ],
)
def test_a_gap_of_the_wrong_type_is_refused(tmp_path, refusal, arrays, sentence):
    np.savez(tmp_path / "gap.npz", **arrays)
    assert sentence in refusal("check", gap_case(tmp_path, "gap.npz"))


def test_a_gap_in_other_units_is_refused(tmp_path, refusal):
    millimetres = xr.Dataset(
        {"gap": (("y", "x"), 1e3 * bowl(), {"units": "mm"})}, coords={"x": axis(), "y": axis()}
    )
    millimetres.to_netcdf(tmp_path / "gap.nc", engine="netcdf4")
    assert "gap is in mm; it must be in metres" in refusal("check", gap_case(tmp_path, "gap.nc"))


def test_a_huge_gap_is_refused_before_it_is_read(tmp_path, refusal):
    with netCDF4.Dataset(tmp_path / "gap.nc", "w") as file:
        for name in "yx":
            file.createDimension(name, 200_000)
            file.createVariable(name, np.float64, name)
        # chunks that were never written take no room
        file.createVariable("gap", np.float64, ("y", "x"), chunksizes=(1000, 1000))
    assert "an array of 40000000000 numbers" in refusal("check", gap_case(tmp_path, "gap.nc"))


# ------------------------------------------------------------------------------------- full disk


def test_a_full_disk_is_reported_and_costs_no_earlier_result(tmp_path, capsys, result_file):
    (tmp_path / "result.nc").write_bytes(result_file)
    before, more = files(tmp_path), run_into(tmp_path, "0", "1")
    with Disk(len(result_file) // 2):
        assert main(more) == FAILED
    said = capsys.readouterr().err
    assert "result.nc" in said or "File too large" in said
    assert files(tmp_path) == before
    # with room again the same command goes on
    assert main(more) == 0
    assert len(open_result(tmp_path / "result.nc").solutions) == 2


# --------------------------------------------------------------------- a limit on processor time

LIMITED = """
import resource, sys
resource.setrlimit(resource.RLIMIT_CPU, (600, resource.RLIM_INFINITY))
import pyworm
scene = pyworm.load(sys.argv[1]).scene()
print(pyworm.solve(scene, pyworm.plan(scene, accuracy=0.05)).cost.convolutions)
"""
"""A solve under a batch system's limit, by which Linux tells processor time in ticks of milliseconds."""


def test_a_clock_of_low_resolution_still_gives_the_cost():
    line = str(CASES / "line_m20_l10.toml")
    command = [sys.executable, "-c", LIMITED, line]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    assert 0 <= float(ended.stdout) < 1e6


# ------------------------------------------------------------------------------------ interrupts


class Interrupted:
    """Sends this process a keyboard interrupt while it is in a kernel call, and tells how long that took."""

    def __init__(self, delay):
        self._timer = threading.Timer(delay, self._interrupt)

    def _interrupt(self):
        self._sent = time.process_time()
        os.kill(os.getpid(), signal.SIGINT)

    def __enter__(self):
        self._timer.start()
        return self

    def __exit__(self, kind, *rest):
        self.taken = time.process_time() - self._sent if kind is KeyboardInterrupt else float("inf")
        self._timer.cancel()
        return kind is KeyboardInterrupt


@pytest.mark.parametrize(("effects", "delays"), [("isothermal", (1.0, 2.5)), ("all", (3,))])
def test_an_interrupt_ends_a_large_solve_at_once(effects, delays):
    """Within 2 s on the largest grids; a kernel call there may take many times as long."""
    scene = pyworm.load(TRACTION).scene(slide_roll_ratio=0.5)
    plan = pyworm.plan(scene, 0.01, effects)
    base = plan.grids[-1]
    across, up = (
        (count - 1) * step / 1024 for count, step in zip(base.shape, base.spacing, strict=True)
    )
    large = replace(
        plan, grids=(Grid(base.west, base.south, across, up, 1025, 1025),), wider_grids=()
    )
    for delay in delays:
        with Interrupted(delay) as interrupted:
            pyworm.solve(scene, large)
        assert interrupted.taken < 2


def test_an_interrupted_run_keeps_what_is_finished(tmp_path):
    """One process; those with workers are in test_batch.py."""
    out = tmp_path / "out"
    process = subprocess.Popen(
        [sys.executable, "-m", "pyworm.cli", "run", str(TRACTION), *CHEAP, "--out", str(out)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not list(out.glob("scenes/[!.]*.nc")):
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    said = process.communicate()[1]
    assert process.returncode == 128 + signal.SIGINT
    assert said == (
        "pyworm: stopped; contacts already solved are kept, the same command continues from there\n"
    )
    kept = list(out.glob("scenes/*"))
    assert kept and all(open_result(path).converged for path in kept)
    assert not (out / "result.nc").exists()


# ------------------------------------------------------------------------------------- same bits

BITS = """
import sys
from dataclasses import replace
from hashlib import sha256
import pyworm
scene = pyworm.load(sys.argv[1]).scene(slide_roll_ratio=0.5)
plan = pyworm.plan(scene, 0.3, "all")
small = replace(plan, wider_grids=(), largest_grid=plan.grids[-1].nodes)
solution = pyworm.solve(scene, small)
print(solution.figures)
for name, field in sorted(solution.fields.items()):
    print(name, sha256(field.values.tobytes()).hexdigest())
"""


def test_run_to_run_and_one_or_two_threads_give_the_same_bits():
    said = [
        subprocess.run(
            [sys.executable, "-c", BITS, str(TRACTION)],
            # on a busy machine threads that wait in a loop would hold each other up
            env=os.environ | {"OMP_NUM_THREADS": threads, "OMP_WAIT_POLICY": "passive"},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for threads in ("1", "2")
    ]
    with redirect_stdout(StringIO()) as printed, pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["-c", str(TRACTION)])
        exec(BITS, {})
    assert said[0].count("\n") > 8
    assert said[0] == said[1] == printed.getvalue()
