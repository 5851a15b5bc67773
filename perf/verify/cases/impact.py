"""Bars that hit a wall and each other: one-dimensional waves tell everything."""
import numpy as np

import choices
import plots
from bench import case, observed_order, thin

YOUNG, DENSITY, AREA = 200e9, 7850, 1e-4
SPEED = np.sqrt(YOUNG / DENSITY)


def find_contact(history, column):
    """First and last time at which a column is not zero."""
    touching = history["time"][np.abs(history[column]) > 0]
    return float(touching[0]), float(touching[-1])


@case("bar_on_wall", "impact", "A bar on a rigid wall", quick=True)
def bar_on_wall(bench):
    """A bar of 10 in at 202.2 in/s hits a rigid wall 0.01 in away (E = 3e7 psi, 0.73e-3 lbf s^2/in^4, 1 in^2). It is a
    published problem of PRONTO's and DYNA3D's manuals; the numbers follow from d'Alembert. With c = 202721 in/s the
    impact is at 4.9456e-5 s and the separation 2 L / c later, at 1.48114e-4 s. The force is rho c v A = 29923 lbf, and
    the rebound is at the impact speed. The impact is detected at the end of its step. The layer of nodes that hits
    loses its energy, which is of first order in h. Rebound and contact time must therefore converge, and are within 1 %
    with 200 elements."""
    sizes, rebound, curves = [], [], []
    for cells in (25, 50, 100, 200):
        run = bench.run("""
title: bar on a wall
time: {end: 2e-4}
parts: {bar: {box: {size: [10, 1, 1], cells: [$cells, 1, 1]}, at: [0.01, 0, 0], material: steel}}
materials: {steel: {model: elastic, density: 0.73e-3, youngs_modulus: 3e7, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0}}
initial: [{part: bar, velocity: [-202.2, 0, 0]}]
walls: [{normal: [1, 0, 0]}]
output: {history: {elements: [{name: middle, near: [5, 0.5, 0.5]}]}}
""", cells=cells)
        h = run.history
        sizes.append(10 / cells)
        rebound.append(1 + h.last("momentum_x") / h.first("momentum_x"))
        curves.append((cells, h))
    first, last = find_contact(h, "wall_force_x")
    bench.near("impact", first, 4.9456e-5, absolute=1.1 * run.summary["dt"]["max"], unit="s")
    bench.near("separation", last, 1.48114e-4, relative=0.01, unit="s")
    bench.near("mean force of the wall", h.mean(5.5e-5, 1.4e-4, "wall_force_x"), 29923, relative=1e-3, unit="lbf")
    bench.near("stress in the middle", h.mean(8.5e-5, 1.1e-4, "middle_stress_xx"), -29923, relative=1e-3, unit="psi")
    bench.near("rebound over impact speed", -h.last("momentum_x") / h.first("momentum_x"), 1, relative=0.01)
    bench.below("energy balance, largest error", h.largest("energy_error"), 1e-3)
    order = observed_order(sizes, rebound)
    bench.above("observed order of the lost speed in h", order, 0.6)
    bench.table(["elements", "lost share of the speed"],
                [[f"{10 / s:.0f}", f"{r:.2e}"] for s, r in zip(sizes, rebound)])

    def draw(axes):
        axes.plot([0, 49.456, 49.456, 148.114, 148.114, 200], [0, 0, 29.923, 29.923, 0, 0], label="exact",
                  **plots.EXACT)
        for cells, table in curves[1::2]:
            axes.plot(*thin(1e6 * table["time"], 1e-3 * table["wall_force_x"], 300), label=f"{cells} elements")
        axes.set(xlabel="time [us]", ylabel="force of the wall [1000 lbf]")
        axes.legend()

    bench.figure("Force of the wall on the bar.", draw)


TWO_BARS = """
title: two bars
time: {end: $end}
parts:
  left: {box: {size: [$left, 0.01, 0.01], cells: [$left_cells, 1, 1]}, at: [-$left, 0, 0], material: a}
  right: {box: {size: [$right, 0.01, 0.01], cells: [$right_cells, 1, 1]}, material: b}
materials:
  a: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}
  b: {model: elastic, density: $density, youngs_modulus: $young, poissons_ratio: 0}
elements: {bulk_viscosity: {linear: 0.02}}
initial: [{part: left, velocity: [$v1, 0, 0]}, {part: right, velocity: [$v2, 0, 0]}]
contact: {surfaces: all$enforcement}
output:
  history:
    nodes: [{name: left, near: [0, 0, 0], part: left}, {name: right, near: [0, 0, 0], part: right}]
    elements: [{name: stress, near: [$station, 0, 0]}]
"""


def strike(bench, enforcement, left, right, cells, speeds, end, young=YOUNG, density=DENSITY):
    return bench.run(TWO_BARS, enforcement=enforcement, left=left, right=right, left_cells=cells[0],
                     right_cells=cells[1], v1=speeds[0], v2=speeds[1], end=end, young=young, density=density,
                     station=0.25 * right)


@case("two_bars", "impact", "Two bars: equal, of different impedance, of different length", quick=True)
def two_bars(bench):
    """Bars in contact at the start, the left one faster. *Equal* (0.5 m, 200 elements, 8 and -2 m/s): the interface moves
    at (v1 + v2) / 2 under rho c (v1 - v2) / 2, and after 2 L / c the bars separate with exchanged speeds. *Steel on
    aluminium* (10 m/s on a bar at rest): with Z = rho c A the interface moves at Z1 v / (Z1 + Z2) under the force Z1 Z2
    v / (Z1 + Z2). *Short on long* (0.2 and 0.6 m): the short bar stops after its 2 L / c, and a pulse of the same
    length travels in the long one. Tolerances are 1 % of the difference for speeds and 0.2 % for stresses: nodes that
    meet lose their energy (order h), and fronts are some elements wide. Linear viscosity is 0.02; 0.06 would round the
    fronts enough to lose 1 % of the speed."""
    for name, text in choices.list_enforcements(bench).items():
        transit = 0.5 / SPEED
        run = strike(bench, text, 0.5, 0.5, (200, 200), (8, -2), 4.3 * transit)
        h, stress = run.history, DENSITY * SPEED * 5
        t0, t1 = 0.2 * transit, 1.8 * transit
        bench.near(f"{name}, equal: speed of the interface, left", h.mean(t0, t1, "left_vx"), 3, absolute=0.05,
                   unit="m/s")
        bench.near(f"{name}, equal: speed of the interface, right", h.mean(t0, t1, "right_vx"), 3, absolute=0.05,
                   unit="m/s")
        bench.near(f"{name}, equal: stress", h.mean(0.5 * transit, 1.5 * transit, "stress_stress_xx"), -stress,
                   relative=2e-3, unit="Pa")
        bench.near(f"{name}, equal: end of contact", float(h["time"][h["contacts"] > 0][-1]), 2 * transit,
                   relative=0.02, unit="s")
        bench.near(f"{name}, equal: left speed after it", h.mean(2.2 * transit, 4.2 * transit, "left_vx"), -2,
                   absolute=0.1, unit="m/s")
        bench.near(f"{name}, equal: right speed after it", h.mean(2.2 * transit, 4.2 * transit, "right_vx"), 8,
                   absolute=0.1, unit="m/s")
        bench.closed(run, 1e-3, f"{name}, equal")
        equal = h

        young, density = 70e9, 2700
        z1, z2 = DENSITY * SPEED * AREA, np.sqrt(young * density) * AREA
        run = strike(bench, text, 0.5, 0.5, (100, 100), (10, 0), 1.6 * transit, young, density)
        h = run.history
        speed, force = z1 * 10 / (z1 + z2), z1 * z2 * 10 / (z1 + z2)
        bench.near(f"{name}, impedance: speed of the interface", h.mean(t0, 1.6 * transit, "left_vx"), speed,
                   absolute=0.05, unit="m/s")
        bench.near(f"{name}, impedance: force", -AREA * h.mean(0.6 * transit, 1.6 * transit, "stress_stress_xx"), force,
                   relative=2e-3, unit="N")
        bench.closed(run, 1e-3, f"{name}, impedance")

        transit = 0.2 / SPEED
        run = strike(bench, text, 0.2, 0.6, (80, 240), (10, 0), 2.9 * transit)
        h = run.history
        pulse = h.time_of_rise("stress_stress_xx", -0.5 * stress) - h.time_of_rise("stress_von_mises", 0.5 * stress)
        bench.near(f"{name}, length: duration of the pulse", pulse, 2 * transit, relative=0.01, unit="s")
        bench.near(f"{name}, length: speed of the short bar after it", h.mean(2.3 * transit, 2.9 * transit, "left_vx"),
                   0, absolute=0.1, unit="m/s")
        bench.closed(run, 1e-3, f"{name}, length")

    def draw(axes):
        t = equal["time"] * SPEED / 0.5
        axes.plot([0, 0, 2, 2, 4.3], [8, 3, 3, -2, -2], **plots.EXACT)
        axes.plot([0, 0, 2, 2, 4.3], [-2, 3, 3, 8, 8], label="exact (mean)", **plots.EXACT)
        axes.plot(*thin(t, equal["left_vx"], 350), label="left face")
        axes.plot(*thin(t, equal["right_vx"], 350), label="right face")
        axes.set(xlabel="time over L / c", ylabel="speed of the faces [m/s]", ylim=(-4, 10))
        axes.legend(loc="upper left", fontsize=7)

    bench.figure("Equal bars: the faces share one speed until the waves return.", draw)
