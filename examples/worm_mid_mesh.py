"""A worm gear at mid-mesh: the film between worm and wheel, from a case file of the drive."""

import sys

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
case = pyworm.load(sys.argv[2] if len(sys.argv) > 2 else "cases/zi_sharif_2001.toml")
scene = case.scene(phase=0.5)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, ("auto", "-squeeze")))
print(f"minimum film thickness {solution.figures.film_min} m")
solution.plot.film("worm_mid_mesh.png")
