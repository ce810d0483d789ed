"""Twenty public uses as a script has them; `test_public_types.py` has mypy read it, nobody runs it."""
# mypy: check-untyped-defs, disallow-any-generics, disallow-incomplete-defs, extra-checks
# mypy: disallow-subclassing-any, disallow-untyped-decorators, strict-equality

import pyworm

# objects, with units or as numbers in SI
oil = pyworm.Oil(
    pyworm.Roelands.from_alpha("40 mPa s", 2e-8), pyworm.Density.dowson_higginson("870 kg/m^3")
)
thin = pyworm.Oil(pyworm.Barus(0.04, "20 1/GPa"), pyworm.Density(870.0, 6e-10, "1.7 1/GPa"))
starved = pyworm.Oil(oil.viscosity, oil.density, supply="0.2 um")
layered = pyworm.Oil(
    oil.viscosity, oil.density, supply=pyworm.OilLayer(("-1 mm", 1e-3), ("0.1 um", 2e-7))
)
law = pyworm.FlowLaw("eyring", stress="5 MPa")
heat = pyworm.OilHeat("60 degC", 0.04, "0.14 W/(m K)", 2000.0, expansivity="7e-4 1/K")
body = pyworm.Body("207 GPa", 0.3, roughness="0.1 um", bulk_temperature="60 degC")
steel = pyworm.Body.from_name("16MnCr5", "0.4 um")
named = pyworm.named_oil("PAO VG 220").oil("60 degC")
ball = pyworm.Scene(
    name="ball",
    gap=pyworm.Paraboloid("10 mm", 0.02),
    load="20 N",
    motions=(pyworm.RigidMotion("1 m/s", 0.0, spin="10 rad/s"), pyworm.RigidMotion(0.8, 0.0)),
    bodies=(body, steel),
    oil=named,
)
roller = pyworm.LineScene(
    name="roller",
    gap=pyworm.Parabola("10 mm"),
    load="100 N/mm",
    velocities=("1.1 m/s", 0.9),
    bodies=(body, body),
    oil=oil,
)
measured = pyworm.SampledGap(["-1 mm", "0 mm", "1 mm"], [-1e-3, 0.0, 1e-3], [[1e-6] * 3] * 3)

# cases, plans, solutions
case = pyworm.load("cases/zi_sharif_2001.toml")
contact = case.scene(phase=0.5)
plan = pyworm.plan(ball, accuracy="5 %")
solution = pyworm.solve(ball, plan)
line = pyworm.solve(roller, pyworm.plan(roller, 0.02, "isothermal", ("film",)))
film = pyworm.film((0.01, "20 mm"), "20 N", "226 GPa", ("1 m/s", 0.0), oil)
tracks = list(pyworm.passes(ball, 2, "10 %"))
dry = pyworm.dry_contact(ball)


def loaded(load: float) -> pyworm.Scene:
    """A contact of a sweep."""
    return pyworm.with_slide_roll_ratio(ball, load / 100)


study = pyworm.sweep(loaded, load=(10, 20), accuracy="2 %")
result = pyworm.open_result("result.nc")

# what is read of them are numbers
viscosity: float = oil.eta("500 MPa", "10 K") + oil.viscosity.eta0 + oil.viscosity.alpha
load: float = ball.load + roller.load + roller.velocities[0]
roughness: float | None = body.roughness
minimum: float = solution.figures.film_min.value
thickness: float = line.figures.film_central.value * line.figures.film_central.error
peak: float = float(solution.fields["pressure"].max())
every: list[str] = [one.name for one in plan.effects] + [one.kind for one in result.solutions]
