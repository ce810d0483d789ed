"""Friction of solved contacts, as input of the losses of drives."""

from types import SimpleNamespace

import numpy as np
import pytest

from pyworm.io.plain_dataset import described
from pyworm.result.contact_loss import MIN_LOAD_SHARE, contact_losses
from pyworm.solver.estimate import Estimate


def solved(load, power):
    """A solution of a pair of teeth that came together at phase zero under loads [N] with losses [W]."""
    instants = np.arange(len(load)) / 100
    life = described(
        {
            "life_load": (("instant",), np.array(load)),
            "life_power_loss": (("instant",), np.array(power)),
            "life_phase": (("instant",), instants),
        },
        {},
    )
    figures = SimpleNamespace(
        friction_coefficient=Estimate(0.05, 0.01), power_loss=Estimate(0.5, 0.01)
    )
    return SimpleNamespace(
        phase=instants[-1],
        load=load[-1],
        figures=figures,
        section=None,
        station=None,
        held=lambda name: life,
    )


def test_instants_without_load_tell_no_friction():
    """Oil that is pressed out as teeth come together loses power while their load is still zero."""
    load, power = [0.0, 2.5e-4, 0.9, 1.1, 50.0], [1e-4, 2.9e-4, 0.02, 0.02, 0.5]
    assert load[2] < MIN_LOAD_SHARE * load[4] < load[3]
    (loss,) = contact_losses([solved(load, power)])
    assert loss.loss_history == pytest.approx(np.array([(0.03, 0.02 / 1.1), (0.04, 0.01)]))


def test_a_steady_solution_tells_the_friction_of_its_phase_alone():
    steady = SimpleNamespace(**vars(solved([50.0], [0.5])) | {"held": lambda name: None})
    (loss,) = contact_losses([steady])
    assert loss.loss_history == () and loss.friction == 0.05
