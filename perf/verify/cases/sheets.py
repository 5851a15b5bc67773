"""Rolled sheet: strain ratios and yield stress by direction."""
import numpy as np

from bench import case

MODULUS, NU, YIELD, SLOPE = 70e3, 0.33, 200.0, 400.0
HILL, BARLAT = (1.8, 1.2, 2.3), (0.7, 0.5, 0.9)


def find_hill_stress(r, degrees):
    """Uniaxial yield stress over that of the rolling direction (Hill 1948)."""
    f, g, h = r[0] / (r[2] * (1 + r[0])), 1 / (1 + r[0]), r[0] / (1 + r[0])
    n = (r[0] + r[2]) * (1 + 2 * r[1]) / (2 * r[2] * (1 + r[0]))
    c, s = np.cos(np.radians(degrees)) ** 2, np.sin(np.radians(degrees)) ** 2
    return 1 / np.sqrt(f * s + g * c + h + (2 * n - f - g - 4 * h) * c * s)


def pull(bench, ratios, exponent, degrees):
    h = bench.run("""
title: A strip of rolled sheet
time: {end: 2e-3}
materials: {m: {model: anisotropic_plasticity, density: 2.7e-9, youngs_modulus: 70e3, poissons_ratio: 0.33, hardening: [[0, 200], [1, 600]],
  r_values: $ratios, exponent: $exponent, first_axis: [$x, $y, 0]}}
parts: {s: {shell_plate: {size: [10, 10], cells: [1, 1]}, thickness: 1, material: m}}
conditions:
  - {nodes: s/x_min, fixed: [x]}
  - {nodes: {name: s, inside: [[-1, -1, -1], [0.1, 0.1, 0.1]]}, fixed: [y, z]}
  - {nodes: s/x_max, velocity: {x: {table: [[0, 0], [1e-3, 333.333], [2e-3, 333.333]]}}}
output: {history: {every: 2e-5, nodes: [{name: a, near: [10, 10, 0]}, {name: b, near: [10, 0, 0]}], elements: [{name: e, near: [5, 5, 0]}]}}
""", ratios=list(ratios), exponent=exponent, x=np.cos(np.radians(degrees)), y=-np.sin(np.radians(degrees))).history
    stress = h.last("e_stress_xx")
    along = np.log(h.last("a_x") / 10) - stress / MODULUS
    width = np.log((h.last("a_y") - h.last("b_y")) / 10) + NU * stress / MODULUS
    return stress / (YIELD + SLOPE * h.last("e_eps")), -width / (along + width)


@case("rolled_sheet", "shells", "Rolled sheet in tension at 0, 45 and 90 degrees")
def rolled_sheet(bench):
    """A shell of 10 mm is pulled to 1.05 of its length, at an angle to its rolling direction. The plastic strain of its width over
    that of its thickness is the r-value of the deck, by Hill (1948) and by Barlat and Lian (1989) with the exponent 8. The
    stress over that of the hardening curve is Hill's. The tolerance is 0.2 %."""
    for degrees, r in zip((0, 45, 90), HILL):
        stress, ratio = pull(bench, HILL, 2, degrees)
        bench.near(f"Hill, {degrees} degrees: r-value", ratio, r, relative=2e-3)
        bench.near(f"Hill, {degrees} degrees: stress over the curve", stress, find_hill_stress(HILL, degrees),
                   relative=2e-3)
    for degrees, r in zip((0, 45, 90), BARLAT):
        _, ratio = pull(bench, BARLAT, 8, degrees)
        bench.near(f"Barlat and Lian, {degrees} degrees: r-value", ratio, r, relative=2e-3)
