"""Rigid bodies that rebound, a block that rattles on springs of contact, a ball between sharp edges."""
import math

from bench import case


@case("restitution", "rigid", "Restitution of a rigid cube on a rigid floor", quick=True)
def restitution(bench):
    """A cube falls by 50 mm. Rigid bodies have no waves that throw them back: what they keep of the velocity is
    `contact.restitution` e, at the first impact as at the next. Each top is e^2 of the one before, under every
    enforcement. A step of 5e-5 s meets the floor up to 5e-5 m early: heights within 0.1 mm."""
    rows, drop = [], 0.05
    for enforcement, e in (("kinematic", 1), ("kinematic", 0.6), ("penalty", 1), ("penalty", 0.6), ("lagrange", 0.6)):
        run = bench.run("""
time: {end: 0.7, max_step: 5.0e-5}
parts:
  body: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [-0.03, -0.02, 0.05], material: m, rigid: true}
  floor: {box: {size: [0.4, 0.4, 0.1], cells: [3, 3, 1]}, at: [-0.2, -0.2, -0.1], material: m, rigid: {fixed: [x, y, z, rx, ry, rz]}}
materials: {m: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: all, enforcement: $enforcement, restitution: $e}
output: {history: {every: 0}}
""", enforcement=enforcement, e=e)
        z = run.history["body_z:body"]
        tops = z[1:-1][(z[1:-1] > z[:-2]) & (z[1:-1] >= z[2:])] - 0.05
        for i in range(2):
            bench.near(f"{enforcement}, e = {e:g}: top {i + 1}", 1e3 * float(tops[i]), 1e3 * drop * e**(2 * i + 2),
                       absolute=0.1, unit="mm")
        bench.below(f"{enforcement}, e = {e:g}: energy balance, largest error",
                    run.history.largest("energy_error"), 1e-6)
        rows.append([enforcement, f"{e:g}", *(f"{1e3 * top:.3f}" for top in tops[:2])])
    bench.table(["contact", "e", "first top [mm]", "second top [mm]"], rows)


@case("rattling_block", "closed", "Penalty contact: energy of a rattling block", quick=True)
def rattling_block(bench):
    """A block of 1 m flies between two stops half a metre apart from it, at 0.003 or 0.03 of its wave speed, with penalty
    contact, in even steps and in those of its elements, which change by a tenth. A spring begins and ends within a step; the sum
    of what contact has taken and what its springs hold may not err by that, nor by a change of the step (theory_contact.md, section 5).
    On walls, whose springs do not act on each other, it is zero to round-off. Rows of faces share nodes: contact gives at most 1e-4. Corners
    that come deeper than the cushion of their spring are stopped: at 0.03 up to 2 % is lost."""
    walls = ("walls: [{point: [0, 0, 0], normal: z}, {point: [0, 0, 1.5], "
             "normal: -z}]\ncontact: {enforcement: penalty}\n")
    bodies = "\n".join(f"  {name}: {{box: {{size: [3, 3, 0.5], cells: [3, 3, 1]}}, at: [-1, -1, {z}], material: m, "
                       "rigid: {fixed: [x, y, z, rx, ry, rz]}}"
                       for name, z in (("low", -0.5), ("high", 1.5)))
    rows = []
    for name, speed, cells, steps, gain, loss in (
            ("walls", 0.003, 1, "even", 1e-10, 1e-10), ("walls", 0.003, 3, "even", 1e-10, 1e-10),
            ("walls", 0.03, 3, "even", 1e-10, 1e-10),
            ("walls", 0.03, 1, "uneven", 1e-10, 1e-10), ("walls", 0.03, 3, "uneven", 1e-10, 1e-10),
            ("rigid bodies", 0.003, 3, "even", 1e-9, 1e-9), ("rigid bodies", 0.03, 3, "even", 1e-4, 0.02),
            ("rigid bodies", 0.03, 3, "uneven", 1e-4, 0.02)):
        h = bench.run("""
time: {end: $end$step}
parts:
  block: {box: {size: [1, 1, 1], cells: [$cells, $cells, $cells]}, at: [0.03, 0.02, 0.2637], material: m}
$parts
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
initial: [{part: block, velocity: [0, 0, $speed]}]
output: {history: {every: 0}}
$stops
""", end=2 / speed, step=f", max_step: {0.2 / cells:g}" if steps == "even" else "", cells=cells, speed=speed, parts="" if name == "walls" else bodies,
                      stops=walls if name == "walls" else "contact: {surfaces: all, enforcement: penalty}").history
        share = (h["contact"] + h["contact_stored"]) / h["kinetic"][0]
        label = f"{name}, {cells} cells, speed {speed:g}, {steps} steps"
        bench.below(f"{label}: energy that contact gives, over that at the start", float(share.max()), gain)
        bench.above(f"{label}: what it has given at the end (negative: taken)", float(share[-1]), -loss)
        rows.append([name, cells, f"{speed:g}", steps, f"{share.max():.1e}", f"{share[-1]:.1e}"])
    bench.table(["stops", "cells an edge", "speed", "steps", "largest gain", "at the end"], rows)


@case("sharp_edges", "hard", "Contact of a ball with sharp edges", quick=True)
def sharp_edges(bench):
    """A ball of radius r = 30 mm, with 8 cells across, falls softly between two edges at x = -20 and 20 mm. Their elements
    are longer than those of the ball, so that its nodes pass beside them: the lines of its mesh must hold. It comes to rest in the middle
    at the height sqrt((r + t/2)^2 - 20^2) above the rims of sheets of t = 2 mm, which are round, and sqrt(r^2 - 20^2) above the
    edges of blocks. Facets lie up to 0.7 % of r inside the ball, lines touch once they have crossed, and the ball is soft: 1.5 mm."""
    for name, shapes, height, exact in (
            ("sheets", [f"shell_plate: {{size: [0.1, 0.2], cells: [2, {n}]}}, thickness: 0.002, at: [{x}, -0.1, 0]"
                        for x, n in ((-0.12, 4), (0.02, 3))], 0.0315, math.sqrt(0.031**2 - 0.02**2)),
            ("blocks", [f"box: {{size: [0.1, 0.2, 0.1], cells: [1, {n}, 1]}}, at: [{x}, -0.1, -0.1]"
                        for x, n in ((-0.12, 3), (0.02, 2))],
             0.0305, math.sqrt(0.03**2 - 0.02**2))):
        run = bench.run("""
time: {end: 0.45}
parts:
  ball: {sphere: {radius: 0.03, cells: 8}, at: [0.003, 0, $height], material: m}
  left: {$left, material: s, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  right: {$right, material: s, rigid: {fixed: [x, y, z, rx, ry, rz]}}
materials:
  m: {model: elastic, density: 7800, youngs_modulus: 1e7, poissons_ratio: 0.3}
  s: {model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3}
loads: {gravity: [0, 0, -9.81]}
damping: [{nodes: ball, coefficient: 10}]
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 2e-3, nodes: [{name: c, near: [0.003, 0, $height], part: ball}]}}
""", height=height, left=shapes[0], right=shapes[1])
        bench.near(f"edges of {name}: height of the ball", 1e3 * run.history.last("c_z"), 1e3 * exact,
                   absolute=1.5, unit="mm")
        bench.near(f"edges of {name}: its place across", 1e3 * run.history.last("c_x"), 0, absolute=1.5, unit="mm")
        told = [warning["rule"] for warning in run.summary["warnings"]]
        bench.equal(f"edges of {name}: warnings of missed contact", told.count("missed_contact"), 0)
