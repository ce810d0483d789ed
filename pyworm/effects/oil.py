"""Effects of the oil at one temperature: thickening and compression under pressure, flow under stress."""

from dataclasses import replace

from pyworm.effects.effect import Contact, Effect, Influence
from pyworm.effects.sketch import Sketch
from pyworm.oils import Barus, Density, FlowLaw

# -------------------------------------------------------------------------------- pressure-viscosity


def _thickening(sketch: Sketch) -> float:
    return sketch.oil.viscosity.alpha * sketch.pressure_max


def _by_thickening(sketch: Sketch) -> Influence:
    change = sketch.oil.eta(sketch.pressure_max) / sketch.oil.eta(0.0) - 1
    return Influence(change, change, change)


def _isoviscous(scene: Contact) -> Contact:
    viscosity = Barus(scene.oil.viscosity.eta0, 0.0)
    heat = scene.oil.heat
    if heat is not None and not isinstance(scene.oil.viscosity, Barus):
        beta = (scene.oil.eta(0.0) - scene.oil.eta(0.0, 1.0)) / scene.oil.eta(0.0)
        heat = replace(heat, viscosity_exponent=beta)
    return replace(scene, oil=replace(scene.oil, viscosity=viscosity, heat=heat))


PRESSURE_VISCOSITY = Effect(
    name="pressure-viscosity",
    symbol="alpha p",
    source="Barus (1893)",
    indicator=_thickening,
    influence=_by_thickening,
    without=_isoviscous,
    lacking=lambda scene: "the oil has alpha = 0" if scene.oil.viscosity.alpha == 0 else None,
)


# ---------------------------------------------------------------------------------- compressibility


def _compression(sketch: Sketch) -> float:
    density = sketch.oil.density
    return density(sketch.pressure_max) / density.rho0 - 1


def _by_compression(sketch: Sketch) -> Influence:
    # what flows through the middle has the mass that came in: h ~ 1/rho (Venner and Bos 1994)
    change = _compression(sketch)
    return Influence(change, change, change)


COMPRESSIBILITY = Effect(
    name="compressibility",
    symbol="rho/rho0 - 1",
    source="Dowson and Higginson (1966); central film as 1/rho",
    indicator=_compression,
    influence=_by_compression,
    without=lambda scene: replace(
        scene,
        oil=replace(scene.oil, density=Density.incompressible(scene.oil.density.rho0)),
    ),
    lacking=lambda scene: "the oil is incompressible" if scene.oil.density.d1 == 0 else None,
)


# ------------------------------------------------------------------------------- flow under stress

INLET_THICKENING = 10.0
"""Stress in the inlet over eta0 (u + us)/h: the film forms where the oil is some times thicker than outside
and the gap somewhat wider than the film."""


def _inlet_stress(sketch: Sketch) -> float:
    """Newtonian shear stress where the film is formed [Pa]."""
    speed = sketch.speed + sketch.sliding
    return INLET_THICKENING * sketch.oil.viscosity.eta0 * speed / sketch.film_central


LOBE_PRESSURE, LOBE_SHARE = 1 / 3, 0.5
"""Pressure over the mean one where the minimum film forms at the contact's sides and exit, and what of a
change of the stress there it feels: oil leaves by the pressure's gradient where the sliding has thinned it."""


def _unlike(sketch: Sketch, other: FlowLaw) -> Influence:
    """Change of what is asked by another flow law than the oil's."""
    own = sketch.oil.flow

    def change(newtonian: float, pressure: float) -> float:
        if newtonian == 0:
            return 0.0
        return abs(other.stress_at(newtonian, pressure) / own.stress_at(newtonian, pressure) - 1)

    lobe = LOBE_PRESSURE * sketch.pressure_mean
    outflow = change(sketch.oil.eta(lobe) * sketch.sliding / sketch.film_min, lobe)
    film = max(change(_inlet_stress(sketch), 0.0), LOBE_SHARE * outflow)
    stress = sketch.hot_stress()
    friction = abs(sketch.hot_stress(flow=other) / stress - 1) if stress > 0 else 0.0
    return Influence(film, max(friction, film), friction * sketch.warmth)


NO_THINNING = {"eyring": "newtonian", "carreau": "newtonian", "eyring-limited": "bair-winer"}
NO_LIMIT = {"bair-winer": "newtonian", "eyring-limited": "eyring"}
"""Flow law -> what is left of it without shear thinning, and without a limiting stress."""


def _changed(flow: FlowLaw, left: dict[str, str]) -> FlowLaw:
    return replace(flow, law=left.get(flow.law, flow.law))


def _without(left: dict[str, str]):
    def without(scene: Contact) -> Contact:
        if scene.oil.flow is None:
            return scene
        return replace(scene, oil=replace(scene.oil, flow=_changed(scene.oil.flow, left)))

    return without


def _lacking(left: dict[str, str], what: str):
    def lacking(scene: Contact) -> str | None:
        if scene.oil.flow is None:
            return "no flow law is given"
        return None if scene.oil.flow.law in left else f"the oil's flow law has no {what}"

    return lacking


SHEAR_THINNING = Effect(
    name="shear-thinning",
    symbol="10 eta0 (u + us) / h tau0",
    source="the oil's own flow law in the inlet and at the mean pressure",
    indicator=lambda sketch: _inlet_stress(sketch) / sketch.oil.flow.stress,
    influence=lambda sketch: _unlike(sketch, _changed(sketch.oil.flow, NO_THINNING)),
    without=_without(NO_THINNING),
    lacking=_lacking(NO_THINNING, "thinning"),
)

LIMITING_STRESS = Effect(
    name="limiting-stress",
    symbol="tau / tauL",
    source="the oil's own flow law in the inlet and at the mean pressure",
    indicator=lambda sketch: sketch.stress() / sketch.oil.flow.limit_at(sketch.pressure_mean),
    influence=lambda sketch: _unlike(sketch, _changed(sketch.oil.flow, NO_LIMIT)),
    without=_without(NO_LIMIT),
    lacking=_lacking(NO_LIMIT, "limiting stress"),
)
