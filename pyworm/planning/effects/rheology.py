"""Isothermal effects of the oil: pressure-viscosity, compressibility, shear thinning, limiting stress."""

from collections.abc import Callable
from dataclasses import replace

from pyworm.materials.flow_laws import NEWTONIAN, FlowLaw
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact

# -------------------------------------------------------------------------------- pressure-viscosity


def _thickening(prediction: Prediction) -> float:
    """alpha times the pressure where the film forms: the number by which an oil counts as piezoviscous."""
    return prediction.regime.thickening


def _by_thickening(prediction: Prediction) -> Influence:
    """The film forms at the pressure of the inlet; friction and heat arise at that of the contact."""
    change = prediction.oil.eta(prediction.pressure_max) / prediction.oil.eta(0.0) - 1
    film = THICKENING_FACTOR * prediction.regime.thickening
    return Influence(min(film, change), change, change)


def _isoviscous(scene: AnyContact) -> AnyContact:
    viscosity = Barus(scene.oil.viscosity.eta0, 0.0)
    heat = scene.oil.heat
    if heat is not None and not isinstance(scene.oil.viscosity, Barus):
        beta = (scene.oil.eta(0.0) - scene.oil.eta(0.0, 1.0)) / scene.oil.eta(0.0)
        heat = replace(heat, viscosity_exponent=beta)
    return replace(scene, oil=replace(scene.oil, viscosity=viscosity, heat=heat))


THICKENING_FACTOR = 1.5
"""Change of the film over alpha p in the inlet; 0.6 in the median of isoviscous twins and 1.15 at most
(`benchmarks/atlas/regimes.py`)."""

PRESSURE_VISCOSITY = Effect(
    name="pressure-viscosity",
    symbol="alpha p",
    source="pressure of the inlet by the limits of the film (`pyworm.formulas.regimes`); Barus (1893)",
    indicator=_thickening,
    influence=_by_thickening,
    without=_isoviscous,
    lacking=lambda scene: "the oil has alpha = 0" if scene.oil.viscosity.alpha == 0 else None,
)


# ---------------------------------------------------------------------------------- compressibility


def _compression(prediction: Prediction) -> float:
    density = prediction.oil.density
    return float(density(prediction.pressure_max)) / density.rho0 - 1


def _by_compression(prediction: Prediction) -> Influence:
    # what flows through the middle has the mass that came in: h ~ 1/rho (Venner and Bos 1994)
    change = _compression(prediction)
    return Influence(change, change, change)


COMPRESSIBILITY = Effect(
    name="compressibility",
    symbol="rho/rho0 - 1",
    source="Dowson and Higginson (1966); central film thickness as 1/rho",
    indicator=_compression,
    influence=_by_compression,
    without=lambda scene: replace(
        scene, oil=replace(scene.oil, density=Density.incompressible(scene.oil.density.rho0))
    ),
    lacking=lambda scene: "the oil is incompressible" if scene.oil.density.d1 == 0 else None,
)


# ------------------------------------------------------------------------------- flow under stress

INLET_THICKENING = 4.5
"""Stress in the inlet over eta0 (u + us)/h: the film forms where the oil is several times as viscous as
outside and the gap somewhat wider than the film."""


def _inlet_stress(prediction: Prediction) -> float:
    """Newtonian shear stress in the inlet [Pa]."""
    speed = prediction.speed + prediction.sliding
    return INLET_THICKENING * prediction.oil.viscosity.eta0 * speed / prediction.film_central


def _inlet_pressure(prediction: Prediction) -> float:
    """Pressure in the inlet at which the oil is several times as viscous as outside [Pa]."""
    alpha = prediction.oil.viscosity.alpha
    return min(2 / alpha, prediction.pressure_mean) if alpha > 0 else 0.0


LOBE_PRESSURE = 1 / 3
"""Pressure over the mean one where the minimum film forms, at the contact's sides and exit. Oil leaves there
by the pressure gradient, the more the sliding thins it."""

HOT_FRICTION = 2.0
"""Change of the largest temperatures over that of the mean stress; they occur at the largest stress."""


def unlike(prediction: Prediction, other: FlowLaw) -> Influence:
    """Influence of replacing the oil's flow law by another one."""
    law_of_oil = prediction.oil.sheared

    def change(newtonian: float, pressure: float) -> float:
        if newtonian == 0:
            return 0.0
        stresses = [law.stress_at(newtonian, pressure) for law in (law_of_oil, other)]
        return 1 - min(stresses) / max(stresses)

    lobe = LOBE_PRESSURE * prediction.pressure_mean
    outflow = change(prediction.oil.eta(lobe) * prediction.sliding / prediction.film_min, lobe)
    film = max(change(_inlet_stress(prediction), _inlet_pressure(prediction)), outflow)
    stress = prediction.own_hot_stress
    friction = abs(prediction.hot_stress(flow=other) / stress - 1) if stress > 0 else 0.0
    return Influence(film, max(friction, film), HOT_FRICTION * friction * prediction.warmth)


UNREACHED_STRESS = 1e12
"""Eyring stress of an oil without shear thinning [Pa]."""


def unthinned(flow: FlowLaw) -> FlowLaw:
    """A flow law without its thinning."""
    return replace(flow, stress=UNREACHED_STRESS) if flow.limited and flow.stress > 0 else NEWTONIAN


def _unlimited(flow: FlowLaw) -> FlowLaw:
    if flow.law == "bair-winer" or flow.stress == UNREACHED_STRESS:
        return NEWTONIAN
    law = "eyring" if flow.law == "eyring-limited" else flow.law
    return replace(flow, law=law, limit=0.0, limit_pressure=0.0)


def _flowing(
    by: Callable[[FlowLaw], FlowLaw], has: Callable[[FlowLaw], bool]
) -> Callable[[AnyContact], AnyContact]:
    """The contact with a simpler flow law, if its own has the property removed."""

    def without(scene: AnyContact) -> AnyContact:
        flow = scene.oil.flow
        if flow is None or not has(flow):
            return scene
        return replace(scene, oil=replace(scene.oil, flow=by(flow)))

    return without


def _lacking(has: Callable[[FlowLaw], bool], what: str) -> Callable[[AnyContact], str | None]:
    def lacking(scene: AnyContact) -> str | None:
        if scene.oil.flow is None:
            return "no flow law is given"
        return None if has(scene.oil.flow) else f"the oil's flow law has no {what}"

    return lacking


def _thins(flow: FlowLaw) -> bool:
    return flow.stress > 0


def _limits(flow: FlowLaw) -> bool:
    return flow.limited


SHEAR_THINNING = Effect(
    name="shear-thinning",
    symbol="4.5 eta0 (u + us) / h tau0",
    source="the oil's own flow law in the inlet, at the contact's sides and at the mean pressure",
    indicator=lambda prediction: _inlet_stress(prediction) / prediction.oil.sheared.stress,
    influence=lambda prediction: unlike(prediction, unthinned(prediction.oil.sheared)),
    without=_flowing(unthinned, _thins),
    lacking=_lacking(_thins, "thinning"),
)

LIMITING_STRESS = Effect(
    name="limiting-stress",
    symbol="tau / tauL",
    source="the oil's own flow law in the inlet, at the contact's sides and at the mean pressure",
    indicator=lambda prediction: (
        prediction.stress() / prediction.oil.sheared.limit_at(prediction.pressure_mean)
    ),
    influence=lambda prediction: unlike(prediction, _unlimited(prediction.oil.sheared)),
    without=_flowing(_unlimited, _limits),
    lacking=_lacking(_limits, "limiting stress"),
    eased_by=("shear-thinning",),  # which rounds the corner of the limit
)
