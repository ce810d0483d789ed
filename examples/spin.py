"""Spin: a disc that turns under a ball skews the horseshoe."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
steel = pyworm.Body.from_name("16MnCr5")
scene = pyworm.Scene(
    name="ball with spin",
    gap=pyworm.Paraboloid("10 mm", "10 mm"),
    load="40 N",
    motions=(pyworm.RigidMotion(0.5, 0), pyworm.RigidMotion(0.5, 0, spin="2500 rad/s")),
    bodies=(steel, steel),
    oil=pyworm.named_oil("mineral VG 100").oil(333.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
print(f"minimum film thickness {solution.figures.film_min} m at {solution.figures.film_min_at}")
solution.plot.film("spin.png")
