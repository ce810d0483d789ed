"""A roller: profiles of pressure and film of a line contact."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "2 %"
steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
scene = pyworm.LineScene(
    name="roller",
    gap=pyworm.Parabola("10 mm"),
    load="200 kN/m",
    velocities=(1.1, 0.9),
    bodies=(steel, steel),
    oil=pyworm.named_oil("PAO VG 220").oil(333.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy))
print(f"friction {solution.figures.friction_coefficient}")
solution.plot.profiles("roller.png")
