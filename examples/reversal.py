"""Reversal: a line contact whose entrainment changes its sign; the film lags behind a steady one."""

import sys

import matplotlib.pyplot as plt

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
case = pyworm.load(sys.argv[2] if len(sys.argv) > 2 else "cases/reversal_line.toml")
scene = case.scene()
moving = pyworm.solve(scene, pyworm.plan(scene, accuracy, ("isothermal", "squeeze")))
steady = pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
print(pyworm.compare(steady, moving).ratios["film_central"])
for solution, name in ((moving, "transient"), (steady, "steady")):
    plt.plot(solution.fields["x"] * 1e3, solution.fields["film"] * 1e6, label=name)
plt.xlim(-0.6, 0.6)
plt.ylim(0, 4e6 * moving.figures.film_central.value)
plt.xlabel("x / mm")
plt.ylabel("film thickness / µm")
plt.legend(frameon=False)
plt.savefig("reversal.png", dpi=120)
