"""Opposite sliding: surfaces that run against each other, a film that is warm and carries by heat too."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "10 %"
steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="40 degC")
scene = pyworm.Scene(
    name="opposite sliding",
    gap=pyworm.Paraboloid("20 mm", "20 mm"),
    load="40 N",
    motions=(pyworm.RigidMotion(2.5, 0), pyworm.RigidMotion(-0.5, 0)),
    bodies=(steel, steel),
    oil=pyworm.named_oil("mineral VG 220").oil(313.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy))
print(f"central film {solution.figures.film_central} m, {solution.figures.temperature_max_film} K")
solution.plot.temperature("opposite_sliding.png")
