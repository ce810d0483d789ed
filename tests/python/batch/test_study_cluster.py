"""A study from Python on the workers of dask.distributed: the same table as in this process."""

import numpy as np
import pytest
from contacts import roller

import pyworm

distributed = pytest.importorskip("distributed")

HOW = {"accuracy": 0.1, "effects": "isothermal", "quantities": ("film",), "progress": False}


def contact(load, speed):
    return roller(load=load, velocities=(1.1 * speed, 0.9 * speed))


@pytest.fixture(scope="module")
def scheduler():
    """Address of a scheduler with one worker, in a process of its own."""
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster:
        yield cluster.scheduler_address


def test_a_study_is_solved_by_other_machines(scheduler, tmp_path):
    values = {"load": (5e4, 1e5), "speed": (0.5, 1.0)}
    there = pyworm.sweep(contact, scheduler=scheduler, out=tmp_path, **values, **HOW)
    assert there.converged.all()
    here = pyworm.sweep(contact, **values, **HOW)
    for name in ("film_central_m", "film_min_m", "load", "speed"):
        assert np.array_equal(there.table[name], here.table[name])
    # what workers solved is kept by the caller and read again without them
    assert pyworm.sweep(contact, out=tmp_path, **values, **HOW).table.identical(there.table)


def test_a_scene_that_cannot_be_sent_says_why(scheduler):
    with pytest.raises(ValueError, match="other processes"):
        pyworm.sweep(
            lambda load: roller(load=load, gap=lambda x: (50 * x * x, x == x), radius=0.01),
            load=(5e4, 1e5),
            scheduler=scheduler,
            **HOW,
        )
