"""Thick shells: plates, a roof and a strip that yields, one element through the thickness."""
import numpy as np

import meshes
from bench import case


@case("thick_strip", "shells", "Thick shells: a cantilever plate under its weight", quick=True)
def thick_strip(bench):
    """A strip of ten thick shells, each ten times as long as thick, bends in a cylinder under its weight (nu = 0.3, its sides do not contract).
    The deflection of its end is g L^4 12 (1 - nu^2) / (8 E t^2) of the density 1. Fully integrated hexahedra of the same mesh lock. The
    deflection is a thousandth of the length. The tolerance is 1 %."""
    length, nu = 100.0, 0.3
    gravity = 1e-3 / length**3
    exact = gravity * length**4 * 12 * (1 - nu**2) / 8
    rows = []
    for kind in ("thick_shell", "full"):
        h = bench.run("""
title: A cantilever of thick shells
time: {end: 1e-9, max_steps: 1}
parts: {strip: {box: {size: [$length, 10, 1], cells: [10, 1, 1]}, material: m, integration: $kind}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: $nu}}
loads: {gravity: [0, 0, $gravity]}
conditions:
  - {nodes: strip/x_min, fixed: [x]}
  - {nodes: {inside: [[0, -1, -0.1], [0, 11, 0.1]]}, fixed: [z]}
  - {nodes: strip/y_min, symmetry: y}
  - {nodes: strip/y_max, symmetry: y}
start: {relaxation: {tolerance: 1e-10, max_steps: 1000000}}
output: {history: {every: 1, nodes: [{name: tip, near: [$length, 0, 0]}]}}
silence: [single_layer, shear_locking]
""", length=length, kind=kind, nu=nu, gravity=-gravity).history
        rows.append([kind, f"{-h.first('tip_z') / exact:.4f}"])
        if kind == "thick_shell":
            bench.near("deflection of the end over that of the plate", -h.first("tip_z") / exact, 1.0, relative=0.01)
    bench.table(["integration", "deflection over that of the plate"], rows)


@case("thick_roof", "shells", "Thick shells: the Scordelis-Lo roof")
def thick_roof(bench):
    """A cylindrical roof (R = 25, L = 50, 80 degrees, t = 0.25, E = 4.32e8, nu = 0) rests on diaphragms and bears 90 by its area. The middle of its
    free edge falls by 0.3024 (MacNeal and Harder 1985; deep shell theory: 0.3086). A quarter has one layer of thick shells. The roof is brought to rest under a
    thousandth of the load. The tolerance is 3 % with 16 x 16."""
    rows = []
    for cells in (8, 16):

        def place(u, v):
            turn = np.radians(40) * u
            return 25 * np.sin(turn), 25 * v, 25 * np.cos(turn)

        middle, quads = meshes.make_surface((cells, cells), place)
        normal = middle * np.array([1, 0, 1]) / 25
        points = np.vstack([middle - 0.125 * normal, middle + 0.125 * normal])
        mesh = meshes.write_exodus(bench.file(f"roof_{cells}.exo"), points, np.hstack([quads, quads + len(middle)]))
        h = bench.run("""
title: A roof of thick shells
time: {end: 1e-9, max_steps: 1}
parts: {roof: {exodus: {file: $mesh}, material: m, integration: thick_shell}}
materials: {m: {model: elastic, density: 360, youngs_modulus: 4.32e8, poissons_ratio: 0}}
loads: {gravity: [0, 0, -1e-3]}
conditions:
  - {nodes: {inside: [[-1e-6, -1, 0], [1e-6, 99, 99]]}, symmetry: x}
  - {nodes: {inside: [[-1, -1e-6, 0], [99, 1e-6, 99]]}, symmetry: y}
  - {nodes: {inside: [[-1, 24.999999, 0], [99, 25.000001, 99]]}, fixed: [x, z]}
start: {relaxation: {tolerance: 1e-8, max_steps: 1000000}}
output: {history: {every: 1, nodes: [{name: edge, near: [16.0697, 0, 19.1511]}]}}
silence: [single_layer]
""", mesh=mesh).history
        fallen = 1e3 * (h.first("edge_z") - points[np.argmin(np.abs(points - [16.0697, 0, 19.1511]).sum(axis=1))][2])
        bench.near(f"{cells} x {cells}: fall of the edge", -fallen, 0.3024, relative=0.06 if cells == 8 else 0.03)
        rows.append([f"{cells} x {cells}", f"{-fallen / 0.3024:.4f}"])
    bench.table(["mesh", "fall over the published one"], rows)


@case("thick_yield", "shells", "Thick shells: a plate bends until it yields through", quick=True)
def thick_yield(bench):
    """A strip of thick shells, 1 mm thick and in plane strain, is bent to eight times the curvature at yield by its end, which turns as a whole. Steel without
    hardening (yield stress s) then bears s t^2 / (2 sqrt(3)) by its width. The Gauss rule of three points across sees 0.861 of it,
    of five 0.945. Two layers of elements have it whole, but for the elastic core: 0.995. This bending is even; at a clamp layers carry more
    ([limits.md](../limits.md)). The tolerance is 1 %, with two layers 2 %."""
    young, nu, stress, length = 200e3, 0.3, 300.0, 10.0
    limit = stress / (2 * np.sqrt(3))
    at_yield = 2 * stress * (1 - nu**2) / (young * np.sqrt(1 - nu + nu**2))
    rows = []
    for layers, points, expected in ((1, 3, 0.861), (1, 5, 0.945), (2, 5, 0.995)):
        spin = 8 * at_yield * length / 1.9e-3
        h = bench.run("""
title: A plate yields through
units: mm, t, s
time: {end: 2e-3}
parts: {strip: {box: {size: [$length, 4, 1], cells: [5, 1, $layers]}, material: m, integration: {kind: thick_shell, points: $points}}}
materials: {m: {model: j2_plasticity, density: 7.85e-9, youngs_modulus: $young, poissons_ratio: $nu, yield_stress: $stress}}
conditions:
  - {nodes: strip/x_min, fixed: [x]}
  - {nodes: {inside: [[0, -1, 0], [0, 11, 0]]}, fixed: [z]}
  - {nodes: strip/y_min, symmetry: y}
  - {nodes: strip/y_max, symmetry: y}
  - {body: end, velocity: {ry: {table: [[0, 0], [2e-4, $spin], [2e-3, $spin]]}}}
rigid_sets: {end: {nodes: strip/x_max}}
damping: [{coefficient: 3e3}]
output: {history: {every: 1e-6, forces: [{name: f, support: strip/x_min, about: [0, 0, 0.5]}]}}
silence: [single_layer]
""", length=length, layers=layers, points=points, young=young, nu=nu, stress=stress, spin=spin).history
        share = abs(h.mean(1.8e-3, 2e-3, "my:f")) / 4 / limit
        rows.append([layers, points, f"{share:.4f}"])
        bench.near(f"{layers} layer{'s' * (layers > 1)}, {points} points: moment over the limit", share, expected,
                   relative=0.01 * layers)
    bench.table(["layers", "points in each", "moment over the limit"], rows)
