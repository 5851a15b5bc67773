"""Tied bodies: a wave goes through a tie as through one bar."""
import numpy as np

import plots
from bench import case, thin

YOUNG, DENSITY = 200e9, 7850
STRESS = np.sqrt(YOUNG * DENSITY)  # rho c v at 1 m/s

PUSHED = """
title: A bar of two parts whose end is pushed
time: {end: 1.9e-4, max_step: 5e-7}
parts:
$parts
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
$contact
conditions: [{nodes: $end, velocity: {x: 1}}]
output: {history: {elements: [{name: a, near: [0.255, 0.015, 0.015]}, {name: b, near: [0.755, 0.015, 0.015]}]}}
"""
WHOLE = "  bar: {box: {size: [1, 0.02, 0.02], cells: [100, 2, 2]}, material: steel}"
HALVES = """  left: {box: {size: [0.5, 0.02, 0.02], cells: [50, 2, 2]}, material: steel}
  right: {box: {size: [0.5, 0.02, 0.02], cells: [50, %d, %d]}, at: [0.5, 0, 0], material: steel}"""
TIE = "contact: {ties: [{a: right/x_min, b: left/x_max}], enforcement: %s}"


@case("tied_bars", "waves", "Ties: a wave through tied meshes", quick=True)
def tied_bars(bench):
    """A bar of 1 m is driven at 1 m/s, its halves tied end to end. Nothing may be reflected by the tie (d'Alembert: the
    section does not change) and the front must continue as in one bar. Matching meshes are one bar to round-off. With 2
    x 2 elements on 3 x 3 the tie has a local field of its own, and the finer half has another lateral inertia: 2 % of
    the stress. The tie does no work."""
    whole = bench.run(PUSHED, parts=WHOLE, contact="", end="bar/x_min").history
    drawn = [("one bar", whole)]
    for enforcement in ("kinematic", "lagrange"):
        for cells, limit in ((2, 1e-10), (3, 0.02)):
            run = bench.run(PUSHED, parts=HALVES % (cells, cells), contact=TIE % enforcement, end="left/x_min")
            h, name = run.history, f"{enforcement}, 2 x 2 on {cells} x {cells}"
            for station, what in (("a", "comes back"), ("b", "goes on otherwise")):
                off = np.abs(h[f"{station}_stress_xx"] - whole[f"{station}_stress_xx"]).max() / STRESS
                bench.below(f"{name}: stress that {what}, over rho c v", off, limit)
            bench.below(f"{name}: work of the tie over that of the push",
                        np.abs(h["contact"]).max() / h["external"][-1], 1e-9)
            if cells == 3:
                drawn.append((name, h))

    def draw(axes):
        for name, h in drawn:
            axes.plot(*thin(1e6 * h["time"], -1e-6 * h["b_stress_xx"], 300), label=f"{name}, beyond the tie",
                      **(plots.EXACT if name == "one bar" else {}))
        axes.set(xlabel="time [us]", ylabel="pressure along [MPa]")
        axes.legend(fontsize=7)

    bench.figure("The front beyond the tie; dashed: in one bar.", draw)
