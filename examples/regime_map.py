"""A regime map: where contacts of three loads and speeds lie on the chart of lubrication."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "10 %"
steel = pyworm.Body.from_name("16MnCr5")
oil = pyworm.named_oil("mineral VG 220").oil(333.15)
solutions = []
for load, speed in ((1, 5.0), (10, 1.0), (100, 0.2)):
    motions = (pyworm.RigidMotion(speed, 0),) * 2
    gap, name = pyworm.Paraboloid(0.01, 0.01), f"{load} N, {speed} m/s"
    scene = pyworm.Scene(
        name=name, gap=gap, load=load, motions=motions, bodies=(steel, steel), oil=oil
    )
    solutions.append(pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal")))
    print(name, solutions[-1].regime.name)
result = pyworm.Result("regimes", {}, tuple(solutions), None, {})
pyworm.plots.write(pyworm.plots.draw_regimes(result), "regime_map.png")
