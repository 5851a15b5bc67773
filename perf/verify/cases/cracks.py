"""The stress at a crack that is loaded at once."""
import numpy as np

import plots
from bench import case, thin

CRACK = """
title: A crack whose faces are loaded at once
time: {end: $end}
parts: {half: {box: {size: [4, 2, $cell], cells: [$along, $up, 1]}, at: [-2, 0, 0], material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: $young, poissons_ratio: 0.3}}
elements: {bulk_viscosity: {linear: 0.06, quadratic: 0}}
conditions:
  - {nodes: all, fixed: [z]}
  - {nodes: half/x_min, symmetry: x}
  - {nodes: half/x_max, symmetry: x}
  - {nodes: {name: half, inside: [[-1e-9, -1e-9, -1], [9, 1e-9, 1]]}, symmetry: y}
loads: {pressure: [{faces: {name: half/y_min, inside: [[-9, -1e-9, -9], [1e-9, 1e-9, 9]]}, value: 1e-6}]}
output: {history: {every: $every, nodes: [$nodes]}}
"""


@case("loaded_crack", "failure", "Stress intensity of a suddenly loaded crack")
def loaded_crack(bench):
    """Pressure s acts from time 0 on the faces of a long crack in an elastic body (plane strain). The stress intensity
    grows as the square root of the time: K = 2 s / (1 - nu) sqrt((1 - 2 nu) c t / pi), c the speed of pressure waves
    (Freund, *Dynamic Fracture Mechanics*, 1990, section 2.5). Half of the body is computed, until waves come back from
    its edges.

    K follows from the opening, u = 2 (1 - nu) K / G sqrt(r / (2 pi)) (1 + b r / (c t) + ...): a parabola through the
    values of K of the nodes at r from 0.1 to 0.5 leads to the tip. Linear elements without a special tip open as if
    the tip lay a share of an element elsewhere: an error of first order in h / r. It is 2 % or less on the finest mesh,
    and must fall with the size."""
    nu, along_of = 0.3, (100, 200) if bench.quick else (100, 200, 400)
    young = (1 + nu) * (1 - 2 * nu) / (1 - nu)  # c = 1
    shear = young / (2 * (1 + nu))
    rows, curves = [], []
    for along in along_of:
        cell = 4 / along
        places = [(i, -0.04 * i) for i in range(3, 13)]
        h = bench.run(CRACK, end=3.6, cell=cell, along=along, up=along // 2, young=young, every=0.01,
                      nodes=", ".join(f"{{name: n{i}, near: [{x!r}, 0, 0]}}" for i, x in places)).history
        r = -np.array([x for _, x in places])
        opened = np.stack([h[f"n{i}_y"] for i, _ in places])
        each = opened * shear / (2 * (1 - nu)) / np.sqrt(r[:, None] / (2 * np.pi)) / 1e-6
        measured = np.polyfit(r, each, 2)[2]
        exact = 2 / (1 - nu) * np.sqrt((1 - 2 * nu) * h["time"] / np.pi)
        late = (h["time"] > 1.5) & (h["time"] < 3.5)
        rows.append((along, float((measured[late] / exact[late]).mean()), float((measured[late] / exact[late]).std()),
                     bench.cpu))
        curves.append((f"{along} elements along", h["time"], measured))
    bench.near("stress intensity over the exact one, mean from 1.5 to 3.5", rows[-1][1], 1.0, relative=0.02)
    bench.below("error on the finest mesh over that on the next", abs((rows[-1][1] - 1) / (rows[-2][1] - 1)), 0.75)
    bench.table(["elements along", "K over exact", "scatter", "time so far [s]"],
                [[n, f"{m:.4f}", f"{s:.4f}", f"{t:.1f}"] for n, m, s, t in rows])

    def draw(axes):
        t = np.linspace(0, 3.6, 200)
        axes.plot(t, 2 / (1 - nu) * np.sqrt((1 - 2 * nu) * t / np.pi), label="Freund", **plots.EXACT)
        for name, times, measured in curves:
            axes.plot(*thin(times, measured), label=name)
        axes.set(xlabel="c t", ylabel="K / s")
        axes.legend()

    bench.figure("Stress intensity after the faces are loaded.", draw)
