"""Cracks in glue that slide."""
import numpy as np

from bench import case

SPLIT = """
title: An end-loaded split beam
time: {end: 9e-3}
parts:
  low: {box: {size: [0.05, 0.001, 0.002], cells: [$cells, 1, $through]}, at: [0, 0, -0.002], material: m}
  high: {box: {size: [0.05, 0.001, 0.002], cells: [$cells, 1, $through]}, material: m}
materials: {m: {model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}}
contact:
  surfaces: none
  ties: [{a: {name: high/z_min, inside: [[0.0299, -1, -1], [1, 1, 1]]}, b: low/z_max, cohesive: {normal_stiffness: 1e13, normal_strength: 30e6, shear_strength: 60e6, normal_energy: 200, shear_energy: 700}}]
damping: [{coefficient: 200}]
conditions:
  - {nodes: high/x_min, velocity: {z: {table: [[0, 0], [1e-3, 0.4], [9e-3, 0.4]]}}}
  - {nodes: low/x_min, velocity: {z: {table: [[0, 0], [1e-3, 0.4], [9e-3, 0.4]]}}}
  - {nodes: high/x_max, fixed: [x, y, z]}
  - {nodes: low/x_max, fixed: [x, y, z]}
output: {history: {every: 1e-5, forces: [{name: up, support: high/x_min}, {name: down, support: low/x_min}]}}
"""


@case("split_beam", "failure", "Glue: an end-loaded split beam")
def split_beam(bench):
    """Two beams of 2 mm, glued but for the first 30 of 50 mm, are clamped at one end; both free ends are pushed across together. The crack
    slides. Beam theory (Williams 1988): the deflection is P (3 a^3 + L^3) / (2 E b h^3), and the crack takes 9 P^2 a^2 / (4 E b^2 h^3). The
    length a that explains force and deflection, which grows with the crack, gives the energy that the crack takes. Means of half a
    millisecond: 5 %. The energy that the glue itself dissipates, by the area that fails meanwhile: 3 %."""
    young, width, height, length, crack = 70e9, 1e-3, 2e-3, 0.05, 0.03
    stiff = young * width * height**3
    for cells, through in ((50, 2), (75, 3)):
        h = bench.run(SPLIT, cells=cells, through=through).history
        force = h["fz:up"] + h["fz:down"]
        name = f"{1e3 * length / cells:.2g} mm"

        def mean(start, values):
            inside = (h["time"] >= start) & (h["time"] < start + 5e-4)
            return float(np.mean(values[inside]))

        def bend(start):
            return 0.4 * (start + 2.5e-4 - 5e-4)

        bench.near(f"{name}: force at 1.1 mm over that of beams", mean(3e-3, force), bend(3e-3) * 2 * stiff / (3 * crack**3 + length**3), relative=0.05, unit="N")
        for start in (7e-3, 7.5e-3):
            pushed = mean(start, force)
            reached = np.cbrt((bend(start) * 2 * stiff / pushed - length**3) / 3)
            bench.near(f"{name}, {1e3 * start + 0.25:g} ms: energy of the crack at {1e3 * reached:.0f} mm", 9 * pushed**2 * reached**2 / (4 * stiff * width), 700.0, relative=0.05, unit="J/m2")
        first, last = (np.searchsorted(h["time"], t) for t in (7e-3, 8.9e-3))
        spent = (h["glue_dissipated"][last] - h["glue_dissipated"][first]) / (h["glue_failed"][last] - h["glue_failed"][first])
        bench.near(f"{name}: energy dissipated by the area that fails", float(spent), 700.0, relative=0.03, unit="J/m2")
