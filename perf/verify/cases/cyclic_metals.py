"""Metals under cyclic loads, and metals with voids, against closed forms."""
import math

from bench import case

BODIES = {
    "hexahedra": "box: {size: [1, 1, 1], cells: [1, 1, 1]}",
    "full": "box: {size: [1, 1, 1], cells: [1, 1, 1]}, integration: full",
    "tetrahedra": "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: tetrahedra",
    "shells": "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1",
}

LOOPS = """
title: A bar of one cell is pulled and pressed
units: m, kg, s
time: {end: 10}
parts: {bar: {$body, material: steel}}
materials: {steel: {model: chaboche, density: 1e5, youngs_modulus: 210e9, poissons_ratio: 0.3, yield_stress: 200e6, back_stresses: [[40, 4e9], [500, 60e9]], cyclic_stress: $q, cyclic_rate: 25}}
conditions:
  - {nodes: bar/x_min, symmetry: x}
  - {nodes: bar/y_min, symmetry: y}
  - {nodes: {inside: [[0, 0, 0], [1, 1, 0]]}, fixed: [z]}
  - {nodes: bar/x_max, displacement: {x: {expression: "0.01 * sin(2 * pi * t)"}}}
damping: [{coefficient: 20}]
output: {history: {every: 0.005, elements: [{name: m, near: [0.5, 0.5, 0.5]}]}}
"""

VOIDS = """
title: A cube with voids is pulled alike in all directions
units: m, kg, s
time: {end: 1}
parts: {cube: {$body, material: metal}}
materials: {metal: {model: gurson, density: 1e5, youngs_modulus: 210e9, poissons_ratio: 0.3, hardening: [[0, 300e6]], void_fraction: 0.01}}
conditions:
  - {nodes: cube/x_min, symmetry: x}
  - {nodes: cube/y_min, symmetry: y}
  - {nodes: cube/z_min, symmetry: z}
  - {nodes: cube/x_max, displacement: {x: {expression: "0.02 * t"}}}
  - {nodes: cube/y_max, displacement: {y: {expression: "0.02 * t"}}}
  - {nodes: cube/z_max, displacement: {z: {expression: "0.02 * t"}}}
damping: [{coefficient: 20}]
output: {history: {every: 0.01, elements: [{name: m, near: [0.5, 0.5, 0.5]}]}}
"""


@case("cyclic_metals", "plastic", "Cyclic loads and voids: Chaboche's and Gurson's laws")
def cyclic_metals(bench):
    """A bar of one cell goes through ten loops of 1 % each way. In a loop that repeats, with the plastic strain p in each half, the back
    stresses give the sum of C / gamma tanh(gamma p / 2), beside the size of the surface: 0.1 %. A cube with 1 % of voids is
    pulled alike in all directions to a strain of 2 %. Its mean stress is 2 Y / (3 q2) acosh((1 + q3 f^2) / (2 q1 f)), and
    all plastic strain is of the voids (Gurson 1977; Tvergaard and Needleman 1984): 0.1 %."""
    for name, body in BODIES.items():
        for hardening, q in (("hardens", 80e6), ("softens", -60e6)):
            h = bench.run(LOOPS, body=body, q=f"{q:g}").history
            late = h["time"] >= 9 - 1e-9
            plastic, stress = h["m_eps"][late], abs(h["m_stress_xx"][late]).max()
            p = 0.5 * (plastic[-1] - plastic[0])
            right = (200e6 + q * (1 - math.exp(-25 * plastic[-1])) + 4e9 / 40 * math.tanh(20 * p)
                     + 60e9 / 500 * math.tanh(250 * p))
            bench.near(f"Chaboche, {name}, {hardening}: largest stress of the tenth loop", 1e-6 * stress, 1e-6 * right,
                       relative=1e-3, unit="MPa")
    for name in ("hexahedra", "full", "tetrahedra"):
        h = bench.run(VOIDS, body=BODIES[name]).history
        f, mean = h.last("m_void_fraction"), -h.last("m_pressure")
        right = 2 * 300e6 / 3 * math.acosh((1 + 2.25 * f * f) / (3 * f))
        bench.near(f"Gurson, {name}: mean stress", 1e-6 * mean, 1e-6 * right, relative=1e-3, unit="MPa")
        bench.near(f"Gurson, {name}: void fraction", f, 1 - 0.99 * math.exp(-(3 * math.log(1.02) - right / 175e9)),
                   relative=1e-3)
