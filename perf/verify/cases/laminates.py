"""Laminates of shells: laminate theory, and cracks of a stated energy."""
import numpy as np

from bench import case

CARBON = ("model: orthotropic, density: 1.6e-9, moduli: [140e3, 10e3, 10e3], poissons_ratios: [0.3, 0.4, 0.3], "
          "shear_moduli: [5e3, 3.5e3, 5e3]")
LAMINATES = {
    "30": [(0.5, 30)],
    "45, -45, -45, 45": [(0.25, 45), (0.25, -45), (0.25, -45), (0.25, 45)],
    "0, 90": [(0.75, 0), (0.75, 90)],
    "0, 30, -45, 90": [(0.4, 0), (0.6, 30), (0.3, -45), (0.4, 90)],
}
LENGTH, WIDTH = 4.0, 2.0


def find_stiffness(plies):
    """A, B and D of laminate theory in one matrix."""
    e1, e2, nu12, g12 = 140e3, 10e3, 0.3, 5e3
    over = 1 / (1 - nu12**2 * e2 / e1)
    own = np.array([[e1 * over, nu12 * e2 * over, 0], [nu12 * e2 * over, e2 * over, 0], [0, 0, g12]])
    whole, bottom = np.zeros((6, 6)), -sum(t for t, _ in plies) / 2
    for thickness, angle in plies:
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        strain = np.array([[c * c, s * s, c * s], [s * s, c * c, -c * s], [-2 * c * s, 2 * c * s, c * c - s * s]])
        turned, top = strain.T @ own @ strain, bottom + thickness
        whole[:3, :3] += turned * (top - bottom)
        whole[:3, 3:] += turned * (top**2 - bottom**2) / 2
        whole[3:, 3:] += turned * (top**3 - bottom**3) / 3
        bottom = top
    whole[3:, :3] = whole[:3, 3:]
    return whole


def select_corner(x, y):
    return f"{{name: s, inside: [[{x - 0.01}, {y - 0.01}, -1], [{x + 0.01}, {y + 0.01}, 1]]}}"


@case("laminate_theory", "shells", "Laminates under a force along them")
def laminate_theory(bench):
    """A strip of carbon fibres of 4 mm x 2 mm, 4 elements, is pulled by 1 mN. Two of the four laminates are not symmetric:
    they bend and twist under a force in their plane. Strains and curvatures are those of classical laminate theory
    (Jones, chapter 4). The tolerance is 0.002 %."""
    for name, plies in LAMINATES.items():
        loads = ", ".join(f"{{nodes: {select_corner(x, y)}, force: {{x: {f}}}}}" for x, y, f in
                          ((0.0, WIDTH, -5e-4), (LENGTH, 0.0, 5e-4), (LENGTH, WIDTH, 5e-4)))
        h = bench.run("""
title: A laminate under a force
time: {end: 1e-7}
materials: {ply: {$carbon}}
parts: {s: {shell_plate: {size: [4, 2], cells: [4, 1]}, material: ply, plies: [$plies]}}
conditions: [{nodes: $corner, fixed: [x, y, z, rx, ry, rz]}]
loads: {nodal: [$loads]}
start: {relaxation: {tolerance: 1e-12, max_steps: 400000}}
output: {history: {every: 1e-7, nodes: [{name: a, near: [4, 0, 0]}, {name: b, near: [4, 2, 0]}]}}
""", carbon=CARBON, plies=", ".join(f"{{thickness: {t}, angle: {a}}}" for t, a in plies), corner=select_corner(0, 0),
                      loads=loads).history
        e = np.linalg.solve(find_stiffness(plies), [1e-3 / WIDTH, 0, 0, 0, 0, 0])
        bench.near(f"{name}: strain along", 1e9 * (h["a_x"][0] / LENGTH - 1), 1e9 * e[0], relative=2e-5, unit="1e-9")
        if abs(e[3]) > 1e-12:
            deflection = -(e[3] * LENGTH**2 + e[4] * WIDTH**2 + e[5] * LENGTH * WIDTH) / 2
            bench.near(f"{name}: deflection of a corner", 1e9 * h["b_z"][0], 1e9 * deflection, relative=2e-5,
                       unit="1e-9 mm")


@case("laminate_crack", "shells", "A crack across the fibres takes its energy on any mesh")
def laminate_crack(bench):
    """A strip of 10 mm x 2 mm x 0.4 mm is pulled across its fibres, a tenth weaker in one element of its length. It breaks
    there: 0.1 N/mm times the section. The tolerance is 1 %."""
    for cells in (5, 9, 15):
        side = 10.0 / cells
        start = side * (cells // 2)
        h = bench.run("""
title: A crack across a strip
time: {end: 2e-4}
materials:
  ply: {$carbon, first_axis: [0, 1, 0], matrix_tension: 10, shear: 80, matrix_tension_energy: 0.1}
  weak: {$carbon, first_axis: [0, 1, 0], matrix_tension: 9, shear: 80, matrix_tension_energy: 0.1}
parts:
  a: {shell_plate: {size: [$start, 2], cells: [$half, 1]}, material: ply, thickness: 0.4}
  b: {shell_plate: {size: [$side, 2], cells: [1, 1]}, at: [$start, 0, 0], material: weak, thickness: 0.4}
  c: {shell_plate: {size: [$start, 2], cells: [$half, 1]}, at: [$end, 0, 0], material: ply, thickness: 0.4}
join: true
conditions:
  - {nodes: a/x_min, fixed: x}
  - {nodes: a, fixed: [z, rx, ry, rz]}
  - {nodes: b, fixed: [z, rx, ry, rz]}
  - {nodes: c, fixed: [z, rx, ry, rz]}
  - {nodes: c/x_max, velocity: {x: 200}}
output: {history: {every: 1e-6}}
""", carbon=CARBON, start=start, half=cells // 2, side=side, end=start + side).history
        bench.near(f"{cells} elements: energy", h.last("internal"), 0.1 * 2 * 0.4, relative=0.01, unit="mJ")
