"""A Stribeck curve: friction of a rough ball from mixed to full film over speed."""

import sys

import matplotlib.pyplot as plt

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
rough = pyworm.Body.from_name("16MnCr5", roughness="0.1 um", bulk_temperature="80 degC")
oil = pyworm.named_oil("mineral VG 100").oil(353.15)
speeds = (0.05, 0.2, 0.8, 3.0)


def contact(speed):
    motions = pyworm.RigidMotion(1.1 * speed, 0), pyworm.RigidMotion(0.9 * speed, 0)
    gap = pyworm.Paraboloid(0.01, 0.01)
    return pyworm.Scene(
        name="rough", gap=gap, load=20, motions=motions, bodies=(rough, rough), oil=oil
    )


curve = pyworm.sweep(contact, speed=speeds, accuracy=accuracy).dataset
print(curve[["friction_coefficient", "specific_film"]].to_dataframe())
plt.semilogx(speeds, curve.friction_coefficient, "o-")
plt.xlabel("entrainment velocity / (m/s)")
plt.ylabel("friction coefficient")
plt.savefig("stribeck_curve.png", dpi=120)
