"""A traction map: friction over load and slide-roll ratio."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
steel = pyworm.named_body("16MnCr5", bulk_temperature="60 degC")
oil = pyworm.named_oil("mineral VG 220").oil(333.15)
loads, ratios = (20.0, 60.0), (0.02, 0.1, 0.5)


def contact(load, ratio):
    motions = pyworm.RigidMotion(1 + ratio / 2, 0), pyworm.RigidMotion(1 - ratio / 2, 0)
    gap = pyworm.Paraboloid(0.01, 0.01)
    return pyworm.Scene(
        name="ball", gap=gap, load=load, motions=motions, bodies=(steel, steel), oil=oil
    )


study = pyworm.sweep(contact, load=loads, ratio=ratios, accuracy=accuracy)
friction = study.table["friction_coefficient"].values.reshape(len(loads), len(ratios))
print(np.round(friction, 4))
for load, row in zip(loads, friction, strict=True):
    plt.semilogx(ratios, row, "o-", label=f"{load:g} N")
plt.xlabel("slide-roll ratio")
plt.ylabel("friction coefficient")
plt.legend(frameon=False)
plt.savefig("traction_map.png", dpi=120)
