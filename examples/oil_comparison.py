"""Oils compared: films and friction of one contact in three base stocks of a grade."""

import sys

import matplotlib.pyplot as plt

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
steel = pyworm.named_body("16MnCr5", bulk_temperature="60 degC")
motions = pyworm.RigidMotion(1.1, 0), pyworm.RigidMotion(0.9, 0)
stocks = ("mineral", "PAO", "PAG")
solutions = []
for stock in stocks:
    oil = pyworm.named_oil(f"{stock} VG 220").oil(333.15)
    gap = pyworm.Paraboloid(0.01, 0.01)
    scene = pyworm.Scene(
        name=stock, gap=gap, load=40, motions=motions, bodies=(steel, steel), oil=oil
    )
    solutions.append(pyworm.solve(scene, pyworm.plan(scene, accuracy)))
print(pyworm.compare(solutions[0], solutions[-1]).ratios["friction_coefficient"])
for name, scale in (("film_central", 1e6), ("friction_coefficient", 10)):
    figures = [getattr(one.figures, name) for one in solutions]
    values, bars = [scale * of.value for of in figures], [scale * of.bar for of in figures]
    plt.errorbar(stocks, values, bars, fmt="o", capsize=4, label=f"{name} x {scale:g}")
plt.ylim(0)
plt.legend(frameon=False)
plt.savefig("oil_comparison.png", dpi=120)
