"""Cracks in glue that slide, and that open and slide at once."""
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

        bench.near(f"{name}: force at 1.1 mm over that of beams", mean(3e-3, force),
                   bend(3e-3) * 2 * stiff / (3 * crack**3 + length**3), relative=0.05, unit="N")
        for start in (7e-3, 7.5e-3):
            pushed = mean(start, force)
            reached = np.cbrt((bend(start) * 2 * stiff / pushed - length**3) / 3)
            bench.near(f"{name}, {1e3 * start + 0.25:g} ms: energy of the crack at {1e3 * reached:.0f} mm",
                       9 * pushed**2 * reached**2 / (4 * stiff * width), 700.0, relative=0.05, unit="J/m2")
        first, last = (np.searchsorted(h["time"], t) for t in (7e-3, 8.9e-3))
        spent = (h["glue_dissipated"][last] - h["glue_dissipated"][first]) / (h["glue_failed"][last]
                                                                              - h["glue_failed"][first])
        bench.near(f"{name}: energy dissipated by the area that fails", float(spent), 700.0, relative=0.03, unit="J/m2")


BENDING = """
title: Mixed-mode bending
units: mm, t, s
time: {end: $end}
parts:
  low: {box: {size: [102, 1, 1.56], cells: [$cells, 1, 2]}, at: [0, 0, -1.56], material: ply}
  high: {box: {size: [102, 1, 1.56], cells: [$cells, 1, 2]}, material: ply}
  lever: {line: {from: [0, 0.5, 10], to: [51, 0.5, 10], cells: 1}, section: {rectangle: {size: [5, 20]}}, toward: y, material: light}
  arm: {line: {from: [51, 0.5, 10], to: [$there, 0.5, 10], cells: 1}, section: {rectangle: {size: [5, 20]}}, toward: y, material: light}
join: [{parts: [lever, arm]}]
materials:
  ply: {model: orthotropic, density: 1.6e-9, moduli: [122.7e3, 10.1e3, 10.1e3], poissons_ratios: [0.25, 0.45, 0.25], shear_moduli: [5.5e3, 3.7e3, 5.5e3]}
  light: {model: elastic, density: 1e-11, youngs_modulus: 200e3, poissons_ratio: 0.3}
contact:
  surfaces: none
  ties: [{a: {name: high/z_min, inside: [[$glued, -1, -1], [999, 9, 9]]}, b: low/z_max, cohesive: {normal_stiffness: 1e5, shear_stiffness: 1e5, normal_strength: 40, shear_strength: 60, normal_energy: 0.969, shear_energy: 1.719, exponent: 2.284}}]
constraints:
  pull: {equal: [z], nodes: {inside: [[-0.01, -1, 1.5], [0.01, 2, 11]]}}
  push: {equal: [z], nodes: {inside: [[50.99, -1, 1.5], [51.01, 2, 11]]}}
damping: [{coefficient: 200}]
conditions:
  - {nodes: {name: low, inside: [[-0.01, -1, -1.57], [0.01, 2, -1.55]]}, fixed: [z]}
  - {nodes: {name: low, inside: [[101.99, -1, -1.57], [102.01, 2, -1.55]]}, fixed: [x, z]}
  - {nodes: low/y_min, fixed: [y]}
  - {nodes: high/y_min, fixed: [y]}
  - {nodes: lever, fixed: [y, rx, rz]}
  - {nodes: arm, fixed: [y, rx, rz]}
  - {nodes: arm/end, fixed: [x]}
  - {nodes: arm/end, velocity: {z: {table: [[0, 0], [1e-3, $speed], [1, $speed]]}}}
output: {history: {every: 1e-5, forces: [{name: f, support: arm/end}]}}
"""


def find_bending_force(lever, crack):
    """Force by 1 mm of width at which the crack grows, by beams that are longer by what the tip gives way (ASTM D6671, Reeder and Crews 1990)."""
    e1, e2, g, half, height = 122.7e3, 10.1e3, 5.5e3, 51.0, 1.56
    ratio = 1.18 * np.sqrt(e1 * e2) / g
    more = height * np.sqrt(e1 / (11 * g) * (3 - 2 * (ratio / (1 + ratio))**2))
    opening = 12 * ((3 * lever - half) / (4 * half) * (crack + more))**2 / (height**3 * e1)
    slide = 9 / 16 * ((lever + half) / half * (crack + 0.42 * more))**2 / (height**3 * e1)
    share = slide / (opening + slide)
    energy = 0.969 + (1.719 - 0.969) * share**2.284
    return np.sqrt(energy / (opening + slide)), share, energy


@case("mixed_bending", "failure", "Glue: mixed-mode bending")
def mixed_bending(bench):
    """The test of mixed-mode bending on AS4/PEEK (102 x 3.12 mm, E1 = 122.7 GPa, G_Ic = 0.969 and G_IIc = 1.719 N/mm, exponent 2.284): a
    lever pulls up one end of the upper half and pushes down its middle, so that the crack opens and slides at once, half of each. The
    largest force is compared with that of corrected beam theory at which
    the crack grows (Reeder and Crews, AIAA J. 28, 1990; ASTM D6671). Within 5 %. The lever is a beam whose
    nodes have the height of the nodes below it (`constraints`)."""
    rows = []
    for lever, crack, end, speed in ((44.4, 34.1, 7e-3, -1050.0),):
        exact, share, energy = find_bending_force(lever, crack)
        h = bench.run(BENDING, end=end, cells=102, there=51 + lever, glued=crack, speed=speed).history
        force = np.convolve(-h["fz:f"], np.full(40, 1 / 40), "valid")  # a mean of 0.4 ms, half a period of the beam
        name = f"{100 * share:.0f} % of sliding"
        bench.near(f"{name}: largest force by 25.4 mm", 25.4 * float(force.max()), 25.4 * exact,
                   relative=0.05, unit="N")
        rows.append([name, f"{25.4 * force.max():.1f}", f"{25.4 * exact:.1f}", f"{energy:.3f}"])
    bench.table(["mix", "largest force [N]", "beam theory [N]", "energy of the mix [N/mm]"], rows)


SHELLS = """
title: Shells that are glued are drawn apart
time: {end: 8e-3}
parts:
  low: {$low, material: m}
  high: {shell_plate: {size: [0.04, 0.002], cells: [$cells, 1]}, thickness: 0.001, at: [0, 0, 0.0005], material: m}
materials: {m: {model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}}
contact:
  surfaces: none
  ties: [{a: {name: $a, inside: [[0.0149, -1, -1], [1, 1, 1]]}, b: $b, cohesive: {normal_stiffness: 1e12, normal_strength: 5e6, shear_strength: $shear_strength, normal_energy: 100, shear_energy: $shear_energy}}]
damping: [{coefficient: 1e3}]
conditions:
  - {nodes: high/x_min, velocity: {z: {table: [[0, 0], [1e-3, 0.25], [8e-3, 0.25]]}}}
$held
output: {history: {every: 1e-5, forces: [{name: pull, support: high/x_min}]}}
"""


@case("glued_shells", "failure", "Glue: shells that peel")
def glued_shells(bench):
    """Strips of shells of 1 mm, 40 mm long, are glued but for the first 15 mm. Two are drawn apart as a double cantilever beam: their
    surfaces open and do not slide, so that glue with 3.5 times the energy in shear takes its energy in tension. One is peeled from
    a rigid block: it slides as it bends, so that both energies are equal there. By beam theory P^2 D is the same for every length of the crack, and
    gives its energy by area: with the stiffness S = E b h^3 / 12, P^2 D = 2 (G b S)^1.5 / (3 S) for two arms and (2 G b S)^1.5 / (3 S) for one. Means over 2 ms."""
    width, energy = 2e-3, 100.0
    stiff = 70e9 * width * 1e-9 / 12
    two = "shell_plate: {size: [0.04, 0.002], cells: [$cells, 1]}, thickness: 0.001, at: [0, 0, -0.0005]"
    block = ("box: {size: [0.04, 0.002, 0.004], cells: [$cells, 1, 2]}, at: [0, 0, -0.004], rigid: {fixed: [x, y, z, "
             "rx, ry, rz]}")
    pulled = "  - {nodes: low/x_min, velocity: {z: {table: [[0, 0], [1e-3, -0.25], [8e-3, -0.25]]}}}"
    for name, cells, low, sides, shear, held in (
            ("double cantilever, 1 mm", 40, two, ("high/bottom", "low/top"), (20e6, 350), pulled),
            ("double cantilever, 0.5 mm, sides exchanged", 80, two, ("low/top", "high/bottom"), (20e6, 350), pulled),
            ("peeled from a block", 40, block, ("high/bottom", "low/z_max"), (8e6, 100), ""),
            ("peeled from a block, sides exchanged", 40, block, ("low/z_max", "high/bottom"), (8e6, 100), "")):
        h = bench.run(SHELLS, cells=cells, low=low.replace("$cells", str(cells)), a=sides[0], b=sides[1],
                      shear_strength=shear[0], shear_energy=shear[1], held=held).history
        opening = 0.5 if low is two else 0.25
        of_energy = (2 / (3 * stiff) * (energy * width * stiff)**1.5 if low is two
                     else (2 * energy * width * stiff)**1.5 / (3 * stiff))
        for start in (4e-3, 6e-3):
            force = h.mean(start, start + 2e-3, "fz:pull")
            reached = (force**2 * opening * (start + 1e-3 - 5e-4) / of_energy)**(2 / 3)
            bench.near(f"{name}, {1e3 * start + 1:g} ms: energy of the crack", energy * reached, energy, relative=0.06,
                       unit="J/m2")
