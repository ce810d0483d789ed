"""Plans: what they leave out, what they say of it, and what solutions say of plans."""

import json
import pickle
from dataclasses import replace
from math import inf, isfinite
from pathlib import Path

import numpy as np
import pytest
from contact_edge import shares_of_contact
from hypothesis import given, settings
from hypothesis import strategies as st
from plan_scenes import ROUGH, STEEL, TRIALS, mineral, point
from plans import trial
from zi_drives import quickly_described

import pyworm
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED
from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.planning.effects.catalogue import EFFECTS
from pyworm.planning.effects.effect import QUANTITIES
from pyworm.planning.effects.geometry import departure
from pyworm.planning.plan import plan_of, planned
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene
from pyworm.scene.point import Paraboloid, RigidMotion
from pyworm.scene.scales import scales

BY_NAME = {effect.name: effect for effect in EFFECTS}


def ball(sliding=0.2, speed=2.0, load=40.0, eta0=0.04, alpha=2e-8, **more):
    """Steel on steel."""
    velocities = ((speed * (1 + sliding / 2), 0.0), (speed * (1 - sliding / 2), 0.0))
    oil = mineral(eta0, alpha, **more)
    return point("ball", (0.01, 0.01), load, velocities, (STEEL, STEEL), oil)


def judged(plan):
    return {judgement.name: judgement for judgement in plan.effects}


def test_names_are_unique_and_refer_to_each_other():
    assert len(BY_NAME) == len(EFFECTS)
    order = list(BY_NAME)
    for effect in EFFECTS:
        assert set(effect.together) <= set(BY_NAME)
        assert effect.part_of is None or order.index(effect.part_of) < order.index(effect.name)


def test_every_effect_is_judged_with_a_reason():
    plan = pyworm.plan(TRIALS["worm, phase 0.5"].scene(), 0.01)
    assert list(judged(plan)) == list(BY_NAME)
    assert all(judgement.reason for judgement in plan.effects)
    assert {"real-gap", "varying-velocity", "film-heating", "shear-thinning"} <= plan.on


@settings(max_examples=60, deadline=None)
@given(
    sliding=st.sampled_from([0.0, 0.01, 0.5]),
    speed=st.floats(0.001, 20.0),
    load=st.floats(0.1, 500.0),
    eta0=st.floats(0.002, 0.5),
    accuracy=st.sampled_from([0.001, 0.01, 0.05]),
)
def test_what_is_left_out_stays_within_the_accuracy(sliding, speed, load, eta0, accuracy):
    scene = ball(sliding, speed, load, eta0)
    plan = plan_of(scene, accuracy)
    left = [
        judgement
        for judgement in plan.effects
        if not judgement.on
        and judgement.influence
        and BY_NAME[judgement.name].without is not None
        and not judgement.reason.startswith("none without")
    ]
    for quantity in plan.quantities:
        assert sum(judgement.influence[quantity] for judgement in left) <= accuracy * (1 + 1e-12)
    assert all(
        value >= 0 and not np.isnan(value)
        for judgement in plan.effects
        for value in judgement.influence.values()
    )


def test_estimates_are_numbers_where_hertz_would_make_the_oil_a_solid():
    """A film that carries the load never sees Hertz's pressure, at which exp(alpha p) is no number."""
    scene = replace(ball(load=5e4), bodies=(replace(STEEL, youngs_modulus=1.5e12),) * 2)
    for judgement in pyworm.plan(scene, 0.01).effects:
        assert all(value >= 0 for value in judgement.influence.values()), judgement.name


@settings(max_examples=30, deadline=None)
@given(speed=st.floats(0.01, 10.0), sliding=st.floats(0.01, 1.0))
def test_a_finer_accuracy_never_leaves_more_out(speed, sliding):
    scene = ball(sliding, speed)
    coarse, fine = (pyworm.plan(scene, accuracy).on for accuracy in (0.05, 0.002))
    assert coarse <= fine


def test_a_scene_is_simplified_by_what_is_off():
    scene = TRIALS["worm, phase 0.5"].scene()
    simple = pyworm.plan(scene, 0.01, ("isothermal", "-real-gap", "-varying-velocity")).simplified(
        scene
    )
    assert simple.gap == Paraboloid(*scene.radii)
    assert all(isinstance(motion, RigidMotion) and motion.spin == 0 for motion in simple.motions)
    assert simple.oil.heat is None
    bare = pyworm.plan(
        scene, 0.01, ("second-dimension", "real-gap", "elastic-deflection")
    ).simplified(scene)
    assert bare.oil.viscosity.alpha == 0
    assert bare.oil.density.d1 == 0
    assert not bare.rigid
    assert pyworm.plan(scene, 0.01, ("isothermal", "-elastic-deflection")).simplified(scene).rigid


def test_a_long_contact_becomes_a_line_of_the_same_pressure():
    scene = TRIALS["long roller"].scene()
    simple = pyworm.plan(scene, 0.05, quantities=("film",)).simplified(scene)
    assert isinstance(simple, LineScene)
    assert predicted(simple).pressure_max == pytest.approx(predicted(scene).pressure_max)
    assert simple.velocities == (1.05, 0.95)


def test_flow_laws_lose_what_is_left_out_of_them():
    scene = ball()
    law = scene.oil.flow
    unthinned = pyworm.plan(scene, 0.01, ("all", "-shear-thinning")).simplified(scene).oil.flow
    assert unthinned.stress_at(1e3, 1e8) == pytest.approx(1e3, rel=1e-6)
    assert unthinned.stress_at(1e12, 1e8) == pytest.approx(law.limit_at(1e8), rel=1e-3)
    unlimited = pyworm.plan(scene, 0.01, ("all", "-limiting-stress")).simplified(scene).oil.flow
    assert unlimited.stress_at(1e12, 1e8) > law.limit_at(1e8)
    # a millionth of a pascal: rounding alone tells the limited oil from one without a limit
    faint = replace(law, stress=4.2e-6, stress_pressure=0.0)
    assert faint.stress_at(1e6, 1e8) == pytest.approx(4.2e-6 * np.arcsinh(1e6 / 4.2e-6))
    neither = pyworm.plan(scene, 0.01, ("all", "-shear-thinning", "-limiting-stress")).simplified(
        scene
    )
    assert neither.oil.flow in (None, NEWTONIAN)


def test_the_quantities_asked_for_decide():
    """Thinning hardly touches the film of glass that slides a little, but makes its friction."""
    motions = RigidMotion(0.052, 0.0), RigidMotion(0.048, 0.0)
    scene = replace(TRIALS["glass, sliding a little"].scene(), motions=motions)
    assert "shear-thinning" not in pyworm.plan(scene, 0.01, quantities=("film",)).on
    assert "shear-thinning" in pyworm.plan(scene, 0.01, quantities=("film", "friction")).on


def test_opposite_sliding_needs_heat_whatever_is_asked():
    plan = pyworm.plan(TRIALS["opposite sliding"].scene(), 0.05, quantities=("film",))
    assert {"film-heating", "surface-heating", "viscosity-across"} <= plan.on
    assert judged(plan)["film-heating"].influence["film"] == inf


def test_bodies_of_another_temperature_bring_heat_in():
    scene = ball(sliding=0.0, speed=0.05)
    warm = replace(STEEL, bulk_temperature=STEEL.bulk_temperature + 20)
    assert "film-heating" not in pyworm.plan(scene, 0.01).on
    assert "film-heating" in pyworm.plan(replace(scene, bodies=(STEEL, warm)), 0.01).on


def test_a_solution_adds_what_its_plan_missed():
    """A prediction that takes the film for a hundred times as thick sees no heat; the solution does."""
    scene = ball(sliding=0.5)
    prediction = predicted(scene)
    fooled = replace(
        prediction, film_central=100 * prediction.film_central, sliding=1e-9, velocities=(1e9, 1e9)
    )
    plan = planned(scene, 0.05, QUANTITIES, replace(fooled, speed=1e-6))
    assert "film-heating" not in plan.on
    mended = pyworm.solve(scene, plan)
    whole = pyworm.solve(scene, pyworm.plan(scene, 0.05, "all"))
    assert mended.converged
    assert {"film-heating", "shear-thinning"} <= {one.name for one in mended.effects if one.on}
    for name in ("film_min", "film_central", "friction_coefficient", "temperature_max_film"):
        one, other = getattr(mended.figures, name), getattr(whole.figures, name)
        assert one.value == pytest.approx(other.value, rel=0.05), name


def test_an_effect_that_was_missed_costs_no_second_climb_of_the_grids():
    """The first grid tells that heat is needed; finer ones are solved with it only."""
    missed = {"film-heating", "limiting-stress", "shear-thinning", "surface-heating"}
    trial = TRIALS["long roller"]
    scene = trial.scene()
    plan = pyworm.plan(scene, 0.05, "auto", trial.quantities)
    told = []
    solution = pyworm.solve(scene, plan, lambda message, fraction: told.append(message))
    called = [number for number, message in enumerate(told) if "calls for" in message]
    assert [told[number] for number in called] == [
        f"{scene.name}: calls for {', '.join(sorted(missed))} too"
    ]
    windows = [number for number, message in enumerate(told) if "wider domain" in message]
    assert called[0] < windows[0]
    assert len(windows) == 1
    on = {one.name for one in solution.effects if one.on}
    assert on == plan.on | missed


def test_only_a_plan_that_leaves_out_what_is_simulated_may_grow():
    trial = TRIALS["slender, across"]
    scene = replace(trial.scene(), bodies=(ROUGH, ROUGH))
    assert pyworm.plan(scene, 0.01, "auto", trial.quantities).may_grow
    whole = pyworm.plan(scene, 1e-4, "auto", ("film", "friction", "temperature"))
    assert not whole.may_grow
    without = pyworm.plan(scene, 1e-4, ("auto", "-roughness"), ("film", "friction", "temperature"))
    assert without.on == whole.on - {"roughness"}
    assert not without.may_grow
    assert not pyworm.plan(scene, 0.01, "isothermal").may_grow


def test_heat_that_was_missed_gets_the_window_it_needs():
    """The inlet of a line reaches farther where it warms; a window found without heat is not taken over."""
    trial = TRIALS["long roller"]
    solution = pyworm.solve(
        trial.scene(), pyworm.plan(trial.scene(), 0.05, "auto", trial.quantities)
    )
    assert solution.converged
    on = {one.name for one in solution.effects if one.on}
    whole = pyworm.plan(trial.scene(), 0.05, tuple(on), trial.quantities)
    again = pyworm.solve(trial.scene(), whole)
    assert solution.figures.film_min.value == pytest.approx(again.figures.film_min.value, rel=1e-3)


def test_effects_asked_for_are_judged_but_not_revised():
    scene = ball(sliding=0.5)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.1, "isothermal", ("film",)))
    heat = judged(solution)["film-heating"]
    assert not heat.on
    assert heat.reason == "not requested"
    assert heat.influence["film"] > 0.02


def squeezed(before, after, age=1.0):
    """What is told of squeeze of a contact that was another one at all times before, if any."""

    def then(seconds):
        if seconds < 0:
            raise ValueError("nothing was carried")
        return before

    scene = replace(after, past=Past(Life(age, then), age))
    return judged(pyworm.plan(scene, 0.05, quantities=("film",)))["squeeze"]


def test_squeeze_of_a_faster_film_is_its_growth_while_oil_passes():
    before, after = ball(speed=2.0), ball(speed=2.02)
    told = squeezed(before, after)
    assert told.indicator == pytest.approx(np.log(scales(after).film / scales(before).film))
    assert told.influence["film"] == pytest.approx(told.indicator)
    assert not told.on
    assert squeezed(after, before).indicator == pytest.approx(told.indicator)


def test_squeeze_of_a_gap_that_departs_from_its_radii_is_estimated():
    """Radii, load and speed stay; the contact reached an edge while oil passed."""
    plain = ball()
    bent = replace(plain, gap=lambda x, y: ((x**2 + y**2) / 0.04 * (1 + 20 * x), y < 1))
    assert squeezed(bent, plain).indicator == pytest.approx(departure(predicted(bent)))


def test_a_cycle_younger_than_the_oil_has_no_earlier_past():
    before, after = ball(speed=2.0), ball(speed=2.02)
    told = squeezed(before, after, age=1e-6)
    assert told.indicator == pytest.approx(np.log(scales(after).film / scales(before).film))
    beginning = squeezed(ball(), ball(), age=0.0)
    assert (beginning.indicator, beginning.reason) == (None, "nothing before")


@pytest.mark.parametrize(("kind", "power", "edges"), [("ball", 1 / 3, 2), ("roller", 1 / 2, 1)])
def test_squeeze_of_a_growing_load_is_that_of_the_contact_s_edges(kind, power, edges):
    """Hertz's a goes with F^(1/3) of a ball and F^(1/2) of a roller; the film hardly changes."""
    share = 1e-3
    if kind == "ball":
        before, after = (ball(load=load) for load in (40.0, 40.0 * (1 + share)))
    else:
        before = TRIALS["roller, half way"].scene()
        after = replace(before, load=before.load * (1 + share))
    told = squeezed(before, after)
    outward = power * share / 2  # of the width, while oil passes through that
    assert edges * outward < told.indicator < 1.35 * edges * outward
    # 0.7 of the edges' share counts, and all of the film's
    assert 0.7 * told.indicator < told.influence["film"] < told.indicator


def test_starvation_is_an_effect_like_any_other():
    starving = TRIALS["starved bearing"].scene()
    judged_by_default = judged(pyworm.plan(starving, 0.05))["starvation"]
    assert judged_by_default.on
    assert 0 < judged_by_default.influence["film"] < 1
    assert not judged(pyworm.plan(starving, 0.05, ("auto", "-starvation")))["starvation"].on


def test_roughness_is_an_effect_like_any_other():
    rough = TRIALS["very rough"].scene()
    roughness = judged(pyworm.plan(rough, 0.05))["roughness"]
    assert roughness.on
    assert roughness.influence["film"] > 0.05
    without = pyworm.plan(rough, 0.05, ("auto", "-roughness"))
    assert judged(without)["roughness"].reason == "neglected as requested"
    assert without.on == pyworm.plan(rough, 0.05).on - {"roughness"}
    smooth = replace(rough, bodies=tuple(replace(body, roughness=None) for body in rough.bodies))
    with pytest.raises(
        ValueError, match="effects = isothermal,roughness: roughness: roughness not given"
    ):
        pyworm.plan(smooth, 0.05, ("isothermal", "roughness"))


@pytest.mark.parametrize("accuracy", [pytest.param(0.01, marks=pytest.mark.long), 0.05])
@pytest.mark.parametrize(
    "name",
    [
        pytest.param("rubber in water", marks=pytest.mark.long),
        pytest.param("steel, rolling slowly", marks=pytest.mark.long),
        "gear, pitch point",
        "gear, tip",
    ],
)
def test_automatic_plans_keep_the_accuracy(name, accuracy):
    """The cheap ones of the suite that `benchmarks/accuracy/plans.py` runs in full."""
    row, neglected_effects = trial(name, TRIALS[name], accuracy)
    assert row["converged"]
    assert row["worst"] <= accuracy
    assert all(one["true"] <= accuracy for one in neglected_effects)


@pytest.mark.parametrize(
    ("accuracy", "levels"), [(0.1, 5), (0.01, 5), (0.0099, 7), (0.0039, 9), (0.001, 9), (2e-4, 11)]
)
def test_levels_across_the_film_leave_a_tenth_of_the_accuracy(accuracy, levels):
    """5, 7 and 9 levels leave 1 %, 0.04 % and 0.003 % in the figures (docs/evidence/validation.md)."""
    scene = pyworm.load("cases/traction_steel.toml").scene()
    assert pyworm.plan(scene, accuracy, "all").model.levels == levels


def test_friction_of_a_newtonian_film_is_read_without_levels():
    """Where thinning changes nothing it is left out, and friction is that of eta us/h."""
    scene = TRIALS["rubber in water"].scene()
    plan = pyworm.plan(scene, 0.05)
    assert plan.model.levels == 0
    solution = pyworm.solve(scene, plan)
    fields = solution.fields
    stress = scene.oil.viscosity.eta0 * fields.sliding_x / fields.film
    cell = float(fields.x[1] - fields.x[0]) * float(fields.y[1] - fields.y[0])
    force = float((shares_of_contact(fields.pressure.values) * stress.values).sum()) * cell
    assert solution.figures.friction_coefficient.on_grid == pytest.approx(
        force / scene.load, rel=1e-3
    )
    assert solution.figures.temperature_max_film is None


def test_check_lists_effects_as_json(capsys):
    assert main(["check", "cases/line_thermal.toml", "--json", "--accuracy", "5%"]) == CONVERGED
    scene = json.loads(capsys.readouterr().out)["scenes"][0]
    assert {effect["name"] for effect in scene["effects"]} == set(BY_NAME)
    for effect in scene["effects"]:
        assert set(effect) == {"name", "on", "indicator", "influence", "reason"}
        assert all(value is None or isfinite(value) for value in effect["influence"].values())


@pytest.mark.parametrize(
    "arguments",
    [
        "zi_sharif_2001.toml --phase 0.5",
        "roller_ref.toml --section left --phase 0.5 --station 0.5 "
        "--effects auto --quantities film --accuracy 5%",
    ],
)
def test_the_page_on_effects_shows_what_check_prints(arguments, capsys, monkeypatch):
    quickly_described(monkeypatch)
    monkeypatch.setenv("COLUMNS", "112")
    assert main(["check", *f"cases/{arguments}".split()]) == CONVERGED
    rows = [line.strip() for line in capsys.readouterr().out.splitlines()]
    shown = [line for line in rows if line.partition(" ")[0] in BY_NAME]
    assert len(shown) == len(EFFECTS)
    page = Path("docs/theory/effects.md").read_text()
    assert "\n".join(shown) in page


@pytest.mark.parametrize(
    ("case", "place"),
    [
        ("zi_drive", {"phase": 0.4}),
        ("roller_ref", {"section": "left", "phase": 0.5, "station": 0.5}),
        ("spur_pair", {"phase": 0.5}),
    ],
)
def test_scenes_travel_to_other_processes_with_their_past(case, place):
    scene = pyworm.load(f"cases/{case}.toml").scene(**place)
    again = pickle.loads(pickle.dumps(scene))
    for seconds in (1e-5, 2e-5):
        assert again.past.before(seconds).load == scene.past.before(seconds).load
    assert (
        judged(pyworm.plan(again, 0.05))["squeeze"] == judged(pyworm.plan(scene, 0.05))["squeeze"]
    )


def test_squeeze_is_simulated_where_the_accuracy_needs_it_or_it_is_named():
    changed = replace(ball(), past=Past(Life(1.0, lambda seconds: ball(speed=1.0)), 1.0))
    same = replace(ball(), past=Past(Life(1.0, lambda seconds: ball()), 1.0))
    for scene, effects, on, why in (
        (changed, "auto", True, "more than 5 %"),
        (same, "auto", False, "within 5 %"),
        (same, ("auto", "squeeze"), True, "requested; within 5 %"),
        (changed, ("auto", "-squeeze"), False, "neglected as requested"),
        (changed, "all", True, "requested"),
        (changed, "isothermal", False, "not requested"),
        (changed, ("isothermal", "squeeze"), True, "requested"),
    ):
        told = judged(pyworm.plan(scene, 0.05, effects))["squeeze"]
        assert (told.on, told.reason) == (on, why)
    scene = changed
    begun = replace(scene, past=replace(scene.past, seconds=0.0))
    for still, why in ((ball(), "steady"), (begun, "nothing before")):
        for effects in (("auto", "squeeze"), ("isothermal", "squeeze")):
            told = judged(pyworm.plan(still, 0.05, effects))["squeeze"]
            assert not told.on and told.reason == why
    for effects, why in (
        (("auto", "roughnes"), "roughnes after auto is none of squeeze, second-dimension"),
        (("auto", ""), "nothing after auto is none of squeeze"),
        (("auto", "-roughnes"), "roughnes after a minus is none of squeeze, second-dimension"),
        (("auto", "-"), "nothing after a minus is none of squeeze"),
        (("squeeze", "auto"), "auto comes first, as in auto,-squeeze"),
    ):
        with pytest.raises(ValueError, match=f"effects = {','.join(effects)}: {why}"):
            pyworm.plan(scene, 0.05, effects)


def test_surfaces_that_entrain_nothing_may_have_a_past():
    """Opposite sliding: heat alone carries the film."""
    against = (1.5, 0.0), (-1.5, 0.0)
    scene = point("ball", (0.01, 0.01), 40.0, against, (STEEL, STEEL), mineral(0.04, 2e-8))
    moving = replace(scene, past=Past(Life(1.0, lambda seconds: scene), 1.0))
    assert judged(pyworm.plan(moving, 0.05))["squeeze"].indicator == 0


@pytest.mark.parametrize("load", [0.3, 3.0, 30.0, 300.0])
def test_the_wider_window_is_wider_however_thin_the_film(load):
    for sliding in (0.0, 0.5):
        plan = pyworm.plan(ball(sliding, 0.02, load), 0.02, "all")
        inner, wider = np.array(plan.grids[-1].box), np.array(plan.wider_grids[-1].box)
        assert (np.abs(wider) > 1.3 * np.abs(inner)).all()
