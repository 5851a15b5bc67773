"""Cracks: the stress at one that is loaded at once, and the way of one that runs."""
import numpy as np

import meshes
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


@case("loaded_crack", "failure", "A crack whose faces are loaded at once")
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
        rows.append((along, float((measured[late] / exact[late]).mean()), float((measured[late] / exact[late]).std()), bench.cpu))
        curves.append((f"{along} elements along", h["time"], measured))
    bench.near("stress intensity over the exact one, mean from 1.5 to 3.5", rows[-1][1], 1.0, relative=0.02)
    bench.below("error on the finest mesh over that on the next", abs((rows[-1][1] - 1) / (rows[-2][1] - 1)), 0.75)
    bench.table(["elements along", "K over exact", "scatter", "time so far [s]"], [[n, f"{m:.4f}", f"{s:.4f}", f"{t:.1f}"] for n, m, s, t in rows])

    def draw(axes):
        t = np.linspace(0, 3.6, 200)
        axes.plot(t, 2 / (1 - nu) * np.sqrt((1 - 2 * nu) * t / np.pi), label="Freund", **plots.EXACT)
        for name, times, measured in curves:
            axes.plot(*thin(times, measured), label=name)
        axes.set(xlabel="c t", ylabel="K / s")
        axes.legend()

    bench.figure("Stress intensity after the faces are loaded.", draw)


NOTCHED = """
title: Kalthoff and Winkler's notched plate
time: {end: 9e-5}
parts: {plate: {exodus: {file: $mesh}, material: steel}}
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 190e9, poissons_ratio: 0.3, failure: {principal_stress: $strength}}}
conditions:
  - {nodes: all, fixed: [z]}
  - {nodes: {inside: [[-1, -1e-9, -1], [1, 1e-9, 1]]}, symmetry: y}
  - {nodes: {inside: [[-1, -1, -1], [1e-9, 0.0249, 1]]}, velocity: {x: {table: [[0, 0], [1e-6, $speed]]}}}
erosion: {free_nodes: remove}
output: {fields: {every: 9e-5, write: [alive]}, history: {every: 5e-7}}
"""


def mesh_notched_plate(bench, cells, seed=1):
    """The upper half of the plate, 100 x 100 mm, with a notch of one row of cells from x = 0 to 50 mm at y = 25 mm; inner nodes are
    moved at random by up to 0.2 of a cell, so that cracks have no rows to follow."""
    size, cell = 0.1, 0.1 / cells
    points, corners = meshes.make_box((size, size, cell), (cells, cells, 1))
    move = np.random.default_rng(seed).uniform(-0.2, 0.2, (cells + 1, cells + 1, 2)) * cell
    i, j = np.rint(points[:, 0] / cell).astype(int), np.rint(points[:, 1] / cell).astype(int)
    row = round(0.025 / cell)
    still = (i == 0) | (i == cells) | (j == 0) | (j == cells) | (((j == row) | (j == row + 1)) & (i <= cells // 2))
    points[:, :2] += np.where(still[:, None], 0, move[j, i])
    return meshes.write_exodus(bench.file(f"plate_{cells}_{seed}.exo"),
                               *meshes.keep(points, corners, lambda x, y, z: ~((x < 0.05) & (y > row * cell) & (y < (row + 1) * cell))))


@case("kalthoff_winkler", "failure", "Kalthoff and Winkler's notched plate")
def kalthoff_winkler(bench):
    """A projectile strikes a plate of maraging steel (18Ni1900: 190 GPa, 8000 kg/m^3, fracture toughness 68 MPa sqrt(m))
    between two notches. Compression waves shear their tips, and at low speed of impact brittle cracks run from them at
    about 70 degrees to the notches (Kalthoff and Winkler 1987; Kalthoff, *Int. J. Fracture* 101, 2000). Computations by
    others, with the edge driven at 16.5 m/s, give 60 to 70 degrees and cracks that reach the side of the plate 80 to
    90 us after the impact (Belytschko and others, *Int. J. Numer. Meth. Engng* 58, 2003: 58 to 65; Song and others,
    *Comput. Mech.* 42, 2008).

    One half in plane strain, its nodes moved at random by up to a fifth of a cell. Elements fail where the largest
    principal stress is K / sqrt(pi h), that of the toughness half an element of size h before a tip. Erosion follows the
    mesh, and the row of failed elements is fitted by a line: 70 degrees +- 10 on the finer mesh."""
    rows, found = [], []
    for cells in (100,) if bench.quick else (70, 100):
        run = bench.run(NOTCHED, mesh=mesh_notched_plate(bench, cells), strength=68e6 / np.sqrt(np.pi * 0.1 / cells), speed=16.5)
        frames, h = run.frames, run.history
        centers = frames.points(0)[frames.corners].mean(axis=1)[:, :2]
        dead = centers[frames.element("alive") < 0.5]
        tip = np.array([0.05, 0.025])
        crack = dead[(dead[:, 1] > 0.03)] - tip
        angle = float(np.degrees(np.arctan2((crack[:, 1]**2).sum(), (crack[:, 0] * crack[:, 1]).sum()))) if len(crack) > 3 else float("nan")
        rows.append([cells, frames.num_elements, len(dead), f"{angle:.1f}", f"{1e3 * (crack[:, 1].max() + 0.025) if len(crack) else 0:.1f}",
                     f"{1e6 * h.time_of_rise('eroded_elements', 0.5):.1f}" if len(dead) else "", f"{h.largest('energy_error'):.1e}", f"{bench.cpu:.1f}"])
        found.append((cells, dead, angle))
    bench.near("angle of the crack to the notch", found[-1][2], 70.0, absolute=10.0, unit="degrees")
    bench.below("energy balance, largest error", h.largest("energy_error"), 0.01)
    bench.table(["elements along a side", "elements", "failed", "angle [degrees]", "highest point of the crack [mm]", "first fails at [us]", "energy error", "time so far [s]"], rows)

    def draw(axes):
        axes.plot([0, 50], [25, 25], color="black")
        for cells, dead, _ in found:
            axes.plot(1e3 * dead[:, 0], 1e3 * dead[:, 1], ".", markersize=3, label=f"{cells} elements along a side")
        axes.plot([50, 50 + 75 / np.tan(np.radians(70))], [25, 100], label="70 degrees", **plots.EXACT)
        axes.set(xlim=(0, 100), ylim=(0, 100), xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
        axes.legend()

    bench.figure("Elements that have failed.", draw, height=4.4)
