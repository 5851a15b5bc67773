"""Energy of cracks: elements whose damage evolves, and glue."""
import numpy as np

import plots
from bench import case

YOUNG, YIELD, ENERGY = 200e3, 300.0, 30.0  # MPa, MPa, N/mm

ELEMENT = """
title: An element softens
units: mm, t, s
time: {end: $end}
parts: {e: {$shape, material: m}}
materials: {m: {model: j2_plasticity, density: 7.85e-9, youngs_modulus: 200e3, poissons_ratio: 0.3, yield_stress: 300, failure: {plastic_strain: 0.01, evolution: {$evolution}}}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
conditions:
  - {nodes: e/x_min, fixed: [x]}
  - {nodes: e/x_max, velocity: {x: {table: [[0, 0], [2e-5, $speed], [5e-3, $speed]]}}}
$held
output: {history: {every: 2e-6, elements: [{name: e, id: 1}]}}
"""


@case("softening", "failure", "An element softens: the energy of the crack", quick=True)
def softening(bench):
    """A cube, or a shell of 0.5 mm, of steel without hardening is drawn along x with free sides. From a plastic strain of 0.01
    on its damage evolves, and it is eroded. It then has taken s^2 / (2 E) + 0.01 s by volume and G by area, whatever its
    size. By a displacement u of 0.2 mm, G is s u / 2, and at half of u the stress is half of s."""
    rows, curve = [], None
    for what, evolution, size in [*(("cube", "energy: 30", s) for s in (1, 2, 4)), ("cube", "displacement: 0.2", 2),
                                  ("shell", "energy: 30", 2)]:
        thick = size if what == "cube" else 0.5
        shape = (f"box: {{size: [{size}, {size}, {size}], cells: [1, 1, 1]}}" if what == "cube"
                 else f"shell_plate: {{size: [{size}, {size}], cells: [1, 1]}}, thickness: 0.5")
        held = "" if what == "cube" else "  - {nodes: all, fixed: [z, rx, ry, rz]}"
        h = bench.run(ELEMENT, end=4e-3 if "energy" in evolution else 1e-3, shape=shape, evolution=evolution,
                      speed=200 * size, held=held).history
        taken = h.last("internal") + h.last("eroded_energy")
        before = size * size * thick * (0.5 * YIELD**2 / YOUNG + 0.01 * YIELD)
        exact = ENERGY if "energy" in evolution else 0.5 * YIELD * 0.2
        name = f"{what} of {size} mm, {evolution.partition(':')[0]}"
        bench.near(f"{name}: energy after the onset, by area", (taken - before) / (size * thick), exact, relative=5e-3,
                   unit="N/mm")
        rows.append([name, f"{taken:.3f}", f"{before:.3f}"])
        if "displacement" in evolution:
            curve = h
    opening = (np.asarray(curve["e_eps"]) - 0.01) * 2
    half = int(np.flatnonzero(opening >= 0.1)[0])
    bench.near("displacement: stress at half of it", float(curve["e_von_mises"][half]),
               YIELD * (1 - float(opening[half]) / 0.2), relative=5e-3, unit="MPa")
    bench.table(["element", "energy taken [mJ]", "of that until the onset"], rows)

    def draw(axes):
        keep = np.asarray(curve["eroded_elements"]) < 1
        axes.plot(opening[keep], np.asarray(curve["e_von_mises"])[keep])
        axes.plot([0, 0.2], [YIELD, 0], **plots.EXACT)
        axes.set(xlabel="plastic displacement after the onset [mm]", ylabel="von Mises stress [MPa]")

    bench.figure("Stress over the displacement, and the line of the deck (dashed).", draw)


BEAM = """
title: A double cantilever beam
time: {end: 6e-3}
parts:
  low: {box: {size: [0.05, 0.001, 0.002], cells: [$cells, 1, $through]}, at: [0, 0, -0.002], material: m}
  high: {box: {size: [0.05, 0.001, 0.002], cells: [$cells, 1, $through]}, material: m}
materials: {m: {model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}}
contact:
  surfaces: none
  ties: [{a: {name: high/z_min, inside: [[0.0199, -1, -1], [1, 1, 1]]}, b: low/z_max, cohesive: {normal_stiffness: 3e12, normal_strength: 20e6, shear_strength: 60e6, normal_energy: 200, shear_energy: 700}}]
damping: [{coefficient: 1e3}]
conditions:
  - {nodes: high/x_min, velocity: {z: {table: [[0, 0], [5e-4, 0.15], [6e-3, 0.15]]}}}
  - {nodes: low/x_min, velocity: {z: {table: [[0, 0], [5e-4, -0.15], [6e-3, -0.15]]}}}
output: {history: {every: 5e-6, forces: [{name: pull, support: high/x_min}]}}
"""


@case("glued_beams", "failure", "Glue: a double cantilever beam")
def glued_beams(bench):
    """Two beams of 2 mm, glued but for the first 20 mm, are drawn apart at their ends. The force before the crack grows is that
    of beams on an elastic foundation (Kanninen, Int. J. Fracture 9, 1973). Then P^2 D is the same for every length of the
    crack, by beam theory: it gives the energy that the crack takes, by area. Means over 1 ms, at three lengths."""
    young, width, height, stiffness, crack, energy = 70e9, 1e-3, 2e-3, 3e12, 20e-3, 200.0
    stiff = young * width * height**3
    la = (6 * stiffness / (young * height**3)) ** 0.25 * crack
    compliance = 8 * crack**3 / stiff * (1 + 3 / la + 3 / la**2 + 1.5 / la**3)
    of_energy = 8 * width**3 / stiff * (energy * young * height**3 / 12) ** 1.5
    for cells, through in ((50, 2), (100, 4)):
        h = bench.run(BEAM, cells=cells, through=through).history
        name = f"{1e3 * 0.05 / cells:g} mm"
        bench.near(f"{name}: force before the crack grows", h.mean(0.8e-3, 1.1e-3, "fz:pull"),
                   0.3 * (0.95e-3 - 2.5e-4) / compliance, relative=0.05, unit="N")
        for start in (3e-3, 4e-3, 5e-3):
            force = h.mean(start, start + 1e-3, "fz:pull")
            reached = (force**2 * 0.3 * (start + 0.5e-3 - 2.5e-4) / of_energy) ** (2 / 3)
            bench.near(f"{name}, {1e3 * start + 0.5:g} ms: energy of the crack", energy * reached, energy,
                       relative=0.05, unit="J/m2")
        bench.above(f"{name}: glue that has failed", 1e6 * h.last("glue_failed"), 8.0, "mm2")
