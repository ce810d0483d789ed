"""Ball on disc: the horseshoe of the film."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "2 %"
steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
scene = pyworm.Scene(
    name="ball on disc",
    gap=pyworm.Paraboloid("12.7 mm", "12.7 mm"),
    load="40 N",
    motions=(pyworm.RigidMotion(0.5, 0), pyworm.RigidMotion(0.5, 0)),
    bodies=(steel, steel),
    oil=pyworm.named_oil("PAO VG 220").oil(333.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy))
print(f"minimum film thickness {solution.figures.film_min} m")
solution.plot.film("ball_on_disc.png")
