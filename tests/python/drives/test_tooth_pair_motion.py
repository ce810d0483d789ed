"""The life of a tooth pair begins with flanks that come together."""

import argparse
from dataclasses import replace
from pathlib import Path

import gear_draws
import numpy as np
import pytest

import pyworm
from pyworm.case.case import case_of
from pyworm.cli.shared import wanted_places
from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.worm.loads.tooth_pair_motion import FIRST_SEPARATION, TOUCH
from pyworm.drives.worm.sensitivity import sensitivity_data
from pyworm.io.input_error import CaseError
from pyworm.scene.scales import scales


@pytest.fixture(scope="module")
def drive():
    return pyworm.load("cases/zi_drive.toml").drive


def contacts(drive, count=120):
    """Contacts of the life of a tooth pair at equal steps of time, and the phases passed then."""
    life = drive.scene(0.5).past.life
    seconds = np.linspace(0, life.duration, count, endpoint=False)
    passed = seconds * abs(drive.phases_per_second) - drive.life.before
    return [life.at(float(one)) for one in seconds], passed


@pytest.mark.parametrize("driver", ["worm", "wheel"])
def test_flanks_come_together_before_the_pair_is_given_its_load(drive, driver):
    drive = replace(drive, driver=driver)
    of_life, passed = contacts(drive)
    apart = [one.separation is not None for one in of_life]
    given = apart.index(False)
    assert 3 < given and not any(apart[given:])
    assert passed[0] < 0 and passed[given] < 0.05
    # each is at its phase, which runs to 0 where the wheel drives
    phases = passed if driver == "worm" else 1 - passed
    assert [one.phase for one in of_life] == pytest.approx(phases, abs=1e-9)
    # they come nearer, to less than what dry flanks would be apart
    distances = [least_distance(one) for one in of_life[:given]]
    film = scales(of_life[given - 1]).film
    # or as far as their separation is known
    assert (FIRST_SEPARATION if driver == "worm" else 2.0) * film == pytest.approx(
        distances[0], rel=0.5
    )
    assert np.all(np.diff(distances) < 0)
    # then the load rises from next to nothing, without a jump
    touch = TOUCH * float(drive.springs.loads[-1])
    assert {one.load for one in of_life[:given]} == {touch}
    loads = [one.load for one in of_life[given:]]
    assert touch <= loads[0] < 5 * touch and max(np.abs(np.diff(loads))) < 0.1 * max(loads)


def least_distance(contact):
    """Distance of the undeformed flanks where it is least [m]."""
    x, y = np.meshgrid(np.linspace(-0.012, 0.012, 97), np.linspace(-4e-3, 4e-3, 97), indexing="ij")
    gap, covered = contact.gap(x, y)
    return contact.separation + gap[covered].min()


def test_a_given_load_begins_and_ends_with_the_mesh_cycle():
    drive = pyworm.load("cases/zi_sharif_2001.toml").drive
    life = drive.scene(0.25).past
    assert life.life.duration == pytest.approx(1 / drive.phases_per_second)
    assert life.seconds == pytest.approx(0.25 / drive.phases_per_second)
    assert life.life.at(0.0).separation is None and life.life.at(0.0).load == 14e3


def test_other_phases_are_refused_though_the_life_is_longer(drive):
    for phase in (-0.01, 1.001):
        with pytest.raises(ValueError, match="touches from phase 0 to phase 1"):
            drive.scene(phase)


@pytest.mark.parametrize("rate", [2.0, -2.0])
def test_time_runs_from_before_the_first_phase_in_either_sense(rate):
    life = ToothLife(lambda phase: phase, rate, before=0.2, after=0.1).past(0.25)
    assert life.life.duration == pytest.approx(0.65)
    assert life.life.touched == pytest.approx(0.1)
    first, last = (-0.2, 1.1) if rate > 0 else (1.2, -0.1)
    assert life.life.at(0.0) == pytest.approx(first)
    assert life.life.at(0.65) == pytest.approx(last)
    assert life.life.at(life.seconds) == pytest.approx(0.25)


@pytest.fixture(scope="module")
def undercut():
    """A case of a worm of five threads whose neighbouring teeth carry all of the load at 0.3 and 0.7."""
    return case_of(gear_draws.drive(0).tables, "undercut", Path())


def test_a_pair_begins_under_load_where_its_flanks_end_before_they_come_together(undercut):
    """Beyond the cusp that the hob leaves, where the relative radius of curvature is negative."""
    first = undercut.scene(phase=0.1)
    assert first.past.life.at(0.0).load > 0
    assert undercut.drive.life.before == 0.0
    radii = [undercut.drive.contact_beyond(phase).radii for phase in (-0.12, 0.0)]
    assert min(radii[0]) < 0 < min(radii[1])


def test_of_several_phases_those_without_load_are_left_out(undercut, capsys):
    options = argparse.Namespace(phase=[0.1, 0.3, 0.7], section=None, station=None)
    options.slide_roll_ratio = None
    assert [place.phase for place in wanted_places(undercut, options)] == [0.1]
    said = (
        "pyworm: warning: --phase 0.3, 0.7: neighbouring teeth carry all of the load; not solved\n"
    )
    assert capsys.readouterr().err == said
    options.phase = [0.3]
    with pytest.raises(
        CaseError, match=r"--phase 0.3: .* carry all of the load; the pair carries some at 0.1, "
    ):
        wanted_places(undercut, options)
    with pytest.raises(CaseError, match="carries no load there"):
        undercut.scene(phase=0.3)


def test_a_drive_whose_neighbours_carry_all_at_mid_mesh_has_its_data(undercut, monkeypatch):
    """The contact at mid-mesh is compared with others under the largest load of the cycle then."""
    other = replace(undercut.drive)
    monkeypatch.setattr(
        type(other), "normal_load", lambda of, phase: 0.0 if 0.25 < phase < 0.8 else 500 * phase
    )
    assert other.mid_mesh_load == 500
    assert sensitivity_data(other).attrs["varied_load"] == 500
