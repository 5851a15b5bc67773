"""Torsion of beams, rigid bodies of few elements, a spot weld between solids, rates in tables and rubber drawn far."""
import math

import numpy as np
from scipy import integrate, optimize, special

from bench import case

STEEL = "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
SHEAR = 200e9 / 2.6
TORSION_SPEED = math.sqrt(SHEAR / 7850)


def find_frequency(history, column, start):
    """Mean frequency of a column between its rises through zero after a time."""
    t, y = history["time"], history[column]
    rises = np.flatnonzero((t[:-1] >= start) & (y[:-1] < 0) & (y[1:] >= 0))
    times = t[rises] - (t[rises + 1] - t[rises]) * y[rises] / (y[rises + 1] - y[rises])
    return (len(times) - 1) / (times[-1] - times[0])


@case("shaft_torsion", "bending", "Shafts of beams in torsion", quick=True)
def shaft_torsion(bench):
    """A steel shaft of length 1 m along x is clamped at one end; a pulse of torque sets its free end swinging. The
    frequency is sqrt(G J / (rho I_p)) / (4 L), 782.6 Hz for every round section, whatever the number of elements. A flat
    section with given constants has the share sqrt(J / I_p) of it. A shaft that spins at 100 rad/s is stopped at one
    end: the torque there is rho c J w, with the speed of torsion c, until the wave is back. Within 1 %."""
    exact = TORSION_SPEED / 4
    rows = []
    flat = ("{general: {area: 4e-4, inertia_y: 4e-9, inertia_z: 38.5e-9, torsion: 10e-9, shear_area_y: 3.3e-4, "
            "shear_area_z: 3.3e-4}}")
    sections = [("round", "{round: {radius: 0.01}}", exact, (5, 10, 20, 40)),
                ("tube", "{tube: {outer_radius: 0.02, inner_radius: 0.018}}", exact, (20,)),
                ("flat", flat, exact * math.sqrt(0.1 / 0.425), (20,))]
    for name, section, frequency, meshes in sections:
        for cells in meshes:
            period = 1 / frequency
            run = bench.run("""
time: {end: $end}
parts: {shaft: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: $cells}, section: $section, toward: y, material: steel}}
conditions: [{nodes: shaft/start, fixed: [x, y, z, rx, ry, rz]}]
loads: {nodal: [{nodes: shaft/end, moment: {x: {expression: "t < $period ? 10 * sin(pi * t / $period)^2 : 0"}}}]}
output: {history: {every: $every}}
""" + STEEL, end=8 * period, cells=cells, section=section, period=period, every=period / 200)
            found = find_frequency(run.history, "angular_x", period)
            rows.append([name, cells, f"{found:.2f}", f"{frequency:.2f}", f"{100 * (found / frequency - 1):+.3f} %"])
            bench.near(f"{name}, {cells} elements: frequency", found, frequency, relative=0.01, unit="Hz")
    bench.table(["section", "elements", "frequency [Hz]", "exact", "difference"], rows)
    spin, j, there = 100, math.pi / 2 * 0.01**4, 1 / TORSION_SPEED
    run = bench.run("""
time: {end: $end}
parts: {shaft: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 200}, section: {round: {radius: 0.01}}, toward: y, material: steel}}
initial: [{part: shaft, angular_velocity: [$spin, 0, 0]}]
conditions: [{nodes: shaft/start, fixed: [x, y, z, rx, ry, rz]}]
output: {history: {every: $every, forces: [{name: clamp, support: shaft/start}]}}
""" + STEEL, end=1.8 * there, spin=spin, every=there / 400)
    bench.near("torque of the shaft that is stopped", -run.history.mean(0.2 * there, 1.6 * there, "mx:clamp"),
               7850 * TORSION_SPEED * j * spin, relative=0.01, unit="N m")


def find_turn_over(inertia, spin):
    """When the middle axis of a body without moments first stands across its direction at the start, by Euler's equations."""
    def rates(_, s):
        w, axis = s[:3], s[3:]
        return np.concatenate([-np.cross(w, inertia * w) / inertia, np.cross(axis, w)])

    def height(_, s):
        return s[4]

    height.terminal, height.direction = True, -1
    found = integrate.solve_ivp(rates, (0, 100), [*spin, 0, 1, 0], rtol=1e-10, atol=1e-12, events=height)
    return found.t_events[0][0]


def measure_top(bench, material):
    """The rate of precession of a heavy top, in axes of the top: gravity leans."""
    mass, arm, g, tilt, spin = 1000 * 0.2 * 0.2 * 0.1, 0.25, 9.81, 0.5, 200
    along, across = mass * 0.08 / 12, mass * 0.05 / 12 + mass * arm**2
    a, b, c = across * math.cos(tilt), along * spin, mass * g * arm
    rate = (b - math.sqrt(b * b - 4 * a * c)) / (2 * a)
    up_x, up_z, own = math.sin(tilt), math.cos(tilt), spin - rate * math.cos(tilt)
    h = bench.run("""
time: {end: 1, max_step: 2e-4}
parts: {top: {box: {size: [0.2, 0.2, 0.1], cells: [1, 1, 1]}, at: [-0.1, -0.1, 0.2], material: m, rigid: true}}
joints: {foot: {kind: spherical, bodies: [top], at: [0, 0, 0]}}
loads: {gravity: [$gx, 0, $gz]}
initial: [{part: top, angular_velocity: [$wx, 0, $wz], center: [0, 0, 0]}]
output: {history: {every: 1e-2}}
""" + material, gx=-g * up_x, gz=-g * up_z, wx=rate * up_x, wz=own + rate * up_z).history
    x, y, z = (h[f"body_{axis}:top"] for axis in "xyz")
    angle = np.unwrap(np.arctan2(y, z * up_x - x * up_z))
    bench.near("rate of precession of the top", float((angle[0] - angle[-1]) / (h["time"][-1] - h["time"][0])), rate,
               relative=1e-3, unit="rad/s")
    bench.near("height of its middle, largest error over the arm",
               float(np.abs((x * up_x + z * up_z) / arm - math.cos(tilt)).max()), 0, absolute=1e-3)


@case("rigid_shapes", "rigid", "Rigid blocks of one element: inertia, top, pendulum, tumbling", quick=True)
def rigid_shapes(bench):
    """A rigid body has the mass and the inertia of the shapes of its elements, so that one element is enough. A cube of
    1000 kg and side 1 m has the moment of inertia m / 6 about its centre, of any elements. A top of 0.2 by 0.2 by 0.1 m, whose
    middle is 0.25 m above a fixed point, leans by 0.5 rad and spins at 200 rad/s: it precesses evenly at the rate W of
    across cos(tilt) W^2 - along spin W + m g arm = 0, with its moments about the point. A block of 0.4 by 0.1 by 0.2 m
    swings about a pin from 1 rad with the period 4 sqrt(I / (m g d)) K(sin(1/2)). A free block of 0.3 by 0.2 by 0.1 m
    that spins about its middle axis turns over when Euler's equations say. Within 0.1 %."""
    material = "materials: {m: {model: elastic, density: 1000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
    for kind in ("hexahedra", "tetrahedra", "wedges", "pyramids"):
        run = bench.run("""
time: {end: 1e-3, max_step: 1e-4}
parts: {b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: $kind, material: m, rigid: true}}
initial: [{part: b, angular_velocity: [0, 0, 1]}]
output: {history: {every: 1e-4}}
""" + material, kind=kind)
        bench.near(f"moment of inertia, {kind}", 2 * run.history.first("kinetic"), 1000 / 6, relative=1e-9,
                   unit="kg m2")
    measure_top(bench, material)
    angle, g, mass, arm = 1, 9.81, 1000 * 0.4 * 0.1 * 0.2, 0.2
    inertia = mass * (0.16 + 0.04) / 12 + mass * arm**2
    period = 4 * math.sqrt(inertia / (mass * g * arm)) * special.ellipk(math.sin(angle / 2)**2)
    run = bench.run("""
time: {end: $end, max_step: 5e-4}
parts: {block: {box: {size: [0.4, 0.1, 0.2], cells: [1, 1, 1]}, at: [0, -0.05, -0.1], material: m, rigid: true}}
joints: {pin: {kind: revolute, bodies: [block], at: [0, 0, 0], axis: y}}
loads: {gravity: [$gx, 0, $gz]}
output: {history: {every: 0}}
""" + material, end=3.1 * period, gx=g * math.cos(angle), gz=-g * math.sin(angle))
    side = run.history["body_x:block"] * math.sin(angle) + run.history["body_z:block"] * math.cos(angle)
    passes = np.flatnonzero((side[:-1] > 0) & (side[1:] <= 0))
    t = run.history["time"]
    times = t[passes] + (t[passes + 1] - t[passes]) * side[passes] / (side[passes] - side[passes + 1])
    bench.near("period of the pendulum", (times[2] - times[0]) / 2, period, relative=1e-3, unit="s")
    block = np.array([0.3, 0.2, 0.1])
    moments = 1000 * block.prod() * (np.sum(block**2) - block**2) / 12
    over = find_turn_over(moments, np.array([0.01, 10, 0.01]))
    run = bench.run("""
time: {end: $end, max_step: 2e-4}
parts: {block: {box: {size: [0.3, 0.2, 0.1], cells: [1, 1, 1]}, at: [-0.15, -0.1, -0.05], material: m, rigid: true}}
initial: [{part: block, angular_velocity: [0.01, 10, 0.01]}]
output: {history: {every: 0}}
""" + material, end=1.1 * over)
    along = 1 - 2 * (run.history["body_q1:block"]**2 + run.history["body_q3:block"]**2)
    i = int(np.flatnonzero((along[:-1] > 0) & (along[1:] <= 0))[0])
    t = run.history["time"]
    bench.near("time of the first turn over", t[i] + (t[i + 1] - t[i]) * along[i] / (along[i] - along[i + 1]), over,
               relative=1e-3, unit="s")


@case("solid_weld", "failure", "Spot weld between separate blocks", quick=True)
def solid_weld(bench):
    """Two blocks of 0.1 by 0.1 by 0.02 m lie 2 mm apart and have one weld in their middle. The upper one is moved along the
    gap, slowly. The weld carries the shear, and the moment of it, and fails at its strength of 3000 N. What is left of
    ringing in the support is within 5 %. Two strips of 4 mm, 1 mm apart and held in their planes, have two welds in the line of a
    load of 1000 N: by symmetry each carries half of it, within 2 %."""
    run = bench.run("""
time: {end: 0.02}
parts:
  low: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, at: [0, 0, 0.022], material: m}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 20e9, poissons_ratio: 0.3}}
welds:
  spot: {between: [{near: [0.05, 0.05, 0.02], part: low}, {near: [0.05, 0.05, 0.022], part: high}], failure: {normal: 5000, shear: 3000}}
conditions:
  - {nodes: low/z_min, fixed: [x, y, z]}
  - {nodes: high/z_max, velocity: {x: {table: [[0, 0], [0.004, 0.01], [0.02, 0.01]]}, y: 0, z: 0}}
output: {history: {every: 1e-5, forces: [{name: f, support: high/z_max}]}}
""")
    bench.near("largest shear of the weld", run.history.largest("weld_shear:spot"), 3000, relative=0.01, unit="N")
    bench.near("largest force of the support", run.history.largest("fx:f"), 3000, relative=0.05, unit="N")
    bench.equal("welds that have failed", int(run.history.last("welds_failed")), 1)
    bench.below("linear momentum, relative change", run.summary["momentum"]["linear_error"], 1e-11)
    bench.below("energy balance, error at the end", abs(run.summary["energy"]["error"]), 1e-3)
    h = bench.run("""
time: {end: 0.02}
parts:
  left: {box: {size: [0.2, 0.04, 0.004], cells: [20, 4, 2]}, material: m}
  right: {box: {size: [0.2, 0.04, 0.004], cells: [20, 4, 2]}, at: [0.12, 0, 0.005], material: m}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
welds:
  first: {between: [{near: [0.14, 0.02, 0.004], part: left}, {near: [0.14, 0.02, 0.005], part: right}]}
  second: {between: [{near: [0.18, 0.02, 0.004], part: left}, {near: [0.18, 0.02, 0.005], part: right}]}
conditions:
  - {nodes: left/x_min, fixed: [x, y, z]}
  - {nodes: right/x_max, fixed: [y, z]}
  - {nodes: left/z_min, fixed: [z]}
  - {nodes: right/z_max, fixed: [z]}
damping: [{nodes: all, coefficient: 4000}]
loads: {pressure: [{faces: right/x_max, value: {expression: "-6.25e6 * min(t / 0.005, 1)"}}]}
output: {history: {every: 1e-4, forces: [{name: f, support: left/x_min}]}}
""").history
    bench.near("lap joint: force of the support", -h.mean(0.015, 0.02, "fx:f"), 1000, relative=0.01, unit="N")
    for name in ("first", "second"):
        bench.near(f"lap joint: shear of the {name} weld", h.mean(0.015, 0.02, f"weld_shear:{name}"), 500,
                   relative=0.02, unit="N")


@case("lap_weld", "failure", "Spot weld in a lap joint, on three meshes")
def lap_weld(bench):
    """Two strips of 120 by 20 mm lap by 40 mm and have one weld of 12 mm diameter in the middle of the lap, given by its point
    and its radius. One end is clamped, a force acts across the other: the joint bends as one beam of the length of both,
    F L^3 / (3 E I) = 8 um. Elements have 10, 5 and 2.5 mm, shells of 4 mm and solids of 5 mm thickness. The
    weld carries the force, and the deflection is within 4 % of the beam's on every mesh."""
    rows = []
    for kind, thickness, gap in (("shells", 4.0, 0.0), ("solids", 5.0, 0.5)):
        force = 1e-3 * thickness**3
        apart = thickness + gap
        for size in (10.0, 5.0, 2.5):
            along, across = round(120 / size), round(20 / size)
            shells = kind == "shells"
            shape = (f"shell_plate: {{size: [120, 20], cells: [{along}, {across}]}}, thickness: {thickness}" if shells
                     else
                     f"box: {{size: [120, 20, {thickness}], cells: [{along}, {across}, 2]}}")
            nodes = (across + 1) * (1 if shells else 3)
            run = bench.run("""
time: {end: 1e-7}
parts:
  a: {$shape, material: m}
  b: {$shape, at: [80, 0, $apart], material: m}
materials: {m: {model: elastic, density: 7.85e-9, youngs_modulus: 2e5, poissons_ratio: 0}}
welds: {spot: {between: [$faces], at: [100, 10, $middle], radius: 6}}
conditions: [{nodes: a/x_min, fixed: [$held]}]
loads: {nodal: [{nodes: b/x_max, force: {z: $share}}]}
start: {relaxation: {tolerance: 1e-8, max_steps: 400000}}
output: {history: {every: 0, nodes: [{name: tip, near: [200, 10, $apart], part: b}]}}
""", shape=shape, apart=apart, faces="a, b" if shells else "a/z_max, b/z_min", middle=apart / 2 if shells else thickness + gap / 2,
                            held="x, y, z, rx, ry, rz" if shells else "x, y, z", share=force / nodes)
            tip = run.history.first("tip_z") - apart
            rows.append([kind, size, f"{1e3 * tip:.4f}",
                         f"{100 * (tip / 0.008 - 1):+.2f} %", run.summary["relaxation"]["damped_steps"]])
            bench.near(f"{kind} of {size} mm: deflection", tip, 0.008, relative=0.04, unit="mm")
            bench.near(f"{kind} of {size} mm: normal force of the weld", run.history.last("weld_normal:spot"), force,
                       relative=1e-3, unit="N")
    bench.table(["elements", "size [mm]", "deflection [um]", "difference from the beam", "damped steps"], rows)


@case("rate_table", "plastic", "Strain rates: bars with a table of curves", quick=True)
def rate_table(bench):
    """A bar of one cell is pulled at a constant rate to a logarithmic strain of 0.06. Its yield stress is given at 0.1 / s
    (250 MPa, 320 MPa at a plastic strain of 0.1) and at 100 / s (350 and 448 MPa), linear or logarithmic in the rate
    between them and constant outside. The stress at the end is that of the table, at the plastic part of the rate, within
    0.1 %."""
    def find_stress(p, rate, logarithmic):
        slow, fast = 250e6 + 700e6 * p, 350e6 + 980e6 * p

        def share(r):
            return float(np.clip(math.log(r / 0.1) / math.log(1000) if logarithmic else (r - 0.1) / 99.9, 0, 1))

        slope = 700e6 + share(rate) * 280e6
        return slow + share(rate / (1 + slope / 210e9)) * (fast - slow)

    rows = []
    for kind, part in (("hexahedra", "box: {size: [1, 1, 1], cells: [1, 1, 1]}"),
                       ("shells", "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1")):
        for rate in (0.01, 1.0, 10.0, 1000.0):
            for law in ("linear", "logarithmic"):
                end = 0.06 / rate
                run = bench.run("""
time: {end: $end}
parts: {bar: {$part, material: steel}}
materials: {steel: {model: rate_table_plasticity, density: $density, youngs_modulus: 210e9, poissons_ratio: 0.3, rate_interpolation: $law, hardening_at_rates: [[0.1, [[0, 250e6], [0.1, 320e6]]], [100, [[0, 350e6], [0.04, 389.2e6], [0.1, 448e6]]]]}}
conditions:
  - {nodes: bar/x_min, symmetry: x}
  - {nodes: bar/y_min, symmetry: y}
  - {nodes: {inside: [[0, 0, 0], [1, 1, 0]]}, fixed: [z]}
  - {nodes: bar/x_max, displacement: {x: {expression: "exp($rate * t) - 1"}}}
damping: [{coefficient: $damping}]
output: {history: {every: $every, elements: [{name: m, near: [0.5, 0.5, 0.5]}]}}
""", end=end, part=part, density=210e9 / (2000 / end)**2, law=law, rate=rate, damping=100 / end, every=end / 50)
                right = find_stress(run.history.last("m_eps"), rate, law == "logarithmic")
                found = run.history.last("m_von_mises")
                rows.append([kind, rate, law, f"{1e-6 * found:.3f}", f"{1e-6 * right:.3f}",
                             f"{100 * (found / right - 1):+.4f} %"])
                bench.near(f"{kind}, {rate:g} / s, {law}", 1e-6 * found, 1e-6 * right, relative=1e-3, unit="MPa")
    bench.table(["elements", "rate [1/s]", "interpolation", "stress [MPa]", "table", "difference"], rows)


@case("rubber_stretch", "exact", "Rubber stretched to three times its length")
def rubber_stretch(bench):
    """A cube of neo-Hookean material (E = 3, nu = 0.3) in fully integrated elements is drawn to a stretch of 3 along one
    direction or two, from nodes that are disturbed at random. The free stretch is that at which the stress across is 0,
    and the force follows. It stays uniform: force within 0.1 %, stretch within 1e-4, whatever the number of elements."""
    mu, lame = 3 / 2.6, 0.9 / (1.3 * 0.4)

    def find_stress(stretches, i):
        j = np.prod(stretches)
        return (mu * (stretches[i]**2 - 1) + lame * math.log(j)) / j

    rows = []
    for driven in (1, 2):
        def find_stretches(free, driven=driven):
            return [3, 3 if driven == 2 else free, free]

        free = optimize.brentq(lambda s: find_stress(find_stretches(s), 2), 0.05, 1.5)
        exact = find_stress(find_stretches(free), 0) * find_stretches(free)[1] * free
        for cells in (1, 2, 4):
            random = np.random.default_rng(7)
            places = [(i / cells, j / cells, k / cells) for k in range(cells + 1) for j in range(cells + 1)
                      for i in range(cells + 1)]
            noise = "".join(f"  - {{nodes: {{inside: [[{x}, {y}, {z}], [{x}, {y}, {z}]]}}, velocity: [{u:.6f}, "
                            f"{v:.6f}, {w:.6f}]}}\n"
                            for (x, y, z), (u, v, w) in zip(places, 1e-3 * random.uniform(-1, 1, (len(places), 3))))
            grow = '{expression: "2 * sin(pi * min(t, 20) / 40)^2"}'
            second = f"  - {{nodes: b/y_max, displacement: {{y: {grow}}}}}\n" if driven == 2 else ""
            run = bench.run("""
time: {end: 25}
parts: {b: {box: {size: [1, 1, 1], cells: [$cells, $cells, $cells]}, integration: full, material: m}}
materials: {m: {model: neo_hookean, density: 1e-2, youngs_modulus: 3, poissons_ratio: 0.3}}
damping: [{coefficient: 2}]
initial:
${noise}conditions:
  - {nodes: b/x_min, symmetry: x}
  - {nodes: b/y_min, symmetry: y}
  - {nodes: b/z_min, symmetry: z}
  - {nodes: b/x_max, displacement: {x: $grow}}
${second}output: {history: {every: 0.5, nodes: [{name: c, near: [1, 1, 1]}], forces: [{name: f, support: b/x_max}]}}
""", cells=cells, noise=noise, grow=grow, second=second)
            force, stretch = run.history.last("fx:f"), run.history.last("c_z")
            rows.append([driven, cells, f"{force:.5f}", f"{exact:.5f}", f"{stretch:.5f}", f"{free:.5f}"])
            bench.near(f"{driven} driven, {cells} cells an edge: force", force, exact, relative=1e-3)
            bench.near(f"{driven} driven, {cells} cells an edge: free stretch", stretch, free, absolute=1e-4)
    bench.table(["directions driven", "cells an edge", "force", "exact", "free stretch", "exact"], rows)
