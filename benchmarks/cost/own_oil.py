"""What an oil by tables costs beside the same oil by Roelands' and Eyring's laws: processor times, in turns.

python benchmarks/cost/own_oil.py [turns]
"""

import statistics
import sys
import time
from dataclasses import replace

import numpy as np

import pyworm

INLET = 333.15
TURNS = int(sys.argv[1]) if len(sys.argv) > 1 else 7


def by_tables(oil):
    """The oil as functions of pressure and temperature, tabulated, its flow law too."""
    heat = oil.heat

    def eta(pressure, temperature):
        return np.vectorize(oil.eta)(pressure, temperature - INLET)

    def rho(pressure, temperature):
        return oil.density(pressure) * (1 - heat.expansivity * (temperature - INLET))

    def sheared(newtonian):
        return oil.flow.stress * np.arcsinh(newtonian / oil.flow.stress)

    return replace(
        oil,
        viscosity=pyworm.TabulatedViscosity.of(eta, INLET),
        density=pyworm.TabulatedDensity.of(rho, INLET),
        flow=pyworm.FlowLaw.of(sheared, oil.flow.stress),
    )


def main():
    steel = pyworm.Body.from_name("16MnCr5", bulk_temperature=INLET)
    oil = replace(
        pyworm.named_oil("mineral VG 220").oil(INLET), flow=pyworm.FlowLaw("eyring", stress=5e6)
    )
    closed = pyworm.Scene(
        name="ball",
        gap=pyworm.Paraboloid(0.01, 0.01),
        load=40.0,
        motions=(pyworm.RigidMotion(1.1, 0), pyworm.RigidMotion(0.9, 0)),
        bodies=(steel, steel),
        oil=oil,
    )
    tables = replace(closed, oil=by_tables(oil))
    for effects, accuracy in (("isothermal", 0.001), ("all", 0.005)):
        seconds = {closed: [], tables: []}
        plans = {scene: pyworm.plan(scene, accuracy, effects) for scene in seconds}
        for scene in (closed, tables):
            pyworm.solve(scene, plans[scene])
        for _ in range(TURNS):
            for scene, times in seconds.items():
                begin = time.process_time()
                pyworm.solve(scene, plans[scene])
                times.append(time.process_time() - begin)
        one, other = (statistics.median(times) for times in seconds.values())
        print(
            f"{effects:10s}  closed forms {one:.3f} s  tables {other:.3f} s  ratio {other / one:.2f}"
        )


if __name__ == "__main__":
    main()
