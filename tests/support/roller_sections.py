"""Worm sections for the tests, around the drive of `cases/roller_ref.toml`."""

from math import radians

import numpy as np

from pyworm.drives.roller_worm import dataset, roller_path
from pyworm.drives.roller_worm.envelope import RollerEnvelope
from pyworm.drives.roller_worm.profile import RollerProfile
from pyworm.drives.roller_worm.section import WormSection

CENTRE_DISTANCE = 0.16
ROLLERS = 35


def envelope(
    shape="cylinder",
    radius=6.5e-3,
    throat=0.4,
    tilt=0.0,
    half_angle=0.0,
    flank="driving",
    hand=-1,
    height=0.0,
    crown=None,
    profile=None,
):
    """The flank that rollers envelop; throat diameter over centre distance, angles in rad."""
    profile = profile or RollerProfile(radius, 14e-3, shape, half_angle, crown)
    pitch_radius = CENTRE_DISTANCE * (1 - throat / 2)
    seat = CENTRE_DISTANCE, pitch_radius, tilt, height
    return RollerEnvelope(profile, float(ROLLERS), *seat, flank, hand)


def section(name="left", outer=60.0, inner=5.0, **options):
    """A section between two wheel angles [deg]."""
    flank = {"left": "driving", "right": "idle"}[name]
    ends = (inner, outer) if name == "left" else (-outer, -inner)
    first, last = (radians(end) for end in ends)
    return WormSection(name, envelope(flank=flank, **options), first, last, -6e-3, 6e-3, ROLLERS)


def coarse_cycle(monkeypatch) -> None:
    """Fewer phases and design values for the data of a cycle, in tests that do not ask for them."""
    monkeypatch.setattr(dataset, "PHASES", np.linspace(0.0, 1.0, 3))
    monkeypatch.setattr(roller_path, "PLACES_PER_PITCH", 4)
    monkeypatch.setattr(dataset, "TILTS", np.zeros(1))
    monkeypatch.setattr(dataset, "VARIED", {name: np.ones(1) for name in dataset.VARIED})
