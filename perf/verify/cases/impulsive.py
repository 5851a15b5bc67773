"""Plates and beams of shells struck by an impulse."""
import numpy as np

import meshes
import plots
from bench import case


BEAM = """
title: A clamped beam under an impulse
time: {end: $end}
parts: {beam: {shell_plate: {size: [0.1, 0.002], cells: [40, 1]}, thickness: 0.005, points: 9, material: alloy}}
materials: {alloy: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.3, yield_stress: 280e6}}
conditions:
  - {nodes: beam/x_min, symmetry: x}
  - {nodes: beam/x_max, fixed: [x, y, z, rx, ry, rz]}
  - {nodes: all, fixed: [rx, rz]}
initial: [{nodes: {name: beam, inside: [[-1, -1, -1], [0.0999, 1, 1]]}, velocity: [0, 0, $speed]}]
output: {history: {every: $every, nodes: [{name: middle, near: [0, 0, 0]}]}}
"""


@case("clamped_beam", "shells", "Clamped beams struck by an impulse")
def clamped_beam(bench):
    """Clamped beams of aluminium, 200 mm long and 5 mm thick, start with one speed all along, as under the explosive
    sheets of Menkes and Opat (*Exp. Mech.* 13, 1973). Jones (*Structural Impact*, section 7.2) gives the final
    deflection of rigid, perfectly plastic beams with the force of the axis: W / H = ((1 + 3/4 L)^(1/2) - 1) / 2, L =
    4 rho V^2 l^2 / (s H^2), l half the length, for a square around the yield curve of moment and axial force, and
    with 0.618 s for the square within it. The exact curve lies between the two.

    The formula has hinges that stay. At small L it gives 3/16 L, while hinges that travel give 1/6 L, the exact
    answer: 8/9 of it. The deflection must lie between 8/9 of the first and the second. It is the middle of the
    elastic vibration that remains. Beyond some 6 thicknesses the formula ends: the beam then stretches by more than 5
    %, and without hardening it necks."""
    rows = []
    for speed in (40.0, 70.0, 100.0):
        number = 4 * 2700 * speed**2 * 0.1**2 / (280e6 * 0.005**2)
        low, high = (((1 + 0.75 * number / share)**0.5 - 1) / 2 for share in (1, 0.618))
        h = bench.run(BEAM, end=4e-3, every=4e-6, speed=speed).history
        late = h["middle_z"][h["time"] > 1.5e-3] / 0.005
        rows.append((speed, number, 0.5 * (late.max() + late.min()), low, high, float(h["middle_z"].max()) / 0.005))
        bench.above(f"{speed:g} m/s: final deflection over the thickness", rows[-1][2], 8 / 9 * low)
        bench.below(f"{speed:g} m/s: final deflection over the thickness", rows[-1][2], high)
        bench.below(f"{speed:g} m/s: energy balance, largest error", h.largest("energy_error"), 1e-3)
    bench.table(["speed [m/s]", "L", "final deflection over thickness", "circumscribed", "inscribed", "largest"],
                [[f"{x:.4g}" for x in row] for row in rows])

    def draw(axes):
        number = np.linspace(0, 1.1 * rows[-1][1], 200)
        for share, factor in ((1, 8 / 9), (0.618, 1)):
            axes.plot(number, factor * ((1 + 0.75 * number / share)**0.5 - 1) / 2, **plots.EXACT)
        axes.plot([r[1] for r in rows], [r[2] for r in rows], "o")
        axes.set(xlabel="4 rho V^2 l^2 / (s H^2)", ylabel="final deflection over thickness")

    bench.figure("Final deflection; dashed: 8/9 of the first formula, and the second.", draw)


PLATE = """
title: A clamped plate under an impulse
time: {end: 6e-4}
parts: {plate: {exodus: {file: $mesh}, thickness: 0.0016, points: 5, material: steel}}
materials: {steel: {model: power_law_plasticity, density: 7850, youngs_modulus: 207e9, poissons_ratio: 0.3, yield_stress: 296e6, hardening_coefficient: 0, hardening_exponent: 1, cowper_symonds_rate: 40.4, cowper_symonds_exponent: 5}}
conditions:
  - {nodes: {name: plate, inside: [[-1e-6, -1, -1], [1e-6, 1, 1]]}, symmetry: x}
  - {nodes: {name: plate, inside: [[-1, -1e-6, -1], [1, 1e-6, 1]]}, symmetry: y}
$rim
initial:
  - {part: plate, velocity: [0, 0, $speed]}
$still
output: {history: {every: 1e-6, nodes: [{name: middle, near: [0, 0, 0]}]}}
"""


@case("impulsive_plate", "shells", "Round plates struck by an impulse")
def impulsive_plate(bench):
    """Clamped round plates of mild steel, 100 mm across and 1.6 mm thick, take a uniform impulse. Nurick and Martin
    (*Int. J. Impact Engng* 8, 1989) put a line through 109 tests: deflection over thickness = 0.425 f + 0.277, f = I
    / (pi R t^2 sqrt(rho s)), with 90 % of the tests within one thickness of it; s is the static yield stress, 296 MPa
    here. The law is that of Cowper and Symonds with 40.4 / s and 5, without hardening. The tolerance is the scatter
    of the tests, one thickness."""
    radius, thickness, density, strength, rows = 0.05, 0.0016, 7850, 296e6, []
    points, corners = meshes.quarter_cylinder(bench, radius, 0.01, 32, 1)
    used, numbers = np.unique(corners[:, :4], return_inverse=True)
    path = meshes.write_exodus(bench.file("plate.exo"), points[used], numbers.reshape(-1, 4))
    edge = [n for n in used if np.hypot(points[n, 0], points[n, 1]) > radius * (1 - 1e-9)]
    rim = meshes.each_node(points[edge], lambda _: "fixed: [x, y, z, rx, ry, rz]")
    still = meshes.each_node(points[edge], lambda _: "velocity: [0, 0, 0]")
    for share in (5.0, 10.0, 15.0):
        impulse = share * np.pi * radius * thickness**2 * np.sqrt(density * strength)
        speed = float(impulse / (np.pi * radius**2 * thickness * density))
        h = bench.run(PLATE, mesh=path, rim=rim, still=still, speed=speed).history
        late = h["middle_z"][h["time"] > 2e-4] / thickness
        final, line = float(0.5 * (late.max() + late.min())), 0.425 * share + 0.277
        rows.append((share, speed, final, line))
        bench.near(f"f = {share:g}: deflection over thickness", final, line, absolute=1.0)
        bench.below(f"f = {share:g}: energy balance, largest error", h.largest("energy_error"), 1e-3)
    bench.table(["f", "speed [m/s]", "deflection over thickness", "line of the tests"],
                [[f"{x:.4g}" for x in row] for row in rows])

    def draw(axes):
        f = np.linspace(0, 18, 50)
        axes.plot(f, 0.425 * f + 0.277, label="Nurick and Martin", **plots.EXACT)
        axes.fill_between(f, 0.425 * f - 0.723, 0.425 * f + 1.277, color="0.9")
        axes.plot([r[0] for r in rows], [r[2] for r in rows], "o", label="percuss")
        axes.set(xlabel="impulse over pi R t^2 sqrt(rho s)", ylabel="deflection over thickness")
        axes.legend()

    bench.figure("Deflection of the middle; grey: 90 % of the tests.", draw)
