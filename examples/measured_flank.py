"""A measured flank: heights on a grid as the gap, here those of a crowned flank with a wave of grinding."""

import sys

import numpy as np

import pyworm

accuracy = sys.argv[1] if len(sys.argv) > 1 else "5 %"
x, y = np.linspace(-2e-3, 2e-3, 161), np.linspace(-2e-3, 2e-3, 81)
heights = (
    x**2 / 0.04 + y[:, None] ** 2 / 0.08 + 0.3e-6 * (1 - np.cos(2 * np.pi * y[:, None] / 0.8e-3))
)
steel = pyworm.Body.from_name("16MnCr5")
scene = pyworm.Scene(
    name="measured flank",
    gap=pyworm.SampledGap(x, y, heights),
    load="60 N",
    motions=(pyworm.RigidMotion(1.0, 0), pyworm.RigidMotion(1.0, 0)),
    bodies=(steel, steel),
    oil=pyworm.named_oil("mineral VG 220").oil(333.15),
)
solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
print(
    f"maximum pressure {solution.figures.pressure_max} Pa, dry {solution.figures.dry.pressure_max:.4g}"
)
solution.plot.pressure("measured_flank.png")
