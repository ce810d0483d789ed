"""A traction map: friction over load and slide-roll ratio."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
oil = pyworm.named_oil("mineral VG 220").oil(333.15)
loads, ratios = (20.0, 60.0), (0.02, 0.1, 0.5)


def contact(load, ratio):
    motions = pyworm.RigidMotion(1 + ratio / 2, 0), pyworm.RigidMotion(1 - ratio / 2, 0)
    gap = pyworm.Paraboloid(0.01, 0.01)
    return pyworm.Scene(
        name="ball", gap=gap, load=load, motions=motions, bodies=(steel, steel), oil=oil
    )


study = pyworm.sweep(contact, load=loads, ratio=ratios, accuracy=accuracy)
friction = study.dataset.friction_coefficient
print(np.round(friction.values, 4))
figure, axes = plt.subplots(layout="constrained")
for load in loads:
    axes.plot(ratios, friction.sel(load=load), "o-", label=f"$F$ = {load:g} N")
axes.set(
    title="Friction of a ball on a disc, mineral VG 220 at 60 °C, $u$ = 1 m/s",
    xlabel="slide-roll ratio $S$",
    ylabel="friction coefficient $\\mu$",
    xlim=(0, None),
    ylim=(0, None),
)
axes.legend(frameon=False)
figure.savefig("traction_map.png", dpi=120)
