"""The recipes of docs/how-to/run-batches.md, run: an array of jobs, Snakemake, dask-jobqueue.

One job is killed in mid-run each time; the table has the bits of a run without any of this.
"""

import json
import re
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest
from conftest import ROOT, table
from slurm import kill_one, wait_for_all

PAGE = (ROOT / "docs/how-to/run-batches.md").read_text()
SHARES = 3
PATIENCE = 400.0


def block(part):
    """The block of code of the page that has a part."""
    (found,) = [text for text in re.findall(r"```\w+\n(.*?)```", PAGE, re.DOTALL) if part in text]
    return found.replace("40", str(SHARES)).replace("/scratch/study", "study")


def submitted(environment, *words):
    """Number of a job submitted."""
    said = subprocess.run(
        ["sbatch", "--parsable", *words],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    return said.stdout.strip()


def wait_until(ready, what):
    until = time.monotonic() + PATIENCE
    while not ready():
        assert time.monotonic() < until, what
        time.sleep(0.02)


def scenes(folder):
    return len(list(folder.glob("study/scenes/[!.]*.json")))


def test_the_array_of_jobs_with_one_killed(slurm, study, alone):
    (study / "share.sh").write_text(block("#SBATCH --array"))
    job = submitted(slurm, "share.sh")
    wait_until(lambda: scenes(study), "no scene is solved")
    killed = int(kill_one(slurm).partition("_")[2])
    last = f"{Path(sys.executable).parent}/pyworm sweep study.toml --out study"
    submitted(slurm, f"--dependency=afterany:{job}", "--wrap", last)
    wait_for_all(slurm, PATIENCE)
    logs = {
        share: (study / f"slurm-{job}_{share}.out").read_text() for share in range(1, SHARES + 1)
    }
    for share, log in logs.items():
        print(f"--- slurm-{job}_{share}.out\n{log}")
        assert ("ended" in log) == (share != killed) and ("Killed" in log) == (share == killed)
        assert f"share {share}/{SHARES}: 0 %" in log or share == killed
    whole = next(log for share, log in logs.items() if share != killed)
    assert all(f": {tenth}0 %, " in whole for tenth in range(1, 9))
    assert table(study / "study").identical(alone)


def test_snakemake_with_slurm_for_its_rules(slurm, study, alone):
    pytest.importorskip("snakemake", reason="no snakemake here; make test-cluster installs it")
    (study / "Snakefile").write_text(block("rule share"))
    submit = "sbatch --parsable --cpus-per-task=1"
    command = [
        *(sys.executable, "-m", "snakemake", "--jobs", "2", "--latency-wait", "5"),
        *("--executor", "cluster-generic", "--cluster-generic-submit-cmd", submit),
    ]
    # one job of the first run is killed, and its rule fails; the same command continues from there
    with subprocess.Popen(
        command, env=slurm, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as first:
        wait_until(lambda: scenes(study), "no scene is solved")
        kill_one(slurm)
        time.sleep(1)
        first.send_signal(signal.SIGINT)
        print(first.communicate(timeout=PATIENCE)[0][-3000:])
    subprocess.run([sys.executable, "-m", "snakemake", "--unlock"], env=slurm, check=True)
    wait_for_all(slurm, PATIENCE)
    again = subprocess.run(
        [*command, "--rerun-incomplete"],
        env=slurm,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    print(again.stderr[-3000:])
    assert again.returncode == 0
    assert table(study / "study").identical(alone)


CLUSTER = "cluster.py"


def test_dask_jobqueue_with_a_worker_killed(slurm, study, alone):
    pytest.importorskip(
        "dask_jobqueue", reason="no dask-jobqueue here; make test-cluster installs it"
    )
    program = block("SLURMCluster(").replace(
        'memory="2GB"', 'memory="2GB", interface="lo", log_directory="logs"'
    )
    (study / CLUSTER).write_text(textwrap.dedent(program))
    with subprocess.Popen(
        [sys.executable, CLUSTER],
        *(-1, None, subprocess.PIPE, subprocess.PIPE),
        env=slurm,
        text=True,
    ) as keeper:
        address = keeper.stdout.readline().strip()
        with subprocess.Popen(
            [
                *(sys.executable, "-m", "pyworm.cli", "sweep", "study.toml", "--out", "study"),
                *("--scheduler", address, "--json"),
            ],
            env=slurm,
            stdout=subprocess.PIPE,
            text=True,
        ) as sweep:
            wait_until(lambda: scenes(study), "no scene is solved")
            kill_one(slurm)
            said = sweep.communicate(timeout=PATIENCE)[0]
        assert len(json.loads(said)["scenes"]) == alone.sizes["scene"]
        logs = "".join(path.read_text() for path in (study / "logs").iterdir())
        keeper.communicate("\n", timeout=PATIENCE)
    subprocess.run(["scancel", "--user=root"], env=slurm, check=True)
    wait_for_all(slurm, PATIENCE)
    print(*re.findall(r"pyworm: .*", logs), sep="\n")
    assert f"scene 1 of {alone.sizes['scene']}, solved" in logs
    assert table(study / "study").identical(alone)
