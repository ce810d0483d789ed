"""Oils compared: films and friction of one contact in three base stocks of a grade."""

import sys

import matplotlib.pyplot as plt

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
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
figure, panels = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
figure.suptitle("Three base oils of VG 220 at 60 °C: ball on disc, 40 N, slide-roll ratio 0.2")
labels = {
    "film_central": (1e6, "$h_c$ / µm"),
    "friction_coefficient": (1, "friction coefficient $\\mu$"),
}
for panel, (name, (scale, label)) in zip(panels, labels.items(), strict=True):
    figures = [getattr(one.figures, name) for one in solutions]
    values, bars = [scale * of.value for of in figures], [scale * of.bar for of in figures]
    panel.errorbar(stocks, values, bars, fmt="o", capsize=4)
    panel.set(
        xlabel="base oil", ylabel=label, xlim=(-0.5, len(stocks) - 0.5), ylim=(0, 1.2 * max(values))
    )
figure.savefig("oil_comparison.png", dpi=120)
