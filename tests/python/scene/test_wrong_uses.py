"""Wrong uses from Python: each refused, or warned of, in one sentence that says what would be right."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from contacts import ball, motions, roller, steel

import pyworm

HEAT = {"viscosity_exponent": 1.1, "conductivity": 0.14, "specific_heat": 2000.0}
ELASTIC = (replace(steel(), hardness=None),) * 2

WRONG = {
    "a percentage as load": (
        lambda: ball(load="5 %"),
        'load = "5 %": must be a force with its unit',
    ),
    "a pressure as load": (lambda: ball(load="1 GPa"), 'load = "1 GPa": must be a force'),
    "a unit in capitals": (lambda: ball(load="50 KN"), 'did you mean "50 kN"'),
    "no load": (lambda: ball(load=None), "load = None: must be a force as a number in N"),
    "a truth as load": (lambda: ball(load=True), "load = True: must be a force as a number in N"),
    "a negative load": (
        lambda: ball(load=-50.0),
        "load = -50: must be finite and greater than zero",
    ),
    "an endless load": (lambda: ball(load=float("inf")), "load = inf: must be finite"),
    "a list as load": (lambda: ball(load=[50.0]), r"load = \[50.0\]: must be a force"),
    "a gap that is a number": (
        lambda: ball(gap=0.01),
        "gap is a float: must be a function of places",
    ),
    "contradicting radii": (
        lambda: ball(gap=pyworm.Paraboloid(0.01, 0.01), radii=(0.02, 0.02)),
        "radii 0.02, 0.02 m contradict the gap",
    ),
    "a gap without radii": (
        lambda: ball(gap=lambda x, y: (x * x, x == x)),
        "radii are missing: a gap that is a function",
    ),
    "a negative radius": (lambda: pyworm.Paraboloid(-0.01, 0.01), "radius_x, radius_y = -0.01 m"),
    "a radius in millimetres": (
        lambda: pyworm.Paraboloid(1e6, 1e6),
        'did you mean "1000000.0 um"|100 km',
    ),
    "one motion": (
        lambda: ball(motions=pyworm.RigidMotion(1, 0)),
        "motions: must be a tuple of two",
    ),
    "speeds for motions": (lambda: ball(motions=(1.1, 0.9)), "motions: must be a tuple of two"),
    "a speed in words": (lambda: pyworm.RigidMotion("fast", 0), 'u = "fast": must be a velocity'),
    "a speed that is none": (lambda: pyworm.RigidMotion(float("nan"), 0), "u, v, spin = nan"),
    "bodies that take up no heat": (
        lambda: pyworm.plan(ball(bodies=(pyworm.Body(2.1e11, 0.3),) * 2)),
        "its oil has heat, but body 1 has no conductivity or density or specific_heat",
    ),
    "one body": (lambda: ball(bodies=steel()), "bodies: must be a tuple of two"),
    "bodies by name": (
        lambda: ball(bodies=("steel", "steel")),
        "a body is a str, .*: must be a Body, such as Body.from_name",
    ),
    "a modulus in gigapascals": (lambda: pyworm.Body(207, 0.3), 'did you mean "207.0 GPa"'),
    "a modulus as force": (lambda: pyworm.Body("207 N", 0.3), 'youngs_modulus = "207 N"'),
    "a Poisson ratio of metal in per cent": (lambda: pyworm.Body(2e11, 30.0), "poisson_ratio = 30"),
    "a bulk temperature in Celsius": (
        lambda: pyworm.Body(2e11, 0.3, bulk_temperature=60.0),
        'did you mean "60.0 degC"',
    ),
    "a roughness in micrometres": (
        lambda: pyworm.Body(2e11, 0.3, roughness=0.4),
        'did you mean "0.4 um"',
    ),
    "an unknown material": (
        lambda: pyworm.Body.from_name("stel"),
        'material "stel": must be one of',
    ),
    "an oil by name": (lambda: ball(oil="PAO VG 220"), "oil is a str, .*: must be an Oil, such as"),
    "an oil without temperature": (
        lambda: ball(oil=pyworm.named_oil("PAO VG 220")),
        r'oil is a NamedOil, an oil over temperature: .* named_oil\("PAO VG 220"\).oil\("60 degC"\)',
    ),
    "an unknown oil": (lambda: pyworm.named_oil("PAO 220"), "must be a base stock"),
    "alpha in 1/GPa": (lambda: pyworm.Barus(0.04, 20.0), 'did you mean "20.0 1/GPa"'),
    "alpha of Roelands in 1/GPa": (
        lambda: pyworm.Roelands.from_alpha(0.04, 20.0),
        'did you mean "20.0 1/GPa"',
    ),
    "a viscosity as density": (lambda: pyworm.Density.dowson_higginson(0.04), "rho0 = 0.04 kg/m"),
    "a density in g/cm3": (
        lambda: pyworm.Density.dowson_higginson(0.87),
        'did you mean "0.87 g/cm.3"',
    ),
    "an inlet in Celsius": (
        lambda: pyworm.OilHeat(inlet_temperature=60.0, **HEAT),
        'did you mean "60.0 degC"',
    ),
    "a Carreau exponent that thickens": (
        lambda: pyworm.FlowLaw("carreau", stress=6e6, exponent=1.4),
        "exponent = 1.4: Carreau's n",
    ),
    "a negative stress": (lambda: pyworm.FlowLaw("eyring", stress=-3e6), "stress = -3e.06 Pa"),
    "a misspelt law": (
        lambda: pyworm.FlowLaw("ering", stress=3e6),
        'law = "ering": must be one of',
    ),
    "velocities of a line as one": (lambda: roller(velocities=1.0), "velocities: must be a tuple"),
    "a line load in newtons": (lambda: roller(load="100 N"), "must be a force per length"),
    "an accuracy in per cent": (lambda: pyworm.plan(ball(), accuracy=5.0), "accuracy = 5"),
    "an accuracy as length": (lambda: pyworm.plan(ball(), accuracy="1 mm"), 'accuracy = "1 mm"'),
    "a quantity as an effect": (
        lambda: pyworm.plan(ball(), effects=["film"]),
        "effects = film: film is none of auto, all, isothermal",
    ),
    "an unknown quantity": (lambda: pyworm.plan(ball(), quantities="wear"), "wear is none of"),
    "a gap without a mask": (
        lambda: pyworm.plan(ball(gap=lambda x, y: x * x + y * y, radii=(0.5, 0.5))),
        r"gap\(x, y\) gives one array of the shape \(3, 3\): must give the gap \[m\] and where both",
    ),
    "a dry contact of a gap without a mask": (
        lambda: pyworm.dry_contact(ball(gap=lambda x, y: x * x + y * y, radii=(0.5, 0.5))),
        r"gap\(x, y\) gives one array of the shape \(3, 3\): must give the gap",
    ),
    "a mask that is one truth": (
        lambda: pyworm.plan(ball(gap=lambda x, y: (x * x + y * y, True), radii=(0.5, 0.5))),
        r"gap\(x, y\) gives 2 values, one array of the shape \(3, 3\) and bool True: must give",
    ),
    "a mask of numbers": (
        lambda: pyworm.plan(ball(gap=lambda x, y: (x * x + y * y, 0 * x + 1), radii=(0.5, 0.5))),
        "gives a second array of float64: must be true where both surfaces exist",
    ),
    "a gap of one place": (
        lambda: pyworm.plan(ball(gap=lambda x: (x * x, x == x), radii=(0.5, 0.5))),
        r"gap\(x, y\) fails \(TypeError: .*\); it must give the gap",
    ),
    "a gap that is not finite": (
        lambda: pyworm.plan(
            ball(gap=lambda x, y: (np.where(y == 0, np.inf, x * x), x == x), radii=(0.5, 0.5))
        ),
        r"gap\(x, y\) gives inf near the contact point: must be finite everywhere",
    ),
    "a gap of a line without a mask": (
        lambda: pyworm.plan(roller(gap=lambda x: x * x / 0.02, radius=0.01)),
        r"gap\(x\) gives one array of the shape \(3,\): must give .* abs\(x\) < 0.005",
    ),
    "a motion of one velocity": (
        lambda: pyworm.plan(ball(motions=(lambda x, y: 1.0 + 0 * x, pyworm.RigidMotion(1, 0)))),
        "the motion of body 1 gives one array .*: must give its velocities along x and y",
    ),
    "a solve by a plan and an accuracy beside it": (
        lambda: pyworm.solve(ball(), pyworm.plan(ball(), 0.2), accuracy=0.05, effects="all"),
        "accuracy, effects: the plan has its own; give either plan or these",
    ),
    "effects that are no names": (
        lambda: pyworm.solve(ball(), effects=("auto", 1)),
        r"effects = \('auto', 1\): must be one name or several, such as",
    ),
    "effects in one text": (
        lambda: pyworm.solve(ball(), effects="auto,-squeeze"),
        'effects = "auto,-squeeze": several names must be texts of their own, "auto", "-squeeze"',
    ),
    "no quantity": (
        lambda: pyworm.plan(ball(), quantities=()),
        r"quantities = \(\): must be one name or several",
    ),
    "a solve by an accuracy": (
        lambda: pyworm.solve(ball(), 0.05),
        r"plan = 0.05: must be a Plan; give an accuracy by its name, accuracy=0.05",
    ),
    "a solve of a plan": (
        lambda: pyworm.solve(pyworm.plan(ball(), 0.2)),
        "scene is a Plan: must be a Scene or a LineScene",
    ),
    "another gap with the radii of the old one": (
        lambda: replace(ball(), gap=pyworm.Paraboloid(0.5, 0.5)),
        "leave them out, and where dataclasses.replace changes the gap, give radii=None with it",
    ),
    "another gap with the radius of the old one": (
        lambda: replace(roller(), gap=pyworm.Parabola(0.5)),
        "dataclasses.replace changes the gap, give radius=None with it",
    ),
    "a film of an oil over temperature": (
        lambda: pyworm.film((0.01, 0.01), 50.0, 226e9, (1.0, 0.0), pyworm.named_oil("PAO VG 220")),
        r'oil is a NamedOil, an oil over temperature: .* named_oil\("PAO VG 220"\).oil\("60 degC"\)',
    ),
    "a film of one radius": (
        lambda: pyworm.film(0.01, 50.0, 226e9, (1.0, 0.0), ball().oil),
        "radii = 0.01: must be two values, along x and along y",
    ),
    "an oil at sixty kelvin": (
        lambda: pyworm.named_oil("PAO VG 220").oil(60.0),
        'temperature = 60 K: must be .* did you mean "60.0 degC"',
    ),
    "a layer of one place": (
        lambda: pyworm.OilLayer("1 mm", ("1 um", "2 um")),
        r"across = .1 mm.: must be several values, such as \(1.0, 2.0\)",
    ),
    **{
        f"{name} for a {wrong}": (lambda call=call, given=given: call(given), sentence)
        for name, call, given, wrong, sentence in (
            ("no text", pyworm.named_oil, 220, "name", "oil = 220: must be a text"),
            ("no text", pyworm.Body.from_name, 1.0, "material", "material = 1.0: must be a text"),
            ("a line", pyworm.film_of, roller(), "film", "scene is a LineScene: must be a Scene"),
            ("a line", lambda v: next(pyworm.passes(v, 1)), roller(), "pass", "must be a Scene"),
            (
                "a line",
                lambda v: pyworm.with_slide_roll_ratio(v, 0.1),
                roller(),
                "slide",
                "a Scene",
            ),
            (
                "a word",
                lambda v: pyworm.with_slide_roll_ratio(ball(), v),
                "x",
                "ratio",
                "ratio = .x",
            ),
            (
                "one",
                lambda v: pyworm.traction_curve(ball(), v),
                0.1,
                "curve",
                "slide_roll_ratios = 0.1",
            ),
            (
                "one",
                lambda v: ball(radii=v),
                0.01,
                "radius",
                "radii = 0.01: must be several values",
            ),
            (
                "no number",
                lambda v: pyworm.Body(2e11, v),
                None,
                "ratio",
                "poisson_ratio = None: must",
            ),
            (
                "a scene",
                lambda v: pyworm.write_csv(v, "a.csv"),
                ball(),
                "file",
                "must be a Solution",
            ),
            (
                "a scene",
                lambda v: pyworm.write_vtk(v, "a.vti"),
                ball(),
                "grid",
                "must be a Solution",
            ),
            (
                "a law",
                pyworm.Parabola,
                steel(),
                "size",
                "radius = <Body.*: must be a radius as a number",
            ),
            (
                "a number",
                lambda v: pyworm.plan(ball(), quantities=v),
                3,
                "list",
                "quantities = 3: must",
            ),
            (
                "nothing",
                lambda v: pyworm.Barus(0.04, v),
                {},
                "law",
                r"alpha = {}: must be a pressure",
            ),
            (
                "a list",
                lambda v: pyworm.Oil(
                    pyworm.Barus(0.04, 0), pyworm.Density(870.0, 0, 0), boundary_friction=v
                ),
                {},
                "law",
                "boundary_friction = {}",
            ),
        )
    },
    "a gap that is no file": (lambda: pyworm.read_gap("none.npz"), "no such file"),
    "a plan of no scene": (lambda: pyworm.plan(pyworm.Paraboloid(1, 1)), "scene is a Paraboloid"),
    "an impossible pressure": (
        lambda: pyworm.plan(roller(load=1e9, bodies=ELASTIC)),
        "nothing with a modulus",
    ),
    "a load beyond the hardness": (lambda: pyworm.plan(ball(load="1 MN")), "yields as a whole"),
    "a plan of another scene": (
        lambda: pyworm.solve(ball(), pyworm.plan(ball(load=31.0), 0.2)),
        "made for another contact than ball",
    ),
    "a plan of other speeds": (
        lambda: pyworm.solve(ball(motions=motions(0.1)), pyworm.plan(ball(), 0.2)),
        "made for another contact",
    ),
    "a comparison of a scene": (lambda: pyworm.compare(ball(), ball()), "takes two solutions"),
    "a study of nothing": (lambda: pyworm.sweep(ball), "nothing varies"),
    "a study of no scenes": (lambda: pyworm.sweep(lambda load: load, load=(1, 2)), "no scene"),
    "half a process": (
        lambda: pyworm.sweep(ball, load=(20.0, 30.0), processes=0.5),
        "processes = 0.5: must be a whole number",
    ),
    "a lambda for other processes": (
        lambda: pyworm.sweep(
            lambda load: ball(
                load=load, gap=lambda x, y: (x * x + y * y, x == x), radii=(0.5, 0.5)
            ),
            load=(20.0, 30.0),
            processes=2,
            accuracy=0.2,
        ),
        "its gap, .*lambda.*, cannot go to other processes.*define it with def",
    ),
    "a dry contact of no nodes": (lambda: pyworm.dry_contact(ball(), nodes=0), "nodes = 0"),
    "a dry contact of a line": (lambda: pyworm.dry_contact(roller()), "must be a Scene"),
    "a heightmap of one row": (
        lambda: pyworm.SampledGap(np.linspace(-1, 1, 9), np.array([0.0]), np.zeros((1, 9))),
        "at least 5 samples|least",
    ),
}


def test_there_are_forty():
    assert len(WRONG) >= 40


@pytest.mark.parametrize("use", WRONG)
def test_a_wrong_use_is_refused_in_one_sentence(use):
    make, sentence = WRONG[use]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pyworm.UnusualWarning)
        with pytest.raises(ValueError, match=sentence) as caught:
            make()
    said = str(caught.value)
    assert "\n" not in said
    assert len(said) < 400


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            lambda: ball(gap=pyworm.Paraboloid(10.0, 10.0), load=50.0),
            "MPa only by Hertz, where the radii are 10 m and 10 m",
        ),
        (lambda: ball(load=3e3), "bear up to 4 GPa as a rule"),
        (
            lambda: ball(load=1e6, bodies=ELASTIC),
            "nothing with a modulus of .* GPa, as the softer body has, bears",
        ),
        (
            lambda: ball(oil=replace(ball().oil, viscosity=pyworm.Barus(150.0, 2e-8))),
            "oil.viscosity.eta0 = 150 Pa s: unusual",
        ),
    ],
)
def test_an_unusual_contact_is_told(make, sentence):
    with pytest.warns(pyworm.UnusualWarning, match=sentence):
        pyworm.plan(make(), 0.2, "isothermal")


def test_a_usual_contact_gives_no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pyworm.plan(ball(), 0.2)


def test_texts_with_units_are_read():
    by_text = ball(load="0.03 kN", gap=pyworm.Paraboloid("10 mm", "1 cm"))
    assert by_text.load == 30.0
    assert by_text.radii == (0.01, 0.01)
    assert pyworm.Body("207 GPa", 0.3, roughness="0.4 um") == pyworm.Body(
        207e9, 0.3, roughness=0.4e-6
    )
    assert pyworm.Roelands.from_alpha("40 mPa s", "20 1/GPa").alpha == pytest.approx(20e-9)
    assert pyworm.RigidMotion("1.1 m/s", 0, spin="10 rad/s").spin == 10


def test_radii_follow_from_the_gap():
    assert ball(gap=pyworm.Paraboloid(0.01, 0.02)).radii == (0.01, 0.02)
    assert roller(gap=pyworm.Parabola(0.02)).radius == 0.02
