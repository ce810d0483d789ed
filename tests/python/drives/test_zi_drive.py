"""A whole ZI drive from its case file to its cycle, coarse: film, friction, heat and loss against physics.

The teeth of Sharif, Kong, Evans and Snidle (2001) under a torque. What the fields must obey is written here
from the paper's own equations and table 2; nothing is compared with an earlier run.
"""

import json

import numpy as np
import pytest
from folders import CASES
from zi_drives import coarse_patterns

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.result.result import open_result
from pyworm.scene.scales import scales

CASE = CASES / "zi_drive.toml"
PHASES = "0.2", "0.5", "0.8"
INLET = 60 + 273.15
EYRING, LIMIT = 3e6, 100e6
WORM_SPEED, WHEEL_SPEED = 50 * np.pi, 50 * np.pi * 3 / 59
ARM = 0.239
"""Of the tooth force about the wheel's axis [m]."""


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    """The result of a run, and what it said as JSON."""
    out = tmp_path_factory.mktemp("drive")
    with pytest.MonkeyPatch.context() as patch:
        said = []
        patch.setattr("pyworm.cli.run.print_json", said.append)
        patch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
        coarse_patterns(patch)  # which nothing here looks at
        options = ["--accuracy", "20%", "--phase", *PHASES, "--json", "--out", str(out)]
        assert main(["run", str(CASE), *options]) == CONVERGED
    return open_result(out / "result.nc"), json.loads(json.dumps(said[0]))


def viscosity(pressure, temperature):
    """Roelands' law with the paper's constants, equation 20 [Pa s]."""
    growth = (1 + 5.1e-9 * pressure) ** 0.227 * ((temperature - 138) / (INLET - 138)) ** -0.782
    return 0.227 * np.exp((np.log(0.227) + 9.67) * (growth - 1))


def stress(newtonian):
    """Stress at which the paper's oil shears as a Newtonian one at another, equation 6 [Pa]."""
    low, high = np.zeros_like(newtonian), np.minimum(newtonian, 0.995 * LIMIT)
    for _ in range(60):
        middle = (low + high) / 2
        faster = EYRING * np.sinh(middle / EYRING) / (1 - (middle / LIMIT) ** 2) > newtonian
        low, high = np.where(faster, low, middle), np.where(faster, middle, high)
    return low


class Contact:
    """Fields of a solved phase where pressure counts, and the area of a node."""

    def __init__(self, solution):
        fields = solution.fields
        self.cell = float(fields.x.diff("x").mean() * fields.y.diff("y").mean())
        counts = fields.pressure.values > 0.02 * float(fields.pressure.max())

        def taken(name):
            return fields[name].values[counts]

        self.pressure, self.film = taken("pressure"), taken("film")
        self.sliding = np.hypot(taken("sliding_x"), taken("sliding_y"))
        self.walls = (taken("temperature_body_1") + taken("temperature_body_2")) / 2
        self.middle, self.power = taken("temperature_middle"), taken("friction_power")
        mean = (2 * self.middle + self.walls) / 3  # of a parabola
        self.stress = stress(viscosity(self.pressure, mean) * self.sliding / self.film)


def test_friction_is_the_oil_s_stress_over_each_contact(drive):
    for solution in drive[0].solutions:
        contact = Contact(solution)
        friction = contact.stress.sum() * contact.cell / solution.load
        assert solution.figures.friction_coefficient.value == pytest.approx(friction, rel=0.03)


def test_loss_is_the_work_of_that_stress(drive):
    for solution in drive[0].solutions:
        contact = Contact(solution)
        work = (contact.stress * contact.sliding).sum() * contact.cell
        assert solution.figures.power_loss.value == pytest.approx(work, rel=0.04)


def test_films_are_as_warm_over_their_walls_as_their_heat_makes_them(drive):
    """q h/(8 k) halfway, k under pressure by the paper's appendix; on average, as heat is carried along."""
    for solution in drive[0].solutions:
        contact = Contact(solution)
        share = 1.56e-9 * contact.pressure / (1 + 0.61e-9 * contact.pressure)
        rise = contact.power * contact.film / (8 * 0.148 * (1 + share))
        assert (contact.middle - contact.walls).sum() == pytest.approx(rise.sum(), rel=0.08)
        assert abs(solution.figures.heat_balance) < 0.01


def test_films_are_between_those_of_cold_oil_and_of_oil_as_hot_as_the_flanks(drive):
    """Nijenbanning, Venner and Moes' films of oil at the inlet's temperature and at the worm's largest."""
    case = pyworm.load(CASE)
    for solution in drive[0].solutions:
        figures = solution.figures
        groups = scales(case.scene(phase=solution.phase)).groups
        cold = float(nijenbanning_venner_moes(groups).central)
        hot = (viscosity(0, figures.temperature_max_body_1.value) / 0.227) ** 0.67 * cold
        assert hot < figures.film_central.value < 0.85 * cold
        # side lobes: 0.47 of the middle in a circle, more across a slender contact, less along one
        assert 0.3 < figures.film_min.value / figures.film_central.value < 0.84


def test_all_pairs_in_mesh_carry_the_torque(drive):
    cycle = drive[0].mesh_cycle
    phase, load = cycle["load_phase"].values, cycle["tooth_load"].values
    moment = load * cycle["lever"].values
    pitch = cycle.attrs["pitch"]
    assert pitch == pytest.approx(120 / 239.8, rel=2e-3)  # degrees of the worm's turn
    for at in np.linspace(0, pitch, 7):
        pairs = sum(np.interp(at + n * pitch, phase, moment, 0, 0) for n in (-1, 0, 1, 2))
        assert pairs == pytest.approx(4e3, rel=0.01)


def test_the_worm_s_power_less_the_loss_is_the_wheel_s(drive):
    cycle = drive[1]["cycle"]
    assert cycle["wheel_torque_N_m"] == pytest.approx(4e3, rel=1e-9)
    given, got = cycle["worm_torque_N_m"] * WORM_SPEED, cycle["wheel_torque_N_m"] * WHEEL_SPEED
    assert given - got == pytest.approx(cycle["power_loss_W"], rel=5e-3)
    assert cycle["efficiency"] == pytest.approx(got / given, rel=2e-4)
    frictions = [one.figures.friction_coefficient.value for one in drive[0].solutions]
    assert min(frictions) < cycle["friction"] < max(frictions)
    # pairs that together press with T2 over their arm slide about as fast as that in mid-mesh
    sliding = Contact(drive[0].solutions[1]).sliding.mean()
    assert cycle["power_loss_W"] == pytest.approx(cycle["friction"] * 4e3 / ARM * sliding, rel=0.04)


def test_the_cycle_agrees_with_its_phases(drive):
    result, said = drive
    cycle, figures = said["cycle"], [one.figures for one in result.solutions]
    assert cycle["phases"] == [float(phase) for phase in PHASES]
    assert cycle["film_min"]["value_m"] == min(of.film_min.value for of in figures)
    assert cycle["pressure_max"]["value_Pa"] == max(of.pressure_max.value for of in figures)
    hottest = max(of.temperature_max_film.value for of in figures)
    assert cycle["temperature_max"]["film"]["value_C"] == pytest.approx(hottest - 273.15)
    assert cycle["bulk_temperature_C"] == pytest.approx({"sump": 60, "worm": 60, "wheel": 60})
    # by transient films; at this accuracy loads may be off by a tenth
    assert abs(cycle["load_moved_by_lift"]["share"]) < 0.1
