"""Contacts whose friction is not given, though the oil's data would allow it, state why."""

import json
from dataclasses import replace

import pytest
from contacts import ball, motions
from test_warm_bodies import OIL

import pyworm
from pyworm.cli.main import main
from pyworm.planning.no_friction import no_friction
from pyworm.result.headline import opening

SENTENCE = (
    "Friction is not given: the oil's flow law and heat are neglected (shear-thinning, limiting-stress, "
    "surface-heating and film-heating)"
)


def sliding(**changes):
    """A sliding ball whose oil has a flow law and heat."""
    return ball(oil=replace(OIL, **changes))


def solved(scene, effects):
    return pyworm.solve(scene, pyworm.plan(scene, 0.2, effects))


def test_an_isothermal_newtonian_film_states_why_it_has_no_friction():
    solution = solved(sliding(), "isothermal")
    assert solution.figures.friction_coefficient is None
    (sentence,) = (line for line in opening([solution], "") if "riction" in line)
    assert sentence.startswith(SENTENCE)
    assert solution.summary()["friction_coefficient_reason"] in sentence


@pytest.mark.parametrize("named", ["shear-thinning", "limiting-stress"])
def test_each_effect_of_the_flow_law_gives_friction(named):
    scene = replace(sliding(heat=None), load=2.0)  # light: a limit alone takes many steps
    reason = no_friction(pyworm.plan(scene, 0.2, "isothermal").effects)
    assert "(shear-thinning and limiting-stress)" in reason
    solution = solved(scene, ("isothermal", named))
    assert solution.figures.friction_coefficient.value > 0
    assert "friction_coefficient_reason" not in solution.summary()
    assert not any(line.startswith("Friction") for line in opening([solution], ""))


def test_an_oil_without_a_law_has_no_friction_to_leave_out():
    scene = sliding(flow=None, heat=None)
    assert no_friction(pyworm.plan(scene, 0.2, "isothermal").effects) == ""


def test_friction_alone_is_refused_where_no_effect_gives_it():
    with pytest.raises(ValueError, match="friction cannot be found with effects = isothermal"):
        pyworm.plan(sliding(), 0.2, "isothermal", ("friction",))


def test_friction_alone_of_a_contact_that_rolls_is_zero():
    scene = ball(oil=replace(OIL, heat=None), motions=motions(sliding=0.0))
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.2, "all", ("friction",)))
    assert solution.converged
    assert solution.figures.friction_coefficient.value == 0


def test_commands_print_the_reason(tmp_path, capsys):
    case = "cases/ball_pag_460.toml"
    main(["check", case, "--effects", "isothermal", "--accuracy", "20%"])
    assert "No friction" in capsys.readouterr().out
    out = ["--out", str(tmp_path), "--accuracy", "20%", "--pictures", "none"]
    main(["run", case, "--effects", "isothermal", *out])
    assert SENTENCE in " ".join(capsys.readouterr().out.split())
    main(["run", case, "--effects", "isothermal", *out, "--json"])
    (scene,) = json.loads(capsys.readouterr().out)["scenes"]
    assert scene["friction_coefficient_reason"].startswith(SENTENCE.partition(": ")[2])
