"""Rules of practice for gear oil, specific film and wear, heating of films: examples and trends."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pyworm.formulas.gear_oil import (
    AGMA_GRADES,
    FEED_PRESSURES,
    FOOT_PER_MINUTE,
    INCH,
    ISO_GRADES,
    LARGEST_JET,
    PSI,
    SMALLEST_JET,
    agma_parallel,
    agma_worm,
    application_method,
    nearest_grade,
    oil_flow,
    oil_jets,
    pitch_line_viscosity,
    worm_table,
)
from pyworm.formulas.thermal_reduction import (
    gupta,
    hsu_lee,
    murch_wilson,
    thermal_loading,
    wilson_sheu,
)
from pyworm.formulas.wear_distress import (
    composite_roughness,
    distress_probability,
    film_of_probability,
    rate_wear,
    regime,
    specific_film,
)

RPM = np.pi / 30
C = 273.15
GPM = 3.785411784e-3 / 60
MICROINCH = 1e-6 * INCH


@pytest.mark.parametrize(("feet", "viscosity", "grade"), [(3000, 127.8, 150), (400, 350, 320)])
def test_pitch_line_rule_of_errichello(feet, viscosity, grade):
    """128 cSt and ISO 150 for the turbine drives, 350 cSt and "close to ISO 320" for the speed increasers."""
    wanted = pitch_line_viscosity(feet * FOOT_PER_MINUTE)
    assert wanted * 1e6 == pytest.approx(viscosity, abs=0.06)
    assert nearest_grade(wanted) == grade


def test_agma_250_04_as_errichello_reads_it():
    """ISO 150 or 220 at 16 in and 50 to 125 degF; ISO 150 for the small drives that failed with ISO 68."""
    assert agma_parallel(16 * INCH, 25 + C).grades == (150, 220)
    small = agma_parallel(6 * INCH, 25 + C).grades
    assert 150 in small and 68 not in small


def test_agma_250_04_for_worms():
    assert agma_worm(0.3048, 1500 * RPM, 20 + C).grades == (AGMA_GRADES["7"],) == (460,)
    assert "to 12 in" in agma_worm(12 * INCH, 450 * RPM, 20 + C).row
    assert agma_worm(0.3048, 450 * RPM, 20 + C).grades == (680,)
    assert agma_worm(0.3048, 450 * RPM, 5 + C).grades == (460,)


@pytest.mark.parametrize(
    ("size", "rpm", "sump", "mineral", "synthetic"),
    [
        (80, 300, 65, (220, 320), (150, 220)),
        (80, 1500, 90, (150, 220), (100, 150)),
        (150, 500, 80, (320, 460), (220, 320)),
        (300, 100, 65, (460, 680), (320, 460)),
        (80, 300, 110, (680, 1000), (460, 680, 1000)),
        (300, 100, 50, (460, 680), (320, 460)),
    ],
)
def test_worm_table_row_by_row(size, rpm, sump, mineral, synthetic):
    args = (size * 1e-3, rpm * RPM, sump + C)
    assert worm_table(*args, synthetic=False).grades == mineral
    assert worm_table(*args, synthetic=True).grades == synthetic


@pytest.mark.parametrize(
    ("size", "rpm", "sump"), [(304.8, 1500, 60), (80, 700, 70), (30, 300, 60), (80, 300, 85)]
)
def test_worm_table_is_silent_in_its_gaps(size, rpm, sump):
    assert worm_table(size * 1e-3, rpm * RPM, sump + C, synthetic=True) is None


@given(st.floats(26e-6, 1.2e-3))
def test_nearest_grade_is_within_half_a_step(viscosity):
    grade = nearest_grade(viscosity)
    assert grade in ISO_GRADES
    distance = abs(np.log(viscosity * 1e6 / grade))
    assert distance == min(abs(np.log(viscosity * 1e6 / other)) for other in ISO_GRADES)


@pytest.mark.parametrize(("power", "flow", "gpm"), [(200, "copious", 1.0), (200, "lean", 0.25)])
def test_oil_flow_examples_of_errichello(power, flow, gpm):
    assert oil_flow(power * 745.6999, flow) / GPM == pytest.approx(gpm, rel=1e-6)


def test_flow_takes_away_the_loss_of_teeth():
    """200 hp/gpm with a loss of 1 % warms oil of 870 kg/m3 and 2000 J/(kg K) by 14 K."""
    flow = oil_flow(100e3, "copious")
    assert 0.01 * 100e3 / (flow * 870 * 2000) == pytest.approx(13.6, abs=0.1)


@given(st.floats(1e-6, 1e-3), st.floats(2e4, 1e6), st.integers(1, 20))
def test_jets_pass_the_flow(flow, pressure, number):
    jets = oil_jets(flow, pressure, 870, number)
    area = number * np.pi / 4 * jets.diameter**2
    assert 0.7 * area * jets.velocity == pytest.approx(flow)
    assert jets.velocity**2 * 870 / 2 == pytest.approx(pressure)
    if jets.most:
        assert oil_jets(flow, pressure, 870, jets.most).diameter >= SMALLEST_JET * (1 - 1e-6)
    assert oil_jets(flow, pressure, 870, jets.most + 1).diameter < SMALLEST_JET


def test_advice_on_jets():
    good = oil_jets(1.73 * GPM, 30 * PSI, 870, 4)
    assert SMALLEST_JET < good.diameter < LARGEST_JET and good.advice == ()
    assert "clog: choose at most" in oil_jets(0.5 * GPM, 100 * PSI, 870, 20).advice[0]
    assert "more than one" in oil_jets(1 * GPM, 30 * PSI, 870, 1).advice[-1]
    assert "are large" in oil_jets(50 * GPM, 30 * PSI, 870, 2).advice[0]
    assert "20 and 100 psi" in oil_jets(1.73 * GPM, 2 * FEED_PRESSURES[1], 870, 4).advice[-1]


@pytest.mark.parametrize(
    ("feet", "words"),
    [
        (400, "splash: gears dip"),
        (4000, "splash with baffles"),
        (6000, "incoming side of the mesh, bearings may live on splash"),
        (7500, "incoming side of the mesh, bearings pressure-fed"),
        (9000, "outgoing side, where"),
        (17000, "2/3 of the oil at the outgoing"),
        (21000, "by experiment"),
    ],
)
def test_methods_of_errichello_by_speed(feet, words):
    assert words in application_method(feet * FOOT_PER_MINUTE)


# ------------------------------------------------------------------------------------ wear


@pytest.mark.parametrize(("film", "printed", "ratio"), [(2.1, 0.073, 0.0743), (2.7, 0.097, 0.0955)])
def test_specific_films_of_errichello_follow_from_his_own_numbers(film, printed, ratio):
    """Films in microinches over 20 microinches rms on both profiles; what he prints is 2 % off."""
    roughness = composite_roughness(20 * MICROINCH, 20 * MICROINCH)
    exact = specific_film(film * MICROINCH, roughness)
    assert exact == pytest.approx(ratio, abs=6e-5)
    assert exact == pytest.approx(printed, rel=0.02)


def test_probabilities_of_wear_of_errichello():
    """Above 95 % at 0.073, and 94 % printed at 0.097; 400 ft/min."""
    velocity = 400 * FOOT_PER_MINUTE
    assert distress_probability(0.073, velocity) == pytest.approx(0.970, abs=6e-4)
    assert distress_probability(0.097, velocity) == pytest.approx(0.94, abs=0.025)


@given(st.floats(0, 3), st.floats(0.01, 1), st.sampled_from([0.5, 20.0, 100.0]))
def test_thicker_films_wear_less(ratio, more, velocity):
    assert distress_probability(ratio + more, velocity) <= distress_probability(ratio, velocity)


@pytest.mark.parametrize(
    ("probability", "velocity", "ratio"), [(0.5, 2, 0.4777), (0.05, 20, 1.4056), (0.9, 100, 0.7746)]
)
def test_film_of_a_probability(probability, velocity, ratio):
    """Mean plus 0, 1.6449 and -1.2816 standard deviations of the rows to 5 m/s, to 60 m/s and above."""
    assert film_of_probability(probability, velocity) == pytest.approx(ratio, abs=6e-5)


def test_wear_rating_takes_the_thinnest_film():
    rating = rate_wear(np.array([0.3, 0.1, 0.2]) * 1e-6, 0.5e-6, 2.0)
    assert (rating.worst, rating.regime) == (1, "boundary")
    assert rating.specific_film_min == pytest.approx(0.2)
    assert rating.probability == pytest.approx(0.9015, abs=6e-5)  # 1.29 deviations below the mean
    assert [regime(ratio) for ratio in (0.99, 1, 2.9, 3)] == [
        "boundary",
        "mixed",
        "mixed",
        "full film",
    ]


# --------------------------------------------------------------------------------- heating

loadings = st.floats(0, 100)
slides = st.floats(0, 2)


@given(slides)
def test_films_are_whole_without_heating(slide):
    for factor in (
        wilson_sheu(0.0, slide),
        gupta(0.0, slide, 0.003),
        hsu_lee(0.0, slide, 4500, 1e-4),
        murch_wilson(0.0),
    ):
        assert factor == 1


@given(loadings, slides, st.floats(1.01, 2))
def test_heating_thins_films(loading, slide, more):
    for factor in (
        lambda loading, slide: wilson_sheu(loading, slide),
        lambda loading, slide: gupta(loading, slide, 0.0),
        lambda loading, slide: hsu_lee(loading, slide, 4500, 1e-4),
    ):
        value = factor(loading, slide)
        assert 0 < value <= 1
        assert factor(loading * more, slide) <= value
        assert factor(loading, slide / more) >= value


@given(st.floats(0, 10))
def test_three_factors_of_pure_rolling_agree(loading):
    values = [wilson_sheu(loading, 0.0), murch_wilson(loading), gupta(loading, 0.0, 0.0)]
    assert max(values) / min(values) < 1.08


@given(st.floats(0, 50), slides)
def test_wilson_and_sheu_with_the_sum_of_the_speeds(loading, slide):
    """0.1 belongs to u1 + u2, whose loading is four times that of the mean: 0.241/4^0.64 = 0.0992."""
    summed = 1 / (1 + 0.1 * (1 + 14.8 * (slide / 2) ** 0.83) * (4 * loading) ** 0.64)
    assert wilson_sheu(loading, slide) == pytest.approx(summed, rel=0.01)


def test_thermal_loading():
    assert thermal_loading(0.1, 0.04, 5.0, 0.14) == pytest.approx(0.1 * 0.04 * 25 / 0.14)


def test_gupta_ends_where_his_numerator_does():
    with pytest.raises(ValueError, match="Gupta's numerator"):
        gupta(1000.0, 0.0, 0.006)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: pitch_line_viscosity(3000), "pitch line velocity = 3000 m/s"),
        (lambda: nearest_grade(220), "kinematic viscosity at 40 degC = 220 m2/s"),
        (lambda: agma_parallel(16, 25 + C), "centre distance = 16 m"),
        (lambda: agma_worm(0.3, 157, 70), "ambient temperature = 70 K"),
        (lambda: worm_table(0.3, 157, 60, synthetic=True), "sump temperature = 60 K"),
        (lambda: oil_flow(1000, "plenty"), 'flow = "plenty": must be one of "copious"'),
        (lambda: oil_jets(1e-4, 30, 870, 2), "feed pressure = 30 Pa"),
        (lambda: specific_film(0.2, 0.5e-6), "minimum film thickness = 0.2 m"),
        (lambda: composite_roughness(0.4, 0.4), "roughness = 0.4 m"),
        (lambda: distress_probability(0.5, 400), "pitch line velocity = 400 m/s"),
        (lambda: thermal_loading(100, 0.04, 5, 140), "conductivity of the oil = 140"),
        (lambda: wilson_sheu(1.0, 3.0), "slide-roll ratio = 3"),
    ],
)
def test_values_in_wrong_units_are_refused(call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call()
