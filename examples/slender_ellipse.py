"""A slender ellipse across the entrainment: as wide as a worm's contact, its dip at the sides almost gone."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "2 %"
steel = pyworm.Body.from_name("16MnCr5")
scene = pyworm.Scene(
    name="slender ellipse",
    gap=pyworm.Paraboloid("10 mm", "100 mm"),
    load="200 N",
    motions=(pyworm.RigidMotion(1.0, 0), pyworm.RigidMotion(1.0, 0)),
    bodies=(steel, steel),
    oil=pyworm.named_oil("mineral VG 220").oil(333.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
print(f"least over central film {solution.figures.film_min / solution.figures.film_central}")
solution.plot.film("slender_ellipse.png")
